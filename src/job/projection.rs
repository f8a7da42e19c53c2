//! How points of the world come into the picture, for programs that put something into it later.

use crate::compiled::camera::{Camera, Projection as Kind};
use crate::imaging::Projection;
use crate::math::DVec3;
use glam::DMat3;

/// The matrices of a camera whose rays are straight images of straight lines; others have none.
///
/// A point q from the location lies at s right and t up in the picture where q is a multiple of d + s r + t u. So its
/// components by right r, up u and direction d, the rows of an inverse matrix, tell s, t and the distance.
pub(super) fn projection(camera: &Camera) -> Option<Projection> {
    let is_central = match camera.projection {
        Kind::Perspective => true,
        Kind::Orthographic => false,
        _ => return None,
    };
    let lengths = [camera.right, camera.up, camera.direction].map(DVec3::length);
    let basis = DMat3::from_cols(camera.right, camera.up, camera.direction);
    let components = basis.inverse().transpose();
    let [right, up, ahead] = [components.x_axis, components.y_axis, components.z_axis];
    if ![right, up, ahead].iter().all(|row| row.is_finite()) {
        return None;
    }
    // Numbers without a direction: 0 of the first kind, 1 of the second stand for the point itself.
    let row = |vector: DVec3, constant: f64| (vector, constant - vector.dot(camera.location));
    let (half, depth) = if is_central { (0.5 * ahead, row(ahead, 0.0)) } else { (DVec3::ZERO, (DVec3::ZERO, 1.0)) };
    let middle = if is_central { 0.0 } else { 0.5 };
    let columns = [row(right + half, middle), row(half - up, middle), row(ahead, 0.0), depth];
    let camera_columns =
        [row(lengths[0] * right, 0.0), row(lengths[1] * up, 0.0), row(lengths[2] * ahead, 0.0), (DVec3::ZERO, 1.0)];
    Some(Projection { camera_from_world: rows(camera_columns), picture_from_world: rows(columns) })
}

/// Columns, each with its number in the last row, row by row.
fn rows(columns: [(DVec3, f64); 4]) -> [f32; 16] {
    std::array::from_fn(|i| {
        let (vector, constant) = columns[i % 4];
        [vector.x, vector.y, vector.z, constant][i / 4] as f32
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::eval::Memory;
    use crate::job::Session;

    /// Where a point stands in camera space and in the picture.
    fn check(camera: &str, point: [f32; 3], in_camera: [f32; 3], in_picture: [f32; 2]) {
        let scene = format!("#version 3.7; global_settings {{ assumed_gamma 1 }} camera {{ {camera} }}");
        let host = Memory::new([("a.pov", &*scene)]);
        let ready = Session::new(1).compile("a.pov".as_ref(), &Default::default(), &host).expect("a right scene");
        let projection = projection(&ready.world.camera).expect("straight rays");
        let through = |matrix: &[f32; 16]| {
            let row = [point[0], point[1], point[2], 1.0];
            let sum: [f32; 4] = std::array::from_fn(|i| (0..4).map(|j| row[j] * matrix[4 * j + i]).sum());
            [sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]]
        };
        let near = |a: &[f32], b: &[f32]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5);
        let (camera, picture) = (through(&projection.camera_from_world), through(&projection.picture_from_world));
        assert!(near(&camera, &in_camera) && near(&picture[..2], &in_picture), "{camera:?} {picture:?}");
    }

    #[test]
    fn points_come_to_their_places() {
        let straight = "location <1, 0, -4> right 2*x up 2*y direction z";
        check(straight, [1.0, 0.0, 0.0], [0.0, 0.0, 4.0], [0.5, 0.5]);
        // A quarter of the picture's width and height away from the middle at a distance of 4.
        check(straight, [3.0, 2.0, 0.0], [2.0, 2.0, 4.0], [0.75, 0.25]);
        check(&format!("orthographic {straight}"), [1.5, -0.5, 9.0], [0.5, -0.5, 13.0], [0.75, 0.75]);
        check("location -5*x right z*-2 up 2*y direction x", [0.0, 5.0, -5.0], [5.0, 5.0, 5.0], [1.0, 0.0]);
    }

    #[test]
    fn bent_rays_have_no_matrix() {
        let host = Memory::new([("a.pov", "#version 3.7; camera { fisheye angle 180 }")]);
        let ready = Session::new(1).compile("a.pov".as_ref(), &Default::default(), &host).expect("a right scene");
        assert_eq!(projection(&ready.world.camera), None);
    }
}
