//! Layers of textures, and `material { … }`.

use super::object::in_place;
use super::table::{Block, Item, Takes, Word};
use super::texture::LAYER;
use crate::diag::{SourceResult, Span};
use crate::eval::{Evaluator, Value};
use crate::scene::{Interior, PlacedTexture, Texture, TextureLayer};
use crate::syntax::{Keyword as K, TokenKind};
use std::sync::Arc;

/// `material`: textures and an interior under one name.
#[derive(Clone, Debug, Default)]
pub struct Material {
    /// The texture, if given.
    pub texture: Option<Arc<Texture>>,
    /// The inner texture, if given.
    pub interior_texture: Option<Arc<Texture>>,
    /// The interior, if given.
    pub interior: Option<Arc<Interior>>,
}

/// Most layers of a texture: far more than light gets through.
const MAX_LAYERS: usize = 1_000_000;

/// The last version in which upper layers let light through without filtering it.
const LAST_UNFILTERED: u32 = 310;

impl Evaluator<'_> {
    /// `texture { … } texture { … } …` of a declaration: all layers.
    ///
    /// A directive behind a layer waits until the declaration is complete.
    pub(super) fn layered_textures(&mut self) -> SourceResult<Arc<Texture>> {
        let mut span = self.next()?.span;
        let mut texture = None;
        loop {
            let layer = self.texture_block()?;
            let stacked = self.stack(texture, layer, span)?;
            if self.fill(true)? != TokenKind::Keyword(K::Texture) {
                return Ok(stacked);
            }
            texture = Some(stacked);
            span = self.next()?.span;
        }
    }

    /// Lays a texture over that of an object, if it has one.
    pub(super) fn layer_over(
        &mut self,
        below: Option<PlacedTexture>,
        top: Arc<Texture>,
        span: Span,
    ) -> SourceResult<PlacedTexture> {
        Ok(PlacedTexture::new(self.stack(below.map(in_place), top, span)?))
    }

    /// Lays `top` over `below`, if there is something; only plain textures can be layered.
    fn stack(&mut self, below: Option<Arc<Texture>>, mut top: Arc<Texture>, span: Span) -> SourceResult<Arc<Texture>> {
        if self.version <= LAST_UNFILTERED {
            unfilter(&mut top, below.is_some());
        }
        let Some(below) = below else { return Ok(top) };
        match (Arc::unwrap_or_clone(below), Arc::unwrap_or_clone(top)) {
            (Texture::Layers(layers), Texture::Layers(more)) if layers.len() + more.len() > MAX_LAYERS => {
                self.error(span, format!("a texture of more than {MAX_LAYERS} layers"))
            }
            (Texture::Layers(mut layers), Texture::Layers(more)) => {
                layers.extend(more);
                Ok(Arc::new(Texture::Layers(layers)))
            }
            (Texture::Patterned(_), _) => self.error(span, "cannot layer a texture over a patterned one"),
            (_, Texture::Patterned(_)) => self.error(span, "cannot layer a patterned texture over another"),
        }
    }

    /// `pigment`, `normal` or `finish` of an object: a part of its texture's top layer.
    pub(super) fn change_top_layer(&mut self, placed: Option<PlacedTexture>, at: Word) -> SourceResult<PlacedTexture> {
        let mut texture = placed.map_or_else(|| self.defaults.texture(), in_place);
        self.change_top(&mut texture, at)?;
        Ok(PlacedTexture::new(texture))
    }

    fn change_top(&mut self, texture: &mut Arc<Texture>, at: Word) -> SourceResult<()> {
        match Arc::make_mut(texture) {
            Texture::Layers(layers) => {
                if let Some(top) = layers.last_mut() {
                    self.item_behind(&LAYER, top, at)?;
                }
                Ok(())
            }
            Texture::Patterned(_) => {
                self.error(at.span, "a patterned texture takes no pigment, normal or finish of its own")
            }
        }
    }

    /// `{ … }` after `material`.
    pub(super) fn material_block(&mut self) -> SourceResult<Material> {
        self.open("material")?;
        let pick = |v: &Value| if let Value::Material(m) = v { Some((**m).clone()) } else { None };
        let mut material = self.take_declared(pick)?.unwrap_or_default();
        while self.item_of(&MATERIAL, &mut material)? {}
        self.close_of(&MATERIAL)?;
        Ok(material)
    }
}

pub(super) static MATERIAL: Block<Material> = Block::moved(
    "material",
    "texture and interior in one",
    |_, material, transform| {
        for texture in [&mut material.texture, &mut material.interior_texture].into_iter().flatten() {
            Arc::make_mut(texture).apply(transform);
        }
        if let Some(interior) = &mut material.interior {
            Arc::make_mut(interior).apply(transform);
        }
    },
    &[
        Item::new(
            K::Texture,
            Takes::Other("{ TEXTURE }", |e, material, at| {
                let texture = e.texture_block()?;
                material.texture = Some(e.stack(material.texture.take(), texture, at.span)?);
                Ok(())
            }),
            "",
            "what the surface looks like; several are layers",
        ),
        Item::new(
            K::InteriorTexture,
            Takes::Other("{ TEXTURE }", |e, material, at| {
                let texture = e.texture_block()?;
                material.interior_texture = Some(e.stack(material.interior_texture.take(), texture, at.span)?);
                Ok(())
            }),
            "",
            "what the surface looks like from inside",
        ),
        Item::new(K::Pigment, Takes::Other("{ PIGMENT }", change_top), "", "colours of the uppermost layer"),
        Item::new(K::Normal, Takes::Other("{ NORMAL }", change_top), "", "bumps of the uppermost layer"),
        Item::new(K::Finish, Takes::Other("{ FINISH }", change_top), "", "how the uppermost layer shines"),
        Item::new(
            K::Interior,
            Takes::Other("{ INTERIOR }", |e, material, _| {
                material.interior = Some(Arc::new(e.interior_block(material.interior.take())?));
                Ok(())
            }),
            "",
            "what it is filled with",
        ),
    ],
);

fn change_top(e: &mut Evaluator<'_>, material: &mut Material, at: Word) -> SourceResult<()> {
    let mut texture = material.texture.take().unwrap_or_else(|| e.defaults.texture());
    e.change_top(&mut texture, at)?;
    material.texture = Some(texture);
    Ok(())
}

/// Marks a texture's layers as upper ones of an old scene, its lowest only where it lies over others.
fn unfilter(texture: &mut Arc<Texture>, over_others: bool) {
    let first = usize::from(!over_others);
    let upper = |texture: &Texture| matches!(texture, Texture::Layers(layers) if layers.len() > first);
    if upper(texture)
        && let Texture::Layers(layers) = Arc::make_mut(texture)
    {
        layers[first..].iter_mut().for_each(|layer: &mut TextureLayer| layer.unfiltered = true);
    }
}
