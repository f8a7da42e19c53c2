//! Textures as rays meet them: constants folded, transformations inverted once.
//!
//! A [`Texture`] is a stack of plain layers or a [`Pattern`] over other textures. A pattern
//! first carries a point through its warps into the space of its formula, then gives a value;
//! a [`Blend`] turns the value into one item or two neighbours and a share. Nothing here
//! allocates while rendering.
//!
//! ```
//! use whitted::compiled::texture::{Context, Pattern, PatternKind};
//! use whitted::math::DVec3;
//! let onion = Pattern::of(PatternKind::Onion);
//! assert_eq!(onion.value(DVec3::new(0.0, 2.25, 0.0), &Context::default()), 0.25);
//! ```

mod blend;
mod crackle;
mod density_file;
mod finish;
mod formula;
mod fractal;
mod image;
mod lookup;
mod noise_formula;
mod normal;
mod pattern;
mod pavement;
mod pavement_table;
mod penrose;
mod pigment;
mod point_function;
mod slope;
mod tiling;
mod warp;

pub use self::image::{ImageMap, MapType, Mapping, Raster, Texels, Transparency};
pub use blend::{Blend, Pick};
pub use crackle::Crackle;
pub use density_file::DensityFile;
pub use finish::{Finish, Reflection};
pub use fractal::{Coloring, Fractal, FractalSet};
pub use noise_formula::{InnerTurbulence, WaveSources};
pub use normal::{Bent, Facets, Frame, Normal, NormalKind, SlopeEntry};
pub use pattern::{Context, Pattern, PatternKind, Wave};
pub use pavement::Pavement;
pub use penrose::Penrose;
pub use pigment::Pigment;
pub use point_function::PointFunction;
pub use slope::{Slope, SlopeAxis};
pub use tiling::{Periodic, Tiling};
pub use warp::{Around, BlackHole, Warp};

use std::sync::Arc;

/// What a surface looks like.
#[derive(Clone, Debug)]
pub enum Texture {
    /// Plain layers, lowest first.
    Layers(Vec<Layer>),
    /// Chosen or mixed by a pattern.
    Patterned(Box<PatternedTexture>),
}

/// A pigment, a normal and a finish.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Colour.
    pub pigment: Pigment,
    /// Bumps.
    pub normal: Option<Arc<Normal>>,
    /// Whether it pays to find the colours of neighbours at once.
    pub side_by_side: bool,
    /// Response to light.
    pub finish: Arc<Finish>,
    /// The colour at quality 5 and below, where it differs from the pigment's.
    pub quick_color: Option<crate::math::Color>,
}

impl Layer {
    /// Whether no light comes through anywhere, at any quality.
    pub fn is_opaque(&self) -> bool {
        self.pigment.is_opaque() && self.quick_color.is_none_or(|color| color.filter == 0.0 && color.transmit == 0.0)
    }
}

/// Textures under a pattern.
#[derive(Clone, Debug)]
pub struct PatternedTexture {
    /// Decides where.
    pub pattern: Pattern,
    /// What to choose from.
    pub items: Blend<Arc<Texture>>,
    /// Bumps keep their depth when the pattern is scaled.
    pub no_bump_scale: bool,
    /// Items are looked up at (u, v, 0).
    pub uv_mapping: bool,
}

impl Texture {
    /// Whether no light comes through anywhere, so that a shadow ray ends here.
    pub fn is_opaque(&self) -> bool {
        match self {
            Self::Layers(layers) => layers.iter().any(Layer::is_opaque),
            Self::Patterned(p) => p.items.iter().all(|item| item.is_opaque()),
        }
    }

    /// Whether it pays somewhere to find the colours of neighbours at once.
    pub fn is_side_by_side(&self) -> bool {
        match self {
            Self::Layers(layers) => layers.iter().any(|layer| layer.side_by_side),
            Self::Patterned(_) => false,
        }
    }

    /// Lets bumps keep their depth when they are scaled; of layers, as in POV-Ray, those of the uppermost.
    pub fn keep_bump_depth(&mut self) {
        match self {
            Self::Layers(layers) => {
                let top = layers.last_mut().and_then(|top| top.normal.as_mut());
                top.into_iter().for_each(|normal| Arc::make_mut(normal).keep_bump_depth());
            }
            Self::Patterned(patterned) => patterned.keep_bump_depth(),
        }
    }

    /// The uppermost layer, if this is a plain texture.
    pub fn top_layer(&self) -> Option<&Layer> {
        match self {
            Self::Layers(layers) => layers.last(),
            Self::Patterned(_) => None,
        }
    }
}

impl PatternedTexture {
    /// As [`Texture::keep_bump_depth`]; the textures of a `material_map` stay as they are, as in POV-Ray.
    pub fn keep_bump_depth(&mut self) {
        self.no_bump_scale = true;
        if !matches!(self.pattern.kind, PatternKind::Material(..)) {
            self.items.iter_mut().for_each(|item| Arc::make_mut(item).keep_bump_depth());
        }
    }
}
