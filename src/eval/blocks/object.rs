//! Objects: which keyword makes which shape, and the modifiers that every object takes.

use crate::diag::{SourceResult, Span, Topic};
use crate::eval::{Evaluator, Value};
use crate::scene::{CsgOperation, Object, PhotonFlags, PlacedTexture, Shape, Texture};
use crate::stack::roomy;
use crate::syntax::{Keyword as K, TokenKind};
use std::sync::Arc;

/// Modifiers that only some shapes take.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shaped {
    Sturm,
    Hierarchy,
    Open,
}

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
        let Some(keyword) = self.keyword()?.filter(|keyword| is_object_keyword(*keyword)) else { return Ok(None) };
        let span = self.next()?.span;
        let word = keyword.word();
        self.count_object(span)?;
        self.open(word)?;
        let mut object = self.object_start(keyword, span)?;
        self.object_modifiers(&mut object)?;
        self.close(word)?;
        self.check_object(&mut object, span)?;
        Ok(Some(object))
    }

    /// What stands first inside an object's braces: another object to copy, or the shape.
    fn object_start(&mut self, keyword: K, span: Span) -> SourceResult<Object> {
        let csg = csg_operation(keyword);
        let name = self.name_ahead()?;
        let known = if keyword == K::LightGroup { None } else { self.declared_object()? };
        let first = name.zip(known);
        if let Some(operation) = csg {
            let children = self.csg_children(first.as_ref().map(|(_, object)| object.clone()))?;
            // One identifier alone is a copy of that object, whatever the keyword.
            if let (Some((name, object)), [_]) = (first, &children[..]) {
                return Ok(copy_of(&object, name, span));
            }
            if children.len() < 2 && self.version >= 150 {
                self.warn_once(Topic::Geometry, span, "a CSG object should have at least two children");
            }
            let flat = |child: &Arc<Object>| child.shape.is_patch() && !matches!(child.shape, Shape::LightSource(_));
            if matches!(keyword, K::Intersection | K::Difference) && children.iter().any(flat) {
                let message = "a part of this has no inside (a mesh without inside_vector, a triangle, a patch)";
                self.warn_here(Topic::Geometry, span, message);
            }
            return Ok(Object::new(Shape::Csg { operation, children: children.into() }, span));
        }
        if let Some((name, object)) = first {
            return Ok(copy_of(&object, name, span));
        }
        match keyword {
            K::Object => match self.object()? {
                Some(inner) => Ok((*inner).clone()),
                None => self.expected("an object"),
            },
            K::LightGroup => {
                let mut group = Object::new(Shape::LightGroup { children: Arc::new([]), global_lights: false }, span);
                self.light_group(&mut group)?;
                Ok(group)
            }
            _ => Ok(Object::new(self.shape(keyword, span)?, span)),
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

    /// Everything that may follow the shape inside an object's braces.
    pub(super) fn object_modifiers(&mut self, object: &mut Object) -> SourceResult<()> {
        loop {
            if let Some(transform) = self.transformation()? {
                object.apply(&transform);
                continue;
            }
            let Some(keyword) = self.keyword()? else { return Ok(()) };
            let known = self.appearance_modifier(keyword, object)?
                || self.flag_modifier(keyword, object)?
                || self.other_modifier(keyword, object)?;
            if !known {
                return Ok(());
            }
        }
    }

    fn appearance_modifier(&mut self, keyword: K, object: &mut Object) -> SourceResult<bool> {
        let span = self.span();
        match keyword {
            K::Texture => {
                self.next()?;
                let texture = self.texture_block()?;
                let below = object.texture.take();
                object.texture = Some(self.layer_over(below, texture, span)?);
            }
            K::InteriorTexture => {
                self.next()?;
                let texture = self.texture_block()?;
                let below = object.rare.interior_texture.take();
                object.rare.interior_texture = Some(self.layer_over(below, texture, span)?);
            }
            K::Pigment | K::Normal | K::Finish => {
                let placed = object.texture.take();
                object.texture = Some(self.change_top_layer(placed, span)?);
            }
            K::Interior => {
                self.next()?;
                let start = object.interior.take();
                object.interior = Some(Arc::new(self.interior_block(start)?));
            }
            K::Material => {
                self.next()?;
                let material = self.material_block()?;
                if let Some(texture) = material.texture {
                    let below = object.texture.take();
                    object.texture = Some(self.layer_over(below, texture, span)?);
                }
                if let Some(texture) = material.interior_texture {
                    let below = object.rare.interior_texture.take();
                    object.rare.interior_texture = Some(self.layer_over(below, texture, span)?);
                }
                if material.interior.is_some() {
                    object.interior = material.interior;
                }
            }
            K::UvMapping => {
                self.next()?;
                if object.texture.is_some() {
                    return self.error(span, "uv_mapping must be specified before the texture");
                }
                object.flags.uv_mapping = true;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn flag_modifier(&mut self, keyword: K, object: &mut Object) -> SourceResult<bool> {
        let span = self.span();
        match keyword {
            K::Inverse => {
                self.next()?;
                if object.shape.is_patch() {
                    self.warn(Topic::Geometry, span, "a surface without an inside cannot be inverted");
                }
                object.flags.inverse = !object.flags.inverse;
                object.flags.turned = true;
            }
            K::NoShadow => {
                self.next()?;
                object.flags.no_shadow = true;
            }
            K::CutawayTextures => {
                self.next()?;
                object.flags.cutaway_textures = true;
            }
            K::Hollow => {
                self.next()?;
                object.flags.hollow = Some(self.optional_bool()?);
            }
            K::DoubleIlluminate => {
                self.next()?;
                object.flags.double_illuminate = Some(self.optional_bool()?);
            }
            K::NoImage => {
                self.next()?;
                object.flags.no_image = self.optional_bool()?;
            }
            K::NoReflection => {
                self.next()?;
                object.flags.no_reflection = self.optional_bool()?;
            }
            K::NoRadiosity => {
                self.next()?;
                object.flags.no_radiosity = self.optional_bool()?;
            }
            K::SplitUnion => {
                self.next()?;
                object.flags.keep_union = !self.optional_bool()?;
            }
            K::Hierarchy => {
                self.next()?;
                self.shape_takes(object, Shaped::Hierarchy, span, "hierarchy")?;
                object.flags.no_hierarchy = !self.optional_bool()?;
            }
            K::Sturm => {
                self.next()?;
                self.shape_takes(object, Shaped::Sturm, span, "sturm")?;
                let on = self.optional_bool()?;
                object.shape.set_sturm(on);
            }
            K::Open => {
                self.next()?;
                self.shape_takes(object, Shaped::Open, span, "open")?;
                object.shape.set_open();
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn shape_takes(&mut self, object: &Object, what: Shaped, span: Span, word: &str) -> SourceResult<()> {
        let takes = match what {
            Shaped::Sturm => object.shape.takes_sturm(),
            Shaped::Hierarchy => {
                matches!(object.shape, Shape::Mesh(_) | Shape::HeightField(_) | Shape::Blob(_))
            }
            Shaped::Open => matches!(object.shape, Shape::Isosurface(_)),
        };
        if takes {
            return Ok(());
        }
        let message = format!("'{word}' cannot be used with this object");
        match what {
            Shaped::Open => self.error_with_hint(
                span,
                message,
                "in a cylinder, cone or prism 'open' stands before pigment and other modifiers",
            ),
            _ => self.error(span, message),
        }
    }

    fn other_modifier(&mut self, keyword: K, object: &mut Object) -> SourceResult<bool> {
        let span = self.span();
        match keyword {
            K::ClippedBy => {
                self.next()?;
                self.open("clipped_by")?;
                if self.accept(K::BoundedBy)? {
                    object.rare.clipped_by = object.rare.bounded_by.clone();
                    object.flags.bounds_are_clips = true;
                } else {
                    let clips = self.clip_objects(span)?;
                    object.rare.clipped_by.extend(clips);
                }
                self.close("clipped_by")?;
            }
            K::BoundedBy => {
                self.next()?;
                self.open("bounded_by")?;
                if self.accept(K::ClippedBy)? {
                    object.rare.bounded_by = object.rare.clipped_by.clone();
                    object.flags.bounds_are_clips = true;
                } else {
                    let bounds = self.clip_objects(span)?;
                    object.rare.bounded_by.extend(bounds);
                }
                self.close("bounded_by")?;
            }
            K::Photons => {
                self.next()?;
                object.rare.photons = self.photons_block(object.rare.photons)?;
            }
            K::Radiosity => {
                self.next()?;
                object.rare.radiosity_importance = Some(self.radiosity_importance()?);
            }
            K::Dtag => {
                self.next()?;
                self.string()?;
            }
            _ if self.at_color()? => {
                self.color()?;
                self.warn(Topic::Ignored, span, "a colour belongs into a pigment; here it has no effect");
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Objects with transformations for all of them, between the braces of a clip or bound.
    fn clip_objects(&mut self, span: Span) -> SourceResult<Vec<Arc<Object>>> {
        let mut objects = Vec::new();
        loop {
            if let Some(object) = self.object()? {
                if object.texture.is_some() || object.shape.is_patch() {
                    return self.error(span, "a clip or bound must be a solid without a texture");
                }
                objects.push(object);
            } else if let Some(transform) = self.transformation()? {
                for object in &mut objects {
                    Arc::make_mut(object).apply(&transform);
                }
            } else {
                break;
            }
            self.comma()?;
        }
        if objects.is_empty() {
            return self.expected("an object");
        }
        Ok(objects)
    }

    /// `{ … }` after `photons` of an object or light.
    pub(super) fn photons_block(&mut self, mut flags: PhotonFlags) -> SourceResult<PhotonFlags> {
        self.open("photons")?;
        while let Some(keyword) = self.keyword()? {
            match keyword {
                K::Target => {
                    self.next()?;
                    flags.target = Some(if self.starts_expression()? { self.float()? } else { 1.0 });
                }
                K::Refraction => {
                    self.next()?;
                    flags.refraction = Some(self.float()? > 0.0);
                }
                K::Reflection => {
                    self.next()?;
                    flags.reflection = Some(self.float()? > 0.0);
                }
                K::Collect => {
                    self.next()?;
                    flags.collect = Some(self.optional_bool()?);
                }
                K::PassThrough => {
                    self.next()?;
                    flags.pass_through = self.optional_bool()?;
                }
                K::AreaLight => {
                    self.next()?;
                    flags.area_light = self.optional_bool()?;
                }
                _ => break,
            }
            self.comma()?;
        }
        self.close("photons")?;
        Ok(flags)
    }

    /// `{ importance F }` after `radiosity`.
    pub(super) fn radiosity_importance(&mut self) -> SourceResult<f32> {
        self.open("radiosity")?;
        if !self.accept(K::Importance)? {
            return self.expected("'importance'");
        }
        let span = self.span();
        let importance = self.float()?;
        if !(importance > 0.0 && importance <= 1.0) {
            return self.error(span, "radiosity importance must be above 0 and at most 1");
        }
        self.close("radiosity")?;
        Ok(importance as f32)
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

pub(in crate::eval) fn is_object_keyword(keyword: K) -> bool {
    csg_operation(keyword).is_some()
        || matches!(
            keyword,
            K::BicubicPatch
                | K::Blob
                | K::Box
                | K::Cone
                | K::Cubic
                | K::Cylinder
                | K::Disc
                | K::HeightField
                | K::Isosurface
                | K::JuliaFractal
                | K::Lathe
                | K::LightGroup
                | K::LightSource
                | K::Mesh
                | K::Mesh2
                | K::Object
                | K::Ovus
                | K::Parametric
                | K::Plane
                | K::Poly
                | K::Polygon
                | K::Polynomial
                | K::Prism
                | K::Quadric
                | K::Quartic
                | K::SmoothTriangle
                | K::Sor
                | K::Sphere
                | K::SphereSweep
                | K::Superellipsoid
                | K::Text
                | K::Torus
                | K::Triangle
        )
}
