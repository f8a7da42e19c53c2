//! Shapes as a scene file gives them, each in its own space.

use super::{Function, Image, LightSource, Object, PlacedTexture, Texture};
use crate::math::{DVec2, DVec3, DVec4, Transform};
use std::path::PathBuf;
use std::sync::Arc;

/// Every geometric primitive of the language, and what groups them.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // fields carry the manual's names
pub enum Shape {
    Sphere {
        center: DVec3,
        radius: f64,
    },
    Box {
        corner1: DVec3,
        corner2: DVec3,
    },
    Cylinder {
        base: DVec3,
        cap: DVec3,
        radius: f64,
        open: bool,
    },
    Cone {
        base: DVec3,
        base_radius: f64,
        cap: DVec3,
        cap_radius: f64,
        open: bool,
    },
    Plane {
        normal: DVec3,
        distance: f64,
    },
    Disc {
        center: DVec3,
        normal: DVec3,
        radius: f64,
        hole_radius: f64,
    },
    Torus {
        major: f64,
        minor: f64,
        sturm: bool,
    },
    Ovus {
        bottom_radius: f64,
        top_radius: f64,
        sturm: bool,
    },
    Quadric {
        squares: DVec3,
        products: DVec3,
        linear: DVec3,
        constant: f64,
    },
    /// `cubic`, `quartic`, `poly`, `polynomial`: coefficients in POV-Ray's order,
    /// x^i y^j z^k with i, then j, then k falling.
    Polynomial {
        order: u32,
        coefficients: Arc<[f64]>,
        sturm: bool,
    },
    Superellipsoid {
        east_west: f64,
        north_south: f64,
    },
    Polygon {
        points: Arc<[DVec3]>,
    },
    Triangle {
        vertices: [DVec3; 3],
    },
    SmoothTriangle(Box<SmoothTriangle>),
    Mesh(Arc<Mesh>),
    HeightField(Arc<HeightField>),
    Blob(Arc<Blob>),
    BicubicPatch(Arc<BicubicPatch>),
    Prism(Arc<Prism>),
    Lathe {
        spline: SweepSpline,
        points: Arc<[DVec2]>,
        sturm: bool,
    },
    Sor {
        points: Arc<[DVec2]>,
        open: bool,
        sturm: bool,
    },
    SphereSweep {
        spline: SweepSpline,
        spheres: Arc<[(DVec3, f64)]>,
        tolerance: f64,
    },
    Text(Arc<Text>),
    Isosurface(Arc<Isosurface>),
    Parametric(Arc<Parametric>),
    JuliaFractal(Arc<JuliaFractal>),
    /// `union`, `merge`, `intersection`, `difference` of at least nothing.
    Csg {
        operation: CsgOperation,
        children: Arc<[Arc<Object>]>,
    },
    /// An invisible point, or the object that `looks_like` gives.
    LightSource(Arc<LightSource>),
    LightGroup {
        children: Arc<[Arc<Object>]>,
        global_lights: bool,
    },
}

/// A triangle whose normals are interpolated.
#[derive(Clone, Copy, Debug)]
pub struct SmoothTriangle {
    /// Corners.
    pub vertices: [DVec3; 3],
    /// Normals there, any length.
    pub normals: [DVec3; 3],
}

impl Shape {
    /// Whether it, or a part of it, has no inside.
    pub fn is_patch(&self) -> bool {
        match self {
            Self::Triangle { .. } | Self::SmoothTriangle(_) | Self::BicubicPatch(_) | Self::Parametric(_) => true,
            Self::Mesh(mesh) => mesh.inside_vector.is_none(),
            Self::LightSource(_) => true,
            Self::Csg { children, .. } => children.iter().any(|child| child.is_patch),
            _ => false,
        }
    }

