//! What `#default` changes: where appearance blocks and cameras start from.

use super::camera::CameraStatement;
use crate::diag::SourceResult;
use crate::eval::Evaluator;
use crate::scene::{Texture, TextureLayer};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// The starting point of textures, pigments, normals, finishes and cameras.
#[derive(Clone, Debug, Default)]
pub struct Defaults {
    /// The one plain layer that a texture starts as.
    pub layer: TextureLayer,
    /// The camera that cameras start as.
    pub camera: CameraStatement,
    /// The camera before, which old scenes go on from.
    pub last_camera: Option<CameraStatement>,
    /// Whether `assumed_gamma` was met.
    pub gamma_given: bool,
}

impl Defaults {
    /// The default texture as a texture of its own.
    pub fn texture(&self) -> Arc<Texture> {
        Arc::new(Texture::Layers(vec![self.layer.clone()]))
    }

    /// Whether a texture is the default one as it stands now, part by part the same.
    pub(super) fn is_texture(&self, texture: &Texture) -> bool {
        let Texture::Layers(layers) = texture else { return false };
        let [layer] = &layers[..] else { return false };
        let same_normal = match (&layer.normal, &self.layer.normal) {
            (None, None) => true,
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            _ => false,
        };
        same_normal
            && Arc::ptr_eq(&layer.pigment, &self.layer.pigment)
            && Arc::ptr_eq(&layer.finish, &self.layer.finish)
    }
}

impl Evaluator<'_> {
    /// What stands between the braces of `#default`.
    pub(in crate::eval) fn default_block(&mut self) -> SourceResult<()> {
        loop {
            let span = self.span();
            match self.keyword()? {
                Some(K::Texture) => {
                    self.next()?;
                    match &*self.texture_block()? {
                        Texture::Layers(layers) if layers.len() == 1 => {
                            self.defaults.layer = layers[0].clone();
                        }
                        _ => {
                            return self
                                .error(span, "the default texture must be a plain one, without layers or pattern");
                        }
                    }
                }
                Some(K::Pigment) => {
                    self.next()?;
                    let start = (*self.defaults.layer.pigment).clone();
                    self.defaults.layer.pigment = Arc::new(self.pigment_block(start)?);
                }
                Some(K::Normal) => {
                    self.next()?;
                    self.defaults.layer.normal = self.normal_block(self.defaults.layer.normal.clone())?;
                }
                Some(K::Finish) => {
                    self.next()?;
                    let start = (*self.defaults.layer.finish).clone();
                    self.defaults.layer.finish = Arc::new(self.finish_block(start)?);
                }
                Some(K::Camera) => {
                    self.next()?;
                    self.defaults.camera = self.camera_block()?;
                }
                Some(K::Radiosity) => {
                    self.next()?;
                    self.scene.settings.radiosity_importance = self.radiosity_importance()?;
                }
                _ => return Ok(()),
            }
        }
    }
}
