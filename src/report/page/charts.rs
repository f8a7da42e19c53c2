//! What the plots of a scene show.

use crate::measure::Program;
use crate::measure::number::{figure, seconds, spread};
use crate::measure::plot::{Mark, Plot, Series, key};
use crate::report::bench::{Bench, Climb, Figures, ShownReference};
use crate::report::front::{Point, front};
use crate::report::ladder::{Against, Ladder};
use maud::{Markup, html};

const ERROR: &str = "RMSE (linear light)";
const CPU: &str = "CPU time (s)";

/// Error against time, and against rays beside it.
pub(super) fn work_precision(bench: &Bench, reference: &ShownReference) -> Markup {
    let cpu = |figures: &Figures| Some(figures.cpu().min);
    let rays = |figures: &Figures| figures.rays.map(|rays| rays.followed() as f64);
    let levels: Vec<(String, f64)> =
        reference.error.map(|error| ("reference's own error".into(), error)).into_iter().collect();
    let plot = |title: &str, x_label: &str, cost: &dyn Fn(&Figures) -> Option<f64>, with_spread: bool| Plot {
        title: format!("{title} of {}: figures stand in the tables below", bench.name()),
        x_label: x_label.into(),
        y_label: ERROR.into(),
        series: bench.climbs_against_reference(true).map(|(_, climb)| series(climb, cost, with_spread)).collect(),
        bands: bands(bench, cost),
        levels: levels.clone(),
        has_diagonal: false,
    };
    html! {
        h3 { "Work and precision" }
        div.plots {
            figure { figcaption { "Error against CPU time" } (plot("Error against CPU time", CPU, &cpu, true).svg()) }
            figure { figcaption { "Error against rays" } (plot("Error against rays", "camera, mirrored and transmitted rays", &rays, false).svg()) }
        }
        (legend(bench))
    }
}

fn legend(bench: &Bench) -> Markup {
    html! {
        ul.legend {
            @for (_, climb) in bench.climbs_against_reference(true) {
                li { (key(look(&climb.ladder))) (climb.ladder.program.name()) ", " (climb.ladder.name) }
            }
            @for (program, _) in bench.fronts() {
                li { span class=(format!("swatch {}", band_class(program))) {} "Pareto front, " (program.name()) }
            }
        }
    }
}

/// The same method has the same shape whoever uses it; whose it is, the colour says.
fn look(ladder: &Ladder) -> usize {
    let method = match ladder.name.as_str() {
        "method 1" => 1,
        "method 2" => 2,
        "no antialiasing" => 3,
        _ => 0,
    };
    method + if ladder.program == Program::PovRay { 4 } else { 0 }
}

fn band_class(program: Program) -> &'static str {
    match program {
        Program::Whitted => "ours",
        Program::PovRay => "theirs",
    }
}

type Cost<'c> = &'c dyn Fn(&Figures) -> Option<f64>;

fn series(climb: &Climb, cost: Cost<'_>, with_spread: bool) -> Series {
    let ladder = &climb.ladder;
    let of = |result: &Result<Figures, String>| result.as_ref().ok().and_then(|f| Some((f.clone(), cost(f)?)));
    let rungs: Vec<_> = ladder.rungs.iter().zip(&climb.results).filter_map(|(rung, r)| Some((rung, of(r)?))).collect();
    let points: Vec<Point> =
        rungs.iter().map(|(_, (f, cost))| Point { cost: *cost, error: f.difference.rmse }).collect();
    let on_front = front(&points);
    let mark = |i: usize| {
        let (rung, (figures, cost)) = &rungs[i];
        Mark {
            x: *cost,
            y: figures.difference.rmse,
            tip: format!("{}, {}, {}\n{}", ladder.program.name(), ladder.name, rung.label, tip(figures)),
            label: None,
            is_full: on_front.contains(&i),
            spread: with_spread.then(|| [figures.cpu().min, figures.cpu().max]),
        }
    };
    // The line runs along the front; what is beaten stands beside it.
    let beaten = (0..points.len()).filter(|i| !on_front.contains(i));
    let points = on_front.iter().copied().chain(beaten).filter(|&i| drawable(points[i].error)).map(mark).collect();
    Series { name: ladder.name.clone(), look: look(ladder), points }
}

/// Whether an error has a place on a logarithmic axis.
fn drawable(error: f64) -> bool {
    error.is_finite() && error > 0.0
}

