//! All figures, a rung a row.

use crate::measure::number::{count, figure, seconds, spread};
use crate::report::bench::{Bench, Climb, Figures};
use crate::report::ladder::Against;
use crate::report::rays::Rays;
use maud::{Markup, html};

/// Columns behind the rung's name.
const N_COLUMNS: usize = 11;

/// One table, ladder after ladder.
pub(super) fn tables(bench: &Bench) -> Markup {
    let fronts = bench.fronts();
    let is_on_front = |l: usize, r: usize| fronts.iter().any(|(_, places)| places.contains(&(l, r)));
    html! {
        h3 { "Figures" }
        p.hint { "★: on its program's Pareto front. Times: least of the runs, and by how much the greatest is above it." }
        div.scroll tabindex="0" role="region" aria-label="Table of all rungs" { table.figures {
            thead { tr {
                th scope="col" { "rung" }
                @for name in ["RMSE", "relative", "FLIP", "worst pixel", "estimated", "CPU", "wall"] { th.number scope="col" { (name) } }
                @for name in ["camera rays", "mirrored", "transmitted", "shadow"] { th.number scope="col" { (name) } }
            } }
            @for (l, climb) in bench.climbs.iter().enumerate() { tbody {
                tr.group { th colspan=(N_COLUMNS + 1) scope="rowgroup" { (heading(climb)) } }
                @for (r, (rung, result)) in climb.ladder.rungs.iter().zip(&climb.results).enumerate() {
                    tr.front[is_on_front(l, r)] {
                        th scope="row" {
                            (rung.label)
                            @if rung.is_scenes_own { " (the scene's)" }
                            @if is_on_front(l, r) { " " span title="on its program's Pareto front" { "★" } }
                        }
                        (row(result))
                    }
                }
            } }
        } }
    }
}

fn heading(climb: &Climb) -> Markup {
    let ladder = &climb.ladder;
    html! {
        (ladder.program.name()) ", " (ladder.name)
        @if let Against::Finest(finest) = &ladder.against { ", against " (finest.label) " with one sample a pixel" }
        @if climb.results.iter().flatten().any(|f| f.rays.is_some()) {
            span.aside { " last column: " (Rays::shadow_name(ladder.program)) }
        }
    }
}

fn row(result: &Result<Figures, String>) -> Markup {
    let figures = match result {
        Ok(figures) => figures,
        Err(why) => return html! { td.failed colspan=(N_COLUMNS) { "no figures: " (why) } },
    };
    let difference = &figures.difference;
    let worst = difference.worst;
    let errors = [
        figure(difference.rmse),
        figure(difference.relative_rmse),
        figure(difference.flip),
        format!("{} at {}, {}", figure(worst.error), worst.x, worst.y),
        figures.estimate.map_or("–".into(), figure),
    ];
    let rays = figures.rays.map(|rays| [rays.camera, rays.reflected, rays.transmitted, rays.shadow]);
    html! {
        @for error in errors { td.number { (error) } }
        @for time in [figures.cpu(), figures.wall()] {
            td.number { (seconds(time.min)) " " span.aside { (spread(time.min, time.max)) } }
        }
        @match rays {
            Some(rays) => { @for n in rays { td.number { (count(n)) } } },
            None => td.number colspan="4" { "–" },
        }
    }
}
