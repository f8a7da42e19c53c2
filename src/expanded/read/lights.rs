//! Light sources, interiors and media.

use super::objects::photons;
use super::reader::{Reader, Value, misplaced};
use super::tree::{Items, Node, Read, Rule, place, wrong};
use crate::math::{DVec3, Transform};
use crate::scene::{AreaLight, Interior, LightKind, LightSource, Media, Shape};
use std::sync::Arc;

impl<'a> Reader<'a> {
    /// A light source without its modifiers.
    pub(super) fn light(&mut self, items: &mut Items<'a>) -> Read<Shape> {
        let mut light = LightSource::new(items.vector()?, items.rgb()?);
        let mut axis = None;
        while items.peek().is_some_and(|rule| rule != Rule::modifiers) {
            let item = items.node()?;
            if item.as_rule() == Rule::axis_note {
                axis = Some(Items::of(item).vector()?);
            } else {
                self.light_item(item, &mut light)?;
            }
        }
        light.axis = axis.unwrap_or_else(|| (light.point_at - light.location).normalize_or(DVec3::Z));
        Ok(Shape::LightSource(Arc::new(light)))
    }

    fn light_item(&mut self, node: Node<'a>, light: &mut LightSource) -> Read<()> {
        let mut items = Items::of(node.clone());
        match node.as_rule() {
            Rule::spotlight => {
                let cylinder = items.word()? == "cylinder";
                let (radius, falloff, tightness) = (items.number()?, items.number()?, items.number()?);
                light.parallel |= cylinder;
                light.kind = if cylinder {
                    LightKind::Cylinder { radius, falloff, tightness }
                } else {
                    LightKind::Spot { radius_deg: radius, falloff_deg: falloff, tightness }
                };
            }
            Rule::light_word if node.as_str() == "parallel" => light.parallel = true,
            Rule::light_word => light.kind = LightKind::Shadowless,
            Rule::point_at => light.point_at = items.vector()?,
            Rule::light_number => {
                let distance = items.word()? == "fade_distance";
                *(if distance { &mut light.fade_distance } else { &mut light.fade_power }) = items.number()?;
            }
            Rule::light_switch => {
                let attenuation = items.word()? == "media_attenuation";
                let on = items.switch();
                *(if attenuation { &mut light.media_attenuation } else { &mut light.media_interaction }) = on;
            }
            Rule::area_light => light.area = Some(self.area_light(items)?),
            Rule::area_alone => light.area = items.switch().then_some(ALONE),
            Rule::photons => light.photons = photons(node)?,
            Rule::looks_like => {
                let object = items.node()?;
                let mut object = self.object(object)?;
                let moved = light.location + Items::of(items.node()?).vector()?;
                if moved != DVec3::ZERO {
                    Arc::make_mut(&mut object).apply(&Transform::translation(moved));
                }
                light.looks_like = Some(object);
            }
            Rule::projected_through => {
                let object = items.node()?;
                light.projected_through = Some(self.object(object)?);
            }
            _ => return misplaced(&node),
        }
        Ok(())
    }

    fn area_light(&self, mut items: Items<'a>) -> Read<AreaLight> {
        let overrides = &self.options.overrides;
        let mut area = AreaLight {
            axis1: items.vector()?,
            axis2: items.vector()?,
            size1: overrides.area_samples(items.whole_within(1, 4096)?),
            size2: overrides.area_samples(items.whole_within(1, 4096)?),
            area_illumination: false,
            ..ALONE
        };
        for item in items {
            let mut inner = Items::of(item.clone());
            match inner.peek() {
                Some(Rule::number) => area.adaptive = inner.whole_within(0, AreaLight::NOT_ADAPTIVE)?,
                Some(Rule::area_alone) => area.area_illumination = Items::of(inner.node()?).switch(),
                _ => match inner.word()? {
                    "jitter" => area.jitter = true,
                    "circular" => area.circular = true,
                    _ => (area.circular, area.orient) = (true, true),
                },
            }
        }
        Ok(area)
    }

