//! Wrong scenes and what is said about them: `tests/wrong/NAME.pov` must give `NAME.txt`, to the letter.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --release --test wrong` writes the messages anew; read the difference before it is
//! kept. Only the include files of this program are used, so that an installed POV-Ray changes nothing.

use std::fmt::Write as _;
use std::path::Path;
use whitted::compile::{self, Queries};
use whitted::diag::{Diagnostic, SourceMap};
use whitted::eval::{Disk, Limits, Options, Reach};
use whitted::expanded;

/// All that is said about a scene, as `whitted render --embedded-includes` says it.
fn messages(scene: &Path) -> String {
    let host = Disk::new(&Reach { scene: scene.to_owned(), ..Reach::default() }, |_, _| {});
    let show = |diagnostics: &[Diagnostic], sources: &SourceMap| -> String {
        diagnostics.iter().map(|d| d.render(sources, false)).collect()
    };
    let options = Options { limits: Limits::strict(), ..Options::default() };
    match expanded::evaluate(scene, &options, &host, &Queries::default()) {
        Err(failed) => show(&failed.diagnostics, &failed.sources),
        Ok(read) => {
            let compiled = match compile::compile(&read.scene) {
                Ok(compiled) => compiled.warnings,
                Err(errors) => errors,
            };
            show(&read.warnings, &read.sources) + &show(&compiled, &read.sources)
        }
    }
}

/// The mistake itself must be named, not only the missing `#version`, which most of these scenes leave out.
fn names_a_mistake(messages: &str) -> bool {
    messages.lines().any(|line| {
        line.starts_with("error:") || line.starts_with("warning[") && !line.starts_with("warning[version]: this scene")
    })
}

#[test]
fn wrong_scenes_get_their_messages() -> std::io::Result<()> {
    let update = std::env::var_os("UPDATE_SNAPSHOTS").is_some();
    let mut scenes: Vec<_> = std::fs::read_dir("tests/wrong")?.collect::<Result<_, _>>()?;
    scenes.retain(|entry| entry.path().extension().is_some_and(|e| e == "pov"));
    scenes.sort_by_key(std::fs::DirEntry::path);
    assert!(scenes.len() >= 40, "only {} scenes were found", scenes.len());
    let mut failures = String::new();
    for scene in scenes {
        let path = scene.path();
        let (said, kept) = (messages(&path), path.with_extension("txt"));
        if !names_a_mistake(&said) {
            let _ = writeln!(failures, "{}: nothing is said about the mistake\n{said}", path.display());
        }
        if update {
            std::fs::write(kept, said)?;
        } else if std::fs::read_to_string(&kept).unwrap_or_default() != said {
            let _ = writeln!(failures, "{} has other messages now:\n{said}", path.display());
        }
    }
    assert!(failures.is_empty(), "{failures}");
    Ok(())
}
