//! The figures for other programs: CSV and JSON, a rung a row.

use super::bench::{Bench, Climb, Figures};
use super::ladder::{Against, Rung};
use super::{Report, front};
use serde_json::{Value, json};

/// A rung with all that belongs to it.
struct Row<'r> {
    bench: &'r Bench,
    climb: &'r Climb,
    rung: &'r Rung,
    result: &'r Result<Figures, String>,
    is_on_front: bool,
}

fn rows(report: &Report) -> Vec<Row<'_>> {
    let mut rows = Vec::new();
    for bench in &report.benches {
        let fronts = bench.fronts();
        for (l, climb) in bench.climbs.iter().enumerate() {
            for (r, (rung, result)) in climb.ladder.rungs.iter().zip(&climb.results).enumerate() {
                let is_on_front = fronts.iter().any(|(_, points)| points.contains(&(l, r)));
                rows.push(Row { bench, climb, rung, result, is_on_front });
            }
        }
    }
    rows
}

/// What the columns of both are called.
const COLUMNS: [&str; 27] = [
    "scene",
    "program",
    "ladder",
    "rung",
    "error_against",
    "target_rmse",
    "estimated_rmse",
    "rmse",
    "relative_rmse",
    "flip",
    "worst_pixel_error",
    "worst_pixel_x",
    "worst_pixel_y",
    "cpu_min_s",
    "cpu_max_s",
    "wall_min_s",
    "wall_max_s",
    "runs",
    "camera_rays",
    "transmitted_rays",
    "reflected_rays",
    "shadow_rays",
    "is_scenes_own",
    "on_pareto_front",
    "reference_rmse",
    "arguments",
    "failure",
];

impl Row<'_> {
    /// In the order of [`COLUMNS`]; null where there is nothing.
    fn values(&self) -> [Value; COLUMNS.len()] {
        let figures = self.result.as_ref().ok();
        let number = |of: fn(&Figures) -> f64| figures.map(of).map_or(Value::Null, Value::from);
        let count = |of: fn(&super::Rays) -> u64| {
            figures.and_then(|f| f.rays.as_ref()).map(of).map_or(Value::Null, Value::from)
        };
        let against = match &self.climb.ladder.against {
            Against::Reference => "reference".to_owned(),
            Against::Finest(finest) => format!("{} {}", self.climb.ladder.name, finest.label),
        };
        let reference = self.bench.reference.as_ref().ok();
        [
            json!(self.bench.scene),
            json!(self.climb.ladder.program.name()),
            json!(self.climb.ladder.name),
            json!(self.rung.label),
            json!(against),
            json!(self.rung.target),
            json!(figures.and_then(|f| f.estimate)),
            number(|f| f.difference.rmse),
            number(|f| f.difference.relative_rmse),
            number(|f| f.difference.flip),
            number(|f| f.difference.worst.error),
            figures.map_or(Value::Null, |f| json!(f.difference.worst.x)),
            figures.map_or(Value::Null, |f| json!(f.difference.worst.y)),
            number(|f| f.cpu().min),
            number(|f| f.cpu().max),
            number(|f| f.wall().min),
            number(|f| f.wall().max),
            figures.map_or(Value::Null, |f| json!(f.runs.len())),
            count(|rays| rays.camera),
            count(|rays| rays.transmitted),
            count(|rays| rays.reflected),
            count(|rays| rays.shadow),
            json!(self.rung.is_scenes_own),
            json!(self.is_on_front),
            json!(reference.and_then(|r| r.error)),
            json!(self.rung.arguments.join(" ")),
            json!(self.result.as_ref().err()),
        ]
    }
}

/// A header and a line for each rung; scenes without a reference have none.
pub(super) fn csv(report: &Report) -> String {
    let cell = |value: &Value| match value {
        Value::Null => String::new(),
        Value::String(text) if text.contains([',', '"', '\n']) => format!("\"{}\"", text.replace('"', "\"\"")),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    let line = |row: &Row<'_>| row.values().iter().map(cell).collect::<Vec<_>>().join(",");
    let lines: Vec<String> = std::iter::once(COLUMNS.join(",")).chain(rows(report).iter().map(line)).collect();
    lines.join("\n") + "\n"
}

/// The same, with what it was measured on and what failed as a whole.
pub(super) fn json(report: &Report) -> String {
    let object = |row: &Row<'_>| -> Value { COLUMNS.iter().map(|c| c.to_string()).zip(row.values()).collect() };
    let scene = |bench: &Bench| {
        let reference = bench.reference.as_ref();
        json!({
            "scene": bench.scene,
            "reference": reference.ok().map(|r| json!({"origin": r.origin, "rmse": r.error})),
            "failure": reference.err(),
            "rmse_between_programs": bench.apart,
            "times_faster_at_equal_error": front::geometric_mean(&bench.ratios()),
            "times_faster_at_the_error_of_povrays_finest": bench.ratio_at_finest(),
        })
    };
    let (plan, machine) = (&report.plan, &report.machine);
    let value = json!({
        "made": plan.origin[0],
        "command": plan.origin[1],
        "programs": report.programs,
        "machine": {
            "processor": machine.processor,
            "cores": machine.cores,
            "system": machine.system,
            "load_at_start": machine.load,
        },
        "width": plan.size[0],
        "height": plan.size[1],
        "threads": plan.threads,
        "error_space": super::ERROR_SPACE,
        "scenes": report.benches.iter().map(scene).collect::<Vec<_>>(),
        "rungs": rows(report).iter().map(object).collect::<Vec<_>>(),
    });
    format!("{value:#}\n")
}
