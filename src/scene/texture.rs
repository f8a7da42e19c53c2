//! Textures: pigments, normals and finishes, alone, layered or blended by a pattern.

use super::{Image, MapType, Pattern, PatternKind};
use crate::diag::Span;
use crate::math::{Color, Rgb, Transform};
use std::sync::Arc;

/// Layers, or a pattern over other textures.
#[derive(Clone, Debug)]
pub enum Texture {
    /// Plain layers, lowest first.
    Layers(Vec<TextureLayer>),
    /// `texture { PATTERN texture_map … }`.
    Patterned(Box<PatternedTexture>),
}

/// A pigment, a normal and a finish with the transformations written in the texture.
#[derive(Clone, Debug, Default)]
pub struct TextureLayer {
    /// Colour.
    pub pigment: Arc<Pigment>,
    /// Bumps.
    pub normal: Option<Arc<Normal>>,
    /// Response to light.
    pub finish: Arc<Finish>,
    /// `no_bump_scale` on the texture itself.
    pub no_bump_scale: bool,
    /// An upper layer of a scene up to version 3.1: what its colours filter they let through as it is.
    pub unfiltered: bool,
}

/// A texture chosen or mixed by a pattern.
#[derive(Clone, Debug)]
pub struct PatternedTexture {
    /// Decides where.
    pub pattern: Pattern,
    /// What to choose from.
    pub map: Blend<Arc<Texture>>,
    /// `no_bump_scale` on the texture itself.
    pub no_bump_scale: bool,
    /// Inner texture looked up at (u, v, 0).
    pub uv_mapping: bool,
    /// As [`Pigment::depth`].
    pub depth: u32,
    /// Its first word.
    pub span: Span,
}

/// How a pattern's value picks among items.
#[derive(Clone, Debug)]
pub enum Blend<T> {
    /// The pattern's own colours, as [`default_colors`](super::default_colors) gives them.
    Default,
    /// `*_map`: linear between entries sorted as written.
    Map(Vec<MapEntry<T>>),
    /// Block patterns: one item for each index.
    List(Vec<T>),
    /// `average`: weights and items.
    Average(Vec<MapEntry<T>>),
}

/// One bracketed entry of a map.
#[derive(Clone, Copy, Debug)]
pub struct MapEntry<T> {
    /// Position in the pattern's range, or weight in an average.
    pub value: f32,
    /// What stands there.
    pub item: T,
}

/// A colour for each point of space.
#[derive(Clone, Debug)]
pub struct Pigment {
    /// What colour, where.
    pub kind: PigmentKind,
    /// What few pigments have.
    pub rare: Option<Box<RarePigment>>,
    /// Levels of parts inside one another, down from this one; noted once it is complete.
    pub depth: u32,
    /// Its first word, or an empty place if nothing was written.
    pub span: Span,
}

/// What must not take up room in all pigments.
#[derive(Clone, Debug, Default)]
pub struct RarePigment {
    /// The colour at quality 5 and below.
    pub quick_color: Option<Color>,
    /// Modifiers and transformations of a plain colour: a pattern written over it takes them over.
    pub pattern: Option<Pattern>,
    /// The map that a plain colour or a picture was written over, with which a pattern after it goes on.
    pub map: Option<PigmentMap>,
}

/// The items that a pattern picks from.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum PigmentMap {
    Colors(Arc<Blend<Color>>),
    Pigments(Arc<Blend<Arc<Pigment>>>),
}

/// The sorts of pigment. Copies that stand elsewhere share everything but the pattern.
#[derive(Clone, Debug)]
pub enum PigmentKind {
    /// The same everywhere.
    Solid(Color),
    /// A pattern through a colour map (explicit or the pattern's default).
    Colors(Box<Pattern>, Arc<Blend<Color>>),
    /// A pattern through other pigments.
    Pigments(Box<Pattern>, Arc<Blend<Arc<Pigment>>>),
    /// `image_map`; the pattern carries only its warps.
    Image(Box<Pattern>, Arc<ImageMap>),
}

