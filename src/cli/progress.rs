//! How a command's work comes along, and how it is stopped.

use super::messages;
use crate::imaging::pause_writing;
use crate::render::{Observer, Stage};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Shows how a picture comes along.
pub(super) struct Bar {
    pub(super) bar: ProgressBar,
    /// Whether the user wants no more, of a picture that is one at any time.
    pub(super) stopped: Option<Arc<AtomicBool>>,
}

impl Observer for Bar {
    fn entered(&self, stage: Stage) {
        self.bar.set_message(match stage {
            Stage::Photons => "photons",
            Stage::Radiosity => "radiosity",
            Stage::Picture => "picture",
        });
    }

    fn advanced(&self, done: usize, of: usize) {
        self.bar.set_length(of as u64);
        self.bar.set_position(done as u64);
    }

    fn cancels(&self) -> bool {
        self.stopped.as_ref().is_some_and(|stopped| stopped.load(Ordering::Relaxed))
    }
}

/// A flag that the first interrupt raises, as by Ctrl-C; the second one ends the program.
pub(super) fn stop_on_interrupt() -> Arc<AtomicBool> {
    let stopped = Arc::new(AtomicBool::new(false));
    let raised = Arc::clone(&stopped);
    // Where there are no signals to be had, an interrupt ends the program as ever.
    let _ = ctrlc::set_handler(move || {
        if raised.swap(true, Ordering::Relaxed) {
            // What a shell calls a program that an interrupt has ended.
            std::process::exit(130);
        }
    });
    stopped
}

/// Ends the program on an interrupt; what is being written becomes whole before.
pub(super) fn end_on_interrupt() {
    let _ = ctrlc::set_handler(|| {
        let _whole = pause_writing();
        messages::line("stopped; --resume goes on from what is finished");
        // What a shell calls a program that an interrupt has ended.
        std::process::exit(130);
    });
}

/// Drawn only on a terminal.
pub(super) fn progress_bar(template: &str) -> ProgressBar {
    let target =
        if std::io::stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    let bar = ProgressBar::with_draw_target(Some(1), target);
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
