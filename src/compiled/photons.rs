//! Photons as rays need them: what they are shot at, how densely, and what they may do where.
//!
//! Source: photon facts, sections 1 and 2 (measured).

use super::handle::{Handle as _, TargetId};
use super::light::Light;
use crate::math::Bounds;
use std::f64::consts::PI;

/// What objects and lights say about photons; `None` is not said.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PhotonRole {
    /// Photons go through.
    pub refraction: Option<bool>,
    /// Photons are mirrored.
    pub reflection: Option<bool>,
    /// Photons stay here.
    pub collect: Option<bool>,
    /// On their way to a target, photons go straight through.
    pub lets_pass: bool,
    /// The target that this is, or belongs to.
    pub target: Option<TargetId>,
}

impl PhotonRole {
    /// What a part says, completed by what contains it.
    #[must_use]
    pub fn within(self, outer: Self) -> Self {
        Self {
            refraction: self.refraction.or(outer.refraction),
            reflection: self.reflection.or(outer.reflection),
            collect: self.collect.or(outer.collect),
            lets_pass: self.lets_pass || outer.lets_pass,
            target: outer.target.or(self.target),
        }
    }

    /// Whether photons stay where this is said.
    pub fn collects(&self) -> bool {
        self.collect != Some(false)
    }

    /// Whether photons of a light go through where this is said.
    pub fn refracts(&self, light: &Self) -> bool {
        both_allow(self.refraction, light.refraction)
    }

    /// Whether photons of a light are mirrored where this is said.
    pub fn reflects(&self, light: &Self) -> bool {
        both_allow(self.reflection, light.reflection)
    }
}

/// One says that they may, and neither that they may not.
fn both_allow(one: Option<bool>, other: Option<bool>) -> bool {
    (one == Some(true) || other == Some(true)) && one != Some(false) && other != Some(false)
}

/// An object at which photons are shot.
#[derive(Clone, Copy, Debug)]
pub struct PhotonTarget {
    /// World space.
    pub bounds: Bounds,
    /// Factor of the distance of photons, above 0.
    pub spacing: f64,
    /// What it says.
    pub role: PhotonRole,
    /// Global lights shine on it.
    pub is_lit: bool,
}

/// How photons are shot and gathered.
#[derive(Clone, Debug)]
pub struct Photons {
    /// In the order of the scene.
    pub targets: Vec<PhotonTarget>,
    /// Distance of photons on their targets, scene units, above 0.
    pub spacing: f64,
    /// About how many to shoot, by which the spacing goes then.
    pub count: Option<u32>,
    /// Least and largest number of photons that make up the light at a point.
    pub gather: [usize; 2],
    /// Random shift in steps between photons.
    pub jitter: f64,
    /// Share of a target's radius from which on an empty ring ends the search.
    pub autostop: f64,
    /// Where few photons are near: how much denser a wider search may be to count.
    pub expand_increase: f64,
    /// Below how many photons it counts in any case.
    pub expand_minimum: usize,
    /// How far around a point of a surface photons are gathered, scene units; `None` for what their density suggests.
    pub radius: Option<f64>,
    /// Factor of what their density suggests.
    pub radius_factor: f64,
    /// How they are left in media, if they are.
    pub media: Option<MediaPhotons>,
    /// Surfaces a photon may meet.
    pub max_trace_level: u32,
    /// Weight below which a photon ends.
    pub adc_bailout: f32,
}

/// How photons are left in media, and gathered there.
#[derive(Clone, Copy, Debug)]
pub struct MediaPhotons {
    /// Most of them on the way from surface to surface, above 0.
    pub steps: u32,
    /// Their distance, in distances of photons, above 0.
    pub factor: f64,
    /// How far around a point they are gathered, scene units; `None` for what their density suggests.
    pub radius: Option<f64>,
    /// Factor of what their density suggests.
    pub radius_factor: f64,
}

impl Photons {
    /// Targets at which photons of a light are shot.
    pub fn targets_of(&self, light: &Light) -> impl Iterator<Item = (TargetId, &PhotonTarget)> {
        let said = light.photons;
        let is_shot_at = move |target: &PhotonTarget| {
            let goes_on = target.role.refracts(&said) || target.role.reflects(&said);
            target.is_lit && goes_on && target.bounds.is_finite()
        };
        let all = self.targets.iter().enumerate().map(|(i, target)| (TargetId::at(i), target));
        all.filter(move |(_, target)| !light.shadowless && is_shot_at(target))
    }

    /// About how many photons some lights shoot, at the spacing that is written.
    ///
    /// Source: photon facts, section 1; these are POV-Ray's guesses.
    pub fn estimate<'l>(&self, lights: impl Iterator<Item = &'l Light>) -> f64 {
        let of_target = |light: &Light, target: &PhotonTarget| {
            let (refracts, reflects) = (target.role.refracts(&light.photons), target.role.reflects(&light.photons));
            let factor = match (refracts, reflects, target.role.collects()) {
                (false, _, _) | (true, false, false) => 1.0,
                (true, false, true) => 2.0,
                (true, true, true) => 4.5,
                (true, true, false) => 1.5,
            };
            let radius = 0.5 * target.bounds.size().length();
            0.5 * PI * factor * (radius / (target.spacing * self.spacing)).powi(2)
        };
        lights.map(|light| self.targets_of(light).map(|(_, target)| of_target(light, target)).sum::<f64>()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_must_allow_and_none_forbid() {
        let said = [None, Some(true), Some(false)];
        let allowed = said.map(|one| said.map(|other| both_allow(one, other)));
        assert_eq!(allowed, [[false, true, false], [true, true, false], [false, false, false]]);
    }

    #[test]
    fn parts_belong_to_the_target_around_them() {
        let target = |number| PhotonRole { target: Some(TargetId::new(number)), ..PhotonRole::default() };
        let part = PhotonRole { reflection: Some(false), ..target(1) };
        let whole = PhotonRole { reflection: Some(true), refraction: Some(true), ..target(0) };
        let found = part.within(whole);
        assert_eq!((found.target, found.reflection, found.refraction), (whole.target, Some(false), Some(true)));
    }
}