impl Default for Pigment {
    fn default() -> Self {
        Self { kind: PigmentKind::Solid(Color::BLACK), rare: None, depth: 0, span: Span::default() }
    }
}

impl Pigment {
    /// Lets all light through unchanged that was filtered, but for that of pictures.
    pub fn unfilter(&mut self) {
        match &mut self.kind {
            PigmentKind::Solid(color) => color.unfilter(),
            PigmentKind::Colors(_, colors) => Arc::make_mut(colors).items_mut().for_each(Color::unfilter),
            PigmentKind::Pigments(_, pigments) => {
                Arc::make_mut(pigments).items_mut().for_each(|pigment| Arc::make_mut(pigment).unfilter());
            }
            PigmentKind::Image(..) => {}
        }
    }
}

impl<T> Blend<T> {
    /// What stands in the entries.
    fn items_mut(&mut self) -> impl Iterator<Item = &mut T> {
        let (entries, list): (&mut [MapEntry<T>], &mut [T]) = match self {
            Self::Default => (&mut [], &mut []),
            Self::Map(entries) | Self::Average(entries) => (entries, &mut []),
            Self::List(list) => (&mut [], list),
        };
        entries.iter_mut().map(|entry| &mut entry.item).chain(list)
    }
}

/// `image_map` with its options.
#[derive(Clone, Debug)]
pub struct ImageMap {
    /// The picture.
    pub image: Image,
    /// Projection and interpolation.
    pub mapping: ImageMapping,
    /// `filter`/`transmit` for palette entries.
    pub palette_filter: Vec<(u32, f32)>,
    /// `transmit` for palette entries.
    pub palette_transmit: Vec<(u32, f32)>,
    /// `filter all`.
    pub filter_all: Option<f32>,
    /// `transmit all`.
    pub transmit_all: Option<f32>,
}

/// How a picture lies in space.
#[derive(Clone, Copy, Debug)]
pub struct ImageMapping {
    /// Projection.
    pub map_type: MapType,
    /// Shown once, not repeated.
    pub once: bool,
    /// 0 nearest, 2 bilinear, 3 bicubic, 4 normalised distance.
    pub interpolate: u8,
    /// Copies per unit.
    pub repeat: [f64; 2],
    /// Shift in units of the picture.
    pub offset: [f64; 2],
    /// `use_index` or `use_color`, if said.
    pub use_index: Option<bool>,
    /// `use_alpha`.
    pub use_alpha: bool,
}

impl Default for ImageMapping {
    fn default() -> Self {
        Self {
            map_type: MapType::Planar,
            once: false,
            interpolate: 0,
            repeat: [1.0; 2],
            offset: [0.0; 2],
            use_index: None,
            use_alpha: false,
        }
    }
}

/// A perturbation of the surface normal.
#[derive(Clone, Debug)]
pub struct Normal {
    /// How the perturbation arises; the pattern carries its own warps.
    pub kind: NormalKind,
    /// Amount, after the pattern or from `bump_size`.
    pub amount: f32,
    /// Sampling distance of pattern slopes.
    pub accuracy: f32,
    /// Bumps keep their depth when the pattern is scaled.
    pub no_bump_scale: bool,
    /// As [`Pigment::depth`].
    pub depth: u32,
    /// As [`Pigment::span`].
    pub span: Span,
}

/// The sorts of normal.
#[derive(Clone, Debug)]
pub enum NormalKind {
    /// By the slope of the pattern, or its native vector form, through an optional slope map.
    Pattern(Pattern, Option<Vec<MapEntry<[f32; 2]>>>),
    /// `normal_map`, `average`, or a block pattern of normals.
    Normals(Pattern, Blend<Arc<Normal>>),
    /// `facets { coords size metric }`.
    Facets {
        /// Carries only the warps.
        pattern: Pattern,
        /// Strength in coordinate mode; 0 for normal mode.
        coords: f64,
        /// Facet size.
        size: f64,
        /// Metric of the cells.
        metric: f64,
    },
    /// `bump_map`.
    BumpMap(Pattern, Arc<(Image, ImageMapping)>),
}

