//! What every object takes behind its shape: textures, flags, clips and bounds.

use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::scene::{Object, PhotonFlags, Shape};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// Modifiers that only some shapes take.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shaped {
    Sturm,
    Hierarchy,
    Open,
}

/// They end with the brace of the object, whatever its word.
pub(super) static MODIFIERS: Block<Object> = Block::moved(
    "object",
    |_, object, transform| object.apply(transform),
    &[
        Item::new(
            K::Texture,
            Takes::Other("{ TEXTURE }", |e, object, at| {
                let texture = e.texture_block()?;
                let below = object.texture.take();
                object.texture = Some(e.layer_over(below, texture, at.span)?);
                Ok(())
            }),
            "",
            "what its surface looks like; several are layers",
        ),
        Item::new(K::Pigment, Takes::Other("{ PIGMENT }", change_top_layer), "", "its colours"),
        Item::new(K::Normal, Takes::Other("{ NORMAL }", change_top_layer), "", "its bumps"),
        Item::new(K::Finish, Takes::Other("{ FINISH }", change_top_layer), "", "how it shines and mirrors"),
        Item::since(
            350,
            K::InteriorTexture,
            Takes::Other("{ TEXTURE }", |e, object, at| {
                let texture = e.texture_block()?;
                let below = object.rare.interior_texture.take();
                object.rare.interior_texture = Some(e.layer_over(below, texture, at.span)?);
                Ok(())
            }),
            "",
            "what its surface looks like from inside",
        ),
        Item::new(
            K::Interior,
            Takes::Other("{ INTERIOR }", |e, object, _| {
                let start = object.interior.take();
                object.interior = Some(Arc::new(e.interior_block(start)?));
                Ok(())
            }),
            "",
            "what it is filled with",
        ),
        Item::new(K::Material, Takes::Other("{ MATERIAL }", material), "", "texture and interior in one"),
        Item::since(
            350,
            K::UvMapping,
            Takes::Other("", |e, object, at| {
                if object.texture.is_some() {
                    return e.error(at.span, "uv_mapping must be specified before the texture");
                }
                object.flags.uv_mapping = true;
                Ok(())
            }),
            "",
            "textures lie on it by its own coordinates",
        ),
        Item::new(
            K::Inverse,
            Takes::Other("", |e, object, at| {
                if object.shape.is_patch() {
                    e.warn(Topic::Geometry, at.span, "a surface without an inside cannot be inverted");
                }
                object.flags.inverse = !object.flags.inverse;
                object.flags.turned = true;
                Ok(())
            }),
            "",
            "its inside becomes its outside",
        ),
        Item::new(
            K::Hollow,
            Takes::Other("[BOOL]", |e, object, _| {
                object.flags.hollow = Some(e.optional_bool()?);
                Ok(())
            }),
            "",
            "air and media of its surroundings are in it",
        ),
        Item::new(K::NoShadow, Takes::Nothing(|object| object.flags.no_shadow = true), "", "it casts no shadow"),
        Item::since(
            350,
            K::NoImage,
            Takes::Switch(|object| &mut object.flags.no_image),
            "",
            "the camera does not see it",
        ),
        Item::since(
            350,
            K::NoReflection,
            Takes::Switch(|object| &mut object.flags.no_reflection),
            "",
            "mirrors do not show it",
        ),
        Item::since(
            370,
            K::NoRadiosity,
            Takes::Switch(|object| &mut object.flags.no_radiosity),
            "",
            "radiosity does not see it",
        ),
        Item::since(
            350,
            K::DoubleIlluminate,
            Takes::Other("[BOOL]", |e, object, _| {
                object.flags.double_illuminate = Some(e.optional_bool()?);
                Ok(())
            }),
            "",
            "lights behind its surface light it, too",
        ),
        Item::since(
            370,
            K::CutawayTextures,
            Takes::Nothing(|object| object.flags.cutaway_textures = true),
            "",
            "cuts take the textures of what they cut",
        ),
        Item::since(
            350,
            K::SplitUnion,
            Takes::Other("[BOOL]", |e, object, _| {
                object.flags.keep_union = !e.optional_bool()?;
                Ok(())
            }),
            "on",
            "whether a union's bounds may be taken apart",
        ),
        Item::new(
            K::Hierarchy,
            Takes::Other("[BOOL]", |e, object, at| {
                shape_takes(e, object, Shaped::Hierarchy, at)?;
                object.flags.no_hierarchy = !e.optional_bool()?;
                Ok(())
            }),
            "",
            "whether bounds are built within a mesh, height field or blob",
        ),
        Item::new(
            K::Sturm,
            Takes::Other("[BOOL]", |e, object, at| {
                shape_takes(e, object, Shaped::Sturm, at)?;
                let on = e.optional_bool()?;
                object.shape.set_sturm(on);
                Ok(())
            }),
            "",
            "slower and surer roots",
        ),
        Item::new(
            K::Open,
            Takes::Other("", |e, object, at| {
                shape_takes(e, object, Shaped::Open, at)?;
                object.shape.set_open();
                Ok(())
            }),
            "",
            "an isosurface does not close where it leaves its container",
        ),
        Item::new(
            K::ClippedBy,
            Takes::Other("{ OBJECTS | bounded_by }", clipped_by),
            "",
            "what lies outside of these is cut away",
        ),
        Item::new(
            K::BoundedBy,
            Takes::Other("{ OBJECTS | clipped_by }", bounded_by),
            "",
            "rays that miss these miss the object",
        ),
        Item::since(
            350,
            K::Photons,
            Takes::Other("{ items }", |e, object, _| {
                object.rare.photons = e.photons_block(object.rare.photons)?;
                Ok(())
            }),
            "",
            "whether photons are aimed at it, and what they do there",
        ),
        Item::since(
            370,
            K::Radiosity,
            Takes::Other("{ importance FLOAT }", |e, object, _| {
                object.rare.radiosity_importance = Some(e.radiosity_importance()?);
                Ok(())
            }),
            "",
            "share of radiosity's rays that are followed to it",
        ),
        Item::new(K::Dtag, Takes::Other("STRING", |e, _, _| e.string().map(drop)), "", "without effect"),
    ],
);

