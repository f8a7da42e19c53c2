//! Light sources, interiors and media.

use super::number::{double, rgb, vector};
use super::patterns::switch;
use super::writer::Writer;
use crate::math::DVec3;
use crate::scene::{AreaLight, Interior, LightKind, LightSource, Media};
use std::sync::Arc;

impl Writer<'_> {
    /// The inside of `light_source`.
    pub(super) fn light(&mut self, light: &LightSource) {
        let LightSource {
            location,
            color,
            kind,
            parallel,
            axis,
            point_at,
            fade_distance,
            fade_power,
            area,
            looks_like,
            projected_through,
            media_attenuation,
            media_interaction,
            photons,
        } = light;
        self.line(format_args!("{}, {}", vector(*location), rgb(*color)));
        if let Some(words) = light_kind(kind) {
            self.line(words);
        }
        if *parallel && !matches!(kind, LightKind::Cylinder { .. }) {
            self.line("parallel");
        }
        // POV-Ray takes no direction for a light that shines everywhere.
        if *parallel || matches!(kind, LightKind::Spot { .. } | LightKind::Cylinder { .. }) {
            self.line(format_args!("point_at {}", vector(*point_at)));
            if *axis != (*point_at - *location).normalize_or(DVec3::Z) {
                self.note(format_args!("axis {}", vector(*axis)));
            }
        }
        if *fade_distance != 0.0 || *fade_power != 0.0 {
            self.line(format_args!("fade_distance {} fade_power {}", double(*fade_distance), double(*fade_power)));
        }
        if let Some(area) = area {
            self.line(area_light(area));
        }
        if *media_attenuation {
            self.line("media_attenuation on");
        }
        if !media_interaction {
            self.line("media_interaction off");
        }
        self.photons(photons);
        if let Some(object) = looks_like {
            // It is moved to the light when it is read.
            self.open("looks_like");
            self.object(object);
            self.line(format_args!("translate {}", vector(-*location)));
            self.close();
        }
        if let Some(object) = projected_through {
            self.open("projected_through");
            self.object(object);
            self.close();
        }
    }

    /// `interior { … }`.
    pub(super) fn interior(&mut self, interior: &Arc<Interior>) {
        let write = |w: &mut Self| {
            w.open("interior");
            w.interior_parts(interior);
            w.close();
        };
        match self.shared(interior, "Interior", false, write) {
            Some(name) => self.block("interior", name),
            None => write(self),
        }
    }

    fn interior_parts(&mut self, interior: &Interior) {
        let Interior {
            span: _,
            ior,
            caustics,
            dispersion,
            dispersion_samples,
            fade_distance,
            fade_power,
            fade_color,
            refraction,
            media,
        } = interior;
        let plain = Interior::default();
        let numbers = [
            ("ior", *ior, plain.ior),
            ("caustics", *caustics, plain.caustics),
            ("dispersion", *dispersion, plain.dispersion),
            ("fade_distance", *fade_distance, plain.fade_distance),
            ("fade_power", *fade_power, plain.fade_power),
            ("refraction", *refraction, plain.refraction),
        ];
        let mut words: Vec<String> = numbers
            .into_iter()
            .filter(|(_, value, default)| value.to_bits() != default.to_bits())
            .map(|(word, value, _)| format!("{word} {}", double(value)))
            .collect();
        if *dispersion_samples != plain.dispersion_samples {
            words.push(format!("dispersion_samples {dispersion_samples}"));
        }
        if *fade_color != plain.fade_color {
            words.push(format!("fade_color {}", rgb(*fade_color)));
        }
        if !words.is_empty() {
            self.line(words.join(" "));
        }
        media.iter().for_each(|media| self.media(media));
    }

    /// `media { … }`.
    pub(super) fn media(&mut self, media: &Media) {
        let Media {
            span: _,
            method,
            intervals,
            samples: [least, most],
            jitter,
            aa_level,
            aa_threshold,
            confidence,
            variance,
            ratio,
            absorption,
            emission,
            scattering: (kind, color, eccentricity, extinction),
            density,
            collect,
        } = media;
        self.open("media");
        self.line(format_args!("method {method} intervals {intervals} samples {least}, {most}"));
        let (jitter, threshold) = (double(*jitter), double(*aa_threshold));
        self.line(format_args!("jitter {jitter} aa_level {aa_level} aa_threshold {threshold}"));
        let (confidence, variance, ratio) = (double(*confidence), double(*variance), double(*ratio));
        self.line(format_args!("confidence {confidence} variance {variance} ratio {ratio}"));
        self.line(format_args!("absorption {} emission {}", rgb(*absorption), rgb(*emission)));
        if *kind != 0 {
            let eccentricity =
                if *kind == 5 { format!(" eccentricity {}", double(*eccentricity)) } else { String::new() };
            let extinction = double(*extinction);
            self.line(format_args!("scattering {{ {kind}, {}{eccentricity} extinction {extinction} }}", rgb(*color)));
        }
        density.iter().for_each(|density| self.density_block(density));
        if !collect {
            self.line("collect off");
        }
        self.close();
    }
}

fn light_kind(kind: &LightKind) -> Option<String> {
    let words = |word: &str, radius: f64, falloff: f64, tightness: f64| {
        let (radius, falloff, tightness) = (double(radius), double(falloff), double(tightness));
        Some(format!("{word} radius {radius} falloff {falloff} tightness {tightness}"))
    };
    match *kind {
        LightKind::Point => None,
        LightKind::Spot { radius_deg, falloff_deg, tightness } => {
            words("spotlight", radius_deg, falloff_deg, tightness)
        }
        LightKind::Cylinder { radius, falloff, tightness } => words("cylinder", radius, falloff, tightness),
        LightKind::Shadowless => Some("shadowless".to_owned()),
    }
}

fn area_light(area: &AreaLight) -> String {
    let AreaLight { axis1, axis2, size1, size2, adaptive, jitter, circular, orient, area_illumination } = *area;
    let alone = axis1 == DVec3::ZERO && axis2 == DVec3::ZERO && area_illumination && size1 == 1 && size2 == 1;
    if alone {
        return "area_illumination on".to_owned();
    }
    let mut text = format!("area_light {}, {}, {size1}, {size2}", vector(axis1), vector(axis2));
    if adaptive != AreaLight::NOT_ADAPTIVE {
        text += &format!(" adaptive {adaptive}");
    }
    for (on, word) in [(jitter, " jitter"), (circular, " circular"), (orient, " orient")] {
        text += if on { word } else { "" };
    }
    if area_illumination {
        text += &format!(" area_illumination {}", switch(true));
    }
    text
}
