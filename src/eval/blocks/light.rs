//! `light_source { … }` and `light_group { … }`.

use super::modifiers::MODIFIERS;
use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::math::{DVec3, Transform};
use crate::scene::{AreaLight, LightKind, LightSource, Object, Shape};
use crate::syntax::Keyword as K;
use std::sync::Arc;

const NOT_ADAPTIVE: u32 = AreaLight::NOT_ADAPTIVE;

/// Modifiers that refer to each other and are put together at the closing brace.
pub(super) struct Draft {
    light: LightSource,
    adaptive: u32,
    jitter: bool,
    circular: bool,
    orient: bool,
    area_illumination: bool,
}

pub(super) static LIGHT_SOURCE: Block<Draft> = Block::<Draft>::moved(
    "light_source",
    "a light",
    |_, draft, transform| {
        draft.light.axis = (draft.light.point_at - draft.light.location).normalize_or(DVec3::Z);
        draft.light.apply(transform);
    },
    &[
        Item::new(
            K::Spotlight,
            Takes::Nothing(|d| d.light.kind = LightKind::Spot { radius_deg: 30.0, falloff_deg: 45.0, tightness: 0.0 }),
            "",
            "a cone of light",
        ),
        Item::new(
            K::Cylinder,
            Takes::Nothing(|d| {
                d.light.kind = LightKind::Cylinder { radius: 0.75, falloff: 1.0, tightness: 0.0 };
                d.light.parallel = true;
            }),
            "",
            "a beam of light",
        ),
        Item::new(
            K::Shadowless,
            Takes::Nothing(|d| d.light.kind = LightKind::Shadowless),
            "",
            "no shadows, no highlights",
        ),
        Item::since(
            350,
            K::Parallel,
            Takes::Nothing(|d| d.light.parallel = true),
            "",
            "parallel light, as from the sun",
        ),
        Item::new(K::PointAt, Takes::Vector(|d| &mut d.light.point_at), "z", "where a cone or beam points"),
        Item::new(
            K::Radius,
            Takes::Other("FLOAT", cone),
            "30",
            "of full light: half an angle in degrees; 0.75 in a cylinder",
        ),
        Item::new(
            K::Falloff,
            Takes::Other("FLOAT", cone),
            "45",
            "of any light: half an angle in degrees; 1 in a cylinder",
        ),
        Item::new(K::Tightness, Takes::Other("FLOAT", cone), "0", "how fast light falls off from the middle"),
        Item::new(
            K::FadeDistance,
            Takes::Float(|d| &mut d.light.fade_distance),
            "0",
            "distance at which it is as bright as its colour says",
        ),
        Item::new(
            K::FadePower,
            Takes::Float(|d| &mut d.light.fade_power),
            "0",
            "power of the distance by which it fades; 2 in nature",
        ),
        Item::new(
            K::MediaAttenuation,
            Takes::Switch(|d| &mut d.light.media_attenuation),
            "off",
            "whether media weaken it",
        ),
        Item::new(
            K::MediaInteraction,
            Takes::Switch(|d| &mut d.light.media_interaction),
            "on",
            "whether media scatter it",
        ),
        Item::new(
            K::LooksLike,
            Takes::Other("{ OBJECT }", |e, d, _| e.looks_like(&mut d.light)),
            "",
            "an object at its place that casts no shadow of it",
        ),
        Item::since(
            350,
            K::ProjectedThrough,
            Takes::Other("{ OBJECT }", |e, d, _| {
                d.light.projected_through = Some(e.wrapped_object("projected_through", &Transform::IDENTITY)?);
                Ok(())
            }),
            "",
            "an object through which alone it shines",
        ),
        Item::since(
            350,
            K::Photons,
            Takes::Other("{ items }", |e, d, _| {
                d.light.photons = e.photons_block(d.light.photons)?;
                Ok(())
            }),
            "",
            "whether photons are shot",
        ),
        Item::spelt(
            K::ColourMap,
            K::ColorMap,
            Takes::Other("{ ENTRIES }", |e, d, _| {
                let map = e.color_map()?;
                d.light.color = map.iter().map(|entry| entry.item.rgb * entry.value).sum();
                Ok(())
            }),
            "",
            "its colour as a sum",
        ),
        Item::new(
            K::AreaLight,
            Takes::Other("VECTOR, VECTOR, INTEGER, INTEGER", area_light),
            "",
            "a grid of lights along two edges, for soft shadows",
        ),
        Item::new(
            K::Adaptive,
            Takes::Other("INTEGER", |e, d, _| {
                d.adaptive = e.integer()?.clamp(0, i64::from(NOT_ADAPTIVE)) as u32;
                Ok(())
            }),
            "",
            "level from which lights of the grid are left out between equal ones",
        ),
        Item::new(K::Jitter, Takes::Nothing(|d| d.jitter = true), "", "lights of the grid are moved at random"),
        Item::since(350, K::Circular, Takes::Nothing(|d| d.circular = true), "", "a disc instead of a rectangle"),
        Item::since(350, K::Orient, Takes::Nothing(|d| d.orient = true), "", "turned towards each point"),
        Item::since(
            370,
            K::AreaIllumination,
            Takes::Switch(|d| &mut d.area_illumination),
            "off",
            "the whole grid shines, not only its middle",
        ),
    ],
)
.with(&[&MODIFIERS]);

