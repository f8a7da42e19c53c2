//! Ladders as data: ways of making a picture that get dearer and better rung by rung.

use super::census::Census;
use crate::measure::Program;

/// One way of making the picture: what is added to the command line that all rungs share.
#[derive(Clone, Debug, PartialEq)]
pub struct Rung {
    /// How it differs from the others of its ladder.
    pub label: String,
    /// Arguments of the program.
    pub arguments: Vec<String>,
    /// The error that it was asked for.
    pub target: Option<f64>,
    /// About how long it takes, one sample a pixel being 1: for the time that is left.
    pub weight: f64,
    /// What the scene itself asks for.
    pub is_scenes_own: bool,
}

/// What a ladder's errors are against.
#[derive(Clone, Debug, PartialEq)]
pub enum Against {
    /// The scene's reference: what sampling leaves undone.
    Reference,
    /// This rung, with the same samples at the same places: what a limit alone cuts off, which no sampling sees.
    Finest(Rung),
}

/// Rungs from coarse to fine.
#[derive(Clone, Debug, PartialEq)]
pub struct Ladder {
    /// The method, in words.
    pub name: String,
    /// Who climbs it.
    pub program: Program,
    /// What errors are against.
    pub against: Against,
    /// Coarse to fine.
    pub rungs: Vec<Rung>,
}

/// The name of the ladders whose finest rungs sample all pixels alike in both programs.
pub const METHOD_1: &str = "method 1";

/// Thresholds and depths of method 1.
const GRID: [(f64, u32); 7] = [(0.3, 2), (0.3, 3), (0.1, 3), (0.1, 5), (0.03, 5), (0.0, 3), (0.0, 5)];
/// Thresholds and depths of method 2, whose depth is in halvings.
const ADAPTIVE: [(f64, u32); 6] = [(0.3, 2), (0.3, 3), (0.1, 3), (0.03, 3), (0.01, 3), (0.0, 2)];
/// Errors that `--target-error` is asked for: the finest is about three times that of a reference that is made.
const TARGETS: [f64; 6] = [0.05, 0.03, 0.02, 0.01, 0.007, 0.005];
const TRACE_LEVELS: [u32; 7] = [1, 2, 3, 5, 8, 12, 20];
const FINEST_TRACE_LEVEL: u32 = 32;
/// One display step of 8 bits, about, is the language's own.
const BAILOUTS: [f64; 4] = [0.1, 0.03, 0.01, 0.001];
const FINEST_BAILOUT: f64 = 1e-5;
const GRID_FACTORS: [f64; 4] = [0.5, 1.0, 2.0, 4.0];
const FINEST_GRID_FACTOR: f64 = 8.0;
const ACCURACY_FACTORS: [f64; 4] = [100.0, 10.0, 1.0, 0.1];
const FINEST_ACCURACY_FACTOR: f64 = 0.01;

/// All ladders of a scene that has something for them.
pub fn all(census: &Census, with_povray: bool) -> Vec<Ladder> {
    let programs: &[Program] = if with_povray { &[Program::Whitted, Program::PovRay] } else { &[Program::Whitted] };
    let mut ladders = vec![targets(&TARGETS)];
    for &program in programs {
        ladders.extend([plain(program), grid(program), adaptive(program)]);
    }
    ladders.extend(limits(census));
    ladders.retain(|ladder| !ladder.rungs.is_empty());
    ladders
}

fn sampling(name: &str, program: Program, rungs: Vec<Rung>) -> Ladder {
    Ladder { name: name.into(), program, against: Against::Reference, rungs }
}

/// Ours, stopping at an error.
fn targets(targets: &[f64]) -> Ladder {
    let rung = |target: &f64| Rung {
        label: format!("{target}"),
        arguments: vec!["--target-error".into(), target.to_string()],
        target: Some(*target),
        weight: 4.0 + 0.02 / target,
        is_scenes_own: false,
    };
    sampling("target error", Program::Whitted, targets.iter().map(rung).collect())
}

fn plain(program: Program) -> Ladder {
    let arguments = match program {
        Program::Whitted => ["--antialias", "off"].map(String::from).to_vec(),
        Program::PovRay => vec!["-A".into()],
    };
    let rung = Rung { label: "one sample".into(), arguments, target: None, weight: 1.0, is_scenes_own: false };
    sampling("no antialiasing", program, vec![rung])
}

fn grid(program: Program) -> Ladder {
    let samples = |depth: u32| f64::from(depth * depth);
    sampling(METHOD_1, program, GRID.map(|(t, depth)| antialiased(program, 1, t, depth, samples(depth))).into())
}

fn adaptive(program: Program) -> Ladder {
    let samples = |depth: u32| f64::from(1 << (2 * depth));
    sampling("method 2", program, ADAPTIVE.map(|(t, depth)| antialiased(program, 2, t, depth, samples(depth))).into())
}

fn antialiased(program: Program, method: u8, threshold: f64, depth: u32, samples: f64) -> Rung {
    /// Share of pixels that are refined, roughly.
    const REFINED: f64 = 0.25;
    let arguments = match program {
        Program::Whitted => vec!["--antialias".into(), format!("{method},{threshold},{depth}")],
        // POV-Ray takes no 0 without a point.
        Program::PovRay => vec![format!("+AM{method}"), format!("+A{threshold:?}"), format!("+R{depth}"), "-J".into()],
    };
    Rung {
        label: format!("threshold {threshold}, depth {depth}"),
        arguments,
        target: None,
        weight: if threshold > 0.0 { 1.0 + REFINED * samples } else { samples },
        is_scenes_own: false,
    }
}

