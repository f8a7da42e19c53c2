//! Handles: what one thing of a compiled scene knows another by.
//!
//! Things stand in lists, a [`Table`] for each kind, and refer to each other by their numbers there. A number by itself
//! fits every list; a handle is a number that fits the tables of its kind alone. It takes four bytes, and an `Option`
//! of it no more.
//!
//! ```
//! use whitted::compiled::{Table, geometry::TextureId};
//! let mut names = Table::default();
//! let (oak, tin): (TextureId, TextureId) = (names.push("oak"), names.push("tin"));
//! assert_eq!((names[oak], names[tin]), ("oak", "tin"));
//! assert_eq!(size_of::<Option<TextureId>>(), 4);
//! ```

use std::fmt;
use std::marker::PhantomData;
use std::num::NonZeroU32;
use std::ops::{Index, IndexMut};

/// What a [`Table`] needs to know of its handles.
pub trait Handle: Copy {
    /// Of the entry at a position.
    fn at(position: usize) -> Self;

    /// The position of its entry.
    fn position(self) -> usize;
}

/// Makes a type of handle of each name.
macro_rules! handles {
    ($($(#[$doc:meta])* $visibility:vis struct $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(transparent)]
        // One more than the number, so that an `Option` takes no room.
        $visibility struct $name(NonZeroU32);

        impl $name {
            /// From its number; 2^32 - 1 is one too many and gives the number before.
            #[inline]
            $visibility const fn new(number: u32) -> Self {
                Self(NonZeroU32::MIN.saturating_add(number))
            }

            /// Its place in a table, from 0.
            #[inline]
            $visibility const fn number(self) -> u32 {
                self.0.get() - 1
            }
        }

        impl Handle for $name {
            #[inline]
            fn at(position: usize) -> Self {
                Self::new(position as u32)
            }

            #[inline]
            fn position(self) -> usize {
                self.number() as usize
            }
        }

        /// The first.
        impl Default for $name {
            fn default() -> Self {
                Self::new(0)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!(stringify!($name), "({})"), self.number())
            }
        }
    )*};
}

handles! {
    /// One of the textures that `compile` collected.
    pub struct TextureId;
    /// One of the interiors that `compile` collected, one for each object that owns one.
    pub struct InteriorId;
    /// A frame-level object (after union splitting), in file order.
    pub struct ObjectId;
    /// An object or light group as the scene file wrote it, whose parts are one thing to a user.
    pub struct StatementId;
    /// One of the light groups that `compile` collected.
    pub struct LightGroupId;
    /// An object at which photons are shot.
    pub struct TargetId;
    /// What objects say about photons.
    pub struct PhotonRoleId;
    /// A shape in its place.
    pub(crate) struct PrimitiveId;
    /// Objects that do not combine, shared by instances.
    pub(crate) struct GroupId;
    /// A shared group in one place.
    pub(crate) struct InstanceId;
    /// How an object appears.
    pub(crate) struct AppearanceId;
    /// A texture with its place.
    pub(crate) struct PlacementId;
    /// A part of a solid.
    pub(crate) struct NodeId;
}

/// A list of things, or of facts about them, that are known by handles.
pub struct Table<H, T> {
    entries: Vec<T>,
    handle: PhantomData<fn(H) -> H>,
}

impl<H: Handle, T> Table<H, T> {
    /// With room for so many.
    pub fn with_capacity(n: usize) -> Self {
        Self { entries: Vec::with_capacity(n), handle: PhantomData }
    }

    /// A handle and those after it.
    pub fn handles_from(&self, first: H) -> impl Iterator<Item = H> + use<H, T> {
        (first.position()..self.entries.len()).map(H::at)
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The handle that the next to be pushed will get.
    pub fn next_handle(&self) -> H {
        H::at(self.entries.len())
    }

    /// Adds one to the end.
    pub fn push(&mut self, entry: T) -> H {
        let handle = self.next_handle();
        self.entries.push(entry);
        handle
    }

    /// Leaves nothing from a handle on.
    pub fn truncate(&mut self, first: H) {
        self.entries.truncate(first.position());
    }

    /// The last entry with its handle.
    pub fn last(&self) -> Option<(H, &T)> {
        self.entries.last().map(|entry| (H::at(self.entries.len() - 1), entry))
    }

    /// What a handle stands for, if it is of this table.
    #[inline]
    pub fn get(&self, handle: H) -> Option<&T> {
        self.entries.get(handle.position())
    }

    /// All, in order.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.entries.iter()
    }
}

impl<H: Handle, T> Index<H> for Table<H, T> {
    type Output = T;

    #[inline]
    fn index(&self, handle: H) -> &T {
        &self.entries[handle.position()]
    }
}

impl<H: Handle, T> IndexMut<H> for Table<H, T> {
    #[inline]
    fn index_mut(&mut self, handle: H) -> &mut T {
        &mut self.entries[handle.position()]
    }
}

impl<H, T> Default for Table<H, T> {
    fn default() -> Self {
        Self { entries: Vec::new(), handle: PhantomData }
    }
}

impl<H, T: fmt::Debug> fmt::Debug for Table<H, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.entries.fmt(f)
    }
}

impl<H, T> FromIterator<T> for Table<H, T> {
    fn from_iter<I: IntoIterator<Item = T>>(entries: I) -> Self {
        Self { entries: entries.into_iter().collect(), handle: PhantomData }
    }
}

impl<H, T> IntoIterator for Table<H, T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.entries.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a number stands for in a table of three; it is told back as it was given.
    fn check(number: u32, expected: Option<&str>) {
        let names: Table<NodeId, _> = ["a", "b", "c"].into_iter().collect();
        let handle = NodeId::new(number);
        assert_eq!(names.get(handle).copied(), expected);
        assert_eq!((handle.number(), format!("{handle:?}")), (number, format!("NodeId({number})")));
    }

    #[test]
    fn a_handle_stands_for_the_entry_of_its_number() {
        check(0, Some("a"));
        check(2, Some("c"));
        check(3, None);
        check(u32::MAX - 1, None);
        assert_eq!(NodeId::new(u32::MAX), NodeId::new(u32::MAX - 1));
    }

    #[test]
    fn pushing_gives_the_handle_that_was_foretold() {
        let mut names: Table<NodeId, _> = ["a", "b"].into_iter().collect();
        let foretold = names.next_handle();
        assert_eq!((names.push("c"), names[foretold]), (foretold, "c"));
        assert_eq!(names.last(), Some((foretold, &"c")));
        assert_eq!(names.handles_from(NodeId::new(1)).collect::<Vec<_>>(), [NodeId::new(1), foretold]);
    }

    #[test]
    fn options_of_handles_take_no_room() {
        assert_eq!(size_of::<Option<NodeId>>(), 4);
        assert_eq!(size_of::<crate::compiled::geometry::Appearance>(), 40);
    }
}
