//! Tokens and directives as text, for people who wonder how a file was read, and for tests.

use super::{Source, Token, TokenKind, Words};
use crate::diag::SourceMap;
use std::fmt::Write as _;

/// Every token on a line of its own: `line:column`, what it is, and its text.
pub fn dump_tokens(source: &Source, sources: &SourceMap) -> String {
    let mut out = String::new();
    each_token(source, |token| {
        let at = sources.line_column(token.span);
        let place = format!("{}:{}", at.line, at.column);
        let _ = writeln!(out, "{place:<10}{:<11}{}", sort(token.kind), shown(source, token));
    });
    out
}

/// The file's directives, those inside others indented, each block with its first and last line; between them the
/// number of tokens that stand there.
pub fn dump_tree(source: &Source, sources: &SourceMap) -> String {
    let mut tree = Tree::default();
    each_token(source, |token| {
        let line = sources.line_column(token.span).line;
        match token.kind {
            TokenKind::Directive(directive) => {
                tree.flush();
                let word = format!("#{}", directive.word());
                if directive.ends_branch() {
                    tree.close(line);
                    if directive.opens_branch() {
                        tree.open(line, word);
                    }
                } else if directive.opens_block() {
                    tree.open(line, word);
                } else {
                    tree.lines.push((tree.open.len(), line, line, word));
                }
            }
            _ => tree.token(line),
        }
    });
    tree.finish()
}

/// Calls with each token of a file in order.
fn each_token(source: &Source, mut call: impl FnMut(&Token)) {
    let mut names = Words::default();
    let mut piece = 0;
    while let Some(tokens) = source.tokens(piece, &mut names) {
        tokens.tokens.iter().for_each(&mut call);
        piece += 1;
    }
}

fn sort(kind: TokenKind) -> &'static str {
    match kind {
        TokenKind::End => "end",
        TokenKind::Number(_) => "number",
        TokenKind::String => "string",
        TokenKind::Keyword(_) => "keyword",
        TokenKind::Name(_) => "name",
        TokenKind::Punct(_) | TokenKind::OrEqual(_) => "sign",
        TokenKind::Directive(_) => "directive",
        TokenKind::Vector => "vector",
        TokenKind::Vectors => "vectors",
        TokenKind::Bad(_) => "malformed",
    }
}

/// The text of a token on one line, not too long.
fn shown(source: &Source, token: &Token) -> String {
    const LONGEST: usize = 60;
    let (start, end) = (token.span.start as usize, token.span.end as usize);
    let text = String::from_utf8_lossy(source.text().get(start..end).unwrap_or_default());
    let mut words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((cut, _)) = words.char_indices().nth(LONGEST) {
        words.truncate(cut);
        words += " …";
    }
    words.escape_debug().filter(|c| *c != '\\').collect()
}

/// Directives as they are found: depth, first line, last line, what.
#[derive(Default)]
struct Tree {
    lines: Vec<(usize, usize, usize, String)>,
    /// Branches that are not closed yet, by their place in `lines`.
    open: Vec<usize>,
    /// Tokens since the last directive: first line, last line, how many.
    run: Option<(usize, usize, usize)>,
}

impl Tree {
    fn token(&mut self, line: usize) {
        let (first, _, count) = self.run.unwrap_or((line, line, 0));
        self.run = Some((first, line, count + 1));
    }

    fn flush(&mut self) {
        if let Some((first, last, count)) = self.run.take() {
            let plural = if count == 1 { "" } else { "s" };
            self.lines.push((self.open.len(), first, last, format!("{count} token{plural}")));
        }
    }

    fn open(&mut self, line: usize, what: String) {
        self.lines.push((self.open.len(), line, line, what));
        self.open.push(self.lines.len() - 1);
    }

    /// A surplus `#end` closes nothing.
    fn close(&mut self, line: usize) {
        if let Some(index) = self.open.pop() {
            self.lines[index].2 = line;
        }
    }

    fn finish(mut self) -> String {
        self.flush();
        for index in &self.open {
            self.lines[*index].3 += " without #end";
        }
        let mut out = String::new();
        for (depth, first, last, what) in &self.lines {
            let extent = if first == last { first.to_string() } else { format!("{first}-{last}") };
            let _ = writeln!(out, "{extent:<12}{:1$}{what}", "", 2 * depth);
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::super::Text;
    use super::*;
    use std::sync::Arc;

    fn check(dump: fn(&Source, &SourceMap) -> String, text: &str, expected: &[&str]) {
        let mut sources = SourceMap::default();
        let text = Arc::new(Text::new(text.as_bytes().to_vec()));
        let file = sources.add("a.pov", Arc::clone(text.bytes()));
        let dumped = dump(&Source::new(file, text), &sources);
        assert_eq!(dumped.lines().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn tokens_have_places_and_text() {
        let expected = [
            "1:1       keyword    sphere",
            "1:8       sign       {",
            "2:1       vectors    <1,2,3>",
            "2:9       name       R",
            "2:11      string     \"a b\"",
            "3:1       directive  #end",
        ];
        check(dump_tokens, "sphere {\n<1,2,3> R \"a b\"\n#end", &expected);
    }

    #[test]
    fn directives_know_how_far_they_reach() {
        let text = "#if (1)\n sphere\n#else\n #declare A = 1;\n#end\n#while (1)\n";
        let expected = [
            "1-3         #if",
            "1-2           4 tokens",
            "3-5         #else",
            "4             #declare",
            "4             4 tokens",
            "6           #while without #end",
            "6             3 tokens",
        ];
        check(dump_tree, text, &expected);
    }
}
