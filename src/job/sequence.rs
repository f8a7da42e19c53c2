//! Pieces of work one after the other, several at once, told of in order.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

/// Address space for each piece that is under way, of which only what is used costs anything: scenes may nest deeply.
const STACK: usize = 256 << 20;

/// Does pieces of work 0 to n, one at a time until one says how many of its like keep all cores busy, then so many.
///
/// `work` is told whether it is the only one at work; results come to `done` in order, on this thread.
pub fn measured_in_order<T: Send>(
    n: usize,
    work: impl Fn(usize, bool) -> (T, Option<usize>) + Sync,
    mut done: impl FnMut(usize, T) -> bool,
) {
    let (mut first, mut measured) = (0, None);
    while first < n && measured.is_none() {
        let (result, at_once) = work(first, true);
        if !done(first, result) {
            return;
        }
        (first, measured) = (first + 1, at_once);
    }
    let at_once = measured.unwrap_or(1);
    in_order(n - first, at_once, |i| work(first + i, at_once == 1).0, |i, result| done(first + i, result));
}

/// Does pieces of work 0 to n, up to `at_once` at the same time, and hands each result to `done` in order.
///
/// `done` runs on this thread and says whether to go on; what is under way then is finished and dropped.
fn in_order<T: Send>(
    n: usize,
    at_once: usize,
    work: impl Fn(usize) -> T + Sync,
    mut done: impl FnMut(usize, T) -> bool,
) {
    let next = AtomicUsize::new(0);
    let take = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|piece| *piece < n);
    std::thread::scope(|scope| {
        let (sender, receiver) = mpsc::sync_channel(at_once);
        let helper = |sender: mpsc::SyncSender<(usize, T)>| {
            let (take, work) = (&take, &work);
            move || {
                while let Some(piece) = take() {
                    if sender.send((piece, work(piece))).is_err() {
                        break;
                    }
                }
            }
        };
        let helpers = at_once.min(n);
        let started = if helpers > 1 {
            let start = |_: &usize| {
                std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, helper(sender.clone())).is_ok()
            };
            (0..helpers).take_while(start).count()
        } else {
            0
        };
        drop(sender);
        // One at a time needs no thread, nor does a system that gives none.
        if started == 0 {
            while let Some(piece) = take() {
                if !done(piece, work(piece)) {
                    break;
                }
            }
        }
        hand_over(receiver, &mut done);
    });
}

/// Results come in any order and are kept until it is their turn.
///
/// Takes the receiver, so that whoever has a result left learns that nobody wants it.
fn hand_over<T>(receiver: mpsc::Receiver<(usize, T)>, done: &mut impl FnMut(usize, T) -> bool) {
    let (mut early, mut turn) = (BTreeMap::new(), 0);
    for (piece, result) in receiver {
        early.insert(piece, result);
        while let Some(result) = early.remove(&turn) {
            if !done(turn, result) {
                return;
            }
            turn += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    fn check(n: usize, at_once: usize, until: usize) {
        let mut told = Vec::new();
        let slow_first = |piece: usize| {
            std::thread::sleep(Duration::from_millis(if piece.is_multiple_of(3) { 3 } else { 0 }));
            piece * piece
        };
        in_order(n, at_once, slow_first, |piece, square| {
            told.push((piece, square));
            piece < until
        });
        let expected: Vec<_> = (0..n.min(until + 1)).map(|piece| (piece, piece * piece)).collect();
        assert_eq!(told, expected, "{at_once} at once");
    }

    #[test]
    fn pieces_are_done_alone_until_one_is_measured() {
        let alone = AtomicUsize::new(0);
        let work = |piece: usize, is_alone: bool| {
            alone.fetch_add(usize::from(is_alone), Ordering::Relaxed);
            (piece, (piece == 2).then_some(4))
        };
        let mut told = Vec::new();
        measured_in_order(9, work, |piece, result| {
            told.push((piece, result));
            true
        });
        assert_eq!(told, (0..9).map(|piece| (piece, piece)).collect::<Vec<_>>());
        assert_eq!(alone.into_inner(), 3);
    }

    #[test]
    fn results_come_in_order() {
        for at_once in [1, 2, 7] {
            check(20, at_once, 20);
            check(20, at_once, 4);
            check(1, at_once, 9);
            check(0, at_once, 9);
        }
    }
}
