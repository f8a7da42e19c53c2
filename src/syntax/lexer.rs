//! From a piece of text to tokens, through the pest grammar.

use super::pieces::{Piece, PieceKind};
use super::{Directive, Keyword, Malformed, Names, Token, TokenKind};
use crate::diag::{FileId, Span};
use pest::Parser as _;
use pest::iterators::Pair;
use std::borrow::Cow;

/// The parser that pest makes from the grammar.
#[derive(pest_derive::Parser)]
#[grammar = "../grammar/tokens.pest"]
struct TokenParser;

/// Longest string and identifier, in bytes of source text.
const MAX_LENGTH: usize = 255;

/// The tokens of one piece of `text`.
pub(super) fn tokenise(file: FileId, text: &[u8], piece: Piece, names: &mut Names) -> Vec<Token> {
    let span = |start: usize, end: usize| Span { file, start: start as u32, end: end as u32 };
    let whole = |kind| vec![Token { kind, span: span(piece.start, piece.end) }];
    match piece.kind {
        PieceKind::Blank => return Vec::new(),
        PieceKind::Vectors => return whole(TokenKind::Vectors),
        PieceKind::DeepComment => return whole(TokenKind::Bad(Malformed::DeepComment)),
        PieceKind::Text => {}
    }
    let readable = readable(&text[piece.start..piece.end]);
    let Ok(mut parsed) = TokenParser::parse(Rule::tokens, &readable) else {
        return whole(TokenKind::Bad(Malformed::Character));
    };
    let inner = parsed.next().map(Pair::into_inner);
    let mut tokens = Vec::new();
    for pair in inner.into_iter().flatten() {
        let range = pair.as_span();
        if let Some(kind) = kind(&pair, names) {
            tokens.push(Token { kind, span: span(piece.start + range.start(), piece.start + range.end()) });
        }
    }
    tokens
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
fn kind(pair: &Pair<'_, Rule>, names: &mut Names) -> Option<TokenKind> {
    let text = pair.as_str();
    Some(match pair.as_rule() {
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
        let tokens = piece.map_or(Vec::new(), |p| tokenise(FileId(0), text.as_bytes(), p, &mut names));
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
