//! `Rendered 1024 of 76800 pixels (1%)`, as callers read it.

use super::console::Console;
use crate::render::Observer;
use std::sync::Mutex;
use std::sync::PoisonError;
use std::time::{Duration, Instant};

/// How often a line is written: many times a second, as in POV-Ray, but not for every block of a small picture.
const INTERVAL: Duration = Duration::from_millis(20);

/// Tells how a picture comes along.
pub(super) struct Progress<'c> {
    console: &'c Console<'c>,
    is_wanted: bool,
    n_pixels: usize,
    last: Mutex<Option<Instant>>,
}

impl<'c> Progress<'c> {
    pub(super) fn new(console: &'c Console<'c>, is_wanted: bool, n_pixels: usize) -> Self {
        Self { console, is_wanted, n_pixels, last: Mutex::new(None) }
    }

    /// The last line; without it the picture is not finished.
    pub(super) fn finish(&self) {
        if self.is_wanted {
            self.console.plain(format!("{}\n", line(self.n_pixels, self.n_pixels)));
        }
    }
}

/// Ends with a carriage return, which lets the next one take its place.
fn line(done: usize, of: usize) -> String {
    format!("Rendered {done} of {of} pixels ({}%)\r", done * 100 / of.max(1))
}

impl Observer for Progress<'_> {
    fn advanced(&self, done: usize, of: usize) {
        if !self.is_wanted || !self.console.is_live() || done >= of {
            return;
        }
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if last.is_none_or(|last| last.elapsed() >= INTERVAL) {
            *last = Some(Instant::now());
            self.console
                .plain(line((done as u128 * self.n_pixels as u128 / of.max(1) as u128) as usize, self.n_pixels));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::line;

    #[test]
    fn lines_are_those_of_povray() {
        assert_eq!(line(1024, 76800), "Rendered 1024 of 76800 pixels (1%)\r");
        assert_eq!(line(48, 48), "Rendered 48 of 48 pixels (100%)\r");
    }
}
