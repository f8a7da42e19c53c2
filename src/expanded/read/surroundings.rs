//! What stands around the objects: settings, camera, background, sky, fog, rainbows.

use super::patterns::{turbulence, working};
use super::reader::{Reader, misplaced};
use super::shapes::unit_kept;
use super::tree::{Items, Node, Read, Rule, file_name, number, place, wrong};
use crate::math::{Color, DVec3, Rgb, Transform};
use crate::scene::{
    Background, Blend, Camera, CameraKind, FocalBlur, Fog, Gamma, GatherRadius, MeshCamera, Pattern, PatternKind,
    PhotonFile, Photons, Pigment, PigmentKind, Radiosity, Rainbow, SkySphere, Subsurface,
};
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

    /// `camera { … }`: its vectors are what rays are made of.
    pub(super) fn camera(&mut self, node: Node<'a>) -> Read<Camera> {
        let mut items = Items::of(node.clone());
        let kind = self.camera_kind(items.node()?)?;
        let angle_deg = if matches!(kind, CameraKind::Spherical) { 360.0 } else { 90.0 };
        let mut camera = Camera { span: place(&node), kind, angle_deg, ..Camera::default() };
        let mut blur = Blur::default();
        for item in items {
            self.camera_item(item, &mut camera, &mut blur)?;
        }
        let Blur { aperture, samples: [min_samples, max_samples], confidence, variance, point, distance, bokeh } = blur;
        if aperture != 0.0 && max_samples > 0 {
            let focal_distance =
                distance.or_else(|| point.map(|point| (point - camera.location).length())).unwrap_or(1.0);
            camera.focal_blur =
                Some(FocalBlur { aperture, min_samples, max_samples, confidence, variance, focal_distance, bokeh });
        }
        Ok(camera)
    }

    fn camera_kind(&mut self, node: Node<'a>) -> Read<CameraKind> {
        let mut items = Items::of(node);
        Ok(match items.peek() {
            Some(Rule::mesh_camera) => {
                let mut inner = Items::of(items.node()?);
                let rays_per_pixel = inner.whole_within(1, 1 << 16)?;
                let distribution = inner.whole_within(0, 3)? as u8;
                let max_distance = inner.number()?;
                let (mut meshes, mut smooth) = (Vec::new(), false);
                for item in inner {
                    match item.as_rule() {
                        Rule::smooth => smooth = true,
                        _ => meshes.push(self.object(item)?),
                    }
                }
                CameraKind::Mesh(Arc::new(MeshCamera { rays_per_pixel, distribution, max_distance, meshes, smooth }))
            }
            Some(Rule::number) => CameraKind::Cylinder(items.whole_within(1, 4)? as u8),
            _ => match items.word()? {
                "orthographic" => CameraKind::Orthographic,
                "fisheye" => CameraKind::Fisheye,
                "ultra_wide_angle" => CameraKind::UltraWideAngle,
                "omnimax" => CameraKind::Omnimax,
                "panoramic" => CameraKind::Panoramic,
                "spherical" => CameraKind::Spherical,
                _ => CameraKind::Perspective,
            },
        })
    }

    fn camera_item(&mut self, node: Node<'a>, camera: &mut Camera, blur: &mut Blur) -> Read<()> {
        let mut items = Items::of(node.clone());
        match node.as_rule() {
            Rule::camera_vector => {
                let word = items.word()?;
                let v = items.vector()?;
                match word {
                    "location" => camera.location = v,
                    "direction" => camera.direction = v,
                    "up" => camera.up = v,
                    "right" => camera.right = v,
                    _ => blur.point = Some(v),
                }
            }
            Rule::angle => {
                camera.angle_deg = items.number()?;
                camera.vertical_angle_deg =
                    if items.peek().is_some() { items.number()? } else { camera.angle_deg / 2.0 };
            }
            Rule::normal => camera.normal = Some(self.normal(node)?),
            Rule::blur_samples => {
                let first = items.whole_within(0, 1 << 24)?;
                let second = if items.peek().is_some() { Some(items.whole_within(0, 1 << 24)?) } else { None };
                blur.samples = second.map_or([0, first], |most| [first, most]);
                if blur.samples[0] > blur.samples[1] {
                    return wrong(&node, "the smallest number of blur samples exceeds the largest");
                }
            }
            Rule::camera_number => match items.word()? {
                "aperture" => blur.aperture = items.number()?,
                "confidence" => blur.confidence = items.number()?,
                _ => blur.variance = items.number()?,
            },
            Rule::bokeh => {
                let pigment = items.node()?;
                blur.bokeh = Some(self.pigment(pigment)?);
            }
            Rule::distance_note => blur.distance = Some(items.number()?),
            _ => return misplaced(&node),
        }
        Ok(())
    }

    pub(super) fn background(&mut self, node: Node<'a>) -> Read<Background> {
        let mut items = Items::of(node);
        let color = items.color()?;
        let legacy = match items.optional(Rule::age_note) {
            Some(note) => Items::of(note).word()? == "legacy",
            None => self.version < 370,
        };
        Ok(Background { color, legacy })
    }

    pub(super) fn sky_sphere(&mut self, node: Node<'a>) -> Read<SkySphere> {
        let mut sky =
            SkySphere { span: place(&node), pigments: Vec::new(), emission: Rgb::ONE, transform: Transform::IDENTITY };
        for item in node.into_inner() {
            match item.as_rule() {
                Rule::pigment => sky.pigments.push(self.pigment(item)?),
                Rule::emission => sky.emission = Items::of(item).rgb()?,
                _ => sky.transform = sky.transform.then(&self.transform(item)?),
            }
        }
        Ok(sky)
    }

    pub(super) fn fog(&mut self, node: Node<'a>) -> Read<Fog> {
        let mut fog = Fog::new(place(&node));
        for item in node.into_inner() {
            let mut items = Items::of(item.clone());
            match item.as_rule() {
                Rule::color => fog.color = super::tree::color(item)?,
                Rule::turbulence => fog.turbulence = Some(turbulence(item)?),
                Rule::fog_up => fog.up = unit_kept(items.vector()?).unwrap_or(DVec3::Y),
                _ => match items.word()? {
                    "fog_type" => fog.ground = items.whole_within(1, 2)? == 2,
                    "distance" => fog.distance = items.number()?,
                    "fog_offset" => fog.offset = items.number()?,
                    "fog_alt" => fog.alt = items.number()?,
                    _ => fog.turb_depth = items.number()?,
                },
            }
        }
        Ok(fog)
    }

    pub(super) fn rainbow(&mut self, node: Node<'a>) -> Read<Rainbow> {
        let mut rainbow = Rainbow::new(place(&node));
        for item in node.clone().into_inner() {
            let mut items = Items::of(item.clone());
            match item.as_rule() {
                Rule::rainbow_vector => {
                    let direction = items.word()? == "direction";
                    *(if direction { &mut rainbow.direction } else { &mut rainbow.up }) = items.vector()?;
                }
                Rule::rainbow_item => match items.word()? {
                    "angle" => rainbow.angle_deg = items.number()?,
                    "width" => rainbow.width_deg = items.number()?,
                    "distance" => rainbow.distance = items.number()?,
                    "jitter" => rainbow.jitter = items.number()?,
                    "arc_angle" => rainbow.arc_angle_deg = Some(items.number()?),
                    _ => rainbow.falloff_angle_deg = Some(items.number()?),
                },
                _ => {
                    let map: Arc<Blend<Color>> = self.color_map(item)?;
                    let along = Box::new(Pattern::new(PatternKind::Gradient(DVec3::X)));
                    rainbow.pigment = Arc::new(Pigment { kind: PigmentKind::Colors(along, map), ..Pigment::default() });
                }
            }
        }
        upright(&node, &mut rainbow)?;
        Ok(rainbow)
    }
}

