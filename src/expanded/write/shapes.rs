//! The parameters of every shape.

use super::number::{double, numbers, quoted, vector, vector2, vector4};
use super::pictures::file_name;
use super::writer::Writer;
use crate::scene::{
    BicubicPatch, Blob, BlobComponent, Container, HeightField, Isosurface, JuliaFractal, JuliaFunction, Parametric,
    Prism, Shape, SmoothTriangle, SweepSpline, Text,
};

impl Writer<'_> {
    /// What stands first in a shape's braces.
    pub(super) fn shape_parts(&mut self, shape: &Shape) {
        match shape {
            Shape::Csg { operation: _, children } => children.iter().for_each(|child| self.object(child)),
            Shape::LightGroup { children, global_lights } => {
                children.iter().for_each(|child| self.object(child));
                if *global_lights {
                    self.line("global_lights");
                }
            }
            Shape::LightSource(light) => self.light(light),
            Shape::Mesh(mesh) => self.mesh(mesh),
            Shape::HeightField(field) => self.height_field(field),
            Shape::Blob(blob) => self.blob(blob),
            Shape::Text(text) => self.text(text),
            Shape::Isosurface(surface) => self.isosurface(surface),
            Shape::Parametric(surface) => self.parametric(surface),
            Shape::JuliaFractal(julia) => self.line(julia_fractal(julia)),
            _ if self.counting => {}
            Shape::BicubicPatch(patch) => self.line(bicubic_patch(patch)),
            Shape::Prism(prism) => self.line(self::prism(prism)),
            _ => self.line(plain_shape(shape)),
        }
    }

    fn height_field(&mut self, field: &HeightField) {
        let HeightField { image, water_level, smooth } = field;
        self.image(image);
        if *water_level != f64::NEG_INFINITY {
            let scale = if self.settings.version < 200 { 256.0 } else { 1.0 };
            self.line(format_args!("water_level {}", double(water_level * scale)));
        }
        if *smooth {
            self.line("smooth");
        }
    }

    fn blob(&mut self, blob: &Blob) {
        let Blob { threshold, components, sturm } = blob;
        self.line(format_args!("threshold {}", double(*threshold)));
        for component in components {
            let BlobComponent { ends: [first, second], is_cylinder, radius, strength, transform, texture } = component;
            self.open(if *is_cylinder { "cylinder" } else { "sphere" });
            let end = if *is_cylinder { format!(", {}", vector(*second)) } else { String::new() };
            let (radius, strength) = (double(*radius), double(*strength));
            self.line(format_args!("{}{end}, {radius}, strength {strength}", vector(*first)));
            self.transform(transform);
            if let Some(texture) = texture {
                self.placed_texture("texture", texture);
            }
            self.close();
        }
        if *sturm {
            self.line("sturm");
        }
    }

    fn text(&mut self, text: &Text) {
        let Text { font: _, font_file, characters, unicode, thickness, offset } = text;
        self.unicode |= *unicode;
        let font = file_name(&(self.style.file_name)(font_file));
        let (thickness, offset) = (double(*thickness), vector(*offset));
        self.line(format_args!("ttf {font} {}, {thickness}, {offset}", quoted(characters)));
        if *unicode != self.unicode {
            self.note("ascii");
        }
    }

    fn isosurface(&mut self, surface: &Isosurface) {
        let Isosurface { function, container, threshold, accuracy, max_gradient, evaluate, max_trace, open, search: _ } =
            surface;
        self.plain_function(function, &["x", "y", "z"]);
        self.line(container_text(container));
        let (threshold, accuracy, gradient) = (double(*threshold), double(*accuracy), double(*max_gradient));
        self.line(format_args!("threshold {threshold} accuracy {accuracy} max_gradient {gradient}"));
        if let Some([a, b, c]) = evaluate {
            self.line(format_args!("evaluate {}, {}, {}", double(*a), double(*b), double(*c)));
        }
        if *max_trace != 1 {
            self.line(format_args!("max_trace {max_trace}"));
        }
        if *open {
            self.line("open");
        }
    }

    fn parametric(&mut self, surface: &Parametric) {
        let Parametric { functions, min, max, container, accuracy, max_gradient, precompute } = surface;
        functions.iter().for_each(|function| self.plain_function(function, &["u", "v"]));
        self.line(format_args!("{}, {}", vector2(*min), vector2(*max)));
        self.line(container_text(container));
        self.line(format_args!("accuracy {} max_gradient {}", double(*accuracy), double(*max_gradient)));
        if let Some((depth, axes)) = precompute {
            let axes: String = ["x", "y", "z"]
                .into_iter()
                .zip(axes)
                .filter(|(_, on)| **on)
                .map(|(axis, _)| format!(", {axis}"))
                .collect();
            self.line(format_args!("precompute {depth}{axes}"));
        }
    }
}

