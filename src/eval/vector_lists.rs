//! Long lists of vectors, as meshes have them.

use super::Evaluator;
use crate::diag::SourceResult;
use crate::math::{DVec2, DVec3};
use crate::syntax::TokenKind;

#[allow(clippy::missing_errors_doc)]
impl Evaluator<'_> {
    /// `n` vectors with optional commas between and behind them.
    ///
    /// Literal vectors are read from the text as fast as their numbers can be parsed.
    pub fn vector_list(&mut self, n: usize) -> SourceResult<Vec<DVec3>> {
        self.list(n, |v, _| DVec3::new(v[0], v[1], v[2]), Self::vector)
    }

    /// `n` vectors of two components with optional commas between and behind them.
    pub fn vector2_list(&mut self, n: usize) -> SourceResult<Vec<DVec2>> {
        self.list(n, |v, _| DVec2::new(v[0], v[1]), Self::vector2)
    }

    fn list<T>(
        &mut self,
        n: usize,
        from_literal: impl Fn([f64; 5], u8) -> T,
        general: impl Fn(&mut Self) -> SourceResult<T>,
    ) -> SourceResult<Vec<T>> {
        /// A list may claim more than it holds, so memory is not reserved beyond this.
        const RESERVED: usize = 1 << 16;
        let mut list = Vec::with_capacity(n.min(RESERVED));
        while list.len() < n {
            if self.fill(false)? == TokenKind::Vector {
                let before = list.len();
                self.literals(n, &mut list, &from_literal);
                if list.len() > before {
                    self.comma()?;
                }
            }
            if list.len() < n {
                list.push(general(self)?);
                self.comma()?;
            }
        }
        Ok(list)
    }

    /// Reads whole literals while more literals follow; the last one of a run stays, since an
    /// operator may come behind it.
    fn literals<T>(&mut self, n: usize, list: &mut Vec<T>, from_literal: &impl Fn([f64; 5], u8) -> T) {
        let room = n - list.len();
        self.feed.take_vectors(room, |v, width| list.push(from_literal(v, width)));
    }
}
