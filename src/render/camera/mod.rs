//! From image positions to rays: projections, lenses, meshes that are cameras.

mod lens;
mod mesh;
mod rays;

pub(super) use lens::Lens;
pub(super) use mesh::mesh_rays;
pub(super) use rays::RawRay;
