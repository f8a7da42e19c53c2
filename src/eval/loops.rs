//! `#while`, `#for` and `#end`.

use super::directives::{Block, BlockKind, ForLoop};
use super::expressions::{EPSILON, truth};
use super::{Evaluator, Place, Value};
use crate::diag::{SourceResult, Span};
use crate::syntax::Position;

impl Evaluator<'_> {
    /// Counts a turn of a loop or a macro call.
    pub(super) fn count_step(&mut self, span: Span) -> SourceResult<()> {
        let step = self.budget.step();
        if self.within(step, span)? {
            self.world.progress(&|| self.at_work(span));
        }
        Ok(())
    }

    /// What a scene is at that loops or calls macros for long.
    fn at_work(&self, span: Span) -> String {
        let place = |span: Span| self.report.place(span);
        let is_loop = |block: &&Block| matches!(block.kind, BlockKind::While { .. } | BlockKind::For(_));
        let loops = self.open_blocks.iter().filter(is_loop).map(|block| block.span);
        let outer = { loops }.find(|outer| *outer != span);
        let within = outer.map_or_else(String::new, |outer| format!(" within the loop at {}", place(outer)));
        format!("{}: still running{within}, {} turns and calls so far", place(span), self.budget.steps())
    }

    /// Counts an object.
    pub(super) fn count_object(&mut self, span: Span) -> SourceResult<()> {
        let object = self.budget.object();
        self.within(object, span)
    }

    pub(super) fn run_while(&mut self, span: Span) -> SourceResult<()> {
        let condition = self.feed.position();
        let holds = truth(self.condition()?);
        self.enter_while(holds, condition, span)
    }

    /// Runs the body of a loop whose condition was met at that place, or goes past it.
    pub(super) fn enter_while(&mut self, holds: bool, condition: Position, span: Span) -> SourceResult<()> {
        if holds {
            let cursor = self.feed.depth();
            self.open_blocks.push(Block { kind: BlockKind::While { cursor, condition }, span });
            Ok(())
        } else {
            self.skip_block(span)
        }
    }

    /// Whether the condition holds, where the `#while` before it was jumped to again.
    fn condition_again(&mut self) -> SourceResult<bool> {
        let known = self.feed.statement(1, |name| self.names.is_macro(name));
        if let Some((statement, start)) = known
            && self.feed.held().is_none()
            && self.version >= 350
            && let Some(holds) = self.condition_of(&statement, start)?
        {
            return Ok(holds);
        }
        self.condition().map(truth)
    }

    pub(super) fn run_for(&mut self, span: Span) -> SourceResult<()> {
        let values = self.bracketed('(', "before the loop's variable", ')', "behind the loop's values", |e| {
            let (name, _) = e.new_name()?;
            e.comma()?;
            let from = e.float()?;
            e.comma()?;
            let to = e.float()?;
            let step = if e.accept_punct(',')? || e.starts_expression()? { e.float()? } else { 1.0 };
            Ok((name, from, to, step))
        })?;
        let (name, from, to, step) = values;
        if !truth(step) {
            return self.error(span, "the step of a #for loop must not be zero");
        }
        let variable = match self.names.find_innermost(name).cloned() {
            Some(place) => {
                self.store(&place, Some(Value::Float(from)), span)?;
                place
            }
            None => {
                let place = Place::new(Value::Float(from));
                self.names.bind(self.names.innermost(), name, place.clone());
                place
            }
        };
        let running = ForLoop { cursor: self.feed.depth(), body: self.feed.position(), variable, end: to, step };
        if !running.goes_on(from) {
            return self.skip_block(span);
        }
        self.open_blocks.push(Block { kind: BlockKind::For(Box::new(running)), span });
        Ok(())
    }

    /// `#end`: leaves a branch, or goes back to the start of a loop.
    pub(super) fn run_end(&mut self, span: Span) -> SourceResult<()> {
        let floor = self.feed.innermost().map_or(0, |c| if c.is_macro() { c.blocks } else { 0 });
        if self.open_blocks.len() <= floor {
            return self.mismatched(span, "#end without anything to end");
        }
        let depth = self.feed.depth();
        match self.open_blocks.last().map(|block| (&block.kind, block.span)) {
            Some((BlockKind::While { cursor, condition }, opened)) => {
                let (started_in, condition) = (*cursor, *condition);
                self.check_same_file(started_in == depth, opened)?;
                self.count_step(opened)?;
                let after = self.feed.position();
                self.feed.jump(condition, &mut self.names.words);
                if !self.condition_again()? {
                    self.feed.jump(after, &mut self.names.words);
                    self.open_blocks.pop();
                }
                Ok(())
            }
            Some((BlockKind::For(running), opened)) => {
                self.check_same_file(running.cursor == depth, opened)?;
                let current = running.variable.with(|value| match value {
                    Some(Value::Float(f)) => Some(*f),
                    _ => None,
                });
                let Some(current) = current else {
                    return self.error(opened, "the variable of this #for loop was given another type");
                };
                let next = current + running.step;
                running.variable.set(Some(Value::Float(next)));
                let (body, goes_on) = (running.body, running.goes_on(next));
                if goes_on {
                    self.count_step(opened)?;
                    self.feed.jump(body, &mut self.names.words);
                } else {
                    self.open_blocks.pop();
                }
                Ok(())
            }
            _ => {
                self.open_blocks.pop();
                Ok(())
            }
        }
    }

    fn check_same_file(&self, same: bool, opened: Span) -> SourceResult<()> {
        if same { Ok(()) } else { self.error(opened, "this loop does not end in the file where it began") }
    }
}

impl ForLoop {
    /// Whether a turn follows for that value of the variable.
    fn goes_on(&self, value: f64) -> bool {
        if self.step > 0.0 { value <= self.end + EPSILON } else { value >= self.end - EPSILON }
    }
}

#[cfg(test)]
mod tests {
    use crate::eval::{Host, Kept, Memory, NoQueries, Options, Status, Stream, evaluate};
    use std::io;
    use std::path::Path;
    use std::sync::Mutex;

    /// A host that writes down what it is told of progress.
    struct Watching(Memory, Mutex<Vec<String>>);

    impl Host for Watching {
        fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
            self.0.read(path)
        }
        fn status(&self, path: &Path) -> Status {
            self.0.status(path)
        }
        fn create(&self, path: &Path) -> io::Result<Kept> {
            self.0.create(path)
        }
        fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<Kept> {
            self.0.append(path, bytes)
        }
        fn message(&self, stream: Stream, text: &str) {
            self.0.message(stream, text);
        }
        fn progress(&self, what: &dyn Fn() -> String) {
            self.1.lock().unwrap().push(what());
        }
    }

    #[test]
    fn long_loops_say_where_they_are() {
        let text =
            "#version 3.7;\n#for (I, 1, 2)\n#declare J = 0;\n#while (J < 700000)\n#declare J = J + 1;\n#end #end";
        let host = Watching(Memory::new([("a.pov", text)]), Mutex::default());
        assert!(evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries).is_ok());
        let told = host.1.into_inner().unwrap();
        let expected = "a.pov:4: still running within the loop at a.pov:2, 1048576 turns and calls so far";
        assert_eq!(told, [expected]);
    }
}
