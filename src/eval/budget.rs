//! What a scene has used up, held against its limits.
//!
//! ```text
//! budget.step() -> Ok, or Exceeded { limit: "steps", message: "more than 5 turns of loops and macro calls" }
//! ```

use super::Limits;

/// Turns and calls after which there may be something to say.
const NOTEWORTHY: u64 = 1 << 20;

/// Counts what a scene uses up.
#[derive(Debug)]
pub(super) struct Budget {
    limits: Limits,
    /// Turns of loops and macro calls so far.
    steps: u64,
    objects: usize,
    /// Bytes that were written and are kept in memory.
    written: usize,
    /// Braces, parentheses and directives that are open.
    nesting: usize,
    includes: usize,
    macros: usize,
}

/// A limit that was met.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Exceeded {
    /// The field of [`Limits`].
    pub(super) limit: &'static str,
    pub(super) message: String,
}

/// Nothing, or a limit that was met.
pub(super) type Within<T = ()> = Result<T, Exceeded>;

#[cold]
fn exceeded<T>(limit: &'static str, message: String) -> Within<T> {
    Err(Exceeded { limit, message })
}

impl Budget {
    /// Nothing is used up yet.
    pub(super) fn new(limits: Limits) -> Self {
        Self { limits, steps: 0, objects: 0, written: 0, nesting: 0, includes: 0, macros: 0 }
    }

    /// Counts a turn of a loop or a macro call; true if there have been so many that there may be something to say.
    #[inline]
    pub(super) fn step(&mut self) -> Within<bool> {
        self.steps += 1;
        let limit = self.limits.steps;
        if self.steps > limit {
            return exceeded("steps", format!("more than {limit} turns of loops and macro calls"));
        }
        Ok(self.steps.is_multiple_of(NOTEWORTHY))
    }

    /// Turns and calls so far.
    pub(super) fn steps(&self) -> u64 {
        self.steps
    }

    /// Counts an object.
    pub(super) fn object(&mut self) -> Within {
        self.objects += 1;
        let limit = self.limits.objects;
        if self.objects > limit {
            return exceeded("objects", format!("more than {limit} objects"));
        }
        Ok(())
    }

    /// Counts bytes that are written and kept in memory.
    pub(super) fn write(&mut self, n_bytes: usize) -> Within {
        self.written += n_bytes;
        // A file is many strings: mesh cameras write a hundred megabytes.
        let limit = self.limits.string_bytes.saturating_mul(16);
        if self.written > limit {
            return exceeded("string_bytes", format!("more than {limit} bytes written"));
        }
        Ok(())
    }

    /// Counts one more level of nesting.
    #[inline]
    pub(super) fn deeper(&mut self) -> Within {
        self.nesting += 1;
        let limit = self.limits.nesting;
        if self.nesting > limit {
            return exceeded("nesting", format!("more than {limit} levels of braces and parentheses"));
        }
        Ok(())
    }

    /// One level less.
    #[inline]
    pub(super) fn shallower(&mut self) {
        self.nesting = self.nesting.saturating_sub(1);
    }

    /// The levels inside something that is complete, if they are not too many; declarations build them without nesting
    /// any text.
    #[inline]
    pub(super) fn levels(&self, depth: u32) -> Within<u32> {
        let limit = self.limits.nesting;
        if depth as usize > limit {
            return exceeded("nesting", format!("more than {limit} levels inside one another"));
        }
        Ok(depth)
    }

    /// Counts an include file that is opened.
    pub(super) fn enter_include(&mut self) -> Within {
        self.includes += 1;
        let limit = self.limits.include_depth;
        if self.includes > limit {
            return exceeded("include_depth", format!("more than {limit} include files inside one another"));
        }
        Ok(())
    }

    /// The innermost include file ends.
    pub(super) fn leave_include(&mut self) {
        self.includes = self.includes.saturating_sub(1);
    }

    /// Counts a macro that is called.
    #[inline]
    pub(super) fn enter_macro(&mut self) -> Within {
        self.macros += 1;
        let limit = self.limits.macro_depth;
        if self.macros > limit {
            return exceeded("macro_depth", format!("more than {limit} macro calls inside one another"));
        }
        Ok(())
    }

