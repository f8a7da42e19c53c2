//! Who watches a picture sees it block by block, and may end it.

use super::*;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use whitted::render::{FinishedBlock, Observer};

/// Collects blocks and cancels when it has enough.
struct Watch {
    blocks: Mutex<Vec<FinishedBlock>>,
    enough: usize,
    most: AtomicUsize,
}

impl Observer for Watch {
    fn advanced(&self, done: usize, of: usize) {
        assert!(done <= of);
        self.most.fetch_max(1000 * done / of, Ordering::Relaxed);
    }

    fn finished(&self, block: &FinishedBlock) {
        self.blocks.lock().expect("no panic").push(block.clone());
    }

    fn wants_blocks(&self) -> bool {
        true
    }

    fn cancels(&self) -> bool {
        self.blocks.lock().expect("no panic").len() >= self.enough
    }
}

fn watched(antialias: Option<Antialias>, enough: usize) -> (Picture, bool, Watch) {
    let watch = Watch { blocks: Mutex::default(), enough, most: AtomicUsize::new(0) };
    let rendered = Session::new(2).picture(&world(SCENE), &small(antialias), &watch);
    (rendered.picture, rendered.complete, watch)
}

#[test]
fn blocks_are_parts_of_the_picture() {
    for way in ways() {
        let (picture, complete, watch) = watched(way, usize::MAX);
        assert!(complete && watch.most.into_inner() == 1000);
        let mut n = 0;
        for block in watch.blocks.into_inner().expect("no panic") {
            for (i, pixel) in block.pixels.iter().enumerate() {
                assert_eq!(*pixel, picture.pixel(block.x + i % block.width, block.y + i / block.width), "{way:?}");
            }
            n += block.pixels.len();
        }
        assert_eq!(n, picture.pixels.len());
    }
}

#[test]
fn whoever_watches_may_end_it() {
    let (picture, complete, _) = watched(None, 1);
    assert!(!complete && picture.pixels.contains(&[0.0, 0.0, 0.0, 1.0]));
}
