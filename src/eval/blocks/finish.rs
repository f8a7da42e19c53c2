//! `finish { … }`.

use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Topic};
use crate::eval::{Evaluator, Value};
use crate::math::Rgb;
use crate::scene::Finish;
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// A finish with which terms were written with `albedo`, to be scaled at the closing brace.
#[derive(Default)]
pub(super) struct Draft {
    finish: Finish,
    albedo_diffuse: bool,
    albedo_phong: bool,
    albedo_specular: bool,
}

pub(super) static FINISH: Block<Draft> = Block::new(
    "finish",
    "how a surface shines",
    &[
        Item::new(
            K::Ambient,
            Takes::Rgb(|d| &mut d.finish.ambient),
            "0.1",
            "light that it gives off, times ambient_light of global_settings; none under radiosity",
        ),
        Item::since(370, K::Emission, Takes::Rgb(|d| &mut d.finish.emission), "0", "light that it gives off"),
        Item::new(
            K::Diffuse,
            Takes::Other("[albedo] FLOAT [, FLOAT]", |e, d, _| {
                d.albedo_diffuse = e.accept(K::Albedo)?;
                d.finish.diffuse = e.float()? as f32;
                e.comma()?;
                d.finish.diffuse_back = if e.starts_expression()? { e.float()? as f32 } else { 0.0 };
                Ok(())
            }),
            "0.6",
            "share of light that is scattered; the second number is for light from behind",
        ),
        Item::new(
            K::Brilliance,
            Takes::Single(|d| &mut d.finish.brilliance),
            "1",
            "exponent by which scattered light falls off with the angle",
        ),
        Item::new(K::Crand, Takes::Single(|d| &mut d.finish.crand), "0", "random graininess of scattered light"),
        Item::new(
            K::Phong,
            Takes::Other("[albedo] FLOAT", |e, d, _| {
                d.albedo_phong = e.accept(K::Albedo)?;
                d.finish.phong = e.float()? as f32;
                Ok(())
            }),
            "0",
            "strength of a highlight after Phong",
        ),
        Item::new(K::PhongSize, Takes::Single(|d| &mut d.finish.phong_size), "40", "exponent of that highlight"),
        Item::new(
            K::Specular,
            Takes::Other("[albedo] FLOAT", |e, d, _| {
                d.albedo_specular = e.accept(K::Albedo)?;
                d.finish.specular = e.float()? as f32;
                Ok(())
            }),
            "0",
            "strength of a highlight after Blinn",
        ),
        Item::new(K::Roughness, Takes::Other("FLOAT", roughness), "0.05", "width of that highlight"),
        Item::new(
            K::Metallic,
            Takes::Amount(|d| &mut d.finish.metallic),
            "0",
            "how much the pigment colours highlights",
        ),
        Item::new(
            K::Irid,
            Takes::Other("{ FLOAT [thickness FLOAT] [turbulence VECTOR] }", |e, d, _| {
                e.open("irid")?;
                d.finish.irid_amount = e.float()? as f32;
                e.comma()?;
                e.items_of(&IRID, &mut d.finish)?;
                e.close_of(&IRID)
            }),
            "{ 0 }",
            "colours of a thin film over it",
        ),
        Item::new(
            K::Reflection,
            Takes::Other("COLOUR | { [COLOUR,] COLOUR items }", |e, d, _| reflection(e, &mut d.finish)),
            "0",
            "share of light that is mirrored; from the first colour seen straight on to the second at a grazing angle",
        ),
        Item::new(
            K::ReflectionExponent,
            Takes::Other("FLOAT", |e, d, at| {
                d.finish.reflection_exponent = e.float()? as f32;
                if d.finish.reflection_exponent == 0.0 {
                    return e.error(at.span, "reflection_exponent must not be 0");
                }
                Ok(())
            }),
            "1",
            "exponent of mirrored brightness; the old spelling of reflection { exponent }",
        ),
        Item::since(
            350,
            K::ConserveEnergy,
            Takes::Switch(|d| &mut d.finish.conserve_energy),
            "off",
            "what is mirrored is lost to what shines through",
        ),
        Item::since(
            370,
            K::Subsurface,
            Takes::Other("{ translucency COLOUR }", |e, d, _| {
                e.open("subsurface")?;
                e.comma()?;
                e.items_of(&SUBSURFACE, &mut d.finish)?;
                e.close_of(&SUBSURFACE)
            }),
            "",
            "light that enters and leaves somewhere else",
        ),
        Item::new(K::Ior, Takes::Other("FLOAT", old_interior), "", "outdated: ior of interior"),
        Item::new(K::Caustics, Takes::Other("FLOAT", old_interior), "", "outdated: caustics of interior"),
        Item::new(K::Refraction, Takes::Other("FLOAT", old_interior), "", "outdated: without effect"),
    ],
);

