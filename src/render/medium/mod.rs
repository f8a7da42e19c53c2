//! What a ray is inside of, and what lies on its way.
//!
//! [`Interiors`] is the list of objects that a ray is in; [`Interiors::cross`] is the only place where it changes, for
//! camera, reflected, refracted and shadow rays alike. [`airlight`] and [`fog_transmittance`] say what fog does along a
//! segment of a ray, [`Passage`] what media do.

mod atmosphere;
mod march;
mod passage;
mod segment;
mod settling;

pub(super) use atmosphere::{Airlight, airlight, fog, fog_transmittance, rainbow};
pub(super) use march::{Carried, Incoming};
pub(super) use passage::Passage;
pub(super) use settling::Settling;

use crate::compiled::World;
use crate::compiled::geometry::{InteriorKey, RayKind, Scratch, Surface};
use crate::math::DVec3;
use smallvec::SmallVec;

/// An object that a ray is inside of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inside {
    /// Which interior.
    pub(super) key: InteriorKey,
    /// Fog goes on inside.
    pub(super) hollow: bool,
    /// What bends light in it.
    pub(super) index: RefractiveIndex,
}

/// How much slower light is than outside of everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RefractiveIndex {
    /// In the middle of the spectrum.
    pub(super) ior: f64,
    /// Ratio of the indices for violet and red.
    pub(super) dispersion: f64,
}

/// The objects that a ray is inside of, in the order of entering; more than two are rare.
#[derive(Debug, Default)]
pub(super) struct Interiors(SmallVec<[Inside; 2]>);

impl Clone for Interiors {
    // What is derived goes element by element, and a copy of no bytes costs a call.
    #[inline]
    fn clone(&self) -> Self {
        match self.0[..] {
            [] => Self::default(),
            [only] => Self(SmallVec::from_buf_and_len([only; 2], 1)),
            [first, second] => Self(SmallVec::from_buf([first, second])),
            _ => Self(SmallVec::from_slice(&self.0)),
        }
    }
}

/// How a ray changes by crossing a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// It goes out of the object.
    pub(super) leaving: bool,
    /// On the side that it comes from; none outside of everything.
    behind: Option<RefractiveIndex>,
    /// On the side that it goes to.
    ahead: Option<RefractiveIndex>,
}

impl Crossing {
    /// Index behind over index ahead.
    pub(super) fn eta(&self) -> f64 {
        self.ratio(|index| index.ior)
    }

    /// The same ratio for dispersion.
    pub(super) fn dispersion(&self) -> f64 {
        self.ratio(|index| index.dispersion)
    }

    /// Between two objects POV-Ray holds it in single precision, but not where one side is air (measured).
    fn ratio(&self, of: impl Fn(RefractiveIndex) -> f64) -> f64 {
        match (self.behind, self.ahead) {
            (Some(behind), Some(ahead)) => f64::from((of(behind) / of(ahead)) as f32),
            (Some(behind), None) => of(behind),
            (None, Some(ahead)) => 1.0 / of(ahead),
            (None, None) => 1.0,
        }
    }
}

impl Interiors {
    /// Those of frame-level objects that contain a world point.
    pub(super) fn at(world: &World, point: DVec3) -> Self {
        let inside = |key: InteriorKey| {
            let interior = world.interior(key.interior);
            let index = RefractiveIndex { ior: interior.ior, dispersion: interior.dispersion };
            Inside { key, hollow: world.geometry.is_hollow(key), index }
        };
        Self(world.geometry.containing(point).into_iter().map(inside).collect())
    }

    /// Whether fog and rainbows go on here: no solid object is around.
    pub(super) fn are_hollow(&self) -> bool {
        self.0.iter().all(|inside| inside.hollow)
    }

