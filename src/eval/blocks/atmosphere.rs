//! `background`, `sky_sphere`, `fog` and `rainbow`.

use crate::diag::{SourceResult, Topic};
use crate::eval::{Evaluator, Value};
use crate::math::{Color, DVec3, Rgb, Transform};
use crate::scene::{Background, Blend, Fog, Pattern, PatternKind, Pigment, PigmentKind, Rainbow, SkySphere};
use crate::syntax::Keyword as K;
use std::sync::Arc;

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
        loop {
            self.comma()?;
            if let Some(transform) = self.transformation()? {
                sky.transform = sky.transform.then(&transform);
            } else if self.accept(K::Pigment)? {
                sky.pigments.push(Arc::new(self.pigment_block(Pigment::default())?));
            } else if self.accept(K::Emission)? {
                sky.emission = self.rgb_only("emission")?;
            } else {
                break;
            }
        }
        if sky.pigments.is_empty() {
            return self.expected("a pigment for the sky_sphere");
        }
        self.close("sky_sphere")?;
        Ok(sky)
    }

    /// `{ … }` after `fog`.
    pub(super) fn fog(&mut self) -> SourceResult<Fog> {
        let span = self.span();
        self.open("fog")?;
        let pick = |v: &Value| if let Value::Fog(f) = v { Some((**f).clone()) } else { None };
        let mut fog = self.take_declared(pick)?.unwrap_or(Fog {
            span,
            ground: false,
            distance: 0.0,
            color: Color::BLACK,
            offset: 0.0,
            alt: 0.0,
            up: DVec3::Y,
            turbulence: None,
            turb_depth: 0.5,
        });
        fog.span = span;
        loop {
            self.comma()?;
            if let Some(transform) = self.transformation()? {
                fog.up = transform.vector(fog.up).normalize_or(DVec3::Y);
                continue;
            }
            let Some(keyword) = self.keyword()? else {
                if self.at_color()? {
                    fog.color = self.color()?;
                } else if self.starts_expression()? {
                    fog.distance = self.float()?;
                } else {
                    break;
                }
                continue;
            };
            if !self.fog_item(keyword, &mut fog)? {
                break;
            }
        }
        self.close("fog")?;
        Ok(fog)
    }

    fn fog_item(&mut self, keyword: K, fog: &mut Fog) -> SourceResult<bool> {
        if self.turbulence_item(keyword, &mut fog.turbulence)? {
            return Ok(true);
        }
        let span = self.span();
        let target = match keyword {
            K::Distance => &mut fog.distance,
            K::FogOffset => &mut fog.offset,
            K::FogAlt => &mut fog.alt,
            K::TurbDepth => &mut fog.turb_depth,
            K::FogType => {
                self.next()?;
                let kind = self.integer()?;
                if !(1..=2).contains(&kind) {
                    self.warn(Topic::Range, span, format!("there is no fog_type {kind}; type 1 is used"));
                }
                fog.ground = kind == 2;
                return Ok(true);
            }
            K::Up => {
                self.next()?;
                fog.up = self.vector()?.normalize_or(DVec3::Y);
                return Ok(true);
            }
            _ if self.at_color()? => {
                fog.color = self.color()?;
                return Ok(true);
            }
            _ if self.starts_expression()? => {
                fog.distance = self.float()?;
                return Ok(true);
            }
            _ => return Ok(false),
        };
        self.next()?;
        *target = self.float()?;
        Ok(true)
    }

    /// `{ … }` after `rainbow`.
    pub(super) fn rainbow(&mut self) -> SourceResult<Rainbow> {
        let span = self.span();
        self.open("rainbow")?;
        let pick = |v: &Value| if let Value::Rainbow(r) = v { Some((**r).clone()) } else { None };
        let mut rainbow = self.take_declared(pick)?.unwrap_or_else(|| Rainbow {
            span,
            direction: DVec3::ZERO,
            up: DVec3::Y,
            angle_deg: 0.0,
            width_deg: 0.0,
            distance: 1e7, // POV-Ray's default
            jitter: 0.0,
            arc_angle_deg: None,
            falloff_angle_deg: None,
            pigment: Arc::new(Pigment::solid(Color { transmit: 1.0, ..Color::BLACK })),
        });
        rainbow.span = span;
        while let Some(keyword) = self.keyword()? {
            if !self.rainbow_item(keyword, &mut rainbow)? {
                break;
            }
            self.comma()?;
        }
        self.close("rainbow")?;
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

    fn rainbow_item(&mut self, keyword: K, rainbow: &mut Rainbow) -> SourceResult<bool> {
        let target = match keyword {
            K::Angle => &mut rainbow.angle_deg,
            K::Width => &mut rainbow.width_deg,
            K::Distance => &mut rainbow.distance,
            K::Jitter => &mut rainbow.jitter,
            K::ArcAngle => rainbow.arc_angle_deg.get_or_insert(0.0),
            K::FalloffAngle => rainbow.falloff_angle_deg.get_or_insert(0.0),
            K::Direction => {
                self.next()?;
                rainbow.direction = self.vector()?;
                return Ok(true);
            }
            K::Up => {
                self.next()?;
                rainbow.up = self.vector()?;
                return Ok(true);
            }
            K::ColorMap | K::ColourMap => {
                self.next()?;
                let map = Arc::new(Blend::Map(self.color_map()?));
                let along = Box::new(Pattern::new(PatternKind::Gradient(DVec3::X)));
                rainbow.pigment = Arc::new(Pigment { kind: PigmentKind::Colors(along, map), ..Pigment::default() });
                return Ok(true);
            }
            _ => return Ok(false),
        };
        self.next()?;
        *target = self.float()?;
        Ok(true)
    }
}
