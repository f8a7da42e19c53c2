//! Objects: a shape, where it stands, what it looks like.

use super::{CsgOperation, Interior, PointFunction, Shape, Texture};
use crate::diag::{Diagnostic, Span};
use crate::function::Caller;
use crate::math::{Bounds, Transform};
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// One object statement with all its modifiers.
#[derive(Clone, Debug)]
pub struct Object {
    /// Geometry in its own space; for CSG, the children.
    pub shape: Shape,
    /// Takes the shape's space to the space of the containing object or the world.
    pub place: Place,
    /// The texture, if the object has one of its own.
    pub texture: Option<PlacedTexture>,
    /// `interior`, if the object has one of its own.
    pub interior: Option<Arc<Interior>>,
    /// What few objects have.
    pub rare: Rare,
    /// On/off modifiers.
    pub flags: Flags,
    /// Where the statement stands, for messages and object ids.
    pub span: Span,
    /// The identifier the object was declared under, for object layers.
    pub name: Option<Arc<str>>,
    /// Levels of objects, textures and pigments inside one another, down from this one; noted once it is complete.
    pub depth: u32,
    /// As [`Shape::is_patch`], noted at the start: asking all levels below at each level takes the square of their number.
    pub is_patch: bool,
}

/// What few objects have; takes up no room in all others, where it reads as nothing said.
#[derive(Clone, Debug, Default)]
pub struct Rare(Option<Box<RareParts>>);

/// The parts of [`Rare`].
#[derive(Clone, Debug, Default)]
pub struct RareParts {
    /// What the inside of the surface looks like, if that differs.
    pub interior_texture: Option<PlacedTexture>,
    /// `clipped_by` objects, in the containing space.
    pub clipped_by: Vec<Arc<Object>>,
    /// `bounded_by` objects, in the containing space.
    pub bounded_by: Vec<Arc<Object>>,
    /// `photons`.
    pub photons: PhotonFlags,
    /// `radiosity { importance }`.
    pub radiosity_importance: Option<f32>,
}

impl Deref for Rare {
    type Target = RareParts;

    fn deref(&self) -> &RareParts {
        static NOTHING: RareParts = RareParts {
            interior_texture: None,
            clipped_by: Vec::new(),
            bounded_by: Vec::new(),
            photons: PhotonFlags::NONE,
            radiosity_importance: None,
        };
        self.0.as_deref().unwrap_or(&NOTHING)
    }
}

impl DerefMut for Rare {
    fn deref_mut(&mut self) -> &mut RareParts {
        self.0.get_or_insert_default()
    }
}

impl Rare {
    /// The parts, if there are any.
    pub fn parts_mut(&mut self) -> Option<&mut RareParts> {
        self.0.as_deref_mut()
    }
}

/// A texture and where it was put.
#[derive(Clone, Debug)]
pub struct PlacedTexture {
    /// The texture itself, shared.
    pub texture: Arc<Texture>,
    /// Takes texture space to the space that contains the textured object.
    pub place: Place,
}

/// A transform that takes up no room while it leaves everything where it is, as most do.
#[derive(Clone, Debug, Default)]
pub struct Place(Option<Box<Transform>>);

impl Place {
    /// Moves what stands here.
    pub fn apply(&mut self, transform: &Transform) {
        match &mut self.0 {
            Some(place) => **place = place.then(transform),
            None => self.0 = Some(Box::new(*transform)),
        }
    }

    /// Takes what stands here to where it stands.
    pub fn transform(&self) -> Transform {
        self.0.as_deref().copied().unwrap_or_default()
    }

    /// First to this place, then wherever `next` takes it.
    pub fn then(&self, next: &Transform) -> Transform {
        self.0.as_deref().map_or(*next, |place| place.then(next))
    }

    /// Whether nothing was ever moved.
    pub fn is_identity(&self) -> bool {
        self.0.is_none()
    }
}

impl PlacedTexture {
    /// In place, unmoved.
    pub fn new(texture: Arc<Texture>) -> Self {
        Self { texture, place: Place::default() }
    }
}

/// On/off modifiers of an object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Flags {
    /// `inverse`, toggled by each occurrence.
    pub inverse: bool,
    /// `inverse` occurred, perhaps more than once: unions turned there and back are merges.
    pub turned: bool,
    /// `hollow`; `None` where the object does not say.
    pub hollow: Option<bool>,
    /// Casts no shadow.
    pub no_shadow: bool,
    /// Not seen by camera rays.
    pub no_image: bool,
    /// Not seen by reflected rays.
    pub no_reflection: bool,
    /// Not seen by radiosity rays.
    pub no_radiosity: bool,
    /// Both sides are lit; `None` where the object does not say.
    pub double_illuminate: Option<bool>,
    /// Cut faces take the texture of what was cut.
    pub cutaway_textures: bool,
    /// Textures are looked up at (u, v, 0).
    pub uv_mapping: bool,
    /// `hierarchy off`.
    pub no_hierarchy: bool,
    /// `split_union off`.
    pub keep_union: bool,
    /// `bounded_by { clipped_by }` or `clipped_by { bounded_by }`: one list serves as both.
    pub bounds_are_clips: bool,
}

