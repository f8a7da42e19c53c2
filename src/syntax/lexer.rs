//! From text to tokens, through the pest grammar.
//!
//! The grammar decides what a token is. Nearly all of a scene is recognised by a shortcut beside it; a test holds the
//! two together. A file is read in pieces, each when the evaluator gets there: a file of 100 MB never stands in
//! memory as tokens.

use super::numbers::number;
use super::vectors::{run_end, skip_blanks};
use super::{Directive, Keyword, Malformed, Token, TokenKind, Words};
use crate::diag::{FileId, Span};
use pest::Parser as _;

/// The parser that pest makes from the grammar.
#[derive(pest_derive::Parser)]
#[grammar = "../grammar/tokens.pest"]
struct TokenParser;

/// Bytes of source text in one piece, about. Small enough that its tokens stay in the second cache, large enough that
/// its fixed costs do not count.
const PIECE: usize = 1 << 13;

/// Longest string and identifier, in bytes of source text.
const MAX_LENGTH: usize = 255;

/// Deepest nesting of comments.
const MAX_COMMENT_DEPTH: usize = 64;

/// Writes the tokens of the piece of `text` that begins at `start` in place of what `tokens` holds; gives back where
/// the next piece begins, which is between two tokens.
pub(super) fn tokenise(file: FileId, text: &[u8], start: usize, names: &mut Words, tokens: &mut Vec<Token>) -> usize {
    tokens.clear();
    let span = |start: usize, end: usize| Span { file, start: start as u32, end: end as u32 };
    let end = text.len().min(start + PIECE);
    let mut at = skip_blanks(text, start);
    while at < end {
        let Some(step) = plain(text, at).or_else(|| by_grammar(text, at)) else {
            tokens.push(Token { kind: TokenKind::Bad(Malformed::DeepComment), span: span(at, text.len()) });
            return text.len();
        };
        if let Some(kind) = kind(step.rule, &text[step.start..step.end], names) {
            tokens.push(Token { kind, span: span(step.start, step.end) });
        }
        at = skip_blanks(text, step.end);
    }
    at
}

/// A match of a token's rule, or of `gap`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Step {
    rule: Rule,
    start: usize,
    end: usize,
}

/// One step of the grammar; `None` for comments that nest too deeply for it.
fn by_grammar(text: &[u8], at: usize) -> Option<Step> {
    let window = window(text, at)?;
    let one = TokenParser::parse(Rule::one, window).ok()?.next()?;
    let end = at + one.as_span().end();
    let token = one.into_inner().next();
    let (rule, start) = token.map_or((Rule::gap, at), |t| (t.as_rule(), at + t.as_span().start()));
    Some(Step { rule, start, end })
}

/// As much of the text as the grammar has to see of what the shortcut leaves to it: a number with what follows, or
/// one character, which has no meaning where it is not UTF-8.
fn window(text: &[u8], at: usize) -> Option<&str> {
    const MEANINGLESS: &str = "\u{7f}";
    match text[at] {
        // Of these the shortcut leaves only comments that nest too deeply.
        b'/' | b'#' => None,
        b'0'..=b'9' | b'.' => std::str::from_utf8(&text[at..=number_end(text, at)]).ok(),
        _ => {
            let valid = text[at..text.len().min(at + 4)].utf8_chunks().next()?.valid();
            Some(valid.chars().next().map_or(MEANINGLESS, |first| &valid[..first.len_utf8()]))
        }
    }
}

