//! `whitted report`, from the command line to the page in a browser.
//!
//! The browser is Debian's package `chromium`; where there is none, that test says so and looks no further.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A report of a scene with something for every ladder, and of one that cannot be read.
fn report(folder: &Path) -> PathBuf {
    let wrong = folder.join("wrong.pov");
    std::fs::write(&wrong, "#version 3.7; sphere { 0, }").unwrap();
    let output = folder.join("out");
    let mut command = Command::new(env!("CARGO_BIN_EXE_whitted"));
    command.args(["report", "tests/report/page.pov"]).arg(&wrong).arg("-o").arg(&output);
    command.args("-W 48 -H 36 --runs 2 --embedded-includes --no-warn all".split(' '));
    let done = command.output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    output
}

#[test]
fn figures_stand_in_all_three_files() {
    let folder = tempfile::tempdir().unwrap();
    let output = report(folder.path());
    let json: Value = serde_json::from_str(&std::fs::read_to_string(output.join("report.json")).unwrap()).unwrap();
    let rungs = json["rungs"].as_array().unwrap();
    let ladders: std::collections::BTreeSet<&str> = rungs.iter().filter_map(|rung| rung["ladder"].as_str()).collect();
    let expected = "adc_bailout area_light_grid isosurface_accuracy max_trace_level method_1 method_2 no_antialiasing target_error";
    assert_eq!(ladders.iter().map(|name| name.replace(' ', "_")).collect::<Vec<_>>().join(" "), expected);
    for rung in rungs {
        assert!(rung["failure"].is_null(), "{rung}");
        assert!(rung["rmse"].is_number() && rung["cpu_min_s"].as_f64() > Some(0.0) && rung["runs"] == 2, "{rung}");
        let camera = rung["camera_rays"].as_u64().unwrap();
        assert!(camera >= 48 * 36 && rung["shadow_rays"].as_u64() > Some(0), "{rung}");
    }
    // Finer rungs of a method are closer to the reference, which is closer to itself than all of them.
    let errors = |ladder: &str| -> Vec<f64> {
        rungs.iter().filter(|rung| rung["ladder"] == ladder).filter_map(|rung| rung["rmse"].as_f64()).collect()
    };
    let (plain, grid) = (errors("no antialiasing"), errors("method 1"));
    assert!(grid.last() < grid.first() && grid.first() < plain.first(), "{plain:?} {grid:?}");
    let own = rungs[0]["reference_rmse"].as_f64();
    assert!(own < grid.last().copied(), "{rungs:?}");
    // A target is missed once in twenty times, by little.
    let targets: Vec<&Value> = rungs.iter().filter(|rung| rung["ladder"] == "target error").collect();
    let hits = targets.iter().filter(|rung| rung["rmse"].as_f64() <= rung["target_rmse"].as_f64()).count();
    assert!(targets.len() == 6 && hits >= 4 && targets.iter().all(|rung| rung["estimated_rmse"].is_number()), "{hits}");
    for limit in ["max_trace_level", "adc_bailout", "area_light_grid", "isosurface_accuracy"] {
        let errors = errors(limit);
        assert!(errors.first() > errors.last(), "{limit}: {errors:?}");
    }
    assert!(json["scenes"][1]["failure"].is_string() && json["scenes"][1]["reference"].is_null(), "{json}");
    let lines = std::fs::read_to_string(output.join("report.csv")).unwrap().lines().count();
    assert_eq!(lines, 1 + rungs.len());
}

/// The first browser that answers.
fn chromium() -> Option<&'static str> {
    let answers = |name: &&str| Command::new(name).arg("--version").output().is_ok_and(|o| o.status.success());
    ["chromium", "chromium-browser", "google-chrome"].into_iter().find(answers)
}

fn open(browser: &str, page: &Path, profile: &Path, more: &[&str]) -> Output {
    let mut command = Command::new(browser);
    command
        .args("--headless --no-sandbox --disable-gpu --enable-logging=stderr --virtual-time-budget=10000".split(' '));
    command.arg(format!("--user-data-dir={}", profile.display())).args(more);
    command.arg(format!("file://{}", page.display())).output().unwrap()
}

/// Lines of the browser's log that come from the page.
fn console(output: &Output) -> Vec<String> {
    let log = String::from_utf8_lossy(&output.stderr).into_owned();
    log.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned).collect()
}

#[test]
fn the_page_works_in_a_browser() {
    let Some(browser) = chromium() else {
        eprintln!("skipped: there is no chromium (Debian: apt-get install chromium)");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let page = report(folder.path()).join("report.html");
    let profile = folder.path().join("profile");
    for look in ["--blink-settings=preferredColorScheme=1", "--blink-settings=preferredColorScheme=0"] {
        let plain = open(browser, &page, &profile, &[look, "--dump-dom"]);
        assert_eq!(console(&plain), [""; 0]);
    }
    let text = std::fs::read_to_string(&page).unwrap();
    let ear = "<script>window.problems = []; addEventListener('error', (e) => problems.push(e.message));</script>";
    let probe = format!("<script>{}</script></body>", include_str!("report/probe.js"));
    let copy = folder.path().join("copy.html");
    std::fs::write(&copy, text.replacen("<head>", &format!("<head>{ear}"), 1).replacen("</body>", &probe, 1)).unwrap();
    for window in ["--window-size=1200,900", "--window-size=500,900"] {
        let looked = open(browser, &copy, &profile, &[window, "--dump-dom"]);
        assert_eq!(console(&looked), [""; 0]);
        let dom = String::from_utf8_lossy(&looked.stdout).into_owned();
        let found = dom.split("<pre id=\"found\">").nth(1).and_then(|rest| rest.split("</pre>").next());
        let found = found.unwrap_or_else(|| panic!("the probe did not run: {dom:.300}"));
        let plain = found.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
        check(&serde_json::from_str(&plain).unwrap(), window);
    }
}

fn check(found: &Value, window: &str) {
    let plots = found["plots"].as_array().unwrap();
    // Time, rays and targets, and a plot for each of four limits.
    assert_eq!(plots.len(), 7, "{found}");
    for plot in plots {
        assert!(plot["width"].as_f64() > Some(250.0) && plot["height"].as_f64() > Some(180.0), "{window}: {plot}");
        assert!(plot["within"] == true, "{window}: {plot}");
    }
    assert!(plots[..2].iter().all(|plot| plot["marks"] == 20), "a mark for each rung: {plots:?}");
    assert!(found["colors"].as_u64() >= Some(3), "{found}");
    assert!(found["images"].as_array().unwrap().iter().all(|width| *width == 48), "{found}");
    assert_eq!(found["choices"], 10);
    assert!(found["overflow"].as_f64() <= Some(0.0), "{window}: the page is wider than the window");
    assert_ne!(found["before"], found["after"], "the slider moves the border");
    assert_eq!(found["after"], "inset(0px 80% 0px 0px)");
    assert_eq!(found["beside_reference"], serde_json::json!(["reference", "picture"]));
    assert_eq!(found["beside_heatmap"], serde_json::json!(["reference", "heatmap", "picture"]));
    assert!(
        found["last_choice"].as_str().unwrap().ends_with(found["name"].as_str().unwrap()) && found["name"] != "",
        "{found}"
    );
    let failures = found["failures"].as_array().unwrap();
    assert!(failures.len() == 1 && failures[0].as_str().unwrap().contains("no figures"), "{failures:?}");
    assert_eq!(found["problems"], serde_json::json!([]));
}
