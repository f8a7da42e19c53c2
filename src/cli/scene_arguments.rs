//! Arguments of every command that reads a scene.

use super::{include_dirs, messages};
use crate::eval::{self, Disk};
use std::path::{Path, PathBuf};

/// Where a scene is and where it may look.
#[derive(Debug, clap::Args)]
pub(super) struct SceneArguments {
    /// POV-Ray scene file
    pub(super) scene: PathBuf,
    /// Folder to search for include files and pictures, before those of an installed POV-Ray
    #[arg(long, short = 'I', value_name = "DIR")]
    include: Vec<PathBuf>,
    /// Folder in which the scene may write files
    #[arg(long, value_name = "DIR")]
    allow_write: Vec<PathBuf>,
    /// Declare a float before the scene is read
    #[arg(long, short = 'D', value_name = "NAME=VALUE", value_parser = declaration)]
    declare: Vec<(String, f64)>,
    /// Value of `clock` for animations
    #[arg(long, value_name = "VALUE", default_value_t = 0.0)]
    clock: f64,
    /// Most turns of loops and macro calls
    #[arg(long, value_name = "N")]
    max_steps: Option<u64>,
}

fn declaration(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    let value = value.trim().parse().map_err(|_| format!("'{value}' is not a number"))?;
    Ok((name.trim().to_owned(), value))
}

impl SceneArguments {
    /// What reading the scene needs to know.
    pub(super) fn reading(&self, width: usize, height: usize) -> eval::Options {
        let mut options = eval::Options {
            include_dirs: self.folders(),
            declarations: self.declare.clone(),
            clock: self.clock,
            image_width: width as u32,
            image_height: height as u32,
            now: days_since_2000(),
            ..eval::Options::default()
        };
        if let Some(steps) = self.max_steps {
            options.limits.steps = steps;
        }
        options
    }

    /// The file system as the scene may see it.
    pub(super) fn host(&self) -> Disk {
        Disk::new(&self.scene, &self.folders(), &self.allow_write, messages::from_scene)
    }

    /// The scene's own folder is searched, too, which POV-Ray leaves out.
    fn folders(&self) -> Vec<PathBuf> {
        let mut folders = include_dirs::search_path(&self.include);
        let beside = self.scene.parent().filter(|p| !p.as_os_str().is_empty());
        folders.extend(beside.map(Path::to_owned));
        folders
    }
}

/// The present, as scenes count it.
fn days_since_2000() -> f64 {
    const DAYS_1970_TO_2000: f64 = 10_957.0;
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    now.map_or(0.0, |t| t.as_secs_f64() / 86_400.0 - DAYS_1970_TO_2000)
}
