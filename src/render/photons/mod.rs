//! Light that photons have carried from lights by way of glass and mirrors: where it arrived, and how much of it there is
//! around a point.
//!
//! [`Rings`] says where the photons of a light go that is to meet a target; `transport` follows them, and `shoot` keeps what
//! arrives in a [`PhotonMap`] before the picture begins.
//!
//! Source: H. W. Jensen, "Global Illumination using Photon Maps", Rendering Techniques 1996, for the idea;
//! docs/povray/photons.md (measured) for every rule.

mod gather;
mod map;
mod photon;
mod rings;

pub(super) use gather::{Gathered, Nearby, Spread};
pub(super) use map::PhotonMap;
pub(super) use photon::Photon;
pub(super) use rings::{Rings, Shot};

use crate::compiled::photons::Photons;

/// What all threads know once photons are shot.
#[derive(Debug)]
pub(super) struct Caught<'w> {
    pub(super) settings: &'w Photons,
    /// On surfaces.
    pub(super) map: PhotonMap,
    /// In media.
    pub(super) in_media: PhotonMap,
}
