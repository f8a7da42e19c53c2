//! Cutting a file into pieces that are parsed one at a time.
//!
//! pest keeps a record for every rule that matched until its result is dropped. For a
//! file of a hundred megabytes that would be gigabytes, so a small scanner finds places
//! where text may be cut (between tokens, outside of strings and comments), and each
//! piece is parsed when the evaluator gets there. Long runs of literal vectors become
//! pieces of their own, which need no parsing at all.

use super::vectors::{run_end, skip_blanks};

/// Bytes of source text in one piece, about. Small enough that its tokens stay in the second cache, large enough that
/// its fixed costs do not count.
const PIECE: usize = 1 << 13;

/// Runs of vectors shorter than this stay with the text around them.
const LONG_RUN: usize = 1 << 9;

/// Deepest nesting of comments that the parser is given.
const MAX_COMMENT_DEPTH: usize = 64;

/// Part of a file, by byte offsets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Piece {
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
    /// What it holds.
    pub kind: PieceKind,
}

/// What a piece holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PieceKind {
    /// Anything.
    Text,
    /// Nothing but blanks.
    Blank,
    /// Literal vectors with commas between them, and nothing else.
    Vectors,
    /// A comment that nests too deeply for the parser.
    DeepComment,
}

/// The piece that starts at `start`; `None` at the end of the text.
pub(super) fn next_piece(text: &[u8], start: usize) -> Option<Piece> {
    if start >= text.len() {
        return None;
    }
    let piece = |end, kind| Some(Piece { start, end, kind });
    let behind_blanks = skip_blanks(text, start);
    if behind_blanks - start >= PIECE {
        return piece(behind_blanks, PieceKind::Blank);
    }
    let mut at = start;
    // A hash mark must stay with the word behind it.
    let mut after_hash = false;
    let too_short = (start + PIECE).min(text.len());
    while at < text.len() {
        if at < too_short && !after_hash {
            // Nothing is cut here yet, so only what may hide a place to cut matters.
            at += text[at..too_short].iter().take_while(|b| !matches!(b, b'"' | b'/' | b'<' | b'#')).count();
            if at == too_short {
                continue;
            }
        }
        match text[at] {
            b'"' => at = string_end(text, at),
            b'/' if text.get(at + 1) == Some(&b'/') => at = line_end(text, at),
            b'/' if text.get(at + 1) == Some(&b'*') => match comment_end(text, at) {
                Some((end, _)) => at = end,
                None if at > start => return piece(at, PieceKind::Text),
                None => return piece(text.len(), PieceKind::DeepComment),
            },
            b'<' => {
                after_hash = false;
                let end = short_vector_end(text, at).or_else(|| run_end(text, at)).unwrap_or(at + 1);
                if end - at >= LONG_RUN {
                    return if at > start { piece(at, PieceKind::Text) } else { piece(end, PieceKind::Vectors) };
                }
                at = end;
            }
            blank @ (b' ' | b'\n' | b'\t' | b'\r') => {
                at += 1;
                let long = at - start >= PIECE;
                if long && !after_hash && (blank == b'\n' || at - start >= 2 * PIECE) {
                    return piece(at, PieceKind::Text);
                }
            }
            byte => {
                after_hash = byte == b'#';
                at += 1;
                // Text without a single blank: cut behind punctuation that is a token by itself.
                if at - start >= 4 * PIECE && matches!(byte, b',' | b';' | b'{' | b'}' | b'(' | b')') {
                    return piece(at, PieceKind::Text);
                }
            }
        }
    }
    piece(text.len(), PieceKind::Text)
}

/// One past a `>` before which only numbers can stand, if no other vector follows and both are near.
fn short_vector_end(text: &[u8], start: usize) -> Option<usize> {
    let inside = |b: &&u8| matches!(b, b'0'..=b'9' | b'.' | b',' | b'-' | b'+' | b'e' | b'E' | b' ');
    let end = start + 1 + text[start + 1..].iter().take(LONG_RUN - 2).take_while(inside).count();
    let comma = skip_blanks(text, end + 1);
    let goes_on = text.get(comma) == Some(&b',') && text.get(skip_blanks(text, comma + 1)) == Some(&b'<');
    (text.get(end) == Some(&b'>') && !goes_on).then_some(end + 1)
}

/// One past the closing quote, or the end of the text.
fn string_end(text: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while at < text.len() {
        match text[at] {
            b'"' => return at + 1,
            b'\\' => at += 2,
            _ => at += 1,
        }
    }
    text.len()
}

/// The line end that closes a comment, or the end of the text.
fn line_end(text: &[u8], start: usize) -> usize {
    text[start..].iter().position(|b| matches!(b, b'\n' | b'\r')).map_or(text.len(), |n| start + n)
}

/// One past the end of a nesting comment, or the end of the text, and whether it is closed; `None` if it nests too
/// deeply.
pub(super) fn comment_end(text: &[u8], start: usize) -> Option<(usize, bool)> {
    let (mut at, mut depth) = (start, 0);
    while at + 1 < text.len() {
        match (text[at], text[at + 1]) {
            (b'/', b'*') => {
                depth += 1;
                at += 2;
                if depth > MAX_COMMENT_DEPTH {
                    return None;
                }
            }
            (b'*', b'/') => {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    return Some((at, true));
                }
            }
            _ => at += 1,
        }
    }
    Some((text.len(), false))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, expected: &[(usize, PieceKind)]) {
        let (mut at, mut pieces) = (0, Vec::new());
        while let Some(piece) = next_piece(text.as_bytes(), at) {
            at = piece.end;
            pieces.push((piece.end, piece.kind));
        }
        assert_eq!(pieces, expected);
    }

    #[test]
    fn short_text_is_one_piece() {
        check("", &[]);
        check("sphere { <1,2,3>, \"a // b\" } /* x /* y */ z */", &[(46, PieceKind::Text)]);
    }

    #[test]
    fn long_runs_stand_alone() {
        let run = ["<1,2,3>"; 100].join(",");
        let text = format!("mesh2 {{ {run} }}");
        check(&text, &[(8, PieceKind::Text), (8 + run.len(), PieceKind::Vectors), (text.len(), PieceKind::Text)]);
    }

    #[test]
    fn deep_comments_are_set_apart() {
        check(&"/*".repeat(1000), &[(2000, PieceKind::DeepComment)]);
    }

    #[test]
    fn pieces_end_between_tokens() {
        let whole = ["# \n declare", "\"x # \\\" /* < \n\"", "/* \" # \n */", "// \" <\n", "<1, 2>,\n <3, 4>", "a < b"];
        let turn = whole.join(" ");
        let text = turn.repeat(40 * PIECE / turn.len());
        let (mut at, mut ends) = (0, Vec::new());
        while let Some(piece) = next_piece(text.as_bytes(), at) {
            at = piece.end;
            ends.push(at % turn.len());
        }
        assert!(ends.len() > 20);
        for part in whole {
            let start = turn.find(part).unwrap_or(0);
            assert!(ends.iter().all(|end| !(start + 1..start + part.len()).contains(end)), "{part}: {ends:?}");
        }
    }

    #[test]
    fn text_without_line_ends_is_cut_too() {
        let text = "x,".repeat(200_000);
        let first = next_piece(text.as_bytes(), 0).map(|p| p.end);
        assert!(first.is_some_and(|end| end < 200_000));
    }
}
