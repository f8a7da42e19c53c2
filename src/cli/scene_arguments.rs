//! Arguments of every command that reads a scene.

use super::messages::Manner;
use super::{explain, include_dirs};
use crate::eval::{self, Disk, Limits, Overrides, Reach};
use crate::omission::{Keep, Omission};
use crate::scene::IsosurfaceSearch;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// Where a scene is and where it may look.
#[derive(Debug, clap::Args)]
pub(super) struct SceneArguments {
    /// POV-Ray scene file
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) how: Reading,
}

/// How scenes are read.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Reading {
    /// Folder to search for include files and pictures, before those of an installed POV-Ray
    #[arg(long, short = 'I', value_name = "DIR")]
    include: Vec<PathBuf>,
    /// Folder below which the scene may read files, beside its own, the working folder, those of --include and your
    /// home folder without what has a name that begins with a dot
    #[arg(long, value_name = "DIR")]
    allow_read: Vec<PathBuf>,
    /// The scene is a stranger's: it reads only below its own folder and those that other options name, and must do
    /// with little time and memory
    #[arg(long)]
    untrusted: bool,
    /// Folder in which the scene may write files
    #[arg(long, value_name = "DIR")]
    allow_write: Vec<PathBuf>,
    /// Declare a float before the scene is read
    #[arg(long, short = 'D', value_name = "NAME=VALUE", value_parser = declaration)]
    declare: Vec<(String, f64)>,
    /// Language version in force before the scene's first #version, as POV-Ray's +MV
    #[arg(long, value_name = "V", value_parser = language_version)]
    language_version: Option<u32>,
    /// Value of `clock` for animations
    #[arg(long, value_name = "VALUE", default_value_t = 0.0)]
    clock: f64,
    /// Change a limit on what a scene may use up: steps, macro_depth, include_depth, nesting, objects,
    /// parts, array_elements or string_bytes
    #[arg(long, value_name = "NAME=N", value_parser = limit)]
    limit: Vec<(String, u64)>,
    /// Set in the scene's place: max_trace_level, adc_bailout, or a factor of area_light_grid (samples along each
    /// axis) or isosurface_accuracy
    #[arg(long, value_name = "NAME=VALUE", value_parser = overriding)]
    r#override: Vec<(String, f64)>,
    /// How isosurfaces are looked for: `guaranteed` finds all of the surface where its function can be
    /// bounded; `povray` believes max_gradient and may leave holes
    #[arg(long, value_enum, default_value = "guaranteed", value_name = "HOW")]
    isosurface_search: Search,
    /// Do not leave out what the picture does not need: all, or a list of names that --explain of `whitted render`
    /// shows. The picture stays the same
    #[arg(long, value_name = "LIST", value_parser = explain::keep)]
    keep: Option<Keep>,
    /// Use the standard include files of this program, not those of an installed POV-Ray
    #[arg(long)]
    embedded_includes: bool,
    #[command(flatten)]
    pub(super) messages: Manner,
}

/// As typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Search {
    Guaranteed,
    Povray,
}

fn declaration(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    let value = value.trim().parse().map_err(|_| format!("'{value}' is not a number"))?;
    Ok((name.trim().to_owned(), value))
}

/// Hundredths.
fn language_version(text: &str) -> Result<u32, String> {
    let version: f64 = text.parse().map_err(|_| format!("'{text}' is not a number"))?;
    let hundredths = (version * 100.0).round();
    if (0.0..=370.0).contains(&hundredths) { Ok(hundredths as u32) } else { Err("must be 0 to 3.7".into()) }
}

fn limit(text: &str) -> Result<(String, u64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=N")?;
    if !Limits::NAMES.contains(&name) {
        return Err(format!("there is no limit '{name}', only {}", Limits::NAMES.join(", ")));
    }
    Ok((name.to_owned(), value.parse().map_err(|_| format!("'{value}' is not a whole number"))?))
}

fn overriding(text: &str) -> Result<(String, f64), String> {
    let (name, value) = declaration(text)?;
    if !Overrides::NAMES.contains(&name.as_str()) {
        return Err(format!("there is no override '{name}', only {}", Overrides::NAMES.join(", ")));
    }
    if Overrides::default().set(&name, value) { Ok((name, value)) } else { Err("makes no sense".into()) }
}

impl SceneArguments {
    /// What reading the scene needs to know.
    pub(super) fn reading(&self, width: usize, height: usize) -> eval::Options {
        self.how.options(&self.scene, width, height)
    }

    /// The file system as the scene may see it.
    pub(super) fn host(&self) -> Disk {
        self.how.host(&self.scene)
    }
}

