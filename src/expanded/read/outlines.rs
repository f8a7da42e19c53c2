//! Shapes by a row of points: prism, lathe, sor, sphere_sweep.

use super::tree::{Items, Node, Read, Rule, components, wrong};
use crate::math::DVec2;
use crate::scene::{Prism, Shape, SweepSpline};
use std::sync::Arc;

pub(super) fn prism(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
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

pub(super) fn lathe(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
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

pub(super) fn sor(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
    let points = points2(items.node()?, 4)?;
    let falls = points[1..points.len() - 1].windows(2).any(|w| w[1].y <= w[0].y);
    let flat = points.windows(3).any(|w| w[2].y == w[0].y);
    if falls || flat || points.iter().any(|p| p.x < 0.0) {
        return wrong(node, "the points of a sor must have rising heights and no negative radius");
    }
    Ok(Shape::Sor { points: points.into(), open: items.accept(Rule::open), sturm: items.accept(Rule::sturm) })
}

pub(super) fn sphere_sweep(node: &Node<'_>, items: &mut Items<'_>) -> Read<Shape> {
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

/// `n, <…>, …`: as many points as it says.
pub(super) fn points<const N: usize>(node: Node<'_>, least: usize) -> Read<Vec<[f64; N]>> {
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
