//! The graph as rays meet it, as an indented tree for people and for snapshot tests.

use super::shape::Primitive as _;
use super::{
    Appearance, AppearanceId, Geometry, Group, Hit, Item, ItemKind, Node, NodeId, NodeKind, Operation, PrimitiveId,
};
use crate::math::{Bounds, DVec3, Ray, Transform};
use crate::stack::roomy;
use std::fmt::Write as _;

impl Geometry {
    /// The tree from the root down; shared groups stand behind it, each once.
    pub(crate) fn dump(&self) -> String {
        let mut dump = Dump { geometry: self, out: String::new(), depth: 0 };
        dump.group("root", &self.root);
        for (i, group) in self.groups.iter().enumerate() {
            dump.group(&format!("group {i}"), group);
        }
        dump.out
    }
}

impl Geometry {
    /// The way of a ray down to what it hit, a line for each space, and back up from there. Directions are not
    /// normalised on the way, so the distance is the same number in every space.
    pub(crate) fn way(&self, ray: &Ray, hit: &Hit) -> Vec<String> {
        let mut steps = Vec::new();
        let mut local = *ray;
        for step in hit.path.steps() {
            let instance = &self.instances[*step];
            local = instance.parent_from_group.inverse_ray(&local);
            let (origin, direction) = (plain(local.origin), plain(local.direction));
            steps.push(format!("in group {}: from {origin} along {direction}", instance.group.number()));
        }
        let primitive = &self.primitives[hit.primitive];
        if let Some(place) = &primitive.group_from_local {
            local = place.inverse_ray(&local);
        }
        let name = primitive.shape.name();
        steps.push(format!(
            "in the space of the {name}: from {} along {}",
            plain(local.origin),
            plain(local.direction)
        ));
        let surface = primitive.shape.surface(&local, hit.t, hit.part);
        steps.push(format!("there it is hit at {}, normal {}", plain(surface.point), plain(surface.normal)));
        steps
    }
}

fn plain(v: DVec3) -> String {
    format!("<{}, {}, {}>", v.x, v.y, v.z)
}

/// The text under way.
struct Dump<'g> {
    geometry: &'g Geometry,
    out: String,
    depth: usize,
}

impl Dump<'_> {
    fn line(&mut self, text: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.out, "{:width$}{text}", "", width = 2 * self.depth);
    }

    fn inside(&mut self, write: impl FnOnce(&mut Self)) {
        self.depth += 1;
        write(self);
        self.depth -= 1;
    }

    fn group(&mut self, name: &str, group: &Group) {
        self.line(&format!("{name}: {}", bounds(&group.bounds)));
        self.inside(|dump| group.infinite.iter().chain(&group.items).for_each(|item| dump.item(item)));
    }

    fn item(&mut self, item: &Item) {
        match item.kind {
            ItemKind::Sphere(_, id) | ItemKind::Plane(_, id) | ItemKind::Primitive(id) => self.primitive(id),
            ItemKind::Solid(id) => self.node("solid", id),
            ItemKind::Instance(id) => {
                let instance = &self.geometry.instances[id];
                let place = place(&instance.parent_from_group);
                let look = self.look(instance.appearance);
                self.line(&format!("instance of group {}{place}{look}", instance.group.number()));
            }
        }
    }

    fn primitive(&mut self, id: PrimitiveId) {
        let primitive = &self.geometry.primitives[id];
        let turned = if primitive.inverse { " inverse" } else { "" };
        let place = primitive.group_from_local.as_ref().map_or_else(String::new, |t| place(t));
        let (box_, look) = (bounds(&primitive.bounds()), self.look(primitive.appearance));
        self.line(&format!("{}{turned} {box_}{place}{look}", primitive.shape.name()));
    }

    fn node(&mut self, what: &str, id: NodeId) {
        let node = &self.geometry.nodes[id];
        roomy(|| self.whole_node(what, node));
    }

    fn whole_node(&mut self, what: &str, node: &Node) {
        let (box_, look) = (bounds(&node.bounds), self.look(node.appearance));
        match &node.kind {
            NodeKind::Primitive(id) => {
                self.line(&format!("{what} of one part, {box_}{look}"));
                self.inside(|dump| dump.primitive(*id));
            }
            NodeKind::Csg { operation, children, is_difference, .. } => {
                let operation = match operation {
                    Operation::Union => "union",
                    Operation::Merge => "merge",
                    Operation::Intersection if *is_difference => "intersection (a difference)",
                    Operation::Intersection => "intersection",
                };
                self.line(&format!("{what}: {operation} {box_}{look}"));
                self.inside(|dump| children.iter().for_each(|child| dump.node("part", *child)));
            }
        }
        self.inside(|dump| {
            node.clips.iter().for_each(|clip| dump.node("clip", *clip));
            node.bounded_by.iter().for_each(|bound| dump.node("bound", *bound));
        });
    }

    /// What an appearance says.
    fn look(&self, id: AppearanceId) -> String {
        let Some(appearance) = self.geometry.appearances.get(id) else { return String::new() };
        let Appearance { texture, interior_texture, interior, uv_mapping, .. } = appearance;
        let mut out = String::new();
        for (word, placement) in [("texture", texture), ("interior_texture", interior_texture)] {
            if let Some(placement) = placement.and_then(|id| self.geometry.placements.get(id)) {
                out += &format!(" {word} {}", placement.texture.number());
                if placement.texture_from_group.is_some() {
                    out += " moved";
                }
            }
        }
        if let Some(interior) = interior {
            out += &format!(" interior {}", interior.number());
        }
        if *uv_mapping {
            out += " uv_mapping";
        }
        out
    }
}

fn vector(v: DVec3) -> String {
    /// Boxes have room for rounding, which is of no interest here: so many parts of a unit are told.
    const PARTS: f64 = 1e9;
    let rounded = v.to_array().map(|c| if c.abs() < PARTS.recip() { 0.0 } else { (c * PARTS).round() / PARTS });
    format!("<{}, {}, {}>", rounded[0], rounded[1], rounded[2])
}

fn bounds(bounds: &Bounds) -> String {
    if bounds.is_empty() {
        "empty".to_owned()
    } else if bounds.is_finite() {
        format!("in {} {}", vector(bounds.min), vector(bounds.max))
    } else {
        "unbounded".to_owned()
    }
}

/// Where local points go: the images of the axes, as far as they are others, and of the origin.
fn place(transform: &Transform) -> String {
    let linear = transform.linear();
    let mut out = String::new();
    for (axis, image, own) in
        [("x", linear.x_axis, DVec3::X), ("y", linear.y_axis, DVec3::Y), ("z", linear.z_axis, DVec3::Z)]
    {
        if image != own {
            out += &format!(" {axis} to {}", vector(image));
        }
    }
    if transform.origin() != DVec3::ZERO {
        out += &format!(" moved by {}", vector(transform.origin()));
    }
    out
}
