//! Command lines in POV-Ray's form: which files appear, the exit code, what the scene saw, what was said.
//!
//! `tests/command_lines.txt` holds a row for each; where POV-Ray differs, a row says why, and what POV-Ray does.
//! `WHITTED_AGAINST=povray cargo test --release --test command_lines` runs the rows by an installed POV-Ray instead.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

const ROWS: &str = include_str!("command_lines.txt");

/// What scenes say about themselves; the second part only if one of the numbers is not 0.
const SAW: &str = r#"#debug concat("saw ", str(image_width, 0, 0), "x", str(image_height, 0, 0))
#if (clock_on | frame_number | initial_frame | final_frame | clock | clock_delta)
  #debug concat(" frame ", str(frame_number, 0, 0), " of ", str(initial_frame, 0, 0), "-", str(final_frame, 0, 0))
  #debug concat(" clock ", str(clock, 0, 8), " by ", str(clock_delta, 0, 6))
  #debug concat(" from ", str(initial_clock, 0, 2), " to ", str(final_clock, 0, 2))
#end
#debug "\n"
camera { location -3*z look_at 0 } light_source { -9*z, 1 } sphere { 0, 1 pigment { rgb x } }
"#;

/// Scenes, each of which begins with a version and ends with `SAW`, by what stands between.
const SCENES: [(&str, &str); 12] = [
    ("s.pov", ""),
    ("x.y.pov", ""),
    ("noext", ""),
    ("a.txt", ""),
    ("U.POV", ""),
    ("sub/t.pov", ""),
    ("with blank/b c.pov", ""),
    ("lib/inlib.pov", ""),
    ("uses.pov", "#include \"only.inc\"\n"),
    ("warns.pov", "#warning \"look out\"\n"),
    ("writes.pov", "#fopen F \"out.txt\" write\n#write (F, \"written\")\n#fclose F\n"),
    ("usehead.pov", "#debug concat(\"head \", str(Head, 0, 0), \"\\n\")\n"),
];

const FILES: [(&str, &str); 37] = [
    ("saw.inc", SAW),
    ("old.pov", "#include \"saw.inc\"\n"),
    ("bad.pov", "#version 3.7;\n\nsphere { nonsense }\n"),
    (
        "two.pov",
        "#version 3.7; global_settings { assumed_gamma 1 }\n#include \"saw.inc\"\n#if (frame_number = 2) #error \"not this one\" #end\n",
    ),
    (
        "usedecl.pov",
        "#version 3.7; global_settings { assumed_gamma 1 }\n#debug concat(\"decl \", str(Foo, 0, 8), \"\\n\")\n#include \"saw.inc\"\n",
    ),
    ("head.inc", "#declare Head = 7;\n"),
    ("lib/only.inc", "#debug \"only here\\n\"\n"),
    ("lib2/only.inc", "#debug \"only there\\n\"\n"),
    ("plain.ini", "Width=9\n; comment\nHeight = 7\n"),
    ("both.ini", "+W8 +H6 Display=off\n"),
    ("two.ini", "Width=20 Height=10\nHeight=9\n"),
    ("sec.ini", "Width=11\n[small]\nHeight=5\n[Big One]\nHeight=15\nWidth=16\n"),
    ("crlf.ini", "Width=8\r\nHeight=6\r\n"),
    ("cr.ini", "Width=8\rHeight=6\r"),
    ("spaced.ini", "Width=8\nHeight=6\nDeclare = Foo = 7\n"),
    ("nonl.ini", "Width=8\nHeight=6"),
    ("hash.ini", "# no comment\nWidth=8\n"),
    ("slash.ini", "// no comment\nWidth=8\n"),
    ("bom.ini", "\u{feff}Width=8\n"),
    ("nest.ini", "plain.ini\nHeight=8\n"),
    ("nestsec.ini", "sec[small]\n"),
    ("self.ini", "self.ini\n"),
    ("badkey.ini", "Width=8\nHieght=6\n"),
    ("scene.ini", "Input_File_Name=x.y.pov\nWidth=8\nHeight=6\n"),
    ("frac.ini", "Width=8,6\nHeight=6\n"),
    ("old.ini", "Buffer_Output=on\nWidth=8\nHeight=6\n"),
    ("quoted.ini", "Output_File_Name=\"q w.png\"\nWidth=8\nHeight=6\n"),
    ("comment.ini", "Width=8 ; wide\nHeight=6;high\nOutput_File_Name=\"a;b.png\"\n"),
    ("tabs.ini", "\tWidth\t=\t8\t\n\n  Height  =  6\n"),
    ("lib/inlib.ini", "Width=12\nHeight=8\n"),
    ("anim.ini", "Final_Frame=3\nWidth=8\nHeight=6\n"),
    ("unq.ini", "Output_File_Name=q w.png\nWidth=8\nHeight=6\n"),
    ("shell.ini", "Pre_Scene_Command=touch ran\nPost_Frame_Command=touch ran\nWidth=8\nHeight=6\n"),
    ("caseini.ini", "wIdTh=8\nHEIGHT=6\n"),
    ("scenebare.ini", "x.y.pov\nWidth=8\nHeight=6\n"),
    ("d/.keep", ""),
    ("sub/.keep", ""),
];

