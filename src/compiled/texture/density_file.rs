//! Voxels from a df3 file.
//!
//! Source: section 8.3 of the function facts (measured).

use crate::math::DVec3;

/// A box of voxels over the unit cube.
#[derive(Clone, Debug)]
pub struct DensityFile {
    size: [usize; 3],
    voxels: Vec<f32>,
    /// 0 nearest, 1 trilinear, others tricubic.
    interpolation: u8,
}

impl DensityFile {
    /// Reads the file's bytes: three big-endian sizes, then voxels of 4, 2 or 1 bytes, x fastest.
    ///
    /// # Errors
    /// When the length fits none of the voxel widths.
    pub fn new(bytes: &[u8], interpolation: u8) -> Result<Self, String> {
        let wrong = || "the density file's length does not fit its size".to_string();
        let (head, body) = bytes.split_at_checked(6).ok_or_else(wrong)?;
        let size = [0, 2, 4].map(|i| usize::from(u16::from_be_bytes([head[i], head[i + 1]])));
        let n = size[0] * size[1] * size[2];
        let width = [4, 2, 1].into_iter().find(|w| n > 0 && body.len() / w >= n).ok_or_else(wrong)?;
        let most = 256.0_f64.powi(width as i32) - 1.0;
        let value = |voxel: &[u8]| {
            let raw = voxel.iter().fold(0_u64, |v, byte| v * 256 + u64::from(*byte));
            (raw as f64 / most) as f32
        };
        Ok(Self { size, voxels: body.chunks_exact(width).take(n).map(value).collect(), interpolation })
    }

    fn voxel(&self, at: [usize; 3]) -> f64 {
        f64::from(self.voxels[at[0] + self.size[0] * (at[1] + self.size[1] * at[2])])
    }

    /// The density; 0 outside the unit cube.
    pub(super) fn value(&self, p: DVec3) -> f64 {
        let p = p.to_array();
        if p.iter().any(|c| !(0.0..1.0).contains(c)) {
            return 0.0;
        }
        let u: [f64; 3] = std::array::from_fn(|i| p[i] * self.size[i] as f64);
        let cell = u.map(|c| c as usize);
        let f: [f64; 3] = std::array::from_fn(|i| u[i] - cell[i] as f64);
        match self.interpolation {
            0 => self.voxel(cell),
            1 => self.trilinear(cell, f),
            _ => self.tricubic(cell, f).max(0.0),
        }
    }

    fn trilinear(&self, cell: [usize; 3], f: [f64; 3]) -> f64 {
        let at = |axis: usize, upper: usize| (cell[axis] + upper) % self.size[axis];
        let mut sum = 0.0;
        for corner in 0..8_usize {
            let upper = [corner & 1, (corner >> 1) & 1, corner >> 2];
            let weight: f64 = (0..3).map(|i| if upper[i] == 1 { f[i] } else { 1.0 - f[i] }).product();
            sum += weight * self.voxel([at(0, upper[0]), at(1, upper[1]), at(2, upper[2])]);
        }
        sum
    }

    /// Catmull-Rom along z, then y, then x, in single precision as in POV-Ray.
    fn tricubic(&self, cell: [usize; 3], f: [f64; 3]) -> f64 {
        let at = |axis: usize, step: usize| match (cell[axis] + step).checked_sub(1) {
            Some(i) => i % self.size[axis],
            // Below the first voxel POV-Ray wraps the largest 64-bit number.
            None => (u64::MAX % self.size[axis] as u64) as usize,
        };
        let f = f.map(|v| v as f32);
        let along_z = |x: usize, y: usize| {
            cubic(std::array::from_fn(|k| self.voxel([at(0, x), at(1, y), at(2, k)]) as f32), f[2])
        };
        let along_y = |x: usize| cubic(std::array::from_fn(|j| along_z(x, j)), f[1]);
        f64::from(cubic(std::array::from_fn(along_y), f[0]))
    }
}

fn cubic([a, b, c, d]: [f32; 4], f: f32) -> f32 {
    let (m0, m1) = ((c - a) / 2.0, (d - b) / 2.0);
    ((2.0 * (b - c) + m0 + m1) * f + (3.0 * (c - b) - 2.0 * m0 - m1)) * f * f + m0 * f + b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolations_match_the_binary() {
        let file = [0, 3, 0, 1, 0, 1, 0, 0x80, 0xff];
        let check = |n: u8, expected: [f64; 4]| {
            let density = DensityFile::new(&file, n).expect("a good file");
            for (x, expected) in [0.1, 0.5, 0.9, 1.0].into_iter().zip(expected) {
                let found = density.value(DVec3::new(x, 0.5, 0.5));
                assert!((found - expected).abs() < 1e-6, "{n} at {x}: {found} for {expected}");
            }
        };
        check(0, [0.0, 0.5019607843137255, 1.0, 0.0]);
        check(1, [0.15058823529411766, 0.7509803921568627, 0.2999999999999998, 0.0]);
        check(2, [0.11381766945123672, 0.8448529839515686, 0.236794114112854, 0.0]);
    }
}
