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
    /// Where the boxes of two objects meet.
    WhereBoxesMeet {
        /// Around all such places.
        around: Bounds,
        /// One by one, each a box itself.
        boxes: Vec<Bounds>,
    },
    /// Nobody knows.
    Anywhere,
}

impl Touching {
    /// More objects, or more places, take longer to look through than what they save.
    const MOST_BOXES: usize = 64;

    /// Where two of some boxes meet.
    fn between(objects: &[Bounds]) -> Self {
        if objects.len() > Self::MOST_BOXES {
            return Self::Anywhere;
        }
        let pairs =
            objects.iter().enumerate().flat_map(|(k, a)| objects[k + 1..].iter().map(move |b| a.intersection(b)));
        let mut boxes: Vec<Bounds> = pairs.filter(|common| !common.is_empty()).collect();
        let around = boxes.iter().fold(Bounds::EMPTY, |sum, one| sum.union(one));
        match boxes.len() {
            0 => Self::Nowhere,
            n => {
                if n > Self::MOST_BOXES {
                    boxes = vec![around];
                }
                Self::WhereBoxesMeet { around, boxes }
            }
        }
    }

    /// Whether it may at a world point.
    pub fn is_at(&self, point: DVec3) -> bool {
        match self {
            Self::Nowhere => false,
            Self::WhereBoxesMeet { around, boxes } => {
                around.contains(point) && boxes.iter().any(|common| common.contains(point))
            }
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
        Touching::between(&boxes)
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
