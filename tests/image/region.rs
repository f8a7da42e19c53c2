//! A part of a picture is made of the whole picture's pixels.

use super::*;
use whitted::render::Region;

/// Renders parts, some on several threads, and compares them with the whole.
fn check(scene: &str, antialias: Option<Antialias>) {
    let world = world(scene);
    let options = small(antialias);
    let whole = picture(&world, &options);
    let parts =
        [([0, 0, 75, 50], 3), ([3, 5, 20, 9], 1), ([30, 31, 34, 33], 1), ([40, 2, 45, 50], 3), ([74, 49, 75, 50], 2)];
    for ([left, top, right, bottom], threads) in parts {
        let region = Some(Region { left, top, right, bottom });
        let part = picture(&world, &Options { region, threads, ..options.clone() });
        assert_eq!([part.width, part.height], [right - left, bottom - top]);
        assert_eq!((part.origin, part.full), ([left as i32, top as i32], [75, 50]));
        for y in top..bottom {
            for x in left..right {
                let (expected, found) = (whole.pixel(x, y), part.pixel(x - left, y - top));
                assert_eq!(expected.map(f32::to_bits), found.map(f32::to_bits), "{x},{y} with {antialias:?}");
            }
        }
    }
}

#[test]
fn parts_are_those_of_the_whole() {
    ways().into_iter().for_each(|way| check(SCENE, way));
}

#[test]
fn parts_are_those_of_the_whole_through_a_lens() {
    ways().into_iter().for_each(|way| check(&format!("{SCENE}{LENS}"), way));
}

#[test]
fn regions_end_with_the_picture() {
    let region = Some(Region { left: 70, top: 40, right: 90, bottom: 60 });
    let options = Options { region, ..small(None) };
    assert_eq!(options.window(), Region { left: 70, top: 40, right: 75, bottom: 50 });
}
