//! From a piece of text to tokens, through the pest grammar.
//!
//! The grammar decides what a token is. Words, numbers, vectors and punctuation, nearly all of a
//! scene, are recognised by a shortcut beside it; a test holds the two together.

use super::pieces::{Piece, PieceKind, comment_end};
use super::vectors::{run_end, skip_blanks};
use super::{Directive, Keyword, Malformed, Names, Token, TokenKind};
use crate::diag::{FileId, Span};
use pest::Parser as _;
use std::borrow::Cow;

/// The parser that pest makes from the grammar.
#[derive(pest_derive::Parser)]
#[grammar = "../grammar/tokens.pest"]
struct TokenParser;

/// Longest string and identifier, in bytes of source text.
const MAX_LENGTH: usize = 255;

/// Writes the tokens of one piece of `text` in place of what `tokens` holds.
pub(super) fn tokenise(file: FileId, text: &[u8], piece: Piece, names: &mut Names, tokens: &mut Vec<Token>) {
    tokens.clear();
    let span = |start: usize, end: usize| Span { file, start: start as u32, end: end as u32 };
    let whole = |kind| Token { kind, span: span(piece.start, piece.end) };
    match piece.kind {
        PieceKind::Blank => {}
        PieceKind::Vectors => tokens.push(whole(TokenKind::Vectors)),
        PieceKind::DeepComment => tokens.push(whole(TokenKind::Bad(Malformed::DeepComment))),
        PieceKind::Text => {
            let readable = readable(&text[piece.start..piece.end]);
            let mut at = skip_blanks(readable.as_bytes(), 0);
            while at < readable.len() {
                let Some(step) = plain(readable.as_bytes(), at).or_else(|| by_grammar(&readable, at)) else {
                    tokens.clear();
                    return tokens.push(whole(TokenKind::Bad(Malformed::Character)));
                };
                if let Some(kind) = kind(step.rule, &readable[step.start..step.end], names) {
                    tokens.push(Token { kind, span: span(piece.start + step.start, piece.start + step.end) });
                }
                at = skip_blanks(readable.as_bytes(), step.end);
            }
        }
    }
}

/// A match of a token's rule, or of `gap`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Step {
    rule: Rule,
    start: usize,
    end: usize,
}

/// One step of the grammar.
fn by_grammar(text: &str, at: usize) -> Option<Step> {
    let one = TokenParser::parse(Rule::one, &text[at..]).ok()?.next()?;
    let end = at + one.as_span().end();
    let token = one.into_inner().next();
    let (rule, start) = token.map_or((Rule::gap, at), |t| (t.as_rule(), at + t.as_span().start()));
    Some(Step { rule, start, end })
}

/// One step for tokens that a glance decides, exactly as the grammar takes it; `None` leaves it
/// to the grammar, which costs about thirty times as much.
fn plain(text: &[u8], start: usize) -> Option<Step> {
    let next = text.get(start + 1).copied().unwrap_or(0);
    let step = |rule, end| Some(Step { rule, start, end });
    match text[start] {
        b'/' if next == b'/' => step(Rule::gap, end_of(text, start, |b| !matches!(b, b'\n' | b'\r'))),
        b'/' if next == b'*' => block_comment(text, start),
        b'"' => string(text, start),
        b'a'..=b'z' | b'A'..=b'Z' | b'_' => step(Rule::word, end_of(text, start, is_word)),
        b'#' if next.is_ascii_alphabetic() || next == b'_' => step(Rule::directive, end_of(text, start + 1, is_word)),
        b'#' => None,
        b'0'..=b'9' => plain_number(text, start),
        b'.' if next.is_ascii_digit() => plain_number(text, start),
        b'<' => match run_end(text, start) {
            Some(end) => step(Rule::vectors, end),
            None if next == b'=' => step(Rule::or_equal, start + 2),
            None => step(Rule::punctuation, start + 1),
        },
        b'>' | b'!' if next == b'=' => step(Rule::or_equal, start + 2),
        b',' | b'{' | b'}' | b'(' | b')' | b'>' | b'!' | b';' | b'=' | b'*' | b'/' | b'+' | b'-' | b'.' | b'['
        | b']' | b'?' | b':' | b'&' | b'|' => step(Rule::punctuation, start + 1),
        _ => None,
    }
}

