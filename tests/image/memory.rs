//! Pictures that a scene names come from its host, and none from the disk.

use super::*;
use whitted::imaging::{self, Encoding, Metadata};

/// A picture of one colour as an EXR file has it.
fn exr(color: [f32; 4]) -> std::io::Result<Vec<u8>> {
    let path = tempfile::tempdir()?.keep().join("a.exr");
    imaging::save(
        &path,
        &Picture::filled(2, 2, color),
        &Metadata::default(),
        &Encoding { float: true, ..Encoding::default() },
    )
    .map_err(std::io::Error::other)?;
    let bytes = std::fs::read(&path)?;
    path.parent().map_or(Ok(()), std::fs::remove_dir_all)?;
    Ok(bytes)
}

/// The colour that a plane shows whose texture names `file`, which lies in memory alone.
fn check(statement: &str, file: &str, bytes: Vec<u8>, expected: [f32; 3]) {
    let text = format!(
        "#version 3.7; global_settings {{ assumed_gamma 1.0 }} camera {{ orthographic location -z look_at 0 }}
        {statement}"
    );
    let host = Memory::new([("a.pov", text.as_str())]).with(file, bytes);
    let read = eval::evaluate("a.pov".as_ref(), &eval::Options::default(), &host, &Queries::default());
    let world = compile::compile(&read.expect("the scene is right").scene).expect("the picture is there").world;
    let found = picture(&world, &Options { width: 2, height: 2, ..Options::default() }).pixels[0];
    assert!(found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-3), "{statement}: {found:?}, not {expected:?}");
}

#[test]
fn pictures_come_from_the_host() -> std::io::Result<()> {
    let plane = |picture: &str| {
        format!("plane {{ z, 0 pigment {{ image_map {{ {picture} }} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}")
    };
    let ppm = || b"P6\n1 1\n255\n\xff\x00\xff".to_vec();
    check(&plane("ppm \"a.ppm\""), "a.ppm", ppm(), [1.0, 0.0, 1.0]);
    check(&plane("exr \"a.exr\""), "a.exr", exr([0.25, 1.5, 0.5, 1.0])?, [0.25, 1.5, 0.5]);
    let field = "height_field { ppm \"b.ppm\" smooth translate -.5 scale 9 rotate -90*x pigment { rgb 1 }
        finish { ambient 0 diffuse 0 emission 1 } }";
    check(field, "b.ppm", b"P6\n2 2\n255\n\x0f\0\0\x0f\0\0\x0f\0\0\x0f\0\0".to_vec(), [1.0; 3]);
    let function = "#declare F = function { pigment { image_map { ppm \"a.ppm\" } } } #declare C = F(.5, .5, 0);
        plane { z, 0 pigment { rgb <C.x, C.y, C.z> } finish { ambient 0 diffuse 0 emission 1 } }";
    check(function, "a.ppm", ppm(), [1.0, 0.0, 1.0]);
    Ok(())
}
