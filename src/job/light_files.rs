//! Files in which light between surfaces goes from one picture to the next.

use super::Job;
use crate::diag::{Diagnostic, Span, Topic};
use crate::imaging::{ImageError, write_whole};
use crate::render::KnownLight;
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Which files, if any.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LightFiles {
    /// What is known before the picture.
    pub from: Option<PathBuf>,
    /// What is known after it, that from before included. It may be the same file.
    pub to: Option<PathBuf>,
}

impl LightFiles {
    /// Pictures that hand light on are made one after the other.
    pub(super) fn hand_on(&self) -> bool {
        self.from.is_some() && self.to.is_some()
    }

    /// Writes what is known after a picture: nothing, if the scene has no radiosity.
    pub(super) fn write(&self, light: Option<&KnownLight>) -> Result<(), ImageError> {
        match &self.to {
            Some(file) => write_whole(file, light.map_or("", KnownLight::text).as_bytes()),
            None => Ok(()),
        }
    }
}

impl Job {
    /// The same with what its file of light says now, and what there is to say about that file.
    pub(super) fn with_known_light(&self) -> (Cow<'_, Self>, Vec<Diagnostic>) {
        let LightFiles { from, to } = &self.light;
        if from.is_none() && to.is_none() {
            return (Cow::Borrowed(self), Vec::new());
        }
        let mut job = self.clone();
        job.rendering.keeps_light = to.is_some();
        let warnings = from.iter().filter_map(|file| {
            let (light, warning) = read(file);
            job.rendering.known_light = light.map(Arc::new);
            // Before the first picture that hands light on there is none.
            warning.filter(|_| to.as_ref() != Some(file) || file.exists())
        });
        let warnings = warnings.collect();
        (Cow::Owned(job), warnings)
    }
}

/// What a file says, and what is wrong with it.
fn read(file: &Path) -> (Option<KnownLight>, Option<Diagnostic>) {
    let warn = |why: String| {
        let message = format!("light between surfaces in {}: {why}", file.display());
        Some(Diagnostic::warning(Topic::Files, Span::default(), message).without_place())
    };
    let text = match std::fs::read(file) {
        Ok(bytes) => String::from_utf8_lossy(&bytes).into_owned(),
        Err(error) => return (None, warn(format!("{error}; all of it is found anew"))),
    };
    let (light, others) = KnownLight::read(&text);
    let warning = others.first().and_then(|line| {
        warn(format!("{} lines are no records and are left out, the first of them line {line}", others.len()))
    });
    (Some(light), warning)
}