pub(super) static PHOTONS: Block<PhotonFlags> = Block::new(
    "photons",
    &[
        Item::new(
            K::Target,
            Takes::Other("[FLOAT]", |e, flags, at| {
                flags.target = Some(if e.starts_expression()? { e.float()? } else { 1.0 });
                pass_or_refract(e, flags, at);
                Ok(())
            }),
            "",
            "photons are aimed at it; the number is a factor of their distance",
        ),
        Item::new(
            K::Refraction,
            Takes::Other("BOOL", |e, flags, at| {
                flags.refraction = Some(e.float()? > 0.0);
                pass_or_refract(e, flags, at);
                Ok(())
            }),
            "",
            "whether photons go through it, or are shot at what is bent",
        ),
        Item::new(
            K::Reflection,
            Takes::Other("BOOL", |e, flags, _| {
                flags.reflection = Some(e.float()? > 0.0);
                Ok(())
            }),
            "",
            "whether it mirrors photons, or they are shot at what mirrors",
        ),
        Item::new(
            K::Collect,
            Takes::Other("[BOOL]", |e, flags, _| {
                flags.collect = Some(e.optional_bool()?);
                Ok(())
            }),
            "",
            "whether photons stay on it",
        ),
        Item::new(
            K::PassThrough,
            Takes::Other("[BOOL]", |e, flags, at| {
                flags.pass_through = e.optional_bool()?;
                pass_or_refract(e, flags, at);
                Ok(())
            }),
            "",
            "photons go on to what is behind it",
        ),
        Item::new(K::AreaLight, Takes::Switch(|flags| &mut flags.area_light), "", "photons come from the whole grid"),
    ],
);

impl Evaluator<'_> {
    /// Everything that may follow the shape inside an object's braces.
    pub(super) fn object_modifiers(&mut self, object: &mut Object) -> SourceResult<()> {
        loop {
            if self.item_of(&MODIFIERS, object)? {
                continue;
            }
            let span = self.span();
            if self.keyword()?.is_none() || !self.at_color()? {
                return Ok(());
            }
            self.color()?;
            self.warn(Topic::Ignored, span, "a colour belongs into a pigment; here it has no effect");
        }
    }

    /// `{ … }` after `photons` of an object or light.
    pub(super) fn photons_block(&mut self, mut flags: PhotonFlags) -> SourceResult<PhotonFlags> {
        self.open("photons")?;
        self.items_of(&PHOTONS, &mut flags)?;
        self.close_of(&PHOTONS)?;
        Ok(flags)
    }

    /// `{ importance F }` after `radiosity`.
    pub(super) fn radiosity_importance(&mut self) -> SourceResult<f32> {
        self.open("radiosity")?;
        if !self.accept(K::Importance)? {
            return self.expected("'importance'");
        }
        let span = self.span();
        let importance = self.float()?;
        if !(importance > 0.0 && importance <= 1.0) {
            return self.error(span, "radiosity importance must be above 0 and at most 1");
        }
        self.close("radiosity")?;
        Ok(importance as f32)
    }
}

