//! Scenes as text: `whitted expand` writes what it reads back to the same bits.

use std::path::{Path, PathBuf};
use whitted::compile::{self, Queries};
use whitted::eval::{self, Disk, Evaluated, Host, Memory, Options, Reach};
use whitted::expanded::{self, Style};
use whitted::render::{self, Unobserved};

/// Where Debian and others put what comes with POV-Ray.
const INSTALLED: &str = "/usr/share/povray-3.7/include";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Scenes below a folder.
fn scenes(folder: &Path) -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = Vec::new();
    for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
        if path.is_dir() {
            found.extend(scenes(&path));
        } else if path.extension().is_some_and(|e| e == "pov") {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn options() -> Options {
    Options { include_dirs: vec![INSTALLED.into()], image_width: 32, image_height: 24, ..Options::default() }
}

fn read(scene: &Path, host: &dyn Host) -> Result<Evaluated, String> {
    read_with(&options(), scene, host)
}

fn read_with(options: &Options, scene: &Path, host: &dyn Host) -> Result<Evaluated, String> {
    expanded::evaluate(scene, options, host, &Queries::default())
        .map_err(|failed| failed.diagnostics.iter().map(|d| d.render(&failed.sources, false)).collect())
}

/// A small picture's bits.
fn picture(read: &Evaluated) -> Vec<u32> {
    let world = compile::compile(&read.scene).expect("a world").world;
    let options = render::Options { width: 32, height: 24, antialias: None, ..render::Options::default() };
    let rendered = render::render(&world, &options, &Unobserved);
    (0..24)
        .flat_map(|y| (0..32).flat_map(move |x| [(x, y)]))
        .flat_map(|(x, y)| rendered.picture.pixel(x, y).map(f32::to_bits))
        .collect()
}

/// Golden scenes and examples, expanded, give the same text again and the same picture to the bit.
#[test]
fn expanded_scenes_are_the_same_scenes() {
    let work = tempfile::tempdir().expect("a folder");
    let text_file = work.path().join("expanded.pov");
    let all: Vec<PathBuf> = ["golden", "examples"].iter().flat_map(|folder| scenes(&root().join(folder))).collect();
    assert!(all.len() > 70, "{}", all.len());
    let (mut wrong, mut n_read) = (Vec::new(), 0);
    for scene in all {
        let reach = Reach {
            scene: scene.clone(),
            include: vec![INSTALLED.into()],
            read: vec![work.path().into(), root().into()],
            ..Reach::default()
        };
        let host = Disk::new(&reach, |_, _| {});
        // What needs files of a POV-Ray that is not installed is no matter of this test.
        let Ok(first) = read(&scene, &host) else { continue };
        n_read += 1;
        let text = expanded::text(&first.scene, &Style::default());
        std::fs::write(&text_file, &text).expect("a file");
        let name = scene.display();
        match read(&text_file, &host) {
            Err(why) => wrong.push(format!("{name}: {why}")),
            Ok(second) if expanded::text(&second.scene, &Style::default()) != text => {
                wrong.push(format!("{name}: another text"));
            }
            Ok(second) if picture(&first) != picture(&second) => wrong.push(format!("{name}: another picture")),
            Ok(_) => {}
        }
    }
    assert!(wrong.is_empty() && n_read > 70, "{n_read}\n{}", wrong.join("\n"));
}

/// `tests/expanded/NAME.pov` is written as `NAME.txt` and compiled to what `NAME.compiled.txt` shows;
/// `UPDATE_SNAPSHOTS=1` writes these anew.
#[test]
fn scenes_are_written_as_they_were() -> std::io::Result<()> {
    let all = scenes(&root().join("tests/expanded"));
    assert!(all.len() >= 4, "{}", all.len());
    for scene in all {
        let host = Disk::new(&Reach { scene: scene.clone(), ..Reach::default() }, |_, _| {});
        let options = Options { origins: true, ..options() };
        let read = read_with(&options, &scene, &host).unwrap_or_else(|why| panic!("{why}"));
        let style = Style { origins: Some(&read.sources), ..Style::default() };
        let prefix = format!("{}/", root().display());
        let text = expanded::text(&read.scene, &style).replace(&prefix, "");
        let compiled = compile::compile(&read.scene).expect("a world").world.dump();
        for (kept, found) in [("txt", text), ("compiled.txt", compiled)] {
            let kept = scene.with_extension(kept);
            if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
                std::fs::write(kept, found)?;
            } else {
                assert_eq!(std::fs::read_to_string(&kept)?, found, "{}", kept.display());
            }
        }
    }
    Ok(())
}

