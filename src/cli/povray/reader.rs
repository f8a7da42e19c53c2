//! Arguments and INI files, one after the other, to settings.
//!
//! Source: command line facts, sections 1 and 2.

use super::keys::{Action, KEYS, Key};
use super::settings::Settings;
use super::switches::{SWITCHES, assignments};
use super::words::{end_of_word, unquoted, without_comment, words};
use crate::diag::nearest;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// What was understood.
#[derive(Debug, Default)]
pub(super) struct Reading {
    pub(super) settings: Settings,
    /// What is said once about options that are taken and do nothing.
    pub(super) notes: Vec<String>,
    /// What was set, as Create_Ini writes it; several values of a key only where they add up.
    pub(super) assigned: BTreeMap<&'static str, Vec<String>>,
}

/// Why an option is not taken.
#[derive(Debug, PartialEq)]
pub(super) struct Refusal {
    /// The argument, or file and line, and the option.
    pub(super) place: String,
    pub(super) reason: String,
    pub(super) hint: Option<String>,
}

/// Keys of older versions: POV-Ray says that they are gone, and goes on.
const OBSOLETE: [&str; 6] =
    ["Buffer_Output", "Buffer_Size", "Create_Histogram", "Histogram_Name", "Histogram_Grid_Size", "Histogram_Type"];

/// INI files that may name one another. Source: command line facts, section 2.
const DEPTH: usize = 10;

/// Takes in INI files and arguments.
#[derive(Debug, Default)]
pub(super) struct Reader {
    reading: Reading,
    /// Folders of the arguments, which may stand behind the file that is looked for there.
    ahead: Vec<PathBuf>,
    /// INI files that are being read, with their lines.
    open: Vec<(PathBuf, usize)>,
}

impl Reader {
    /// Reads the file that holds before all arguments, and then those.
    ///
    /// # Errors
    /// The first option that is not taken.
    pub(super) fn read(arguments: &[OsString], initial: Option<PathBuf>) -> Result<Reading, Refusal> {
        let mut reader = Self::default();
        if let Some(file) = initial {
            reader.file(&file, None)?;
        }
        let arguments: Vec<String> = arguments.iter().map(|argument| argument.to_string_lossy().into_owned()).collect();
        let all = || arguments.iter().flat_map(|argument| words(argument));
        reader.ahead = all().filter_map(|word| library_of(&word)).collect();
        for word in all() {
            reader.word(&word)?;
        }
        Ok(reader.reading)
    }

    /// A switch, a key with its value, a scene, a folder or an INI file.
    fn word(&mut self, word: &str) -> Result<(), Refusal> {
        if matches!(word, "-" | "+") {
            return self.assign(word, "Input_File_Name", "-");
        }
        if word.starts_with(['+', '-']) {
            return self.switch(word);
        }
        if let Some((key, value)) = word.split_once('=') {
            return self.assign(word, key, value);
        }
        if word.ends_with(".pov") || word.ends_with(".POV") {
            return self.assign(word, "Input_File_Name", word);
        }
        if word.ends_with('/') {
            return self.assign(word, "Library_Path", word);
        }
        self.named_file(word)
    }

    fn switch(&mut self, word: &str) -> Result<(), Refusal> {
        let meant = assignments(word).map_err(|reason| {
            let letters: String = word[1..].chars().take_while(char::is_ascii_alphabetic).collect();
            let known = nearest(&letters.to_ascii_uppercase(), SWITCHES.iter().map(|switch| switch.letters));
            let hint = known.filter(|_| reason.starts_with("there is no")).map(|name| format!("did you mean +{name}?"));
            self.refusal(word, reason, hint)
        })?;
        meant.iter().try_for_each(|(key, value)| self.assign(word, key, value))
    }

