//! The page: one file that needs no other, with its style, its script and its pictures inside.

mod charts;
mod tables;
mod viewer;

use super::bench::{Bench, ShownReference};
use super::front::geometric_mean;
use super::ladder::Against;
use super::{ERROR_SPACE, Report};
use crate::measure::number::{figure, seconds};
use crate::measure::{Program, STYLE};
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// The whole document.
pub(super) fn html(report: &Report) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { "Error against run time" }
                link rel="icon" href="data:,";
                style { (PreEscaped(STYLE)) }
            }
            body {
                header {
                    h1 { "Error against run time" }
                    p.lead { (lead(report)) }
                    (facts(report))
                }
                main {
                    @if report.benches.len() > 1 { (overview(report)) }
                    @for (i, bench) in report.benches.iter().enumerate() { (scene(i, bench)) }
                    (reading())
                }
                script { (PreEscaped(include_str!("script.js"))) }
            }
        }
    };
    page.into_string()
}

fn lead(report: &Report) -> String {
    let programs = report.programs.join(" and ");
    let n = report.benches.len();
    let scenes = if n == 1 { report.benches[0].name() } else { format!("{n} scenes") };
    format!("How wrong the pictures of {scenes} are, and what they cost, by {programs}.")
}

fn facts(report: &Report) -> Markup {
    let (plan, machine) = (&report.plan, &report.machine);
    let [width, height] = plan.size;
    let load = machine.load.map_or(String::new(), |load| format!(", load {load} at the start"));
    let facts = [
        ("Programs", report.programs.join(", ")),
        ("Machine", format!("{}, {} cores, {}{load}", machine.processor, machine.cores, machine.system)),
        ("Pictures", format!("{width} × {height} pixels")),
        (
            "Runs",
            format!("of each rung {}, in turn, each a process of its own; worker threads: {}", plan.runs, plan.threads),
        ),
        ("Made", plan.origin[0].clone()),
        ("Command", plan.origin[1].clone()),
    ];
    html! {
        details.facts {
            summary { "How it was measured" }
            dl {
                @for (name, value) in facts { dt { (name) } dd { (value) } }
                dt { "Error" } dd { "RMSE: " (ERROR_SPACE) ", as " code { "whitted compare" } " prints it." }
            }
        }
    }
}

/// All scenes at a glance.
fn overview(report: &Report) -> Markup {
    let ratios: Vec<f64> = report.benches.iter().filter_map(Bench::ratio_at_finest).collect();
    html! {
        section.overview {
            h2 { "All scenes" }
            @if let Some(mean) = geometric_mean(&ratios) {
                p {
                    "At the error of POV-Ray's finest rung, POV-Ray takes "
                    strong { (figure(mean)) " times" } " as much CPU time as whitted (geometric mean over "
                    (ratios.len()) " of " (report.benches.len()) " scenes, those where whitted reaches that error)."
                }
            }
            div.scroll { table {
                thead { tr {
                    th scope="col" { "scene" }
                    @for program in ["whitted", "POV-Ray"] {
                        th.number scope="col" { (program) ", finest rung: RMSE" } th.number scope="col" { "CPU time" }
                    }
                    th.number scope="col" { "times faster at equal error" }
                } }
                tbody { @for (i, bench) in report.benches.iter().enumerate() { tr {
                    th scope="row" { a href=(format!("#scene-{i}")) { (bench.name()) } }
                    @for program in [Program::Whitted, Program::PovRay] {
                        @if let Some((rmse, cpu)) = bench.finest(program) {
                            td.number { (figure(rmse)) } td.number { (seconds(cpu)) }
                        } @else { td.number { "–" } td.number { "–" } }
                    }
                    td.number { (bench.ratio_at_finest().map_or("–".into(), figure)) }
                } } }
            } }
        }
    }
}

fn scene(i: usize, bench: &Bench) -> Markup {
    html! {
        section.scene id=(format!("scene-{i}")) {
            h2 { (bench.name()) }
            p.path { code { (bench.scene) } }
            @match &bench.reference {
                Err(why) => p.failed { "This scene has no figures: " (why) },
                Ok(reference) => {
                    (cards(bench, reference))
                    (gaps(bench))
                    (charts::work_precision(bench, reference))
                    (charts::targets(bench))
                    (viewer::viewer(i, bench, reference))
                    (charts::limits(bench))
                    (tables::tables(bench))
                }
            }
        }
    }
}