/// What is looked for among the messages.
const WORDS: [&str; 11] = [
    "Problem with option",
    "Parse Error",
    "Cannot parse input",
    "Render failed",
    "POV-Ray finished",
    "Rendering frame",
    "prohibited",
    "Invalid start",
    "Invalid end",
    "look out",
    "skipping",
];

#[test]
fn command_lines_do_what_they_do_in_povray() {
    let against = std::env::var("WHITTED_AGAINST").ok();
    let rows: Vec<&str> = ROWS.lines().filter(|row| !row.is_empty() && !row.starts_with('#')).collect();
    assert!(rows.len() >= 200, "{} rows", rows.len());
    let (next, wrong) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(row) = rows.get(i) else { break };
                    if let Err(message) = check(row, against.as_deref()) {
                        wrong.lock().unwrap_or_else(PoisonError::into_inner).insert(i, message);
                    }
                }
            });
        }
    });
    let wrong: Vec<String> = wrong.into_inner().unwrap_or_else(PoisonError::into_inner).into_values().collect();
    assert!(wrong.is_empty(), "{} of {} rows:\n{}", wrong.len(), rows.len(), wrong.join("\n"));
}

/// Runs a row: `ARGUMENTS [<<< PREPARATION] | EXIT | FILES | SAW | SAID [| WHY | …POV-Ray's four]`.
fn check(row: &str, against: Option<&str>) -> Result<(), String> {
    let fields: Vec<&str> = row.split('|').map(str::trim).collect();
    let expected = match (fields.len(), against) {
        (5, _) | (10, None) => &fields[1..5],
        (10, Some(_)) => &fields[6..10],
        _ => return Err(format!("{row}\n    has {} fields", fields.len())),
    };
    let (arguments, preparation) = fields[0].split_once(" <<< ").unwrap_or((fields[0], ""));
    let found = run(&words(arguments), preparation, against).map_err(|error| format!("{row}\n    {error}"))?;
    if found == expected { Ok(()) } else { Err(format!("{row}\n    found: {}", found.join(" | "))) }
}

/// Exit code, new files, what the scene saw, what was said.
fn run(arguments: &[String], preparation: &str, against: Option<&str>) -> std::io::Result<[String; 4]> {
    let folder = tempfile::tempdir()?;
    let folder = folder.path();
    for (name, text) in scenes().chain(FILES.map(|(name, text)| (name, text.to_owned()))) {
        fs::create_dir_all(folder.join(name).parent().unwrap_or(folder))?;
        fs::write(folder.join(name), text)?;
    }
    if !preparation.is_empty() {
        Command::new("sh").args(["-c", preparation]).current_dir(folder).status()?;
    }
    let before = files_below(folder, folder)?;
    let mut command = Command::new(against.unwrap_or(env!("CARGO_BIN_EXE_whitted")));
    if against.is_none() {
        command.arg("povray");
    }
    command
        .args(arguments)
        .arg("-D")
        .current_dir(folder)
        .env_remove("POVINI")
        .env_remove("POVINC")
        .stdin(Stdio::null());
    let output = command.output()?;
    let mut files: Vec<String> = Vec::new();
    for (name, bytes) in files_below(folder, folder)?.into_iter().filter(|(name, _)| !before.contains_key(name)) {
        files.push(format!("{name}={}", kind(&name, &bytes)));
    }
    if !output.stdout.is_empty() {
        files.push(format!("-={}", kind("-", &output.stdout)));
    }
    let said = String::from_utf8_lossy(&output.stderr).replace("\n from", " from").replace("\n to", " to");
    let saw = said.lines().filter(|line| ["saw", "only", "head", "decl"].iter().any(|word| line.starts_with(word)));
    let saw: Vec<&str> = saw.map(|line| line.strip_prefix("saw ").unwrap_or(line)).collect();
    let words: Vec<&str> = WORDS.into_iter().filter(|word| said.contains(word)).collect();
    let exit = output.status.code().map_or("signal".into(), |code| code.to_string());
    Ok([exit, files.join(", "), saw.join("; "), words.join(", ")])
}