/// A number with no second decimal point behind it.
fn plain_number(text: &[u8], start: usize) -> Option<Step> {
    let mut end = end_of(text, start, |b| b.is_ascii_digit());
    if text.get(end) == Some(&b'.') {
        end = end_of(text, end + 1, |b| b.is_ascii_digit());
    }
    if matches!(text.get(end), Some(b'e' | b'E')) {
        let signed = matches!(text.get(end + 1), Some(b'+' | b'-'));
        end = end_of(text, end + 1 + usize::from(signed), |b| b.is_ascii_digit());
    }
    (text.get(end) != Some(&b'.')).then_some(Step { rule: Rule::number, start, end })
}

/// A comment that is closed, or else the rest of the text.
fn block_comment(text: &[u8], start: usize) -> Option<Step> {
    let (end, closed) = comment_end(text, start)?;
    Some(Step { rule: if closed { Rule::gap } else { Rule::bad_comment }, start, end })
}

/// A string that is closed, or else the rest of the text.
fn string(text: &[u8], start: usize) -> Option<Step> {
    let mut at = start + 1;
    while let Some(byte) = text.get(at) {
        match byte {
            b'"' => return Some(Step { rule: Rule::string, start, end: at + 1 }),
            b'\\' if matches!(text.get(at + 1), None | Some(b'\n' | b'\r')) => break,
            b'\\' => at += 2,
            _ => at += 1,
        }
    }
    Some(Step { rule: Rule::bad_string, start, end: text.len() })
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

/// Where bytes that `belong` end.
fn end_of(text: &[u8], start: usize, belong: impl Fn(u8) -> bool) -> usize {
    text[start..].iter().position(|b| !belong(*b)).map_or(text.len(), |n| start + n)
}

/// The text with every byte that is not UTF-8 replaced by one that has no meaning, so that
/// offsets stay the same.
fn readable(text: &[u8]) -> Cow<'_, str> {
    const STAND_IN: char = '\u{7f}';
    match std::str::from_utf8(text) {
        Ok(valid) => Cow::Borrowed(valid),
        Err(_) => {
            let mut out = String::with_capacity(text.len());
            for chunk in text.utf8_chunks() {
                out.push_str(chunk.valid());
                out.extend(chunk.invalid().iter().map(|_| STAND_IN));
            }
            Cow::Owned(out)
        }
    }
}

/// The token of a matched rule.
fn kind(rule: Rule, text: &str, names: &mut Names) -> Option<TokenKind> {
    Some(match rule {
        Rule::number => TokenKind::Number(number(text)),
        Rule::word => word(text, names),
        Rule::directive => {
            let name = text.rsplit(|c: char| !c.is_ascii_alphanumeric() && c != '_').next().unwrap_or("");
            match Keyword::from_word(name).and_then(Directive::from_keyword) {
                Some(directive) => TokenKind::Directive(directive),
                None => word(name, names),
            }
        }
        Rule::string if text.len() > MAX_LENGTH + 2 => TokenKind::Bad(Malformed::LongString),
        Rule::string => TokenKind::String,
        Rule::vectors => TokenKind::Vectors,
        Rule::or_equal => TokenKind::OrEqual(text.chars().next()?),
        Rule::punctuation => TokenKind::Punct(text.chars().next()?),
        Rule::bad_number => TokenKind::Bad(Malformed::Number),
        Rule::bad_string => TokenKind::Bad(Malformed::String),
        Rule::bad_comment => TokenKind::Bad(Malformed::Comment),
        Rule::bad_character => TokenKind::Bad(Malformed::Character),
        _ => return None,
    })
}

fn word(text: &str, names: &mut Names) -> TokenKind {
    match Keyword::from_word(text) {
        Some(keyword) => TokenKind::Keyword(keyword),
        None if text.len() > MAX_LENGTH => TokenKind::Bad(Malformed::LongName),
        None => TokenKind::Name(names.intern(text)),
    }
}

