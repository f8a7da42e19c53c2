//! Meshes, patches, height fields and blobs.

use super::{Case, Field, check};

/// A cube of twelve triangles.
fn cube() -> String {
    let corner = |i: usize| {
        let [x, y, z] = [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -1 } else { 1 });
        format!("<{x}, {y}, {z}>")
    };
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let face = |[a, b, c, d]: [usize; 4]| {
        let [a, b, c, d] = [a, b, c, d].map(corner);
        format!("triangle {{ {a}, {c}, {b} }} triangle {{ {a}, {d}, {c} }} ")
    };
    sides.map(face).concat()
}

#[test]
fn meshes() {
    let field: Field = |p| p.abs().max_element() - 1.0;
    let solid = format!("mesh {{ {} inside_vector <.1, .9, .2> }}", cube());
    check(&Case::solid("mesh", solid).convex().field(field));
    check(&Case::sheet("mesh without inside", format!("mesh {{ {} }}", cube())).convex().field(field));
    let roof = "mesh2 { vertex_vectors { 4, <-1, -.5, -1>, <1, -.5, -1>, <0, .7, 0>, <0, -.5, 1> }
        face_indices { 3, <0, 1, 2>, <1, 3, 2>, <3, 0, 2> } }";
    check(&Case::sheet("mesh2", roof));
}

#[test]
fn patches() {
    // z = 4 times the two inner Bernstein weights in u times those in v: a hill over a square.
    let row = |i: i32| {
        let point = |j: i32| {
            let height = if (1..3).contains(&i) && (1..3).contains(&j) { 1.0 } else { 0.0 };
            format!("<{}, {}, {height}>", (2 * j - 3) as f64 / 3.0, (2 * i - 3) as f64 / 3.0)
        };
        [0, 1, 2, 3].map(point).join(", ")
    };
    let points = [0, 1, 2, 3].map(row).join(", ");
    let hill: Field = |p| {
        let inner = |x: f64| {
            let w = 0.5 * (x + 1.0);
            3.0 * w * (1.0 - w)
        };
        p.z - inner(p.x) * inner(p.y)
    };
    let text = format!("bicubic_patch {{ type 1 u_steps 6 v_steps 6 {points} }}");
    // The facets turn by a 64th of the whole turn of the normal, from one to the next; stretched unevenly by more.
    check(&Case::sheet("bicubic_patch", text).field(hill).normals_within(0.2));
}

#[test]
fn height_fields() {
    let field = |extra: &str| {
        format!(
            "height_field {{ function 33, 33 {{ .5 + .3 * sin(5 * x) * cos(4 * y) }} {extra} translate -.5 scale 2 }}"
        )
    };
    check(&Case::open("height_field", field("")));
    check(&Case::open("height_field smooth", field("smooth")));
    check(&Case::sheet("height_field in water", field("water_level .4")));
}

#[test]
fn blobs() {
    let pair: Field = |p| {
        let part = |x: f64| (1.0 - (p - super::v(x, 0.0, 0.0)).length_squared()).max(0.0).powi(2);
        0.4 - part(0.4) - part(-0.4)
    };
    let text = "blob { threshold .4 sphere { .4*x, 1, 1 } sphere { -.4*x, 1, 1 } }";
    check(&Case::solid("blob", text).field(pair));
    let mixed = "blob { threshold .5 cylinder { -.6*x, .6*x, .8, 1 } sphere { .5*y, .7, 1.2 }
        sphere { <.4, .3, -.5>, .6, -1 } cylinder { 0, z, .5, .8 scale <1, 1.5, 1> rotate 20*y } }";
    check(&Case::solid("blob of all parts", mixed));
}
