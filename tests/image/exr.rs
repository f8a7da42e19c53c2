//! Files opened by another program: Python's OpenEXR, where it is installed.

use super::SCENE;
use std::path::Path;
use std::process::Command;

#[test]
fn two_renders_give_the_same_file() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let scene = folder.path().join("scene.pov");
    std::fs::write(&scene, SCENE).expect("written");
    let file = |threads: &str| {
        let output = folder.path().join("picture.exr");
        let mut whitted = Command::new(env!("CARGO_BIN_EXE_whitted"));
        whitted.args(["render", "-W", "40", "-H", "30", "-t", threads]).arg(&scene).arg("-o").arg(&output);
        assert!(whitted.output().expect("whitted runs").status.success());
        std::fs::read(output).expect("a picture")
    };
    assert!(file("1") == file("2"));
}

#[test]
fn another_program_reads_our_layers() {
    let installed = Command::new("python3").args(["-c", "import OpenEXR, numpy"]).output();
    if !installed.is_ok_and(|o| o.status.success()) {
        eprintln!("skipped: python3 with OpenEXR and numpy is not installed");
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let scene = folder.path().join("scene.pov");
    std::fs::write(&scene, format!("#version 3.7; global_settings {{ assumed_gamma 1.0 }}\n{SCENE}")).expect("written");
    let render = |name: &str, more: &[&str]| {
        let output = folder.path().join(name);
        let whitted = Command::new(env!("CARGO_BIN_EXE_whitted"))
            .args(["render", "-W", "80", "-H", "60", "--antialias", "1,0.1,2", "--float"])
            .args(more)
            .arg(&scene)
            .arg("-o")
            .arg(&output)
            .output()
            .expect("whitted runs");
        assert!(whitted.status.success(), "{}", String::from_utf8_lossy(&whitted.stderr));
        output
    };
    let plain = render("plain.exr", &[]);
    let layers = render("layers.exr", &["--layers", "all"]);
    let part = render("part.exr", &["--layers", "Z,N", "--region", "10,20,50,45"]);
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/image/check_layers.py");
    let check = Command::new("python3").arg(script).args([plain, layers, part]).output().expect("python3 runs");
    assert!(check.status.success(), "{}", String::from_utf8_lossy(&check.stderr));
}
