//! Whatever the input, the program answers soon if it was told not to trust it: an error with its place, exit code 2, no picture.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Each case takes at most two seconds by itself; the machine may have other things to do.
const PATIENCE: Duration = Duration::from_secs(30);

/// Renders a scene of a folder; what was said.
fn refused(folder: &Path, scene: &str) -> std::io::Result<String> {
    let mut child = Command::new(env!("CARGO_BIN_EXE_whitted"))
        .current_dir(folder)
        .args(["render", scene, "--untrusted", "--output", "out.exr", "--width", "8", "--preview=out.png"])
        .stdout(Stdio::null())
        .stderr(std::fs::File::create(folder.join("said.txt"))?)
        .spawn()?;
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if start.elapsed() > PATIENCE {
            child.kill()?;
            panic!("{scene}: no answer after {} seconds", PATIENCE.as_secs());
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let said = String::from_utf8_lossy(&std::fs::read(folder.join("said.txt"))?).into_owned();
    assert_eq!(status.code(), Some(2), "{scene}: {}", said.chars().take(2000).collect::<String>());
    assert!(!folder.join("out.exr").exists() && !folder.join("out.png").exists(), "{scene}: a picture was written");
    Ok(said)
}

/// A scene of these bytes is refused with these words.
fn check(bytes: &[u8], words: &[&str]) -> std::io::Result<()> {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("bad.pov"), bytes)?;
    says(&refused(folder.path(), "bad.pov")?, words);
    Ok(())
}

fn says(said: &str, words: &[&str]) {
    assert!(said.len() < 20_000, "{} bytes were said", said.len());
    for word in words {
        assert!(said.contains(word), "no '{word}' in\n{said}");
    }
}

#[test]
fn files_that_are_no_scenes() -> std::io::Result<()> {
    check(b"\0\0\0\0spere", &["bad.pov:1:"])?;
    check(b"\x7fELF\x02\x01\x01\0\0\0\0\xff\xfe", &["bad.pov:1:1", "no meaning"])?;
    check(b"\xff\xfe s\0p\0h\0e\0r\0e\0", &["bad.pov:1:"])?;
    check(b"sphere { 0, 1 pigment { rgb \xe9 } }", &["bad.pov:1:29", "no meaning"])
}

#[test]
fn files_that_cannot_be_read() -> std::io::Result<()> {
    let folder = tempfile::tempdir()?;
    says(&refused(folder.path(), "missing.pov")?, &["missing.pov"]);
    std::fs::create_dir(folder.path().join("folder.pov"))?;
    says(&refused(folder.path(), "folder.pov")?, &["folder.pov"]);
    std::fs::write(folder.path().join("itself.pov"), "#include \"itself.pov\"")?;
    says(&refused(folder.path(), "itself.pov")?, &["itself.pov:1:1", "include_depth=N"]);
    std::fs::write(folder.path().join("reads_folder.pov"), "#include \"folder.pov\"")?;
    says(&refused(folder.path(), "reads_folder.pov")?, &["reads_folder.pov:1:"]);
    let host_file = PathBuf::from("/etc/hostname");
    if host_file.exists() {
        std::fs::write(folder.path().join("spy.pov"), "#include \"/etc/hostname\"")?;
        says(&refused(folder.path(), "spy.pov")?, &["spy.pov:1:", "--allow-read /etc "]);
    }
    Ok(())
}

#[test]
fn a_long_line() -> std::io::Result<()> {
    const BYTES: usize = 100_000_000;
    let mut text = b"sphere { 0, 1 } ".repeat(BYTES / 16 / 100);
    text.resize(BYTES, b' ');
    text.extend(b"spere");
    check(&text, &["bad.pov:1:100000001", "did you mean 'sphere'?"])?;
    check(&vec![b'a'; BYTES], &["bad.pov:1:1", "255"])
}

