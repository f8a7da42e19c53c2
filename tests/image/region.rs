//! A part of a picture is made of the whole picture's pixels.

use super::*;
use whitted::render::Region;

/// Renders parts, some on several threads, and compares them with the whole.
fn check(scene: &str, antialias: Option<Antialias>) {
    let world = world(scene);
    let options = small(antialias);
    let whole = picture(&world, &options);
    let parts = [
        ([0, 0, 75, 50], 3),
        ([3, 5, 20, 9], 1),
        ([30, 31, 34, 33], 1),
        ([40, 2, 45, 50], 3),
        ([74, 49, 75, 50], 2),
        // No pixel has neighbours here.
        ([0, 24, 75, 25], 2),
        ([17, 0, 18, 50], 1),
    ];
    for ([left, top, right, bottom], threads) in parts {
        let region = Some(Region { left, top, right, bottom });
        let options = Options { region, ..options.clone() };
        let part = Session::new(threads).picture(&world, &options, &Unobserved).picture;
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

/// Noise wherever neighbouring rays share it: layers, maps and averages of pigments, by points and by surface
/// coordinates, a sky; and patterns that keep it from being shared.
const NOISY: &str = "
camera { location <0, 2, -6> look_at <0, 0.5, 0> angle 45 right x*4/3 }
light_source { <-5, 7, -6> rgb 1 }
sky_sphere { pigment { gradient y pigment_map {
  [0 rgb .8] [.3 bozo turbulence .6 color_map { [0 rgb .4] [1 rgb 1] } scale .2] [1 rgb <.2,.3,.6>] } } }
#declare Veins = texture { pigment { granite color_map { [0 rgbt <1,1,1,.9>] [1 rgbt <.3,.2,.1,.2>] } scale .8 } }
plane { y, -0.8 texture { pigment { wood turbulence .3 color_map { [0 rgb .4] [1 rgb <.8,.6,.3>] } rotate x*20 } }
  texture { Veins } }
sphere { -1.6*x, 0.9 pigment { average pigment_map { [1 agate scale .4] [2 wrinkles] [1 marble turbulence .4] } } }
sphere { 1.6*x, 0.9 uv_mapping pigment { spotted scale .1 warp { turbulence .2 } } normal { dents .5 scale .2 } }
box { -0.6, 0.6 texture { bozo texture_map { [.4 pigment { leopard }] [.6 Veins] } scale .3 } rotate y*30 }
sphere { <0, 1.6, 0>, 0.5 pigment { slope y turbulence .2 } normal { granite .3 } finish { reflection .3 } }
";

#[test]
fn neighbours_share_work_and_no_bits() {
    // Where parts begin and end, other rays are neighbours, or there are none.
    ways().into_iter().for_each(|way| check(NOISY, way));
}

#[test]
fn regions_end_with_the_picture() {
    let region = Some(Region { left: 70, top: 40, right: 90, bottom: 60 });
    let options = Options { region, ..small(None) };
    assert_eq!(options.window(), Region { left: 70, top: 40, right: 75, bottom: 50 });
}

/// What blocks light lies in the same place as what lets it through, so that rounding says which of them a ray meets.
const SAME_PLACE: &str = "
camera { location <1, 4, -6> look_at 0 angle 45 right x*4/3 }
light_source { <9, 9, -7>*50 rgb 1 }
plane { y, -1 pigment { rgb 1 } }
union {
  box { <-1, -1, 0>, <1, 1, 1> pigment { rgbf <1, .5, .3, .8> } interior { ior 1.2 } }
  difference { box { <-1, -1, -1>, <1, 1, 1> } box { <-.8, -.8, -2>, <.8, .8, .7> } pigment { rgb .4 } }
  rotate <20, 35, 10>
}
";

#[test]
fn shadows_do_not_depend_on_others() {
    check(SAME_PLACE, None);
}