/// A target cannot let photons pass and bend them as well: of the words that ask for both, the last decides.
///
/// Source: photon facts, section 1 (measured).
fn pass_or_refract(e: &mut Evaluator<'_>, flags: &mut PhotonFlags, last: Word) {
    let is_target = flags.target.is_some_and(|spacing| spacing > 0.0);
    if !is_target || !flags.pass_through || flags.refraction == Some(false) {
        return;
    }
    let off = if last.word != K::PassThrough && flags.refraction == Some(true) {
        flags.pass_through = false;
        "pass_through"
    } else {
        flags.refraction = Some(false);
        "refraction"
    };
    let message = format!("a target of photons cannot have both pass_through and refraction; here {off} is off");
    e.warn(Topic::Ignored, last.span, message);
}

/// A pigment, normal or finish in place of that of the uppermost layer.
fn change_top_layer(e: &mut Evaluator<'_>, object: &mut Object, at: Word) -> SourceResult<()> {
    let placed = object.texture.take();
    object.texture = Some(e.change_top_layer(placed, at)?);
    Ok(())
}

fn material(e: &mut Evaluator<'_>, object: &mut Object, at: Word) -> SourceResult<()> {
    let material = e.material_block()?;
    if let Some(texture) = material.texture {
        let below = object.texture.take();
        object.texture = Some(e.layer_over(below, texture, at.span)?);
    }
    if let Some(texture) = material.interior_texture {
        let below = object.rare.interior_texture.take();
        object.rare.interior_texture = Some(e.layer_over(below, texture, at.span)?);
    }
    if material.interior.is_some() {
        object.interior = material.interior;
    }
    Ok(())
}

fn clipped_by(e: &mut Evaluator<'_>, object: &mut Object, at: Word) -> SourceResult<()> {
    e.open("clipped_by")?;
    if e.accept(K::BoundedBy)? {
        object.rare.clipped_by = object.rare.bounded_by.clone();
        object.flags.bounds_are_clips = true;
    } else {
        let clips = clip_objects(e, at.span)?;
        object.rare.clipped_by.extend(clips);
    }
    e.close("clipped_by")
}

fn bounded_by(e: &mut Evaluator<'_>, object: &mut Object, at: Word) -> SourceResult<()> {
    e.open("bounded_by")?;
    if e.accept(K::ClippedBy)? {
        object.rare.bounded_by = object.rare.clipped_by.clone();
        object.flags.bounds_are_clips = true;
    } else {
        let bounds = clip_objects(e, at.span)?;
        object.rare.bounded_by.extend(bounds);
    }
    e.close("bounded_by")
}

/// Objects with transformations for all of them, between the braces of a clip or bound.
fn clip_objects(e: &mut Evaluator<'_>, span: Span) -> SourceResult<Vec<Arc<Object>>> {
    let mut objects = Vec::new();
    loop {
        if let Some(object) = e.object()? {
            if object.texture.is_some() || object.shape.is_patch() {
                return e.error(span, "a clip or bound must be a solid without a texture");
            }
            objects.push(object);
        } else if let Some(transform) = e.transformation()? {
            for object in &mut objects {
                Arc::make_mut(object).apply(&transform);
            }
        } else {
            break;
        }
        e.comma()?;
    }
    if objects.is_empty() {
        return e.expected("an object");
    }
    Ok(objects)
}

fn shape_takes(e: &Evaluator<'_>, object: &Object, what: Shaped, at: Word) -> SourceResult<()> {
    let takes = match what {
        Shaped::Sturm => object.shape.takes_sturm(),
        Shaped::Hierarchy => {
            matches!(object.shape, Shape::Mesh(_) | Shape::HeightField(_) | Shape::Blob(_))
        }
        Shaped::Open => matches!(object.shape, Shape::Isosurface(_)),
    };
    if takes {
        return Ok(());
    }
    let message = format!("'{}' cannot be used with this object", at.word.word());
    match what {
        Shaped::Open => e.error_with_hint(
            at.span,
            message,
            "in a cylinder, cone or prism 'open' stands before pigment and other modifiers",
        ),
        _ => e.error(at.span, message),
    }
}
