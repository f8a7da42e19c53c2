//! The parameters of every shape.

use super::implicit::julia_fractal;
use super::outlines::{lathe, points, prism, sor, sphere_sweep};
use super::reader::{Reader, misplaced};
use super::tree::{Items, Node, Read, Rule, file_name, numbers, wrong};
use crate::math::{DVec2, DVec3, Transform, unit};
use crate::scene::{BicubicPatch, Blob, BlobComponent, HeightField, Shape, SmoothTriangle, Text};
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
}

/// A vector of length 1: one that is so already, up to rounding, stays as it is to the bit.
pub(super) fn unit_kept(v: DVec3) -> Option<DVec3> {
    /// What normalising leaves of a difference to 1.
    const ROUNDING: f64 = 8.0 * f64::EPSILON;
    if (v.length_squared() - 1.0).abs() <= ROUNDING { Some(v) } else { unit(v) }
}

pub(super) fn positive(items: &mut Items<'_>) -> Read<f64> {
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