    fn assign(&mut self, word: &str, name: &str, value: &str) -> Result<(), Refusal> {
        let name = name.trim();
        if OBSOLETE.iter().any(|key| key.eq_ignore_ascii_case(name)) {
            self.note(format!("{name} belongs to older versions and does nothing"));
            return Ok(());
        }
        let Some(key) = Key::named(name) else {
            let known = nearest(name, KEYS.iter().map(|key| key.name));
            let hint = known.map(|name| format!("did you mean {name}?"));
            return Err(self.refusal(word, format!("there is no option '{name}'"), hint));
        };
        if key.name == "Include_Ini" {
            return self.named_file(value);
        }
        let value =
            key.takes.value(value).map_err(|reason| self.refusal(word, format!("{}: {reason}", key.name), None))?;
        match key.action {
            Action::Ignore => {}
            Action::Note(why) => self.note(format!("{} has no effect: {why}", key.name)),
            Action::Work(set) => set(&mut self.reading.settings, &value)
                .map_err(|reason| self.refusal(word, format!("{}: {reason}", key.name), None))?,
        }
        let values = self.reading.assigned.entry(key.name).or_default();
        if !key.adds_up() {
            values.clear();
        }
        values.push(value.written(key.takes));
        Ok(())
    }

    fn note(&mut self, note: String) {
        if !self.reading.notes.contains(&note) {
            self.reading.notes.push(note);
        }
    }

    /// `name` or `name[section]`, with or without `.ini`, from here or from the library.
    fn named_file(&mut self, word: &str) -> Result<(), Refusal> {
        let (name, section) = match word.strip_suffix(']').and_then(|word| word.split_once('[')) {
            Some((name, section)) => (name, Some(section)),
            None => (word, None),
        };
        let Some(found) = self.find(name) else {
            let reason = format!("there is no INI file '{name}' or '{name}.ini'");
            let is_scene = Path::new(name).is_file() || Path::new(&format!("{name}.pov")).is_file();
            let hint = is_scene.then(|| format!("a scene that is not called NAME.pov in full needs +I: '+I{name}'"));
            return Err(self.refusal(word, reason, hint));
        };
        if self.open.len() >= DEPTH || self.open.iter().any(|(open, _)| *open == found) {
            return Err(self.refusal(word, "INI files name one another without an end".into(), None));
        }
        self.file(&found, section)
    }

    fn find(&self, name: &str) -> Option<PathBuf> {
        let folders = std::iter::once(Path::new("")).chain(self.reading.settings.library.iter().map(PathBuf::as_path));
        let folders = folders.chain(self.ahead.iter().map(PathBuf::as_path));
        let mut places = folders.flat_map(|folder| [folder.join(name), folder.join(format!("{name}.ini"))]);
        places.find(|place| place.is_file())
    }

    /// Lines in front of the first section hold always, a section's where it is asked for.
    fn file(&mut self, path: &Path, section: Option<&str>) -> Result<(), Refusal> {
        let bytes =
            std::fs::read(path).map_err(|error| self.refusal(&path.display().to_string(), error.to_string(), None))?;
        self.open.push((path.to_owned(), 0));
        let mut holds = true;
        let text = String::from_utf8_lossy(&bytes).replace("\r\n", "\n");
        for (i, line) in text.split(['\n', '\r']).enumerate() {
            if let Some(open) = self.open.last_mut() {
                open.1 = i + 1;
            }
            let line = line.trim();
            match line.strip_prefix('[').and_then(|line| line.split_once(']')) {
                Some((label, _)) => holds = section.is_some_and(|section| section.eq_ignore_ascii_case(label)),
                None if holds => self.line(line)?,
                None => {}
            }
        }
        self.open.pop();
        Ok(())
    }

    /// Switches and files, and perhaps a key, whose value is the rest of the line.
    fn line(&mut self, line: &str) -> Result<(), Refusal> {
        let mut rest = if line.starts_with('#') { "" } else { without_comment(line).trim() };
        while !rest.is_empty() {
            if !rest.starts_with(['+', '-'])
                && let Some((key, value)) = rest.split_once('=')
                && key.trim().chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            {
                return self.assign(rest, key, unquoted(last_number(value.trim())).trim());
            }
            let end = end_of_word(rest);
            self.word(&unquoted(&rest[..end]))?;
            rest = rest[end..].trim_start();
        }
        Ok(())
    }

    fn refusal(&self, word: &str, reason: String, hint: Option<String>) -> Refusal {
        let place = match self.open.last() {
            Some((file, line)) => format!("{}, line {line}: '{word}'", file.display()),
            None => format!("argument '{word}'"),
        };
        Refusal { place, reason, hint }
    }
}

