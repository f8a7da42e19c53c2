//! The short form of `whitted stability`: no family breaks earlier than docs/stability.csv says.
//!
//! Costs are times, which no test may hold; `whitted stability cost` measures them.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;
use whitted::measure::{Caller, Program};
use whitted::stability::{Family, Setup, Sweep, Truth, catalog};

/// Steps that took longer when the table was made are left to the whole command.
const LONGEST: f64 = 1.0;

/// Of each family, how many steps whitted has right by the table before the first that is wrong or takes long.
fn recorded() -> BTreeMap<String, usize> {
    let table = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/stability.csv")).unwrap();
    let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let heads = lines.next().unwrap();
    let column = |name: &str| heads.iter().position(|head| *head == name).unwrap();
    let [family, program, is_right, cpu] = ["family", "program", "is_right", "cpu_s"].map(column);
    let mut recorded = BTreeMap::new();
    let mut is_over = BTreeMap::new();
    for line in lines.filter(|line| line[program] == "whitted") {
        let over = is_over.entry(line[family].to_owned()).or_insert(false);
        *over |= line[is_right] != "true" || line[cpu].parse().is_ok_and(|seconds: f64| seconds > LONGEST);
        *recorded.entry(line[family].to_owned()).or_default() += usize::from(!*over);
    }
    recorded
}

fn sweep(family: &Family, most: usize) -> Sweep {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["--embedded-includes", "--no-warn", "all"].map(Into::into).into();
    let setup = Setup {
        program: Program::Whitted,
        caller: Caller { program: env!("CARGO_BIN_EXE_whitted").into(), arguments },
        // Far from what a step takes, however busy the machine is.
        limit: Duration::from_secs(120),
        folder: folder.path().to_owned(),
    };
    setup.sweep(family, most, |_| {})
}

#[test]
fn no_breaking_point_has_moved_nearer() {
    let recorded = recorded();
    let families: Vec<Family> = catalog().filter(|family| !matches!(family.truth, Truth::Cost { .. })).collect();
    for family in &families {
        assert!(recorded.contains_key(&family.name), "{} is not in docs/stability.csv", family.name);
    }
    let (waiting, wrong) = (Mutex::new(families.iter()), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let next = waiting.lock().unwrap().next();
                    let Some(family) = next else { break };
                    let most = recorded[&family.name];
                    let sweep = sweep(family, most);
                    if let Some(step) = sweep.first_wrong() {
                        let step = format!("{} breaks at {}: {:?}", family.name, family.shown(step.x), step.error);
                        wrong.lock().unwrap().push(step);
                    }
                }
            });
        }
    });
    let wrong = wrong.into_inner().unwrap();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_family_that_breaks_is_seen_to_break() {
    let text = "//! about: a sphere that fades\n//! steps: 0 to 9 by 1\n//! truth: the first step\n#version 3.7;\n\
        global_settings { assumed_gamma 1 }\ncamera { location -3*z look_at 0 }\n\
        sphere { 0, 1 pigment { rgb 1 - X * .008 } finish { ambient 1 diffuse 0 } }\n";
    let sweep = sweep(&Family::parse("fading", text).unwrap(), usize::MAX);
    // Visible from the third step on, and two steps in a row that are wrong are enough.
    assert_eq!((sweep.n_right, sweep.steps.len()), (3, 5));
    assert!(sweep.first_wrong().unwrap().error.as_ref().is_ok_and(|error| *error > 0.05), "{sweep:?}");
}