fn scenes() -> impl Iterator<Item = (&'static str, String)> {
    let version = "#version 3.7; global_settings { assumed_gamma 1 }\n";
    SCENES.into_iter().map(move |(name, inner)| (name, format!("{version}{inner}{SAW}")))
}

/// Names from `root`, with bytes.
fn files_below(folder: &Path, root: &Path) -> std::io::Result<BTreeMap<String, Vec<u8>>> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(files_below(&path, root)?);
        } else {
            let name = path.strip_prefix(root).unwrap_or(&path).to_string_lossy().into_owned();
            files.insert(name, fs::read(&path)?);
        }
    }
    Ok(files)
}

/// What kind of file that is, and for pictures bits of a pixel and size.
fn kind(name: &str, bytes: &[u8]) -> String {
    let number = |at: usize, n: usize| bytes[at..at + n].iter().fold(0_u32, |all, byte| (all << 8) | u32::from(*byte));
    let swapped = |at: usize, n: usize| number(at, n).swap_bytes() >> (32 - 8 * n);
    match bytes {
        [] => "0".into(),
        [0x89, b'P', b'N', b'G', ..] => {
            let channels = match bytes[25] {
                0 => 1,
                2 => 3,
                4 => 2,
                _ => 4,
            };
            format!("png{}:{}x{}", u32::from(bytes[24]) * channels, number(16, 4), number(20, 4))
        }
        [b'P', digit @ (b'5' | b'6'), ..] => {
            let text = String::from_utf8_lossy(&bytes[2..bytes.len().min(400)]).into_owned();
            let lines = text.lines().filter(|line| !line.starts_with('#'));
            let numbers: Vec<&str> = lines.flat_map(str::split_whitespace).take(3).collect();
            let name = if *digit == b'6' { "ppm" } else { "pgm" };
            format!("{name}:{}x{}:{}", numbers[0], numbers[1], numbers[2])
        }
        [b'B', b'M', ..] => format!("bmp{}:{}x{}", bytes[28], swapped(18, 4), swapped(22, 4)),
        [0xff, 0xd8, ..] => "jpg".into(),
        [b'v', b'/', b'1', 1, ..] => "exr".into(),
        [b'#', b'?', ..] => "hdr".into(),
        // Such files have no number at their beginning.
        [_, 0, kind @ (2 | 10), ..] if name == "-" || name.ends_with(".tga") => {
            format!("tga{kind}-{}:{}x{}", bytes[16], swapped(12, 2), swapped(14, 2))
        }
        _ => "text".into(),
    }
}

/// The words of a command line, as a shell cuts them.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut open) = (Vec::new(), None::<String>, None);
    for c in line.chars() {
        match open {
            Some(mark) if c == mark => open = None,
            None if matches!(c, '"' | '\'') => {
                open = Some(c);
                word.get_or_insert_default();
            }
            None if c == ' ' => words.extend(word.take()),
            _ => word.get_or_insert_default().push(c),
        }
    }
    words.extend(word);
    words
}

#[test]
fn words_are_cut_as_by_a_shell() {
    assert_eq!(words("'a b'  +I\"c d\" '\"e f\"'"), ["a b", "+Ic d", "\"e f\""]);
}