/// `photons { … }` of an object or a light; `None` is "not said".
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PhotonFlags {
    /// Spacing multiplier of a target.
    pub target: Option<f64>,
    /// Refracting photons.
    pub refraction: Option<bool>,
    /// Reflecting photons.
    pub reflection: Option<bool>,
    /// Photons are stored.
    pub collect: Option<bool>,
    /// Photons pass through.
    pub pass_through: bool,
    /// Lights: area light samples shoot.
    pub area_light: bool,
}

impl PhotonFlags {
    /// Nothing said.
    pub const NONE: Self = Self {
        target: None,
        refraction: None,
        reflection: None,
        collect: None,
        pass_through: false,
        area_light: false,
    };
}

impl Object {
    /// Whether it is a union that nothing holds together, so that its parts may stand alone.
    pub fn splits(&self) -> bool {
        matches!(self.shape, Shape::Csg { operation: CsgOperation::Union, .. })
            && !self.flags.keep_union
            && !self.flags.turned
            && self.rare.clipped_by.is_empty()
            && self.rare.bounded_by.is_empty()
    }

    /// A bare shape in its own place.
    pub fn new(shape: Shape, span: Span) -> Self {
        Self {
            is_patch: shape.is_patch(),
            shape,
            place: Place::default(),
            texture: None,
            interior: None,
            rare: Rare::default(),
            flags: Flags::default(),
            span,
            name: None,
            depth: 0,
        }
    }

    /// What [`depth`](Self::depth) is to be, from the parts.
    pub fn depth_of_parts(&self) -> u32 {
        // This is asked of each object that is read, and most have nothing in them.
        if self.texture.is_none() && self.rare.0.is_none() && self.shape.is_single() {
            return 0;
        }
        let mut depth = 0;
        let mut around = |part: u32| depth = depth.max(part + 1);
        for objects in [self.shape.children(), &self.rare.clipped_by, &self.rare.bounded_by] {
            objects.iter().for_each(|object| around(object.depth));
        }
        if let Shape::LightSource(light) = &self.shape
            && let Some(looks) = &light.looks_like
        {
            around(looks.depth);
        }
        for placed in [&self.texture, &self.rare.interior_texture].into_iter().flatten() {
            around(placed.texture.depth());
        }
        depth
    }

    /// Moves the object with everything it has so far: shape, textures, clips, bounds, interior.
    ///
    /// Under `uv_mapping` textures stay, as in POV-Ray.
    pub fn apply(&mut self, transform: &Transform) {
        self.place.apply(transform);
        let moves = !self.flags.uv_mapping;
        let textured = |placed: &mut Option<PlacedTexture>| {
            if let Some(placed) = placed.as_mut().filter(|_| moves) {
                placed.place.apply(transform);
            }
        };
        textured(&mut self.texture);
        if let Some(rare) = self.rare.parts_mut() {
            textured(&mut rare.interior_texture);
            for other in rare.clipped_by.iter_mut().chain(&mut rare.bounded_by) {
                Arc::make_mut(other).apply(transform);
            }
        }
        if let Some(interior) = &mut self.interior {
            Arc::make_mut(interior).apply(transform);
        }
        if let Shape::LightSource(light) = &mut self.shape {
            Arc::make_mut(light).apply(transform);
        }
    }
}

/// What the language may ask about objects while a scene is being read (`trace`, `inside`,
/// `min_extent`, calls of pigments and patterns), answered by the compiled scene behind this interface.
pub trait GeometryQueries: Caller<PointFunction> {
    /// Nearest hit of a ray with unit direction: the point and the unit raw normal.
    fn trace(&self, object: &Arc<Object>, ray: &crate::math::Ray) -> Option<(crate::math::DVec3, crate::math::DVec3)>;
    /// Whether the point is inside; `None` for patches, which have no inside.
    fn inside(&self, object: &Arc<Object>, point: crate::math::DVec3) -> Option<bool>;
    /// The bounding box.
    fn extent(&self, object: &Arc<Object>) -> Bounds;
    /// Whether a pigment or pattern can be called: only then it [is](Caller::call).
    ///
    /// # Errors
    /// What is wrong with it, with a place if one is known.
    fn check(&self, function: &Arc<PointFunction>) -> Result<(), Diagnostic>;
    /// Pixels across and down of the picture a pigment shows, if it shows one.
    fn image_size(&self, _pigment: &Arc<super::Pigment>) -> Option<[u32; 2]> {
        None
    }
}
