//! Places in source files.

use rustc_hash::FxHashMap;
use std::sync::Arc;

/// A file that was read, by order of reading, or a part of one as it was [come to](SourceMap::visit).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FileId(pub u32);

/// A range of bytes in one file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// Which file.
    pub file: FileId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

/// All files that were read, with their text, so that spans can be shown.
///
/// Where it matters how reading came to a place, a span's file is a [visit](Self::visit): so a span takes up no more room
/// than one without a story, and all that was read on one visit share it.
#[derive(Clone, Debug, Default)]
pub struct SourceMap {
    files: Vec<SourceFile>,
    visits: Vec<Visit>,
    /// Their numbers, since a loop comes the same way again and again.
    known: FxHashMap<Visit, FileId>,
}

/// A file that was read because another one says so there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Visit {
    /// The file.
    file: FileId,
    /// What led to it.
    pub by: Way,
    /// Where that stands; its file may itself be read on a visit.
    pub from: Span,
}

/// What leads to another place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Way {
    /// The call of a macro, whose name stands there.
    Call,
    /// An `#include`.
    Include,
}

/// The number of the first visit; those below are files.
const FIRST_VISIT: u32 = 1 << 31;

/// One file.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// What messages call it.
    pub name: String,
    /// Its bytes, which need not be text; none while they are [released](SourceMap::release_large).
    pub text: Arc<Vec<u8>>,
    /// How many bytes were released.
    released: usize,
}

/// A place as people count: both from 1, columns in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineColumn {
    /// Line number.
    pub line: usize,
    /// Characters from the start of the line.
    pub column: usize,
}

/// Part of a file around a place, short enough to be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excerpt {
    /// The text: one line, or as much of it as fits.
    pub text: String,
    /// First marked character of `text`.
    pub start: usize,
    /// One past the last marked character of `text`.
    pub end: usize,
    /// Whether characters of the line before `text` are left out.
    pub cut: bool,
}

/// Most characters of a line that are shown before and behind a place.
const WINDOW: usize = 100;

/// Bytes from which the text of a file is worth releasing.
const LARGE: usize = 1 << 20;

impl SourceMap {
    /// Takes in a file.
    pub fn add(&mut self, name: impl Into<String>, text: Arc<Vec<u8>>) -> FileId {
        self.files.push(SourceFile { name: name.into(), text, released: 0 });
        FileId((self.files.len() - 1) as u32)
    }

    /// A file as it is read because of what stands at `from`, for spans that shall tell.
    pub fn visit(&mut self, file: FileId, by: Way, from: Span) -> FileId {
        let visit = Visit { file, by, from };
        *self.known.entry(visit).or_insert_with(|| {
            self.visits.push(visit);
            FileId(FIRST_VISIT + (self.visits.len() - 1) as u32)
        })
    }

    /// How reading came to a place, the last step first.
    pub fn visits(&self, span: Span) -> impl Iterator<Item = &Visit> {
        let of = |id: FileId| self.visits.get(id.0.checked_sub(FIRST_VISIT)? as usize);
        std::iter::successors(of(span.file), move |visit| of(visit.from.file))
    }

    /// A file by its number.
    pub fn file(&self, id: FileId) -> Option<&SourceFile> {
        self.files.get(self.unvisited(id).0 as usize)
    }

    /// The file that is read on a visit; any other itself.
    pub fn unvisited(&self, id: FileId) -> FileId {
        let visit = id.0.checked_sub(FIRST_VISIT).and_then(|i| self.visits.get(i as usize));
        visit.map_or(id, |visit| visit.file)
    }

    /// All files in order of reading.
    pub fn files(&self) -> &[SourceFile] {
        &self.files
    }

    /// Lets go of the text of large files, meshes mostly, once they have been read: nobody may ever want to see it.
    pub fn release_large(&mut self) {
        for file in self.files.iter_mut().filter(|file| file.text.len() > LARGE) {
            file.released = file.text.len();
            file.text = Arc::default();
        }
    }

    /// With the text of released files, if `read` still finds as many bytes under their names.
    #[must_use]
    pub fn restored(&self, read: impl Fn(&str) -> Option<Vec<u8>>) -> Self {
        let mut all = self.clone();
        for file in all.files.iter_mut().filter(|file| file.released > 0) {
            if let Some(text) = read(&file.name).filter(|text| text.len() == file.released) {
                (file.text, file.released) = (Arc::new(text), 0);
            }
        }
        all
    }

    /// Whether the text of a span cannot be shown.
    pub fn is_released(&self, span: Span) -> bool {
        self.file(span.file).is_some_and(|file| file.released > 0)
    }

    /// The bytes of a span; empty if it lies outside of its file.
    pub fn bytes(&self, span: Span) -> &[u8] {
        self.file(span.file).and_then(|f| f.text.get(span.start as usize..span.end as usize)).unwrap_or(&[])
    }

    /// Line and column of a span's first byte.
    pub fn line_column(&self, span: Span) -> LineColumn {
        let Some(file) = self.file(span.file) else { return LineColumn { line: 1, column: 1 } };
        let before = &file.text[..file.text.len().min(span.start as usize)];
        let (line, start) = line_starts(before).enumerate().last().unwrap_or_default();
        LineColumn { line: line + 1, column: String::from_utf8_lossy(&before[start..]).chars().count() + 1 }
    }

