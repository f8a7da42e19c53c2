//! The parameters of every shape.

use super::reader::{Reader, misplaced};
use super::tree::{Items, Node, Read, Rule, components, file_name, numbers, wrong};
use crate::math::{DVec2, DVec3, DVec4, Transform, unit};
use crate::scene::{
    BicubicPatch, Blob, BlobComponent, Container, HeightField, Isosurface, JuliaFractal, JuliaFunction, Parametric,
    Prism, Shape, SmoothTriangle, SweepSpline, Text,
};
use std::sync::Arc;

/// POV-Ray's highest order of a polynomial.
const MAX_ORDER: u32 = 35;

impl<'a> Reader<'a> {
    /// The shape that a node is, without its modifiers.
    pub(super) fn shape(&mut self, node: &Node<'a>, items: &mut Items<'a>) -> Read<Shape> {
        Ok(match node.as_rule() {
            Rule::sphere => Shape::Sphere { center: items.vector()?, radius: items.number()? },
            Rule::cube => Shape::Box { corner1: items.vector()?, corner2: items.vector()? },
            Rule::cylinder => cylinder(node, items)?,
            Rule::cone => cone(node, items)?,
            Rule::plane => plane(node, items)?,
            Rule::disc => Shape::Disc {
                center: items.vector()?,
                normal: items.vector()?,
                radius: items.number()?,
                hole_radius: items.number()?,
            },
            Rule::torus => {
                Shape::Torus { major: items.number()?, minor: items.number()?, sturm: items.accept(Rule::sturm) }
            }
            Rule::ovus => {
                let (bottom_radius, top_radius) = (items.number()?, items.number()?);
                if bottom_radius < 0.0 || top_radius < 0.0 || top_radius >= 2.0 * bottom_radius {
                    return wrong(
                        node,
                        "an ovus needs radii that are not negative, the top less than twice the bottom",
                    );
                }
                Shape::Ovus { bottom_radius, top_radius, sturm: items.accept(Rule::sturm) }
            }
            Rule::quadric => Shape::Quadric {
                squares: items.vector()?,
                products: items.vector()?,
                linear: items.vector()?,
                constant: items.number()?,
            },
            Rule::polynomial => polynomial(items)?,
            Rule::superellipsoid => {
                let e = items.vector2()?;
                Shape::Superellipsoid { east_west: e.x, north_south: e.y }
            }
            Rule::polygon => {
                let points: Vec<DVec3> = points(items.node()?, 3)?.into_iter().map(DVec3::from).collect();
                Shape::Polygon { points: points.into() }
            }
            Rule::triangle => Shape::Triangle { vertices: [items.vector()?, items.vector()?, items.vector()?] },
            Rule::smooth_triangle => smooth_triangle(items)?,
            Rule::mesh => self.mesh(items)?,
            Rule::mesh2 => self.mesh2(node, items)?,
            Rule::height_field => self.height_field(items)?,
            Rule::blob => self.blob(items)?,
            Rule::bicubic_patch => bicubic_patch(items)?,
            Rule::prism => prism(node, items)?,
            Rule::lathe => lathe(node, items)?,
            Rule::sor => sor(node, items)?,
            Rule::sphere_sweep => sphere_sweep(node, items)?,
            Rule::text => self.text(items)?,
            Rule::isosurface => self.isosurface(items)?,
            Rule::parametric => self.parametric(items)?,
            Rule::julia_fractal => julia_fractal(node, items)?,
            Rule::light_source => self.light(items)?,
            _ => return misplaced(node),
        })
    }

    fn height_field(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let image = self.image(items.node()?)?;
        let mut field = HeightField { image, water_level: f64::NEG_INFINITY, smooth: false };
        if let Some(level) = items.optional(Rule::water_level) {
            let scale = if self.version < 200 { 256.0 } else { 1.0 };
            field.water_level = Items::of(level).number()? / scale;
        }
        field.smooth = items.accept(Rule::smooth);
        Ok(Shape::HeightField(Arc::new(field)))
    }

    fn blob(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let mut blob = Blob { threshold: items.number()?, components: Vec::new(), sturm: false };
        while let Some(component) = items.optional(Rule::component) {
            let part = Items::of(component).node()?;
            blob.components.push(self.component(part)?);
        }
        blob.sturm = items.accept(Rule::sturm);
        Ok(Shape::Blob(Arc::new(blob)))
    }