/// How a surface answers to light; see the manual's section 3.4.5.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Finish {
    pub ambient: Rgb,
    pub emission: Rgb,
    pub diffuse: f32,
    pub diffuse_back: f32,
    /// Diffuse before `albedo` scaling, for radiosity and subsurface.
    pub raw_diffuse: f32,
    pub brilliance: f32,
    pub crand: f32,
    pub phong: f32,
    pub phong_size: f32,
    pub specular: f32,
    /// 1 / roughness.
    pub specular_exponent: f32,
    pub metallic: f32,
    pub irid_amount: f32,
    pub irid_thickness: f32,
    pub irid_turbulence: f32,
    pub reflection_min: Rgb,
    pub reflection_max: Rgb,
    pub reflection_fresnel: bool,
    pub reflection_falloff: f32,
    pub reflection_exponent: f32,
    pub reflection_metallic: f32,
    pub conserve_energy: bool,
    pub subsurface_translucency: Option<Rgb>,
    /// Legacy `finish { ior }`.
    pub ior: Option<f32>,
    /// Legacy `finish { caustics }`.
    pub caustics: Option<f32>,
    /// Legacy `finish { refraction }`.
    pub refraction: Option<f32>,
}

impl Default for Finish {
    fn default() -> Self {
        Self {
            ambient: Rgb::splat(0.1),
            emission: Rgb::ZERO,
            diffuse: 0.6,
            diffuse_back: 0.0,
            raw_diffuse: 0.6,
            brilliance: 1.0,
            crand: 0.0,
            phong: 0.0,
            phong_size: 40.0,
            specular: 0.0,
            specular_exponent: 20.0,
            metallic: 0.0,
            irid_amount: 0.0,
            irid_thickness: 0.0,
            irid_turbulence: 0.0,
            reflection_min: Rgb::ZERO,
            reflection_max: Rgb::ZERO,
            reflection_fresnel: false,
            reflection_falloff: 1.0,
            reflection_exponent: 1.0,
            reflection_metallic: 0.0,
            conserve_energy: false,
            subsurface_translucency: None,
            ior: None,
            caustics: None,
            refraction: None,
        }
    }
}

impl Default for Normal {
    /// No perturbation, with POV-Ray's amount 0.5 and accuracy 0.02 for what is still to come.
    fn default() -> Self {
        Self {
            kind: NormalKind::Pattern(Pattern::new(PatternKind::None), None),
            amount: 0.5,
            accuracy: 0.02,
            no_bump_scale: false,
            depth: 0,
            span: Span::default(),
        }
    }
}

impl Default for Texture {
    fn default() -> Self {
        Self::Layers(vec![TextureLayer::default()])
    }
}

impl<T> Blend<T> {
    /// All items, as written.
    pub fn items(&self) -> impl Iterator<Item = &T> {
        let (entries, list): (&[MapEntry<T>], &[T]) = match self {
            Self::Default => (&[], &[]),
            Self::Map(entries) | Self::Average(entries) => (entries, &[]),
            Self::List(list) => (&[], list),
        };
        entries.iter().map(|entry| &entry.item).chain(list)
    }
}

/// One level more than the deepest of some parts.
fn around(parts: impl Iterator<Item = u32>) -> u32 {
    parts.max().map_or(0, |deepest| deepest + 1)
}

impl Pigment {
    /// What [`depth`](Self::depth) is to be, from the parts.
    pub fn depth_of_parts(&self) -> u32 {
        match &self.kind {
            PigmentKind::Solid(_) => 0,
            PigmentKind::Colors(pattern, _) | PigmentKind::Image(pattern, _) => pattern.depth(),
            PigmentKind::Pigments(pattern, list) => around(list.items().map(|p| p.depth)).max(pattern.depth()),
        }
    }

