//! What scenes that come one after the other have in common: pictures, decoded once.

use crate::compile::Pictures;
use crate::eval::{Host, Kept, Status, Stream};
use crate::imaging::Encoded;
use rustc_hash::FxHashMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Pictures of the last scene, as files and as rasters in working spaces.
#[derive(Debug, Default)]
pub(super) struct Library {
    files: Mutex<Files>,
    pub(super) pictures: Pictures,
}

/// Files by name, and whether the scene of now has asked for them.
type Files = FxHashMap<PathBuf, (Arc<Encoded>, bool)>;

impl Library {
    /// Another scene begins: what the last one did not need is dropped.
    pub(super) fn begin_scene(&self) {
        self.files().retain(|_, (_, is_used)| std::mem::take(is_used));
        self.pictures.begin_scene();
    }

    /// A panic of another thread does not matter to plain data.
    fn files(&self) -> MutexGuard<'_, Files> {
        self.files.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A host whose pictures are kept in a library.
pub(super) struct Remembering<'h> {
    pub(super) host: &'h dyn Host,
    pub(super) library: &'h Library,
}

impl Host for Remembering<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.host.read(path)
    }

    fn status(&self, path: &Path) -> Status {
        self.host.status(path)
    }

    fn create(&self, path: &Path) -> io::Result<Kept> {
        self.host.create(path)
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<Kept> {
        self.host.append(path, bytes)
    }

    fn picture(&self, file: Encoded) -> Arc<Encoded> {
        let mut files = self.library.files();
        let path = file.path().to_owned();
        match files.get_mut(&path).filter(|(known, _)| known.is_like(&file)) {
            Some((known, is_used)) => {
                *is_used = true;
                Arc::clone(known)
            }
            None => {
                let file = Arc::new(file);
                files.insert(path, (Arc::clone(&file), true));
                file
            }
        }
    }

    fn message(&self, stream: Stream, text: &str) {
        self.host.message(stream, text);
    }

    fn progress(&self, what: &dyn Fn() -> String) {
        self.host.progress(what);
    }
}

#[cfg(test)]
mod tests {
    use crate::compiled::texture::{Pigment, Raster, Texture};
    use crate::eval::{Memory, Options};
    use crate::job::Session;
    use std::sync::Arc;

    /// What the last texture of a scene shows.
    fn raster(session: &Session, scene: &str, picture: &[u8]) -> Arc<Raster> {
        let host = Memory::new([("a.pov", scene)]).with("a.ppm", picture.to_vec());
        let ready = session.compile("a.pov".as_ref(), &Options::default(), &host).expect("a right scene");
        let Some(Texture::Layers(layers)) = ready.world.textures.iter().next_back() else { panic!("no plain texture") };
        let Pigment::Image(_, map) = &layers[0].pigment else { panic!("no picture") };
        Arc::clone(&map.raster)
    }

    #[test]
    fn scenes_of_a_session_share_pictures_that_are_the_same() {
        let session = Session::new(1);
        let (red, blue) = (b"P6\n1 1\n255\n\xff\x00\x00", b"P6\n1 1\n255\n\x00\x00\xff");
        let scene = "#version 3.7; sphere { 0, 1 pigment { image_map { ppm \"a.ppm\" } } }";
        let first = raster(&session, scene, red);
        assert!(Arc::ptr_eq(&first, &raster(&session, &scene.replace("sphere", "plane { y, -9 } sphere"), red)));
        assert!(!Arc::ptr_eq(&first, &raster(&session, scene, blue)));
        assert!(!Arc::ptr_eq(&first, &raster(&session, scene, red)), "two scenes ago is forgotten");
    }
}
