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
    /// By base: its index and how many statements have it.
    known: FxHashMap<Arc<str>, [u32; 2]>,
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
        let entry = match self.known.get_mut(base) {
            Some(entry) => entry,
            None => {
                let base: Arc<str> = base.into();
                self.labels.bases.push(Arc::clone(&base));
                self.known.entry(base).or_insert([self.labels.bases.len() as u32 - 1, 0])
            }
        };
        let id = self.labels.statements.push(*entry);
        entry[1] += 1;
        self.statement.id = Some(id);
        id
    }

    /// All names.
    pub(super) fn finish(self) -> Labels {
        self.labels
    }
}