    /// The colour, if it is the same everywhere.
    pub fn solid(color: Color) -> Self {
        Self { kind: PigmentKind::Solid(color), ..Self::default() }
    }

    /// What `uv_mapping` makes of a pigment.
    pub fn at_uv(inner: Arc<Self>) -> Self {
        let map = Blend::Map(vec![MapEntry { value: 0.0, item: inner.clone() }]);
        let kind = PigmentKind::Pigments(Pattern::new(PatternKind::Uv).into(), Arc::new(map));
        Self { kind, rare: None, depth: inner.depth + 1, span: inner.span }
    }

    /// Applies a transformation written after the whole pigment.
    pub fn apply(&mut self, transform: &Transform) {
        match &mut self.kind {
            PigmentKind::Solid(_) if transform.is_identity() => {}
            PigmentKind::Solid(_) => {
                let rare = self.rare.get_or_insert_default();
                rare.pattern.get_or_insert_with(|| Pattern::new(PatternKind::None)).apply(transform);
            }
            PigmentKind::Colors(p, _) | PigmentKind::Pigments(p, _) | PigmentKind::Image(p, _) => p.apply(transform),
        }
    }
}

impl Normal {
    /// What [`depth`](Self::depth) is to be, from the parts.
    pub fn depth_of_parts(&self) -> u32 {
        match &self.kind {
            NormalKind::Pattern(pattern, _) | NormalKind::BumpMap(pattern, _) => pattern.depth(),
            NormalKind::Facets { pattern, .. } => pattern.depth(),
            NormalKind::Normals(pattern, list) => around(list.items().map(|n| n.depth)).max(pattern.depth()),
        }
    }

    /// What `uv_mapping` makes of a normal.
    pub fn at_uv(inner: Arc<Self>) -> Self {
        let map = Blend::Map(vec![MapEntry { value: 0.0, item: inner.clone() }]);
        let kind = NormalKind::Normals(Pattern::new(PatternKind::Uv), map);
        Self { kind, depth: inner.depth + 1, span: inner.span, ..Self::default() }
    }

    /// Applies a transformation written after the whole normal.
    pub fn apply(&mut self, transform: &Transform) {
        match &mut self.kind {
            NormalKind::Pattern(p, _) | NormalKind::Normals(p, _) | NormalKind::BumpMap(p, _) => p.apply(transform),
            NormalKind::Facets { pattern, .. } => pattern.apply(transform),
        }
    }
}

impl PatternedTexture {
    /// What [`depth`](Self::depth) is to be, from the parts.
    pub fn depth_of_parts(&self) -> u32 {
        around(self.map.items().map(|texture| texture.depth())).max(self.pattern.depth())
    }
}

impl Texture {
    /// The index of refraction that it gives to an object's interior: by the finish of the top layer.
    pub fn finish_ior(&self) -> Option<f32> {
        match self {
            Self::Patterned(_) => None,
            Self::Layers(layers) => layers.last()?.finish.ior.filter(|ior| *ior >= 0.0),
        }
    }

    /// Levels of parts inside one another.
    pub fn depth(&self) -> u32 {
        match self {
            Self::Patterned(patterned) => patterned.depth,
            Self::Layers(layers) => {
                let deepest =
                    |layer: &TextureLayer| layer.pigment.depth.max(layer.normal.as_ref().map_or(0, |n| n.depth));
                layers.iter().map(deepest).max().unwrap_or(0)
            }
        }
    }

    /// Applies a transformation written after the whole texture; what is looked up at (u, v, 0) stays.
    pub fn apply(&mut self, transform: &Transform) {
        match self {
            Self::Patterned(p) if p.uv_mapping => {}
            Self::Patterned(p) => p.pattern.apply(transform),
            Self::Layers(layers) => {
                for layer in layers {
                    Arc::make_mut(&mut layer.pigment).apply(transform);
                    if let Some(normal) = &mut layer.normal {
                        Arc::make_mut(normal).apply(transform);
                    }
                }
            }
        }
    }
}
