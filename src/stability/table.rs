//! What was found, as text, for people and for programs.

use super::family::{Family, Truth};
use super::sweep::{Step, Sweep};
use super::{Findings, VISIBLE};
use crate::measure::Program;
use crate::measure::number::figure;
use serde_json::{Value, json};
use std::fmt::Write;

/// Who goes further.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// Nobody else was asked, and there is no end to it.
    ToTheEnd,
    /// Nobody else was asked, and it breaks.
    Breaks,
    /// We go further than POV-Ray.
    Further,
    /// Both go to the end.
    BothToTheEnd,
    /// Both break at the same step.
    Equal,
    /// POV-Ray goes further.
    Behind,
}

impl Verdict {
    pub(super) fn of(family: &Family, sweeps: &[Sweep]) -> Self {
        let all = family.steps.len();
        match sweeps {
            [ours] if ours.n_right == all => Self::ToTheEnd,
            [ours, theirs, ..] if ours.n_right == theirs.n_right => {
                if ours.n_right == all {
                    Self::BothToTheEnd
                } else {
                    Self::Equal
                }
            }
            [ours, theirs, ..] if ours.n_right > theirs.n_right => Self::Further,
            [_, _, ..] => Self::Behind,
            _ => Self::Breaks,
        }
    }

    pub(super) fn words(self) -> &'static str {
        match self {
            Self::ToTheEnd => "to the end",
            Self::Breaks => "breaks",
            Self::Further => "further",
            Self::BothToTheEnd => "both to the end",
            Self::Equal => "both break",
            Self::Behind => "**POV-Ray further**",
        }
    }
}

/// What stands in the table for a sweep: how far it is right, and what comes then.
pub(super) fn reach(family: &Family, sweep: &Sweep) -> String {
    let cost = |step: &Step| match (family.truth, &step.run) {
        (Truth::Cost { .. }, Some(run)) => {
            format!(" ({} s, {} MB)", figure(run.cpu.as_secs_f64()), figure(run.memory as f64 / 1e6))
        }
        _ => String::new(),
    };
    let right = sweep.last_right().map_or("never".into(), |step| format!("{}{}", family.shown(step.x), cost(step)));
    match sweep.first_wrong() {
        None => format!("{right}, the end"),
        Some(step) => format!("{right}; {}: {}", family.shown(step.x), failure(family, step)),
    }
}

/// What is wrong with a step, in few words.
fn failure(family: &Family, step: &Step) -> String {
    match &step.error {
        Err(why) => why.chars().take(70).collect(),
        Ok(error) => match family.truth {
            Truth::First | Truth::FirstBits | Truth::Partner => format!("{} % off", figure(100.0 * error)),
            Truth::Found => format!("error {}", figure(*error)),
            Truth::Cost { .. } => format!("n^{} too steep", figure(*error)),
        },
    }
}

/// The greatest error of the steps that are right.
pub(super) fn worst_right(sweep: &Sweep) -> f64 {
    sweep.steps[..sweep.n_right].iter().filter_map(|step| step.error.as_ref().ok()).copied().fold(0.0, f64::max)
}

const HEADS: [&str; 4] = ["family", "what grows", "whitted is right to", "error there"];

fn rows(findings: &Findings) -> Vec<Vec<String>> {
    let row = |(family, sweeps): (&Family, &Vec<Sweep>)| {
        let mut row = vec![family.name.clone(), family.about.clone(), reach(family, &sweeps[0])];
        row.push(figure(worst_right(&sweeps[0])));
        row.extend(sweeps.get(1).map(|sweep| reach(family, sweep)));
        row.push(Verdict::of(family, sweeps).words().into());
        row
    };
    findings.plan.families.iter().zip(&findings.sweeps).map(row).collect()
}

fn heads(findings: &Findings) -> Vec<&'static str> {
    let rival = findings.programs.get(1).map(|_| "POV-Ray is right to");
    HEADS.into_iter().chain(rival).chain(["verdict"]).collect()
}

/// As wide as most windows can be made.
const COLUMNS_OF_TEXT: u16 = 160;

/// Columns side by side.
pub(super) fn text(findings: &Findings) -> String {
    let mut table = comfy_table::Table::new();
    table.load_preset(comfy_table::presets::UTF8_HORIZONTAL_ONLY);
    table.set_content_arrangement(comfy_table::ContentArrangement::Dynamic).set_width(COLUMNS_OF_TEXT);
    table.set_header(heads(findings)).add_rows(rows(findings));
    format!("{table}\n")
}

/// A document with the table.
pub(super) fn markdown(findings: &Findings) -> String {
    let mut text = String::from("# How far scenes can be driven\n\n");
    let [made, command] = &findings.plan.origin;
    let _ = writeln!(text, "Made by `{command}`, {made}, with {}.\n", findings.programs.join(" and "));
    let _ = writeln!(text, "{}\n", reading());
    let line = |cells: &mut dyn Iterator<Item = String>| format!("| {} |\n", cells.collect::<Vec<_>>().join(" | "));
    let heads = heads(findings);
    text += &line(&mut heads.iter().map(|head| head.to_string()));
    text += &line(&mut heads.iter().map(|_| "---".to_string()));
    for row in rows(findings) {
        text += &line(&mut row.iter().map(|cell| cell.replace('|', "\\|")));
    }
    let notes: Vec<_> = findings.plan.families.iter().filter_map(|f| Some((&f.name, f.note.as_ref()?))).collect();
    if !notes.is_empty() {
        text += "\n## Notes\n\n";
        for (name, note) in notes {
            let _ = writeln!(text, "- **{name}**: {note}");
        }
    }
    text + OWN_FAMILY
}

