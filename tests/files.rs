//! Which files a scene may open, statement by statement, and that it sees what it has written: through the program itself.

use std::fs;
use std::io;
use std::path::Path;
use std::process::Command;

/// Statements that open the file FILE, with the ending of its name.
const STATEMENTS: [(&str, &str); 11] = [
    ("inc", "#include \"FILE\""),
    ("txt", "#fopen F \"FILE\" read #read(F, A)"),
    ("png", "plane { y, 0 pigment { image_map { png \"FILE\" } } }"),
    ("exr", "plane { y, 0 pigment { image_map { exr \"FILE\" } } }"),
    ("ppm", "plane { y, 0 pigment { image_pattern { ppm \"FILE\" } } }"),
    ("gif", "plane { y, 0 pigment { rgb 1 } normal { bump_map { gif \"FILE\" } } }"),
    ("tga", "plane { y, 0 texture { material_map { tga \"FILE\" texture { pigment { rgb 1 } } } } }"),
    ("bmp", "#declare F = function { pigment { image_map { bmp \"FILE\" } } } sphere { 0, F(0, 0, 0).x }"),
    ("tiff", "height_field { tiff \"FILE\" }"),
    ("ttf", "text { ttf \"FILE\" \"a\" 1, 0 }"),
    ("df3", "plane { y, 0 pigment { density_file df3 \"FILE\" } }"),
];

/// A home folder with a scene's folder in it, and files in all places that matter.
fn folders() -> io::Result<tempfile::TempDir> {
    let root = tempfile::tempdir()?;
    for (ending, _) in STATEMENTS {
        for place in ["home/scenes", "home/lib", "home/.secret", "include", "out"] {
            let folder = root.path().join(place);
            fs::create_dir_all(&folder)?;
            fs::write(folder.join(format!("f.{ending}")), "")?;
        }
        #[cfg(unix)]
        std::os::unix::fs::symlink(
            root.path().join("out").join(format!("f.{ending}")),
            root.path().join(format!("home/scenes/link.{ending}")),
        )?;
    }
    fs::create_dir(root.path().join("elsewhere"))?;
    Ok(root)
}

/// What is said about a scene in `home/scenes`, from a folder elsewhere.
fn said(root: &Path, text: &str, options: &[&str]) -> io::Result<String> {
    let scene = root.join("home/scenes/s.pov");
    fs::write(&scene, format!("#version 3.7; global_settings {{ assumed_gamma 1 }}\n{text}\n"))?;
    let output = Command::new(env!("CARGO_BIN_EXE_whitted"))
        .current_dir(root.join("elsewhere"))
        .env("HOME", root.join("home"))
        .args(["check", "--embedded-includes", "--include", "../include"])
        .args(options)
        .arg(&scene)
        .output()?;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(matches!(output.status.code(), Some(0 | 2)), "{text}: {said}");
    Ok(said)
}

/// Whether each statement may open a file of that name, without its ending.
fn check(name: &str, options: &[&str], expected: bool) -> io::Result<()> {
    let root = folders()?;
    let name = name.replace("ROOT", &root.path().display().to_string());
    for (ending, statement) in STATEMENTS {
        let text = statement.replace("FILE", &format!("{name}.{ending}"));
        let said = said(root.path(), &text, options)?;
        assert_eq!(said.contains("--allow-read /"), !expected, "{text} with {options:?}:\n{said}");
        assert!(!said.contains("cannot find"), "{text} with {options:?}:\n{said}");
    }
    Ok(())
}

#[test]
fn files_of_the_scene() -> io::Result<()> {
    for options in [&[][..], &["--untrusted"]] {
        check("f", options, true)?;
        check("../scenes/f", options, true)?;
        check("../include/f", options, true)?;
        check("ROOT/home/scenes/f", options, true)?;
    }
    Ok(())
}

#[test]
fn files_of_the_user() -> io::Result<()> {
    check("../lib/f", &[], true)?;
    check("ROOT/home/lib/f", &[], true)?;
    check("../lib/f", &["--untrusted"], false)?;
    check("ROOT/home/lib/f", &["--untrusted"], false)?;
    check("../.secret/f", &[], false)?;
    check("ROOT/home/scenes/../.secret/f", &[], false)?;
    check("../.secret/f", &["--allow-read", "../home/.secret"], true)
}

