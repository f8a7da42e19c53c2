//! From scene textures to compiled ones: constants folded, identities dropped, pictures loaded once.
//!
//! Messages carry no place here; the caller knows which object asked.

mod finish;
mod normal;
mod pattern;
mod picture;

use super::picture::Pictures;
use crate::compiled::texture::{Blend, ImageMap, Layer, Normal, PatternedTexture, Pigment, Texture, WaveSources};
use crate::math::Color;
use crate::math::noise::NoiseGenerator;
use crate::scene::{self, PigmentKind, Settings};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Why a texture cannot be compiled, in one sentence without a full stop.
pub type Refusal = String;

/// Compiles textures of one scene; pictures are loaded once however often they are named.
#[derive(Debug)]
pub struct TextureCompiler<'s> {
    settings: &'s Settings,
    pictures: Pictures,
    /// By address; each is kept so that its address stays its own.
    image_maps: FxHashMap<usize, (Arc<scene::ImageMap>, Arc<ImageMap>)>,
    /// Sources of ripples and waves, made when first asked for.
    waves: Option<Arc<WaveSources>>,
    /// How deep in a texture it is, and how many parts that has so far.
    depth: usize,
    n_parts: usize,
}

/// Most pigments, normals and textures inside one another, copies counted each time.
const MAX_PARTS: usize = 200_000;

impl<'s> TextureCompiler<'s> {
    /// For a scene with these settings.
    pub fn new(settings: &'s Settings) -> Self {
        Self::sharing(settings, &Pictures::default())
    }

    /// The same, with the pictures of other compilers.
    pub(super) fn sharing(settings: &'s Settings, pictures: &Pictures) -> Self {
        let (pictures, image_maps) = (pictures.clone(), FxHashMap::default());
        Self { settings, pictures, image_maps, waves: None, depth: 0, n_parts: 0 }
    }

    /// Makes a part of a texture, if that has not too many already.
    fn part<T>(&mut self, make: impl FnOnce(&mut Self) -> Result<T, Refusal>) -> Result<T, Refusal> {
        if self.depth == 0 {
            self.n_parts = 0;
        }
        self.n_parts += 1;
        if self.n_parts > MAX_PARTS {
            return Err(format!("more than {MAX_PARTS} pigments, normals and textures inside one another"));
        }
        self.depth += 1;
        let made = make(self);
        self.depth -= 1;
        made
    }

    /// Compiles a texture with everything below it.
    ///
    /// # Errors
    /// A message that names what is unsupported or which file cannot be read.
    pub fn texture(&mut self, texture: &scene::Texture) -> Result<Texture, Refusal> {
        self.part(|compiler| compiler.whole_texture(texture))
    }

    fn whole_texture(&mut self, texture: &scene::Texture) -> Result<Texture, Refusal> {
        Ok(match texture {
            scene::Texture::Layers(layers) => {
                Texture::Layers(layers.iter().map(|l| self.layer(l)).collect::<Result<_, _>>()?)
            }
            scene::Texture::Patterned(patterned) => {
                let mut pattern = self.pattern(&patterned.pattern)?;
                let items = self.blend(&patterned.map, |compiler, t| compiler.texture(t))?;
                if let crate::compiled::texture::PatternKind::Material(_, _, n) = &mut pattern.kind {
                    *n = items.iter().count();
                }
                let uv_mapping = patterned.uv_mapping;
                let mut compiled = PatternedTexture { pattern, items, no_bump_scale: false, uv_mapping };
                if patterned.no_bump_scale {
                    compiled.keep_bump_depth();
                }
                Texture::Patterned(Box::new(compiled))
            }
        })
    }

    fn layer(&mut self, layer: &scene::TextureLayer) -> Result<Layer, Refusal> {
        let mut normal = layer.normal.as_ref().map(|n| self.normal(n)).transpose()?;
        if layer.no_bump_scale {
            normal.iter_mut().for_each(Normal::keep_bump_depth);
        }
        let mut pigment = self.pigment(&layer.pigment)?;
        if layer.unfiltered {
            pigment.unfilter();
        }
        Ok(Layer {
            side_by_side: pigment.is_side_by_side(),
            pigment,
            normal,
            finish: finish::compile(&layer.finish, self.settings),
            quick_color: layer.pigment.quick_color,
        })
    }

    /// Compiles a pigment by itself, for skies, rainbows and functions.
    ///
    /// # Errors
    /// As [`texture`](Self::texture).
    pub fn pigment(&mut self, pigment: &scene::Pigment) -> Result<Pigment, Refusal> {
        self.part(|compiler| compiler.whole_pigment(pigment))
    }

    fn whole_pigment(&mut self, pigment: &scene::Pigment) -> Result<Pigment, Refusal> {
        let compiled = match &pigment.kind {
            PigmentKind::Solid(color) => Pigment::Solid(*color),
            PigmentKind::Colors(pattern, colors) => {
                let colors = match colors {
                    scene::Blend::Default => {
                        Blend::map(scene::default_colors(&pattern.kind).iter().map(|e| (f64::from(e.value), e.item)))
                    }
                    named => self.blend(named, |_, c| Ok(*c))?,
                };
                match single_color(&colors) {
                    Some(color) => Pigment::Solid(color),
                    None => Pigment::Colors(self.pattern(pattern)?, colors),
                }
            }
            PigmentKind::Pigments(pattern, pigments) => {
                let pigments = self.blend(pigments, |compiler, p| compiler.pigment(p))?;
                Pigment::Pigments(self.pattern(pattern)?, pigments)
            }
            PigmentKind::Image(pattern, image) => {
                let map = self.image_map(image)?;
                Pigment::Image(self.pattern(pattern)?, map)
            }
        };
        Ok(if pigment.uv_mapping { Pigment::Uv(Box::new(compiled)) } else { compiled })
    }

    /// Compiles the items of a map, list or average.
    fn blend<S, T>(
        &mut self,
        blend: &scene::Blend<S>,
        mut item: impl FnMut(&mut Self, &S) -> Result<T, Refusal>,
    ) -> Result<Blend<T>, Refusal> {
        let mut entries = |list: &[scene::MapEntry<S>]| -> Result<Vec<(f32, T)>, Refusal> {
            list.iter().map(|e| Ok((e.value, item(self, &e.item)?))).collect()
        };
        let blend = match blend {
            scene::Blend::Default => return Err("a map is missing".into()),
            scene::Blend::Map(list) => Blend::map(entries(list)?.into_iter().map(|(v, t)| (f64::from(v), t))),
            scene::Blend::Average(list) => Blend::average(entries(list)?),
            scene::Blend::List(list) => Blend::list(list.iter().map(|i| item(self, i)).collect::<Result<Vec<_>, _>>()?),
        };
        if blend.iter().next().is_none() { Err("a map without entries".into()) } else { Ok(blend) }
    }
}

/// The noise of a scene where nothing else is said.
pub(super) fn noise_generator(settings: &Settings) -> NoiseGenerator {
    match settings.noise_generator() {
        1 => NoiseGenerator::Original,
        2 => NoiseGenerator::Corrected,
        _ => NoiseGenerator::Perlin,
    }
}

/// The colour of a map in which all entries agree.
fn single_color(colors: &Blend<Color>) -> Option<Color> {
    let first = colors.iter().next().copied()?;
    colors.iter().all(|c| *c == first).then_some(first)
}
