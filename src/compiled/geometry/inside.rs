//! Which objects contain a point.

use super::Geometry;
use super::graph::{Group, Item, ItemKind};
use super::record::{InteriorKey, Path};
use crate::compiled::handle::ObjectId;
use crate::math::{DVec3, Range, Ray};
use std::ops::ControlFlow;

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