pub(super) static LIGHT_GROUP: Block<Object> = Block::<Object>::moved(
    "light_group",
    "objects and the lights that light only them",
    |_, group, transform| group.apply(transform),
    &[
        Item::new(
            K::GlobalLights,
            Takes::Other("[BOOL]", |e, group, _| {
                let on = e.optional_bool()?;
                if let Shape::LightGroup { global_lights, .. } = &mut group.shape {
                    *global_lights = on;
                }
                Ok(())
            }),
            "off",
            "whether lights outside of it light them, too",
        ),
        Item::new(
            K::Photons,
            Takes::Other("{ items }", |e, group, _| {
                group.rare.photons = e.photons_block(group.rare.photons)?;
                Ok(())
            }),
            "",
            "what photons do at its objects",
        ),
    ],
)
.with(&[&MODIFIERS]);

impl Evaluator<'_> {
    /// The inside of a light source after its opening brace, up to the closing brace.
    pub(super) fn light_source(&mut self) -> SourceResult<Shape> {
        let location = self.vector()?;
        self.comma()?;
        let color = self.rgb_only("a light's colour")?;
        let light = LightSource::new(location, color);
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
        self.item_of(&LIGHT_SOURCE, draft)
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
        let mut group = Vec::new();
        loop {
            if let Some(child) = self.object()? {
                group.push(child);
            } else if !self.item_of(&LIGHT_GROUP, object)? {
                break;
            }
        }
        if let Shape::LightGroup { children, .. } = &mut object.shape {
            *children = group.into();
        }
        Ok(())
    }
}

/// `radius`, `falloff` and `tightness`, which mean something else in a cone and in a beam.
fn cone(e: &mut Evaluator<'_>, draft: &mut Draft, at: Word) -> SourceResult<()> {
    let value = e.float()?;
    match (&mut draft.light.kind, at.word) {
        (LightKind::Spot { radius_deg: field, .. }, K::Radius)
        | (LightKind::Spot { falloff_deg: field, .. }, K::Falloff)
        | (LightKind::Spot { tightness: field, .. }, K::Tightness)
        | (LightKind::Cylinder { radius: field, .. }, K::Radius)
        | (LightKind::Cylinder { falloff: field, .. }, K::Falloff)
        | (LightKind::Cylinder { tightness: field, .. }, K::Tightness) => *field = value,
        _ => {
            let word = at.word.word();
            return e.error(at.span, format!("'{word}' belongs after 'spotlight' or 'cylinder'"));
        }
    }
    Ok(())
}

fn area_light(e: &mut Evaluator<'_>, draft: &mut Draft, at: Word) -> SourceResult<()> {
    let axis1 = e.vector()?;
    e.comma()?;
    let axis2 = e.vector()?;
    e.comma()?;
    let size1 = e.integer()?;
    e.comma()?;
    let size2 = e.integer()?;
    if size1 < 1 || size2 < 1 {
        return e.error(at.span, "an area light needs at least one sample along each axis");
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
    Ok(())
}
