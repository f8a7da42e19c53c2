//! `#fopen`, `#fclose`, `#read` and `#write`.

use super::data_file::{DataFile, Datum, Wrong};
use super::feed::{Cursor, Role};
use super::names::Names;
use super::world::OpenFile;
use super::{Evaluator, Kept, Place, Value};
use crate::diag::{SourceResult, Span, Topic};
use crate::syntax::{Keyword, Position, Symbol, TokenKind, Words};
use std::path::{Path, PathBuf};

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
        if self.names.find(handle).is_some() {
            return self.error(handle_span, "this name is already declared; a file needs a new one");
        }
        let name = self.file_name()?;
        let file = if self.accept_word(Keyword::Read)? {
            let (path, text) = self.text_to_read(&name, span)?;
            let source = self.take_in(&path, text)?;
            {
                let cursor = Cursor::new(source, (Position::default(), None), Role::Data);
                OpenFile::Reading(Box::new(DataFile::new(cursor)))
            }
        } else {
            let append = self.accept_word(Keyword::Append)?;
            if !append && !self.accept_word(Keyword::Write)? {
                return self.expected("read, write or append");
            }
            let path = PathBuf::from(&*name);
            match self.world.create(&path, append) {
                Ok(Kept::OnDisk) => {}
                Ok(Kept::InMemory) => self.warn_of_memory(&path, span),
                Err(error) => return self.error(span, format!("cannot write {}: {error}", path.display())),
            }
            OpenFile::Writing(path)
        };
        let number = self.world.keep(file);
        self.names.bind(Names::GLOBAL, handle, Place::new(Value::File(number)));
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
        if let Some(Value::File(number)) = self.names.get(handle) {
            self.world.close(number);
            self.names.unbind(handle);
        }
        Ok(())
    }

    /// The open file whose name comes next.
    fn file_handle(&mut self) -> SourceResult<(Symbol, usize)> {
        if let TokenKind::Name(handle) = self.fill(false)?
            && let Some(Value::File(number)) = self.names.get(handle)
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
            let Some(OpenFile::Writing(path)) = e.world.opened(number) else {
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
        match self.world.append(&bytes.0, &bytes.1) {
            Ok(Kept::OnDisk) => Ok(()),
            Ok(Kept::InMemory) => {
                let written = self.budget.write(bytes.1.len());
                self.within(written, span)
            }
            Err(error) => self.error(span, format!("cannot write {}: {error}", bytes.0.display())),
        }
    }

    /// `#read(H, names)`.
    pub(super) fn read_file(&mut self, span: Span) -> SourceResult<()> {
        self.arguments(|e| {
            let (handle, number) = e.file_handle()?;
            if !matches!(e.world.opened(number), Some(OpenFile::Reading(_))) {
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
                let value = match e.read_from(number, |file, words| file.datum(words, span))? {
                    None => None,
                    Some(Datum::Number(number)) => Some(Value::from(number)),
                    Some(Datum::String(span)) => Some(Value::String(e.decode(span)?)),
                };
                match (value, place) {
                    (None, _) => {}
                    (Some(value), Some(place)) => e.store_datum(&place, value, name_span)?,
                    (Some(value), None) => e.names.bind(Names::GLOBAL, name, Place::new(value)),
                }
                // The token behind a datum is taken whatever it is.
                at_end = e.read_from(number, DataFile::token)?.is_none();
            }
            if at_end {
                e.world.close(number);
                e.names.unbind(handle);
            }
            Ok(())
        })
    }

    /// Reads from an open file of data; a closed one is at its end.
    fn read_from<T>(
        &mut self,
        number: usize,
        read: impl FnOnce(&mut DataFile, &mut Words) -> Result<Option<T>, Wrong>,
    ) -> SourceResult<Option<T>> {
        let Some(OpenFile::Reading(file)) = self.world.opened(number) else { return Ok(None) };
        read(file, &mut self.names.words).or_else(|(span, message)| self.error(span, message))
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
