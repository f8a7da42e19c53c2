//! What a scene has for the ladders.

use crate::compiled::World;

/// What decides which ladders make sense, and the scene's own rungs of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Census {
    /// Something mirrors or lets through.
    pub has_secondary_rays: bool,
    /// Some light is a grid of lights.
    pub has_area_lights: bool,
    /// Some surface is searched for.
    pub has_isosurfaces: bool,
    /// The scene's own.
    pub max_trace_level: u32,
    /// The scene's own.
    pub adc_bailout: f64,
}

impl Census {
    /// Of a compiled scene.
    pub fn of(world: &World) -> Self {
        let features = &world.features;
        Self {
            has_secondary_rays: features.mirroring_textures + features.see_through_textures > 0,
            has_area_lights: features.area_lights > 0,
            has_isosurfaces: features.isosurfaces > 0,
            max_trace_level: world.settings.max_trace_level,
            adc_bailout: f64::from(world.settings.adc_bailout),
        }
    }
}
