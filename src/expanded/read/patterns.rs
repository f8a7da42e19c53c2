//! Patterns, and what changes them.

use super::reader::{Reader, misplaced};
use super::shapes::unit_kept;
use super::tree::{Items, Node, Read, Rule, file_name, number, place, wrong};
use crate::math::DVec3;
use crate::scene::{BlackHole, FractalColoring, Pattern, PatternKind, SlopeDirection, Turbulence, Warp, Wave};
use std::sync::Arc;

impl<'a> Reader<'a> {
    /// A pattern as its word makes it, with the list behind it.
    pub(super) fn pattern(&mut self, node: Node<'a>) -> Read<(Pattern, Option<Node<'a>>)> {
        let mut items = Items::of(node);
        let kind = items.node()?;
        let mut list = items.optional(Rule::items);
        if kind.as_rule() == Rule::object_pattern {
            // Its list stands inside its braces.
            let mut inner = Items::of(kind);
            let object = inner.node()?;
            let object = self.object(object)?;
            list = inner.optional(Rule::items).or(list);
            return Ok((Pattern::new(PatternKind::Object(object)), list));
        }
        Ok((Pattern::new(self.pattern_kind(kind)?), list))
    }

    /// The items of a list are what belongs there, and as many as the pattern chooses from.
    pub(super) fn check_items(&self, list: &Node<'a>, kind: &PatternKind, rule: Rule) -> Read<()> {
        if list.clone().into_inner().any(|item| item.as_rule() != rule) {
            return wrong(list, "these do not belong together: a pattern chooses from things of one sort");
        }
        let n = list.clone().into_inner().count();
        match kind.n_blocks() {
            Some(needed) if needed == n => Ok(()),
            Some(needed) => wrong(list, format!("this pattern chooses from {needed} things, not from {n}")),
            None => wrong(list, "this pattern takes a map, not a list"),
        }
    }

    fn pattern_kind(&mut self, node: Node<'a>) -> Read<PatternKind> {
        use PatternKind as K;
        let rule = node.as_rule();
        let mut items = Items::of(node.clone());
        Ok(match rule {
            Rule::pattern_word => plain_kind(node.as_str()),
            Rule::pigment_pattern => K::Pigment(self.pigment_content(items.node()?)?),
            Rule::function => K::Function(self.plain_function(node, &["x", "y", "z"])?),
            Rule::image_pattern => K::Image(Arc::new(self.image_and_mapping(items.node()?)?)),
            Rule::agate => K::Agate { turbulence: items.float()? },
            Rule::crackle => K::Crackle {
                form: items.vector()?,
                metric: items.number()?,
                offset: items.number()?,
                solid: items.accept(Rule::solid),
            },
            Rule::density_file => {
                let name = items.node()?;
                let path = self.find(file_name(&name), &name)?;
                let data = self.bytes(&path, &name)?.into();
                K::DensityFile { span: place(&name), path, interpolation: items.whole_within(0, 9)? as u8, data }
            }
            Rule::gradient => K::Gradient(items.vector()?),
            Rule::julia => {
                let (c, iterations, exponent) = (items.vector2()?.to_array(), items.whole()?, exponent(&mut items)?);
                let [exterior, interior] = colorings(items.node()?)?;
                K::Julia { c, iterations, exponent, exterior, interior }
            }
            Rule::mandel => {
                let (iterations, exponent) = (items.whole()?, exponent(&mut items)?);
                let [exterior, interior] = colorings(items.node()?)?;
                K::Mandel { iterations, exponent, exterior, interior }
            }
            Rule::magnet => {
                let kind = items.whole_within(1, 2)?;
                let c = if items.peek() == Some(Rule::vector) { Some(items.vector2()?.to_array()) } else { None };
                let iterations = items.whole()?;
                let [exterior, interior] = colorings(items.node()?)?;
                K::Magnet { kind, c, iterations, exterior, interior }
            }
            Rule::pavement => {
                let mut next = || items.whole();
                let (sides, tiles, pattern) = (next()?, next()?, next()?);
                let (interior, exterior, form) = (next()?, next()?, next()?);
                K::Pavement { span: place(&node), sides, tiles, pattern, interior, exterior, form }
            }
            Rule::quilted => K::Quilted { control0: items.float()?, control1: items.float()? },
            Rule::slope => slope(&node, items)?,
            Rule::spiral => {
                let first = items.word()? == "spiral1";
                let arms = items.number()? as i32;
                if first { K::Spiral1(arms) } else { K::Spiral2(arms) }
            }
            Rule::tiling => K::Tiling(items.whole_within(1, 27)?),
            _ => return misplaced(&node),
        })
    }

    /// Something that changes any pattern.
    pub(super) fn pattern_modifier(&mut self, node: Node<'a>, pattern: &mut Pattern) -> Read<()> {
        let mut items = Items::of(node.clone());
        match node.as_rule() {
            Rule::transform => pattern.apply(&self.transform(node)?),
            Rule::brick_size => match &mut pattern.kind {
                PatternKind::Brick { size, mortar } => (*size, *mortar) = (items.vector()?, items.float()?),
                _ => return wrong(&node, "brick_size does not belong to this pattern"),
            },
            Rule::wave => {
                let inner = items.node()?;
                pattern.wave = match inner.as_str() {
                    "ramp_wave" => Wave::Ramp,
                    "triangle_wave" => Wave::Triangle,
                    "sine_wave" => Wave::Sine,
                    "scallop_wave" => Wave::Scallop,
                    "cubic_wave" => Wave::Cubic,
                    _ => Wave::Poly(number(&inner)? as f32),
                };
            }
            Rule::pattern_number => match items.word()? {
                "frequency" => pattern.frequency = items.float()?,
                "phase" => pattern.phase = items.float()?,
                _ => pattern.noise_generator = Some(items.whole_within(1, 3)? as u8),
            },
            Rule::turbulence => pattern.turbulence = Some(turbulence(node)?),
            Rule::warp => {
                let warp = warp(items.node()?)?;
                pattern.add(warp);
            }
            _ => return misplaced(&node),
        }
        Ok(())
    }
}

