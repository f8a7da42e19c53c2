use crate::diag::{Severity, Span};
use crate::eval::{Memory, NoQueries, Options, evaluate};
use crate::scene::{GatherRadius, PhotonFile, Photons, Radiosity, Settings, Subsurface};

/// What a scene's settings are, with its warnings; or its error.
fn read(version: &str, text: &str) -> Result<(Settings, Vec<String>), String> {
    let text = format!("#version {version}; global_settings {{ assumed_gamma 1 {text} }} sphere {{ 0, 1 }}");
    let host = Memory::new([("a.pov", text.as_str())]);
    let said = |diagnostics: Vec<crate::diag::Diagnostic>, severity| -> Vec<String> {
        let wanted = diagnostics.into_iter().filter(|d| d.severity == severity);
        wanted.inspect(|d| assert!(d.span.is_some(), "{text}: {}", d.message)).map(|d| d.message).collect()
    };
    match evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries) {
        Ok(read) => Ok((read.scene.settings, said(read.warnings, Severity::Warning))),
        Err(failed) => Err(said(failed.diagnostics, Severity::Error).swap_remove(0)),
    }
}

/// Settings of radiosity that give these values, apart from their place.
fn radiosity(text: &str, expected: Radiosity) {
    let found = read("3.7", text).map(|(s, _)| s.radiosity.map(|r| Radiosity { span: Span::default(), ..r }));
    assert_eq!(found, Ok(Some(expected)), "{text}");
}

/// The same of photons.
fn photons(text: &str, expected: Photons) {
    let found = read("3.7", text).map(|(s, _)| s.photons.map(|p| Photons { span: Span::default(), ..p }));
    assert_eq!(found, Ok(Some(expected)), "{text}");
}

fn warns(text: &str, message: &str) {
    match read("3.7", text) {
        Ok((_, warnings)) => assert!(warnings.iter().any(|w| w.contains(message)), "{text}: {warnings:?}"),
        Err(error) => panic!("{text}: {error}"),
    }
}

fn fails(text: &str, message: &str) {
    let found = read("3.7", text).map(|_| ());
    assert!(found.as_ref().is_err_and(|error| error.contains(message)), "{text}: {found:?}");
}

/// What POV-Ray 3.7.0.10 takes; the defaults are those of its manual.
#[test]
fn radiosity_is_kept() {
    let default = Radiosity::default;
    assert!(read("3.7", "").is_ok_and(|(s, _)| s.radiosity.is_none() && s.photons.is_none()));
    radiosity("radiosity {}", default());
    radiosity("radiosity { count 10.7 }", Radiosity { count: 10, ..default() });
    radiosity("radiosity { count 2000 }", Radiosity { count: 2000, directions: 2000, ..default() });
    radiosity("radiosity { count 5.5 5 }", Radiosity { count: 5, directions: 5, ..default() });
    radiosity("radiosity { count 5, error_bound 1 }", Radiosity { count: 5, error_bound: 1.0, ..default() });
    let nearest = Radiosity { nearest_count: 20, enough_for_pretrace: 3, ..default() };
    radiosity("radiosity { nearest_count 20.9, 3 }", nearest);
    radiosity("radiosity { low_error_factor 2 }", Radiosity { low_error_factor: 2.0, ..default() });
    radiosity("radiosity { recursion_limit 20.5 }", Radiosity { recursion_limit: 20, ..default() });
    let factors = Radiosity { brightness: 3.0, gray_threshold: 1.0, adc_bailout: 2.0, ..default() };
    radiosity("radiosity { brightness 3 gray_threshold 1 adc_bailout 2 }", factors);
    radiosity("radiosity { max_sample 0.3 }", Radiosity { max_sample: Some(0.3), ..default() });
    radiosity("radiosity { max_sample -5 }", default());
    let on = Radiosity { always_sample: true, normal: true, media: true, subsurface: true, ..default() };
    radiosity("radiosity { always_sample on normal yes media -1 subsurface 1.5 }", on);
    radiosity("radiosity { always_sample off normal .9 media -.4 subsurface 0 }", default());
    let both = Radiosity { pretrace_start: 0.5, pretrace_end: 0.3, ..default() };
    radiosity("radiosity { pretrace_start .5 } radiosity { pretrace_end .3 }", both);
}

