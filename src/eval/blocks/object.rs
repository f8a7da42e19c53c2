//! Objects: copies, compounds and shapes, with what stands in their braces.

use super::object_words::{OBJECTS, words_in};
use super::table::Word;
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::{Evaluator, Value};
use crate::scene::{CsgOperation, Object, PlacedTexture, Shape, Texture};
use crate::stack::roomy;
use crate::syntax::{Keyword as K, TokenKind};
use std::sync::Arc;

impl Evaluator<'_> {
    /// An object, if one comes next: a shape in braces or the identifier of one.
    pub(super) fn object(&mut self) -> SourceResult<Option<Arc<Object>>> {
        match self.declared_object()? {
            Some(object) => Ok(Some(object)),
            None => Ok(self.object_block()?.map(Arc::new)),
        }
    }

    /// The same for an object that is to stand by itself: in no other, so it needs no room beyond its own.
    pub(super) fn own_object(&mut self) -> SourceResult<Option<Object>> {
        match self.declared_object()? {
            Some(object) => Ok(Some(Arc::unwrap_or_clone(object))),
            None => self.object_in_braces(),
        }
    }

    fn declared_object(&mut self) -> SourceResult<Option<Arc<Object>>> {
        self.take_declared(|v: &Value| if let Value::Object(o) = v { Some(o.clone()) } else { None })
    }

    fn object_block(&mut self) -> SourceResult<Option<Object>> {
        roomy(|| self.object_in_braces())
    }

    fn object_in_braces(&mut self) -> SourceResult<Option<Object>> {
        let Some(keyword) = self.keyword()?.filter(|keyword| OBJECTS.knows(*keyword)) else { return Ok(None) };
        let span = self.next()?.span;
        let origin = self.origin(span);
        let word = keyword.word();
        self.count_object(span)?;
        self.open(word)?;
        let mut object = self.object_start(keyword, span, origin)?;
        self.object_modifiers(&mut object)?;
        self.close_in(keyword)?;
        self.check_object(&mut object, span)?;
        Ok(Some(object))
    }

    /// What stands first inside an object's braces: another object to copy, or the shape.
    fn object_start(&mut self, keyword: K, span: Span, origin: Span) -> SourceResult<Object> {
        let csg = csg_operation(keyword);
        let name = self.name_ahead()?;
        let known = if keyword == K::LightGroup { None } else { self.declared_object()? };
        let first = name.zip(known);
        if let Some(operation) = csg {
            let children = self.csg_children(first.as_ref().map(|(_, object)| object.clone()))?;
            // One identifier alone is a copy of that object, whatever the keyword.
            if let (Some((name, object)), [_]) = (first, &children[..]) {
                return Ok(copy_of(&object, name, origin));
            }
            if children.len() < 2 && self.version >= 150 {
                self.warn_once(Topic::Geometry, span, "a CSG object should have at least two children");
            }
            let flat = |child: &Arc<Object>| child.shape.is_patch() && !matches!(child.shape, Shape::LightSource(_));
            if matches!(keyword, K::Intersection | K::Difference) && children.iter().any(flat) {
                let message = "a part of this has no inside (a mesh without inside_vector, a triangle, a patch)";
                self.warn_here(Topic::Geometry, span, message);
            }
            return Ok(Object::new(Shape::Csg { operation, children: children.into() }, origin));
        }
        if let Some((name, object)) = first {
            return Ok(copy_of(&object, name, origin));
        }
        match keyword {
            K::Object => match self.object()? {
                Some(inner) => Ok((*inner).clone()),
                None => self.expected("an object"),
            },
            K::LightGroup => {
                let mut group = Object::new(Shape::LightGroup { children: Arc::new([]), global_lights: false }, origin);
                self.light_group(&mut group)?;
                Ok(group)
            }
            word => Ok(Object::new(self.whole_of(&OBJECTS, Word { word, span })?, origin)),
        }
    }

    /// The identifier that comes next, if one does.
    fn name_ahead(&mut self) -> SourceResult<Option<Arc<str>>> {
        Ok(match self.peek()?.kind {
            TokenKind::Name(name) => Some((&**self.names.words.word(name)).into()),
            _ => None,
        })
    }

    fn csg_children(&mut self, first: Option<Arc<Object>>) -> SourceResult<Vec<Arc<Object>>> {
        let mut children: Vec<_> = first.into_iter().collect();
        while let Some(child) = self.object()? {
            children.push(child);
            self.comma()?;
        }
        Ok(children)
    }

    /// Takes the brace that ends an object, or says what that takes.
    fn close_in(&mut self, keyword: K) -> SourceResult<()> {
        if !self.accept_punct('}')? {
            return self.expected_in(words_in(keyword), &format!("'}}' to close {}", keyword.word()));
        }
        self.budget.shallower();
        Ok(())
    }

    /// Rules that hold once the whole block is read.
    fn check_object(&mut self, object: &mut Object, span: Span) -> SourceResult<()> {
        if object.rare.interior_texture.is_some() && object.texture.is_none() {
            return self.error(span, "an interior_texture needs a texture beside it");
        }
        let cuts =
            matches!(object.shape, Shape::Csg { operation: CsgOperation::Intersection | CsgOperation::Difference, .. });
        if object.flags.cutaway_textures && !cuts {
            return self.error(span, "cutaway_textures belongs to an intersection or difference");
        }
        object.depth = match object.depth_of_parts() {
            0 => 0,
            depth => self.within(self.budget.levels(depth), span)?,
        };
        Ok(())
    }
}

/// A copy that remembers the name it was declared under.
fn copy_of(object: &Object, name: Arc<str>, span: Span) -> Object {
    Object { span, name: Some(name), ..object.clone() }
}

/// The texture with its placement worked into it.
pub(super) fn in_place(placed: PlacedTexture) -> Arc<Texture> {
    let mut texture = placed.texture;
    if !placed.place.is_identity() {
        Arc::make_mut(&mut texture).apply(&placed.place.transform());
    }
    texture
}

fn csg_operation(keyword: K) -> Option<CsgOperation> {
    Some(match keyword {
        K::Union | K::Composite => CsgOperation::Union,
        K::Merge => CsgOperation::Merge,
        K::Intersection => CsgOperation::Intersection,
        K::Difference => CsgOperation::Difference,
        _ => return None,
    })
}
