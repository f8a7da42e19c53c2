//! Which statement of the scene an object belongs to, and what it is called.

use crate::compiled::Labels;
use crate::compiled::geometry::{ObjectId, StatementId};
use crate::scene::Object;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// The statement whose parts are being placed.
#[derive(Clone, Debug, Default)]
pub(super) struct Statement {
    /// A declared identifier; the outermost one stays.
    name: Option<Arc<str>>,
    kind: &'static str,
    /// Known as soon as a part was placed.
    id: Option<StatementId>,
}

/// Gives out object ids.
#[derive(Debug, Default)]
pub(super) struct Labeler {
    labels: Labels,
    statement: Statement,
    /// Indices of bases.
    known: FxHashMap<Arc<str>, usize>,
    /// How many statements have each base.
    counts: Vec<u32>,
    /// The base of the last statement: mostly that of the next.
    last: usize,
}

impl Labeler {
    /// Starts a frame-level statement.
    pub(super) fn begin(&mut self, object: &Object) {
        self.statement = Statement { name: object.name.clone(), kind: object.shape.kind(), id: None };
    }

    /// Goes into a part of a statement, which is one of its own if it is the first to have a name; gives back
    /// what to [`leave`](Self::leave) with.
    pub(super) fn enter(&mut self, object: &Object) -> Option<Statement> {
        if self.statement.name.is_some() || object.name.is_none() {
            return None;
        }
        let inner = Statement { name: object.name.clone(), kind: object.shape.kind(), id: None };
        Some(std::mem::replace(&mut self.statement, inner))
    }

    /// Goes back to the statement around.
    pub(super) fn leave(&mut self, outer: Option<Statement>) {
        if let Some(outer) = outer {
            self.statement = outer;
        }
    }

    /// The id of a new object within the current statement.
    pub(super) fn object_id(&mut self) -> ObjectId {
        let statement = match self.statement.id {
            Some(statement) => statement,
            None => self.new_statement(),
        };
        self.labels.statement_of.push(statement)
    }

    fn new_statement(&mut self) -> StatementId {
        let base = self.statement.name.as_deref().unwrap_or(self.statement.kind);
        if self.labels.bases.get(self.last).is_none_or(|last| **last != *base) {
            self.last = match self.known.get(base) {
                Some(index) => *index,
                None => {
                    let base: Arc<str> = base.into();
                    self.labels.bases.push(Arc::clone(&base));
                    self.known.insert(base, self.counts.len());
                    self.counts.push(0);
                    self.counts.len() - 1
                }
            };
        }
        let count = &mut self.counts[self.last];
        let id = self.labels.statements.push([self.last as u32, *count]);
        *count += 1;
        self.statement.id = Some(id);
        id
    }

    /// All names.
    pub(super) fn finish(self) -> Labels {
        self.labels
    }
}
