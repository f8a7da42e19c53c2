//! `texture { … }`.

use super::pattern::PATTERNS;
use super::pattern_modifiers::{MODIFIERS, OF_KINDS, TURBULENCE};
use super::table::{Block, Item, Takes};
use crate::diag::SourceResult;
use crate::eval::{Evaluator, Value};
use crate::scene::{Blend, Normal, Pattern, PatternKind, PatternedTexture, Pigment, Texture, TextureLayer};
use crate::stack::roomy;
use crate::syntax::{Keyword as K, TokenKind};
use std::sync::Arc;

/// What a layer is made of.
pub(super) static LAYER: Block<TextureLayer> = Block::new(
    "layer of a texture",
    "what a layer of a texture is made of",
    &[
        Item::new(
            K::Pigment,
            Takes::Other("{ PIGMENT }", |e, layer, _| {
                let mut start = (*layer.pigment).clone();
                // What the block leaves of an upper layer stays as it was made of it.
                if std::mem::take(&mut layer.unfiltered) {
                    start.unfilter();
                }
                layer.pigment = Arc::new(e.pigment_block(start)?);
                Ok(())
            }),
            "",
            "its colours",
        ),
        Item::new(
            K::Normal,
            Takes::Other("{ NORMAL }", |e, layer, _| {
                layer.normal = e.normal_block(layer.normal.clone())?;
                Ok(())
            }),
            "",
            "its bumps",
        ),
        Item::new(
            K::Finish,
            Takes::Other("{ FINISH }", |e, layer, _| {
                let start = (*layer.finish).clone();
                layer.finish = e.shared_finish_block(start)?;
                Ok(())
            }),
            "",
            "how it shines and mirrors",
        ),
        Item::since(
            350,
            K::NoBumpScale,
            Takes::Nothing(|layer| layer.no_bump_scale = true),
            "",
            "bumps keep their depth when it is scaled",
        ),
    ],
);

/// What stands first in a texture.
#[derive(Default)]
pub(super) struct First {
    uv_mapping: bool,
    no_bump_scale: bool,
}

/// Behind its own words a texture is a layer, or has a pattern.
pub(super) static TEXTURE: Block<First> = Block::<First>::new(
    "texture",
    "what a surface looks like",
    &[
        Item::since(
            350,
            K::UvMapping,
            Takes::Nothing(|first| first.uv_mapping = true),
            "",
            "it lies on the surface by its own coordinates",
        ),
        Item::since(
            350,
            K::NoBumpScale,
            Takes::Nothing(|first| first.no_bump_scale = true),
            "",
            "bumps keep their depth when it is scaled",
        ),
    ],
)
.with(&[&LAYER, &WHOLE, &PATTERNED, &PATTERNS, &MODIFIERS, &TURBULENCE, &OF_KINDS]);

/// What stands in the place of a pattern.
static WHOLE: Block<PatternedTexture> = Block::new(
    "textures by a picture or in tiles",
    "in the place of a pattern",
    &[
        Item::new(
            K::MaterialMap,
            Takes::Other("{ IMAGE … TEXTURE, … }", |e, patterned, _| e.material_map(patterned)),
            "",
            "textures by the numbers of a picture's colours",
        ),
        Item::new(
            K::Tiles,
            Takes::Other("{ TEXTURE tile2 TEXTURE }", |e, patterned, _| e.tiles(patterned)),
            "",
            "outdated: two textures as a checker",
        ),
    ],
);

/// What a texture with a pattern takes.
static PATTERNED: Block<PatternedTexture> = Block::new(
    "textures with a pattern",
    "what a texture with a pattern takes",
    &[
        Item::new(
            K::TextureMap,
            Takes::Other("{ [FLOAT TEXTURE] … }", |e, patterned, at| {
                e.check_map(&patterned.pattern.kind, at, true)?;
                let average = matches!(patterned.pattern.kind, PatternKind::Average);
                patterned.map = e.texture_map(average)?;
                Ok(())
            }),
            "",
            "which texture is where in the pattern",
        ),
        Item::since(
            350,
            K::NoBumpScale,
            Takes::Nothing(|patterned| patterned.no_bump_scale = true),
            "",
            "bumps keep their depth when it is scaled",
        ),
    ],
);

