//! From scene textures to compiled ones: constants folded, identities dropped, pictures loaded once.
//!
//! Messages carry the place of the innermost part that has one.

mod finish;
mod normal;
mod pattern;
mod picture;

use super::function::Functions;
use crate::compiled::texture::{
    Blend, Finish, ImageMap, Layer, Normal, Pattern, PatternedTexture, Pigment, Texture, WaveSources,
};
use crate::diag::{Diagnostic, Span};
use crate::math::Color;
use crate::math::noise::NoiseGenerator;
use crate::omission::{Keep, Ledger, Omission};
use crate::scene::{self, PigmentKind, Settings};
use crate::stack::roomy;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// What was made of parts that several textures have, by address, with how many parts are in each. The sources are kept
/// so that their addresses stay their own.
type Shared<S, T> = FxHashMap<usize, (Arc<S>, Arc<T>, usize)>;

/// Why a texture cannot be compiled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Where it is, as far as that is known already.
    pub span: Option<Span>,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
}

impl Refusal {
    /// At a place that was written, unless one further inside is known.
    #[must_use]
    pub fn at(self, span: Span) -> Self {
        let written = (span != Span::default()).then_some(span);
        Self { span: self.span.or(written), ..self }
    }

    /// As an error of the scene.
    pub fn diagnostic(self) -> Diagnostic {
        Diagnostic { span: self.span, ..Diagnostic::error(Span::default(), self.message) }
    }
}

impl From<String> for Refusal {
    fn from(message: String) -> Self {
        Self { span: None, message }
    }
}

impl From<&str> for Refusal {
    fn from(message: &str) -> Self {
        message.to_owned().into()
    }
}

/// Compiles textures of one scene; what several of them share is compiled once.
#[derive(Debug)]
pub struct TextureCompiler<'s> {
    settings: &'s Settings,
    functions: Functions,
    image_maps: Shared<scene::ImageMap, ImageMap>,
    colors: Shared<scene::Blend<Color>, Blend<Color>>,
    pigments: Shared<scene::Blend<Arc<scene::Pigment>>, Blend<Pigment>>,
    normals: Shared<scene::Normal, Normal>,
    finishes: Shared<scene::Finish, Finish>,
    textures: Shared<scene::Texture, Texture>,
    /// Sources of ripples and waves, made when first asked for.
    waves: Option<Arc<WaveSources>>,
    /// What pictures do not need.
    ledger: Ledger,
    /// How deep in a texture it is, and how many parts that has so far.
    depth: usize,
    n_parts: usize,
}

/// Most pigments, normals and textures inside one another, copies counted each time: a lookup may have to go through
/// all of them.
const MAX_PARTS: usize = 200_000;

impl<'s> TextureCompiler<'s> {
    /// For a scene with these settings.
    pub fn new(settings: &'s Settings) -> Self {
        Self::sharing(settings, &Functions::default())
    }

    /// The same, with the functions and pictures of other compilers.
    pub(super) fn sharing(settings: &'s Settings, functions: &Functions) -> Self {
        Self {
            settings,
            functions: functions.clone(),
            image_maps: Shared::default(),
            colors: Shared::default(),
            pigments: Shared::default(),
            normals: Shared::default(),
            finishes: Shared::default(),
            textures: Shared::default(),
            waves: None,
            ledger: Ledger::default(),
            depth: 0,
            n_parts: 0,
        }
    }

    /// Without leaving out what is to be kept.
    pub(super) fn keeping(self, keep: Keep) -> Self {
        Self { ledger: Ledger::new(keep), ..self }
    }

    /// What was found that pictures do not need.
    pub(super) fn ledger(&self) -> &Ledger {
        &self.ledger
    }

    /// Makes a part of a texture, if that has not too many already.
    fn part<T>(&mut self, make: impl FnOnce(&mut Self) -> Result<T, Refusal>) -> Result<T, Refusal> {
        if self.depth == 0 {
            self.n_parts = 0;
        }
        self.count(1)?;
        self.depth += 1;
        let made = roomy(|| make(self));
        self.depth -= 1;
        made
    }

    fn count(&mut self, n: usize) -> Result<(), Refusal> {
        self.n_parts += n;
        if self.n_parts > MAX_PARTS {
            return Err(format!("more than {MAX_PARTS} pigments, normals and textures inside one another").into());
        }
        Ok(())
    }

