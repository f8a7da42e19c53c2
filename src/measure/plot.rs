//! Plots as SVG: two logarithmic axes, a line a series, a point a rung.
//!
//! Colours and fonts are classes of the page's style, so that a plot looks right by day and by night.

use maud::{Markup, html};

/// A picture of how two quantities hang together; both are positive.
#[derive(Clone, Debug)]
pub(crate) struct Plot {
    /// For whoever cannot see it.
    pub(crate) title: String,
    pub(crate) x_label: String,
    pub(crate) y_label: String,
    pub(crate) series: Vec<Series>,
    /// Pale wide lines below the series: class and points.
    pub(crate) bands: Vec<(String, Vec<[f64; 2]>)>,
    /// Level lines with their names.
    pub(crate) levels: Vec<(String, f64)>,
    /// Where x and y are equal, with half and double.
    pub(crate) has_diagonal: bool,
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) name: String,
    /// Its looks, one of the classes `s0` to `s7`.
    pub(crate) look: usize,
    pub(crate) points: Vec<Mark>,
}

/// A rung.
#[derive(Clone, Debug)]
pub(crate) struct Mark {
    pub(crate) x: f64,
    pub(crate) y: f64,
    /// All that is known of it, shown where the pointer rests.
    pub(crate) tip: String,
    /// A word beside it.
    pub(crate) label: Option<String>,
    /// Full marks are joined by the line; hollow ones are beaten by others.
    pub(crate) is_full: bool,
    /// Ends of a line through the mark, along x.
    pub(crate) spread: Option<[f64; 2]>,
}

const WIDTH: f64 = 520.0;
const HEIGHT: f64 = 380.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 12.0;
const BOTTOM: f64 = 52.0;

/// A logarithmic axis: from its least to its greatest value along pixels.
#[derive(Clone, Copy, Debug)]
struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    /// Holds all the values with a little room; a decade at least.
    fn around(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.filter(|value| *value > 0.0 && value.is_finite()) {
            (low, high) = (low.min(value.log10()), high.max(value.log10()));
        }
        if low > high {
            (low, high) = (0.0, 0.0);
        }
        let room = (0.06 * (high - low)).max(0.5 * (1.0 - (high - low)));
        Self { low: low - room, high: high + room, from, to }
    }

    fn at(&self, value: f64) -> f64 {
        self.from + (value.log10() - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    /// Values with a line, and whether they get a name; names stand at 1, and at 2 and 5 where there is room.
    fn ticks(&self) -> Vec<(f64, bool)> {
        let decades = self.high - self.low;
        let named: &[i32] = if decades < 2.2 { &[1, 2, 5] } else { &[1] };
        let mut ticks = Vec::new();
        for exponent in self.low.floor() as i32..=self.high.ceil() as i32 {
            // Powers between the named ones where all would crowd, and nothing else where lines would.
            let is_named = exponent % (decades / 7.0).ceil() as i32 == 0;
            let steps = if decades < 25.0 { 1..10 } else { 1..1 + i32::from(is_named) };
            for step in steps {
                let value = f64::from(step) * 10f64.powi(exponent);
                if (self.low..=self.high).contains(&value.log10()) {
                    ticks.push((value, is_named && named.contains(&step)));
                }
            }
        }
        ticks
    }
}

/// A number as an axis shows it: plain where that is short, else a power of ten.
fn tick_name(value: f64) -> String {
    let exponent = value.log10().floor() as i32;
    let step = (value / 10f64.powi(exponent)).round() as i32;
    match exponent {
        -4..=-1 => format!("{value:.*}", exponent.unsigned_abs() as usize),
        0..=4 => format!("{value:.0}"),
        _ => {
            let digits = exponent.unsigned_abs().to_string();
            let raised: String =
                digits.chars().filter_map(|c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c.to_digit(10)? as usize)).collect();
            let sign = if exponent < 0 { "⁻" } else { "" };
            let factor = if step == 1 { String::new() } else { format!("{step}·") };
            format!("{factor}10{sign}{raised}")
        }
    }
}