/// The value of a number; an exponent without digits counts as none. Too large is infinite.
fn number(text: &str) -> f64 {
    fast_float2::parse_partial::<f64, _>(text).map_or(0.0, |(value, _)| value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::pieces::next_piece;

    fn check(text: &str, expected: &str) {
        let mut names = Names::default();
        let piece = next_piece(text.as_bytes(), 0);
        let mut tokens = Vec::new();
        if let Some(piece) = piece {
            tokenise(FileId(0), text.as_bytes(), piece, &mut names, &mut tokens);
        }
        let shown: Vec<String> = tokens
            .iter()
            .map(|t| match t.kind {
                TokenKind::Number(n) => format!("{n}"),
                TokenKind::Keyword(k) => k.word().into(),
                TokenKind::Name(s) => format!("'{}", names.word(s)),
                TokenKind::Punct(c) => c.into(),
                TokenKind::OrEqual(c) => format!("{c}="),
                TokenKind::Directive(d) => format!("#{}", d.word()),
                other => format!("{other:?}"),
            })
            .collect();
        assert_eq!(shown.join(" "), expected, "{text}");
    }

    #[test]
    fn numbers() {
        check("1e 1e+ .5 5. 007 1.e1 1e400", "1 1 0.5 5 7 10 inf");
        check("1.2.3", "Bad(Number) 3");
        check("1e2.3", "Bad(Number) 3");
        check("1..x", "1 . x");
    }

    #[test]
    fn words_and_directives() {
        check("sphere Sphere _a1", "sphere 'Sphere '_a1");
        check("# /* c */ declare #sphere{ #if", "#declare sphere { #if");
        check("/* a /* b */ c */ 1 // x", "1");
        check("1<=2>=3!=4 a'b", "1 <= 2 >= 3 != 4 'a ' 'b");
    }

    #[test]
    fn the_shortcut_agrees_with_the_grammar() {
        // Every short text over the characters that matter to the shortcut, then longer ones.
        let alphabet = b"1.e+-<>=!,/#a_ *\n";
        let n = alphabet.len();
        let short = (0..n * n * n * n).map(|k| {
            let digits = [k % n, k / n % n, k / n / n % n, k / n / n / n];
            String::from_utf8_lossy(&digits.map(|d| alphabet[d])).into_owned()
        });
        let long = ["<1,2>,<3,-4e5>=1", "1.5e3.2", "#declare A=.5;//x\r#end", "<1,2,3,4,5,6>", "x2_y(1..2)"];
        let strings =
            ["\"\"", "\"a\\\"b\" c", "\"a\\", "\"a\\\nb\"", "\"\u{e9}\\\u{e9}\"", "\"a\nb", "/* /* */ x", "/*/**/*/ 1"];
        for text in short.chain(long.map(String::from)).chain(strings.map(String::from)) {
            let Some(step) = plain(text.as_bytes(), 0) else { continue };
            // The grammar takes a gap whole, the shortcut in parts.
            match by_grammar(&text, 0) {
                Some(expected) if step.rule != Rule::gap => assert_eq!(step, expected, "{text:?}"),
                found => assert!(found.is_some_and(|f| f.start >= step.end || f.rule == Rule::gap), "{text:?}"),
            }
        }
    }

    #[test]
    fn vectors_are_one_token() {
        check("<1,2,3>,<1,-2> <a,1>", "Vectors < 'a , 1 >");
        check("matrix <1,0,0,0,1,0>", "matrix < 1 , 0 , 0 , 0 , 1 , 0 >");
        check("<1,2>=3", "< 1 , 2 >= 3");
    }

    #[test]
    fn malformed_text_becomes_tokens() {
        check("\"abc", "Bad(String)");
        check("/* abc", "Bad(Comment)");
        check("\u{e9}", "Bad(Character)");
        check(&format!("\"{}\"", "a".repeat(256)), "Bad(LongString)");
        check(&"a".repeat(256), "Bad(LongName)");
    }
}
