//! `whitted language`: the blocks and words of the language, as the tables have them that scenes are read by.

use super::{fail, print};
use crate::diag::nearest;
use crate::eval::blocks::{Described, DescribedBlock, described};
use std::fmt::Write as _;
use std::process::ExitCode;

/// What was typed.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A block, whose words are listed, or a word, of which is told where it stands [default: list all blocks]
    name: Vec<String>,
}

/// Prints the page, or what may have been meant.
pub(super) fn run(arguments: &Arguments) -> ExitCode {
    let name = arguments.name.join(" ");
    if name.is_empty() {
        return print(&contents());
    }
    match page(&name) {
        Some(text) => print(&text),
        None => {
            let blocks = all_blocks();
            let words = blocks.iter().flat_map(|block| block.words.iter().map(|word| word.word).chain([block.name]));
            let hint = nearest(&name, words).map_or_else(
                || "\nhint: 'whitted language' lists the blocks".to_owned(),
                |near| format!("\nhint: did you mean '{near}'?"),
            );
            fail(format_args!("the language has no block and no word '{name}'{hint}"))
        }
    }
}

/// Characters on a line.
const WIDTH: usize = 100;

/// All blocks, a line each.
fn contents() -> String {
    let mut text =
        "'whitted language NAME' lists what one of these takes, or tells where a word stands.\n\n".to_owned();
    let rows: Vec<_> = described().map(|block| (block.name.to_owned(), block.help.to_owned())).collect();
    columns(&mut text, &rows);
    text
}

/// Blocks of a name, then where that is a word of others.
fn page(name: &str) -> Option<String> {
    let mut text = String::new();
    for block in all_blocks() {
        for word in block.words.iter().filter(|word| word.word == name || word.alias == Some(name)) {
            let _ = writeln!(text, "in {} ({}):", block.name, block.help);
            columns(&mut text, &[row(word)]);
        }
    }
    for block in described().filter(|block| block.name == name) {
        separate(&mut text);
        let _ = writeln!(text, "{}: {}", block.name, block.help);
        columns(&mut text, &block.words.iter().map(row).collect::<Vec<_>>());
        for part in &block.parts {
            let _ = writeln!(text, "\n{}: {}", part.name, part.help);
            if described().any(|other| other.name == part.name) {
                words(&mut text, part);
            } else {
                columns(&mut text, &part.words.iter().map(row).collect::<Vec<_>>());
            }
        }
    }
    (!text.is_empty()).then_some(text)
}

/// The blocks, and the parts of blocks that have no page of their own.
fn all_blocks() -> Vec<DescribedBlock> {
    let mut all: Vec<DescribedBlock> = described().collect();
    let mut i = 0;
    while i < all.len() {
        for part in all[i].parts.clone() {
            if all.iter().all(|known| known.name != part.name) {
                all.push(part);
            }
        }
        i += 1;
    }
    all
}

/// Begins a new paragraph, if there is one before.
fn separate(text: &mut String) {
    if !text.is_empty() {
        text.push('\n');
    }
}

/// The words of a block that has a page of its own.
fn words(text: &mut String, block: &DescribedBlock) {
    let mut line = String::new();
    for word in block.all_words() {
        if line.len() + word.word.len() + 4 > WIDTH {
            let _ = writeln!(text, "  {}", line.trim_end());
            line.clear();
        }
        line.push_str(word.word);
        line.push(' ');
    }
    let _ = writeln!(text, "  {}\n  ('whitted language {}' says more)", line.trim_end(), block.name);
}

/// A word with what it takes, and what it does.
fn row(word: &Described) -> (String, String) {
    let mut left = word.word.to_owned();
    if let Some(alias) = word.alias {
        let _ = write!(left, " | {alias}");
    }
    if !word.takes.is_empty() {
        let _ = write!(left, " {}", word.takes);
    }
    let mut right = word.help.to_owned();
    if !word.default.is_empty() {
        let _ = write!(right, "; {} if not given", word.default);
    }
    if word.since > 0 {
        let _ = write!(right, "; since {}.{}", word.since / 100, word.since % 100 / 10);
    }
    (left, right)
}

/// Rows of two columns; what is too long for the first stands on a line of its own.
fn columns(text: &mut String, rows: &[(String, String)]) {
    /// Longest text of the first column.
    const FIRST: usize = 40;
    let fitting = rows.iter().map(|(left, _)| left.chars().count()).filter(|n| *n <= FIRST);
    let first = fitting.max().unwrap_or(4);
    for (left, right) in rows {
        if left.chars().count() > FIRST {
            let _ = writeln!(text, "  {left}\n  {:first$}  {right}", "");
        } else {
            let _ = writeln!(text, "  {left:first$}  {right}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{contents, page};
    use crate::eval::blocks::described;

    #[test]
    fn every_block_has_a_page() {
        let list = contents();
        for block in described() {
            assert!(list.contains(block.help), "{}", block.name);
            let page = page(block.name).unwrap_or_default();
            assert!(block.words.iter().all(|word| page.contains(word.help)), "{page}");
        }
        assert_eq!(page("sphare"), None);
    }

    #[test]
    fn a_page_tells_of_a_block_and_where_its_word_stands() {
        let fog = page("fog").unwrap_or_default();
        assert!(fog.starts_with("in scene (what stands outside of all braces, beside objects and directives):\n  fog { FOG }  haze that hides what is far away\n\nfog: haze"), "{fog}");
        assert!(
            fog.contains("\n  turb_depth FLOAT     where along the ray turbulence is taken; 0.5 if not given\n"),
            "{fog}"
        );
        assert!(fog.contains("\n  turbulence octaves omega lambda\n"), "{fog}");
        let word = page("interior_texture").unwrap_or_default();
        assert!(
            word.starts_with("in object (") && word.contains("; since 3.5\n") && word.contains("\nin material ("),
            "{word}"
        );
        assert_eq!(
            page("colour_map").map(|page| page.lines().next().map(str::to_owned)),
            Some(Some("in light_source (a light):".into()))
        );
        let turned = page("vrotate").unwrap_or_default();
        assert!(
            turned.contains("\n  vrotate (VECTOR, VECTOR)  turned about x, then y, then z, in degrees\n"),
            "{turned}"
        );
        assert!(
            page("functions").is_some_and(|page| page.contains("string functions:") && page.contains("  vstr (N, "))
        );
        assert!(page("function").is_some_and(|page| page.contains("  sum (") && !page.contains("vdot")));
        assert!(page("face_indices").is_some_and(|page| page.starts_with("in faces of a mesh2")));
        assert!(page("mesh2").unwrap_or_default().contains("\n  face_indices {"));
    }
}
