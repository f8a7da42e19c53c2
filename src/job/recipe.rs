//! The options that make a picture, in the words that stand in its file.

use super::Job;
use crate::eval::Overrides;
use crate::render::{Antialias, Method, Region, Target};
use crate::scene::IsosurfaceSearch;
use std::fmt::Display;
use std::time::Duration;

/// `name=value` for each option with a say in the pixels, by the names of `whitted render`'s long options, whichever front
/// end they came from; `header`, `antialias-gamma` and `frame` beside them. What is as ever is left out.
pub(super) fn recipe(job: &Job) -> String {
    let mut words = Words::default();
    words.picture(job);
    words.reading(job);
    words.0.join(" ")
}

#[derive(Default)]
struct Words(Vec<String>);

impl Words {
    fn say(&mut self, name: &str, value: impl Display) {
        let value = value.to_string();
        let blank = value.contains(char::is_whitespace);
        self.0.push(if blank { format!("{name}=\"{value}\"") } else { format!("{name}={value}") });
    }

    fn maybe(&mut self, name: &str, value: Option<impl Display>) {
        value.into_iter().for_each(|value| self.say(name, value));
    }

    fn picture(&mut self, job: &Job) {
        let options = &job.rendering;
        self.say("width", options.width);
        self.say("height", options.height);
        self.maybe("region", options.region.map(region));
        match &options.target {
            Some(target) => self.target(target),
            None => self.say("antialias", options.antialias.map_or("off".into(), antialias)),
        }
        let gamma = options.antialias.map(|antialias| antialias.gamma);
        self.maybe("antialias-gamma", gamma.filter(|gamma| *gamma != Antialias::GAMMA));
        self.say("quality", options.quality);
        if options.alpha {
            self.0.push("alpha".into());
        }
        if !options.layers.is_empty() {
            self.say("layers", listed(options.layers.iter().map(|layer| layer.name())));
        }
        self.maybe("radiosity-from", job.light.from.as_ref().map(|file| file.display()));
        if !job.exposure.is_a_moment() {
            // What is known of the shutter is what it does to the clock.
            self.say("exposure", job.exposure.span);
            self.say("samples", job.exposure.samples);
        }
    }

    fn target(&mut self, target: &Target) {
        self.maybe("target-error", target.error);
        self.maybe("time-budget", target.time.as_ref().map(Duration::as_secs_f64));
        self.maybe("rounds", target.rounds.as_ref().map(|rounds| listed(rounds.iter())));
        self.say("seed", target.seed);
    }

    fn reading(&mut self, job: &Job) {
        let reading = &job.reading;
        self.maybe("language-version", reading.version.map(|hundredths| f64::from(hundredths) / 100.0));
        self.maybe("header", reading.header.as_ref().map(|header| header.display()));
        for (name, value) in &reading.declarations {
            self.say("declare", format_args!("{name}:{value}"));
        }
        if reading.clock != 0.0 || reading.animated {
            self.say("clock", reading.clock);
        }
        let [first, last, frame, from, to, _] = reading.animation;
        if frame != 0.0 || last != 0.0 {
            self.say("frame", frame);
            self.say("frames", format_args!("{first}-{last}"));
            self.say("clocks", format_args!("{from},{to}"));
        }
        if reading.isosurface_search == IsosurfaceSearch::PovRay {
            self.say("isosurface-search", "povray");
        }
        self.overrides(&reading.overrides);
    }

    fn overrides(&mut self, overrides: &Overrides) {
        let usual = Overrides::default();
        let factor = |value: f64, usual: f64| (value != usual).then_some(value);
        self.maybe("max_trace_level", overrides.max_trace_level);
        self.maybe("adc_bailout", overrides.adc_bailout);
        self.maybe("area_light_grid", factor(overrides.area_light_grid, usual.area_light_grid));
        self.maybe("isosurface_accuracy", factor(overrides.isosurface_accuracy, usual.isosurface_accuracy));
    }
}

fn listed(values: impl Iterator<Item = impl Display>) -> String {
    values.map(|value| value.to_string()).collect::<Vec<_>>().join(",")
}

fn region(Region { left, top, right, bottom }: Region) -> String {
    format!("{left},{top},{right},{bottom}")
}

fn antialias(Antialias { method, threshold, depth, jitter, .. }: Antialias) -> String {
    let method = match method {
        Method::Grid => 1,
        Method::Adaptive => 2,
    };
    format!("{method},{threshold},{depth},{jitter}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Animation, Exposure};
    use crate::render::ImageLayer;

    fn check(change: impl Fn(&mut Job), expected: &str) {
        let mut job = Job::default();
        (job.rendering.width, job.rendering.height) = (64, 48);
        change(&mut job);
        assert_eq!(recipe(&job), expected);
    }

    #[test]
    fn options_that_count_are_told() {
        check(|_| {}, "width=64 height=48 antialias=off quality=9");
        check(
            |job| {
                let rendering = &mut job.rendering;
                rendering.antialias =
                    Some(Antialias { method: Method::Grid, threshold: 0.3, depth: 3, jitter: 1.0, gamma: 1.0 });
                rendering.region = Some(Region { left: 1, top: 2, right: 3, bottom: 4 });
                (rendering.alpha, rendering.layers) = (true, vec![ImageLayer::Depth, ImageLayer::Normal]);
                job.reading.declarations = vec![("A".into(), 1.5)];
                job.reading.header = Some("a b.inc".into());
            },
            "width=64 height=48 region=1,2,3,4 antialias=1,0.3,3,1 antialias-gamma=1 quality=9 alpha layers=Z,N header=\"a b.inc\" declare=A:1.5",
        );
    }

    #[test]
    fn frames_say_which_they_are() {
        let animation =
            Animation { initial_frame: 1, final_frame: 5, initial_clock: 0.0, final_clock: 2.0, cyclic: false };
        check(
            |job| {
                animation.show(3, &mut job.reading);
                job.exposure = Exposure { span: 0.25, samples: 8 };
            },
            "width=64 height=48 antialias=off quality=9 exposure=0.25 samples=8 clock=1 frame=3 frames=1-5 clocks=0,2",
        );
    }
}
