//! Numbers, scanned by hand: what the grammar sees of large lists is where they end.

use super::tree::{Node, Read, place};
use crate::diag::{Diagnostic, FileId, Span};
use crate::syntax::number;

/// A place in a run of numbers.
pub(super) struct Scanner<'t> {
    text: &'t [u8],
    at: usize,
    /// Where the run begins in the file.
    start: u32,
}

impl<'t> Scanner<'t> {
    pub(super) fn new(node: &Node<'t>) -> Self {
        Self { text: node.as_str().as_bytes(), at: 0, start: place(node).start }
    }

    /// Passes over blanks and comments.
    fn skip_blanks(&mut self) {
        loop {
            match self.text.get(self.at..).unwrap_or_default() {
                [b' ' | b'\n' | b'\t' | b'\r', ..] => self.at += 1,
                [b'/', b'/', rest @ ..] => {
                    self.at += 2 + rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len());
                }
                _ => return,
            }
        }
    }

    /// Passes over a sign, if it comes next.
    #[inline]
    pub(super) fn accept(&mut self, sign: u8) -> bool {
        self.skip_blanks();
        let found = self.text.get(self.at) == Some(&sign);
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, sign: u8) -> Read<()> {
        if self.accept(sign) { Ok(()) } else { self.expected(&format!("'{}'", char::from(sign))) }
    }

    /// An error at this place.
    pub(super) fn expected<T>(&self, what: &str) -> Read<T> {
        let at = self.start + self.at as u32;
        let end = at + u32::from(self.at < self.text.len());
        let span = Span { file: FileId(0), start: at, end };
        Err(Box::new(Diagnostic::error(span, format!("expected {what}"))))
    }

    /// Whether nothing more comes.
    pub(super) fn is_at_end(&mut self) -> bool {
        self.skip_blanks();
        self.at >= self.text.len()
    }

    #[inline]
    pub(super) fn number(&mut self) -> Read<f64> {
        self.skip_blanks();
        match number(self.text.get(self.at..).unwrap_or_default()) {
            Some((value, length)) => {
                self.at += length;
                Ok(value)
            }
            None => self.expected("a number"),
        }
    }

    /// How many entries follow, with the comma behind it.
    pub(super) fn count(&mut self) -> Read<usize> {
        let value = self.number()?;
        if !(0.0..4e9).contains(&value) || value.fract() != 0.0 {
            return self.expected("the count before this to be a whole number");
        }
        self.accept(b',');
        Ok(value as usize)
    }

    /// `<a, b, …>` of so many numbers.
    #[inline]
    pub(super) fn components<const N: usize>(&mut self) -> Read<[f64; N]> {
        let mut components = [0.0; N];
        self.expect(b'<')?;
        for (i, component) in components.iter_mut().enumerate() {
            if i > 0 {
                self.expect(b',')?;
            }
            *component = self.number()?;
        }
        self.expect(b'>')?;
        Ok(components)
    }

    /// `<a, b, …>` of any count.
    pub(super) fn vector(&mut self) -> Read<Vec<f64>> {
        let mut components = Vec::new();
        self.expect(b'<')?;
        loop {
            components.push(self.number()?);
            if !self.accept(b',') {
                self.expect(b'>')?;
                return Ok(components);
            }
        }
    }

    /// `n, <…>, …` to the end, each vector as `entry` takes it.
    pub(super) fn list<const N: usize, T>(&mut self, entry: impl Fn([f64; N]) -> T) -> Read<Vec<T>> {
        let n = self.count()?;
        // Each takes at least so many bytes, whatever the count says.
        let mut list = Vec::with_capacity(n.min(self.text.len() / (2 * N + 1)));
        for i in 0..n {
            if i > 0 {
                self.accept(b',');
            }
            list.push(entry(self.components()?));
        }
        if self.is_at_end() {
            Ok(list)
        } else {
            self.expected("the end of the list: it has as many entries as it says")
        }
    }

    /// `n, <a, b, c>, …` of whole numbers below `limit`.
    pub(super) fn indices(&mut self, limit: usize, what: &str) -> Read<Vec<[u32; 3]>> {
        let n = self.count()?;
        let mut list = Vec::with_capacity(n.min(self.text.len() / 7));
        for i in 0..n {
            if i > 0 {
                self.accept(b',');
            }
            list.push(self.three_indices(limit, what)?);
        }
        if self.is_at_end() {
            Ok(list)
        } else {
            self.expected("the end of the list: it has as many entries as it says")
        }
    }

    /// Three whole numbers below `limit`.
    #[inline]
    pub(super) fn three_indices(&mut self, limit: usize, what: &str) -> Read<[u32; 3]> {
        self.skip_blanks();
        let start = self.at;
        let three = self.components::<3>()?;
        let limit = limit as f64;
        if three.iter().all(|v| *v >= 0.0 && *v < limit && v.fract() == 0.0) {
            return Ok(three.map(|v| v as u32));
        }
        self.at = start;
        self.expected(&format!("indices of {what}, of which there are {limit}, numbered from 0"))
    }
}

impl Scanner<'_> {
    /// Whether a vector comes next.
    pub(super) fn is_at_vector(&mut self) -> bool {
        self.skip_blanks();
        self.text.get(self.at) == Some(&b'<')
    }
}