#[test]
fn endless_loops() -> std::io::Result<()> {
    let limit = ["bad.pov:1:", "--limit steps=N"];
    check(b"#while (1) #end", &limit)?;
    check(b"#while (1) #declare A = 1; #end", &limit)?;
    check(b"#macro M() #end #while (1) M() #end", &limit)?;
    check(b"#for (I, 0, 1e30) #end", &limit)?;
    check(b"#while (1) sphere { 0, 1 } #end", &["bad.pov:1:", "--limit "])?;
    check(b"union { #while (1) sphere { 0, 1 } #end }", &["bad.pov:1:", "--limit "])
}

#[test]
fn things_that_grow() -> std::io::Result<()> {
    check(b"#declare A = array[3000][3000][3000];", &["bad.pov:1:", "--limit array_elements=N"])?;
    check(b"#declare S = \"aaaa\"; #while (1) #declare S = concat(S, S); #end", &["--limit string_bytes=N"])?;
    check(b"#macro M() M() #end M()", &["bad.pov:1:", "--limit macro_depth=N"])?;
    let deep = |text: &str| text.repeat(100_000).into_bytes();
    check(&deep("union { "), &["bad.pov:1:", "--limit nesting=N"])?;
    check(&[b"#declare A = ".to_vec(), deep("(")].concat(), &["bad.pov:1:", "--limit nesting=N"])?;
    check(&deep("#if (1) "), &["bad.pov:1:"])
}

#[test]
fn mistakes() -> std::io::Result<()> {
    check(b"sphere { 0, 1", &["bad.pov:1:"])?;
    check(b"sphere { 0, Radius }", &["bad.pov:1:13", "Radius"])?;
    check(b"sphere { 0, \"1\" }", &["bad.pov:1:13", "a string"])?;
    check(b"#include \"missing.inc\"", &["bad.pov:1:", "--include DIR"])?;
    check(b"plane { y, 0 pigment { image_map { png \"missing.png\" } } }", &["bad.pov:1:", "missing.png"])
}

/// Sixty times over, each line made of the one before twice.
fn doubled(first: &str, step: &str, end: &str) -> String {
    format!("#version 3.7;\n#declare A = {first}\n{}{end}\n", format!("#declare A = {step}\n").repeat(60))
}

#[test]
fn copies_of_copies() -> std::io::Result<()> {
    let many = ["bad.pov:63:1", "parts=N"];
    check(doubled("sphere { 0 1 }", "union { object { A } object { A rotate y } }", "object { A }").as_bytes(), &many)?;
    for operation in ["merge", "intersection", "difference"] {
        let step = format!("{operation} {{ object {{ A }} object {{ A translate x }} }}");
        check(doubled("sphere { 0 1 }", &step, "object { A }").as_bytes(), &many)?;
    }
    check(
        doubled("sphere { 0 1 }", "object { A clipped_by { A } bounded_by { A } }", "object { A }").as_bytes(),
        &many,
    )?;
    let lit = "union { light_source { 0 1 looks_like { sphere { 0 1 } } } }";
    check(doubled(lit, "union { object { A } object { A } }", "object { A }").as_bytes(), &many)?;
    let inside = ["200000 pigments"];
    for (first, step, end) in [
        ("pigment { rgb 1 }", "pigment { average pigment_map { [1 A] [1 A] } }", "pigment { A }"),
        ("normal { bumps }", "normal { gradient x normal_map { [0 A] [1 A] } }", "pigment { rgb 1 } normal { A }"),
        ("texture { pigment { rgb 1 } }", "texture { checker texture { A } texture { A } }", "texture { A }"),
    ] {
        check(doubled(first, step, &format!("sphere {{ 0 1 {end} }}")).as_bytes(), &inside)?;
    }
    check(
        doubled("texture { pigment { rgbt .5 } }", "texture { A } texture { A }", "").as_bytes(),
        &["1000000 layers"],
    )?;
    check(doubled("\"ab\"", "concat(A, A)", "#debug A").as_bytes(), &["string_bytes=N"])?;
    // What is shared may be asked about: the error comes behind it.
    let asks = "#declare E = max_extent(A) + trace(A, -5*z, z); #declare I = inside(A, <0, 0, 0>);\nobject { B }";
    check(doubled("sphere { 0 1 }", "union { object { A } object { A } }", asks).as_bytes(), &["bad.pov:64:", "'B'"])
}