/// The figures that matter most.
fn cards(bench: &Bench, reference: &ShownReference) -> Markup {
    html! {
        ul.cards {
            @for program in [Program::Whitted, Program::PovRay] {
                @if let Some((rmse, cpu)) = bench.finest(program) {
                    li {
                        span.what { (program.name()) ", finest rung" }
                        strong { (figure(rmse)) }
                        span { "RMSE in " (seconds(cpu)) " of CPU time" }
                    }
                }
            }
            @if bench.finest(Program::PovRay).is_some() {
                li {
                    span.what { "At equal error" }
                    @match bench.ratio_at_finest() {
                        Some(ratio) => {
                            strong { (figure(ratio)) " ×" }
                            span { "POV-Ray's CPU time over whitted's, at the error of POV-Ray's finest rung" }
                        },
                        None => { strong { "–" } span { "no rung of whitted reaches the error of POV-Ray's finest" } },
                    }
                    @if let Some(apart) = bench.apart {
                        span { "sampling alike, the programs differ by " (figure(apart)) }
                    }
                    @if let Some(mean) = geometric_mean(&bench.ratios()) {
                        span { "over its whole front: " (figure(mean)) " ×" }
                    }
                }
            }
            li {
                span.what { "Reference" }
                strong { (reference.error.map_or("given".into(), |error| format!("± {}", figure(error)))) }
                span { @if reference.error.is_some() { "its own RMSE; errors near it say little" } @else { "its own error is not known here" } }
            }
        }
        p.origin { "The reference is " (reference.origin) "." }
    }
}

/// What has no figures, by name.
fn gaps(bench: &Bench) -> Markup {
    let mut gaps = Vec::new();
    for climb in &bench.climbs {
        for (rung, result) in climb.ladder.rungs.iter().zip(&climb.results) {
            if let Err(why) = result {
                gaps.push(format!("{}, {}, {}: {why}", climb.ladder.program.name(), climb.ladder.name, rung.label));
            }
        }
    }
    html! {
        @if !gaps.is_empty() {
            div.failed {
                p { "Rungs without figures: " (gaps.len()) }
                ul { @for gap in &gaps { li { (gap) } } }
            }
        }
    }
}

/// How to read it.
fn reading() -> Markup {
    html! {
        section.reading {
            h2 { "How to read this" }
            ul {
                li { "Lower and further left is better. A full mark is a rung that no cheaper rung of its method beats; the line of "
                    "a method joins those. The pale band is the Pareto front of each program: what it offers at best." }
                li { "Times are those of whole processes, their start and the reading of the scene included: the least of the runs; "
                    "a thin line to the right reaches to the greatest." }
                li { "Rays are camera, mirrored and transmitted rays, which both programs count alike and which do not depend on the "
                    "machine. Shadow rays stand in the table: POV-Ray counts tests of objects instead." }
                li { "POV-Ray's files are in half precision, which adds about 0.0002 of a value, and its picture differs from "
                    "whitted's in what no sampling mends: the RMSE between both programs' pictures where every pixel is sampled at "
                    "the same places (method 1, threshold 0) stands above. It is part of POV-Ray's error here, because the reference "
                    "is whitted's unless it was given." }
                li { "The slider's right side is the reference, or the error map: the largest difference of the three sRGB values "
                    "of a pixel, of 255." }
                li { "Limits cut light off without leaving noise. Their ladders are each against their own finest rung, with one "
                    "sample a pixel at the same places, so they show the limit alone." }
            }
        }
    }
}

impl Bench {
    /// The scene's name without its folder.
    fn name(&self) -> String {
        std::path::Path::new(&self.scene)
            .file_stem()
            .map_or(self.scene.clone(), |stem| stem.to_string_lossy().into_owned())
    }

