//! What height fields and textures share about pictures.

use crate::compiled::texture::Raster;
use crate::imaging::Encoded;
use crate::scene::{Function, Working};
use rustc_hash::FxHashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Rasters that were needed so far, in the working spaces that were asked for; copies of this share them, and so may
/// scenes that come one after the other.
#[derive(Clone, Debug, Default)]
pub struct Pictures(Arc<Mutex<Known>>);

/// By the address of what they were made from, which is kept so that its address stays its own.
type Known = FxHashMap<usize, Vec<Finished>>;

/// A raster with what it was made from.
#[derive(Debug)]
struct Finished {
    made: Making,
    raster: Arc<Raster>,
    /// By the scene that is compiled now.
    is_used: bool,
}

/// All that decides what a raster looks like.
#[derive(Clone, Debug)]
pub(super) enum Making {
    /// From a file, with these settings.
    File(Arc<Encoded>, Curve, Option<bool>),
    /// By sampling a function at so many places across and down.
    Function(Arc<Function>, [u32; 2]),
}

impl Making {
    fn address(&self) -> usize {
        match self {
            Self::File(file, ..) => Arc::as_ptr(file).addr(),
            Self::Function(function, _) => Arc::as_ptr(function).addr(),
        }
    }

    /// Whether the result is the same, where the addresses are.
    fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::File(_, curve, premultiplied), Self::File(_, other, same)) => {
                curve == other && premultiplied == same
            }
            (Self::Function(_, size), Self::Function(_, other)) => size == other,
            _ => false,
        }
    }
}

impl Pictures {
    /// A panic of another thread does not matter to plain data.
    fn known(&self) -> MutexGuard<'_, Known> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The raster that was made so before, or is made now.
    pub(super) fn raster(&self, made: Making, make: impl FnOnce(&Making) -> Raster) -> Arc<Raster> {
        let address = made.address();
        let find = |known: &mut Known| {
            let same = known.get_mut(&address)?.iter_mut().find(|finished| finished.made.is_like(&made))?;
            same.is_used = true;
            Some(Arc::clone(&same.raster))
        };
        if let Some(raster) = find(&mut self.known()) {
            return raster;
        }
        let raster = Arc::new(make(&made));
        let finished = Finished { made, raster: Arc::clone(&raster), is_used: true };
        self.known().entry(address).or_default().push(finished);
        raster
    }

    /// Another scene begins: what the last one did not need is dropped.
    pub fn begin_scene(&self) {
        self.known().retain(|_, finished| {
            finished.retain_mut(|finished| std::mem::take(&mut finished.is_used));
            !finished.is_empty()
        });
    }
}

/// How a file's value becomes a working value: decoded to linear light, then encoded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Curve {
    pub(super) decode: Option<Working>,
    pub(super) encode: Option<Working>,
}

/// The 16-bit level, 0 to 65535, in which a picture made by a function holds a value; outside 0 to 1 it wraps
/// around. Source: function facts, section 8.2.
pub(super) fn stored_level(value: f64) -> f64 {
    (f64::from(value as f32) * 65535.0).trunc().rem_euclid(65536.0)
}
