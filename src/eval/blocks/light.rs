//! `light_source { … }` and `light_group { … }`.

use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::math::{DVec3, Transform};
use crate::scene::{AreaLight, LightKind, LightSource, Object, PhotonFlags, Shape};
use crate::syntax::Keyword as K;
use std::sync::Arc;

const NOT_ADAPTIVE: u32 = AreaLight::NOT_ADAPTIVE;

/// Modifiers that refer to each other and are put together at the closing brace.
struct Draft {
    light: LightSource,
    adaptive: u32,
    jitter: bool,
    circular: bool,
    orient: bool,
    area_illumination: bool,
}

impl Evaluator<'_> {
    /// The inside of a light source after its opening brace, up to the closing brace.
    pub(super) fn light_source(&mut self) -> SourceResult<Shape> {
        let location = self.vector()?;
        self.comma()?;
        let color = self.rgb_only("a light's colour")?;
        let light = LightSource {
            location,
            color,
            kind: LightKind::Point,
            parallel: false,
            axis: DVec3::Z,
            point_at: DVec3::Z,
            fade_distance: 0.0,
            fade_power: 0.0,
            area: None,
            looks_like: None,
            projected_through: None,
            media_attenuation: false,
            media_interaction: true,
            photons: PhotonFlags::default(),
        };
        let mut draft = Draft {
            light,
            adaptive: NOT_ADAPTIVE,
            jitter: false,
            circular: false,
            orient: false,
            area_illumination: false,
        };
        while self.light_item(&mut draft)? {}
        let mut light = draft.light;
        light.axis = (light.point_at - light.location).normalize_or(DVec3::Z);
        if let Some(area) = &mut light.area {
            area.adaptive = draft.adaptive;
            area.jitter = draft.jitter;
            area.circular = draft.circular || draft.orient;
            area.orient = draft.orient;
            area.area_illumination = draft.area_illumination;
            let span = self.span();
            if draft.circular && (area.size1 < 2 || area.size2 < 2) {
                return self.error(span, "a circular area light needs at least two samples along each axis");
            }
            let overrides = &self.options.overrides;
            (area.size1, area.size2) = (overrides.area_samples(area.size1), overrides.area_samples(area.size2));
        } else if draft.circular || draft.orient {
            let span = self.span();
            self.warn(
                Topic::Ignored,
                span,
                "'circular' and 'orient' have no effect on a light that is not an area light",
            );
        }
        if light.area.is_none() && draft.area_illumination {
            // On its own the word lights both sides of surfaces, which a one-sample area light expresses.
            light.area = Some(AreaLight {
                axis1: DVec3::ZERO,
                axis2: DVec3::ZERO,
                size1: 1,
                size2: 1,
                adaptive: NOT_ADAPTIVE,
                jitter: false,
                circular: false,
                orient: false,
                area_illumination: true,
            });
        }
        Ok(Shape::LightSource(Arc::new(light)))
    }

    fn light_item(&mut self, draft: &mut Draft) -> SourceResult<bool> {
        self.comma()?;
        if let Some(transform) = self.transformation()? {
            draft.light.axis = (draft.light.point_at - draft.light.location).normalize_or(DVec3::Z);
            draft.light.apply(&transform);
            return Ok(true);
        }
        let span = self.span();
        let Some(keyword) = self.keyword()? else { return Ok(false) };
        let light = &mut draft.light;
        match keyword {
            K::Spotlight => {
                self.next()?;
                light.kind = LightKind::Spot { radius_deg: 30.0, falloff_deg: 45.0, tightness: 0.0 };
            }
            K::Cylinder => {
                self.next()?;
                light.kind = LightKind::Cylinder { radius: 0.75, falloff: 1.0, tightness: 0.0 };
                light.parallel = true;
            }
            K::Shadowless => {
                self.next()?;
                light.kind = LightKind::Shadowless;
            }
            K::Parallel => {
                self.next()?;
                light.parallel = true;
            }
            K::PointAt => {
                self.next()?;
                light.point_at = self.vector()?;
            }
            K::Radius | K::Falloff | K::Tightness => {
                self.next()?;
                let value = self.float()?;
                match (&mut light.kind, keyword) {
                    (LightKind::Spot { radius_deg: field, .. }, K::Radius)
                    | (LightKind::Spot { falloff_deg: field, .. }, K::Falloff)
                    | (LightKind::Spot { tightness: field, .. }, K::Tightness)
                    | (LightKind::Cylinder { radius: field, .. }, K::Radius)
                    | (LightKind::Cylinder { falloff: field, .. }, K::Falloff)
                    | (LightKind::Cylinder { tightness: field, .. }, K::Tightness) => *field = value,
                    _ => {
                        let word = keyword.word();
                        return self.error(span, format!("'{word}' belongs after 'spotlight' or 'cylinder'"));
                    }
                }
            }
            K::FadeDistance => {
                self.next()?;
                light.fade_distance = self.float()?;
            }
            K::FadePower => {
                self.next()?;
                light.fade_power = self.float()?;
            }
            K::MediaAttenuation => {
                self.next()?;
                light.media_attenuation = self.optional_bool()?;
            }
            K::MediaInteraction => {
                self.next()?;
                light.media_interaction = self.optional_bool()?;
            }
            K::LooksLike => {
                self.next()?;
                self.looks_like(light)?;
            }
            K::ProjectedThrough => {
                self.next()?;
                light.projected_through = Some(self.wrapped_object("projected_through", &Transform::IDENTITY)?);
            }
            K::Photons => {
                self.next()?;
                light.photons = self.photons_block(light.photons)?;
            }
            K::ColorMap | K::ColourMap => {
                self.next()?;
                let map = self.color_map()?;
                light.color = map.iter().map(|entry| entry.item.rgb * entry.value).sum();
            }
            _ => return self.area_item(keyword, draft),
        }
        Ok(true)
    }

    fn area_item(&mut self, keyword: K, draft: &mut Draft) -> SourceResult<bool> {
        let span = self.span();
        match keyword {
            K::AreaLight => {
                self.next()?;
                let axis1 = self.vector()?;
                self.comma()?;
                let axis2 = self.vector()?;
                self.comma()?;
                let size1 = self.integer()?;
                self.comma()?;
                let size2 = self.integer()?;
                if size1 < 1 || size2 < 1 {
                    return self.error(span, "an area light needs at least one sample along each axis");
                }
                draft.light.area = Some(AreaLight {
                    axis1,
                    axis2,
                    size1: size1.min(4096) as u32,
                    size2: size2.min(4096) as u32,
                    adaptive: NOT_ADAPTIVE,
                    jitter: false,
                    circular: false,
                    orient: false,
                    area_illumination: false,
                });
            }
            K::Adaptive => {
                self.next()?;
                draft.adaptive = self.integer()?.clamp(0, i64::from(NOT_ADAPTIVE)) as u32;
            }
            K::Jitter => {
                self.next()?;
                draft.jitter = true;
            }
            K::Circular => {
                self.next()?;
                draft.circular = true;
            }
            K::Orient => {
                self.next()?;
                draft.orient = true;
            }
            K::AreaIllumination => {
                self.next()?;
                draft.area_illumination = self.optional_bool()?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The object is moved to the light's location as it is now; what follows inside the braces
    /// then turns it about the origin, as in POV-Ray.
    fn looks_like(&mut self, light: &mut LightSource) -> SourceResult<()> {
        let span = self.span();
        if light.looks_like.is_some() {
            return self.error(span, "a light has only one looks_like");
        }
        let to_light = Transform::translation(light.location);
        light.looks_like = Some(self.wrapped_object("looks_like", &to_light)?);
        Ok(())
    }

    /// `{ OBJECT modifiers }`; the object is moved by `placement` before the modifiers.
    fn wrapped_object(&mut self, what: &str, placement: &Transform) -> SourceResult<Arc<Object>> {
        self.open(what)?;
        let Some(object) = self.object()? else { return self.expected("an object") };
        let mut object = (*object).clone();
        object.apply(placement);
        self.object_modifiers(&mut object)?;
        self.close(what)?;
        Ok(Arc::new(object))
    }

    /// The inside of a light group after its opening brace, up to the closing brace.
    pub(super) fn light_group(&mut self, object: &mut Object) -> SourceResult<()> {
        let (mut children, mut global_lights) = (Vec::new(), false);
        loop {
            if let Some(child) = self.object()? {
                children.push(child);
            } else if let Some(transform) = self.transformation()? {
                object.apply(&transform);
            } else if self.accept(K::GlobalLights)? {
                global_lights = self.optional_bool()?;
            } else if self.accept(K::Photons)? {
                object.rare.photons = self.photons_block(object.rare.photons)?;
            } else {
                break;
            }
        }
        object.shape = Shape::LightGroup { children: children.into(), global_lights };
        Ok(())
    }
}