    fn component(&mut self, node: Node<'a>) -> Read<BlobComponent> {
        let is_cylinder = node.as_rule() == Rule::blob_cylinder;
        let mut items = Items::of(node.clone());
        let first = items.vector()?;
        let second = if is_cylinder { items.vector()? } else { first };
        if is_cylinder && first == second {
            return wrong(&node, "the two ends of a blob cylinder must not be the same point");
        }
        let (radius, strength) = (items.number()?, items.number()?);
        let (mut transform, mut texture) = (Transform::IDENTITY, None);
        for item in items {
            match item.as_rule() {
                Rule::transform => transform = transform.then(&self.transform(item)?),
                _ => self.add_texture(item, &mut texture)?,
            }
        }
        Ok(BlobComponent { ends: [first, second], is_cylinder, radius, strength, transform, texture })
    }

    fn text(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let name = items.node()?;
        let font_file = self.find(file_name(&name), &name)?;
        let font = self.font(&font_file, &name)?;
        let literal = items.node()?;
        let characters = unescaped(&literal)?;
        let (thickness, offset) = (items.number()?, items.vector()?);
        let unicode = self.utf8 && !items.accept(Rule::ascii_note);
        Ok(Shape::Text(Arc::new(Text { font, font_file, characters, unicode, thickness, offset })))
    }

    fn isosurface(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let function = self.plain_function(items.node()?, &["x", "y", "z"])?;
        let mut surface = Isosurface::new(function, self.options.isosurface_search);
        while let Some(rule) = items.peek().filter(|rule| *rule != Rule::modifiers) {
            let item = items.node()?;
            let mut inner = Items::of(item.clone());
            match rule {
                Rule::container => surface.container = container(inner.node()?)?,
                Rule::evaluate => surface.evaluate = Some([inner.number()?, inner.number()?, inner.number()?]),
                Rule::open => surface.open = true,
                Rule::surface_number => match inner.word()? {
                    "threshold" => surface.threshold = inner.number()?,
                    "accuracy" => surface.accuracy = positive(&mut inner)?,
                    "max_gradient" => surface.max_gradient = positive(&mut inner)?,
                    _ => surface.max_trace = inner.whole_within(1, 10)?,
                },
                _ => return misplaced(&item),
            }
        }
        surface.accuracy *= self.options.overrides.isosurface_accuracy;
        Ok(Shape::Isosurface(Arc::new(surface)))
    }

    fn parametric(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let mut function = || self.plain_function(items.node()?, &["u", "v"]);
        let functions = [function()?, function()?, function()?];
        let mut surface = Parametric {
            functions,
            min: items.vector2()?,
            max: items.vector2()?,
            container: Container::Box { min: DVec3::NEG_ONE, max: DVec3::ONE },
            accuracy: 0.001,
            max_gradient: 1.0,
            precompute: None,
        };
        while let Some(rule) = items.peek().filter(|rule| *rule != Rule::modifiers) {
            let item = items.node()?;
            let mut inner = Items::of(item.clone());
            match rule {
                Rule::container => surface.container = container(inner.node()?)?,
                Rule::surface_number => match inner.word()? {
                    "accuracy" => surface.accuracy = positive(&mut inner)?,
                    "max_gradient" => surface.max_gradient = positive(&mut inner)?,
                    _ => return misplaced(&item),
                },
                Rule::precompute => {
                    let depth = inner.whole_within(1, 20)?;
                    let mut axes = [false; 3];
                    for axis in inner {
                        axes[usize::from(axis.as_str().as_bytes()[0] - b'x')] = true;
                    }
                    surface.precompute = Some((depth, axes));
                }
                _ => return misplaced(&item),
            }
        }
        Ok(Shape::Parametric(Arc::new(surface)))
    }
}

/// A vector of length 1: one that is so already, up to rounding, stays as it is to the bit.
pub(super) fn unit_kept(v: DVec3) -> Option<DVec3> {
    /// What normalising leaves of a difference to 1.
    const ROUNDING: f64 = 8.0 * f64::EPSILON;
    if (v.length_squared() - 1.0).abs() <= ROUNDING { Some(v) } else { unit(v) }
}

fn positive(items: &mut Items<'_>) -> Read<f64> {
    let node = items.node()?;
    let value = super::tree::number(&node)?;
    if value > 0.0 { Ok(value) } else { wrong(&node, "expected a number above 0") }
}

fn cylinder(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let (base, cap, radius) = (items.vector()?, items.vector()?, items.number()?.abs());
    if base == cap {
        return wrong(node, "the two ends of a cylinder must not be the same point");
    }
    Ok(Shape::Cylinder { base, cap, radius, open: items.accept(Rule::open) })
}

fn cone(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let (base, base_radius) = (items.vector()?, items.number()?);
    let (cap, cap_radius) = (items.vector()?, items.number()?);
    if base == cap {
        return wrong(node, "the two ends of a cone must not be the same point");
    }
    Ok(Shape::Cone { base, base_radius, cap, cap_radius, open: items.accept(Rule::open) })
}

fn plane(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    match unit_kept(items.vector()?) {
        Some(normal) => Ok(Shape::Plane { normal, distance: items.number()? }),
        None => wrong(node, "a plane needs a normal that is not zero"),
    }
}

