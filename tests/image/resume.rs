//! A picture that is gone on with is the picture that was never interrupted.

use super::*;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use whitted::imaging::{Encoding, FileKind};
use whitted::job::{Earlier, Job, Keeping, Output};
use whitted::render::{Observer, Piece, Place, Rendered, Unobserved};

/// Gives what it has and takes the rest.
#[derive(Default)]
struct Keeper {
    given: HashMap<Place, Piece>,
    taken: Mutex<HashMap<Place, Piece>>,
}

impl Observer for Keeper {
    fn keeps(&self) -> bool {
        true
    }

    fn keep(&self, piece: Piece) {
        self.taken.lock().expect("no panic").insert(piece.place, piece);
    }

    fn kept(&self, place: Place) -> Option<Piece> {
        self.given.get(&place).cloned()
    }
}

fn rendered(antialias: Option<Antialias>, given: HashMap<Place, Piece>) -> (Rendered, HashMap<Place, Piece>) {
    let keeper = Keeper { given, ..Keeper::default() };
    let rendered = Session::new(2).picture(&world(SCENE), &small(antialias), &keeper);
    (rendered, keeper.taken.into_inner().expect("no panic"))
}

#[test]
fn pieces_stand_for_the_work_that_made_them() {
    for way in ways() {
        let (whole, all) = rendered(way, HashMap::new());
        assert!(all.len() > 1);
        for left_out in [1, 2, 3] {
            let is_given = |place: &Place| (place.x + place.y + place.stage) % 4 != left_out;
            let given: HashMap<_, _> =
                all.iter().filter(|(place, _)| is_given(place)).map(|(place, piece)| (*place, piece.clone())).collect();
            let expected = all.len() - given.len();
            let (again, made) = rendered(way, given);
            assert_eq!((again.picture, again.statistics), (whole.picture.clone(), whole.statistics), "{way:?}");
            assert_eq!(made.len(), expected, "{way:?}");
        }
    }
}

/// Ends the work after so many pieces.
struct Impatient(AtomicUsize);

impl Observer for Impatient {
    fn cancels(&self) -> bool {
        self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1)).is_err()
    }
}

fn job(folder: &Path, keeping: Keeping) -> Job {
    let rendering = small(ways()[1]);
    let output = Output { file: folder.join("a.exr"), kind: FileKind::Exr, encoding: Encoding::default() };
    Job { scene: "a.pov".into(), rendering, outputs: vec![output], keeping, ..Job::default() }
}

/// Makes the picture and writes it, if it is complete; what an earlier run had left.
fn made(job: &Job, text: &str, observer: &dyn Observer) -> Earlier {
    let (session, host) = (Session::new(2), Memory::new([("a.pov", text)]));
    let mut outcome = session.render(job, &host, observer).expect("a right scene");
    if outcome.complete {
        session.write(&mut outcome, job).expect("a folder to write in");
    }
    outcome.earlier
}

#[test]
fn files_are_the_same_after_an_interruption() {
    let folder = tempfile::tempdir().expect("a folder");
    let (new, resuming) = (job(folder.path(), Keeping::New), job(folder.path(), Keeping::Resuming));
    let (file, state) = (folder.path().join("a.exr"), folder.path().join("a.exr.whitted-state"));
    made(&new, SCENE, &Unobserved);
    let expected = std::fs::read(&file).expect("a picture");
    std::fs::remove_file(&file).expect("a picture");
    made(&new, SCENE, &Impatient(AtomicUsize::new(5)));
    assert!(state.exists() && !file.exists());
    assert_eq!(made(&resuming, &format!("{SCENE} // another"), &Impatient(AtomicUsize::new(0))), Earlier::Other);
    made(&new, SCENE, &Impatient(AtomicUsize::new(5)));
    assert!(matches!(made(&resuming, SCENE, &Unobserved), Earlier::Pieces(n) if n > 0));
    assert!(std::fs::read(&file).expect("a picture") == expected && !state.exists());
}

#[test]
fn files_say_which_picture_they_are() {
    let folder = tempfile::tempdir().expect("a folder");
    let (job, session) = (job(folder.path(), Keeping::Resuming), Session::new(2));
    let is_made = |text: &str| {
        let ready = session.compile(&job.scene, &job.reading, &Memory::new([("a.pov", text)])).expect("a right scene");
        session.is_made(&job, &ready)
    };
    assert_eq!(is_made(SCENE), None);
    made(&job, SCENE, &Unobserved);
    // A run was killed between the picture and clearing up.
    let state = folder.path().join("a.exr.whitted-state");
    std::fs::write(&state, "pieces").expect("a folder to write in");
    assert_eq!((is_made(&format!("{SCENE} // another")), state.exists()), (Some(false), true));
    assert_eq!((is_made(SCENE), state.exists()), (Some(true), false));
}