/// Comments tell the whole way: calls in calls, includes within them, recursions once, what stands in an argument by
/// the caller's place; loops are no part of it, and nothing is told of how files without macros came in.
#[test]
fn origins_tell_which_calls_led_there() {
    let scene =
        "#version 3.7;\n#include \"trees.inc\"\nForest(2)\n#for (I, 1, 3) Leaf() #end\nGroup(sphere { 0, 9 })\n";
    let trees = "#macro Leaf() sphere { 0, 1 } #end\n#macro Tree(N)\n #if (N > 0)\n  Tree(N - 1)\n #else Leaf() #end\n#end\n\
                 #macro Forest(N)\n Tree(N)\n #include \"rock.inc\"\n#end\nbox { 0, 1 }\n\
                 #macro Group(A) union { A Leaf() } #end\n";
    let host = Memory::new([("a.pov", scene), ("trees.inc", trees), ("rock.inc", "\ntorus { 2, 1 }")]);
    let options = Options { origins: true, ..options() };
    let read = read_with(&options, "a.pov".as_ref(), &host).unwrap_or_else(|why| panic!("{why}"));
    let text = expanded::text(&read.scene, &Style { origins: Some(&read.sources), ..Style::default() });
    let told: Vec<&str> = text.lines().skip(1).filter_map(|line| line.trim_start().strip_prefix("// ")).collect();
    let expected = [
        "trees.inc:11",
        "trees.inc:1 in Leaf, called at trees.inc:5 in Tree, called at trees.inc:4 in Tree (2 times), called at \
         trees.inc:8 in Forest, called at a.pov:3",
        "rock.inc:2, included at trees.inc:9 in Forest, called at a.pov:3",
        "trees.inc:1 in Leaf, called at a.pov:4",
        "trees.inc:1 in Leaf, called at a.pov:4",
        "trees.inc:1 in Leaf, called at a.pov:4",
        "trees.inc:12 in Group, called at a.pov:5",
        "a.pov:5",
        "trees.inc:1 in Leaf, called at trees.inc:12 in Group, called at a.pov:5",
    ];
    assert_eq!(told, expected);
    assert_eq!(read.sources.files().len(), 3, "visits are no files");
}

/// What a macro builds ten thousand times is written once, and what is placed is one short line more.
#[test]
fn text_grows_with_what_is_written() {
    let size = |copies: u32| {
        let scene = format!(
            "#version 3.7; #declare Tree = union {{ sphere {{ 0, 1 }} cylinder {{ 0, -y, 0.1 }} }}
             #declare Row = union {{ #for (I, 1, 100) object {{ Tree translate I*x }} #end }}
             #for (J, 1, {copies}) object {{ Row rotate J*y translate J*z pigment {{ rgb 1 }} }} #end"
        );
        let host = Memory::new([("a.pov", scene.as_str())]);
        let read = read("a.pov".as_ref(), &host).unwrap_or_else(|why| panic!("{why}"));
        expanded::text(&read.scene, &Style::default()).len()
    };
    let (few, many) = (size(1), size(101));
    assert!(many - few < 100 * 400, "{few} {many}");
}

/// Only the first line makes a text an expanded scene, and POV-Ray's language has no say in it.
#[test]
fn expanded_scenes_run_nothing() {
    let text = format!("{}\n#version 3.7;\n#include \"colors.inc\"\n", expanded::MARK);
    let host = Memory::new([("a.pov", text.as_str())]);
    let failed =
        expanded::evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()).expect_err("refused");
    assert!(failed.diagnostics[0].message.starts_with("expected"), "{:?}", failed.diagnostics);
    let plain = Memory::new([("a.pov", "#version 3.7; #declare A = 1; sphere { 0, A }")]);
    assert!(eval::evaluate("a.pov".as_ref(), &Options::default(), &plain, &Queries::default()).is_ok());
}

/// What nests deeply is refused or read, and needs no more stack than there is.
#[test]
fn deep_scenes_are_no_danger() {
    for (open, close) in
        [("union { ", "}"), ("sphere { <0, 0, 0>, 1 texture { pigment { bozo pigment_map { [0 ", "] } } } }")]
    {
        for n in [1_000, 30_000] {
            let text = format!("{}\n#version 3.7;\n{}{}", expanded::MARK, open.repeat(n), close.repeat(n));
            let host = Memory::new([("a.pov", text.as_str())]);
            let read = expanded::evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default());
            assert!(read.is_ok() == (open.starts_with("union") && n == 1_000), "{n} {open}");
        }
    }
}

/// `whitted trace` tells of the same light to the bit.
#[test]
fn told_pixels_are_the_pictures_own() {
    for (scene, pixels) in
        [("examples/04_glass.pov", 12), ("examples/10_patterns.pov", 6), ("golden/media/fog_media.pov", 4)]
    {
        let path = root().join(scene);
        let host = Disk::new(&Reach { scene: path.clone(), ..Reach::default() }, |_, _| {});
        let Ok(read) = read(&path, &host) else { continue };
        let world = compile::compile(&read.scene).expect("a world").world;
        let options = render::Options { width: 32, height: 24, antialias: None, ..render::Options::default() };
        let picture = render::render(&world, &options, &Unobserved).picture;
        for i in 0..pixels {
            let (x, y) = (5 + i * 7 % 25, 3 + i * 5 % 20);
            let told = render::tell(&world, &options, [x, y]);
            assert_eq!(
                told.pixel.map(f32::to_bits),
                picture.pixel(x, y).map(f32::to_bits),
                "{scene} {x},{y}\n{}",
                told.text
            );
            assert!(told.text.starts_with("camera ray from"), "{}", told.text);
        }
    }
}
