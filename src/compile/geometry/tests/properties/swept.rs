//! Outlines turned and swept, and text.

use super::{Case, Field, check};

const SQUARE: &str = "5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>";
const QUADRATIC: &str = "6, <1, -1>, <-.5, -.5>, <.5, -.5>, <.5, .5>, <-.5, .5>, <-.5, -.5>";
const CUBIC: &str = "7, <-.5, .5>, <-.5, -.5>, <.5, -.5>, <.5, .5>, <-.5, .5>, <-.5, -.5>, <.5, -.5>";
const BEZIER: &str = "8, <-.8, 0>, <-.3, -1>, <.3, -1>, <.8, 0>, <.8, 0>, <.3, .8>, <-.3, .8>, <-.8, 0>";

#[test]
fn prisms() {
    let cube: Field = |p| p.abs().max_element() - 1.0;
    check(&Case::solid("prism linear", format!("prism {{ -1, 1, {SQUARE} }}")).convex().field(cube));
    check(&Case::solid("prism quadratic", format!("prism {{ quadratic_spline -1, 1, {QUADRATIC} }}")));
    check(&Case::solid("prism cubic", format!("prism {{ cubic_spline -1, 1, {CUBIC} }}")));
    check(&Case::solid("prism bezier", format!("prism {{ bezier_spline -1, 1, {BEZIER} }}")));
    let pyramid: Field = |p| (p.x.abs().max(p.z.abs()) - p.y - 0.5).max((p.y - 0.1).abs() - 0.4);
    let text = format!("prism {{ conic_sweep .2, 1, {SQUARE} translate -.5*y }}");
    check(&Case::solid("prism conic", text).field(pyramid));
    let text = format!("prism {{ conic_sweep cubic_spline -1, 1, {CUBIC} }}");
    check(&Case::solid("prism conic cubic", text));
}

#[test]
fn lathes() {
    let lathe = |spline: &str, points: &str| format!("lathe {{ {spline} {points} }}");
    let linear = lathe("linear_spline", "5, <0, -1>, <.9, -.5>, <.4, .2>, <.6, .7>, <0, 1>");
    check(&Case::solid("lathe linear", linear));
    let quadratic = lathe("quadratic_spline", "6, <.5, -1>, <0, -1>, <.9, -.5>, <.4, .2>, <.6, .7>, <0, 1>");
    check(&Case::solid("lathe quadratic", quadratic));
    let cubic = lathe("cubic_spline", "7, <.5, -1>, <0, -1>, <.9, -.5>, <.4, .2>, <.6, .7>, <0, 1>, <-.5, 1>");
    check(&Case::solid("lathe cubic", cubic));
    let bezier =
        lathe("bezier_spline", "8, <0, -1>, <.7, -1>, <1, -.5>, <.4, .1>, <.4, .1>, <.1, .4>, <.5, .9>, <0, 1>");
    check(&Case::solid("lathe bezier", bezier));
}

#[test]
fn sors() {
    let points = "5, <.5, -1.5>, <.6, -1>, <.9, 0>, <.3, 1>, <.2, 1.5>";
    check(&Case::solid("sor", format!("sor {{ {points} }}")));
    check(&Case::sheet("sor open", format!("sor {{ {points} open }}")));
}

#[test]
fn sphere_sweeps() {
    let linear = "sphere_sweep { linear_spline 3, <-.8, 0, 0>, .4, <0, .5, .2>, .25, <.8, -.2, 0>, .35 }";
    check(&Case::solid("sphere_sweep linear", linear));
    let capsule: Field = |p| (p - super::v(p.x.clamp(-0.6, 0.6), 0.0, 0.0)).length() - 0.4;
    let text = "sphere_sweep { linear_spline 2, -.6*x, .4, .6*x, .4 }";
    check(&Case::solid("sphere_sweep capsule", text).convex().field(capsule));
    let points = "5, <-1.5, 0, 0>, .3, <-.7, .5, 0>, .25, <0, -.3, .4>, .4, <.7, .5, 0>, .2, <1.5, 0, 0>, .3";
    check(&Case::solid("sphere_sweep b_spline", format!("sphere_sweep {{ b_spline {points} }}")));
    check(&Case::solid("sphere_sweep cubic", format!("sphere_sweep {{ cubic_spline {points} }}")));
}

#[test]
fn text() {
    let text = "text { ttf \"oA.ttf\" \"oA\" .3, 0 translate <-.6, -.3, -.15> }";
    check(&Case::solid("text", text));
}
