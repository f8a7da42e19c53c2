//! `background`, `sky_sphere`, `fog` and `rainbow`.

use super::colors::COLORS;
use super::pattern_modifiers::TURBULENCE;
use super::table::{Block, Item, Takes};
use crate::diag::{SourceResult, Topic};
use crate::eval::{Evaluator, Value};
use crate::math::{Color, DVec3, Rgb, Transform};
use crate::scene::{Background, Blend, Fog, Pattern, PatternKind, Pigment, PigmentKind, Rainbow, SkySphere};
use crate::syntax::Keyword as K;
use std::sync::Arc;

pub(super) static FOG: Block<Fog> = Block::<Fog>::moved(
    "fog",
    "haze that hides what is far away",
    |_, fog, transform| fog.up = transform.vector(fog.up).normalize_or(DVec3::Y),
    &[
        Item::new(
            K::Distance,
            Takes::Float(|f| &mut f.distance),
            "0",
            "the way after which 37 percent of light is left",
        ),
        Item::new(
            K::FogType,
            Takes::Other("INTEGER", |e, f, at| {
                let kind = e.integer()?;
                if !(1..=2).contains(&kind) {
                    e.warn(Topic::Range, at.span, format!("there is no fog_type {kind}; type 1 is used"));
                }
                f.ground = kind == 2;
                Ok(())
            }),
            "1",
            "1 the same everywhere, 2 thinner with height",
        ),
        Item::new(K::FogOffset, Takes::Float(|f| &mut f.offset), "0", "height up to which ground fog is dense"),
        Item::new(K::FogAlt, Takes::Float(|f| &mut f.alt), "0", "height above that where a quarter is left"),
        Item::new(
            K::Up,
            Takes::Other("VECTOR", |e, f, _| {
                f.up = e.vector()?.normalize_or(DVec3::Y);
                Ok(())
            }),
            "y",
            "where height is measured to",
        ),
        Item::new(K::TurbDepth, Takes::Float(|f| &mut f.turb_depth), "0.5", "where along the ray turbulence is taken"),
    ],
)
.with(&[&COLORS, &TURBULENCE]);

pub(super) static RAINBOW: Block<Rainbow> = Block::new(
    "rainbow",
    "a bow in the sky",
    &[
        Item::new(K::Direction, Takes::Vector(|r| &mut r.direction), "", "where light comes from, as seen by the bow"),
        Item::new(K::Up, Takes::Vector(|r| &mut r.up), "y", "to the top of the bow"),
        Item::new(K::Angle, Takes::Float(|r| &mut r.angle_deg), "0", "between the direction and the bow, in degrees"),
        Item::new(K::Width, Takes::Float(|r| &mut r.width_deg), "0", "how wide it is, in degrees"),
        Item::new(K::Distance, Takes::Float(|r| &mut r.distance), "10000000", "how far away it is full"),
        Item::new(K::Jitter, Takes::Float(|r| &mut r.jitter), "0", "how much its angle varies at random"),
        Item::new(
            K::ArcAngle,
            Takes::Float(|r| r.arc_angle_deg.get_or_insert(0.0)),
            "180",
            "part of the circle that is seen, in degrees",
        ),
        Item::new(
            K::FalloffAngle,
            Takes::Float(|r| r.falloff_angle_deg.get_or_insert(0.0)),
            "180",
            "part of it that is at full strength",
        ),
        Item::spelt(
            K::ColourMap,
            K::ColorMap,
            Takes::Other("{ ENTRIES }", |e, r, _| {
                let map = Arc::new(Blend::Map(e.color_map()?));
                let along = Box::new(Pattern::new(PatternKind::Gradient(DVec3::X)));
                r.pigment = Arc::new(Pigment { kind: PigmentKind::Colors(along, map), ..Pigment::default() });
                Ok(())
            }),
            "",
            "its colours, from the inside to the outside",
        ),
    ],
);

