//! What stands around the objects: camera, background, sky, fog, rainbows.

use super::patterns::turbulence;
use super::reader::{Reader, misplaced};
use super::shapes::unit_kept;
use super::tree::{Items, Node, Read, Rule, place, wrong};
use crate::math::{Color, DVec3, Rgb, Transform};
use crate::scene::{
    Background, Blend, Camera, CameraKind, FocalBlur, Fog, MeshCamera, Pattern, PatternKind, Pigment, PigmentKind,
    Rainbow, SkySphere,
};
use std::sync::Arc;

impl<'a> Reader<'a> {
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