    /// The word for this kind of shape.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Box { .. } => "box",
            Self::Cylinder { .. } => "cylinder",
            Self::Cone { .. } => "cone",
            Self::Plane { .. } => "plane",
            Self::Disc { .. } => "disc",
            Self::Torus { .. } => "torus",
            Self::Ovus { .. } => "ovus",
            Self::Quadric { .. } => "quadric",
            Self::Polynomial { .. } => "poly",
            Self::Superellipsoid { .. } => "superellipsoid",
            Self::Polygon { .. } => "polygon",
            Self::Triangle { .. } => "triangle",
            Self::SmoothTriangle { .. } => "smooth_triangle",
            Self::Mesh(_) => "mesh",
            Self::HeightField(_) => "height_field",
            Self::Blob(_) => "blob",
            Self::BicubicPatch(_) => "bicubic_patch",
            Self::Prism(_) => "prism",
            Self::Lathe { .. } => "lathe",
            Self::Sor { .. } => "sor",
            Self::SphereSweep { .. } => "sphere_sweep",
            Self::Text(_) => "text",
            Self::Isosurface(_) => "isosurface",
            Self::Parametric(_) => "parametric",
            Self::JuliaFractal(_) => "julia_fractal",
            Self::Csg { operation, .. } => match operation {
                CsgOperation::Union => "union",
                CsgOperation::Intersection => "intersection",
                CsgOperation::Difference => "difference",
                CsgOperation::Merge => "merge",
            },
            Self::LightSource(_) => "light_source",
            Self::LightGroup { .. } => "light_group",
        }
    }

    /// Whether no other object can be in it.
    pub fn is_single(&self) -> bool {
        !matches!(self, Self::Csg { .. } | Self::LightGroup { .. } | Self::LightSource(_))
    }

    /// The objects that a group is made of; none for anything else.
    pub fn children(&self) -> &[Arc<Object>] {
        match self {
            Self::Csg { children, .. } | Self::LightGroup { children, .. } => children,
            _ => &[],
        }
    }
}

/// How the children of a CSG object combine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CsgOperation {
    /// All surfaces of all children.
    Union,
    /// Surfaces that are inside no other child.
    Merge,
    /// Surfaces that are inside every other child.
    Intersection,
    /// The first child less all others.
    Difference,
}

/// `mesh` or `mesh2`; every index is in range.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Corner points, rounded to single precision by nobody yet.
    pub vertices: Vec<[f32; 3]>,
    /// Unit vertex normals.
    pub normals: Vec<[f32; 3]>,
    /// uv coordinates.
    pub uvs: Vec<DVec2>,
    /// Three vertex indices a face.
    pub faces: Vec<[u32; 3]>,
    /// Three normal indices a face; shorter than `faces` where the rest is flat.
    pub normal_indices: Vec<[u32; 3]>,
    /// Three uv indices a face; empty where no uv was given.
    pub uv_indices: Vec<[u32; 3]>,
    /// Textures that faces refer to.
    pub textures: Vec<Arc<Texture>>,
    /// One, or three different, textures a face; empty where none has one.
    pub face_textures: Vec<Option<[u32; 3]>>,
    /// Direction of the inside test; without it a mesh is a patch.
    pub inside_vector: Option<DVec3>,
    /// Written as `mesh2`: face planes come from the rounded vertices.
    pub is_mesh2: bool,
}

/// Heights over a grid in the unit square of x and z.
#[derive(Clone, Debug)]
pub struct HeightField {
    /// Where heights come from.
    pub image: Image,
    /// Everything below is cut away, in object units of y.
    pub water_level: f64,
    /// Interpolated normals.
    pub smooth: bool,
}

/// A sum of soft spheres and cylinders.
#[derive(Clone, Debug)]
pub struct Blob {
    /// Field value on the surface.
    pub threshold: f64,
    /// The parts.
    pub components: Vec<BlobComponent>,
    /// Use the Sturm solver.
    pub sturm: bool,
}

/// One part of a blob.
#[derive(Clone, Debug)]
pub struct BlobComponent {
    /// A point, or a segment for cylinders.
    pub ends: [DVec3; 2],
    /// Whether it is a cylinder.
    pub is_cylinder: bool,
    /// Radius of influence.
    pub radius: f64,
    /// Field at the centre.
    pub strength: f64,
    /// Takes the component's space to the blob's.
    pub transform: Transform,
    /// Its own texture.
    pub texture: Option<PlacedTexture>,
}

/// A Bézier patch with the tessellation parameters of the scene file.
#[derive(Clone, Debug)]
pub struct BicubicPatch {
    /// Control points, rows as listed.
    pub points: [[DVec3; 4]; 4],
    /// Corner uv coordinates, at P00, P03, P33, P30.
    pub uv_corners: [DVec2; 4],
    /// Distance from flat, in world units, at which subdivision stops.
    pub flatness: f64,
    /// Most halvings in u.
    pub u_steps: u32,
    /// Most halvings in v.
    pub v_steps: u32,
}