/// Of numbers with commas between them the last: each sets the key anew.
fn last_number(value: &str) -> &str {
    let is_list = value.contains(',') && value.chars().all(|c| c.is_ascii_digit() || ",.+- ".contains(c));
    if is_list { value.rsplit(',').next().unwrap_or(value) } else { value }
}

/// The folder of an argument that adds one to the library.
fn library_of(word: &str) -> Option<PathBuf> {
    let switch = word.get(..2).filter(|head| head.eq_ignore_ascii_case("+l") || head.eq_ignore_ascii_case("-l"));
    let key = || word.split_once('=').filter(|(key, _)| key.eq_ignore_ascii_case("Library_Path")).map(|(_, path)| path);
    switch.map(|_| &word[2..]).or_else(key).map(PathBuf::from)
}

/// The INI file that holds before all arguments, and what is wrong with the one that `$POVINI` names.
pub(super) fn initial_file() -> (Option<PathBuf>, Option<String>) {
    let home = std::env::home_dir().unwrap_or_default();
    let named = std::env::var_os("POVINI").filter(|name| !name.is_empty()).map(PathBuf::from);
    let system = PathBuf::from("/etc/povray/3.7/povray.ini");
    if let Some(named) = named {
        if named.is_file() {
            return (Some(named), None);
        }
        let message = format!("cannot open the file '{}' that POVINI names", named.display());
        return (Some(system).filter(|file| file.is_file()), Some(message));
    }
    let places = ["povray.ini".into(), home.join(".povray/3.7/povray.ini"), system, home.join(".povrayrc")];
    (places.into_iter().find(|place| place.is_file()), None)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(arguments: &[&str], initial: &str) -> Result<Reading, Refusal> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("first.ini");
        std::fs::write(&file, initial).unwrap();
        Reader::read(&arguments.iter().map(OsString::from).collect::<Vec<_>>(), Some(file))
    }

    fn check(arguments: &[&str], initial: &str, size: [i64; 2], scene: &str) {
        let settings = read(arguments, initial).unwrap_or_else(|refusal| panic!("{refusal:?}")).settings;
        assert_eq!((settings.size, settings.scene), (size, Some(scene.into())), "{arguments:?}");
    }

    #[test]
    fn arguments_hold_over_files_and_over_those_before_them() {
        check(&["a.pov"], "", [800, 600], "a.pov");
        check(&["a.pov", "+W8"], "Width=20\nHeight=10", [8, 10], "a.pov");
        check(&["a.pov", "+W8 +H6", "height=7", "b.pov"], "", [8, 7], "b.pov");
        check(&["+Ia.txt"], " Width = 8 ; wide\n+H6 Display=off\n[other]\nWidth=9", [8, 6], "a.txt");
        check(&["-"], "Width=20 Height=10\nHeight=9", [20, 9], "-");
    }

    #[test]
    fn refusals_say_where_and_what() {
        let check = |arguments: &[&str], initial: &str, words: [&str; 2]| {
            let refusal = read(arguments, initial).unwrap_err();
            let said = format!("{} {} {:?}", refusal.place, refusal.reason, refusal.hint);
            assert!(words.iter().all(|word| said.contains(word)), "{said}");
        };
        check(&["a.pov", "Hieght=6"], "", ["argument 'Hieght=6'", "did you mean Height?"]);
        check(&["a.pov"], "Width=8\nHieght=6", ["first.ini, line 2", "Height"]);
        check(&["a.pov", "+Wx"], "", ["+Wx", "expected a whole number"]);
        check(&["nothing"], "", ["nothing.ini", "None"]);
        check(&["+A1"], "", ["+A1", "+A0.3"]);
    }

    #[test]
    fn what_was_set_is_kept() {
        let reading = read(&["a.pov", "+A0.2", "+L/b", "+L/c", "+W8", "+W9", "+UF"], "").unwrap();
        let values = |key: &str| reading.assigned[key].join(" ");
        assert_eq!((values("Antialias"), values("Antialias_Threshold")), ("On".into(), "0.2".into()));
        assert_eq!((values("Library_Path"), values("Width")), ("\"/b\" \"/c\"".into(), "9".into()));
        assert_eq!(reading.notes.len(), 1);
    }
}