#[test]
fn distances_of_reuse_keep_apart() {
    let reuse = |text: &str| {
        read("3.7", &format!("radiosity {{ {text} }}")).map(|(s, w)| (s.radiosity.map(|r| r.reuse()), w.len()))
    };
    let check = |text, reuse_at, n_warnings| assert_eq!(reuse(text), Ok((Some(reuse_at), n_warnings)), "{text}");
    check("", [0.015, 0.2], 0);
    check("minimum_reuse .15", [0.15, 0.3], 1);
    check("maximum_reuse .02", [0.01, 0.02], 1);
    check("minimum_reuse .1 maximum_reuse .2", [0.1, 0.2], 0);
    check("minimum_reuse .15 maximum_reuse .2", [0.15, 0.2], 1);
    check("minimum_reuse 0 maximum_reuse 1", [0.0, 1.0], 0);
    fails("radiosity { minimum_reuse .2 maximum_reuse .2 }", "must be above minimum_reuse");
}

/// Each of these is refused by POV-Ray 3.7.0.10, too.
#[test]
fn radiosity_has_ranges() {
    for text in [
        "count 0.5",
        "count 10, 5",
        "count 10,, 20",
        "count",
        "error_bound 0",
        "low_error_factor 0",
        "nearest_count 0",
        "nearest_count 21",
        "nearest_count 5.7,5",
        "nearest_count 5,-1",
        "minimum_reuse -1",
        "maximum_reuse 0",
        "pretrace_start 0",
        "pretrace_start 1.1",
        "pretrace_end 0",
        "recursion_limit 0",
        "recursion_limit 21",
        "brightness 0",
        "gray_threshold -1",
        "gray_threshold 1.1",
        "adc_bailout 0",
    ] {
        fails(&format!("radiosity {{ {text} }}"), "");
    }
    fails("radiosity { pretrace_end .09 }", "pretrace_end must not be above pretrace_start");
    fails("radiosity { always_sample }", "expected");
    fails("radiosity { count 5, , brightness 2 }", "to close radiosity");
    fails("radiosity { distance_maximum 5 }", "to close radiosity");
    fails("radiosity { importance .5 }", "to close radiosity");
    fails("radiosity off", "to open radiosity");
    warns("radiosity { load_file \"x\" }", "load_file of radiosity has no effect");
    warns("radiosity { save_file concat(\"x\", \"y\") }", "save_file of radiosity has no effect");
    let old =
        |version| read(version, "radiosity {}").map_or(0, |(_, w)| w.iter().filter(|w| w.contains("3.5")).count());
    assert_eq!((old("3.1"), old("3.5")), (1, 0));
}

/// What POV-Ray 3.7.0.10 takes.
#[test]
fn photons_are_kept() {
    let default = Photons::default;
    photons("photons {}", default());
    photons(
        "photons { spacing -1 jitter 5 autostop 2 }",
        Photons { spacing: -1.0, jitter: 5.0, autostop: 2.0, ..default() },
    );
    photons("photons { count 100.5 }", Photons { count: Some(100), ..default() });
    photons("photons { count -5 }", default());
    photons("photons { gather 20.9 20.1 }", Photons { gather: [20, 20], ..default() });
    let thresholds = Photons { expand_increase: 0.0, expand_minimum: 3, ..default() };
    photons("photons { expand_thresholds -.2, 3.7 }", thresholds);
    let radius = |length, factor| GatherRadius { length, factor };
    let radii = |surface_radius, media_radius| Photons { surface_radius, media_radius, ..default() };
    photons("photons { radius }", default());
    photons("photons { radius .1 2 .3 4 }", radii(radius(Some(0.1), 2.0), radius(Some(0.3), 4.0)));
    photons("photons { radius ,,.5 }", radii(radius(None, 1.0), radius(Some(0.5), 1.0)));
    photons("photons { radius -1, 2, jitter .4 }", radii(radius(None, 2.0), radius(None, 1.0)));
    photons("photons { media 100.9, 2 }", Photons { media_steps: 100, media_factor: 2.0, ..default() });
    let limits = Photons { max_trace_level: Some(2), adc_bailout: Some(0.5), ..default() };
    photons("photons { max_trace_level 2.9 adc_bailout .5 }", limits);
    photons("photons { max_trace_level -1 adc_bailout -1 }", default());
    photons("photons { save_file \"a\" }", Photons { file: Some(PhotonFile::Save("a".into())), ..default() });
    photons("photons { spacing 3 } photons { count 5 }", Photons { count: Some(5), ..default() });
}