/// What no amount of samples mends, each by itself.
fn limits(census: &Census) -> Vec<Ladder> {
    let mut ladders = Vec::new();
    if census.has_secondary_rays {
        let levels = with_own(&TRACE_LEVELS.map(f64::from), f64::from(census.max_trace_level));
        let finest = f64::from(FINEST_TRACE_LEVEL.max(census.max_trace_level));
        ladders.push(limit("max_trace_level", &levels, finest, f64::from(census.max_trace_level)));
        let bailouts = with_own(&BAILOUTS, census.adc_bailout);
        ladders.push(limit("adc_bailout", &bailouts, FINEST_BAILOUT.min(census.adc_bailout), census.adc_bailout));
    }
    if census.has_area_lights {
        ladders.push(limit("area_light_grid", &GRID_FACTORS, FINEST_GRID_FACTOR, 1.0));
    }
    if census.has_isosurfaces {
        ladders.push(limit("isosurface_accuracy", &ACCURACY_FACTORS, FINEST_ACCURACY_FACTOR, 1.0));
    }
    ladders
}

/// The values with the scene's own among them, in their order.
fn with_own(values: &[f64], own: f64) -> Vec<f64> {
    let rises = values.first() < values.last();
    let mut all: Vec<f64> = values.iter().copied().filter(|v| (v / own - 1.0).abs() > 1e-3).chain([own]).collect();
    all.sort_by(|a, b| if rises { a.total_cmp(b) } else { b.total_cmp(a) });
    all
}

fn limit(name: &str, values: &[f64], finest: f64, own: f64) -> Ladder {
    let is_factor = matches!(name, "area_light_grid" | "isosurface_accuracy");
    let rung = |value: f64| Rung {
        label: if is_factor { format!("× {value}") } else { short(value) },
        arguments: ["--antialias", "off", "--override"]
            .map(String::from)
            .into_iter()
            .chain([format!("{name}={value}")])
            .collect(),
        target: None,
        weight: if name == "area_light_grid" { value * value } else { 1.0 },
        is_scenes_own: value == own,
    };
    // The finest is what others are held against, so it is no rung itself.
    let rungs = values.iter().copied().filter(|value| *value != finest).map(rung).collect();
    Ladder { name: name.into(), program: Program::Whitted, against: Against::Finest(rung(finest)), rungs }
}

/// With few digits: 1/255 would fill the page.
fn short(value: f64) -> String {
    let digits = (2.0 - value.abs().log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn glass() -> Census {
        Census { has_secondary_rays: true, max_trace_level: 12, adc_bailout: 1.0 / 255.0, ..Census::default() }
    }

    #[test]
    fn a_plain_scene_has_ladders_of_sampling_only() {
        let ladders = all(&Census::default(), false);
        assert_eq!(
            ladders.iter().map(|l| l.name.as_str()).collect::<Vec<_>>(),
            ["target error", "no antialiasing", "method 1", "method 2"]
        );
        assert_eq!(all(&Census::default(), true).len(), 7);
    }

    #[test]
    fn limits_hold_the_scenes_own_once() {
        for ladder in limits(&glass()) {
            assert_eq!(ladder.rungs.iter().filter(|rung| rung.is_scenes_own).count(), 1, "{}", ladder.name);
        }
        let [levels, bailouts] = &limits(&glass())[..] else { panic!("two ladders") };
        assert_eq!(levels.rungs.len(), TRACE_LEVELS.len());
        let labels: Vec<&str> = bailouts.rungs.iter().map(|rung| rung.label.as_str()).collect();
        assert_eq!(labels, ["0.1", "0.03", "0.01", "0.00392", "0.001"]);
        assert_eq!(levels.rungs[5].arguments, ["--antialias", "off", "--override", "max_trace_level=12"]);
    }

    #[test]
    fn a_scene_finer_than_the_ladder_is_the_finest() {
        let census = Census { max_trace_level: 100, ..glass() };
        let ladder = &limits(&census)[0];
        let Against::Finest(finest) = &ladder.against else { panic!("a limit") };
        assert!(finest.is_scenes_own && ladder.rungs.iter().all(|rung| !rung.is_scenes_own));
    }

    #[test]
    fn povray_gets_the_same_rungs_in_its_own_words() {
        let (ours, theirs) = (grid(Program::Whitted), grid(Program::PovRay));
        let (ours, theirs) = (&ours.rungs[5], &theirs.rungs[5]);
        assert_eq!(ours.label, theirs.label);
        assert_eq!(ours.arguments, ["--antialias", "1,0,3"]);
        assert_eq!(theirs.arguments, ["+AM1", "+A0.0", "+R3", "-J"]);
    }

    #[test]
    fn targets_are_rungs_like_others() {
        let ladder = targets(&[0.01]);
        assert_eq!(ladder.rungs[0].arguments, ["--target-error", "0.01"]);
        assert_eq!(ladder.rungs[0].target, Some(0.01));
    }
}