/// Shapes of a few numbers.
fn plain_shape(shape: &Shape) -> String {
    let when = |on: bool, word: &'static str| if on { word } else { "" };
    match shape {
        Shape::Sphere { center, radius } => format!("{}, {}", vector(*center), double(*radius)),
        Shape::Box { corner1, corner2 } => format!("{}, {}", vector(*corner1), vector(*corner2)),
        Shape::Cylinder { base, cap, radius, open } => {
            format!("{}, {}, {}{}", vector(*base), vector(*cap), double(*radius), when(*open, " open"))
        }
        Shape::Cone { base, base_radius, cap, cap_radius, open } => {
            let (base, cap) = (vector(*base), vector(*cap));
            format!("{base}, {}, {cap}, {}{}", double(*base_radius), double(*cap_radius), when(*open, " open"))
        }
        Shape::Plane { normal, distance } => format!("{}, {}", vector(*normal), double(*distance)),
        Shape::Disc { center, normal, radius, hole_radius } => {
            format!("{}, {}, {}, {}", vector(*center), vector(*normal), double(*radius), double(*hole_radius))
        }
        Shape::Torus { major, minor, sturm } => {
            format!("{}, {}{}", double(*major), double(*minor), when(*sturm, " sturm"))
        }
        Shape::Ovus { bottom_radius, top_radius, sturm } => {
            format!("{}, {}{}", double(*bottom_radius), double(*top_radius), when(*sturm, " sturm"))
        }
        Shape::Quadric { squares, products, linear, constant } => {
            format!("{}, {}, {}, {}", vector(*squares), vector(*products), vector(*linear), double(*constant))
        }
        Shape::Polynomial { order, coefficients, sturm } => {
            format!("{order}, {}{}", numbers(coefficients), when(*sturm, " sturm"))
        }
        Shape::Superellipsoid { east_west, north_south } => numbers(&[*east_west, *north_south]),
        Shape::Polygon { points } => {
            format!("{}, {}", points.len(), joined(points.iter().map(|p| vector(*p))))
        }
        Shape::Triangle { vertices } => joined(vertices.iter().map(|v| vector(*v))),
        Shape::SmoothTriangle(triangle) => {
            let SmoothTriangle { vertices, normals } = &**triangle;
            joined(vertices.iter().zip(normals).flat_map(|(v, n)| [vector(*v), vector(*n)]))
        }
        Shape::Lathe { spline, points, sturm } => {
            let list = joined(points.iter().map(|p| vector2(*p)));
            format!("{} {}, {list}{}", spline_word(*spline), points.len(), when(*sturm, " sturm"))
        }
        Shape::Sor { points, open, sturm } => {
            let list = joined(points.iter().map(|p| vector2(*p)));
            format!("{}, {list}{}{}", points.len(), when(*open, " open"), when(*sturm, " sturm"))
        }
        Shape::SphereSweep { spline, spheres, tolerance } => {
            let list =
                joined(spheres.iter().map(|(center, radius)| format!("{}, {}", vector(*center), double(*radius))));
            format!("{} {}, {list} tolerance {}", spline_word(*spline), spheres.len(), double(*tolerance))
        }
        Shape::Csg { .. } | Shape::LightGroup { .. } | Shape::LightSource(_) | Shape::Mesh(_) => String::new(),
        Shape::HeightField(_) | Shape::Blob(_) | Shape::BicubicPatch(_) | Shape::Prism(_) => String::new(),
        Shape::Text(_) | Shape::Isosurface(_) | Shape::Parametric(_) | Shape::JuliaFractal(_) => String::new(),
    }
}

