//! What is left out changes no bit of a picture: golden scenes and examples with everything kept, and with each thing kept
//! that they have.

use std::path::{Path, PathBuf};
use whitted::compile;
use whitted::compiled::World;
use whitted::eval::{self, Disk, Reach};
use whitted::imaging::Picture;
use whitted::job::{Job, Session};
use whitted::omission::{Keep, Omission};
use whitted::render::{self, Options, Unobserved};

/// Enough pixels for every part of a scene to be among them.
const SIZE: [usize; 2] = [48, 36];

fn scenes(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder of scenes").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let own = files.into_iter().filter(|file| file.extension().is_some_and(|kind| kind == "pov"));
    own.chain(folders.iter().flat_map(|folder| scenes(folder))).collect()
}

fn host(scene: &Path) -> Disk {
    Disk::new(&Reach { scene: scene.to_owned(), ..Reach::default() }, |_, _| {})
}

fn options() -> Options {
    Options { width: SIZE[0], height: SIZE[1], ..Options::default() }
}

/// The picture of a scene, with what was found in it that it does not need; `None` where it is refused.
fn picture(session: &Session, scene: &Path, keep: Keep) -> Option<(Picture, Vec<Omission>)> {
    let [width, height] = SIZE.map(|pixels| pixels as u32);
    let reading = eval::Options { keep, image_width: width, image_height: height, ..eval::Options::default() };
    let job = Job { scene: scene.to_owned(), reading, rendering: options(), ..Job::default() };
    let outcome = session.render(&job, &host(scene), &Unobserved).ok()?;
    let ledger = &outcome.explanation.ledger;
    let found = Omission::ALL.into_iter().filter(|omission| ledger.of(*omission).count > 0).collect();
    Some((outcome.picture, found))
}

fn bits(picture: &Picture) -> Vec<u32> {
    let [width, height] = SIZE;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    pixels.flat_map(|(x, y)| picture.pixel(x, y).map(f32::to_bits)).collect()
}

#[test]
fn nothing_that_is_left_out_is_missed() {
    let (root, session) = (Path::new(env!("CARGO_MANIFEST_DIR")), Session::new(0));
    let all: Vec<PathBuf> = ["golden", "examples"].iter().flat_map(|folder| scenes(&root.join(folder))).collect();
    let checked: Vec<(PathBuf, Vec<Omission>, Vec<String>)> = all
        .into_iter()
        .filter_map(|scene| {
            let (expected, found) = picture(&session, &scene, Keep::NONE)?;
            let expected = bits(&expected);
            let each = found.iter().map(|omission| (omission.name(), Keep::NONE.with(*omission)));
            let wrong = each
                .chain([("all", Keep::ALL)])
                .filter(|(_, keep)| picture(&session, &scene, *keep).is_none_or(|(kept, _)| bits(&kept) != expected))
                .map(|(name, _)| format!("{} with --keep {name}", scene.display()))
                .collect();
            Some((scene, found, wrong))
        })
        .collect();
    let wrong: Vec<&String> = checked.iter().flat_map(|(_, _, wrong)| wrong).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    for omission in Omission::ALL {
        assert!(checked.iter().any(|(_, found, _)| found.contains(&omission)), "no scene has {}", omission.name());
    }
}

/// A lie about a world shows in its picture.
fn check_lie(text: &str, lie: impl FnOnce(&mut World)) {
    let host = eval::Memory::new([("a.pov", text)]);
    let read = eval::evaluate("a.pov".as_ref(), &eval::Options::default(), &host, &eval::NoQueries).expect("a scene");
    let mut world = compile::compile(&read.scene).expect("a scene").world;
    let honest = render::render(&world, &options(), &Unobserved).picture;
    lie(&mut world);
    let lying = render::render(&world, &options(), &Unobserved).picture;
    assert_ne!(bits(&honest), bits(&lying), "{text}");
}

#[test]
fn a_lying_census_is_caught() {
    const VIEW: &str = "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 3, -6> look_at 0 }
        light_source { <3, 9, -5>, 1 } plane { y, -1 pigment { checker rgb 1 rgb .2 } }";
    let glass = format!("{VIEW} sphere {{ 0, 1 pigment {{ rgbf .9 }} interior {{ ior 1.5 }} }}");
    check_lie(&glass, |world| {
        world.opaque = world.textures.iter().map(|_| true).collect();
        world.features.see_through_textures = 0;
    });
    let inside = glass.replace("sphere { 0, 1", "sphere { 0, 30 hollow");
    check_lie(&inside, |world| world.features.optical_interiors = 0);
}
