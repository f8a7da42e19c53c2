//! What stands in a scene outside of all braces, beside objects and directives.

use super::settings::GLOBAL_SETTINGS;
use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::scene::Object;
use crate::syntax::Keyword as K;

pub(super) static SCENE: Block<()> = Block::new(
    "scene",
    "what stands outside of all braces, beside objects and directives",
    &[
        Item::new(K::Camera, Takes::Other("{ CAMERA }", camera), "", "where the picture is seen from"),
        Item::new(
            K::GlobalSettings,
            Takes::Other("{ SETTINGS }", |e, (), _| e.global_settings()),
            "",
            "what holds for the whole scene",
        ),
        Item::new(
            K::Background,
            Takes::Other("{ COLOUR }", |e, (), _| {
                e.scene.background = Some(e.background()?);
                Ok(())
            }),
            "{ rgb 0 }",
            "what is seen where nothing else is",
        ),
        Item::new(
            K::Fog,
            Takes::Other("{ FOG }", |e, (), _| {
                let fog = e.fog()?;
                e.scene.fogs.push(fog);
                Ok(())
            }),
            "",
            "haze that hides what is far away",
        ),
        Item::new(
            K::Rainbow,
            Takes::Other("{ RAINBOW }", |e, (), _| {
                let rainbow = e.rainbow()?;
                e.scene.rainbows.push(rainbow);
                Ok(())
            }),
            "",
            "a bow in the sky",
        ),
        Item::new(
            K::SkySphere,
            Takes::Other("{ SKY }", |e, (), at| {
                let sky = e.sky_sphere()?;
                if e.scene.sky_sphere.replace(sky).is_some() {
                    e.warn(Topic::Ignored, at.span, "there is more than one sky_sphere; the last one is used");
                }
                Ok(())
            }),
            "",
            "pigments that are seen where nothing else is",
        ),
        Item::new(
            K::Media,
            Takes::Other("{ MEDIA }", |e, (), _| {
                let media = e.media_block()?;
                e.scene.media.push(media);
                Ok(())
            }),
            "",
            "dust, smoke and fire all over the scene",
        ),
        Item::new(K::MaxTraceLevel, Takes::Other("INTEGER", setting), "", "outdated: belongs into global_settings"),
        Item::new(K::MaxIntersections, Takes::Other("INTEGER", setting), "", "outdated: without effect"),
    ],
);

fn camera(e: &mut Evaluator<'_>, (): &mut (), at: Word) -> SourceResult<()> {
    let camera = e.camera_block()?;
    let version = e.version;
    if e.defaults.last_camera.replace(camera.clone()).is_some() && version >= 350 {
        e.warn(Topic::Ignored, at.span, "there is more than one camera; the last one is used");
    }
    e.scene.camera = camera.into_camera(version);
    Ok(())
}

fn setting(e: &mut Evaluator<'_>, (): &mut (), at: Word) -> SourceResult<()> {
    e.item_behind(&GLOBAL_SETTINGS, &mut (), at)
}

impl Evaluator<'_> {
    /// One item of the scene level, if one comes next.
    pub(in crate::eval) fn scene_item(&mut self) -> SourceResult<bool> {
        match self.own_object()? {
            Some(object) => self.add_to_scene(object),
            None => return self.item_of(&SCENE, &mut ()),
        }
        Ok(true)
    }

    /// Puts an object into the scene, with the default texture in force now.
    fn add_to_scene(&mut self, object: Object) {
        self.scene.objects.push(object);
        let texture = match self.scene.default_textures.last() {
            Some(last) if self.defaults.is_texture(last) => last.clone(),
            _ => self.defaults.texture(),
        };
        self.scene.default_textures.push(texture);
    }
}