impl Plot {
    /// The SVG element.
    pub(crate) fn svg(&self) -> Markup {
        let marks = || self.series.iter().flat_map(|series| &series.points);
        let levels = self.levels.iter().map(|(_, y)| *y);
        let (mut xs, mut ys): (Vec<f64>, Vec<f64>) =
            (marks().map(|m| m.x).collect(), marks().map(|m| m.y).chain(levels).collect());
        if self.has_diagonal {
            let both: Vec<f64> = xs.iter().chain(&ys).copied().collect();
            (xs, ys) = (both.clone(), both);
        }
        let x = Axis::around(xs.into_iter(), LEFT, WIDTH - RIGHT);
        let y = Axis::around(ys.into_iter(), HEIGHT - BOTTOM, TOP);
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        html! {
            svg.plot viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" aria-label=(self.title) {
                @for (value, is_named) in x.ticks() {
                    @let at = px(x.at(value));
                    line.grid.minor[!is_named] x1=(at) x2=(at) y1=(px(TOP)) y2=(px(bottom)) {}
                    @if is_named { text.tick x=(at) y=(px(bottom + 17.0)) text-anchor="middle" { (tick_name(value)) } }
                }
                @for (value, is_named) in y.ticks() {
                    @let at = px(y.at(value));
                    line.grid.minor[!is_named] x1=(px(LEFT)) x2=(px(right)) y1=(at) y2=(at) {}
                    @if is_named { text.tick x=(px(LEFT - 7.0)) y=(at) dy="0.35em" text-anchor="end" { (tick_name(value)) } }
                }
                rect.frame x=(px(LEFT)) y=(px(TOP)) width=(px(right - LEFT)) height=(px(bottom - TOP)) {}
                text.axis x=(px((LEFT + right) / 2.0)) y=(px(HEIGHT - 12.0)) text-anchor="middle" { (self.x_label) }
                text.axis transform=(format!("translate(14 {}) rotate(-90)", px((TOP + bottom) / 2.0))) text-anchor="middle" {
                    (self.y_label)
                }
                @if self.has_diagonal { (diagonal(x, y)) }
                @for (name, value) in &self.levels {
                    @let at = y.at(*value);
                    line.level x1=(px(LEFT)) x2=(px(right)) y1=(px(at)) y2=(px(at)) {}
                    text.note x=(px(right - 6.0)) y=(px(at - 5.0)) text-anchor="end" { (name) }
                }
                @for (class, points) in &self.bands {
                    polyline class=(format!("band {class}")) points=(path(points.iter().copied(), x, y)) {}
                }
                @for series in &self.series { (drawn(series, x, y)) }
            }
        }
    }
}

/// Equality, and half and double of it as thinner lines.
fn diagonal(x: Axis, y: Axis) -> Markup {
    let line = |factor: f64, class: &str| {
        let (low, high) = (x.low.max(y.low - factor.log10()), x.high.min(y.high - factor.log10()));
        let ends = [low, high].map(|e| [10f64.powf(e), factor * 10f64.powf(e)]);
        html! { polyline class=(class) points=(path(ends.into_iter(), x, y)) {} }
    };
    html! { (line(1.0, "level")) (line(0.5, "level thin")) (line(2.0, "level thin")) }
}

fn drawn(series: &Series, x: Axis, y: Axis) -> Markup {
    let full = series.points.iter().filter(|mark| mark.is_full).map(|mark| [mark.x, mark.y]);
    html! {
        g class=(format!("series s{}", series.look)) {
            polyline.line points=(path(full, x, y)) {}
            @for mark in &series.points {
                @let (cx, cy) = (x.at(mark.x), y.at(mark.y));
                @if let Some([from, to]) = mark.spread {
                    line.spread x1=(px(x.at(from))) x2=(px(x.at(to).min(x.to))) y1=(px(cy)) y2=(px(cy)) {}
                }
                g.mark.hollow[!mark.is_full] transform=(format!("translate({} {})", px(cx), px(cy))) {
                    title { (mark.tip) }
                    circle.reach r="11" {}
                    (symbol(series.look))
                }
                @if let Some(label) = &mark.label { (beside(label, cx, cy, x.to)) }
            }
        }
    }
}