    /// What was made of something before, or is made now and remembered if others may ask for it, too.
    fn once<S, T>(
        &mut self,
        source: &Arc<S>,
        known: impl Fn(&mut Self) -> &mut Shared<S, T>,
        make: impl FnOnce(&mut Self) -> Result<T, Refusal>,
    ) -> Result<Arc<T>, Refusal> {
        let address = Arc::as_ptr(source).addr();
        if let Some((_, made, n_parts)) = known(self).get(&address) {
            let (made, n_parts) = (Arc::clone(made), *n_parts);
            self.count(n_parts)?;
            return Ok(made);
        }
        let before = self.n_parts;
        let made = Arc::new(make(self)?);
        if Arc::strong_count(source) > 1 {
            let n_parts = self.n_parts.saturating_sub(before);
            known(self).insert(address, (Arc::clone(source), Arc::clone(&made), n_parts));
        }
        Ok(made)
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
                let mut layers: Vec<Layer> = layers.iter().map(|l| self.layer(l)).collect::<Result<_, _>>()?;
                let n_covered = layers.iter().rposition(Layer::is_opaque).unwrap_or(0);
                let is_left_out = |_: &usize| self.ledger.omits(Omission::CoveredLayers, size_of::<Layer>());
                let n_left_out = (0..n_covered).filter(is_left_out).count();
                layers.drain(..n_left_out);
                Texture::Layers(layers)
            }
            scene::Texture::Patterned(patterned) => self.patterned(patterned).map_err(|r| r.at(patterned.span))?,
        })
    }

    fn patterned(&mut self, patterned: &scene::PatternedTexture) -> Result<Texture, Refusal> {
        let mut pattern = self.pattern(&patterned.pattern)?;
        let items =
            self.blend(&patterned.map, |compiler, t| compiler.once(t, |c| &mut c.textures, |c| c.texture(t)))?;
        if let crate::compiled::texture::PatternKind::Material(_, _, n) = &mut pattern.kind {
            *n = items.iter().count();
        }
        let uv_mapping = patterned.uv_mapping;
        let mut compiled = PatternedTexture { pattern, items, no_bump_scale: false, uv_mapping };
        if patterned.no_bump_scale {
            compiled.keep_bump_depth();
        }
        Ok(Texture::Patterned(Box::new(compiled)))
    }

    fn layer(&mut self, layer: &scene::TextureLayer) -> Result<Layer, Refusal> {
        let mut normal = layer.normal.as_ref().map(|n| self.shared_normal(n)).transpose()?;
        if layer.no_bump_scale {
            normal.iter_mut().for_each(|normal| Arc::make_mut(normal).keep_bump_depth());
        }
        let mut pigment = self.pigment(&layer.pigment)?;
        if layer.unfiltered {
            pigment.unfilter();
        }
        let settings = self.settings;
        Ok(Layer {
            side_by_side: pigment.is_side_by_side(),
            pigment,
            normal,
            finish: self.once(
                &layer.finish,
                |c| &mut c.finishes,
                |c| Ok(finish::compile(&layer.finish, settings, &mut c.ledger)),
            )?,
            quick_color: layer.pigment.rare.as_ref().and_then(|rare| rare.quick_color),
        })
    }

    fn shared_normal(&mut self, normal: &Arc<scene::Normal>) -> Result<Arc<Normal>, Refusal> {
        self.once(normal, |c| &mut c.normals, |c| c.normal(normal))
    }

    /// Compiles a pigment by itself, for skies, rainbows and functions.
    ///
    /// # Errors
    /// As [`texture`](Self::texture).
    pub fn pigment(&mut self, pigment: &scene::Pigment) -> Result<Pigment, Refusal> {
        self.part(|compiler| compiler.whole_pigment(pigment)).map_err(|r| r.at(pigment.span))
    }

    fn whole_pigment(&mut self, pigment: &scene::Pigment) -> Result<Pigment, Refusal> {
        Ok(match &pigment.kind {
            PigmentKind::Solid(color) => Pigment::Solid(*color),
            PigmentKind::Colors(pattern, colors) if matches!(pattern.kind, scene::PatternKind::Uv) => {
                Pigment::Solid(colors.items().next().copied().unwrap_or(Color::BLACK))
            }
            PigmentKind::Pigments(pattern, list) if matches!(pattern.kind, scene::PatternKind::Uv) => {
                let inner = list.items().next().ok_or("a map is missing")?;
                Pigment::Uv(Box::new(self.pigment(inner)?))
            }
            PigmentKind::Colors(pattern, colors) => {
                let colors = self.color_blend(&pattern.kind, colors)?;
                match single_color(&colors) {
                    Some(color) if self.ledger.omits(Omission::FlatMaps, size_of::<Pattern>()) => Pigment::Solid(color),
                    _ => Pigment::Colors(Box::new(self.pattern(pattern)?), colors),
                }
            }
            PigmentKind::Pigments(pattern, list) => {
                let pigments = self.once(list, |c| &mut c.pigments, |c| c.blend(list, |c, p| c.pigment(p)))?;
                Pigment::Pigments(Box::new(self.pattern(pattern)?), pigments)
            }
            PigmentKind::Image(pattern, image) => {
                let map = self.once(image, |c| &mut c.image_maps, |c| c.image_map(image))?;
                Pigment::Image(Box::new(self.pattern(pattern)?), map)
            }
        })
    }

    fn color_blend(
        &mut self,
        kind: &scene::PatternKind,
        colors: &Arc<scene::Blend<Color>>,
    ) -> Result<Arc<Blend<Color>>, Refusal> {
        if let scene::Blend::Default = **colors {
            let own = scene::default_colors(kind);
            return Ok(Arc::new(Blend::map(own.iter().map(|e| (f64::from(e.value), e.item)))));
        }
        self.once(colors, |c| &mut c.colors, |c| c.blend(colors, |_, color| Ok(*color)))
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
