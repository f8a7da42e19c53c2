//! Textures and finishes.

use super::reader::{Reader, Value, misplaced};
use super::tree::{Items, Node, Read, Rule, place, wrong};
use crate::math::Transform;
use crate::scene::{
    Blend, Finish, MapEntry, Pattern, PatternKind, PatternedTexture, Place, PlacedTexture, Texture, TextureLayer,
};
use crate::stack::roomy;
use std::sync::Arc;

impl<'a> Reader<'a> {
    /// One or more `texture { … }`: all layers.
    pub(super) fn textures(&mut self, node: Node<'a>) -> Read<Arc<Texture>> {
        let mut texture = None;
        for layer in node.into_inner() {
            self.add_texture(layer, &mut texture)?;
        }
        Ok(in_place(texture.unwrap_or_else(|| PlacedTexture::new(Arc::default()))))
    }

    /// A texture with its transformations worked in.
    pub(super) fn texture(&mut self, node: Node<'a>) -> Read<Arc<Texture>> {
        let content = Items::of(node).node()?;
        Ok(in_place(self.texture_content(content)?))
    }

    /// Lays a texture over what is there already.
    pub(super) fn add_texture(&mut self, node: Node<'a>, below: &mut Option<PlacedTexture>) -> Read<()> {
        let top = self.texture_content(Items::of(node.clone()).node()?)?;
        let Some(known) = below.take() else {
            *below = Some(top);
            return Ok(());
        };
        let (known, top) = (Arc::unwrap_or_clone(in_place(known)), Arc::unwrap_or_clone(in_place(top)));
        let (Texture::Layers(mut layers), Texture::Layers(more)) = (known, top) else {
            return wrong(&node, "patterned textures cannot be layered");
        };
        layers.extend(more);
        *below = Some(PlacedTexture::new(Arc::new(Texture::Layers(layers))));
        Ok(())
    }

    /// The inside of a texture: what it is, and where it was put.
    pub(super) fn texture_content(&mut self, node: Node<'a>) -> Read<PlacedTexture> {
        let inner = Items::of(node).node()?;
        let (texture, rest) = match inner.as_rule() {
            Rule::known_texture => {
                let mut items = Items::of(inner);
                (self.known_texture(&items.node()?)?, items)
            }
            Rule::patterned_texture => {
                return Ok(PlacedTexture::new(Arc::new(Texture::Patterned(Box::new(roomy(|| {
                    self.patterned(inner)
                })?)))));
            }
            _ => {
                let mut items = Items::of(inner);
                let layer = self.layer(&mut items)?;
                (Arc::new(Texture::Layers(vec![layer])), items)
            }
        };
        let mut place = Place::default();
        for transform in rest {
            place.apply(&self.transform(transform)?);
        }
        Ok(PlacedTexture { texture, place })
    }

    fn layer(&mut self, items: &mut Items<'a>) -> Read<TextureLayer> {
        let mut layer = TextureLayer::default();
        while let Some(rule) = items.peek().filter(|rule| *rule != Rule::transform) {
            let item = items.node()?;
            match rule {
                Rule::pigment => layer.pigment = self.pigment(item)?,
                Rule::normal => layer.normal = Some(self.normal(item)?),
                Rule::finish => layer.finish = self.finish_block(item)?,
                Rule::no_bump_scale => layer.no_bump_scale = true,
                _ => layer.unfiltered = true,
            }
        }
        Ok(layer)
    }

    fn patterned(&mut self, node: Node<'a>) -> Read<PatternedTexture> {
        let mut items = Items::of(node.clone());
        let uv_mapping = items.accept(Rule::uv_mapping);
        let no_bump_scale = items.accept(Rule::no_bump_scale);
        let head = items.node()?;
        let mut map = Blend::Default;
        let mut pattern = if head.as_rule() == Rule::material_map {
            let mut inner = Items::of(head);
            let image = self.image_and_mapping(inner.node()?)?;
            map = Blend::List(inner.map(|texture| self.texture(texture)).collect::<Read<_>>()?);
            Pattern::new(PatternKind::Material(Arc::new(image)))
        } else {
            let (pattern, list) = self.pattern(head)?;
            if let Some(list) = list {
                self.check_items(&list, &pattern.kind, Rule::texture)?;
                map = Blend::List(list.into_inner().map(|texture| self.texture(texture)).collect::<Read<_>>()?);
            }
            pattern
        };
        for item in items {
            if item.as_rule() != Rule::texture_map {
                self.pattern_modifier(item, &mut pattern)?;
                continue;
            }
            let mut entries = Vec::new();
            for entry in item.into_inner() {
                let mut inner = Items::of(entry);
                let value = inner.float()?;
                let content = inner.node()?;
                entries.push(MapEntry { value, item: in_place(self.texture_content(content)?) });
            }
            map = blend(entries, &pattern);
        }
        if matches!(map, Blend::Default) {
            return wrong(&node, "a texture with a pattern needs a texture_map or a list of textures");
        }
        let mut texture = PatternedTexture { pattern, map, no_bump_scale, uv_mapping, depth: 0, span: place(&node) };
        texture.depth = self.nested(texture.depth_of_parts(), &node)?;
        Ok(texture)
    }