fn polynomial(items: &mut Items<'_>) -> Read<Shape> {
    let order = items.whole_within(2, MAX_ORDER)?;
    let list = items.node()?;
    let coefficients = numbers(&list)?;
    let n = order as usize;
    let needed = (n + 1) * (n + 2) * (n + 3) / 6;
    if coefficients.len() != needed {
        return wrong(
            &list,
            format!("a polynomial of order {n} has {needed} coefficients, not {}", coefficients.len()),
        );
    }
    Ok(Shape::Polynomial { order, coefficients: coefficients.into(), sturm: items.accept(Rule::sturm) })
}

fn smooth_triangle(items: &mut Items<'_>) -> Read<Shape> {
    let (mut vertices, mut normals) = ([DVec3::ZERO; 3], [DVec3::ZERO; 3]);
    for i in 0..3 {
        vertices[i] = items.vector()?;
        normals[i] = unit_kept(items.vector()?).unwrap_or_default();
    }
    Ok(Shape::SmoothTriangle(Box::new(SmoothTriangle { vertices, normals })))
}

/// `n, <…>, …`: as many points as it says.
fn points<const N: usize>(node: Node<'_>, least: usize) -> Read<Vec<[f64; N]>> {
    let mut items = Items::of(node.clone());
    let n = items.whole()? as usize;
    let points = items.map(|point| components(&point)).collect::<Read<Vec<_>>>()?;
    if points.len() != n || n < least {
        let have = points.len();
        return wrong(&node, format!("{n} points are announced, {have} are there, and at least {least} are needed"));
    }
    Ok(points)
}

fn points2(node: Node<'_>, least: usize) -> Read<Vec<DVec2>> {
    Ok(points(node, least)?.into_iter().map(DVec2::from).collect())
}

fn sweep_spline(items: &mut Items<'_>) -> Read<SweepSpline> {
    Ok(match items.word()? {
        "linear_spline" => SweepSpline::Linear,
        "quadratic_spline" => SweepSpline::Quadratic,
        "cubic_spline" => SweepSpline::Cubic,
        "bezier_spline" => SweepSpline::Bezier,
        _ => SweepSpline::B,
    })
}

/// How many points a curve needs at least, where a shape takes that curve.
fn least_points(node: &Node<'_>, spline: SweepSpline, least: [Option<usize>; 5]) -> Read<usize> {
    match least[spline as usize] {
        Some(least) => Ok(least),
        None => wrong(node, "this shape takes no such spline"),
    }
}

fn check_bezier(node: &Node<'_>, spline: SweepSpline, n: usize) -> Read<()> {
    if spline == SweepSpline::Bezier && !n.is_multiple_of(4) {
        return wrong(node, format!("a bezier_spline needs a multiple of 4 points, it has {n}"));
    }
    Ok(())
}

fn prism(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let spline = sweep_spline(items)?;
    let least = least_points(node, spline, [Some(3), Some(5), Some(6), Some(4), None])?;
    let conic = items.word()? == "conic_sweep";
    let heights = [items.number()?, items.number()?];
    let points = points2(items.node()?, least)?;
    check_bezier(node, spline, points.len())?;
    let (open, sturm) = (items.accept(Rule::open), items.accept(Rule::sturm));
    let heights = [heights[0].min(heights[1]), heights[0].max(heights[1])];
    Ok(Shape::Prism(Arc::new(Prism { spline, conic, heights, points, open, sturm })))
}

fn lathe(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let spline = sweep_spline(items)?;
    let least = least_points(node, spline, [Some(2), Some(3), Some(4), Some(4), None])?;
    let points = points2(items.node()?, least)?;
    check_bezier(node, spline, points.len())?;
    let inner = points.get(1..points.len() - 1).unwrap_or_default();
    if inner.iter().any(|p| p.x < 0.0) {
        return wrong(node, "the points of a lathe must not have a negative radius");
    }
    Ok(Shape::Lathe { spline, points: points.into(), sturm: items.accept(Rule::sturm) })
}

fn sor(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let points = points2(items.node()?, 4)?;
    let falls = points[1..points.len() - 1].windows(2).any(|w| w[1].y <= w[0].y);
    let flat = points.windows(3).any(|w| w[2].y == w[0].y);
    if falls || flat || points.iter().any(|p| p.x < 0.0) {
        return wrong(node, "the points of a sor must have rising heights and no negative radius");
    }
    Ok(Shape::Sor { points: points.into(), open: items.accept(Rule::open), sturm: items.accept(Rule::sturm) })
}