#[test]
fn files_of_others() -> io::Result<()> {
    for name in ["ROOT/out/f", "../../out/f"] {
        check(name, &[], false)?;
        check(name, &["--untrusted"], false)?;
        check(name, &["--allow-read", "../out"], true)?;
    }
    if cfg!(unix) {
        check("link", &[], false)?;
        check("link", &["--allow-read", "../out"], true)?;
    }
    Ok(())
}

/// A scene in which `FILE` was written says what it read; an old file of that name, beside the scene and in the
/// working folder, does not count.
fn check_written(write: &str, read: &str, ending: &str) -> io::Result<()> {
    for options in [&[][..], &["--allow-write", "."]] {
        let root = folders()?;
        fs::write(root.path().join(format!("elsewhere/f.{ending}")), "1")?;
        let name = format!("\"f.{ending}\"");
        let text = format!("#fopen W {name} write #write(W, {write}) #fclose W\n{}", read.replace("FILE", &name));
        let said = said(root.path(), &text, options)?;
        assert!(said.contains("[found]"), "{text} with {options:?}:\n{said}");
        let kept = fs::read(root.path().join(format!("elsewhere/f.{ending}")))? != b"1";
        assert_eq!(kept, !options.is_empty(), "{text}");
    }
    Ok(())
}

#[test]
fn written_files_are_read() -> io::Result<()> {
    check_written("\"#declare A = \\\"[found]\\\";\"", "#include FILE #debug A", "inc")?;
    check_written("\"\\\"[found]\\\"\"", "#fopen R FILE read #read(R, A) #debug A", "txt")?;
    let picture = "#declare F = function { pigment { image_map { ppm FILE } } } #declare C = F(.5, .5, 0);
        #if (C.x = 1 & C.y = 0) #debug \"[found]\" #end";
    check_written("\"P3\\n1 1\\n255\\n255 0 0\\n\"", picture, "ppm")?;
    let density =
        "#declare F = function { pattern { density_file df3 FILE } } #if (F(.5, .5, .5) = 1) #debug \"[found]\" #end";
    check_written("uint16be 1, uint16be 1, uint16be 1, uint8 255", density, "df3")?;
    let twice = "#include FILE #fopen W FILE append #write(W, \"#debug A\") #fclose W #include FILE";
    check_written("\"#declare A = \\\"[found]\\\";\\n\"", twice, "inc")
}

/// A picture that the scene changes is another picture afterwards.
#[test]
fn pictures_may_be_written_anew() -> io::Result<()> {
    let root = folders()?;
    let paint = |color: &str| {
        format!(
            "#fopen W \"p.ppm\" write #write(W, \"P3\\n1 1\\n255\\n{color}\\n\") #fclose W
             #declare F = function {{ pigment {{ image_map {{ ppm \"p.ppm\" }} }} }} #declare C = F(.5, .5, 0);
             #debug concat(\"[\", vstr(3, <C.x, C.y, C.z>, \",\", 0, 0), \"]\")"
        )
    };
    let said = said(root.path(), &format!("{}\n#undef F\n{}", paint("255 0 0"), paint("0 0 255")), &[])?;
    assert!(said.contains("[1,0,0]") && said.contains("[0,0,1]"), "{said}");
    Ok(())
}

#[test]
fn strings_are_parsed() -> io::Result<()> {
    let text = "#include \"strings.inc\" Parse_String(\"#declare A = 3;\") #if (A = 3) #debug \"[found]\" #end";
    for options in [&[][..], &["--untrusted"], &["--allow-write", "."]] {
        let said = said(folders()?.path(), text, options)?;
        assert!(said.contains("[found]"), "{options:?}:\n{said}");
    }
    Ok(())
}

#[test]
fn only_files_that_may_be_read_exist() -> io::Result<()> {
    let root = folders()?;
    let text = "#debug concat(\"[\", str(file_exists(\"f.inc\"), 0, 0), str(file_exists(\"../.secret/f.inc\"), 0, 0), \
                str(file_exists(\"../../out/f.inc\"), 0, 0), \"]\")";
    assert!(said(root.path(), text, &[])?.contains("[100]"));
    Ok(())
}
