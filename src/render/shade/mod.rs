//! Textures at a place, as values: what is mixed there, and each layer's colour, normal and finish.
//!
//! [`resolve`] goes down a texture's patterns to its layers, once and in the same way for light that is shaded and for
//! light that only passes through. What a layer is gets worked out when it is asked for.
//!
//! Source: sections 2 and 6 of the shading facts (measured).

pub(super) mod finish;
mod lanes;

pub(super) use lanes::{Lane, Lanes};

use super::options::Options;
use super::radiance::Mix;
use super::random::{Branch, Random};
use crate::compiled::World;
use crate::compiled::geometry::{Hit, Surface, TextureRef};
use crate::compiled::texture::{Context, Finish, Frame, Layer, PatternedTexture, Pick, Texture};
use crate::math::{Color, DVec3, Rgb, Transform};

/// What lookups at one place share, and leave for later ones.
pub(super) struct Lookup<'p> {
    /// What patterns may ask about the place. The normal of the last layer with bumps stays for patterns that ask for
    /// the slope, in whatever layer or texture of the place they stand, as in POV-Ray.
    pub(super) context: &'p mut Context,
    /// Where the colours of neighbours are found at once.
    pub(super) lane: Option<Lane<'p>>,
}

/// What patterns may ask about a surface before any bump, seen along a unit direction, from which `normal` is turned to.
#[inline(always)]
pub(super) fn context(surface: &Surface, direction: DVec3, normal: DVec3) -> Context {
    Context { uv: surface.uv, normal, perturbed_normal: normal, direction, point: surface.point }
}

/// Where a texture is looked up.
#[derive(Clone, Copy)]
pub(super) struct TexturePoint {
    /// In the space that contains the texture.
    pub(super) point: DVec3,
    /// No pattern chose it: only then it obeys legacy finish keywords.
    pub(super) plain: bool,
    /// Random choices in it.
    pub(super) random: Random,
}

/// The space of a hit's texture, and the hit there.
#[derive(Clone, Copy)]
pub(super) struct TextureSpace<'s> {
    pub(super) point: DVec3,
    /// The map there, unless it is looked up by surface coordinates.
    pub(super) texture_from_world: Option<&'s Transform>,
}

/// What is known already of a hit with a single texture.
#[derive(Clone, Copy)]
pub(super) struct Known<'p> {
    pub(super) space: TextureSpace<'p>,
    pub(super) lane: Option<Lane<'p>>,
}

/// Where a texture of a hit is looked up; `room` is for a map that must be made.
#[inline(always)]
pub(super) fn texture_space<'s>(
    world: &'s World,
    surface: &Surface,
    hit: &Hit,
    seen: &TextureRef,
    room: &'s mut Option<Transform>,
) -> TextureSpace<'s> {
    if surface.uv_mapping {
        return TextureSpace { point: surface.uv.lookup_point(), texture_from_world: None };
    }
    let texture_from_world = world.geometry.texture_from_world(hit, seen, room);
    TextureSpace { point: texture_from_world.point(surface.point), texture_from_world: Some(texture_from_world) }
}

/// Mixes what `of_layers` makes of all layered textures that show at a place.
///
/// What `frame` enters it keeps: bumps of later items pass through the spaces of earlier ones, as in POV-Ray.
// Always inline: most textures are layers.
#[inline(always)]
pub(super) fn resolve<T: Mix>(
    texture: &Texture,
    at: TexturePoint,
    frame: &mut Frame<'_>,
    lookup: &mut Lookup<'_>,
    of_layers: &mut impl FnMut(Layers<'_>, &mut Lookup<'_>) -> T,
) -> T {
    match texture {
        Texture::Layers(layers) => of_layers(Layers { layers, at, frame }, lookup),
        Texture::Patterned(patterned) => resolve_pattern(patterned, at, frame, lookup, of_layers),
    }
}