    /// Goes through the surface of an object: into it, or out of it if the ray was inside.
    ///
    /// Leaving an object that was not entered last bends nothing. Source: section 8.1 of the shading facts (measured).
    pub(super) fn cross(&mut self, object: Inside) -> Crossing {
        let around = |list: &Self| list.0.last().map(|last| last.index);
        let Some(at) = self.position(&object) else {
            let behind = around(self);
            self.0.push(object);
            return Crossing { leaving: false, behind, ahead: Some(object.index) };
        };
        let was_last = at + 1 == self.0.len();
        self.0.remove(at);
        let ahead = around(self);
        Crossing { leaving: true, behind: if was_last { Some(object.index) } else { ahead }, ahead }
    }

    /// Goes through a surface along a direction, and through all that touch it there, as one: light that leaves glass where
    /// it touches water goes from the one into the other.
    pub(super) fn cross_at(
        &mut self,
        world: &World,
        surface: &Surface,
        (direction, kind): (DVec3, RayKind),
        scratch: &mut Scratch,
    ) -> Crossing {
        let first = self.cross(inside_of(world, surface));
        if !world.touching.is_at(surface.point) {
            return first;
        }
        let touching = world.geometry.passed_with(surface, direction, kind, scratch);
        touching
            .iter()
            .fold(first, |whole, other| Crossing { ahead: self.cross(inside_of(world, other)).ahead, ..whole })
    }

    /// Whether an object is among them.
    pub(super) fn hold(&self, object: &Inside) -> bool {
        self.position(object).is_some()
    }

    /// Index of the far side of an object's surface over that of the near side, for Fresnel's equations.
    ///
    /// Where the ray leaves an object that lies in another, this is the ratio that refraction uses; POV-Ray takes 1
    /// there and mirrors nothing.
    pub(super) fn relative_ior(&self, object: &Inside) -> f64 {
        let own = object.index.ior;
        let Some(last) = self.0.last() else { return own };
        match self.position(object) {
            None => own / last.index.ior,
            Some(0) if self.0.len() == 1 => 1.0 / own,
            Some(_) => last.index.ior / own,
        }
    }

    /// Whether an object is among them.
    pub(super) fn are_in(&self, object: &Inside) -> bool {
        self.position(object).is_some()
    }

    fn position(&self, object: &Inside) -> Option<usize> {
        self.0.iter().position(|inside| inside.key == object.key)
    }
}

/// What fills the object of a surface.
pub(super) fn inside_of(world: &World, surface: &Surface) -> Inside {
    let interior = world.interior(surface.interior.interior);
    let index = RefractiveIndex { ior: interior.ior, dispersion: interior.dispersion };
    Inside { key: surface.interior, hollow: surface.hollow, index }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiled::geometry::InteriorId;

    fn glass(number: u32, ior: f64) -> Inside {
        let key = InteriorKey { interior: InteriorId::new(number), instance: 0 };
        Inside { key, hollow: false, index: RefractiveIndex { ior, dispersion: 1.0 } }
    }

    fn check(inside: &mut Interiors, object: Inside, leaving: bool, eta: f64, n: usize) {
        let crossing = inside.cross(object);
        assert_eq!((crossing.leaving, crossing.eta(), inside.0.len()), (leaving, eta, n));
    }

    fn single(ratio: f64) -> f64 {
        f64::from(ratio as f32)
    }

    #[test]
    fn a_ray_enters_and_leaves_nested_objects() {
        let (glass, water) = (glass(1, 1.5), glass(2, 1.25));
        let mut inside = Interiors::default();
        assert_eq!(inside.relative_ior(&water), 1.25);
        check(&mut inside, water, false, 1.0 / 1.25, 1);
        assert_eq!(inside.relative_ior(&glass), 1.2);
        check(&mut inside, glass, false, single(1.25 / 1.5), 2);
        check(&mut inside, glass, true, single(1.5 / 1.25), 1);
        check(&mut inside, water, true, 1.25, 0);
    }

    #[test]
    fn leaving_the_outer_of_two_objects_first_bends_nothing() {
        let mut inside = Interiors::default();
        inside.cross(glass(1, 1.5));
        inside.cross(glass(2, 1.25));
        check(&mut inside, glass(1, 1.5), true, 1.0, 1);
    }
}
