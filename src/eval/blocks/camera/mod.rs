//! `camera { … }`.

mod statement;

pub use statement::CameraStatement;

use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Topic};
use crate::eval::{Evaluator, Value};
use crate::math::DVec3;
use crate::scene::{CameraKind, MeshCamera, Pigment};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// From this version on, the order of statements in a camera does not matter.
const VERSION_OF_UNORDERED_CAMERAS: u32 = 350;

/// The types, which stand first.
pub(super) static CAMERA_TYPES: Block<CameraStatement> = Block::new(
    "types of camera",
    "the kinds of camera",
    &[
        Item::new(K::Perspective, Takes::Nothing(|c| c.kind = CameraKind::Perspective), "", "as a pinhole camera sees"),
        Item::new(K::Orthographic, Takes::Nothing(|c| c.kind = CameraKind::Orthographic), "", "parallel rays"),
        Item::new(K::Fisheye, Takes::Nothing(|c| c.kind = CameraKind::Fisheye), "", "a circle of any angle"),
        Item::new(
            K::UltraWideAngle,
            Takes::Nothing(|c| c.kind = CameraKind::UltraWideAngle),
            "",
            "a rectangle of any angle",
        ),
        Item::new(K::Omnimax, Takes::Nothing(|c| c.kind = CameraKind::Omnimax), "", "a fisheye for domes"),
        Item::new(K::Panoramic, Takes::Nothing(|c| c.kind = CameraKind::Panoramic), "", "a cylinder about the camera"),
        Item::since(
            350,
            K::Spherical,
            Takes::Nothing(|c| c.kind = CameraKind::Spherical),
            "",
            "all around, by longitude and latitude",
        ),
        Item::new(
            K::Cylinder,
            Takes::Other("INTEGER", |e, c, _| {
                let span = e.span();
                c.kind = match e.integer()? {
                    n @ 1..=4 => CameraKind::Cylinder(n as u8),
                    n => return e.error(span, format!("there is no cylinder camera of type {n}; use 1 to 4")),
                };
                Ok(())
            }),
            "",
            "a cylinder: 1 and 3 upright, 2 and 4 lying; 3 and 4 with a viewpoint that moves along it",
        ),
        Item::since(
            370,
            K::MeshCamera,
            Takes::Other("{ RAYS, DISTRIBUTION [, MAX_DISTANCE] MESHES [smooth] }", |e, c, _| {
                c.kind = CameraKind::Mesh(Arc::new(e.mesh_camera()?));
                Ok(())
            }),
            "",
            "rays from the triangles of meshes",
        ),
    ],
);

