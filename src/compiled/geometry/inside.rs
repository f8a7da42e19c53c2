//! Which objects contain a point.

use super::Geometry;
use super::graph::{Group, Item, ItemKind, padded};
use super::record::{InteriorKey, Path};
use crate::compiled::handle::{InteriorId, ObjectId};
use crate::math::{Bounds, DVec3, Range, Ray};
use std::ops::ControlFlow;

/// Where a ray may go from one object straight into another; errs on the side of more.
#[derive(Clone, Debug, Default)]
pub enum Touching {
    /// No two are near each other.
    #[default]
    Nowhere,
    /// In two of these boxes at once.
    WhereBoxesMeet(Vec<Bounds>),
    /// Nobody knows.
    Anywhere,
}

impl Touching {
    /// More boxes take longer to look through than what they save.
    const MOST_BOXES: usize = 64;

    /// Whether it may at a world point.
    pub fn is_at(&self, point: DVec3) -> bool {
        match self {
            Self::Nowhere => false,
            Self::WhereBoxesMeet(boxes) => boxes.iter().filter(|bounds| bounds.contains(point)).nth(1).is_some(),
            Self::Anywhere => true,
        }
    }
}

impl Geometry {
    /// Calls `found` with every item that contains `point` (in the group's space) until it
    /// returns false; tells whether to go on.
    pub(super) fn gather(
        &self,
        group: &Group,
        point: DVec3,
        path: &mut Path,
        found: &mut impl FnMut(&Self, &Item, &Path) -> bool,
    ) -> bool {
        for item in &group.infinite {
            if !self.gather_item(item, point, path, found) {
                return false;
            }
        }
        // A ray of no length meets exactly the boxes that hold its origin.
        let ray = Ray::new(point, DVec3::X);
        let here = Range { min: -f64::MIN_POSITIVE, max: f64::MIN_POSITIVE };
        let flow: ControlFlow<()> = group.bvh.walk(&ray, here, |items, _| {
            for item in &group.items[items] {
                if !self.gather_item(item, point, path, found) {
                    return ControlFlow::Break(());
                }
            }
            ControlFlow::Continue(())
        });
        flow.is_continue()
    }

    pub(super) fn gather_item(
        &self,
        item: &Item,
        point: DVec3,
        path: &mut Path,
        found: &mut impl FnMut(&Self, &Item, &Path) -> bool,
    ) -> bool {
        let inside = match &item.kind {
            ItemKind::Sphere(_, p) | ItemKind::Plane(_, p) | ItemKind::Primitive(p) => {
                self.primitive_contains(*p, point)
            }
            ItemKind::Solid(root) => self.node_contains(*root, point),
            ItemKind::Instance(i) => {
                let instance = &self.instances[*i];
                let local = instance.parent_from_group.inverse_point(point);
                path.push(*i);
                let go_on = self.gather(&self.groups[instance.group], local, path, found);
                path.pop();
                return go_on;
            }
        };
        !inside || found(self, item, path)
    }

    /// Where two objects may touch whose interiors are such.
    pub(crate) fn may_touch(&self, is_such: impl Fn(InteriorId) -> bool) -> Touching {
        let mut boxes: Vec<Bounds> = Vec::new();
        for item in self.root.items.iter().chain(&self.root.infinite) {
            let bounds = match &item.kind {
                ItemKind::Sphere(_, p) | ItemKind::Plane(_, p) | ItemKind::Primitive(p) => self.primitives[*p].bounds(),
                ItemKind::Solid(root) => padded(self.nodes[*root].bounds),
                // Its objects inherit from one another, and may touch among themselves.
                ItemKind::Instance(_) => return Touching::Anywhere,
            };
            if self.item_interior(item, &Path::default()).is_some_and(|(_, key)| is_such(key.interior)) {
                boxes.push(bounds);
            }
        }
        let meet = |a: &Bounds, b: &Bounds| !a.intersection(b).is_empty();
        if boxes.len() > Touching::MOST_BOXES {
            Touching::Anywhere
        } else if boxes.iter().enumerate().any(|(k, a)| boxes[k + 1..].iter().any(|b| meet(a, b))) {
            Touching::WhereBoxesMeet(boxes)
        } else {
            Touching::Nowhere
        }
    }

    /// The interior of a frame-level object, with its place in file order.
    pub(super) fn item_interior(&self, item: &Item, path: &Path) -> Option<(ObjectId, InteriorKey)> {
        let appearance = match &item.kind {
            ItemKind::Sphere(_, p) | ItemKind::Plane(_, p) | ItemKind::Primitive(p) => self.primitives[*p].appearance,
            ItemKind::Solid(root) => self.nodes[*root].appearance,
            ItemKind::Instance(_) => return None,
        };
        self.interior_of(appearance, path)
    }
}
