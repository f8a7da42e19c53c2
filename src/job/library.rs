//! What scenes that come one after the other have in common: files, and what was made of them.

use super::shelf::Shelf;
use crate::compile::Pictures;
use crate::eval::{Host, Kept, Status, Stream};
use crate::imaging::Encoded;
use crate::syntax::Text;
use std::io;
use std::path::Path;
use std::sync::Arc;

/// Files of the last scene, with what was made of them. They are read anew for each scene, so that one which has changed
/// since, or which the scene itself has written, is seen as it is.
#[derive(Debug)]
pub(super) struct Library {
    /// Scenes and include files; their tokens are kept from the second time on.
    texts: Shelf<Text>,
    fonts: Shelf<Vec<u8>>,
    encoded: Shelf<Encoded>,
    /// The same pictures as rasters in working spaces.
    pub(super) pictures: Pictures,
}

/// Larger texts are meshes mostly: a few tokens of any length, and a text that is let go once it has been read.
const LARGEST_TEXT: usize = 256 << 10;

/// Bytes of all texts together. The tokens of one take up about six times as much memory, and at most 32 times.
const ALL_TEXTS: usize = 2 << 20;

/// Bytes of fonts, and of pictures, beyond which no further one is kept.
const ALL_BINARIES: usize = 1 << 30;

impl Default for Library {
    fn default() -> Self {
        Self {
            texts: Shelf::with_room(ALL_TEXTS),
            fonts: Shelf::with_room(ALL_BINARIES),
            encoded: Shelf::with_room(ALL_BINARIES),
            pictures: Pictures::default(),
        }
    }
}

impl Library {
    /// Another scene begins: what the last one did not need is dropped.
    pub(super) fn begin_scene(&self) {
        self.texts.begin_scene();
        self.fonts.begin_scene();
        self.encoded.begin_scene();
        self.pictures.begin_scene();
    }
}

/// A host whose files are kept in a library.
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

    fn text(&self, path: &Path, text: Text) -> Arc<Text> {
        if text.bytes().len() > LARGEST_TEXT {
            return Arc::new(text);
        }
        let (text, is_known) = self.library.texts.shared(path, text);
        if is_known {
            text.keep_tokens();
        }
        text
    }

    fn font(&self, path: &Path, bytes: Vec<u8>) -> Arc<Vec<u8>> {
        self.library.fonts.shared(path, bytes).0
    }

    fn picture(&self, file: Encoded) -> Arc<Encoded> {
        let path = file.path().to_owned();
        self.library.encoded.shared(&path, file).0
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
    use super::{Library, Remembering};
    use crate::compiled::texture::{Pigment, Raster, Texture};
    use crate::eval::{Memory, NoQueries, Options, evaluate};
    use crate::job::Session;
    use crate::scene::{Object, Shape};
    use std::sync::Arc;

    /// What the last texture of a scene shows.
    fn raster(session: &Session, scene: &str, picture: &[u8]) -> Arc<Raster> {
        let host = Memory::new([("a.pov", scene)]).with("a.ppm", picture.to_vec());
        let ready = session.compile("a.pov".as_ref(), &Options::default(), &host).expect("a right scene");
        let Some(Texture::Layers(layers)) = ready.world.textures.iter().next_back() else { panic!("no plain texture") };
        let Pigment::Image(_, map) = &layers[0].pigment else { panic!("no picture") };
        Arc::clone(&map.raster)
    }

    /// What a scene of a session says, its text and the errors or warnings.
    fn said(session: &Session, host: &Memory) -> String {
        let before = host.messages().len();
        let (diagnostics, sources) = match session.compile("a.pov".as_ref(), &Options::default(), host) {
            Ok(ready) => (ready.warnings, ready.sources),
            Err(failed) => (failed.diagnostics, failed.sources),
        };
        let shown = diagnostics.iter().map(|diagnostic| diagnostic.render(&sources, false));
        host.messages()[before..].to_owned() + &shown.collect::<String>()
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
    #[test]
    fn kept_tokens_change_no_word_of_what_is_said() {
        let scene = "#version 3.7; #include \"colors.inc\" #include \"b.inc\" B(3) #debug str(Red.x + C, 0, 1) D;";
        let include = "#macro B(N) #declare C = N; #if (N > 2) #warning \"many\" #else sphere { #end #end\n finnish {}";
        let one = || Memory::new([("a.pov", scene), ("b.inc", include)]);
        // Another scene whose words have other numbers.
        let other = || Memory::new([("a.pov", "#version 3.7; #declare D = 1; #include \"b.inc\" B(3) E;")]);
        let other = || other().with("b.inc", include.as_bytes().to_vec());
        let alone = [said(&Session::new(1), &one()), said(&Session::new(1), &other())];
        assert!(alone[0].contains("b.inc:2:2") && alone[0] != alone[1], "{}", alone[0]);
        let session = Session::new(1);
        for _ in 0..3 {
            assert_eq!(alone, [said(&session, &one()), said(&session, &other())]);
        }
    }

    #[test]
    fn files_that_have_changed_are_read_as_they_are() {
        let scene = "#version 3.7; #fopen F \"own.inc\" write #write(F, \"#debug \\\"\", N, \"\\\"\") #fclose F
            #include \"own.inc\" #include \"b.inc\" #include \"own.inc\"";
        let session = Session::new(1);
        for (n, expected) in [(1, "1b1"), (1, "1b1"), (2, "2b2"), (2, "2b2"), (1, "1c1"), (1, "1c1")] {
            let debug = format!("#debug \"{}\"", &expected[1..2]);
            let host = Memory::new([("a.pov", &*scene.replace('N', &n.to_string())), ("b.inc", &*debug)]);
            session.compile("a.pov".as_ref(), &Options::default(), &host).expect("a right scene");
            assert_eq!(host.messages(), expected);
        }
    }

    #[test]
    fn texts_and_scenes_share_a_font() {
        let library = Library::default();
        let scene = "#version 3.7; text { ttf \"a.ttf\" \"a\" 1, 0 } text { ttf \"a.ttf\" \"b\" 1, 0 }";
        let fonts = |bytes: &[u8]| {
            let host = Memory::new([("a.pov", scene)]).with("a.ttf", bytes.to_vec());
            let host = Remembering { host: &host, library: &library };
            library.begin_scene();
            let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries).expect("a right scene");
            let font = |object: &Object| match &object.shape {
                Shape::Text(text) => Arc::clone(&text.font),
                other => panic!("{other:?}"),
            };
            read.scene.objects.iter().map(font).collect::<Vec<_>>()
        };
        let (first, again, changed) = (fonts(b"font"), fonts(b"font"), fonts(b"other"));
        assert!(Arc::ptr_eq(&first[0], &first[1]) && Arc::ptr_eq(&first[0], &again[0]));
        assert_eq!(changed[1][..], *b"other");
    }
}
