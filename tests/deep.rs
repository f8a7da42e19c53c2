//! Nesting of ten thousand levels works or is refused with its place; nothing crashes.
//!
//! Solids that cut each other so often are out of sight: what a ray meets of them costs the square of their number, in
//! POV-Ray five times as much.

use std::io;
use std::process::Command;

/// Renders a scene of a few pixels; whether it could, and what was said.
fn render(text: &str, options: &[&str]) -> io::Result<(bool, String)> {
    let folder = tempfile::tempdir()?;
    std::fs::write(
        folder.path().join("s.pov"),
        format!("#version 3.7; global_settings {{ assumed_gamma 1 }}\n{text}"),
    )?;
    let output = Command::new(env!("CARGO_BIN_EXE_whitted"))
        .current_dir(folder.path())
        .args(["render", "s.pov", "-o", "s.exr", "-W", "4", "-H", "3", "-t", "1"])
        .args(options)
        .output()?;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    match output.status.code() {
        Some(0) => Ok((true, said)),
        Some(2) => Ok((false, said)),
        other => panic!("{other:?}: {} …\n{}", &text[..text.len().min(200)], &said[..said.len().min(2000)]),
    }
}

const SIGHT: &str = "camera { location -5*z look_at 0 } light_source { -9*z rgb 1 }\n";

/// `open` so many times, the middle, `close` as often, between what stands before and behind.
fn nest(n: usize, [before, open, middle, close, behind]: [&str; 5]) -> String {
    format!("{SIGHT}{before}{}{middle}{}{behind}", open.repeat(n), close.repeat(n))
}

/// Text nested ten thousand times works, and a hundred thousand times it is refused with its place; `n` times by
/// default.
fn check(parts: [&str; 5]) -> io::Result<()> {
    let (works, said) = render(&nest(9_000, parts), &[])?;
    assert!(works, "{parts:?}: {}", &said[..said.len().min(2000)]);
    for options in [&[][..], &["--untrusted"]] {
        let (works, said) = render(&nest(100_000, parts), options)?;
        assert!(!works && said.contains("s.pov:"), "{parts:?}: {}", &said[..said.len().min(2000)]);
    }
    Ok(())
}

#[test]
fn text_nests_deeply() -> io::Result<()> {
    check(["#declare A = ", "(", "1", ")", ";"])?;
    check(["#declare A = ", "-(2*", "1", ")", ";"])?;
    check(["#declare A = ", "max(1,", "1", ")", ";"])?;
    check(["#declare A = (", "1 ? 1 : ", "1", "", ");"])?;
    check(["#declare A = ", "concat(\"\",", "\"a\"", ")", ";"])?;
    check(["#declare A = ", "<0,1,", "1", ">.x", ";"])?;
    check(["", "union { ", "sphere { 0, 1 }", "}", ""])?;
    check(["", "difference { ", "sphere { 1000, 1 pigment { rgb 1 } }", "box { 999, 1000 } }", ""])?;
    check(["", "merge { sphere { 1000, 1 } ", "sphere { 1000, 1 }", " translate .0001*x }", ""])?;
    check(["", "object { ", "sphere { 0, 1 }", "}", ""])?;
    check(["", "sphere { 0, 1 clipped_by { ", "plane { x, 0 }", "} }", ""])?;
    check(["sphere { 0, 1 pigment { ", "gradient x pigment_map { [0 ", "rgb 1", "] [1 rgb 0] }", "} }"])?;
    check([
        "sphere { 0, 1 pigment { rgb 1 } normal { ",
        "gradient x normal_map { [0 ",
        "bumps",
        "] [1 bumps] }",
        "} }",
    ])?;
    check([
        "sphere { 0, 1 texture { ",
        "gradient x texture_map { [0 ",
        "pigment { rgb 1 }",
        "] [1 pigment { rgb 0 }] }",
        "} }",
    ])
}

/// Directives nest without end: they take no stack.
#[test]
fn directives_nest_deeply() -> io::Result<()> {
    for parts in [["", "#if (1) ", "", " #end", ""], ["", "#for (I, 1, 1) ", "", " #end", ""]] {
        let (works, said) = render(&nest(10_000, parts), &[])?;
        assert!(works, "{parts:?}: {}", &said[..said.len().min(2000)]);
    }
    Ok(())
}

/// What declarations nest, without nesting any text.
fn check_declared(first: &str, step: &str, used: &str) -> io::Result<()> {
    let scene = |n: usize| format!("{SIGHT}#declare A = {first}\n#for (I, 1, {n}) #declare A = {step} #end\n{used}");
    let (works, said) = render(&scene(10_000), &[])?;
    assert!(works, "{step}: {}", &said[..said.len().min(2000)]);
    for options in [&[][..], &["--untrusted"]] {
        let (works, said) = render(&scene(300_000), options)?;
        assert!(!works && said.contains("s.pov:"), "{step}: {}", &said[..said.len().min(2000)]);
    }
    Ok(())
}

#[test]
fn declarations_nest_deeply() -> io::Result<()> {
    check_declared("sphere { 0, 1 }", "union { object { A } sphere { I*x, 1 } }", "object { A }")?;
    check_declared("sphere { 1000, 1 }", "difference { object { A } sphere { 1000 + I*x, .1 } }", "object { A }")?;
    check_declared("sphere { 0, 1 }", "sphere { 0, 1 clipped_by { object { A } } }", "object { A }")?;
    check_declared(
        "pigment { rgb 1 }",
        "pigment { gradient x pigment_map { [0 A] [1 rgb 0] } }",
        "sphere { 0, 1 pigment { A } }",
    )?;
    check_declared(
        "normal { bumps }",
        "normal { gradient x normal_map { [0 A] [1 bumps] } }",
        "sphere { 0, 1 pigment { rgb 1 } normal { A } }",
    )?;
    check_declared(
        "texture { pigment { rgb 1 } }",
        "texture { gradient x texture_map { [0 A] [1 pigment { rgb 0 }] } }",
        "sphere { 0, 1 texture { A } }",
    )?;
    check_declared(
        "sphere { 0, 1 }",
        "sphere { 0, 1 pigment { object { A color rgb 0, color rgb 1 } } }",
        "object { A }",
    )
}

#[test]
fn macros_call_themselves() -> io::Result<()> {
    let (works, said) = render(&format!("{SIGHT}#macro M(N) #if (N) M(N - 1) #end #end M(20000)"), &[])?;
    assert!(works, "{}", &said[..said.len().min(2000)]);
    let (works, said) = render(&format!("{SIGHT}#macro M(N) (N ? 1 + M(N - 1) : 0) #end #declare A = M(1);"), &[])?;
    assert!(!works && said.contains("s.pov:") && said.len() < 20_000, "{}", &said[..said.len().min(2000)]);
    Ok(())
}