/// What POV-Ray 3.7.0.10 refuses or warns about.
#[test]
fn photons_have_ranges() {
    for text in ["gather 5", "gather 5,, 10", "gather -1, 10", "gather 11, 10", "media -1", "media 10, 0"] {
        fails(&format!("photons {{ {text} }}"), "");
    }
    for text in ["expand_thresholds .2", "radius 1, 2, 3, 4, 5", "target", "steps 5", "spacing .1, count 5"] {
        fails(&format!("photons {{ {text} }}"), "");
    }
    warns("photons { expand_thresholds .2, -10 }", "taken for 0");
    warns("photons { save_file \"a\" load_file \"b\" }", "this load_file is what counts");
    warns("photons { gather 0, .5 }", "switched off");
    assert!(read("3.7", "photons { gather 0, 0 }").is_ok_and(|(s, _)| s.photons.is_none()));
}

/// What POV-Ray 3.7.0.10 says of the same words, and how many photons it shoots then.
#[test]
fn targets_let_photons_pass_or_bend_them() {
    let check = |words: &str, refraction: Option<bool>, pass_through: bool, off: &[&str]| {
        let text =
            format!("#version 3.7; global_settings {{ assumed_gamma 1 }} sphere {{ 0, 1 photons {{ {words} }} }}");
        let host = Memory::new([("a.pov", text.as_str())]);
        let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries);
        let read = read.unwrap_or_else(|_| panic!("{words}"));
        let flags = read.scene.objects[0].rare.photons;
        assert_eq!((flags.refraction, flags.pass_through), (refraction, pass_through), "{words}");
        let ends = off.iter().map(|word| format!("here {word} is off"));
        let warnings: Vec<_> = read.warnings.iter().map(|warning| &warning.message).collect();
        assert!(warnings.len() == off.len() && warnings.iter().zip(ends).all(|(w, end)| w.ends_with(&end)), "{words}");
    };
    let (on, off) = (Some(true), Some(false));
    check("target refraction on pass_through", off, true, &["refraction"]);
    check("target refraction on } photons { pass_through", off, true, &["refraction"]);
    check("refraction on target pass_through", off, true, &["refraction"]);
    check("target pass_through", off, true, &["refraction"]);
    check("pass_through target", off, true, &["refraction"]);
    check("target reflection on pass_through", off, true, &["refraction"]);
    check("target pass_through refraction off", off, true, &["refraction"]);
    check("target pass_through refraction on", on, false, &["refraction", "pass_through"]);
    check("pass_through target refraction on", on, false, &["refraction", "pass_through"]);
    check("target refraction on pass_through refraction on", on, false, &["refraction", "pass_through"]);
    check("refraction on pass_through target", on, false, &["pass_through"]);
    check("pass_through refraction on target", on, false, &["pass_through"]);
    check("pass_through refraction on", on, true, &[]);
    check("target refraction off pass_through", off, true, &[]);
    check("target refraction on pass_through off", on, false, &[]);
    check("target 0 refraction on pass_through", on, true, &[]);
}

#[test]
fn subsurface_is_kept() {
    let check = |text: &str, samples, radiosity| {
        let found = read("3.7", text).map(|(s, _)| s.subsurface.map(|s| Subsurface { span: Span::default(), ..s }));
        assert_eq!(found, Ok(Some(Subsurface { samples, radiosity, ..Subsurface::default() })), "{text}");
    };
    check("subsurface {}", [50, 50], false);
    check("subsurface { radiosity on samples 5 6 }", [5, 6], true);
    fails("subsurface { samples 5 }", "expected");
    fails("subsurface { radiosity }", "expected");
    fails("subsurface { radiosity off, samples 4, 4 }", "to close subsurface");
}