pub(super) static IRID: Block<Finish> = Block::new(
    "irid",
    "colours of thin films on a surface",
    &[
        Item::new(K::Thickness, Takes::Single(|f| &mut f.irid_thickness), "0", "how thick the film is"),
        Item::new(
            K::Turbulence,
            Takes::Other("VECTOR", |e, f, _| {
                f.irid_turbulence = e.vector()?.x as f32;
                Ok(())
            }),
            "0",
            "how much its thickness varies",
        ),
    ],
);

pub(super) static SUBSURFACE: Block<Finish> = Block::new(
    "subsurface",
    "light that goes into a surface and comes out beside",
    &[
        Item::new(
            K::Translucency,
            Takes::Other("COLOUR", |e, f, _| {
                f.subsurface_translucency = Some(e.rgb_only("translucency")?);
                Ok(())
            }),
            "",
            "how far light of each colour comes, in millimetres",
        ),
        Item::new(
            K::Anisotropy,
            Takes::Other("COLOUR", |e, _, _| e.rgb_only("anisotropy").map(drop)),
            "",
            "without effect, as in POV-Ray",
        ),
    ],
);

pub(super) static REFLECTION: Block<Finish> = Block::new(
    "reflection",
    "what a surface mirrors",
    &[
        Item::since(
            350,
            K::Fresnel,
            Takes::Other("[BOOL]", |e, f, at| {
                let value = e.optional_amount()?;
                if value != 0.0 && value != 1.0 {
                    return e.error(at.span, "fresnel is either on (1) or off (0)");
                }
                f.reflection_fresnel = value == 1.0;
                Ok(())
            }),
            "off",
            "between the colours as glass of the interior's ior mirrors",
        ),
        Item::new(
            K::Falloff,
            Takes::Single(|f| &mut f.reflection_falloff),
            "1",
            "exponent of the angle between the colours",
        ),
        Item::new(K::Exponent, Takes::Single(|f| &mut f.reflection_exponent), "1", "exponent of mirrored brightness"),
        Item::new(
            K::Metallic,
            Takes::Amount(|f| &mut f.reflection_metallic),
            "0",
            "how much the pigment colours what is mirrored",
        ),
    ],
);

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
        let finish = self.take_declared(pick)?.map_or(start, |f| (*f).clone());
        let mut draft = Draft { finish, ..Draft::default() };
        self.items_of(&FINISH, &mut draft)?;
        self.close_of(&FINISH)?;
        let Draft { mut finish, albedo_diffuse, albedo_phong, albedo_specular } = draft;
        // Source: shading facts, section 5.1; reflectances integrate to the given number.
        finish.raw_diffuse = finish.diffuse;
        if albedo_diffuse {
            let scale = (finish.brilliance + 1.0) / 2.0;
            finish.diffuse *= scale;
            finish.diffuse_back *= scale;
        }
        if albedo_phong {
            finish.phong *= (finish.phong_size + 1.0) / 2.0;
        }
        if albedo_specular {
            let e = finish.specular_exponent;
            finish.specular *= (e + 2.0) / (4.0 * (2.0 - (-e / 2.0).exp2()));
        }
        Ok(finish)
    }
}

fn roughness(e: &mut Evaluator<'_>, draft: &mut Draft, at: Word) -> SourceResult<()> {
    let roughness = e.float()?;
    draft.finish.specular_exponent = if roughness == 0.0 { 0.0 } else { (1.0 / roughness) as f32 };
    if roughness == 0.0 {
        e.warn(Topic::Range, at.span, "a roughness of 0 gives a highlight of exponent 0");
    }
    Ok(())
}

/// Words that old scenes have in the finish instead of the interior.
fn old_interior(e: &mut Evaluator<'_>, draft: &mut Draft, at: Word) -> SourceResult<()> {
    let value = Some(e.float()? as f32);
    let message = format!("'{}' belongs into interior; in finish it is kept for old scenes", at.word.word());
    e.warn(Topic::Outdated, at.span, message);
    match at.word {
        K::Ior => draft.finish.ior = value,
        K::Caustics => draft.finish.caustics = value,
        _ => draft.finish.refraction = value,
    }
    Ok(())
}

fn reflection(e: &mut Evaluator<'_>, finish: &mut Finish) -> SourceResult<()> {
    if !e.accept_punct('{')? {
        let both = e.rgb_only("reflection")?;
        finish.reflection_min = both;
        finish.reflection_max = both;
        finish.reflection_falloff = 1.0;
        finish.reflection_fresnel = false;
        return Ok(());
    }
    let mut colors = Vec::new();
    loop {
        e.comma()?;
        if e.item_of(&REFLECTION, finish)? {
            continue;
        }
        if colors.len() < 2 && (e.starts_color()? || e.starts_expression()?) {
            colors.push(e.rgb_only("reflection")?);
        } else {
            break;
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
    e.close_of(&REFLECTION)
}
