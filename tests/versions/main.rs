//! Versions, gamma settings, backgrounds and pictures in all combinations, against POV-Ray's own numbers.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use whitted::compile::{self, Queries};
use whitted::eval::{self, Disk, Reach};
use whitted::job::Session;
use whitted::render::{Options, Unobserved};

/// Half floats hold 11 bits, so half of the last one is 4.9e-4 of a value; the rest is single precision on both sides.
const TOLERANCE: f32 = 5.5e-4;

/// A pixel of a scene with what was asked for.
fn pixel(scene: &Path, options: &str) -> [f32; 4] {
    let version = match options {
        "MV37" => Some(370),
        "MV36" => Some(360),
        _ => None,
    };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/versions");
    let reading = eval::Options { version, include_dirs: vec![folder.clone()], ..eval::Options::default() };
    let reach = Reach { scene: scene.to_owned(), include: vec![folder], ..Reach::default() };
    let host = Disk::new(&reach, |_, _| {});
    let read = eval::evaluate(scene, &reading, &host, &Queries::default());
    let read = read.unwrap_or_else(|f| panic!("{:?}", f.diagnostics));
    let compiled = compile::compile(&read.scene).unwrap_or_else(|e| panic!("{e:?}"));
    let how = Options { width: 4, height: 4, alpha: options == "UA", ..Options::default() };
    Session::new(1).picture(&compiled.world, &how, &Unobserved).picture.pixel(1, 1)
}

#[test]
fn versions_and_gamma_mean_what_they_mean_in_povray() {
    let (mut headers, mut bodies) = (BTreeMap::new(), BTreeMap::new());
    let (mut n, mut wrong) = (0, Vec::new());
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file: PathBuf = folder.path().join("scene.pov");
    for line in include_str!("povray.txt").lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let fields: Vec<&str> = line.split('|').map(str::trim).collect();
        match fields.as_slice() {
            ["header", name, before, behind] => {
                headers.insert(*name, (*before, *behind));
            }
            ["body", name, text] => {
                bodies.insert(*name, *text);
            }
            ["case", header, body, options, expected] => {
                let (before, behind) = headers[header];
                std::fs::write(&file, format!("{before}\n{}\n{behind}\n", bodies[body])).expect("written");
                let expected: Vec<f32> = expected.split(' ').map(|v| v.parse().expect("a number")).collect();
                let found = pixel(&file, options);
                let off = found.iter().zip(&expected).any(|(f, e)| (f - e).abs() > TOLERANCE * e.abs().max(0.01));
                if off {
                    wrong.push(format!("{header} {body} {options}: {found:?} instead of {expected:?}"));
                }
                n += 1;
            }
            _ => panic!("{line}"),
        }
    }
    assert!(n > 400, "{n} cases");
    assert!(wrong.is_empty(), "{} of {n}:\n{}", wrong.len(), wrong.join("\n"));
}
