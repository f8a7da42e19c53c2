//! Objects at which photons are shot, found while they are built.
//!
//! Source: photon facts, sections 1 and 2 (measured).

use super::LightGroup;
use super::builder::Builder;
use super::extent::extent;
use super::inherit::Context;
use crate::compile::photons::role;
use crate::compiled::geometry::{LightGroupId, PhotonRoleId};
use crate::compiled::photons::{PhotonRole, PhotonTarget};
use crate::compiled::{Table, TargetId};
use crate::scene::{Object, PhotonFlags};

/// Those found so far.
#[derive(Debug, Default)]
pub(super) struct Targets {
    found: Table<TargetId, (PhotonTarget, Option<LightGroupId>)>,
    /// The last of them: a part of a solid is visited twice.
    last: Option<*const Object>,
}

impl Targets {
    /// All that global lights shine on; the others are never met by a photon on its way to them.
    pub(super) fn finish(self, groups: &Table<LightGroupId, LightGroup>) -> Vec<PhotonTarget> {
        let is_lit = |group: Option<LightGroupId>| group.is_none_or(|group| groups[group].global_lights);
        let lit = |(target, group): &(PhotonTarget, _)| PhotonTarget { is_lit: is_lit(*group), ..*target };
        self.found.iter().map(lit).collect()
    }

    fn add(&mut self, object: &Object, around: &Context, spacing: f64, said: PhotonRole) -> TargetId {
        let bounds = around.group_from_parent.bounds(&extent(object));
        if let Some((id, (target, _))) = self.found.last()
            && self.last == Some(std::ptr::from_ref(object))
            && target.bounds == bounds
        {
            return id;
        }
        self.last = Some(object);
        self.found.push((PhotonTarget { bounds, spacing, role: said, is_lit: true }, around.light_group))
    }
}

impl Builder<'_> {
    /// What an object says about photons, completed by what contains it; nothing where none are shot.
    pub(super) fn photon_role(&mut self, object: &Object, around: &Context) -> Option<PhotonRoleId> {
        let targets = self.targets.as_mut()?;
        let flags = &object.rare.photons;
        if *flags == PhotonFlags::NONE {
            return around.photons;
        }
        let roles = &mut self.geometry.photon_roles;
        let outer = around.photons.map_or_else(PhotonRole::default, |id| roles[id]);
        let mut said = role(flags).within(outer);
        if let Some(spacing) = flags.target.filter(|spacing| *spacing > 0.0 && said.target.is_none()) {
            said.target = Some(targets.add(object, around, spacing, said));
        }
        Some(match roles.last() {
            Some((id, last)) if *last == said => id,
            _ => roles.push(said),
        })
    }
}
