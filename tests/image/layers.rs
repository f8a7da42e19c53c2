//! Layers agree with the picture and with the scene.

use super::*;
use whitted::imaging::Layer;
use whitted::render::ImageLayer;

fn layered(scene: &str, antialias: Option<Antialias>) -> Picture {
    picture(&world(scene), &Options { layers: ImageLayer::ALL.to_vec(), ..small(antialias) })
}

fn layer<'p>(picture: &'p Picture, name: &str) -> &'p Layer {
    picture.layers.iter().find(|l| l.name == name).unwrap_or_else(|| panic!("no layer {name}"))
}

/// Values of a layer at a pixel, channel by channel.
fn values(picture: &Picture, name: &str, x: usize, y: usize) -> Vec<f32> {
    layer(picture, name).channels.iter().map(|(_, values)| values[y * picture.width + x]).collect()
}

/// The picture keeps its bits, and the terms of light add up to it.
fn check(scene: &str) {
    for way in ways() {
        let plain = picture(&world(scene), &small(way));
        let with_layers = layered(scene, way);
        assert_eq!(plain.pixels, with_layers.pixels, "{way:?}");
        let terms = ["emission", "direct", "reflection", "refraction", "background", "atmosphere"];
        for (i, pixel) in plain.pixels.iter().enumerate() {
            for (c, value) in pixel.iter().enumerate().take(3) {
                let sum: f32 = terms.iter().map(|t| layer(&with_layers, t).channels[c].1[i]).sum();
                // Sums of a few dozen samples in single precision.
                assert!((sum - value).abs() < 3e-6 * value.max(1.0), "{sum} is not {value} at {i}");
            }
        }
    }
}

#[test]
fn light_adds_up_to_the_picture() {
    check(SCENE);
    check(&format!("{SCENE}{LENS}"));
    check("camera { panoramic } sphere { 3*z, 1 pigment { rgbt .5 } } light_source { 0 1 } background { rgb .3 }");
    // Terms share what the curve of another gamma makes of their sum.
    check(&format!("global_settings {{ assumed_gamma 2.2 }} {SCENE}"));
}

#[test]
fn geometry_is_that_of_the_scene() {
    // A wall at z = 3, bent in a smooth triangle, seen straight on.
    let scene = "camera { location <0, 0, -2> look_at 0 angle 60 right x*3/2 up y }
        box { <-9, -9, 3>, <0, 9, 4> pigment { rgb <.2, .4, .6> } finish { ambient 1 diffuse 0 } }";
    let picture = layered(scene, None);
    let (left, right) = ((10, 25), (60, 25));
    assert_eq!(values(&picture, "", left.0, left.1), [5.0]);
    assert_eq!(values(&picture, "", right.0, right.1), [1e10]);
    let found = values(&picture, "P", left.0, left.1);
    // Column 10 of 75 on a field that is 2 tan 30° wide at distance 1.
    let expected = ((10.5 / 75.0 - 0.5) * 2.0 * 30f64.to_radians().tan() * 5.0) as f32;
    assert!((found[0] - expected).abs() < 1e-5 && (found[2] - 3.0).abs() < 1e-6, "{found:?} {expected}");
    for name in ["N", "Ng"] {
        assert_eq!(values(&picture, name, left.0, left.1), [0.0, 0.0, -1.0]);
        assert_eq!(values(&picture, name, right.0, right.1), [0.0; 3]);
    }
    assert_eq!(values(&picture, "albedo", left.0, left.1), [0.2, 0.4, 0.6]);
    assert_eq!(values(&picture, "emission", left.0, left.1), [0.2, 0.4, 0.6]);
    assert_eq!(values(&picture, "samples", left.0, left.1), [1.0]);
}

#[test]
fn bumps_show_in_the_shading_normal_alone() {
    let picture = layered(SCENE, None);
    // The green ball with bumps stands above the middle.
    let (x, y) = (37, 18);
    let dot: f32 = values(&picture, "N", x, y).iter().zip(values(&picture, "Ng", x, y)).map(|(a, b)| a * b).sum();
    assert!(dot > 0.5 && dot < 0.9999, "{dot}");
}

#[test]
fn mattes_cover_pixels_by_samples() {
    let picture = layered(SCENE, ways()[1]);
    let manifest = &layer(&picture, "CryptoObject00").attributes[3].1;
    for name in ["\"plane\"", "\"Ball\"", "\"Ball.001\"", "\"Glass\"", "\"sphere\""] {
        assert!(manifest.contains(name), "{name} is missing in {manifest}");
    }
    let mut edges = 0;
    for y in 0..picture.height {
        for x in 0..picture.width {
            let ranks = [values(&picture, "CryptoObject00", x, y), values(&picture, "CryptoObject01", x, y)].concat();
            let shares: Vec<f32> = ranks.iter().skip(1).step_by(2).copied().collect();
            let total: f32 = shares.iter().sum();
            assert!(total < 1.0 + 1e-5 && shares.windows(2).all(|w| w[0] >= w[1]), "{shares:?}");
            edges += usize::from(shares[1] > 0.0);
            let samples = values(&picture, "samples", x, y)[0];
            assert!(samples == 1.0 || samples == 5.0, "{samples}");
        }
    }
    assert!(edges > 50, "{edges} pixels show two objects");
}