fn resolve_pattern<T: Mix>(
    patterned: &PatternedTexture,
    at: TexturePoint,
    frame: &mut Frame<'_>,
    lookup: &mut Lookup<'_>,
    of_layers: &mut impl FnMut(Layers<'_>, &mut Lookup<'_>) -> T,
) -> T {
    let (pick, warped) = patterned.pattern.pick(&patterned.items, at.point, lookup.context);
    let point = if patterned.uv_mapping { lookup.context.uv_point() } else { warped };
    frame.enter(&patterned.pattern, patterned.no_bump_scale);
    let mut of = |item: &Texture, entry: usize| {
        let at = TexturePoint { point, plain: false, random: at.random.branch(Branch::Texture(entry)) };
        resolve(item, at, frame, lookup, of_layers)
    };
    match pick {
        Pick::One(item) => of(item, 0),
        Pick::Two(lower, upper, t) => {
            let mut mixed = of(upper, 1).scaled(t);
            mixed.add_scaled(&of(lower, 0), 1.0 - t);
            mixed
        }
        Pick::All(items) => {
            let mut sum = T::default();
            for (i, (weight, item)) in items.iter().enumerate() {
                sum.add_scaled(&of(item, i), *weight);
            }
            sum
        }
    }
}

/// The layers of a texture at a place.
pub(super) struct Layers<'t> {
    layers: &'t [Layer],
    at: TexturePoint,
    frame: &'t Frame<'t>,
}

impl<'t> Layers<'t> {
    /// All layers from the top.
    pub(super) fn iter(&self) -> impl Iterator<Item = LayerRef<'_, 't>> {
        (0..self.layers.len()).rev().map(|index| LayerRef { of: self, index })
    }

    /// The uppermost layer's finish.
    pub(super) fn top_finish(&self) -> Option<&'t Finish> {
        self.layers.last().map(|top| &*top.finish)
    }

    /// The finish whose legacy keywords count.
    pub(super) fn legacy_finish(&self) -> Option<&'t Finish> {
        self.top_finish().filter(|_| self.at.plain)
    }

    /// Whether there is one layer, and no other texture at the surface.
    pub(super) fn are_only(&self, surface: &Surface) -> bool {
        self.layers.len() == 1 && self.at.plain && surface.textures.len() == 1
    }

    /// Random choices in this texture.
    pub(super) fn random(&self) -> Random {
        self.at.random
    }
}

/// A layer that is worked out as far as somebody asks.
pub(super) struct LayerRef<'l, 't> {
    of: &'l Layers<'t>,
    index: usize,
}

impl<'t> LayerRef<'_, 't> {
    fn layer(&self) -> &'t Layer {
        &self.of.layers[self.index]
    }

    pub(super) fn finish(&self) -> &'t Finish {
        &self.layer().finish
    }

    /// Unit shading normal with the layer's bumps.
    #[inline(always)]
    pub(super) fn normal(&self, lookup: &mut Lookup<'_>, options: &Options) -> DVec3 {
        let facing = lookup.context.normal;
        match &self.layer().normal {
            Some(bumps) if options.reflection_and_normals() => {
                let bent = bumps.perturb(facing, self.of.at.point, self.of.frame, lookup.context);
                lookup.context.perturbed_normal = bent.inner;
                bent.normal
            }
            _ => facing,
        }
    }

    /// The pigment's colour; `None` where a picture leaves a hole.
    #[inline(always)]
    pub(super) fn color(&self, lookup: &Lookup<'_>, options: &Options) -> Option<Color> {
        let layer = self.layer();
        if let (true, Some(quick)) = (options.quick_colors(), layer.quick_color) {
            return Some(quick);
        }
        let known = lookup.lane.filter(|_| self.of.at.plain).and_then(|lane| lane.color(self.index));
        known.or_else(|| layer.pigment.color(self.of.at.point, lookup.context))
    }
}

/// A layer as light meets it.
pub(super) struct SurfaceLayer<'t> {
    pub(super) finish: &'t Finish,
    /// Unit perturbed normal.
    pub(super) normal: DVec3,
    /// Diffuse amounts on the lit side and on the far one: none where light goes below the surface instead.
    pub(super) diffuse: f32,
    /// See `diffuse`.
    pub(super) diffuse_back: f32,
    /// The pigment's colour.
    pub(super) albedo: Rgb,
    /// What part of the layer is not see-through.
    pub(super) opacity: f32,
    /// How many layers lie above it.
    pub(super) depth: usize,
    /// Whether there is no other at the vertex.
    pub(super) is_only: bool,
    /// Random choices in its texture.
    pub(super) random: Random,
}

/// What part of a colour is not see-through; scenes below version 3.7 have a rule of their own.
pub(super) fn opacity(world: &World, color: &Color) -> f32 {
    if world.settings.legacy_opacity {
        1.0 - color.filter * color.rgb.max_element() - color.transmit
    } else {
        color.opacity()
    }
}