    /// What to show of a span: the part of its first line around its start.
    pub fn excerpt(&self, span: Span) -> Excerpt {
        let text: &[u8] = self.file(span.file).map_or(&[], |f| &f.text);
        let start = text.len().min(span.start as usize);
        let end = text.len().clamp(start, (span.end as usize).max(start));
        let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
        let near = start.saturating_sub(WINDOW);
        let from = text[near..start].iter().rposition(is_end).map_or(near, |n| near + n + 1);
        let far = text.len().min(start + 2 * WINDOW);
        let to = text[start..far].iter().position(is_end).map_or(far, |n| start + n);
        let shown = |bytes: &[u8]| {
            let clean = |c: char| if c.is_control() { ' ' } else { c };
            String::from_utf8_lossy(bytes).chars().map(clean).collect::<String>()
        };
        let (before, marked) = (shown(&text[from..start]), shown(&text[start..end.clamp(start, to)]));
        let rest = shown(&text[end.clamp(start, to)..to]);
        let first = before.chars().count();
        Excerpt {
            start: first,
            end: first + marked.chars().count().max(1),
            text: before + &marked + &rest,
            cut: from == near && near > 0 && !is_end(&text[near - 1]),
        }
    }
}

impl SourceFile {
    /// Where its lines start, in order, for who asks for many.
    pub fn line_starts(&self) -> impl Iterator<Item = usize> {
        line_starts(&self.text)
    }
}

/// Where the lines of a text start, one behind its last end of a line included. CR, LF and both together end one line.
fn line_starts(text: &[u8]) -> impl Iterator<Item = usize> {
    let mut at = 0;
    let next = move || {
        let end = at + text[at..].iter().position(|byte| matches!(byte, b'\n' | b'\r'))?;
        let other = if text[end] == b'\n' { b'\r' } else { b'\n' };
        at = end + 1 + usize::from(text.get(end + 1) == Some(&other));
        Some(at)
    };
    std::iter::once(0).chain(std::iter::from_fn(next))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &[u8], start: u32, end: u32, expected: (usize, usize, &str, usize, usize)) {
        let mut map = SourceMap::default();
        let file = map.add("a", Arc::new(text.to_vec()));
        let span = Span { file, start, end };
        let (place, shown) = (map.line_column(span), map.excerpt(span));
        assert_eq!((place.line, place.column, &*shown.text, shown.start, shown.end), expected);
    }

    #[test]
    fn places_are_found() {
        check(b"ab\ncd ef\n", 6, 8, (2, 4, "cd ef", 3, 5));
        check(b"a\r\nb\n\rc\rd", 8, 9, (4, 1, "d", 0, 1));
        check(b"", 0, 0, (1, 1, "", 0, 1));
        check(b"ab", 7, 9, (1, 3, "ab", 2, 3));
        check("é\u{2192}x".as_bytes(), 5, 6, (1, 3, "é\u{2192}x", 2, 3));
        check(b"\xff\xfex", 2, 3, (1, 3, "\u{fffd}\u{fffd}x", 2, 3));
    }

    #[test]
    fn spans_tell_how_reading_came_to_them() {
        let mut map = SourceMap::default();
        let text = b"sphere\nA\nB".to_vec();
        let file = map.add("a", Arc::new(text));
        let at = |file, start| Span { file, start, end: start + 1 };
        let outer = map.visit(file, Way::Call, at(file, 9));
        let inner = map.visit(file, Way::Call, at(outer, 7));
        assert_eq!((map.visit(file, Way::Call, at(outer, 7)), map.files().len()), (inner, 1));
        let place = Span { file: inner, start: 0, end: 6 };
        assert_eq!((map.bytes(place), map.line_column(place).line), (&b"sphere"[..], 1));
        let lines: Vec<_> = map.visits(place).map(|visit| map.line_column(visit.from).line).collect();
        assert_eq!((lines, map.visits(at(file, 0)).count()), (vec![2, 3], 0));
    }

    #[test]
    fn large_files_are_released_until_they_are_shown() {
        let mut map = SourceMap::default();
        let text = [b"// a\nsphere".to_vec(), vec![b' '; LARGE]].concat();
        let file = map.add("a", Arc::new(text.clone()));
        let span = Span { file, start: 5, end: 11 };
        map.release_large();
        assert!(map.is_released(span) && map.bytes(span).is_empty());
        let other = map.restored(|_| Some(b"something else".to_vec()));
        assert!(other.is_released(span), "the file has changed");
        let again = map.restored(|name| (name == "a").then(|| text.clone()));
        assert_eq!((again.bytes(span), again.line_column(span).line), (&b"sphere"[..], 2));
    }

    #[test]
    fn long_lines_show_a_window() {
        let mut map = SourceMap::default();
        let file = map.add("a", Arc::new(vec![b'x'; 1000]));
        let shown = map.excerpt(Span { file, start: 500, end: 501 });
        assert!(shown.cut);
        assert_eq!((shown.text.len(), shown.start, shown.end), (300, 100, 101));
    }
}
