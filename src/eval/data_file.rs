//! Files of data that `#read` reads: numbers, vectors and strings, separated by commas.

use super::Number;
use super::feed::{Cursor, Literal};
use crate::diag::Span;
use crate::syntax::{Token, TokenKind, Words};

/// A file that is open for reading.
#[derive(Debug)]
pub(super) struct DataFile {
    cursor: Cursor,
    literal: Literal,
}

/// One of its values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Datum {
    Number(Number),
    /// The place of its literal.
    String(Span),
}

/// Where something is wrong, and what.
pub(super) type Wrong = (Span, &'static str);

impl DataFile {
    /// From the beginning.
    pub(super) fn new(cursor: Cursor) -> Self {
        Self { cursor, literal: Literal::default() }
    }

    /// A signed number, a vector of signed numbers or a string; `None` at the end. `asked` is where it is asked for.
    pub(super) fn datum(&mut self, words: &mut Words, asked: Span) -> Result<Option<Datum>, Wrong> {
        let Some(token) = self.token(words)? else { return Ok(None) };
        let number = match token.kind {
            TokenKind::String => return Ok(Some(Datum::String(token.span))),
            TokenKind::Vector => Number { n: self.literal.1, v: self.literal.0 },
            TokenKind::Punct('<') => self.vector(words, asked)?,
            _ => Number::scalar(self.number(token, words, asked)?),
        };
        Ok(Some(Datum::Number(number)))
    }

    fn vector(&mut self, words: &mut Words, asked: Span) -> Result<Number, Wrong> {
        let mut value = Number { n: 0, v: [0.0; 5] };
        loop {
            match self.token(words)? {
                Some(Token { kind: TokenKind::Punct('>'), .. }) if value.n > 1 => return Ok(value),
                Some(Token { kind: TokenKind::Punct(','), .. }) if value.n > 0 => {}
                Some(token) if value.n < 5 => {
                    value.v[value.n as usize] = self.number(token, words, asked)?;
                    value.n += 1;
                }
                Some(token) => return Err((token.span, "a vector in a data file has two to five numbers")),
                None => return Err((asked, "the data file ends inside of a vector")),
            }
        }
    }

    fn number(&mut self, first: Token, words: &mut Words, asked: Span) -> Result<f64, Wrong> {
        let (mut token, mut sign) = (first, 1.0);
        while let TokenKind::Punct(c @ ('-' | '+')) = token.kind {
            sign = if c == '-' { -sign } else { sign };
            match self.token(words)? {
                Some(next) => token = next,
                None => return Err((asked, "the data file ends behind a sign")),
            }
        }
        match token.kind {
            TokenKind::Number(value) => Ok(sign * value),
            _ => Err((token.span, "a data file holds numbers, vectors and strings, separated by commas")),
        }
    }

    /// The next token; `None` at the end.
    pub(super) fn token(&mut self, words: &mut Words) -> Result<Option<Token>, Wrong> {
        match self.cursor.step(words, &mut self.literal) {
            Some(Token { kind: TokenKind::Bad(what), span }) => Err((span, what.message())),
            token => Ok(token),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{DataFile, Datum};
    use crate::diag::{FileId, Span};
    use crate::eval::feed::{Cursor, Role};
    use crate::syntax::{Position, Source, Text, Words};
    use std::rc::Rc;
    use std::sync::Arc;

    /// The values of a text, each with the comma behind it, and what is wrong behind them.
    fn read(text: &str) -> (Vec<Vec<f64>>, Option<&'static str>) {
        let source = Source::new(FileId(0), Arc::new(Text::new(text.as_bytes().to_vec())));
        let mut file = DataFile::new(Cursor::new(Rc::new(source), (Position::default(), None), Role::Data));
        let (mut words, mut values) = (Words::default(), Vec::new());
        loop {
            match file.datum(&mut words, Span::default()) {
                Ok(Some(Datum::Number(number))) => values.push(number.v[..usize::from(number.n)].to_vec()),
                Ok(Some(Datum::String(span))) => values.push(vec![f64::from(span.start), f64::from(span.end)]),
                Ok(None) => return (values, None),
                Err((_, wrong)) => return (values, Some(wrong)),
            }
            match file.token(&mut words) {
                Ok(Some(_)) => {}
                _ => return (values, None),
            }
        }
    }

    #[test]
    fn data_are_numbers_vectors_and_strings() {
        let expected = vec![vec![1.0], vec![-2.5], vec![1.0, -2.0, 3.0], vec![21.0, 24.0], vec![4.0]];
        assert_eq!(read("1, --+-2.5, <1,-2,3>,\"a\", 4"), (expected, None));
        assert_eq!(read("<1, 2>, <3, 4>"), (vec![vec![1.0, 2.0], vec![3.0, 4.0]], None));
    }

    #[test]
    fn what_is_wrong_is_told() {
        let wrong = |text| read(text).1.unwrap_or_default();
        assert!(wrong("A").starts_with("a data file holds"));
        assert!(wrong("1, -").ends_with("behind a sign"));
        assert!(wrong("<1, -2").ends_with("inside of a vector"));
        assert!(wrong("<1,-2,3,4,5,6>").starts_with("a vector in a data file"));
    }
}
