//! Textures and their layers, each declared once where several things share it.

use super::number::float;
use super::writer::Writer;
use crate::scene::{Blend, MapEntry, PatternKind, PatternedTexture, PlacedTexture, Texture, TextureLayer};
use crate::stack::roomy;
use std::sync::Arc;

impl Writer<'_> {
    /// `texture` or `interior_texture` of an object, with the place where it was put.
    pub(super) fn placed_texture(&mut self, word: &str, placed: &PlacedTexture) {
        let PlacedTexture { texture, place } = placed;
        let moved = !place.transform().is_identity();
        // Where the transformations of a pattern end and those of the place begin, only a name can tell.
        let plain = matches!(&**texture, Texture::Layers(layers) if layers.len() == 1);
        if let Some(name) = self.texture_name(texture, moved && !plain) {
            self.open(word);
            self.line(name);
            self.place(place);
            return self.close();
        }
        match &**texture {
            Texture::Layers(layers) => {
                for layer in layers {
                    self.open(word);
                    self.layer(layer);
                    self.place(place);
                    self.close();
                }
            }
            Texture::Patterned(patterned) => {
                self.open(word);
                self.patterned(patterned);
                self.place(place);
                self.close();
            }
        }
    }

    /// A texture's name, if it has one.
    pub(super) fn texture_name(&mut self, texture: &Arc<Texture>, always: bool) -> Option<String> {
        let always = always || self.textures_ahead;
        self.shared(texture, "Texture", always, |w| w.texture_blocks(texture))
    }

    /// `texture { … }` for each layer.
    pub(super) fn texture_blocks(&mut self, texture: &Texture) {
        match texture {
            Texture::Layers(layers) => {
                for layer in layers {
                    self.open("texture");
                    self.layer(layer);
                    self.close();
                }
            }
            Texture::Patterned(patterned) => {
                self.open("texture");
                self.patterned(patterned);
                self.close();
            }
        }
    }

    /// The inside of a texture within another.
    fn texture_content(&mut self, texture: &Arc<Texture>) {
        let layered = matches!(&**texture, Texture::Layers(layers) if layers.len() != 1);
        if let Some(name) = self.texture_name(texture, layered) {
            return self.line(name);
        }
        match &**texture {
            Texture::Layers(layers) => layers.iter().for_each(|layer| self.layer(layer)),
            Texture::Patterned(patterned) => roomy(|| self.patterned(patterned)),
        }
    }

    /// A texture within another, in its braces.
    pub(super) fn inner_texture(&mut self, texture: &Arc<Texture>) {
        self.open("texture");
        self.texture_content(texture);
        self.close();
    }

    fn layer(&mut self, layer: &TextureLayer) {
        let TextureLayer { pigment, normal, finish, no_bump_scale, unfiltered } = layer;
        self.open("pigment");
        self.pigment_content(pigment);
        self.close();
        if let Some(normal) = normal {
            self.normal_block(normal);
        }
        self.finish(finish);
        if *no_bump_scale {
            self.line("no_bump_scale");
        }
        if *unfiltered {
            self.note("unfiltered");
        }
    }

    fn patterned(&mut self, texture: &PatternedTexture) {
        let PatternedTexture { pattern, map, no_bump_scale, uv_mapping, depth: _, span: _ } = texture;
        if *uv_mapping {
            self.line("uv_mapping");
        }
        if *no_bump_scale {
            self.line("no_bump_scale");
        }
        if let PatternKind::Material(image) = &pattern.kind {
            self.open("material_map");
            self.image(&image.0);
            self.mapping(&image.1);
            map.items().for_each(|texture| self.inner_texture(texture));
            self.close();
            return self.pattern(pattern, |_| {});
        }
        self.pattern(pattern, |w| {
            if let Blend::List(list) = map {
                list.iter().for_each(|texture| w.inner_texture(texture));
            }
        });
        self.blend("texture_map", map, |w, texture| w.texture_content(texture));
    }

    /// A map or an average; lists stand behind their pattern's word, and a pattern's own colours nowhere.
    pub(super) fn blend<T>(&mut self, word: &str, blend: &Blend<T>, mut item: impl FnMut(&mut Self, &T)) {
        match blend {
            Blend::Default | Blend::List(_) => {}
            Blend::Map(entries) | Blend::Average(entries) => {
                self.open(word);
                for MapEntry { value, item: content } in entries {
                    self.open_entry(*value);
                    item(self, content);
                    self.close_with("]");
                }
                self.close();
            }
        }
    }

    /// `[value …`, an entry of a map.
    pub(super) fn open_entry(&mut self, value: f32) {
        self.open_with(format_args!("[{}", float(value)));
    }
}
