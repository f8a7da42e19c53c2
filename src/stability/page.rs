//! The page: the table, and of each family a plot of error against extremity.

use super::family::{Family, Truth};
use super::sweep::Sweep;
use super::table::{Verdict, reach, reading};
use super::{Findings, Step};
use crate::measure::plot::{Mark, Plot, Series, key};
use crate::measure::{Program, STYLE};
use maud::{DOCTYPE, PreEscaped, html};

/// Errors below this are drawn there: a logarithmic axis has no zero.
const NO_ERROR: f64 = 1e-7;

/// The whole document.
pub(super) fn html(findings: &Findings) -> String {
    let families = || findings.plan.families.iter().zip(&findings.sweeps);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { "How far scenes can be driven" }
                link rel="icon" href="data:,";
                style { (PreEscaped(STYLE)) }
            }
            body {
                header {
                    h1 { "How far scenes can be driven" }
                    p.lead { "Stiff and extreme scenes, by " (findings.programs.join(" and ")) "." }
                    p { (reading()) }
                    p.path { (findings.plan.origin[0]) ", " code { (findings.plan.origin[1]) } }
                }
                main {
                    div.scroll { table {
                        thead { tr {
                            th scope="col" { "family" }
                            @for program in [Program::Whitted, Program::PovRay].iter().take(findings.programs.len()) {
                                th scope="col" { (program.name()) " is right to" }
                            }
                            th scope="col" { "verdict" }
                        } }
                        tbody { @for (family, sweeps) in families() { tr {
                            th scope="row" { a href=(format!("#{}", family.name)) { (family.name) } }
                            @for sweep in sweeps { td { (reach(family, sweep)) } }
                            td { (Verdict::of(family, sweeps).words().trim_matches('*')) }
                        } } }
                    } }
                    div.plots { @for (family, sweeps) in families() {
                        figure id=(family.name) {
                            figcaption { (family.name) }
                            p.hint { (family.about) }
                            (plot(family, sweeps).svg())
                            ul.legend { @for sweep in sweeps { li { (key(look(sweep.program))) (sweep.program.name()) } } }
                            @if let Some(note) = &family.note { p.hint { (note) } }
                        }
                    } }
                }
            }
        }
    };
    page.into_string()
}

fn look(program: Program) -> usize {
    if program == Program::PovRay { 5 } else { 1 }
}

fn plot(family: &Family, sweeps: &[Sweep]) -> Plot {
    let is_cost = matches!(family.truth, Truth::Cost { .. });
    let y_label = match family.truth {
        Truth::First | Truth::FirstBits | Truth::Partner => "share of pixels that are off",
        Truth::Found => "error",
        Truth::Cost { .. } => "CPU time (s)",
    };
    let y = |step: &Step| match &step.error {
        _ if is_cost => step.run.map(|run| run.cpu.as_secs_f64()),
        Ok(error) => Some(error.max(NO_ERROR)),
        Err(_) => None,
    };
    let mark = |step: &Step| {
        let x = family.size(step.x);
        let tip = format!("{}: {:?}", family.shown(step.x), step.error);
        let mark = Mark { x, y: y(step)?, tip, label: None, is_full: true, spread: None };
        (x > 0.0 && x.is_finite() && mark.y.is_finite()).then_some(mark)
    };
    let series = |sweep: &Sweep| Series {
        name: sweep.program.name().into(),
        look: look(sweep.program),
        points: sweep.steps.iter().filter_map(mark).collect(),
    };
    let tolerance = (!is_cost && family.tolerance > NO_ERROR).then(|| ("tolerance".to_owned(), family.tolerance));
    Plot {
        title: format!("{}: {}", family.name, family.about),
        x_label: "extremity".into(),
        y_label: y_label.into(),
        series: sweeps.iter().map(series).collect(),
        bands: Vec::new(),
        levels: tolerance.into_iter().collect(),
        has_diagonal: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{Caller, Machine};
    use crate::stability::Plan;
    use std::time::Duration;

    #[test]
    fn every_family_has_its_row_and_its_plot() {
        let text =
            "//! about: a < b\n//! extremity: 10^X\n//! steps: 0 1 2\n//! truth: the first step\n//! note: as it is\n";
        let family = Family::parse("far", text).unwrap();
        let step = |x: f64, error| Step { x, error, run: None };
        let steps = [step(0.0, Ok(0.0)), step(1.0, Ok(0.3)), step(2.0, Err("no picture".into()))].to_vec();
        let sweep = |program| Sweep { program, steps: steps.clone(), n_right: 1 };
        let findings = Findings {
            plan: Plan {
                families: vec![family],
                whitted: Caller { program: "whitted".into(), arguments: Vec::new() },
                povray: None,
                limit: Duration::from_secs(1),
                origin: ["today".into(), "whitted stability".into()],
            },
            programs: vec!["whitted 0".into(), "POV-Ray 3.7".into()],
            machine: Machine { processor: "abacus".into(), cores: 1, system: "none".into(), load: None },
            sweeps: vec![vec![sweep(Program::Whitted), sweep(Program::PovRay)]],
        };
        let page = html(&findings);
        assert!(page.contains("href=\"#far\"") && page.contains("id=\"far\"") && page.contains("a &lt; b"));
        // A mark for each picture of both programs; what has none is told by the table alone.
        assert_eq!(page.matches("class=\"mark\" transform").count(), 4);
        assert!(page.contains("10^1: 30.0 % off") && page.contains("both break") && !page.contains("NaN"));
    }
}
