//! `#fopen`, `#fclose`, `#read` and `#write`.

use super::cursor::{Cursor, Role};
use super::scope::Scopes;
use super::{Evaluator, Kept, Number, Place, Value};
use crate::diag::{SourceResult, Span, Topic};
use crate::imaging::Encoded;
use crate::scene::ImageFormat;
use crate::syntax::{Keyword, Position, Symbol, Token, TokenKind};
use rustc_hash::FxHashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A file that a scene opened.
#[derive(Debug)]
pub(super) enum OpenFile {
    /// For reading.
    Reading(Box<Cursor>),
    /// For writing.
    Writing(PathBuf),
}

/// Files that were read as a whole, so that each is read once for all statements that name it; what the scene writes
/// may change them.
#[derive(Debug, Default)]
pub(super) struct Binaries {
    /// By place and type.
    pub(super) pictures: FxHashMap<(PathBuf, ImageFormat), Arc<Encoded>>,
    /// By place.
    pub(super) fonts: FxHashMap<PathBuf, Arc<Vec<u8>>>,
}

/// How `#write` lays out integers.
#[derive(Clone, Copy, Debug)]
struct BinaryFormat {
    bytes: usize,
    signed: bool,
    big_endian: bool,
}

impl Evaluator<'_> {
    /// `#fopen NAME S read|write|append`.
    pub(super) fn open_file(&mut self, span: Span) -> SourceResult<()> {
        let (handle, handle_span) = self.new_name()?;
        if self.scopes.find(handle).is_some() {
            return self.error(handle_span, "this name is already declared; a file needs a new one");
        }
        let name = self.file_name()?;
        let file = if self.accept_word(Keyword::Read)? {
            let (path, text) = self.text_to_read(&name, span)?;
            let source = self.take_in(&path, text)?;
            OpenFile::Reading(Box::new(Cursor::new(source, (Position::default(), None), Role::Data)))
        } else {
            let append = self.accept_word(Keyword::Append)?;
            if !append && !self.accept_word(Keyword::Write)? {
                return self.expected("read, write or append");
            }
            let path = PathBuf::from(&*name);
            self.binaries = Binaries::default();
            let opened = if append { self.host.append(&path, &[]) } else { self.host.create(&path) };
            match opened {
                Ok(Kept::OnDisk) => {}
                Ok(Kept::InMemory) => self.warn_of_memory(&path, span),
                Err(error) => return self.error(span, format!("cannot write {}: {error}", path.display())),
            }
            OpenFile::Writing(path)
        };
        let number = self.files.iter().position(Option::is_none).unwrap_or(self.files.len());
        if number == self.files.len() {
            self.files.push(None);
        }
        self.files[number] = Some(file);
        self.scopes.bind(Scopes::GLOBAL, handle, Place::new(Value::File(number)));
        Ok(())
    }

    /// What `#fopen … read` finds under a name.
    fn text_to_read(&mut self, name: &str, span: Span) -> SourceResult<(PathBuf, Vec<u8>)> {
        let Some(path) = self.find_file(name, &[]) else {
            return self.error(span, format!("cannot find the file '{name}'"));
        };
        let text = self.bytes_of(&path, span)?;
        Ok((path, text))
    }

    /// Where a scene may not write, what it writes stays in memory, for it to read again.
    fn warn_of_memory(&mut self, path: &Path, span: Span) {
        let name = path.display();
        self.warn(
            Topic::Files,
            span,
            format!("{name} is kept in memory only: scenes may write to a folder after --allow-write DIR"),
        );
    }

    fn accept_word(&mut self, word: Keyword) -> SourceResult<bool> {
        let found = self.fill(true)? == TokenKind::Keyword(word);
        if found {
            self.take();
        }
        Ok(found)
    }

    /// `#fclose NAME`; a name that is not an open file is ignored.
    pub(super) fn close_file(&mut self) -> SourceResult<()> {
        let (handle, _) = self.new_name()?;
        if let Some(Value::File(number)) = self.scopes.find(handle).and_then(Place::get) {
            self.files[number] = None;
            self.scopes.unbind(handle);
        }
        Ok(())
    }

    /// The open file whose name comes next.
    fn file_handle(&mut self) -> SourceResult<(Symbol, usize)> {
        if let TokenKind::Name(handle) = self.fill(false)?
            && let Some(Value::File(number)) = self.scopes.find(handle).and_then(Place::get)
        {
            self.take();
            return Ok((handle, number));
        }
        self.expected("the name of an open file")
    }

    /// `#write(H, items)`.
    pub(super) fn write_file(&mut self, span: Span) -> SourceResult<()> {
        let bytes = self.arguments(|e| {
            let (_, number) = e.file_handle()?;
            let Some(Some(OpenFile::Writing(path))) = e.files.get(number) else {
                return e.error(span, "this file is open for reading");
            };
            let path = path.clone();
            let mut bytes = Vec::new();
            e.comma()?;
            let mut format = None;
            while !e.at_punct(')')? {
                if e.accept_punct(',')? {
                    format = None;
                } else if let Some(binary) = e.keyword()?.and_then(binary_format) {
                    e.take();
                    format = Some(binary);
                } else if e.starts_string()? {
                    // Written characters beyond ASCII become blanks, as in POV-Ray.
                    let text = e.string()?;
                    bytes.extend(text.chars().map(|c| if c.is_ascii() { c as u8 } else { b' ' }));
                } else if let Some(binary) = format {
                    binary.put(e.float()?, &mut bytes);
                } else {
                    let value = e.any_expression()?;
                    bytes.extend(Self::written(&value).bytes());
                }
            }
            Ok((path, bytes))
        })?;
        self.binaries = Binaries::default();
        match self.host.append(&bytes.0, &bytes.1) {
            Ok(Kept::OnDisk) => Ok(()),
            Ok(Kept::InMemory) => {
                self.n_kept += bytes.1.len();
                // A file is many strings: mesh cameras write a hundred megabytes.
                let limit = self.options.limits.string_bytes.saturating_mul(16);
                if self.n_kept > limit {
                    return self.limit(span, format!("more than {limit} bytes written"), "string_bytes");
                }
                Ok(())
            }
            Err(error) => self.error(span, format!("cannot write {}: {error}", bytes.0.display())),
        }
    }

    /// `#read(H, names)`.
    pub(super) fn read_file(&mut self, span: Span) -> SourceResult<()> {
        self.arguments(|e| {
            let (handle, number) = e.file_handle()?;
            if !matches!(e.files.get(number), Some(Some(OpenFile::Reading(_)))) {
                return e.error(span, "this file is open for writing");
            }
            let mut at_end = false;
            loop {
                e.comma()?;
                if e.fill(true)? == TokenKind::Punct(')') {
                    break;
                }
                let (name, name_span) = e.new_name()?;
                let place = e.place_after(name, name_span)?;
                if at_end {
                    continue;
                }
                match e.datum(number, span)? {
                    None => {}
                    Some(value) => match place {
                        Some(place) => e.store_datum(&place, value, name_span)?,
                        None => e.scopes.bind(Scopes::GLOBAL, name, Place::new(value)),
                    },
                }
                // The token behind a datum is taken whatever it is.
                at_end = e.data_token(number)?.is_none();
            }
            if at_end {
                e.files[number] = None;
                e.scopes.unbind(handle);
            }
            Ok(())
        })
    }

    fn store_datum(&mut self, place: &Place, value: Value, span: Span) -> SourceResult<()> {
        match place.get() {
            None | Some(Value::Float(_) | Value::Vector(_) | Value::String(_)) => {
                place.set(Some(value));
                Ok(())
            }
            Some(other) => {
                let kind = other.kind();
                self.error(span, format!("data cannot be read into a {kind}"))
            }
        }
    }

    /// A signed number, a vector of signed numbers or a string; `None` at the end.
    fn datum(&mut self, number: usize, span: Span) -> SourceResult<Option<Value>> {
        let Some(token) = self.data_token(number)? else { return Ok(None) };
        match token.kind {
            TokenKind::String => Ok(Some(Value::String(self.decode(token.span)?))),
            TokenKind::Vector => Ok(Some(Value::from(Number { n: self.literal.1, v: self.literal.0 }))),
            TokenKind::Punct('<') => self.data_vector(number, span).map(Some),
            _ => self.data_number(number, token, span).map(|f| Some(Value::Float(f))),
        }
    }

    fn data_vector(&mut self, number: usize, span: Span) -> SourceResult<Value> {
        let mut value = Number { n: 0, v: [0.0; 5] };
        loop {
            match self.data_token(number)? {
                Some(Token { kind: TokenKind::Punct('>'), .. }) if value.n > 1 => return Ok(Value::from(value)),
                Some(Token { kind: TokenKind::Punct(','), .. }) if value.n > 0 => {}
                Some(token) if value.n < 5 => {
                    value.v[value.n as usize] = self.data_number(number, token, span)?;
                    value.n += 1;
                }
                Some(token) => return self.error(token.span, "a vector in a data file has two to five numbers"),
                None => return self.error(span, "the data file ends inside of a vector"),
            }
        }
    }

    fn data_number(&mut self, number: usize, first: Token, span: Span) -> SourceResult<f64> {
        let (mut token, mut sign) = (first, 1.0);
        while let TokenKind::Punct(c @ ('-' | '+')) = token.kind {
            sign = if c == '-' { -sign } else { sign };
            match self.data_token(number)? {
                Some(next) => token = next,
                None => return self.error(span, "the data file ends behind a sign"),
            }
        }
        match token.kind {
            TokenKind::Number(value) => Ok(sign * value),
            _ => self.error(token.span, "a data file holds numbers, vectors and strings, separated by commas"),
        }
    }

    /// The next token of a data file.
    fn data_token(&mut self, number: usize) -> SourceResult<Option<Token>> {
        let Some(Some(OpenFile::Reading(cursor))) = self.files.get_mut(number) else { return Ok(None) };
        match cursor.step(&mut self.names, &mut self.literal) {
            Some(Token { kind: TokenKind::Bad(what), span }) => self.error(span, what.message()),
            token => Ok(token),
        }
    }
}