    /// `finish { … }`.
    pub(super) fn finish_block(&mut self, node: Node<'a>) -> Read<Arc<Finish>> {
        let mut items = Items::of(node);
        if let Some(name) = items.optional(Rule::identifier) {
            return self.known(&name, "finish", |v| if let Value::Finish(f) = v { Some(Arc::clone(f)) } else { None });
        }
        let mut finish = Finish::default();
        let (mut albedo, mut raw) = (false, None);
        for item in items {
            match item.as_rule() {
                Rule::diffuse => {
                    let mut inner = Items::of(item);
                    albedo = inner.accept(Rule::albedo);
                    (finish.diffuse, finish.diffuse_back) = (inner.float()?, inner.float()?);
                }
                Rule::raw_note => raw = Some(Items::of(item).float()?),
                _ => finish_term(item, &mut finish)?,
            }
        }
        finish.raw_diffuse = raw.unwrap_or(finish.diffuse);
        if albedo {
            // Source: docs/povray/shading.md, section 5.1.
            let scale = (finish.brilliance + 1.0) / 2.0;
            finish.diffuse *= scale;
            finish.diffuse_back *= scale;
        }
        Ok(Arc::new(finish))
    }
}

fn finish_term(node: Node<'_>, finish: &mut Finish) -> Read<()> {
    let rule = node.as_rule();
    let mut items = Items::of(node.clone());
    match rule {
        Rule::finish_color => {
            let field = if items.word()? == "ambient" { &mut finish.ambient } else { &mut finish.emission };
            *field = items.rgb()?;
        }
        Rule::finish_number => finish_number(&mut items, finish)?,
        Rule::conserve_energy => finish.conserve_energy = true,
        Rule::irid => {
            finish.irid_amount = items.float()?;
            finish.irid_thickness = items.float()?;
            finish.irid_turbulence = items.float()?;
        }
        Rule::reflection => {
            finish.reflection_min = items.rgb()?;
            finish.reflection_max = items.rgb()?;
            finish.reflection_fresnel = items.accept(Rule::fresnel);
            for item in items {
                let mut inner = Items::of(item);
                let falloff = inner.word()? == "falloff";
                *(if falloff { &mut finish.reflection_falloff } else { &mut finish.reflection_metallic }) =
                    inner.float()?;
            }
        }
        Rule::subsurface => finish.subsurface_translucency = Some(items.rgb()?),
        _ => return misplaced(&node),
    }
    Ok(())
}

fn finish_number(items: &mut Items<'_>, finish: &mut Finish) -> Read<()> {
    let word = items.word()?;
    let node = items.node()?;
    let number = super::tree::number(&node)?;
    let value = number as f32;
    match word {
        "brilliance" => finish.brilliance = value,
        "crand" => finish.crand = value,
        "phong" => finish.phong = value,
        "phong_size" => finish.phong_size = value,
        "specular" => finish.specular = value,
        "roughness" => finish.specular_exponent = if number == 0.0 { 0.0 } else { (1.0 / number) as f32 },
        "metallic" => finish.metallic = value,
        "reflection_exponent" if value == 0.0 => return wrong(&node, "reflection_exponent must not be 0"),
        "reflection_exponent" => finish.reflection_exponent = value,
        "ior" => finish.ior = Some(value),
        "caustics" => finish.caustics = Some(value),
        _ => finish.refraction = Some(value),
    }
    Ok(())
}

/// Entries as what their pattern makes of them.
pub(super) fn blend<T>(entries: Vec<MapEntry<T>>, pattern: &Pattern) -> Blend<T> {
    if matches!(pattern.kind, PatternKind::Average) { Blend::Average(entries) } else { Blend::Map(entries) }
}

/// The texture with its place worked into it.
fn in_place(placed: PlacedTexture) -> Arc<Texture> {
    let mut texture = placed.texture;
    let transform: Transform = placed.place.transform();
    if !transform.is_identity() {
        Arc::make_mut(&mut texture).apply(&transform);
    }
    texture
}