/// A word above and right of a mark, where a falling line leaves room; below and left of it near the right border.
fn beside(label: &str, cx: f64, cy: f64, border: f64) -> Markup {
    /// Of a letter, about.
    const LETTER: f64 = 7.0;
    let fits = cx + 9.0 + LETTER * label.chars().count() as f64 <= border;
    let (dx, dy, anchor) = if fits { (8.0, -6.0, "start") } else { (-8.0, 14.0, "end") };
    html! { text.note x=(px(cx + dx)) y=(px(cy + dy)) text-anchor=(anchor) { (label) } }
}

/// The shape of a series' marks, around the origin: colour alone does not tell all eyes apart.
fn symbol(look: usize) -> Markup {
    html! {
        @match look % 4 {
            0 => path d="M0-6.5 6.5 0 0 6.5-6.5 0Z" {},
            1 => circle r="4.6" {},
            2 => rect x="-4.3" y="-4.3" width="8.6" height="8.6" {},
            _ => path d="M0-5.6 5.4 4.2H-5.4Z" {},
        }
    }
}

/// A line and a mark of a series, for a legend.
pub(crate) fn key(look: usize) -> Markup {
    html! {
        svg.key viewBox="-16 -8 32 16" aria-hidden="true" {
            g class=(format!("series s{look}")) { line.line x1="-15" x2="15" y1="0" y2="0" {} g.mark { (symbol(look)) } }
        }
    }
}

fn path(points: impl Iterator<Item = [f64; 2]>, x: Axis, y: Axis) -> String {
    points.map(|[a, b]| format!("{},{}", px(x.at(a)), px(y.at(b)))).collect::<Vec<_>>().join(" ")
}

/// Tenths of a pixel are fine enough.
fn px(value: f64) -> String {
    format!("{:.1}", value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_have_short_names() {
        let names = [1e-6, 2e-5, 5e-4, 0.02, 1.0, 500.0, 20_000.0, 1e6, 5e7].map(tick_name);
        assert_eq!(names, ["10⁻⁶", "2·10⁻⁵", "0.0005", "0.02", "1", "500", "20000", "10⁶", "5·10⁷"]);
    }

    #[test]
    fn axes_hold_their_values_and_a_decade_at_least() {
        let axis = Axis::around([2.0, 3.0, 0.0, f64::NAN].into_iter(), 0.0, 100.0);
        assert!(axis.high - axis.low > 0.999 && axis.at(2.0) > 0.0 && axis.at(3.0) < 100.0);
        assert!(axis.ticks().iter().any(|(_, is_named)| *is_named));
        let none = Axis::around(std::iter::empty(), 0.0, 100.0);
        assert!(none.at(1.0).is_finite());
    }

    #[test]
    fn a_point_a_rung_with_its_tip() {
        let mark =
            |x, is_full| Mark { x, y: x, tip: format!("<{x}>"), label: None, is_full, spread: Some([x, 2.0 * x]) };
        let series = vec![Series { name: "a".into(), look: 1, points: vec![mark(0.1, true), mark(1.0, false)] }];
        let plot = Plot {
            title: "A".into(),
            x_label: "x".into(),
            y_label: "y".into(),
            series,
            bands: Vec::new(),
            levels: vec![("level".into(), 0.5)],
            has_diagonal: true,
        };
        let svg = plot.svg().into_string();
        assert_eq!(svg.matches("class=\"mark").count(), 2);
        assert_eq!(svg.matches("class=\"mark hollow\"").count(), 1);
        assert!(svg.contains("&lt;0.1&gt;") && svg.contains("role=\"img\"") && !svg.contains("NaN"));
    }
}
