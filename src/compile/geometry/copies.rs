//! Pass 1b, `count_written_out`: how much has to be written out although it is used more than once.
//!
//! Twenty lines that each join two copies of the line before make a million objects. Copies are shared where that can be
//! done ([`super::builder`]); what cannot is counted here, before anything is built, so that such a scene gets a message
//! instead of all the memory.

use super::builder::can_be_shared;
use super::census::Census;
use crate::compiled::geometry::MAX_INSTANCE_DEPTH;
use crate::scene::{Object, Shape};
use crate::stack::roomy;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// What building an object takes.
#[derive(Clone, Copy, Debug, Default)]
struct Cost {
    /// Items and nodes.
    parts: u64,
    /// Instances inside each other.
    height: usize,
}

/// Counts of objects that were met, by address.
pub(super) struct Copies<'c> {
    census: &'c Census,
    solids: FxHashMap<*const Object, u64>,
    placed: FxHashMap<*const Object, Cost>,
    /// In groups that are built once.
    shared: u64,
}

impl<'c> Copies<'c> {
    pub(super) fn new(census: &'c Census) -> Self {
        Self { census, solids: FxHashMap::default(), placed: FxHashMap::default(), shared: 0 }
    }

    /// Items, nodes and lights that a frame-level object adds.
    pub(super) fn count(&mut self, object: &Object, split: bool) -> u64 {
        let before = std::mem::take(&mut self.shared);
        let own = self.place(object, split).parts;
        let lights = match &object.shape {
            Shape::Csg { children, .. } => self.census.of(children).lights,
            _ => 0,
        };
        let added = own.saturating_add(self.shared).saturating_add(lights);
        self.shared = before;
        added
    }

    /// As [`super::builder::Builder`] places it.
    fn place(&mut self, object: &Object, split: bool) -> Cost {
        if is_single(object) {
            return Cost { parts: 1, height: 0 };
        }
        roomy(|| self.place_parts(object, split))
    }

    fn place_parts(&mut self, object: &Object, split: bool) -> Cost {
        if let Some(known) = self.placed.get(&std::ptr::from_ref(object)) {
            return *known;
        }
        let cost = match &object.shape {
            Shape::LightSource(light) => light.looks_like.as_ref().map_or(Cost::default(), |o| self.place(o, split)),
            Shape::LightGroup { children, .. } => self.sum(children, split),
            Shape::Csg { children, .. } => {
                let splits = split && object.splits();
                let shares = can_be_shared(self.census.of(children), object, splits) && !object.flags.turned;
                let inside = if splits { self.sum(children, split) } else { self.one_solid(object) };
                if shares && inside.height < MAX_INSTANCE_DEPTH {
                    self.shared = self.shared.saturating_add(inside.parts);
                    Cost { parts: 1, height: inside.height + 1 }
                } else {
                    inside
                }
            }
            _ => self.one_solid(object),
        };
        self.placed.insert(object, cost);
        cost
    }

    fn sum(&mut self, children: &[Arc<Object>], split: bool) -> Cost {
        children.iter().fold(Cost { parts: 1, height: 0 }, |sum, child| {
            let one = self.place(child, split);
            Cost { parts: sum.parts.saturating_add(one.parts), height: sum.height.max(one.height) }
        })
    }

    fn one_solid(&mut self, object: &Object) -> Cost {
        Cost { parts: self.solid(object), height: 0 }
    }

    /// An object as part of a solid, with everything in it and all that cuts it.
    fn solid(&mut self, object: &Object) -> u64 {
        if is_single(object) {
            return 1;
        }
        if let Some(known) = self.solids.get(&std::ptr::from_ref(object)) {
            return *known;
        }
        let children: &[Arc<Object>] = match &object.shape {
            Shape::Csg { children, .. } | Shape::LightGroup { children, .. } => children,
            _ => &[],
        };
        let looks = match &object.shape {
            Shape::LightSource(light) => light.looks_like.as_ref(),
            _ => None,
        };
        let all = children.iter().chain(looks).chain(&object.rare.clipped_by).chain(&object.rare.bounded_by);
        let n = roomy(|| all.fold(1_u64, |n, one| n.saturating_add(self.solid(one))));
        self.solids.insert(object, n);
        n
    }
}

/// Whether an object holds no other, as most do: nothing is worth remembering of it.
fn is_single(object: &Object) -> bool {
    object.shape.is_single() && object.rare.clipped_by.is_empty() && object.rare.bounded_by.is_empty()
}