impl Evaluator<'_> {
    /// `{ … }` after `texture`.
    pub(super) fn texture_block(&mut self) -> SourceResult<Arc<Texture>> {
        self.open("texture")?;
        let texture = self.texture_items()?;
        self.close_of(&TEXTURE)?;
        Ok(texture)
    }

    /// The inside of a texture, also of a `texture_map` entry.
    ///
    /// A declared texture that nothing is added to stays shared.
    pub(super) fn texture_items(&mut self) -> SourceResult<Arc<Texture>> {
        roomy(|| self.whole_texture())
    }

    fn whole_texture(&mut self) -> SourceResult<Arc<Texture>> {
        let pick = |v: &Value| if let Value::Texture(t) = v { Some(t.clone()) } else { None };
        if let Some(mut known) = self.take_declared(pick)? {
            if self.peek()?.kind != TokenKind::Punct('}') {
                self.texture_modifiers(Arc::make_mut(&mut known))?;
            }
            return Ok(known);
        }
        let mut first = First::default();
        while self.item_of(&TEXTURE, &mut first)? {}
        let First { uv_mapping, no_bump_scale } = first;
        if let Some(mut patterned) = self.patterned_texture()? {
            patterned.uv_mapping = uv_mapping;
            patterned.no_bump_scale |= no_bump_scale;
            return Ok(Arc::new(Texture::Patterned(Box::new(patterned))));
        }
        let mut layer = self.defaults.layer.clone();
        layer.no_bump_scale |= no_bump_scale;
        let mut texture = Texture::Layers(vec![layer]);
        self.texture_modifiers(&mut texture)?;
        if let (true, Texture::Layers(layers)) = (uv_mapping, &mut texture) {
            // Before a plain texture's parts: each of them is looked up at (u, v, 0).
            for layer in layers {
                layer.pigment = Arc::new(Pigment::at_uv(layer.pigment.clone()));
                layer.normal = layer.normal.take().map(|normal| Arc::new(Normal::at_uv(normal)));
            }
        }
        Ok(Arc::new(texture))
    }

    /// Pigments, normals, finishes and transformations on top of what is there.
    fn texture_modifiers(&mut self, texture: &mut Texture) -> SourceResult<()> {
        loop {
            self.comma()?;
            if let Some(transform) = self.transformation()? {
                texture.apply(&transform);
                continue;
            }
            let more = match texture {
                Texture::Layers(layers) => match layers.last_mut() {
                    Some(top) => self.layer_item(top)?,
                    None => false,
                },
                Texture::Patterned(patterned) => self.patterned_item(patterned)?,
            };
            if !more {
                return Ok(());
            }
        }
    }

    /// A pigment, normal or finish that replaces a part of `layer`; also their bare identifiers.
    pub(super) fn layer_item(&mut self, layer: &mut TextureLayer) -> SourceResult<bool> {
        match self.keyword()? {
            Some(_) => self.item_of(&LAYER, layer),
            None => self.layer_identifier(layer),
        }
    }

    fn layer_identifier(&mut self, layer: &mut TextureLayer) -> SourceResult<bool> {
        match self.declared()? {
            Some(Value::Pigment(pigment)) => {
                layer.pigment = pigment;
                layer.unfiltered = false;
            }
            Some(Value::Normal(normal)) => layer.normal = Some(normal),
            Some(Value::Finish(finish)) => layer.finish = finish,
            _ => return Ok(false),
        }
        self.take_declared(|_| Some(()))?;
        Ok(true)
    }

    /// The inside of a texture that starts with a pattern, if one does here.
    fn patterned_texture(&mut self) -> SourceResult<Option<PatternedTexture>> {
        let span = self.peek()?.span;
        let mut patterned = PatternedTexture {
            span,
            pattern: Pattern::new(PatternKind::None),
            map: Blend::Default,
            no_bump_scale: false,
            uv_mapping: false,
            depth: 0,
        };
        if !self.item_of(&WHOLE, &mut patterned)? && !self.texture_pattern(&mut patterned)? {
            return Ok(None);
        }
        while self.patterned_item(&mut patterned)? {
            self.comma()?;
        }
        if matches!(patterned.map, Blend::Default) {
            return self.error(span, "a texture with a pattern needs a texture_map or a list of textures");
        }
        patterned.depth = self.within(self.budget.levels(patterned.depth_of_parts()), span)?;
        Ok(Some(patterned))
    }

    fn patterned_item(&mut self, patterned: &mut PatternedTexture) -> SourceResult<bool> {
        Ok(self.item_of(&PATTERNED, patterned)?
            || self.texture_pattern(patterned)?
            || self.pattern_modifier(&mut patterned.pattern)?)
    }

    /// A pattern keyword, with its textures if it is a block pattern.
    fn texture_pattern(&mut self, patterned: &mut PatternedTexture) -> SourceResult<bool> {
        let mut list = Vec::new();
        let mut read_list = |e: &mut Evaluator, n: usize| {
            e.comma()?;
            while list.len() < n && e.accept(K::Texture)? {
                list.push(e.texture_block()?);
                e.comma()?;
            }
            list.resize_with(n, || e.defaults.texture());
            Ok(())
        };
        let read = self.pattern_keyword(&mut patterned.pattern, &mut read_list)?;
        if !list.is_empty() {
            patterned.map = Blend::List(list);
        }
        Ok(read)
    }

    /// `material_map { IMAGE options texture … }`, after the word.
    fn material_map(&mut self, patterned: &mut PatternedTexture) -> SourceResult<()> {
        self.open("material_map")?;
        let image = self.image()?;
        let mut mapping = Default::default();
        while self.image_option(&mut mapping)? {}
        let mut textures = Vec::new();
        while self.accept(K::Texture)? {
            textures.push(self.texture_block()?);
            self.comma()?;
        }
        if textures.is_empty() {
            return self.expected("a texture of the material_map");
        }
        self.close("material_map")?;
        patterned.pattern.kind = PatternKind::Material(Arc::new((image, mapping)));
        patterned.pattern.frequency = 0.0;
        patterned.map = Blend::List(textures);
        Ok(())
    }

    /// `tiles { texture { … } tile2 texture { … } }`, after the word.
    fn tiles(&mut self, patterned: &mut PatternedTexture) -> SourceResult<()> {
        self.open("tiles")?;
        let mut textures = Vec::new();
        for word in [None, Some(K::Tile2)] {
            if let Some(word) = word
                && !self.accept(word)?
            {
                return self.expected("'tile2'");
            }
            if !self.accept(K::Texture)? {
                return self.expected("a texture");
            }
            textures.push(self.texture_block()?);
        }
        self.close("tiles")?;
        // The first texture lies on odd cubes: the other way round than with checker.
        textures.reverse();
        patterned.pattern = Pattern { frequency: 0.0, ..Pattern::new(PatternKind::Checker) };
        patterned.map = Blend::List(textures);
        Ok(())
    }
}
