//! `finish { … }`.

use crate::diag::{SourceResult, Topic};
use crate::eval::{Evaluator, Value};
use crate::math::Rgb;
use crate::scene::Finish;
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// Which terms were written with `albedo`, to be scaled at the closing brace.
#[derive(Default)]
struct Albedo {
    diffuse: bool,
    phong: bool,
    specular: bool,
}

impl Evaluator<'_> {
    /// [`finish_block`](Self::finish_block), as one with the last that was written if they are alike: loops write the
    /// same one for thousands of objects.
    pub(super) fn shared_finish_block(&mut self, start: Finish) -> SourceResult<Arc<Finish>> {
        let finish = self.finish_block(start)?;
        match &self.last_finish {
            Some(last) if **last == finish => Ok(Arc::clone(last)),
            _ => Ok(Arc::clone(self.last_finish.insert(Arc::new(finish)))),
        }
    }

    /// `{ … }` after `finish`, starting from `start`.
    pub(super) fn finish_block(&mut self, start: Finish) -> SourceResult<Finish> {
        self.open("finish")?;
        let pick = |v: &Value| if let Value::Finish(f) = v { Some(f.clone()) } else { None };
        let mut finish = self.take_declared(pick)?.map_or(start, |f| (*f).clone());
        let mut albedo = Albedo::default();
        while let Some(keyword) = self.keyword()? {
            if !self.finish_item(keyword, &mut finish, &mut albedo)? {
                break;
            }
            self.comma()?;
        }
        self.close("finish")?;
        // Source: shading facts, section 5.1; reflectances integrate to the given number.
        finish.raw_diffuse = finish.diffuse;
        if albedo.diffuse {
            let scale = (finish.brilliance + 1.0) / 2.0;
            finish.diffuse *= scale;
            finish.diffuse_back *= scale;
        }
        if albedo.phong {
            finish.phong *= (finish.phong_size + 1.0) / 2.0;
        }
        if albedo.specular {
            let e = finish.specular_exponent;
            finish.specular *= (e + 2.0) / (4.0 * (2.0 - (-e / 2.0).exp2()));
        }
        Ok(finish)
    }

    fn finish_item(&mut self, keyword: K, finish: &mut Finish, albedo: &mut Albedo) -> SourceResult<bool> {
        let span = self.span();
        let target = match keyword {
            K::Brilliance => &mut finish.brilliance,
            K::Crand => &mut finish.crand,
            K::PhongSize => &mut finish.phong_size,
            K::ReflectionExponent => &mut finish.reflection_exponent,
            _ => return self.finish_term(keyword, finish, albedo),
        };
        self.next()?;
        *target = self.float()? as f32;
        if keyword == K::ReflectionExponent && *target == 0.0 {
            return self.error(span, "reflection_exponent must not be 0");
        }
        Ok(true)
    }

    fn finish_term(&mut self, keyword: K, finish: &mut Finish, albedo: &mut Albedo) -> SourceResult<bool> {
        let span = self.span();
        match keyword {
            K::Ambient => {
                self.next()?;
                finish.ambient = self.rgb_only("ambient")?;
            }
            K::Emission => {
                self.next()?;
                finish.emission = self.rgb_only("emission")?;
            }
            K::Diffuse => {
                self.next()?;
                albedo.diffuse = self.accept(K::Albedo)?;
                finish.diffuse = self.float()? as f32;
                self.comma()?;
                finish.diffuse_back = if self.starts_expression()? { self.float()? as f32 } else { 0.0 };
            }
            K::Phong => {
                self.next()?;
                albedo.phong = self.accept(K::Albedo)?;
                finish.phong = self.float()? as f32;
            }
            K::Specular => {
                self.next()?;
                albedo.specular = self.accept(K::Albedo)?;
                finish.specular = self.float()? as f32;
            }
            K::Roughness => {
                self.next()?;
                let roughness = self.float()?;
                finish.specular_exponent = if roughness == 0.0 { 0.0 } else { (1.0 / roughness) as f32 };
                if roughness == 0.0 {
                    self.warn(Topic::Range, span, "a roughness of 0 gives a highlight of exponent 0");
                }
            }
            K::Metallic => {
                self.next()?;
                finish.metallic = self.optional_amount()?;
            }
            K::Irid => {
                self.next()?;
                self.irid(finish)?;
            }
            K::Reflection => {
                self.next()?;
                self.reflection(finish)?;
            }
            K::ConserveEnergy => {
                self.next()?;
                finish.conserve_energy = self.optional_bool()?;
            }
            K::Subsurface => {
                self.next()?;
                self.subsurface(finish)?;
            }
            K::Ior | K::Caustics | K::Refraction => {
                self.next()?;
                let value = Some(self.float()? as f32);
                self.warn(
                    Topic::Outdated,
                    span,
                    format!("'{}' belongs into interior; in finish it is kept for old scenes", keyword.word()),
                );
                match keyword {
                    K::Ior => finish.ior = value,
                    K::Caustics => finish.caustics = value,
                    _ => finish.refraction = value,
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// An optional number; the bare word means 1.
    fn optional_amount(&mut self) -> SourceResult<f32> {
        Ok(if self.starts_expression()? { self.float()? as f32 } else { 1.0 })
    }

    fn irid(&mut self, finish: &mut Finish) -> SourceResult<()> {
        self.open("irid")?;
        finish.irid_amount = self.float()? as f32;
        loop {
            self.comma()?;
            if self.accept(K::Thickness)? {
                finish.irid_thickness = self.float()? as f32;
            } else if self.accept(K::Turbulence)? {
                finish.irid_turbulence = self.vector()?.x as f32;
            } else {
                return self.close("irid");
            }
        }
    }

    fn reflection(&mut self, finish: &mut Finish) -> SourceResult<()> {
        if !self.accept_punct('{')? {
            let both = self.rgb_only("reflection")?;
            finish.reflection_min = both;
            finish.reflection_max = both;
            finish.reflection_falloff = 1.0;
            finish.reflection_fresnel = false;
            return Ok(());
        }
        let mut colors = Vec::new();
        loop {
            self.comma()?;
            let span = self.span();
            match self.keyword()? {
                Some(K::Fresnel) => {
                    self.next()?;
                    let value = self.optional_amount()?;
                    if value != 0.0 && value != 1.0 {
                        return self.error(span, "fresnel is either on (1) or off (0)");
                    }
                    finish.reflection_fresnel = value == 1.0;
                }
                Some(K::Falloff) => {
                    self.next()?;
                    finish.reflection_falloff = self.float()? as f32;
                }
                Some(K::Exponent) => {
                    self.next()?;
                    finish.reflection_exponent = self.float()? as f32;
                }
                Some(K::Metallic) => {
                    self.next()?;
                    finish.reflection_metallic = self.optional_amount()?;
                }
                _ if colors.len() < 2 && (self.starts_color()? || self.starts_expression()?) => {
                    colors.push(self.rgb_only("reflection")?);
                }
                _ => break,
            }
        }
        match colors[..] {
            [min, max] => (finish.reflection_min, finish.reflection_max) = (min, max),
            [only] => {
                finish.reflection_min = if finish.reflection_fresnel { Rgb::ZERO } else { only };
                finish.reflection_max = only;
            }
            _ => {}
        }
        self.close("reflection")
    }

    fn subsurface(&mut self, finish: &mut Finish) -> SourceResult<()> {
        self.open("subsurface")?;
        loop {
            self.comma()?;
            if self.accept(K::Translucency)? {
                finish.subsurface_translucency = Some(self.rgb_only("translucency")?);
            } else if self.accept(K::Anisotropy)? {
                self.rgb_only("anisotropy")?;
            } else {
                return self.close("subsurface");
            }
        }
    }
}