pub(super) static SKY_SPHERE: Block<SkySphere> = Block::moved(
    "sky_sphere",
    "pigments that are seen where nothing else is",
    |_, sky, transform| sky.transform = sky.transform.then(transform),
    &[
        Item::new(
            K::Pigment,
            Takes::Other("{ PIGMENT }", |e, sky, _| {
                sky.pigments.push(Arc::new(e.pigment_block(Pigment::default())?));
                Ok(())
            }),
            "",
            "its colours by direction; later ones are seen through by what they let through",
        ),
        Item::since(370, K::Emission, Takes::Rgb(|sky| &mut sky.emission), "rgb 1", "factor of its colours"),
    ],
);

impl Evaluator<'_> {
    /// `{ COLOUR }` after `background`.
    pub(super) fn background(&mut self) -> SourceResult<Background> {
        self.open("background")?;
        let color = if self.at_punct('}')? { Color::BLACK } else { self.color()? };
        self.close("background")?;
        Ok(Background { color, legacy: self.effective_version() < 370 })
    }

    /// `{ … }` after `sky_sphere`.
    pub(super) fn sky_sphere(&mut self) -> SourceResult<SkySphere> {
        let span = self.span();
        self.open("sky_sphere")?;
        let pick = |v: &Value| if let Value::SkySphere(s) = v { Some((**s).clone()) } else { None };
        let mut sky = self.take_declared(pick)?.unwrap_or(SkySphere {
            span,
            pigments: Vec::new(),
            emission: Rgb::ONE,
            transform: Transform::IDENTITY,
        });
        sky.span = span;
        self.comma()?;
        self.items_of(&SKY_SPHERE, &mut sky)?;
        if sky.pigments.is_empty() {
            return self.expected("a pigment for the sky_sphere");
        }
        self.close_of(&SKY_SPHERE)?;
        Ok(sky)
    }

    /// `{ … }` after `fog`.
    pub(super) fn fog(&mut self) -> SourceResult<Fog> {
        let span = self.span();
        self.open("fog")?;
        let pick = |v: &Value| if let Value::Fog(f) = v { Some((**f).clone()) } else { None };
        let mut fog = self.take_declared(pick)?.unwrap_or(Fog::new(span));
        fog.span = span;
        loop {
            self.comma()?;
            if self.item_of(&FOG, &mut fog)? || self.item_of(&TURBULENCE, &mut fog.turbulence)? {
                continue;
            }
            if self.at_color()? {
                fog.color = self.color()?;
            } else if self.starts_expression()? {
                fog.distance = self.float()?;
            } else {
                break;
            }
        }
        self.close_of(&FOG)?;
        Ok(fog)
    }

    /// `{ … }` after `rainbow`.
    pub(super) fn rainbow(&mut self) -> SourceResult<Rainbow> {
        let span = self.span();
        self.open("rainbow")?;
        let pick = |v: &Value| if let Value::Rainbow(r) = v { Some((**r).clone()) } else { None };
        let mut rainbow = self.take_declared(pick)?.unwrap_or_else(|| Rainbow::new(span));
        rainbow.span = span;
        self.items_of(&RAINBOW, &mut rainbow)?;
        self.close_of(&RAINBOW)?;
        let Some(direction) = rainbow.direction.try_normalize() else {
            return self.error(span, "a rainbow needs a direction");
        };
        let Some(side) = rainbow.up.cross(direction).try_normalize() else {
            return self.error(span, "a rainbow's up vector must not point along its direction");
        };
        rainbow.direction = direction;
        rainbow.up = direction.cross(side);
        if let (Some(arc), Some(falloff)) = (rainbow.arc_angle_deg, rainbow.falloff_angle_deg)
            && arc < falloff
        {
            return self.error(span, "a rainbow's arc_angle must not be smaller than its falloff_angle");
        }
        Ok(rainbow)
    }
}
