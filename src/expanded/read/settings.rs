//! `global_settings`, with radiosity and photons.

use super::pictures::working;
use super::reader::{Reader, misplaced};
use super::tree::{Items, Node, Read, Rule, file_name, number, place, wrong};
use crate::scene::{Gamma, GatherRadius, PhotonFile, Photons, Radiosity, Subsurface};
use std::sync::Arc;

impl<'a> Reader<'a> {
    /// `global_settings { … }`; whether `assumed_gamma` is among them.
    pub(super) fn global_settings(&mut self, node: Node<'a>) -> Read<bool> {
        let mut gamma_given = false;
        for item in node.into_inner() {
            let mut items = Items::of(item.clone());
            let settings = &mut self.scene.settings;
            match item.as_rule() {
                Rule::gamma => {
                    settings.gamma = Gamma::Linear(working(&items.node()?)?);
                    gamma_given = true;
                }
                Rule::charset => self.utf8 = item.as_str().ends_with("utf8"),
                Rule::setting_color => {
                    let ambient = items.word()? == "ambient_light";
                    *(if ambient { &mut settings.ambient_light } else { &mut settings.irid_wavelength }) =
                        items.rgb()?;
                }
                Rule::setting_number => match items.word()? {
                    "max_trace_level" => settings.max_trace_level = items.whole_within(1, 256)?,
                    "adc_bailout" => settings.adc_bailout = items.number()?,
                    "number_of_waves" => settings.number_of_waves = items.whole_within(1, 1 << 16)?,
                    "noise_generator" => settings.noise_generator = Some(items.whole_within(1, 3)? as u8),
                    _ => settings.mm_per_unit = items.number()?,
                },
                Rule::subsurface_settings => {
                    let samples = [items.whole()?, items.whole()?];
                    let radiosity = items.number()? != 0.0;
                    settings.subsurface = Some(Subsurface { span: place(&item), samples, radiosity });
                }
                Rule::radiosity => settings.radiosity = Some(radiosity(item)?),
                Rule::photon_settings => settings.photons = Some(photon_settings(item)?),
                _ => return misplaced(&item),
            }
        }
        Ok(gamma_given)
    }
}

fn radiosity(node: Node<'_>) -> Read<Radiosity> {
    let mut radiosity = Radiosity { span: place(&node), ..Radiosity::default() };
    for item in node.clone().into_inner() {
        radiosity_item(item, &mut radiosity)?;
    }
    let [least, largest] = radiosity.reuse();
    if radiosity.pretrace_end > radiosity.pretrace_start || least >= largest {
        return wrong(&node, "pretrace_end must not be above pretrace_start, nor minimum_reuse above maximum_reuse");
    }
    Ok(radiosity)
}

fn radiosity_item(node: Node<'_>, radiosity: &mut Radiosity) -> Read<()> {
    let mut items = Items::of(node);
    let word = items.word()?;
    let first = items.node()?;
    let value = number(&first)?;
    let on = value != 0.0;
    let ranged = |field: &mut f64, holds: bool| {
        *field = value;
        if holds { Ok(()) } else { wrong(&first, format!("{word} lies outside of its range")) }
    };
    let whole = |least: f64, most: f64| -> Read<u32> {
        if (least..=most).contains(&value) {
            return Ok(value as u32);
        }
        wrong(&first, format!("{word} lies outside of its range"))
    };
    match word {
        "count" => {
            radiosity.count = whole(1.0, f64::from(u32::MAX))?;
            radiosity.directions = radiosity.count.max(1600);
            if items.peek().is_some() {
                radiosity.directions = items.whole_within(radiosity.count, u32::MAX)?;
            }
        }
        "nearest_count" => {
            radiosity.nearest_count = whole(1.0, 20.0)?;
            if items.peek().is_some() {
                radiosity.enough_for_pretrace = items.whole_within(0, radiosity.nearest_count - 1)?;
            }
        }
        "recursion_limit" => radiosity.recursion_limit = whole(1.0, 20.0)?,
        "error_bound" => ranged(&mut radiosity.error_bound, value > 0.0)?,
        "low_error_factor" => ranged(&mut radiosity.low_error_factor, value > 0.0)?,
        "minimum_reuse" => ranged(radiosity.minimum_reuse.insert(0.0), value >= 0.0)?,
        "maximum_reuse" => ranged(radiosity.maximum_reuse.insert(0.0), value > 0.0)?,
        "pretrace_start" => ranged(&mut radiosity.pretrace_start, value > 0.0 && value <= 1.0)?,
        "pretrace_end" => ranged(&mut radiosity.pretrace_end, value > 0.0 && value <= 1.0)?,
        "brightness" => ranged(&mut radiosity.brightness, value > 0.0)?,
        "gray_threshold" => ranged(&mut radiosity.gray_threshold, (0.0..=1.0).contains(&value))?,
        "adc_bailout" => ranged(&mut radiosity.adc_bailout, value > 0.0)?,
        "max_sample" => radiosity.max_sample = Some(value).filter(|v| *v > 0.0),
        "always_sample" => radiosity.always_sample = on,
        "normal" => radiosity.normal = on,
        "media" => radiosity.media = on,
        _ => radiosity.subsurface = on,
    }
    Ok(())
}

fn photon_settings(node: Node<'_>) -> Read<Photons> {
    let mut photons = Photons { span: place(&node), ..Photons::default() };
    for item in node.into_inner() {
        if item.as_rule() == Rule::photon_file {
            let mut items = Items::of(item);
            let save = items.word()? == "save_file";
            let name: Arc<str> = file_name(&items.node()?).into();
            photons.file = Some(if save { PhotonFile::Save(name) } else { PhotonFile::Load(name) });
            continue;
        }
        photon_item(item, &mut photons)?;
    }
    Ok(photons)
}

fn photon_item(node: Node<'_>, photons: &mut Photons) -> Read<()> {
    let mut items = Items::of(node.clone());
    match items.word()? {
        "spacing" => photons.spacing = items.number()?,
        "count" => photons.count = Some(items.whole()?).filter(|n| *n > 0),
        "gather" => {
            photons.gather = [items.whole()?, items.whole()?];
            if photons.gather[0] > photons.gather[1] || photons.gather[1] == 0 {
                return wrong(&node, "the first number of gather must not be above the second, which is above 0");
            }
        }
        "jitter" => photons.jitter = items.number()?,
        "autostop" => photons.autostop = items.number()?,
        "expand_thresholds" => {
            photons.expand_increase = items.number()?.max(0.0);
            photons.expand_minimum = items.whole()?;
        }
        "radius" => {
            let mut radius = || -> Read<GatherRadius> {
                let length = Some(items.number()?).filter(|v| *v > 0.0);
                Ok(GatherRadius { length, factor: items.number()? })
            };
            (photons.surface_radius, photons.media_radius) = (radius()?, radius()?);
        }
        "media" => {
            photons.media_steps = items.whole()?;
            if items.peek().is_some() {
                photons.media_factor = items.number()?;
            }
            if photons.media_factor.is_nan() || photons.media_factor <= 0.0 {
                return wrong(&node, "the second number of photons' media must be above 0");
            }
        }
        "max_trace_level" => photons.max_trace_level = Some(items.whole()?),
        _ => photons.adc_bailout = Some(items.number()?).filter(|v| *v >= 0.0),
    }
    Ok(())
}
