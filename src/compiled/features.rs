//! The census: what a compiled scene uses, found once, so that rendering takes only the ways that it needs.

use super::World;
use super::atmosphere::Sky;
use super::light::{Beam, Light};
use super::texture::{Layer, Texture};
use crate::omission::{Keep, Omission};

/// What a scene uses, and how often.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Features {
    /// Textures through which light may come somewhere: while there is none, a shadow ray needs no more than a yes or no.
    pub see_through_textures: usize,
    /// Textures that a pattern chooses from.
    pub patterned_textures: usize,
    /// Textures with a layer that mirrors.
    pub mirroring_textures: usize,
    /// Textures with a layer that light goes below, where the scene has such light.
    pub translucent_textures: usize,
    /// Textures with bumps.
    pub bumpy_textures: usize,
    /// Textures whose colours are found for four neighbours at once.
    pub side_by_side_textures: usize,
    /// The same holds for the sky.
    pub side_by_side_sky: bool,
    /// Interiors that bend, split or fade light.
    pub optical_interiors: usize,
    /// Interiors with media.
    pub filled_interiors: usize,
    /// Fogs, rainbows and media of the atmosphere, which end where a ray enters a solid object.
    pub airs: usize,
    /// Lights that are grids of lights.
    pub area_lights: usize,
    /// Lights that shine in a cone or a tube only.
    pub beamed_lights: usize,
    /// Lights that lose brightness with distance.
    pub fading_lights: usize,
    /// Lights that shine through one object only.
    pub projected_lights: usize,
    /// Surfaces that are searched for along rays.
    pub isosurfaces: usize,
    /// What is done although none of this asks for it.
    pub kept: Keep,
}

impl Features {
    /// Of everything that rays may meet.
    pub(crate) fn of(world: &World, kept: Keep) -> Self {
        let textures = |holds: fn(&Texture) -> bool| world.textures.iter().filter(|texture| holds(texture)).count();
        let lights = |holds: fn(&Light) -> bool| world.lights.iter().filter(|light| holds(light)).count();
        let atmosphere = &world.atmosphere;
        Self {
            see_through_textures: world.opaque.iter().filter(|opaque| !**opaque).count(),
            patterned_textures: textures(|texture| matches!(texture, Texture::Patterned(_))),
            mirroring_textures: textures(|texture| any_layer(texture, |layer| layer.finish.reflection.is_some())),
            translucent_textures: textures(|texture| any_layer(texture, |layer| layer.finish.translucency.is_some())),
            bumpy_textures: textures(|texture| any_layer(texture, |layer| layer.normal.is_some())),
            side_by_side_textures: textures(Texture::is_side_by_side),
            side_by_side_sky: atmosphere.sky.as_ref().is_some_and(Sky::is_side_by_side),
            optical_interiors: world.interiors.iter().filter(|interior| interior.is_optical()).count(),
            filled_interiors: world.interiors.iter().filter(|interior| !interior.media.is_empty()).count(),
            airs: atmosphere.fogs.len() + atmosphere.rainbows.len() + atmosphere.media.len(),
            area_lights: lights(|light| light.area.is_some()),
            beamed_lights: lights(|light| light.beam != Beam::Even),
            fading_lights: lights(|light| light.fade.is_some()),
            projected_lights: lights(|light| light.projected_through.is_some()),
            isosurfaces: world.geometry.isosurfaces(),
            kept,
        }
    }

    /// Whether what fills objects or the air bends, dims or colours light.
    pub fn bends_light(&self) -> bool {
        self.optical_interiors > 0 || self.filled_interiors > 0 || self.airs > 0
    }

    /// Whether there are fog, rainbows or media anywhere.
    pub fn has_air(&self) -> bool {
        self.airs > 0 || self.filled_interiors > 0
    }

    /// Whether rays know which objects they are in.
    pub fn interiors_matter(&self) -> bool {
        self.bends_light() || self.kept.holds(Omission::Interiors)
    }

    /// Lights with places where they do not shine.
    pub(crate) fn waning_lights(&self, world: &World) -> usize {
        world.lights.iter().filter(|light| light.beam != Beam::Even || light.fade.is_some()).count()
    }

    /// Their names and counts, in a fixed order.
    pub fn summary(&self) -> [(&'static str, usize); 15] {
        [
            ("see-through textures", self.see_through_textures),
            ("patterned textures", self.patterned_textures),
            ("mirroring textures", self.mirroring_textures),
            ("translucent textures", self.translucent_textures),
            ("bumpy textures", self.bumpy_textures),
            ("side by side textures", self.side_by_side_textures),
            ("side by side skies", usize::from(self.side_by_side_sky)),
            ("optical interiors", self.optical_interiors),
            ("interiors with media", self.filled_interiors),
            ("fogs, rainbows, media", self.airs),
            ("area lights", self.area_lights),
            ("beamed lights", self.beamed_lights),
            ("fading lights", self.fading_lights),
            ("projected lights", self.projected_lights),
            ("isosurfaces", self.isosurfaces),
        ]
    }
}

/// Whether a layer anywhere in a texture has some property.
fn any_layer(texture: &Texture, holds: fn(&Layer) -> bool) -> bool {
    match texture {
        Texture::Layers(layers) => layers.iter().any(holds),
        Texture::Patterned(patterned) => patterned.items.iter().any(|item| any_layer(item, holds)),
    }
}