pub(super) static CAMERA: Block<CameraStatement> = Block::<CameraStatement>::moved(
    "camera",
    "where the picture is seen from",
    |e, camera, transform| {
        if e.orders_cameras() {
            camera.location = transform.point(camera.location);
            for v in [&mut camera.direction, &mut camera.up, &mut camera.right] {
                *v = transform.vector(*v);
            }
        } else {
            camera.transform = camera.transform.then(transform);
        }
    },
    &[
        Item::new(K::Location, Takes::Vector(|c| &mut c.location), "<0, 0, 0>", "where it stands"),
        Item::new(
            K::LookAt,
            Takes::Other("VECTOR", |e, c, _| {
                let target = e.vector()?;
                c.look_at = Some(target);
                if e.orders_cameras() {
                    c.face(target);
                }
                Ok(())
            }),
            "",
            "what it is turned towards",
        ),
        Item::new(
            K::Angle,
            Takes::Other("FLOAT [, FLOAT]", camera_angle),
            "",
            "how wide it sees, in degrees; a spherical one also how high",
        ),
        Item::new(
            K::Right,
            Takes::Other("VECTOR", |e, c, _| {
                c.right = e.vector()?;
                c.has_frame = true;
                Ok(())
            }),
            "1.33*x",
            "to the right of the picture, as long as it is wide",
        ),
        Item::new(
            K::Up,
            Takes::Other("VECTOR", |e, c, _| {
                c.up = e.vector()?;
                c.has_frame = true;
                Ok(())
            }),
            "y",
            "upwards in the picture, as long as it is high",
        ),
        Item::new(K::Direction, Takes::Vector(|c| &mut c.direction), "z", "to the middle of the picture"),
        Item::new(K::Sky, Takes::Vector(|c| &mut c.sky), "y", "what is up when it is turned by look_at"),
        Item::new(
            K::Normal,
            Takes::Other("{ NORMAL }", |e, c, _| {
                c.normal = e.normal_block(e.defaults.layer.normal.clone())?;
                Ok(())
            }),
            "",
            "bumps by which its rays are bent",
        ),
        Item::new(K::Aperture, Takes::Float(|c| &mut c.aperture), "0", "size of the lens: how much is out of focus"),
        Item::new(
            K::BlurSamples,
            Takes::Other("[INTEGER,] INTEGER", blur_samples),
            "0",
            "rays for each pixel through the lens, at least and at most",
        ),
        Item::new(
            K::Confidence,
            Takes::Other("FLOAT", |e, c, at| {
                let value = e.float()?;
                if value > 0.0 && value < 1.0 {
                    c.confidence = value;
                } else {
                    e.warn(Topic::Range, at.span, "confidence must lie between 0 and 1; the default is kept");
                }
                Ok(())
            }),
            "0.9",
            "how sure a pixel must be to take no more rays",
        ),
        Item::new(
            K::Variance,
            Takes::Other("FLOAT", |e, c, at| {
                let value = e.float()?;
                if (0.0..=1.0).contains(&value) {
                    c.variance = value;
                } else {
                    e.warn(Topic::Range, at.span, "variance must lie between 0 and 1; the default is kept");
                }
                Ok(())
            }),
            "1/10000",
            "how much the colours of a pixel's rays may differ",
        ),
        Item::new(
            K::FocalPoint,
            Takes::Other("VECTOR", |e, c, _| {
                c.focal_point = Some(e.vector()?);
                Ok(())
            }),
            "",
            "a point that is in focus",
        ),
        Item::since(
            370,
            K::Bokeh,
            Takes::Other("{ pigment { … } }", |e, c, _| {
                e.open("bokeh")?;
                if !e.accept(K::Pigment)? {
                    return e.expected("a pigment");
                }
                c.bokeh = Some(Arc::new(e.pigment_block(Pigment::default())?));
                e.close("bokeh")
            }),
            "",
            "shape and colour of what is out of focus",
        ),
    ],
)
.with(&[&CAMERA_TYPES]);

fn blur_samples(e: &mut Evaluator<'_>, camera: &mut CameraStatement, at: Word) -> SourceResult<()> {
    let first = e.integer()?.clamp(0, 1 << 24) as u32;
    e.comma()?;
    let second = if e.starts_expression()? { Some(e.integer()?.clamp(0, 1 << 24) as u32) } else { None };
    camera.blur_samples = second.map_or([0, first], |most| [first, most]);
    if camera.blur_samples[0] > camera.blur_samples[1] {
        return e.error(at.span, "the smallest number of blur samples exceeds the largest");
    }
    Ok(())
}

