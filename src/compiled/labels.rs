//! Names of objects and textures, for layers that tell them apart.

use super::handle::{ObjectId, StatementId, Table, TextureId};
use std::sync::Arc;

/// Finds the name of anything that a ray can meet.
///
/// An object is named by the identifier it was declared under, the outermost one where several apply,
/// or by its kind. The first of a name bears it alone, further ones have a number: `Chair`, `Chair.001`.
///
/// ```
/// use whitted::compiled::Labels;
/// use whitted::compiled::geometry::TextureId;
/// assert_eq!(Labels::default().texture(TextureId::new(7)), "texture.007");
/// ```
#[derive(Debug, Default)]
pub struct Labels {
    /// What stands before the number.
    pub bases: Vec<Arc<str>>,
    /// Of each statement, the position of its base and how many had it before.
    pub statements: Table<StatementId, [u32; 2]>,
    /// The statement that an object belongs to.
    pub statement_of: Table<ObjectId, StatementId>,
}

impl Labels {
    /// Which statement an object belongs to: all its parts are one thing to a user.
    pub fn statement(&self, id: ObjectId) -> StatementId {
        self.statement_of.get(id).copied().unwrap_or(StatementId::new(u32::MAX))
    }

    /// The name of a statement's object.
    pub fn object(&self, statement: StatementId) -> String {
        let found = self.statements.get(statement);
        let base = found.and_then(|[base, _]| self.bases.get(*base as usize));
        numbered(base.map_or("object", |b| b), found.map_or(statement.number(), |[_, number]| *number))
    }

    /// The name of a texture: textures are numbered in the order in which objects use them.
    pub fn texture(&self, id: TextureId) -> String {
        numbered("texture", id.number())
    }
}

fn numbered(base: &str, number: u32) -> String {
    if number == 0 { base.to_owned() } else { format!("{base}.{number:03}") }
}
