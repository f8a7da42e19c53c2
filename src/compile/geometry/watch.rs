//! What is only known about isosurfaces once the picture is made.

use super::POV_TINY;
use crate::compiled::geometry::SearchNotes;
use crate::diag::{Diagnostic, Span, Topic};
use std::sync::Arc;

/// An isosurface whose searches are watched; copies of an object share it.
#[derive(Clone, Debug)]
pub struct Watched {
    pub(super) span: Span,
    pub(super) notes: Arc<SearchNotes>,
    pub(super) max_gradient: f64,
    /// Searches believe `max_gradient`.
    pub(super) believes: bool,
    /// The file lets searches adapt the number.
    pub(super) adapts: bool,
}

impl Watched {
    /// What to say after rendering, as far as there is something to say.
    pub fn warning(&self) -> Option<Diagnostic> {
        let (given, found) = (self.max_gradient, self.notes.steepest());
        if self.adapts || given <= POV_TINY || found <= POV_TINY {
            return None;
        }
        let warning = |topic, text: &str| {
            let message = format!("max_gradient is {given:.3}, the steepest slope found is {found:.3}: {text}");
            Diagnostic::warning(topic, self.span, message)
        };
        if !self.believes {
            let hint = "`--isosurface-search povray` leaves them out, too";
            // Rays that graze a surface by less than `accuracy` are lost to POV-Ray whatever the number.
            return (self.notes.lost() && found > given).then(|| {
                warning(Topic::Geometry, "POV-Ray loses parts of this isosurface, which are shown here").hint(hint)
            });
        }
        // POV-Ray's own limits (function facts, section 9.4).
        let (gap, ratio) = (given - found, given / found);
        if ratio <= 0.9 && gap <= -0.5 || (ratio <= 0.95 || gap <= -0.1) && given < 10.0 {
            return Some(warning(Topic::Geometry, "the isosurface may have holes"));
        }
        let generous = gap >= 10.0 || ratio >= 1.1 && gap >= 0.5;
        generous.then(|| warning(Topic::Cost, "a lower number renders faster"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::{Queries, compile};
    use crate::eval::{Memory, Options, evaluate};

    fn check(given: f64, found: f64, believes: bool, expected: Option<&str>) {
        let notes = Arc::new(SearchNotes::default());
        notes.add(found, !believes && found > given);
        let watched = Watched { span: Span::default(), notes, max_gradient: given, believes, adapts: false };
        let message = watched.warning().map(|w| w.message);
        assert_eq!(message.as_ref().map(|m| m.split(": ").nth(1).unwrap_or_default()), expected);
    }

    #[test]
    fn messages_follow_povrays_limits() {
        let (holes, faster) = (Some("the isosurface may have holes"), Some("a lower number renders faster"));
        check(1.1, 1.1, true, None);
        check(1.1, 2.0, true, holes);
        check(1.1, 1.19, true, holes);
        check(20.0, 20.6, true, None);
        check(20.0, 24.0, true, holes);
        check(2.0, 1.4, true, faster);
        check(100.0, 95.0, true, None);
        check(100.0, 89.0, true, faster);
        check(1.1, 2.0, false, Some("POV-Ray loses parts of this isosurface, which are shown here"));
        check(5.0, 2.0, false, None);
    }
    #[test]
    fn isosurfaces_of_one_statement_come_in_their_order() {
        let text = "#version 3.7; #for (I, 1, 50) isosurface { function { x } max_gradient I } #end";
        let host = Memory::new([("a.pov", text)]);
        let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()).unwrap();
        let watched = compile(&read.scene).unwrap().watched;
        assert!(watched.len() == 50 && watched.iter().map(|w| w.max_gradient).is_sorted());
    }
}