    /// `interior { … }`.
    pub(super) fn interior(&mut self, node: Node<'a>) -> Read<Arc<Interior>> {
        let mut items = Items::of(node.clone());
        if let Some(name) = items.optional(Rule::identifier) {
            let pick = |v: &Value| if let Value::Interior(i) = v { Some(Arc::clone(i)) } else { None };
            return self.known(&name, "interior", pick);
        }
        let mut interior = Interior { span: place(&node), ..Interior::default() };
        for item in items {
            match item.as_rule() {
                Rule::media => interior.media.push(self.media(item)?),
                Rule::fade_color => interior.fade_color = Items::of(item).rgb()?,
                _ => interior_number(item, &mut interior)?,
            }
        }
        Ok(Arc::new(interior))
    }

    /// `media { … }`.
    pub(super) fn media(&mut self, node: Node<'a>) -> Read<Media> {
        let mut media = Media::new(place(&node));
        for item in node.into_inner() {
            if item.as_rule() == Rule::density {
                media.density.push(self.density(item)?);
            } else {
                media_item(item, &mut media)?;
            }
        }
        Ok(media)
    }
}

/// `area_illumination` without `area_light`, as an area light without extent.
const ALONE: AreaLight = AreaLight {
    axis1: DVec3::ZERO,
    axis2: DVec3::ZERO,
    size1: 1,
    size2: 1,
    adaptive: AreaLight::NOT_ADAPTIVE,
    jitter: false,
    circular: false,
    orient: false,
    area_illumination: true,
};

fn interior_number(node: Node<'_>, interior: &mut Interior) -> Read<()> {
    let mut items = Items::of(node);
    match items.word()? {
        "ior" => interior.ior = items.number()?,
        "caustics" => interior.caustics = items.number()?,
        "dispersion" => interior.dispersion = items.number()?,
        "dispersion_samples" => interior.dispersion_samples = items.whole_within(2, u32::MAX)?,
        "fade_distance" => interior.fade_distance = items.number()?,
        "fade_power" => interior.fade_power = items.number()?,
        _ => interior.refraction = items.number()?,
    }
    Ok(())
}

fn media_item(node: Node<'_>, media: &mut Media) -> Read<()> {
    let mut items = Items::of(node.clone());
    match node.as_rule() {
        Rule::samples => {
            media.samples = [items.whole_within(1, u32::MAX)?, items.whole_within(1, u32::MAX)?];
            if media.samples[1] < media.samples[0] {
                return wrong(&node, "the largest number of samples is below the smallest");
            }
        }
        Rule::media_color => {
            let field = if items.word()? == "absorption" { &mut media.absorption } else { &mut media.emission };
            *field = items.rgb()?;
        }
        Rule::scattering => {
            let (kind, color) = (items.whole_within(1, 5)? as u8, items.rgb()?);
            let eccentricity = match items.optional(Rule::eccentricity) {
                Some(eccentricity) => Items::of(eccentricity).number()?,
                None => 0.0,
            };
            media.scattering = (kind, color, eccentricity, items.number()?);
        }
        Rule::collect => media.collect = items.switch(),
        Rule::media_number => media_number(&node, items, media)?,
        _ => return misplaced(&node),
    }
    Ok(())
}

fn media_number(node: &Node<'_>, mut items: Items<'_>, media: &mut Media) -> Read<()> {
    match items.word()? {
        "method" => media.method = items.whole_within(1, 3)? as u8,
        "intervals" => media.intervals = items.whole_within(1, u32::MAX)?,
        "aa_level" => media.aa_level = items.whole_within(1, u32::MAX)?,
        "jitter" => media.jitter = items.number()?,
        "aa_threshold" => {
            media.aa_threshold = items.number()?;
            if media.aa_threshold <= 0.0 {
                return wrong(node, "aa_threshold must be positive");
            }
        }
        "confidence" => {
            media.confidence = items.number()?;
            if !(0.0..1.0).contains(&media.confidence) {
                return wrong(node, "confidence must be at least 0 and less than 1");
            }
        }
        "variance" => media.variance = items.number()?,
        _ => media.ratio = items.number()?,
    }
    Ok(())
}