    /// Error and CPU time of a program's rung with the least error.
    fn finest(&self, program: Program) -> Option<(f64, f64)> {
        let rungs = self.rungs_of(program).into_iter().map(|(_, f)| (f.difference.rmse, f.cpu().min));
        rungs.filter(|(rmse, _)| rmse.is_finite()).min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Ladders that are held against the reference, or those that are not.
    fn climbs_against_reference(&self, wanted: bool) -> impl Iterator<Item = (usize, &super::Climb)> {
        let matches = move |climb: &super::Climb| (climb.ladder.against == Against::Reference) == wanted;
        self.climbs.iter().enumerate().filter(move |(_, climb)| matches(climb))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::imaging::{Picture, compare};
    use crate::measure::Caller;
    use crate::measure::{Machine, Run};
    use crate::report::ladder::{Ladder, Rung};
    use crate::report::{Climb, Figures, Images, Plan};
    use std::time::Duration;

    fn rung(label: &str, target: Option<f64>) -> Rung {
        Rung { label: label.into(), arguments: Vec::new(), target, weight: 1.0, is_scenes_own: false }
    }

    fn figures(error: f32, cpu_ms: u64, estimate: Option<f64>) -> Figures {
        let (a, b) = (Picture::filled(4, 4, [0.5; 4]), Picture::filled(4, 4, [0.5 + error; 4]));
        let run = |ms| Run { cpu: Duration::from_millis(ms), wall: Duration::from_millis(2 * ms), memory: 0 };
        Figures {
            runs: vec![run(cpu_ms + 1), run(cpu_ms)],
            rays: None,
            difference: compare(&a, &b).unwrap(),
            estimate,
            images: Some(Images { picture: vec![1], heatmap: vec![2] }),
        }
    }

    /// Ours reaches 0.1 in 20 ms and 0.01 in 200 ms, POV-Ray 0.1 in 80 ms and nothing else.
    fn bench() -> Bench {
        let ladder =
            |name: &str, program, rungs| Ladder { name: name.into(), program, against: Against::Reference, rungs };
        let ours = ladder("target error", Program::Whitted, vec![rung("0.1", Some(0.1)), rung("0.01", Some(0.01))]);
        let theirs = ladder("method 1", Program::PovRay, vec![rung("fine", None), rung("finer", None)]);
        Bench {
            scene: "a/<ball>.pov".into(),
            reference: Ok(ShownReference { origin: "given".into(), error: Some(0.001), picture: vec![0] }),
            climbs: vec![
                Climb { ladder: ours, results: vec![Ok(figures(0.1, 20, Some(0.11))), Ok(figures(0.01, 200, None))] },
                Climb { ladder: theirs, results: vec![Ok(figures(0.1, 80, None)), Err("took too long".into())] },
            ],
            apart: None,
        }
    }

    fn report(benches: Vec<Bench>) -> Report {
        let plan = Plan {
            subjects: Vec::new(),
            size: [4, 4],
            threads: 1,
            runs: 2,
            limit: Duration::from_secs(1),
            reference: None,
            whitted: Caller { program: "whitted".into(), arguments: Vec::new() },
            povray: None,
            origin: ["now".into(), "whitted report".into()],
        };
        let machine = Machine { processor: "abacus".into(), cores: 1, system: "none".into(), load: None };
        Report { plan, programs: vec!["whitted".into()], machine, benches }
    }

    #[test]
    fn a_page_shows_what_there_is_and_names_what_there_is_not() {
        let lost = Bench { scene: "b.pov".into(), reference: Err("no light".into()), climbs: Vec::new(), apart: None };
        let page = html(&report(vec![bench(), lost]));
        // Time and rays are a plot each, targets another.
        assert_eq!(page.matches("<svg class=\"plot\"").count(), 3);
        assert!(page.contains("Target and error") && page.contains("All scenes"));
        assert!(page.contains("no figures: took too long") && page.contains("no figures: no light"));
        assert!(page.contains("&lt;ball&gt;") && !page.contains("<ball>"));
        assert_eq!(page.matches("data:image/png").count(), 1 + 2 * 3);
        assert!(!page.contains("http"), "the page asks for nothing from elsewhere");
    }

    #[test]
    fn tables_have_a_row_for_each_rung() {
        let report = report(vec![bench()]);
        let csv = crate::report::table::csv(&report);
        let lines: Vec<&str> = csv.lines().collect();
        assert_eq!(lines.len(), 1 + 4);
        assert!(lines[0].starts_with("scene,program,ladder,rung,") && lines[4].ends_with(",took too long"));
        assert!(lines.iter().all(|line| line.matches(',').count() == lines[0].matches(',').count()), "{csv}");
        let json: serde_json::Value = serde_json::from_str(&crate::report::table::json(&report)).unwrap();
        assert_eq!(json["rungs"].as_array().unwrap().len(), 4);
        assert_eq!(json["rungs"][0]["estimated_rmse"], 0.11);
        assert_eq!(json["rungs"][3]["rmse"], serde_json::Value::Null);
        let ratio = json["scenes"][0]["times_faster_at_equal_error"].as_f64().unwrap();
        assert!((ratio - 4.0).abs() < 1e-3, "{ratio}");
    }
}
