//! Pass 1, `census`: what a scene uses how often, and how large it is.

use crate::scene::{Object, Shape};
use crate::stack::roomy;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// What is known about one list of children, which every copy of a CSG object shares.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Entry {
    /// How many objects refer to it.
    pub(super) uses: u32,
    /// Primitives in it, copies counted each time.
    pub(super) weight: u64,
    /// Light sources in it, copies counted each time.
    pub(super) lights: u64,
    /// Holds a light group, whose members cannot be shared.
    pub(super) light_groups: bool,
    /// Something in it has a texture.
    pub(super) textured: bool,
    /// Something in it has a finish with an index of refraction.
    pub(super) finish_ior: bool,
    /// Something in it has media whose density depends on the place.
    pub(super) placed_media: bool,
    /// Something in it is a target of photons.
    pub(super) photon_targets: bool,
}

/// Facts about all lists of children, by address.
#[derive(Debug, Default)]
pub(super) struct Census {
    /// Photons are shot: their targets cannot be shared.
    with_photons: bool,
    entries: FxHashMap<*const Arc<Object>, Entry>,
    /// Objects that stand in no list of children, by address.
    counted: FxHashMap<*const Object, Entry>,
}

impl Census {
    /// Before anything is visited.
    pub(super) fn new(with_photons: bool) -> Self {
        Self { with_photons, ..Self::default() }
    }

    /// Visits an object and everything in it.
    pub(super) fn count(&mut self, object: &Object) -> Entry {
        for other in object.rare.clipped_by.iter().chain(&object.rare.bounded_by) {
            self.count_once(other);
        }
        let mut entry = match &object.shape {
            Shape::Csg { children, .. } => self.count_children(children),
            Shape::LightGroup { children, .. } => Entry { light_groups: true, ..self.count_children(children) },
            Shape::LightSource(light) => {
                let looks = light.looks_like.as_ref().map(|o| self.count_once(o)).unwrap_or_default();
                Entry { lights: 1, ..looks }
            }
            _ => Entry { weight: 1, ..Entry::default() },
        };
        entry.textured |= object.texture.is_some();
        entry.placed_media |= object.interior.as_ref().is_some_and(|interior| interior.has_place());
        entry.photon_targets |= self.with_photons && object.rare.photons.target.is_some();
        entry.finish_ior |= object.texture.as_ref().is_some_and(|placed| placed.texture.finish_ior().is_some());
        entry
    }

    /// An object that many may refer to.
    fn count_once(&mut self, object: &Arc<Object>) -> Entry {
        if let Some(known) = self.counted.get(&Arc::as_ptr(object)) {
            return *known;
        }
        let entry = roomy(|| self.count(object));
        self.counted.insert(Arc::as_ptr(object), entry);
        entry
    }

    fn count_children(&mut self, children: &Arc<[Arc<Object>]>) -> Entry {
        let key = children.as_ptr();
        if let Some(known) = self.entries.get_mut(&key) {
            known.uses += 1;
            return *known;
        }
        let mut sum = Entry { uses: 1, ..Entry::default() };
        for child in children.iter() {
            let one = roomy(|| self.count(child));
            sum.weight = sum.weight.saturating_add(one.weight);
            sum.lights = sum.lights.saturating_add(one.lights);
            sum.light_groups |= one.light_groups;
            sum.textured |= one.textured;
            sum.finish_ior |= one.finish_ior;
            sum.placed_media |= one.placed_media;
            sum.photon_targets |= one.photon_targets;
        }
        self.entries.insert(key, sum);
        sum
    }

    /// What is known about a list of children.
    pub(super) fn of(&self, children: &Arc<[Arc<Object>]>) -> Entry {
        self.entries.get(&children.as_ptr()).copied().unwrap_or_default()
    }

    /// Whether an object or anything in it has a texture.
    pub(super) fn textured(&self, object: &Object) -> bool {
        object.texture.is_some() || matches!(&object.shape, Shape::Csg { children, .. } if self.of(children).textured)
    }
}
