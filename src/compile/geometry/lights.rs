//! Pass 2, `collect_lights`: light sources leave the object graph.

use super::census::Census;
use super::{CompiledGeometry, LightGroup, PlacedLight};
use crate::compiled::geometry::LightGroupId;
use crate::math::Transform;
use crate::scene::{Object, Shape};
use crate::stack::roomy;
use std::sync::Arc;

/// Finds every light in an object; `world_from_parent` is where the object stands.
pub(super) fn collect_lights(
    object: &Object,
    world_from_parent: &Transform,
    group: Option<LightGroupId>,
    census: &Census,
    out: &mut CompiledGeometry,
) {
    let world_from_shape = || object.place.then(world_from_parent);
    match &object.shape {
        Shape::LightSource(light) => {
            // The light moved along with its object already; what contains it has not moved it.
            let mut light = Arc::clone(light);
            if !world_from_parent.is_identity() {
                Arc::make_mut(&mut light).apply(world_from_parent);
            }
            out.lights.push(PlacedLight { span: object.span, light, group });
        }
        // Only direct members belong to a group: in a union inside it they are global.
        Shape::Csg { children, .. } if census.of(children).lights > 0 || census.of(children).light_groups => {
            let world_from_shape = world_from_shape();
            for child in children.iter() {
                roomy(|| collect_lights(child, &world_from_shape, None, census, out));
            }
        }
        Shape::LightGroup { children, global_lights } => {
            // Of groups in groups the outermost decides.
            let outer = group.and_then(|g| out.light_groups.get(g));
            let global_lights = outer.map_or(*global_lights, |outer| outer.global_lights);
            let id = out.light_groups.push(LightGroup { global_lights });
            let world_from_shape = world_from_shape();
            for child in children.iter() {
                roomy(|| collect_lights(child, &world_from_shape, Some(id), census, out));
            }
        }
        _ => {}
    }
}
