//! The arrows between modules: what ARCHITECTURE.md promises about imports, read off the sources.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// From the first to the last: a module knows those before it, never those behind it.
const ORDER: [&str; 17] = [
    "omission",
    "math",
    "diag",
    "imaging",
    "function",
    "syntax",
    "scene",
    "eval",
    "expanded",
    "compiled",
    "compile",
    "render",
    "job",
    "measure",
    "report",
    "stability",
    "cli",
];

/// Files of code that is not only for tests, with their text up to the tests, comments left out.
fn sources(folder: &Path) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    let mut entries: Vec<PathBuf> =
        std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    entries.sort();
    for path in entries {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && name != "tests" {
            found.extend(sources(&path));
        } else if name.ends_with(".rs") && !["tests.rs", "probes.rs", "formula_probes.rs"].contains(&name.as_str()) {
            let text = std::fs::read_to_string(&path).expect("a source file");
            let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
            let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
            found.push((path, lines.collect::<Vec<_>>().join("\n")));
        }
    }
    found
}

/// The words that follow a prefix in a text, those of `{…}` behind it included.
fn words_after<'t>(text: &'t str, prefix: &str) -> BTreeSet<&'t str> {
    let mut words = BTreeSet::new();
    for (at, _) in text.match_indices(prefix) {
        let rest = &text[at + prefix.len()..];
        let word = |text: &'t str| {
            let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
            &text[..end]
        };
        match rest.strip_prefix('{') {
            Some(list) => words.extend(list.split('}').next().unwrap_or_default().split(',').map(|w| word(w.trim()))),
            None => drop(words.insert(word(rest))),
        }
    }
    words
}

#[test]
fn no_import_runs_back_up() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut wrong = Vec::new();
    for (i, module) in ORDER.iter().enumerate() {
        let mut files = sources(&root.join(module));
        let alone = root.join(module).with_extension("rs");
        files.extend(std::fs::read_to_string(&alone).ok().map(|code| (alone, code)));
        assert!(!files.is_empty(), "{module}");
        for (file, code) in files {
            for later in words_after(&code, "crate::").iter().filter(|w| ORDER[i + 1..].contains(w)) {
                wrong.push(format!("{} knows {later}", file.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn modules_of_the_renderer_form_no_circle() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/render");
    let mut knows: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (file, code) in sources(&root) {
        let below = file.strip_prefix(&root).expect("below the renderer");
        let module = below.components().next().expect("a name").as_os_str().to_string_lossy().replace(".rs", "");
        if module == "mod" {
            continue;
        }
        let is_top = below.components().count() == 1 || below.ends_with("mod.rs");
        let mut others = words_after(&code, "crate::render::");
        if is_top {
            others.extend(words_after(&code, "super::"));
        }
        knows.entry(module).or_default().extend(others.into_iter().map(str::to_owned));
    }
    assert!(knows.len() > 15, "{knows:?}");
    // What knows nobody that is left goes first; what never can is part of a circle.
    while !knows.is_empty() {
        let left: BTreeSet<String> = knows.keys().cloned().collect();
        let before = knows.len();
        knows.retain(|own, others| others.iter().any(|other| other != own && left.contains(other)));
        assert!(knows.len() < before, "a circle among {knows:?}");
    }
}

/// The parts that the evaluator owns can be built alone: none of them knows it, and of each other they know what is
/// listed here.
#[test]
fn parts_of_the_evaluator_stand_alone() {
    let parts: [(&str, &[&str]); 6] = [
        ("feed", &[]),
        ("names", &[]),
        ("budget", &[]),
        ("report", &[]),
        ("data_file", &["feed"]),
        ("world", &["data_file"]),
    ];
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/eval");
    for (part, known) in parts {
        let mut files = sources(&root.join(part));
        let alone = root.join(part).with_extension("rs");
        files.extend(std::fs::read_to_string(&alone).ok().map(|code| (alone, code)));
        assert!(!files.is_empty(), "{part}");
        for (file, code) in files {
            assert!(!code.contains("Evaluator"), "{} knows the evaluator", file.display());
            for (other, _) in parts.iter().filter(|(other, _)| *other != part && !known.contains(other)) {
                assert!(!code.contains(&format!("super::{other}")), "{} knows {other}", file.display());
            }
        }
    }
}
