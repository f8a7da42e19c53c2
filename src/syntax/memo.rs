//! What was found at the tokens of a piece, from the second time it is asked for.

use std::rc::Rc;

/// What is known of each place: things that are worth finding only where they are met again.
#[derive(Debug)]
pub(super) struct Memo<T> {
    /// For each token [`UNSEEN`], [`SEEN`], [`NONE`] or, from [`FIRST`] on, which of the list.
    known: Vec<u16>,
    list: Vec<Rc<T>>,
}

/// It was not asked for yet.
const UNSEEN: u16 = 0;
/// It was asked for once.
const SEEN: u16 = 1;
/// There is nothing.
const NONE: u16 = 2;
const FIRST: u16 = 3;

impl<T> Default for Memo<T> {
    fn default() -> Self {
        Self { known: Vec::new(), list: Vec::new() }
    }
}

impl<T> Memo<T> {
    /// What is at token number `at` of `n`; `find` looks for it, once.
    #[inline]
    pub(super) fn at(&mut self, at: usize, n: usize, find: impl FnOnce() -> Option<T>) -> Option<Rc<T>> {
        match self.known.get(at).copied() {
            Some(known @ FIRST..) => self.list.get(usize::from(known - FIRST)).cloned(),
            Some(NONE) => None,
            _ => self.meet(at, n, find),
        }
    }

    fn meet(&mut self, at: usize, n: usize, find: impl FnOnce() -> Option<T>) -> Option<Rc<T>> {
        if self.known.is_empty() {
            self.known = vec![UNSEEN; n];
        }
        let known = self.known.get_mut(at)?;
        if *known == UNSEEN {
            *known = SEEN;
            return None;
        }
        *known = NONE;
        let found = Rc::new(find()?);
        let index = u16::try_from(self.list.len()).ok().and_then(|n| n.checked_add(FIRST))?;
        *known = index;
        self.list.push(Rc::clone(&found));
        Some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn things_are_looked_for_at_the_second_meeting_and_kept() {
        let mut memo = Memo::default();
        assert!(memo.at(1, 3, || Some(5)).is_none());
        assert_eq!(memo.at(1, 3, || Some(5)).as_deref(), Some(&5));
        assert_eq!(memo.at(1, 3, || Some(6)).as_deref(), Some(&5));
        assert!(memo.at(2, 3, || Some(7)).is_none() && memo.at(2, 3, || None).is_none());
        assert!(memo.at(2, 3, || Some(7)).is_none(), "what is not there is not looked for again");
        assert!(memo.at(3, 3, || Some(8)).is_none() && memo.at(3, 3, || Some(8)).is_none());
    }
}