fn joined(items: impl Iterator<Item = String>) -> String {
    items.collect::<Vec<_>>().join(", ")
}

fn spline_word(spline: SweepSpline) -> &'static str {
    match spline {
        SweepSpline::Linear => "linear_spline",
        SweepSpline::Quadratic => "quadratic_spline",
        SweepSpline::Cubic => "cubic_spline",
        SweepSpline::Bezier => "bezier_spline",
        SweepSpline::B => "b_spline",
    }
}

fn bicubic_patch(patch: &BicubicPatch) -> String {
    let BicubicPatch { points, uv_corners, flatness, u_steps, v_steps } = patch;
    let points = joined(points.iter().flatten().map(|p| vector(*p)));
    let corners = joined(uv_corners.iter().map(|p| vector2(*p)));
    format!("type 1 flatness {} u_steps {u_steps} v_steps {v_steps} uv_vectors {corners} {points}", double(*flatness))
}

fn prism(prism: &Prism) -> String {
    let Prism { spline, conic, heights: [low, high], points, open, sturm } = prism;
    let sweep = if *conic { "conic_sweep" } else { "linear_sweep" };
    let list = joined(points.iter().map(|p| vector2(*p)));
    let words = [(*open, " open"), (*sturm, " sturm")].map(|(on, word)| if on { word } else { "" }).concat();
    let heights = format!("{}, {}", double(*low), double(*high));
    format!("{} {sweep} {heights}, {}, {list}{words}", spline_word(*spline), points.len())
}

fn container_text(container: &Container) -> String {
    match container {
        Container::Box { min, max } => format!("contained_by {{ box {{ {}, {} }} }}", vector(*min), vector(*max)),
        Container::Sphere { center, radius } => {
            format!("contained_by {{ sphere {{ {}, {} }} }}", vector(*center), double(*radius))
        }
    }
}

fn julia_fractal(julia: &JuliaFractal) -> String {
    let JuliaFractal { parameter, hypercomplex, function, max_iteration, precision, slice_normal, slice_distance } =
        julia;
    let algebra = if *hypercomplex { "hypercomplex" } else { "quaternion" };
    let function = match function {
        JuliaFunction::Sqr => "sqr".to_owned(),
        JuliaFunction::Cube => "cube".to_owned(),
        JuliaFunction::Exp => "exp".to_owned(),
        JuliaFunction::Ln => "ln".to_owned(),
        JuliaFunction::Sin => "sin".to_owned(),
        JuliaFunction::Asin => "asin".to_owned(),
        JuliaFunction::Cos => "cos".to_owned(),
        JuliaFunction::Acos => "acos".to_owned(),
        JuliaFunction::Tan => "tan".to_owned(),
        JuliaFunction::Atan => "atan".to_owned(),
        JuliaFunction::Sinh => "sinh".to_owned(),
        JuliaFunction::Asinh => "asinh".to_owned(),
        JuliaFunction::Cosh => "cosh".to_owned(),
        JuliaFunction::Acosh => "acosh".to_owned(),
        JuliaFunction::Tanh => "tanh".to_owned(),
        JuliaFunction::Atanh => "atanh".to_owned(),
        JuliaFunction::Reciprocal => "reciprocal".to_owned(),
        JuliaFunction::Pwr(a, b) => format!("pwr({}, {})", double(*a), double(*b)),
    };
    let slice = format!("slice {}, {}", vector4(*slice_normal), double(*slice_distance));
    let precision = double(*precision);
    let parameter = vector4(*parameter);
    format!("{parameter} {algebra} {function} max_iteration {max_iteration} precision {precision} {slice}")
}