fn tip(figures: &Figures) -> String {
    let (cpu, difference) = (figures.cpu(), &figures.difference);
    format!(
        "RMSE {}, FLIP {}\nCPU {} ({})",
        figure(difference.rmse),
        figure(difference.flip),
        seconds(cpu.min),
        spread(cpu.min, cpu.max)
    )
}

fn bands(bench: &Bench, cost: Cost<'_>) -> Vec<(String, Vec<[f64; 2]>)> {
    let band = |program: Program| {
        let rungs = bench.rungs_of(program);
        let priced = rungs.iter().filter_map(|(_, f)| Some(Point { cost: cost(f)?, error: f.difference.rmse }));
        let points: Vec<Point> = priced.filter(|point| drawable(point.error)).collect();
        let places = front(&points).into_iter().map(|i| [points[i].cost, points[i].error]).collect();
        (band_class(program).to_owned(), places)
    };
    [Program::PovRay, Program::Whitted].map(band).into()
}

/// What was asked for against what came of it, and what the program itself thought of it.
pub(super) fn targets(bench: &Bench) -> Markup {
    let mut achieved = Vec::new();
    let mut estimated = Vec::new();
    for climb in &bench.climbs {
        for (rung, result) in climb.ladder.rungs.iter().zip(&climb.results) {
            let (Some(target), Ok(figures)) = (rung.target, result) else { continue };
            let mark = |y: f64, what: &str| Mark {
                x: target,
                y,
                tip: format!("target {}\n{what} {}", figure(target), figure(y)),
                label: None,
                is_full: true,
                spread: None,
            };
            achieved.push(mark(figures.difference.rmse, "achieved"));
            estimated.extend(figures.estimate.map(|estimate| mark(estimate, "estimated")));
        }
    }
    let series = |name: &str, look, points| Series { name: name.into(), look, points };
    let series = vec![series("achieved", 0, achieved), series("estimated", 2, estimated)];
    html! {
        @if series.iter().any(|series| !series.points.is_empty()) {
            h3 { "Target and error" }
            div.plots { figure {
                figcaption { "Achieved and estimated error against what was asked for" }
                (Plot {
                    title: "Achieved error against target: on the line is as asked, below is better than asked".into(),
                    x_label: "target RMSE".into(),
                    y_label: ERROR.into(),
                    series: series.clone(),
                    bands: Vec::new(),
                    levels: Vec::new(),
                    has_diagonal: true,
                }.svg())
            } }
            ul.legend {
                @for series in &series { li { (key(series.look)) (series.name) } }
                li { "lines: equal, half and double" }
            }
        }
    }
}

/// Each limit by itself.
pub(super) fn limits(bench: &Bench) -> Markup {
    let climbs: Vec<&Climb> = bench.climbs_against_reference(false).map(|(_, climb)| climb).collect();
    html! {
        @if !climbs.is_empty() {
            h3 { "What sampling cannot see" }
            p { "Each limit by itself: the error against the same picture with the limit at its finest. The scene's own choice is marked." }
            div.plots { @for climb in climbs { (limit(climb)) } }
        }
    }
}

fn limit(climb: &Climb) -> Markup {
    let ladder = &climb.ladder;
    let finest = if let Against::Finest(finest) = &ladder.against { finest } else { return html! {} };
    let mut exact = Vec::new();
    let mut points = Vec::new();
    for (rung, result) in ladder.rungs.iter().zip(&climb.results) {
        let Ok(figures) = result else { continue };
        if !drawable(figures.difference.rmse) {
            exact.push(rung.label.as_str());
            continue;
        }
        let own = if rung.is_scenes_own { " (the scene's)" } else { "" };
        points.push(Mark {
            x: figures.cpu().min,
            y: figures.difference.rmse,
            tip: format!("{} {}{own}\n{}", ladder.name, rung.label, tip(figures)),
            label: Some(format!("{}{own}", rung.label)),
            is_full: true,
            spread: None,
        });
    }
    let plot = Plot {
        title: format!("Error of {} against CPU time", ladder.name),
        x_label: CPU.into(),
        y_label: ERROR.into(),
        series: vec![Series { name: ladder.name.clone(), look: 2, points }],
        bands: Vec::new(),
        levels: Vec::new(),
        has_diagonal: false,
    };
    html! {
        figure {
            figcaption { code { (ladder.name) } " against " (finest.label) }
            @if plot.series[0].points.is_empty() { p.empty { "There is no rung with an error." } } @else { (plot.svg()) }
            @if !exact.is_empty() { p.exact { "No difference at all: " (exact.join(", ")) } }
        }
    }
}