/// Makes the directions of a rainbow units, perpendicular to each other, as far as they are not so already.
fn upright(node: &Node<'_>, rainbow: &mut Rainbow) -> Read<()> {
    let Some(direction) = unit_kept(rainbow.direction) else { return wrong(node, "a rainbow needs a direction") };
    let Some(side) = rainbow.up.cross(direction).try_normalize() else {
        return wrong(node, "a rainbow's up vector must not point along its direction");
    };
    rainbow.direction = direction;
    let square = rainbow.up.dot(direction).abs() <= 8.0 * f64::EPSILON;
    let up = unit_kept(rainbow.up).filter(|up| square && *up == rainbow.up);
    rainbow.up = up.unwrap_or_else(|| direction.cross(side));
    Ok(())
}

/// What a camera says of its lens.
struct Blur {
    aperture: f64,
    samples: [u32; 2],
    confidence: f64,
    variance: f64,
    point: Option<DVec3>,
    distance: Option<f64>,
    bokeh: Option<Arc<Pigment>>,
}

impl Default for Blur {
    fn default() -> Self {
        // POV-Ray's defaults.
        let (confidence, variance) = (0.9, 1e-4);
        Self { aperture: 0.0, samples: [0, 0], confidence, variance, point: None, distance: None, bokeh: None }
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