impl Evaluator<'_> {
    /// `{ … }` after `camera`.
    pub(super) fn camera_block(&mut self) -> SourceResult<CameraStatement> {
        let span = self.span();
        self.open("camera")?;
        let pick = |v: &Value| if let Value::Camera(c) = v { Some((**c).clone()) } else { None };
        let mut camera = match self.take_declared(pick)? {
            Some(camera) => camera,
            None if self.orders_cameras() => {
                self.defaults.last_camera.clone().unwrap_or_else(|| self.defaults.camera.clone())
            }
            None => self.defaults.camera.clone(),
        };
        camera.span = span;
        self.camera_kind(&mut camera)?;
        while self.camera_item(&mut camera)? {
            self.comma()?;
        }
        let span = self.span();
        self.close_of(&CAMERA)?;
        if let Some(target) = camera.look_at
            && (target - camera.location).abs().max_element() <= COINCIDENT * camera.location.abs().max_element()
        {
            return self.error(span, "the camera's look_at is the same point as its location");
        }
        Ok(camera)
    }

    /// The type keyword, which must come first.
    fn camera_kind(&mut self, camera: &mut CameraStatement) -> SourceResult<bool> {
        let found = self.item_of(&CAMERA_TYPES, camera)?;
        if found && self.orders_cameras() && matches!(camera.kind, CameraKind::Orthographic) {
            let target = camera.look_at.unwrap_or(DVec3::Z);
            let scale = (target - camera.location).length() / camera.direction.length();
            camera.right *= scale;
            camera.up *= scale;
        }
        Ok(found)
    }

    fn mesh_camera(&mut self) -> SourceResult<MeshCamera> {
        self.open("mesh_camera")?;
        let span = self.span();
        let rays_per_pixel = self.integer()?.clamp(1, 1 << 16) as u32;
        self.comma()?;
        let distribution = self.integer()?;
        if !(0..=3).contains(&distribution) {
            return self.error(span, "a mesh camera has a distribution of 0, 1, 2 or 3");
        }
        if distribution >= 2 && rays_per_pixel != 1 {
            return self.error(span, "this mesh camera distribution takes one ray per pixel");
        }
        self.comma()?;
        let max_distance = if self.starts_expression()? { self.float()? } else { 0.0 };
        let mut meshes = Vec::new();
        let mut smooth = false;
        loop {
            self.comma()?;
            if let Some(mesh) = self.object()? {
                meshes.push(mesh);
            } else if self.accept(K::Smooth)? {
                smooth = true;
            } else {
                break;
            }
        }
        if meshes.is_empty() {
            return self.expected("a mesh");
        }
        self.close("mesh_camera")?;
        Ok(MeshCamera { rays_per_pixel, distribution: distribution as u8, max_distance, meshes, smooth })
    }

    fn camera_item(&mut self, camera: &mut CameraStatement) -> SourceResult<bool> {
        Ok(self.item_of(&CAMERA, camera)? || self.orders_cameras() && self.camera_kind(camera)?)
    }

    /// Whether the order of statements in a camera matters, as it did of old.
    fn orders_cameras(&self) -> bool {
        self.version < VERSION_OF_UNORDERED_CAMERAS
    }
}

fn camera_angle(e: &mut Evaluator<'_>, camera: &mut CameraStatement, at: Word) -> SourceResult<()> {
    let flat = camera.uses_flat_angle();
    if matches!(camera.kind, CameraKind::Orthographic) && !e.starts_expression()? {
        camera.angle_deg = Some(0.0);
        return Ok(());
    }
    let angle = e.float()?;
    if angle < 0.0 || (flat && angle >= 180.0) {
        let range = if flat { "between 0 and 180 degrees" } else { "0 or more" };
        return e.error(at.span, format!("the camera angle must be {range}"));
    }
    camera.angle_deg = Some(angle);
    if matches!(camera.kind, CameraKind::Spherical) {
        e.comma()?;
        if e.starts_expression()? {
            camera.vertical_angle_deg = Some(e.float()?);
        }
    }
    if e.orders_cameras() && matches!(camera.kind, CameraKind::Perspective) && angle > 0.0 {
        camera.set_angle(angle);
    }
    Ok(())
}

/// Two points this near to each other, as a share of their distance from the origin, have no direction between them: the
/// rounding of both is a fourth of it. POV-Ray's distance is 1e-5, whatever the scene's size.
const COINCIDENT: f64 = 4.0 * f64::EPSILON;