/// Curve families of prism, lathe and sphere_sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum SweepSpline {
    Linear,
    Quadratic,
    Cubic,
    Bezier,
    B,
}

/// An outline swept along y.
#[derive(Clone, Debug)]
pub struct Prism {
    /// Curve family of the outline.
    pub spline: SweepSpline,
    /// Tapers to a point at the origin instead of keeping its size.
    pub conic: bool,
    /// Lower and upper y.
    pub heights: [f64; 2],
    /// Outline points (x, z) as listed, with all sub-shapes.
    pub points: Vec<DVec2>,
    /// Without caps.
    pub open: bool,
    /// Use the Sturm solver.
    pub sturm: bool,
}

/// A line of TrueType text.
#[derive(Clone, Debug)]
pub struct Text {
    /// The font file's bytes.
    pub font: Arc<Vec<u8>>,
    /// Where they are from.
    pub font_file: PathBuf,
    /// Character codes.
    pub characters: Vec<u16>,
    /// Whether `charset` asks for Unicode lookup.
    pub unicode: bool,
    /// Extent along z.
    pub thickness: f64,
    /// Added to the pen after each glyph.
    pub offset: DVec3,
}

/// Where an isosurface or parametric surface is looked for.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs)]
pub enum Container {
    Box { min: DVec3, max: DVec3 },
    Sphere { center: DVec3, radius: f64 },
}

/// The surface where a function takes a value.
#[derive(Clone, Debug)]
pub struct Isosurface {
    /// f(x, y, z).
    pub function: Arc<Function>,
    /// Region searched.
    pub container: Container,
    /// The value.
    pub threshold: f64,
    /// Interval length at which POV-Ray stops.
    pub accuracy: f64,
    /// POV-Ray's bound of the slope.
    pub max_gradient: f64,
    /// `evaluate` parameters.
    pub evaluate: Option<[f64; 3]>,
    /// Hits per ray.
    pub max_trace: u32,
    /// Not capped by the container.
    pub open: bool,
    /// How the surface is looked for.
    pub search: IsosurfaceSearch,
}

impl Isosurface {
    /// As POV-Ray has it where nothing but the function is said.
    pub fn new(function: Arc<Function>, search: IsosurfaceSearch) -> Self {
        Self {
            function,
            container: Container::Box { min: DVec3::NEG_ONE, max: DVec3::ONE },
            threshold: 0.0,
            accuracy: 0.001,
            max_gradient: 1.1,
            evaluate: None,
            max_trace: 1,
            open: false,
            search,
        }
    }
}

/// What a search for an isosurface may leave out. The caller's choice, not the file's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum IsosurfaceSearch {
    /// What bounds of the function rule out, as far as they are known.
    #[default]
    Guaranteed,
    /// What `max_gradient` rules out, true or not.
    PovRay,
}

/// A surface given by three functions of (u, v).
#[derive(Clone, Debug)]
pub struct Parametric {
    /// x, y and z.
    pub functions: [Arc<Function>; 3],
    /// Lower (u, v).
    pub min: DVec2,
    /// Upper (u, v).
    pub max: DVec2,
    /// Region shown.
    pub container: Container,
    /// Size at which POV-Ray stops.
    pub accuracy: f64,
    /// POV-Ray's bound of the slope.
    pub max_gradient: f64,
    /// `precompute` depth and axes.
    pub precompute: Option<(u32, [bool; 3])>,
}

/// A slice through a four-dimensional Julia set.
#[derive(Clone, Debug)]
pub struct JuliaFractal {
    /// The constant c.
    pub parameter: DVec4,
    /// Hypercomplex instead of quaternion algebra.
    pub hypercomplex: bool,
    /// Iterated function.
    pub function: JuliaFunction,
    /// Most iterations.
    pub max_iteration: u32,
    /// Inverse of the smallest step.
    pub precision: f64,
    /// Normal of the slicing hyperplane.
    pub slice_normal: DVec4,
    /// Distance of the slicing hyperplane.
    pub slice_distance: f64,
}

/// What a Julia fractal iterates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum JuliaFunction {
    Sqr,
    Cube,
    Exp,
    Ln,
    Sin,
    Asin,
    Cos,
    Acos,
    Tan,
    Atan,
    Sinh,
    Asinh,
    Cosh,
    Acosh,
    Tanh,
    Atanh,
    Reciprocal,
    Pwr(f64, f64),
}