pub(super) fn turbulence(node: Node<'_>) -> Read<Turbulence> {
    let mut items = Items::of(node);
    let (amount, octaves) = (items.vector()?, items.whole_within(1, 10)?);
    Ok(Turbulence { amount, octaves, omega: items.float()?, lambda: items.float()? })
}

fn warp(node: Node<'_>) -> Read<Warp> {
    let rule = node.as_rule();
    let mut items = Items::of(node.clone());
    Ok(match rule {
        Rule::turbulence => Warp::Turbulence(turbulence(node)?),
        Rule::repeat => {
            let step = items.vector()?;
            let axes: Vec<usize> = (0..3).filter(|&i| step[i] != 0.0).collect();
            let [axis] = axes[..] else { return wrong(&node, "a repeat warp needs exactly one axis") };
            let mut inner = |rule| items.optional(rule).map(|node| Items::of(node).vector()).transpose();
            let (offset, flip) = (inner(Rule::offset)?.unwrap_or_default(), inner(Rule::flip)?.unwrap_or_default());
            Warp::Repeat { axis, width: step[axis] as f32, offset, flip }
        }
        Rule::black_hole => {
            let (center, radius, strength, falloff) =
                (items.vector()?, items.number()?, items.number()?, items.number()?);
            let inverse = items.accept(Rule::inverse);
            let kind = match items.optional(Rule::hole_type) {
                Some(kind) => Items::of(kind).number()? as i32,
                None => 0,
            };
            let mut inner = |rule| items.optional(rule).map(|node| Items::of(node).vector()).transpose();
            let (repeat, turbulence) = (inner(Rule::hole_repeat)?, inner(Rule::hole_turbulence)?);
            Warp::BlackHole(BlackHole { center, radius, strength, falloff, inverse, kind, repeat, turbulence })
        }
        Rule::mapping_warp => {
            let word = items.word()?;
            let orientation = unit_kept(items.vector()?).unwrap_or(DVec3::Z);
            let dist_exp = items.number()?;
            let radius = items.optional(Rule::major_radius);
            match word {
                "cylindrical" => Warp::Cylindrical { orientation, dist_exp },
                "spherical" => Warp::Spherical { orientation, dist_exp },
                _ => {
                    let major_radius = radius.map_or(Ok(1.0), |radius| Items::of(radius).number())?;
                    Warp::Toroidal { orientation, dist_exp, major_radius }
                }
            }
        }
        Rule::planar_warp => {
            let orientation = unit_kept(items.vector()?).unwrap_or(DVec3::Z);
            Warp::Planar { orientation, distance: items.number()? }
        }
        _ => Warp::Cubic,
    })
}

fn exponent(items: &mut Items<'_>) -> Read<u32> {
    Items::of(items.node()?).whole_within(2, 33)
}

fn colorings(node: Node<'_>) -> Read<[FractalColoring; 2]> {
    let mut items = Items::of(node);
    let mut one = |most| -> Read<FractalColoring> {
        Ok(FractalColoring { kind: items.whole_within(0, most)?, factor: items.number()? })
    };
    Ok([one(8)?, one(6)?])
}

fn slope(node: &Node<'_>, mut items: Items<'_>) -> Read<PatternKind> {
    fn range(items: &mut Items<'_>) -> Read<(f64, f64)> {
        match items.optional(Rule::range) {
            Some(range) => {
                let mut inner = Items::of(range);
                Ok((inner.number()?, inner.number()?))
            }
            None => Ok((0.0, 0.0)),
        }
    }
    let point_at = items.accept(Rule::slope_point);
    let v = items.vector()?;
    let direction = if point_at { SlopeDirection::PointAt(v) } else { SlopeDirection::Vector(v) };
    let (low, high) = range(&mut items)?;
    let altitude = match items.optional(Rule::altitude) {
        Some(altitude) => {
            let mut inner = Items::of(altitude);
            let axis = inner.vector()?;
            if point_at || (axis == DVec3::ZERO && v == DVec3::ZERO) {
                return wrong(node, "this slope takes no such altitude");
            }
            let (low, high) = range(&mut inner)?;
            Some((axis, low, high))
        }
        None => None,
    };
    Ok(PatternKind::Slope { direction, low, high, altitude })
}

fn plain_kind(word: &str) -> PatternKind {
    use PatternKind as K;
    match word {
        "aoi" => K::Aoi,
        "average" => K::Average,
        "boxed" => K::Boxed,
        "bozo" => K::Bozo,
        "spotted" => K::Spotted,
        "bumps" => K::Bumps,
        "brick" => K::Brick { size: DVec3::new(8.0, 3.0, 4.5), mortar: 0.5 }, // POV-Ray's default
        "cells" => K::Cells,
        "checker" => K::Checker,
        "cubic" => K::Cubic,
        "cylindrical" => K::Cylindrical,
        "dents" => K::Dents,
        "granite" => K::Granite,
        "hexagon" => K::Hexagon,
        "leopard" => K::Leopard,
        "marble" => K::Marble,
        "onion" => K::Onion,
        "planar" => K::Planar,
        "radial" => K::Radial,
        "ripples" => K::Ripples,
        "spherical" => K::Spherical,
        "square" => K::Square,
        "triangular" => K::Triangular,
        "waves" => K::Waves,
        "wood" => K::Wood,
        _ => K::Wrinkles,
    }
}