fn sphere_sweep(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let spline = sweep_spline(items)?;
    let least = least_points(node, spline, [Some(2), None, Some(4), None, Some(4)])?;
    let n = items.whole()? as usize;
    let mut spheres = Vec::new();
    while items.peek() == Some(Rule::vector) {
        spheres.push((items.vector()?, items.number()?));
    }
    if spheres.len() != n || n < least {
        let have = spheres.len();
        return wrong(node, format!("{n} spheres are announced, {have} are there, and at least {least} are needed"));
    }
    let tolerance = match items.optional(Rule::tolerance) {
        Some(tolerance) => Items::of(tolerance).number()?,
        None => 1e-6, // POV-Ray's default
    };
    Ok(Shape::SphereSweep { spline, spheres: spheres.into(), tolerance })
}

fn bicubic_patch(items: &mut Items<'_>) -> Read<Shape> {
    items.number()?; // both types are the same surface
    let mut patch = BicubicPatch {
        flatness: items.number()?,
        u_steps: items.whole_within(0, 30)?,
        v_steps: items.whole_within(0, 30)?,
        points: [[DVec3::ZERO; 4]; 4],
        uv_corners: [DVec2::ZERO; 4],
    };
    for corner in &mut patch.uv_corners {
        *corner = items.vector2()?;
    }
    for point in patch.points.iter_mut().flatten() {
        *point = items.vector()?;
    }
    Ok(Shape::BicubicPatch(Arc::new(patch)))
}

fn container(node: Node<'_>) -> Read<Container> {
    let is_sphere = node.as_rule() == Rule::container_sphere;
    let mut items = Items::of(node);
    let first = items.vector()?;
    if is_sphere {
        return Ok(Container::Sphere { center: first, radius: items.number()? });
    }
    let second = items.vector()?;
    Ok(Container::Box { min: first.min(second), max: first.max(second) })
}

fn julia_fractal(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let parameter = items.vector4()?;
    let hypercomplex = items.word()? == "hypercomplex";
    let function = julia_function(items.node()?)?;
    if !hypercomplex && !matches!(function, JuliaFunction::Sqr | JuliaFunction::Cube) {
        return wrong(node, "quaternion Julia fractals iterate only sqr and cube; 'hypercomplex' ones take any");
    }
    let max_iteration = items.whole_within(1, 1 << 20)?;
    let precision = items.number()?.max(1.0);
    let (normal, slice_distance) = (items.vector4()?, items.number()?);
    let slice_normal = if (normal.length_squared() - 1.0).abs() <= 8.0 * f64::EPSILON {
        normal
    } else {
        normal.try_normalize().unwrap_or(DVec4::ZERO)
    };
    // POV-Ray's smallest fourth component of a slice.
    if slice_normal.w.abs() < 1e-10 {
        return wrong(node, "the slice's normal needs a fourth component that is not 0");
    }
    Ok(Shape::JuliaFractal(Arc::new(JuliaFractal {
        parameter,
        hypercomplex,
        function,
        max_iteration,
        precision,
        slice_normal,
        slice_distance,
    })))
}

fn julia_function(node: Node<'_>) -> Read<JuliaFunction> {
    use JuliaFunction as F;
    let mut items = Items::of(node);
    if items.peek() == Some(Rule::number) {
        return Ok(F::Pwr(items.number()?, items.number()?));
    }
    Ok(match items.word()? {
        "sqr" => F::Sqr,
        "cube" => F::Cube,
        "exp" => F::Exp,
        "ln" => F::Ln,
        "sin" => F::Sin,
        "asin" => F::Asin,
        "cos" => F::Cos,
        "acos" => F::Acos,
        "tan" => F::Tan,
        "atan" => F::Atan,
        "sinh" => F::Sinh,
        "asinh" => F::Asinh,
        "cosh" => F::Cosh,
        "acosh" => F::Acosh,
        "tanh" => F::Tanh,
        "atanh" => F::Atanh,
        _ => F::Reciprocal,
    })
}

/// The characters of a literal.
fn unescaped(node: &Node<'_>) -> Read<Vec<u16>> {
    let text = file_name(node);
    let mut out = Vec::new();
    let mut rest = text.chars();
    while let Some(c) = rest.next() {
        if c != '\\' {
            let mut two = [0; 2];
            out.extend_from_slice(c.encode_utf16(&mut two));
            continue;
        }
        match rest.next() {
            Some(c @ ('\\' | '"' | '\'')) => out.push(c as u16),
            Some('n') => out.push(10),
            Some('t') => out.push(9),
            Some('u') => {
                let digits: String = rest.by_ref().take(4).collect();
                match u16::from_str_radix(&digits, 16) {
                    Ok(unit) if digits.len() == 4 => out.push(unit),
                    _ => return wrong(node, "\\u needs four hexadecimal digits"),
                }
            }
            _ => return wrong(node, "unknown escape sequence in this string"),
        }
    }
    Ok(out)
}
