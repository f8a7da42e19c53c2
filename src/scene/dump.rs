//! The evaluated scene as text, for people and for snapshot tests.

use super::Scene;

/// Longest line that small values are gathered on.
const WIDTH: usize = 110;

impl Scene {
    /// Everything the scene describes, small values gathered on one line. Places in the text are left out, so that a
    /// comment more does not change it.
    pub fn dump(&self) -> String {
        compact(&format!("{self:#?}\n"))
    }
}

/// A block of the text that may still fit on one line.
struct Block {
    /// Its first line in the output, and where that line starts.
    line: usize,
    indent: usize,
}

/// Joins every bracketed block of pretty-printed text that fits on a line.
fn compact(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut open: Vec<Block> = Vec::new();
    for line in text.lines().map(str::trim_end) {
        let indent = line.len() - line.trim_start().len();
        let closes = line.trim_start().starts_with(['}', ']', ')']);
        lines.push(line.to_owned());
        if closes {
            if let Some(block) = open.pop().filter(|block| block.indent == indent) {
                if is_place(&lines[block.line]) {
                    lines.truncate(block.line);
                } else {
                    join(&mut lines, block.line);
                }
            }
        } else if line.ends_with(['{', '[', '(']) {
            open.push(Block { line: lines.len() - 1, indent });
        }
    }
    lines.join("\n") + "\n"
}

fn is_place(line: &str) -> bool {
    line.trim_start().starts_with("span: ")
}

/// Makes the lines from `first` on one line, if it is short enough.
fn join(lines: &mut Vec<String>, first: usize) {
    let total: usize = lines[first..].iter().map(|line| line.trim_start().len() + 1).sum();
    let indent = lines[first].len() - lines[first].trim_start().len();
    if total + indent > WIDTH {
        return;
    }
    let mut joined = lines[first].clone();
    for line in &lines[first + 1..] {
        let (part, tight) = (line.trim_start(), joined.ends_with(['(', '[']));
        if part.starts_with([')', ']', '}']) {
            if joined.ends_with(',') {
                joined.pop();
            }
            joined += if part.starts_with('}') { " " } else { "" };
        } else if !tight {
            joined.push(' ');
        }
        joined += part;
    }
    lines.truncate(first);
    lines.push(joined);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug)]
    #[allow(dead_code, reason = "read by Debug")]
    struct Example {
        span: (u32, u32),
        point: [f64; 3],
        name: Option<&'static str>,
        long: Vec<String>,
    }

    #[test]
    fn small_values_stand_on_one_line() {
        let long = vec!["a".repeat(80), "b".repeat(80)];
        let example = Example { span: (3, 4), point: [1.0, 2.0, 3.0], name: Some("n"), long };
        let text = compact(&format!("{example:#?}"));
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines[..4], ["Example {", "    point: [1.0, 2.0, 3.0],", "    name: Some(\"n\"),", "    long: ["]);
        assert!(lines[4].len() > 80 && lines[6..] == ["    ],", "}"]);
    }
}
