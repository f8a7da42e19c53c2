//! Objects and all that is said about them.

use super::reader::{Reader, Value, misplaced};
use super::tree::{Items, Node, Read, Rule, place, wrong};
use crate::scene::{CsgOperation, Flags, Object, PhotonFlags, PlacedTexture, Shape};
use crate::stack::roomy;
use std::sync::Arc;

impl<'a> Reader<'a> {
    /// Any object; a name that nothing is added to stays shared.
    pub(super) fn object(&mut self, node: Node<'a>) -> Read<Arc<Object>> {
        roomy(|| self.whole_object(node))
    }

    fn whole_object(&mut self, node: Node<'a>) -> Read<Arc<Object>> {
        let mut items = Items::of(node.clone());
        let mut object = match node.as_rule() {
            Rule::known_object => {
                let pick = |v: &Value| if let Value::Object(o) = v { Some(Arc::clone(o)) } else { None };
                let known = self.known(&items.node()?, "object", pick)?;
                let unchanged = items.clone().next().is_none_or(|modifiers| modifiers.into_inner().next().is_none());
                if unchanged {
                    return Ok(known);
                }
                Object { span: place(&node), ..(*known).clone() }
            }
            Rule::csg => {
                let operation = match items.word()? {
                    "union" => CsgOperation::Union,
                    "merge" => CsgOperation::Merge,
                    "intersection" => CsgOperation::Intersection,
                    _ => CsgOperation::Difference,
                };
                let children = self.children(&mut items)?.into();
                Object::new(Shape::Csg { operation, children }, place(&node))
            }
            Rule::light_group => {
                let children = self.children(&mut items)?.into();
                let global_lights = items.accept(Rule::global_lights);
                Object::new(Shape::LightGroup { children, global_lights }, place(&node))
            }
            _ => Object::new(self.shape(&node, &mut items)?, place(&node)),
        };
        for modifier in items.node()?.into_inner() {
            self.modifier(modifier, &mut object)?;
        }
        if object.rare.interior_texture.is_some() && object.texture.is_none() {
            return wrong(&node, "an interior_texture needs a texture beside it");
        }
        object.depth = self.nested(object.depth_of_parts(), &node)?;
        Ok(Arc::new(object))
    }

    /// Objects up to the modifiers of what they are in.
    fn children(&mut self, items: &mut Items<'a>) -> Read<Vec<Arc<Object>>> {
        let mut children = Vec::new();
        while !matches!(items.peek(), None | Some(Rule::modifiers | Rule::global_lights)) {
            let child = items.node()?;
            children.push(self.object(child)?);
        }
        Ok(children)
    }

    fn modifier(&mut self, node: Node<'a>, object: &mut Object) -> Read<()> {
        match node.as_rule() {
            Rule::name_note => object.name = Some(Items::of(node).word()?.into()),
            Rule::transform => object.apply(&self.transform(node)?),
            Rule::uv_mapping => {
                if object.texture.is_some() {
                    return wrong(&node, "uv_mapping must be specified before the texture");
                }
                object.flags.uv_mapping = true;
            }
            Rule::texture => self.add_texture(node, &mut object.texture)?,
            Rule::interior_texture => {
                let mut texture: Option<PlacedTexture> = object.rare.interior_texture.take();
                self.add_texture(node, &mut texture)?;
                object.rare.interior_texture = texture;
            }
            Rule::interior => object.interior = Some(self.interior(node)?),
            Rule::flag => flag(node, object)?,
            Rule::photons => object.rare.photons = photons(node)?,
            Rule::importance => object.rare.radiosity_importance = Some(self.importance(node)?),
            Rule::clipped_by => object.rare.clipped_by = self.cutters(node)?,
            Rule::bounded_by => {
                if node.clone().into_inner().any(|inner| inner.as_rule() == Rule::by_clips) {
                    object.rare.bounded_by = object.rare.clipped_by.clone();
                    object.flags.bounds_are_clips = true;
                } else {
                    object.rare.bounded_by = self.cutters(node)?;
                }
            }
            _ => return misplaced(&node),
        }
        Ok(())
    }

    fn cutters(&mut self, node: Node<'a>) -> Read<Vec<Arc<Object>>> {
        let mut objects = Vec::new();
        for inner in node.into_inner() {
            let object = self.object(inner.clone())?;
            if object.texture.is_some() || object.shape.is_patch() {
                return wrong(&inner, "a clip or bound must be a solid without a texture");
            }
            objects.push(object);
        }
        Ok(objects)
    }

    /// `radiosity { importance F }`.
    pub(super) fn importance(&mut self, node: Node<'a>) -> Read<f32> {
        let importance = Items::of(node.clone()).float()?;
        if importance > 0.0 && importance <= 1.0 {
            return Ok(importance);
        }
        wrong(&node, "radiosity importance must be above 0 and at most 1")
    }
}

fn flag(node: Node<'_>, object: &mut Object) -> Read<()> {
    let mut items = Items::of(node.clone());
    let (word, on) = (items.word()?, items.switch());
    let flags: &mut Flags = &mut object.flags;
    match word {
        "inverse" => {
            flags.inverse = !flags.inverse;
            flags.turned = true;
        }
        "no_shadow" => flags.no_shadow = on,
        "no_image" => flags.no_image = on,
        "no_reflection" => flags.no_reflection = on,
        "no_radiosity" => flags.no_radiosity = on,
        "cutaway_textures" => {
            if !object.shape.is_cut() {
                return wrong(&node, "cutaway_textures belongs to an intersection or difference");
            }
            flags.cutaway_textures = on;
        }
        "hierarchy" => flags.no_hierarchy = !on,
        "split_union" => flags.keep_union = !on,
        "hollow" => flags.hollow = Some(on),
        _ => flags.double_illuminate = Some(on),
    }
    Ok(())
}

/// `photons { … }` of an object or light.
pub(super) fn photons(node: Node<'_>) -> Read<PhotonFlags> {
    let mut photons = PhotonFlags::NONE;
    for item in node.into_inner() {
        let rule = item.as_rule();
        let mut items = Items::of(item);
        if rule == Rule::photon_target {
            photons.target = Some(if items.peek().is_some() { items.number()? } else { 1.0 });
            continue;
        }
        let (word, on) = (items.word()?, items.switch());
        match word {
            "refraction" => photons.refraction = Some(on),
            "reflection" => photons.reflection = Some(on),
            "collect" => photons.collect = Some(on),
            "pass_through" => photons.pass_through = on,
            _ => photons.area_light = on,
        }
    }
    Ok(photons)
}