fn binary_format(word: Keyword) -> Option<BinaryFormat> {
    let format = |bytes, signed, big_endian| Some(BinaryFormat { bytes, signed, big_endian });
    match word {
        Keyword::Sint8 => format(1, true, false),
        Keyword::Uint8 => format(1, false, false),
        Keyword::Sint16be => format(2, true, true),
        Keyword::Sint16le => format(2, true, false),
        Keyword::Uint16be => format(2, false, true),
        Keyword::Uint16le => format(2, false, false),
        Keyword::Sint32be => format(4, true, true),
        Keyword::Sint32le => format(4, true, false),
        _ => None,
    }
}

impl BinaryFormat {
    /// Rounded half up and clamped to what fits.
    fn put(self, value: f64, bytes: &mut Vec<u8>) {
        let bits = 8 * self.bytes as u32;
        let (low, high) = match self.signed {
            true => (-(1_i64 << (bits - 1)), (1_i64 << (bits - 1)) - 1),
            false => (0, (1_i64 << bits) - 1),
        };
        let rounded = ((value + 0.5).floor() as i64).clamp(low, high);
        let little = rounded.to_le_bytes();
        let part = &little[..self.bytes];
        if self.big_endian { bytes.extend(part.iter().rev()) } else { bytes.extend(part) }
    }
}