    /// The innermost macro ends.
    #[inline]
    pub(super) fn leave_macro(&mut self) {
        self.macros = self.macros.saturating_sub(1);
    }

    /// Macro calls running.
    #[inline]
    pub(super) fn macros(&self) -> usize {
        self.macros
    }

    /// Whether an array, a picture or a list of anything, which messages call so, may have that many elements.
    pub(super) fn elements(&self, n: usize, what: &str, elements: &str) -> Within {
        let limit = self.limits.array_elements;
        if n > limit {
            return exceeded("array_elements", format!("this {what} has more than {limit} {elements}"));
        }
        Ok(())
    }

    /// Whether there may be another stream of random numbers beside so many.
    pub(super) fn random_stream(&self, n: usize) -> Within {
        if n >= self.limits.array_elements {
            return exceeded("array_elements", "too many random streams".into());
        }
        Ok(())
    }

    /// Whether a string may have that many bytes.
    pub(super) fn string(&self, n_bytes: usize) -> Within {
        let limit = self.limits.string_bytes;
        if n_bytes > limit {
            return exceeded("string_bytes", format!("this string is longer than {limit} bytes"));
        }
        Ok(())
    }

    /// Everything that was open in the scene file is left, behind an error.
    pub(super) fn leave_all(&mut self) {
        (self.nesting, self.macros) = (0, 0);
    }
}

#[cfg(test)]
mod tests {
    use super::{Budget, Exceeded, Within};
    use crate::eval::Limits;

    /// A budget of that much of everything.
    fn of(n: usize) -> Budget {
        let mut limits = Limits::default();
        for name in Limits::NAMES {
            assert!(limits.set(name, n as u64));
        }
        Budget::new(limits)
    }

    /// What is used up goes well twice, and then meets that limit.
    fn check(limit: &'static str, message: &str, mut use_up: impl FnMut(&mut Budget) -> Within) {
        let mut budget = of(2);
        assert_eq!((use_up(&mut budget), use_up(&mut budget)), (Ok(()), Ok(())), "{limit}");
        assert_eq!(use_up(&mut budget), Err(Exceeded { limit, message: message.into() }));
    }

    #[test]
    fn everything_is_counted_against_its_limit() {
        check("steps", "more than 2 turns of loops and macro calls", |b| b.step().map(|_| ()));
        check("objects", "more than 2 objects", Budget::object);
        check("nesting", "more than 2 levels of braces and parentheses", Budget::deeper);
        check("include_depth", "more than 2 include files inside one another", Budget::enter_include);
        check("macro_depth", "more than 2 macro calls inside one another", Budget::enter_macro);
        check("string_bytes", "more than 32 bytes written", |b| b.write(16));
    }

    #[test]
    fn what_is_left_counts_no_more() {
        let mut budget = of(1);
        for _ in 0..3 {
            assert_eq!((budget.deeper(), budget.enter_macro(), budget.enter_include()), (Ok(()), Ok(()), Ok(())));
            budget.shallower();
            budget.leave_macro();
            budget.leave_include();
        }
        assert!(budget.deeper().is_ok() && budget.enter_macro().is_ok());
        budget.leave_all();
        assert!(budget.deeper().is_ok() && budget.enter_macro().is_ok());
    }

    #[test]
    fn sizes_are_limited() {
        let budget = of(3);
        assert!(budget.elements(3, "array", "elements").is_ok() && budget.string(3).is_ok());
        assert_eq!(budget.string(4).map_err(|e| e.limit), Err("string_bytes"));
        let message = "this picture has more than 3 pixels".into();
        assert_eq!(budget.elements(4, "picture", "pixels"), Err(Exceeded { limit: "array_elements", message }));
        assert_eq!((budget.levels(3), budget.levels(4).is_ok()), (Ok(3), false));
        assert!(budget.random_stream(2).is_ok() && budget.random_stream(3).is_err());
    }

    #[test]
    fn a_million_steps_are_noteworthy() {
        let mut budget = Budget::new(Limits::default());
        let told: Vec<u64> = (1..=3 << 20).filter(|_| budget.step() == Ok(true)).collect();
        assert_eq!((told, budget.steps()), (vec![1 << 20, 2 << 20, 3 << 20], 3 << 20));
    }
}
