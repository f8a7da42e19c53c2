//! The values of layers beside the picture.

use super::coverage::Coverage;
use super::gather::{Detail, Gather, Term};
use crate::compiled::World;
use crate::compiled::camera::Projection;
use crate::compiled::geometry::{ObjectId, StatementId, TextureId};
use crate::imaging::{Layer, cryptomatte};
use crate::math::{DVec3, Rgb};
use crate::render::image_layer::ImageLayer;

/// The depth of pixels that show nothing, as Blender writes it.
const NO_DEPTH: f32 = 1e10;

impl ImageLayer {
    /// Its values over all pixels; Cryptomatte is several layers.
    pub(in crate::render) fn build(self, world: &World, pixels: &[Detail]) -> Vec<Layer> {
        let term = |term: Term| self.colors(pixels, |p| linear_share(world, p, term));
        let one = |channel: &str, value: &dyn Fn(&Detail) -> f32| {
            let name = if channel == "Z" { String::new() } else { self.name().into() };
            let channels = vec![(channel.to_owned(), pixels.iter().map(value).collect())];
            vec![Layer { name, is_color: false, channels, attributes: Vec::new() }]
        };
        match self {
            Self::Depth => one("Z", &|p| depth(world, p)),
            Self::Samples => one("Y", &|p| p.samples() as f32),
            Self::Position => self.vectors(pixels, |p| p.nearest().map_or(DVec3::ZERO, |n| n.point)),
            Self::Normal => self.vectors(pixels, Detail::normal),
            Self::GeometricNormal => self.vectors(pixels, Detail::geometric_normal),
            Self::Albedo => self.colors(pixels, |p| p.albedo().to_array().map(|v| world.settings.transfer.linear(v))),
            Self::Variance => self.colors(pixels, |p| p.variance().to_array()),
            Self::Emission => term(Term::Emission),
            Self::Direct => term(Term::Direct),
            Self::Indirect => term(Term::Indirect),
            Self::Caustics => term(Term::Caustics),
            Self::Subsurface => term(Term::Subsurface),
            Self::Reflection => term(Term::Reflection),
            Self::Refraction => term(Term::Refraction),
            Self::Background => term(Term::Background),
            Self::Atmosphere => term(Term::Atmosphere),
            Self::Media => term(Term::Media),
            Self::CryptoObject => {
                let shares: Vec<_> = pixels.iter().map(|p| statements(world, p)).collect();
                cryptomatte(self.name(), &shares, |statement| world.labels.object(StatementId::new(statement)))
            }
            Self::CryptoMaterial => {
                let shares: Vec<_> = pixels.iter().map(|p| p.materials().ranked()).collect();
                cryptomatte(self.name(), &shares, |texture| world.labels.texture(TextureId::new(texture)))
            }
        }
    }

    fn colors(self, pixels: &[Detail], color: impl Fn(&Detail) -> [f32; 3]) -> Vec<Layer> {
        self.three(["R", "G", "B"], pixels.iter().map(color).collect())
    }

    fn vectors(self, pixels: &[Detail], vector: impl Fn(&Detail) -> DVec3) -> Vec<Layer> {
        self.three(["X", "Y", "Z"], pixels.iter().map(|p| vector(p).as_vec3().to_array()).collect())
    }

    fn three(self, names: [&str; 3], values: Vec<[f32; 3]>) -> Vec<Layer> {
        let channel = |i: usize| (names[i].to_owned(), values.iter().map(|v| v[i]).collect());
        let channels = (0..3).map(channel).collect();
        vec![Layer { name: self.name().into(), is_color: self.is_color(), channels, attributes: Vec::new() }]
    }
}

/// Linear light of one term. Where a scene's working values are not linear, sums in both spaces differ, so the
/// pixel's linear light is divided in the ratio of the terms' working values: all terms always add up to it.
fn linear_share(world: &World, pixel: &Detail, term: Term) -> [f32; 3] {
    let (total, part): (Rgb, Rgb) = (pixel.light().rgb, pixel.term(term));
    std::array::from_fn(|i| {
        if total[i] == 0.0 { part[i] } else { part[i] * (world.settings.transfer.linear(total[i]) / total[i]) }
    })
}

fn depth(world: &World, pixel: &Detail) -> f32 {
    let Some(nearest) = pixel.nearest() else { return NO_DEPTH };
    let camera = &world.camera;
    let depth = match camera.projection {
        Projection::Perspective | Projection::Orthographic => {
            (nearest.point - camera.location).dot(camera.direction.normalize_or(DVec3::Z))
        }
        _ => nearest.length,
    };
    depth as f32
}

/// Shares of the statements to which objects belong.
fn statements(world: &World, pixel: &Detail) -> Vec<(u32, f32)> {
    let mut shares = Coverage::default();
    for (object, share) in pixel.objects().ranked() {
        shares.add(world.labels.statement(ObjectId::new(object)).number(), share);
    }
    shares.ranked()
}