/// How to add to the table.
const OWN_FAMILY: &str = r#"
## A family of one's own

A family is a scene file with a head; `X` is declared by whoever renders it, the same for both programs. `whitted stability
my-family.pov --against povray -o out` sweeps it; a file in `src/stability/families` belongs to the catalogue once its name
stands in `catalog.rs`.

```text
//! about: a sphere 10^X away
//! extremity: 10^X
//! steps: 0 to 12 by 1
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 angle 60 / pow(10, X) }
light_source { <5, 9, -7> * pow(10, X), 1 }
sphere { pow(10, X) * z, 1 pigment { rgb 1 } }
```

Other truths: `the first step to the last bit`; `the picture with Right declared` (of the same step); `what it finds`, greatest
of the errors that the scene writes by `#debug concat("found ", str(Error, 0, 20), "\n")`; `time n^1 memory n^1`, for costs.
`//! tolerance:` changes what counts as right, `//! note:` stands below the table.
"#;

/// How the table is to be read.
pub(super) fn reading() -> String {
    format!(
        "Each family is one scene that grows more extreme step by step. A step is right when its picture is, but for few \
         pixels, the one that the same program makes of the same scene at ordinary size (a pixel is off when a channel \
         differs by more than {VISIBLE}), or when what the scene works out agrees with a closed form; of families of cost, \
         when time and memory grow with no greater power of the number of things than they should. The table tells the \
         last step up to which all are right, and what the next one shows."
    )
}

/// What the columns of both are called.
const COLUMNS: [&str; 10] =
    ["family", "program", "step", "extremity", "error", "tolerance", "is_right", "cpu_s", "memory_bytes", "failure"];

fn values(family: &Family, sweep: &Sweep, step: &Step) -> [Value; COLUMNS.len()] {
    let error = step.error.as_ref().ok();
    [
        json!(family.name),
        json!(sweep.program.name()),
        json!(step.x),
        json!(family.shown(step.x)),
        json!(error),
        json!(family.tolerance),
        json!(error.is_some_and(|error| *error <= family.tolerance)),
        json!(step.run.map(|run| run.cpu.as_secs_f64())),
        json!(step.run.map(|run| run.memory)),
        json!(step.error.as_ref().err()),
    ]
}

fn all_values(findings: &Findings) -> Vec<[Value; COLUMNS.len()]> {
    let mut all = Vec::new();
    for (family, sweeps) in findings.plan.families.iter().zip(&findings.sweeps) {
        for sweep in sweeps {
            all.extend(sweep.steps.iter().map(|step| values(family, sweep, step)));
        }
    }
    all
}

/// A header and a line for each step of each program.
pub(super) fn csv(findings: &Findings) -> String {
    let cell = |value: &Value| match value {
        Value::Null => String::new(),
        Value::String(text) if text.contains([',', '"', '\n']) => format!("\"{}\"", text.replace('"', "\"\"")),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    let line = |values: &[Value; COLUMNS.len()]| values.iter().map(cell).collect::<Vec<_>>().join(",");
    let lines: Vec<String> = std::iter::once(COLUMNS.join(",")).chain(all_values(findings).iter().map(line)).collect();
    lines.join("\n") + "\n"
}

/// The same, with the machine and the verdicts.
pub(super) fn json(findings: &Findings) -> String {
    let step =
        |values: [Value; COLUMNS.len()]| -> Value { COLUMNS.map(String::from).into_iter().zip(values).collect() };
    let family = |(family, sweeps): (&Family, &Vec<Sweep>)| {
        let last = |program: Program| {
            let sweep = sweeps.iter().find(|sweep| sweep.program == program)?;
            sweep.last_right().map(|step| family.shown(step.x))
        };
        json!({
            "family": family.name,
            "about": family.about,
            "whitted_right_to": last(Program::Whitted),
            "povray_right_to": last(Program::PovRay),
            "verdict": Verdict::of(family, sweeps).words().trim_matches('*'),
        })
    };
    let machine = &findings.machine;
    let value = json!({
        "made": findings.plan.origin[0],
        "command": findings.plan.origin[1],
        "programs": findings.programs,
        "machine": { "processor": machine.processor, "cores": machine.cores, "system": machine.system },
        "families": findings.plan.families.iter().zip(&findings.sweeps).map(family).collect::<Vec<_>>(),
        "steps": all_values(findings).into_iter().map(step).collect::<Vec<_>>(),
    });
    format!("{value:#}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sweep(program: Program, n_right: usize) -> Sweep {
        let step = |k: usize| Step { x: k as f64, error: Ok(if k < n_right { 0.0 } else { 0.5 }), run: None };
        Sweep { program, steps: (0..3).map(step).collect(), n_right }
    }

    #[test]
    fn verdicts_go_by_the_first_wrong_step() {
        let text = "//! about: a\n//! extremity: 10^X\n//! steps: 0 1 2\n//! truth: the first step\n";
        let family = Family::parse("a", text).unwrap();
        let verdict =
            |ours, theirs| Verdict::of(&family, &[sweep(Program::Whitted, ours), sweep(Program::PovRay, theirs)]);
        assert_eq!(verdict(3, 3), Verdict::BothToTheEnd);
        assert_eq!(verdict(2, 2), Verdict::Equal);
        assert_eq!((verdict(2, 1), verdict(1, 2)), (Verdict::Further, Verdict::Behind));
        assert_eq!(Verdict::of(&family, &[sweep(Program::Whitted, 3)]), Verdict::ToTheEnd);
        assert_eq!(reach(&family, &sweep(Program::Whitted, 2)), "10^1; 10^2: 50.0 % off");
        assert_eq!(reach(&family, &sweep(Program::Whitted, 3)), "10^2, the end");
    }
}
