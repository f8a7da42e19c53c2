//! A scene as text of the expanded language.

mod expressions;
mod finishes;
mod functions;
mod lights;
mod meshes;
mod normals;
mod number;
mod objects;
mod origins;
mod patterns;
mod pictures;
mod pigments;
mod shapes;
mod surroundings;
mod textures;
mod transforms;
mod writer;

pub use writer::Style;

use super::MARK;
use crate::scene::{Scene, Shape, Texture};
use std::sync::Arc;
use writer::Writer;

/// The text of a scene, from which [`evaluate`](super::evaluate) makes the same one again.
///
/// What is stored once is written once, so the text is as long as what was written, not as what it became.
pub fn text(scene: &Scene, style: &Style<'_>) -> String {
    let mut writer = Writer::new(style, &scene.settings);
    writer.textures_ahead = scene.default_textures.iter().any(|texture| !is_pristine(texture));
    writer.scene(scene);
    writer.start_writing();
    writer.scene(scene);
    let version = scene.settings.version;
    let body = std::mem::take(&mut writer.out);
    let settings = writer.apart(Writer::global_settings);
    writer.end_of_declarations();
    let declarations = writer.declarations;
    format!("{MARK}\n#version {}.{:02};\n{settings}\n{declarations}{body}", version / 100, version % 100)
}

/// Whether a texture is the one that scenes start from.
fn is_pristine(texture: &Texture) -> bool {
    let text = |texture: &Texture| {
        let (style, settings) = (Style { file_name: &|_| String::new(), origins: None }, Default::default());
        let mut writer = Writer::new(&style, &settings);
        writer.start_writing();
        writer.apart(|w| w.texture_blocks(texture))
    };
    text(texture) == text(&Texture::default())
}

impl Writer<'_> {
    fn scene(&mut self, scene: &Scene) {
        // What was declared for nothing, and the settings, which stand in front.
        let Scene {
            settings: _,
            camera,
            background,
            sky_sphere,
            fogs,
            rainbows,
            media,
            objects,
            default_textures,
            unused: _,
        } = scene;
        self.camera(camera);
        if let Some(background) = background {
            self.background(background);
        }
        if let Some(sky) = sky_sphere {
            self.sky_sphere(sky);
        }
        fogs.iter().for_each(|fog| self.fog(fog));
        rainbows.iter().for_each(|rainbow| self.rainbow(rainbow));
        media.iter().for_each(|media| self.media(media));
        let mut default: Option<&Arc<Texture>> = None;
        for (object, texture) in objects.iter().zip(default_textures) {
            let same = default.is_some_and(|known| Arc::ptr_eq(known, texture));
            if self.textures_ahead && !same && !matches!(object.shape, Shape::LightSource(_)) {
                let name = self.texture_name(texture, true).unwrap_or_default();
                self.line(format_args!("#default {{ texture {{ {name} }} }}"));
                default = Some(texture);
            }
            self.object_block(object);
        }
    }
}