/// One step for tokens that a glance decides, exactly as the grammar takes it; `None` leaves it
/// to the grammar, which costs about thirty times as much.
fn plain(text: &[u8], start: usize) -> Option<Step> {
    let next = text.get(start + 1).copied().unwrap_or(0);
    let step = |rule, end| Some(Step { rule, start, end });
    match text[start] {
        b'/' if next == b'/' => step(Rule::gap, line_end(text, start)),
        b'/' if next == b'*' => block_comment(text, start),
        b'"' => string(text, start),
        b'a'..=b'z' | b'A'..=b'Z' | b'_' => step(Rule::word, end_of(text, start, is_word)),
        b'#' => directive(text, start),
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

/// A hash mark with the word behind it, if there is one.
fn directive(text: &[u8], start: usize) -> Option<Step> {
    let word = gap_end(text, start + 1)?;
    match text.get(word) {
        Some(b'a'..=b'z' | b'A'..=b'Z' | b'_') => {
            Some(Step { rule: Rule::directive, start, end: end_of(text, word, is_word) })
        }
        _ => Some(Step { rule: Rule::punctuation, start, end: start + 1 }),
    }
}

/// Where blanks and closed comments end; `None` if one nests too deeply.
fn gap_end(text: &[u8], mut at: usize) -> Option<usize> {
    loop {
        at = match &text[at..] {
            [b' ' | b'\n' | b'\t' | b'\r' | b'\x0c' | b'\0' | b'\x1a', ..] => at + 1,
            [b'/', b'/', ..] => line_end(text, at),
            [b'/', b'*', ..] => match comment_end(text, at)? {
                (end, true) => end,
                _ => return Some(at),
            },
            _ => return Some(at),
        };
    }
}

/// A number with no second decimal point behind it.
fn plain_number(text: &[u8], start: usize) -> Option<Step> {
    let end = number_end(text, start);
    (text.get(end) != Some(&b'.')).then_some(Step { rule: Rule::number, start, end })
}

/// One past an unsigned number; an exponent needs no digits.
fn number_end(text: &[u8], start: usize) -> usize {
    let mut end = end_of(text, start, |b| b.is_ascii_digit());
    if text.get(end) == Some(&b'.') {
        end = end_of(text, end + 1, |b| b.is_ascii_digit());
    }
    if matches!(text.get(end), Some(b'e' | b'E')) {
        let signed = matches!(text.get(end + 1), Some(b'+' | b'-'));
        end = end_of(text, end + 1 + usize::from(signed), |b| b.is_ascii_digit());
    }
    end
}

/// The line end that closes a comment, or the end of the text.
fn line_end(text: &[u8], start: usize) -> usize {
    end_of(text, start, |b| !matches!(b, b'\n' | b'\r'))
}

/// A comment that is closed, or else the rest of the text.
fn block_comment(text: &[u8], start: usize) -> Option<Step> {
    let (end, closed) = comment_end(text, start)?;
    Some(Step { rule: if closed { Rule::gap } else { Rule::bad_comment }, start, end })
}

/// One past the end of a nesting comment, or the end of the text, and whether it is closed; `None` if it nests too
/// deeply.
fn comment_end(text: &[u8], start: usize) -> Option<(usize, bool)> {
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

/// By byte, whether it may stand in a word.
const IN_WORDS: [bool; 256] = {
    let mut table = [false; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = (byte as u8).is_ascii_alphanumeric() || byte as u8 == b'_';
        byte += 1;
    }
    table
};

fn is_word(byte: u8) -> bool {
    IN_WORDS[usize::from(byte)]
}

/// Where bytes that `belong` end.
#[inline]
fn end_of(text: &[u8], mut at: usize, belong: impl Fn(u8) -> bool) -> usize {
    while text.get(at).is_some_and(|b| belong(*b)) {
        at += 1;
    }
    at
}

/// The token of a matched rule.
fn kind(rule: Rule, text: &[u8], names: &mut Words) -> Option<TokenKind> {
    Some(match rule {
        // An exponent without digits counts as none.
        Rule::number => TokenKind::Number(number(text).map_or(0.0, |(value, _)| value)),
        Rule::word => word(text, names),
        Rule::directive => {
            let name = text.rsplit(|b| !is_word(*b)).next().unwrap_or_default();
            match Keyword::from_bytes(name).and_then(Directive::from_keyword) {
                Some(directive) => TokenKind::Directive(directive),
                None => word(name, names),
            }
        }
        Rule::string if text.len() > MAX_LENGTH + 2 => TokenKind::Bad(Malformed::LongString),
        Rule::string => TokenKind::String,
        Rule::vectors => TokenKind::Vectors,
        Rule::or_equal => TokenKind::OrEqual(char::from(text[0])),
        Rule::punctuation => TokenKind::Punct(char::from(text[0])),
        Rule::bad_number => TokenKind::Bad(Malformed::Number),
        Rule::bad_string => TokenKind::Bad(Malformed::String),
        Rule::bad_comment => TokenKind::Bad(Malformed::Comment),
        Rule::bad_character => TokenKind::Bad(Malformed::Character),
        _ => return None,
    })
}

fn word(text: &[u8], names: &mut Words) -> TokenKind {
    match Keyword::from_bytes(text) {
        Some(keyword) => TokenKind::Keyword(keyword),
        None if text.len() > MAX_LENGTH => TokenKind::Bad(Malformed::LongName),
        // Words are letters, digits and underscores.
        None => TokenKind::Name(names.intern(std::str::from_utf8(text).unwrap_or_default())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, expected: &str) {
        let mut names = Words::default();
        let mut tokens = Vec::new();
        tokenise(FileId(0), text.as_bytes(), 0, &mut names, &mut tokens);
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

    /// The first step of the grammar when it sees all of a text.
    fn whole(text: &str) -> Option<Step> {
        let one = TokenParser::parse(Rule::one, text).ok()?.next()?;
        let end = one.as_span().end();
        let token = one.into_inner().next();
        let (rule, start) = token.map_or((Rule::gap, 0), |t| (t.as_rule(), t.as_span().start()));
        Some(Step { rule, start, end })
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
            let Some(step) = plain(text.as_bytes(), 0).or_else(|| by_grammar(text.as_bytes(), 0)) else { continue };
            // The grammar takes a gap whole, the shortcut in parts.
            match whole(&text) {
                Some(expected) if step.rule != Rule::gap => assert_eq!(step, expected, "{text:?}"),
                found => assert!(found.is_some_and(|f| f.start >= step.end || f.rule == Rule::gap), "{text:?}"),
            }
        }
    }

    /// Whether the rule `tokens`, which specifies the language, takes a text apart as the lexer does; texts that are not
    /// UTF-8 and comments that nest too deeply for the grammar are the lexer's alone.
    fn check_against_specification(what: &str, text: &[u8]) {
        let Ok(text) = std::str::from_utf8(text) else { return };
        let whole = TokenParser::parse(Rule::tokens, text).expect("the grammar takes any text");
        let expected: Vec<Step> = whole
            .flat_map(|tokens| tokens.into_inner())
            .filter(|token| token.as_rule() != Rule::EOI)
            .map(|token| Step { rule: token.as_rule(), start: token.as_span().start(), end: token.as_span().end() })
            .collect();
        let mut found = Vec::new();
        let mut at = skip_blanks(text.as_bytes(), 0);
        while at < text.len() {
            let Some(step) = plain(text.as_bytes(), at).or_else(|| by_grammar(text.as_bytes(), at)) else { return };
            if step.rule != Rule::gap {
                found.push(step);
            }
            at = skip_blanks(text.as_bytes(), step.end);
        }
        let differs = (0..expected.len().max(found.len())).find(|&i| expected.get(i) != found.get(i));
        assert!(differs.is_none(), "{what}: {:?}", differs.map(|i| (expected.get(i), found.get(i))));
    }

    /// Scenes below a folder.
    fn scenes(folder: &std::path::Path) -> Vec<std::path::PathBuf> {
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
        let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
        let is_scene = |path: &std::path::PathBuf| path.extension().is_some_and(|e| e == "pov" || e == "inc");
        folders.iter().flat_map(|folder| scenes(folder)).chain(files.into_iter().filter(is_scene)).collect()
    }

    #[test]
    fn the_lexer_agrees_with_its_specification() {
        const DAMAGE: &[u8] = b"#/*\"<>.,e9 {}\\\n-";
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let all: Vec<_> =
            ["golden", "examples", "src/include", "tests"].iter().flat_map(|f| scenes(&root.join(f))).collect();
        assert!(all.len() > 100, "{}", all.len());
        let mut random = 1_u64;
        let mut next = |n: usize| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) as usize % n.max(1)
        };
        for path in all {
            let text = std::fs::read(&path).unwrap_or_default();
            check_against_specification(&path.display().to_string(), &text);
            // A short part of it, damaged.
            let start = next(text.len());
            let mut part = text[start..text.len().min(start + 400)].to_vec();
            for _ in 0..8 {
                let at = next(part.len());
                if let Some(byte) = part.get_mut(at) {
                    *byte = DAMAGE[next(DAMAGE.len())];
                }
            }
            check_against_specification("damaged", &part);
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
        check(&"/*".repeat(1000), "Bad(DeepComment)");
    }

    #[test]
    fn pieces_end_between_tokens() {
        let turn = "# \n declare \"x # \\\" /* < \n\" /* \" # \n */ // \" <\n <1, 2>,\n <3, 4> a < b ";
        let text = turn.repeat(20 * PIECE / turn.len());
        let (mut names, mut start, mut n_pieces) = (Words::default(), 0, 0);
        let (mut found, mut piece) = (Vec::new(), Vec::new());
        while start < text.len() {
            start = tokenise(FileId(0), text.as_bytes(), start, &mut names, &mut piece);
            found.extend(piece.iter().map(|token| token.kind));
            n_pieces += 1;
        }
        tokenise(FileId(0), turn.as_bytes(), 0, &mut names, &mut piece);
        assert!(n_pieces > 10 && piece.len() == 6, "{n_pieces} {piece:?}");
        assert!(found.chunks(piece.len()).all(|turn| turn.iter().eq(piece.iter().map(|token| &token.kind))));
    }
}