impl Reading {
    /// What reading a scene needs to know.
    pub(super) fn options(&self, scene: &Path, width: usize, height: usize) -> eval::Options {
        let mut options = eval::Options {
            include_dirs: self.folders(scene),
            version: self.language_version,
            declarations: self.declare.clone(),
            clock: self.clock,
            image_width: width as u32,
            image_height: height as u32,
            now: days_since_2000(),
            isosurface_search: match self.isosurface_search {
                Search::Guaranteed => IsosurfaceSearch::Guaranteed,
                Search::Povray => IsosurfaceSearch::PovRay,
            },
            keep: self.keep.unwrap_or_default(),
            limits: if self.untrusted { Limits::strict() } else { Limits::default() },
            ..eval::Options::default()
        };
        for (name, value) in &self.limit {
            options.limits.set(name, *value);
        }
        for (name, value) in &self.r#override {
            options.overrides.set(name, *value);
        }
        options
    }

    /// The file system as the scene may see it.
    pub(super) fn host(&self, scene: &Path) -> Disk {
        let reach = Reach {
            scene: scene.to_owned(),
            include: include_dirs::search_path(&self.include, self.embedded_includes),
            read: self.allow_read.clone(),
            write: self.allow_write.clone(),
            home: std::env::home_dir(),
            untrusted: self.untrusted,
        };
        Disk::new(&reach, self.messages.scene_output()).observed(self.messages.observer())
    }

    /// The same again, for a process that reads in another folder.
    pub(super) fn arguments(&self) -> Vec<OsString> {
        let mut arguments = Vec::new();
        let mut add = |name: &str, value: &dyn AsRef<OsStr>| {
            let mut argument = OsString::from(name);
            argument.push("=");
            argument.push(value);
            arguments.push(argument);
        };
        let folders =
            [("--include", &self.include), ("--allow-read", &self.allow_read), ("--allow-write", &self.allow_write)];
        for (name, folder) in folders.into_iter().flat_map(|(name, all)| all.iter().map(move |folder| (name, folder))) {
            // A folder without a full name is the one that the system cannot find either.
            add(name, &std::path::absolute(folder).unwrap_or_else(|_| folder.clone()));
        }
        self.declare.iter().for_each(|(name, value)| add("--declare", &format!("{name}={value}")));
        self.limit.iter().for_each(|(name, value)| add("--limit", &format!("{name}={value}")));
        self.r#override.iter().for_each(|(name, value)| add("--override", &format!("{name}={value}")));
        let kept: Vec<&str> = Omission::ALL
            .into_iter()
            .filter(|omission| self.keep.is_some_and(|keep| keep.holds(*omission)))
            .map(Omission::name)
            .collect();
        if !kept.is_empty() {
            add("--keep", &kept.join(","));
        }
        if let Some(version) = self.language_version {
            add("--language-version", &(f64::from(version) / 100.0).to_string());
        }
        add("--clock", &self.clock.to_string());
        let search = match self.isosurface_search {
            Search::Guaranteed => "guaranteed",
            Search::Povray => "povray",
        };
        add("--isosurface-search", &search);
        let flags = [(self.untrusted, "--untrusted"), (self.embedded_includes, "--embedded-includes")];
        arguments.extend(flags.into_iter().filter(|(is_on, _)| *is_on).map(|(_, flag)| flag.into()));
        arguments
    }

    /// The same for POV-Ray, as far as it has the like.
    pub(super) fn povray_arguments(&self) -> Vec<OsString> {
        let mut arguments = Vec::new();
        for folder in &self.include {
            let mut argument = OsString::from("+L");
            argument.push(std::path::absolute(folder).unwrap_or_else(|_| folder.clone()));
            arguments.push(argument);
        }
        arguments.extend(self.declare.iter().map(|(name, value)| format!("Declare={name}={value}").into()));
        arguments.extend(self.language_version.map(|version| format!("+MV{}", f64::from(version) / 100.0).into()));
        arguments.push(format!("+K{}", self.clock).into());
        arguments
    }

    /// The scene's own folder is searched, too, which POV-Ray leaves out.
    fn folders(&self, scene: &Path) -> Vec<PathBuf> {
        let mut folders = include_dirs::search_path(&self.include, self.embedded_includes);
        let beside = scene.parent().filter(|p| !p.as_os_str().is_empty());
        folders.extend(beside.map(Path::to_owned));
        folders
    }
}

/// The present, as scenes count it.
pub(super) fn days_since_2000() -> f64 {
    const DAYS_1970_TO_2000: f64 = 10_957.0;
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    now.map_or(0.0, |t| t.as_secs_f64() / 86_400.0 - DAYS_1970_TO_2000)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Debug, Parser)]
    struct Typed {
        #[command(flatten)]
        how: Reading,
    }

    #[test]
    fn arguments_survive_being_typed_again() {
        let line = "x -I /a --allow-read=/b --allow-write /c -D n=-1.5 --clock 0.25 --limit steps=5 --untrusted \
                    --override adc_bailout=0.5 --language-version 3.5 --isosurface-search povray --embedded-includes";
        let how = Typed::try_parse_from(line.split_whitespace()).unwrap().how;
        let again = std::iter::once("x".into()).chain(how.arguments());
        let again = Typed::try_parse_from(again).unwrap().how;
        assert_eq!(format!("{how:?}"), format!("{again:?}"));
        assert_eq!(again.declare, [("n".to_owned(), -1.5)]);
        assert_eq!(how.povray_arguments(), ["+L/a", "Declare=n=-1.5", "+MV3.5", "+K0.25"]);
    }
}
