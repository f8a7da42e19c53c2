//! What identifiers, parameters and array elements hold.

use super::blocks;
use crate::function::Spline;
use crate::math::{Color, DVec3, Transform};
use crate::scene::{self, Function, MapEntry};
use crate::syntax::formula::MacroResult;
use crate::syntax::{Position, Source, Symbol};
use std::cell::{Cell, OnceCell};
use std::rc::Rc;
use std::sync::Arc;

/// A number with one to five components.
///
/// Components past `n` are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    /// How many components count.
    pub n: u8,
    /// The components.
    pub v: [f64; 5],
}

impl Number {
    /// One component.
    pub const fn scalar(value: f64) -> Self {
        Self { n: 1, v: [value, 0.0, 0.0, 0.0, 0.0] }
    }

    /// Three components.
    pub const fn vector(v: DVec3) -> Self {
        Self { n: 3, v: [v.x, v.y, v.z, 0.0, 0.0] }
    }

    /// The first components as a vector.
    pub const fn xyz(&self) -> DVec3 {
        DVec3::new(self.v[0], self.v[1], self.v[2])
    }

    /// At least `n` components: one is replicated, more are filled up with zeros.
    #[must_use]
    #[inline]
    pub fn widened(mut self, n: u8) -> Self {
        if self.n < n {
            if self.n == 1 {
                let first = self.v[0];
                self.v[1..n as usize].fill(first);
            }
            self.n = n;
        }
        self
    }
}

/// A value of the language. Cheap to clone: everything large is shared and copied on write.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum Value {
    Float(f64),
    /// Two to five components; five are a colour, rounded to single precision when stored.
    Vector(Number),
    String(Rc<str>),
    Array(Rc<Array>),
    Function(Arc<Function>),
    Spline(Arc<Spline>),
    Transform(Rc<Transform>),
    Object(Arc<scene::Object>),
    Camera(Arc<blocks::CameraStatement>),
    Texture(Arc<scene::Texture>),
    Pigment(Arc<scene::Pigment>),
    Normal(Arc<scene::Normal>),
    Finish(Arc<scene::Finish>),
    Interior(Arc<scene::Interior>),
    Material(Arc<blocks::Material>),
    Media(Arc<scene::Media>),
    Density(Arc<scene::Density>),
    Fog(Arc<scene::Fog>),
    Rainbow(Arc<scene::Rainbow>),
    SkySphere(Arc<scene::SkySphere>),
    ColorMap(Rc<Vec<MapEntry<Color>>>),
    PigmentMap(Rc<Vec<MapEntry<Arc<scene::Pigment>>>>),
    NormalMap(Rc<Vec<MapEntry<Arc<scene::Normal>>>>),
    TextureMap(Rc<Vec<MapEntry<Arc<scene::Texture>>>>),
    SlopeMap(Rc<Vec<MapEntry<[f32; 2]>>>),
    DensityMap(Rc<Vec<MapEntry<Arc<scene::Density>>>>),
    /// An open file, by its number.
    File(usize),
    Macro(Rc<Macro>),
}

impl Value {
    /// What a message calls it.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Float(_) => "float",
            Self::Vector(Number { n: 5, .. }) => "colour",
            Self::Vector(_) => "vector",
            Self::String(_) => "string",
            Self::Array(_) => "array",
            Self::Function(_) => "function",
            Self::Spline(_) => "spline",
            Self::Transform(_) => "transform",
            Self::Object(_) => "object",
            Self::Camera(_) => "camera",
            Self::Texture(_) => "texture",
            Self::Pigment(_) => "pigment",
            Self::Normal(_) => "normal",
            Self::Finish(_) => "finish",
            Self::Interior(_) => "interior",
            Self::Material(_) => "material",
            Self::Media(_) => "media",
            Self::Density(_) => "density",
            Self::Fog(_) => "fog",
            Self::Rainbow(_) => "rainbow",
            Self::SkySphere(_) => "sky_sphere",
            Self::ColorMap(_) => "color_map",
            Self::PigmentMap(_) => "pigment_map",
            Self::NormalMap(_) => "normal_map",
            Self::TextureMap(_) => "texture_map",
            Self::SlopeMap(_) => "slope_map",
            Self::DensityMap(_) => "density_map",
            Self::File(_) => "file handle",
            Self::Macro(_) => "macro",
        }
    }

    /// The number, if it is one.
    pub fn number(&self) -> Option<Number> {
        match self {
            Self::Float(f) => Some(Number::scalar(*f)),
            Self::Vector(v) => Some(*v),
            _ => None,
        }
    }
}

impl From<Number> for Value {
    /// Colours lose precision here, as in POV-Ray: five components are stored as `f32`.
    fn from(number: Number) -> Self {
        match number.n {
            1 => Self::Float(number.v[0]),
            5 => Self::Vector(Number { n: 5, v: number.v.map(|c| f64::from(c as f32)) }),
            _ => Self::Vector(number),
        }
    }
}

/// An array of up to five dimensions; an element may be unset.
#[derive(Clone, Debug)]
pub struct Array {
    /// Sizes, outermost first.
    pub dimensions: Vec<usize>,
    /// Elements, the last index running fastest.
    pub elements: Vec<Option<Value>>,
    /// Where an element was set when last looked for.
    set: Cell<usize>,
}

impl Array {
    /// Of these sizes; the elements are theirs, or are still to come.
    pub fn new(dimensions: Vec<usize>, elements: Vec<Option<Value>>) -> Self {
        Self { dimensions, elements, set: Cell::new(0) }
    }

    /// Any element that is set, looked for in nested arrays too: all are of one type.
    #[inline]
    pub fn sample(&self) -> Option<&Value> {
        match self.any()? {
            Value::Array(inner) => inner.sample(),
            value => Some(value),
        }
    }

    /// Any element that is set.
    #[inline]
    pub fn any(&self) -> Option<&Value> {
        match self.elements.get(self.set.get()) {
            Some(Some(value)) => Some(value),
            _ => {
                self.set.set(self.elements.iter().position(Option::is_some)?);
                self.elements[self.set.get()].as_ref()
            }
        }
    }
}

/// A macro: its parameters and where its body stands.
#[derive(Debug)]
pub struct Macro {
    /// What it is called.
    pub name: Symbol,
    /// Names of the parameters.
    pub parameters: Vec<Symbol>,
    /// The file that holds the body.
    pub source: Rc<Source>,
    /// First token of the body.
    pub start: Position,
    /// The `#end` behind it.
    pub end: Position,
    /// The expression it ends in, if its body is made so; known from the first call on.
    pub result: OnceCell<Option<MacroResult>>,
}
