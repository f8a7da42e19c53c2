//! Arguments and lines of INI files cut into words.
//!
//! Source: command line facts, sections 1 and 2.

/// The words of a line: cut at blanks outside of quotation marks, which are taken off.
pub(super) fn words(line: &str) -> Vec<String> {
    let mut rest = line.trim_start();
    let mut words = Vec::new();
    while !rest.is_empty() {
        let end = end_of_word(rest);
        words.push(unquoted(&rest[..end]));
        rest = rest[end..].trim_start();
    }
    words
}

/// Where the first word of a text ends: at a blank that stands in no quotation marks.
pub(super) fn end_of_word(text: &str) -> usize {
    end_before(text, char::is_whitespace)
}

/// A line of an INI file up to the semicolon that begins a comment.
pub(super) fn without_comment(line: &str) -> &str {
    &line[..end_before(line, |c| c == ';')]
}

/// Up to the first such letter that stands in no quotation marks.
fn end_before(text: &str, ends: impl Fn(char) -> bool) -> usize {
    let mut open: Option<char> = None;
    for (at, c) in text.char_indices() {
        match open {
            Some(mark) if c == mark => open = None,
            Some(_) => {}
            // A mark without its counterpart is a letter, as in the name of a file.
            None if matches!(c, '"' | '\'') && text[at + 1..].contains(c) => open = Some(c),
            None if ends(c) => return at,
            None => {}
        }
    }
    text.len()
}

/// Without quotation marks that come in pairs.
pub(super) fn unquoted(word: &str) -> String {
    let mut out = String::with_capacity(word.len());
    let mut open: Option<char> = None;
    for (at, c) in word.char_indices() {
        match open {
            Some(mark) if c == mark => open = None,
            None if matches!(c, '"' | '\'') && word[at + 1..].contains(c) => open = Some(c),
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(line: &str, expected: &[&str]) {
        assert_eq!(words(line), expected, "{line}");
    }

    #[test]
    fn words_end_at_blanks_outside_of_quotation_marks() {
        check(" +W8\t +H6 ", &["+W8", "+H6"]);
        check("+I\"a b/s.pov\" +O'c d'", &["+Ia b/s.pov", "+Oc d"]);
        check("\"quickres.ini[160x120, No AA]\"", &["quickres.ini[160x120, No AA]"]);
        check("+Ian's.pov +W8", &["+Ian's.pov", "+W8"]);
        check("Declare='Id=\"text\"'", &["Declare=Id=\"text\""]);
        check("", &[]);
    }

    #[test]
    fn comments_begin_outside_of_quotation_marks() {
        assert_eq!(without_comment("Width=8 ; wide"), "Width=8 ");
        assert_eq!(without_comment("Output_File_Name=\"a;b\";c"), "Output_File_Name=\"a;b\"");
    }
}
