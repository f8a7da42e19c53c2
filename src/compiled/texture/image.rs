//! Pictures in space: projection, interpolation, colours, heights and indices.
//!
//! Source: section 13 of the freeform facts (measured).

use crate::math::{Color, DVec3, Rgb, floor, gray};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// A picture in memory, in the scene's working space; shared by all that show it.
#[derive(Debug, Default)]
pub struct Raster {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Its colours.
    pub texels: Texels,
    /// Palette index of each pixel, for palette pictures.
    pub indices: Option<Arc<Vec<u8>>>,
    /// Colours are multiplied by alpha.
    pub premultiplied: bool,
    /// Whether the file carries alpha; else opacities do not count.
    pub has_alpha: bool,
}

/// Height x width x (red, green, blue, opacity), row-major, top row first.
#[derive(Debug)]
pub enum Texels {
    /// As the file has them, 8 bits each, and what a byte of a colour stands for.
    Bytes(Arc<Vec<u8>>, Box<[f32; 256]>),
    /// In working space.
    Floats(Arc<Vec<[f32; 4]>>),
}

impl Default for Texels {
    fn default() -> Self {
        Self::Floats(Arc::default())
    }
}

/// A picture as a pigment.
#[derive(Clone, Debug)]
pub struct ImageMap {
    /// Its pixels.
    pub raster: Arc<Raster>,
    /// How it lies in space.
    pub mapping: Mapping,
    /// What the scene says about its transparency.
    pub transparency: Transparency,
}

/// `filter` and `transmit` of a picture's pixels where a scene says otherwise than the file.
#[derive(Clone, Debug, Default)]
pub enum Transparency {
    /// As the file has them.
    #[default]
    AsItIs,
    /// Both are more, by as much.
    Added([f32; 2]),
    /// Both of each palette entry, where something was said.
    Palette(Box<[[Option<f32>; 2]; 256]>),
}

impl Transparency {
    #[inline]
    fn apply(&self, index: Option<u8>, color: &mut Color) {
        match (self, index) {
            (Self::AsItIs, _) | (Self::Palette(_), None) => {}
            (Self::Added([filter, transmit]), _) => {
                color.filter += filter;
                color.transmit += transmit;
            }
            (Self::Palette(entries), Some(index)) => {
                let [filter, transmit] = entries[usize::from(index)];
                color.filter = filter.unwrap_or(color.filter);
                color.transmit = transmit.unwrap_or(color.transmit);
            }
        }
    }
}

/// How a picture lies in space.
#[derive(Clone, Copy, Debug)]
pub struct Mapping {
    /// Projection.
    pub map_type: MapType,
    /// Shown once, not repeated.
    pub once: bool,
    /// 0 nearest, 2 bilinear, 3 bicubic, 4 normalised distance.
    pub interpolate: u8,
    /// Copies per unit.
    pub repeat: [f64; 2],
    /// Shift in units of the picture.
    pub offset: [f64; 2],
    /// Heights are palette indices.
    pub use_index: bool,
    /// Values are transparency.
    pub use_alpha: bool,
}

/// Projections.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum MapType {
    Planar,
    Spherical,
    Cylindrical,
    Torus,
}

/// POV-Ray's shift that decides exact pixel borders.
const PIXEL_OFFSET: f64 = 1e-10;

/// Angle of (x, z) from +x towards +z over a full turn, 0 to 1.
fn turn(x: f64, z: f64) -> f64 {
    let angle = z.atan2(x) / TAU;
    if angle < 0.0 { angle + 1.0 } else { angle }
}

impl Mapping {
    /// Picture coordinates before wrapping, each 0 to 1 over the picture; `None` where nothing shows.
    fn project(&self, p: DVec3) -> Option<(f64, f64)> {
        let outside = |v: f64| self.once && !(0.0..=1.0).contains(&v);
        match self.map_type {
            MapType::Planar => (!outside(p.x) && !outside(p.y)).then_some((p.x, p.y)),
            MapType::Spherical => {
                let length = p.length();
                let u = if p.x == 0.0 && p.z == 0.0 { 0.0 } else { turn(p.x, p.z) };
                (length > 0.0).then(|| (u, 0.5 + (p.y / length).asin() / PI))
            }
            MapType::Cylindrical => ((p.x != 0.0 || p.z != 0.0) && !outside(p.y)).then(|| (turn(p.x, p.z), p.y)),
            MapType::Torus => {
                let radius = p.x.hypot(p.z);
                let (across, tube) = (radius - 1.0, (radius - 1.0).hypot(p.y));
                let phi = (-across / tube).clamp(-1.0, 1.0).acos();
                let phi = if p.y > 0.0 { TAU - phi } else { phi };
                (radius > 0.0).then(|| (turn(p.x, p.z), if phi.is_nan() { 0.0 } else { phi / TAU }))
            }
        }
    }

    /// Pixel coordinates: column in 0..width, row from the top in 0..height.
    fn pixel(&self, p: DVec3, width: usize, height: usize) -> Option<(f64, f64)> {
        let (s, t) = self.project(p)?;
        let (w, h) = (width as f64, height as f64);
        let wraps = |planar: bool, v: f64, size: f64| if planar { v % size } else { v };
        let planar = self.map_type == MapType::Planar;
        let column = wraps(planar, s * w * self.repeat[0], w * self.repeat[0]) - self.offset[0] * w + PIXEL_OFFSET;
        let planar = planar || self.map_type == MapType::Cylindrical;
        let row = wraps(planar, t * h * self.repeat[1], h * self.repeat[1]) - self.offset[1] * h + PIXEL_OFFSET;
        if self.once && !(column >= 0.0 && row >= 0.0 && column < w && row < h) {
            return None;
        }
        Some((column.rem_euclid(w), (-row).rem_euclid(h)))
    }

    /// The pixels that count at a position, with their weights.
    fn taps(&self, x: f64, y: f64, width: usize, height: usize) -> smallvec::SmallVec<[(usize, f64); 16]> {
        let wrap = |v: i64, size: usize| {
            if self.once { v.clamp(0, size as i64 - 1) as usize } else { v.rem_euclid(size as i64) as usize }
        };
        let index = |i: i64, j: i64| wrap(j, height) * width + wrap(i, width);
        if !matches!(self.interpolate, 2..=4) {
            let nearest = |v: f64, size: usize| (v as usize).min(size - 1);
            return smallvec::smallvec![(nearest(y, height) * width + nearest(x, width), 1.0)];
        }
        let (x, y) = (x + 0.5, y + 0.5);
        let (left, top) = (floor(x), floor(y));
        let (i, j) = (left as i64, top as i64);
        let (p, q) = (x - left, y - top);
        let grid = |first: i64, u: &[f64], v: &[f64]| {
            let columns = |b: usize, wv: f64| {
                u.iter().enumerate().map(move |(a, wu)| (a, b, wu * wv)).collect::<smallvec::SmallVec<[_; 4]>>()
            };
            let all = v.iter().enumerate().flat_map(|(b, wv)| columns(b, *wv));
            all.map(|(a, b, w)| (index(i + first + a as i64, j + first + b as i64), w)).collect()
        };
        match self.interpolate {
            2 => grid(-1, &[1.0 - p, p], &[1.0 - q, q]),
            3 => grid(-2, &catmull_rom(p), &catmull_rom(q)),
            _ => {
                let near = |dx: f64, dy: f64| 1.0 / (dx * dx + dy * dy);
                let weights = [near(p, q), near(1.0 - p, q), near(p, 1.0 - q), near(1.0 - p, 1.0 - q)];
                let total: f64 = weights.iter().sum();
                let at = [index(i - 1, j - 1), index(i, j - 1), index(i - 1, j), index(i, j)];
                // On a pixel's centre its weight is infinite and it counts alone.
                match weights.iter().position(|w| w.is_infinite()) {
                    Some(k) => smallvec::smallvec![(at[k], 1.0)],
                    None => at.into_iter().zip(weights.map(|w| w / total)).collect(),
                }
            }
        }
    }
}

/// Weights of four neighbours at fraction `p` between the middle two.
fn catmull_rom(p: f64) -> [f64; 4] {
    let r = 1.0 - p;
    [-0.5 * p * r * r, 0.5 * r * (r * (3.0 * p + 1.0) + 1.0), 0.5 * p * (p * (4.0 - 3.0 * p) + 1.0), -0.5 * r * p * p]
}

impl Raster {
    /// Whether there are no pixels.
    fn is_empty(&self) -> bool {
        self.width == 0 || self.height == 0
    }

    /// The colour of a pixel, by its number.
    #[inline]
    fn color(&self, i: usize) -> Color {
        let ([r, g, b], opacity) = match &self.texels {
            Texels::Bytes(bytes, values) => {
                let [r, g, b, opacity] = bytes.as_chunks::<4>().0[i];
                ([r, g, b].map(|v| values[usize::from(v)]), f32::from(opacity) / 255.0)
            }
            Texels::Floats(floats) => {
                let [r, g, b, opacity] = floats[i];
                ([r, g, b], opacity)
            }
        };
        Color { rgb: Rgb::new(r, g, b), filter: 0.0, transmit: if self.has_alpha { 1.0 - opacity } else { 0.0 } }
    }

    /// Whether no light comes through any pixel, as the file has them.
    pub fn is_opaque(&self) -> bool {
        !self.has_alpha
            || match &self.texels {
                Texels::Bytes(bytes, _) => bytes.as_chunks::<4>().0.iter().all(|p| p[3] == u8::MAX),
                Texels::Floats(floats) => floats.iter().all(|p| p[3] == 1.0),
            }
    }

    /// The interpolated pixel at a point of pattern space; `None` where the picture does not reach.
    fn sample(&self, mapping: &Mapping, transparency: &Transparency, p: DVec3) -> Option<Color> {
        if self.is_empty() {
            return None;
        }
        let (x, y) = mapping.pixel(p, self.width, self.height)?;
        let mut sum = [0.0; 5];
        for (i, weight) in mapping.taps(x, y, self.width, self.height) {
            let mut color = self.color(i);
            transparency.apply(self.indices.as_ref().map(|indices| indices[i]), &mut color);
            sum.iter_mut().zip(color.to_array()).for_each(|(s, c)| *s += weight * c);
        }
        Some(Color::from_array(sum))
    }

    /// `image_pattern`: grey or transparency, 0 to 1; 0 where nothing shows.
    pub(super) fn pattern_value(&self, mapping: &Mapping, p: DVec3) -> f64 {
        let Some(color) = self.sample(mapping, &Transparency::AsItIs, p) else { return 0.0 };
        let value = match (mapping.use_alpha, self.has_alpha) {
            (false, _) => gray(color.rgb),
            (true, true) => color.transmit,
            (true, false) => color.rgb.x,
        };
        f64::from(value).clamp(0.0, 1.0)
    }

    /// `material_map`: which of `n` textures; more than `n` starts again, `n` itself is the last.
    pub(super) fn material_index(&self, mapping: &Mapping, p: DVec3, n: usize) -> usize {
        let Some((x, y)) = mapping.pixel(p, self.width, self.height) else { return 0 };
        let index = match &self.indices {
            Some(indices) => {
                let taps = mapping.taps(x, y, self.width, self.height);
                taps.iter().map(|(i, w)| w * f64::from(indices[*i])).sum::<f64>() as usize
            }
            None => self.sample(mapping, &Transparency::AsItIs, p).map_or(0, |c| (255.0 * c.rgb.x) as usize),
        };
        (if index > n { index % n.max(1) } else { index }).min(n.saturating_sub(1))
    }

    /// `bump_map`: tilts a normal by the heights of three neighbouring pixels.
    pub(super) fn bump(&self, mapping: &Mapping, p: DVec3, n: DVec3, amount: f64) -> DVec3 {
        if self.is_empty() {
            return n;
        }
        let Some((x, y)) = mapping.pixel(p, self.width, self.height) else { return n };
        let height = |dx: f64, dy: f64| {
            let (x, y) = ((x + dx).rem_euclid(self.width as f64), (y + dy).rem_euclid(self.height as f64));
            let taps = mapping.taps(x, y, self.width, self.height);
            let value = |i: usize| match &self.indices {
                Some(indices) if mapping.use_index => f64::from(indices[i]),
                _ => f64::from(gray(self.color(i).rgb)),
            };
            amount * taps.iter().map(|(i, w)| w * value(*i)).sum::<f64>()
        };
        let corner = DVec3::new(0.0, height(0.0, 0.0), 0.0);
        let left = DVec3::new(-1.0, height(-1.0, 1.0), 1.0);
        let right = DVec3::new(1.0, height(1.0, 1.0), 1.0);
        let bump = (right - left).cross(corner - left).normalize_or(DVec3::Y);
        // POV-Ray's own limits for a normal along y, which it takes to point down where its length is not 1
        // (`no_bump_scale`).
        let across = n.cross(DVec3::Y);
        let along_y = across.length() < 1e-10;
        let vertical = if (n.y - 1.0).abs() < 1e-10 { DVec3::Y } else { DVec3::NEG_Y };
        let (x_axis, y_axis) = if along_y { (DVec3::X, vertical) } else { (across.normalize(), n) };
        let z_axis = x_axis.cross(y_axis).normalize_or(DVec3::Z);
        bump.x * x_axis + bump.y * y_axis - bump.z * z_axis
    }
}

impl ImageMap {
    /// The colour, not multiplied by alpha; `None` where the picture does not reach.
    pub(super) fn color(&self, p: DVec3) -> Option<Color> {
        let color = self.raster.sample(&self.mapping, &self.transparency, p)?;
        let alpha = 1.0 - color.transmit;
        // POV-Ray's own limit for alpha.
        let divide = self.raster.premultiplied && alpha > 1e-10;
        Some(if divide { Color { rgb: color.rgb / Rgb::splat(alpha), ..color } } else { color })
    }

    /// Whether no light comes through anywhere, whichever entries of a palette are shown.
    pub(super) fn is_opaque(&self) -> bool {
        let shuts =
            |[filter, transmit]: [Option<f32>; 2]| filter.unwrap_or(0.0) == 0.0 && transmit.unwrap_or(0.0) == 0.0;
        !self.mapping.once
            && self.raster.is_opaque()
            && match &self.transparency {
                Transparency::AsItIs => true,
                Transparency::Added(more) => *more == [0.0; 2],
                Transparency::Palette(entries) => entries.iter().all(|entry| shuts(*entry)),
            }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 4 x 2 pixels, red = column, green = row.
    fn check(mapping: Mapping, p: [f64; 3], expected: Option<[f32; 2]>) {
        let pixels = (0..8).map(|i| [(i % 4) as f32, (i / 4) as f32, 0.0, 1.0]).collect();
        let raster = Raster { width: 4, height: 2, texels: Texels::Floats(Arc::new(pixels)), ..Raster::default() };
        let found = raster.sample(&mapping, &Transparency::AsItIs, DVec3::from(p)).map(|c| [c.rgb.x, c.rgb.y]);
        let close = |a: [f32; 2], b: [f32; 2]| (a[0] - b[0]).abs() < 1.5e-3 && (a[1] - b[1]).abs() < 1.5e-3;
        let agree = match (found, expected) {
            (Some(f), Some(e)) => close(f, e),
            (f, e) => f == e,
        };
        assert!(agree, "{found:?} instead of {expected:?} at {p:?} with {mapping:?}");
    }

    #[test]
    fn pixels_lie_where_povray_puts_them() {
        let plain = Mapping {
            map_type: MapType::Planar,
            once: false,
            interpolate: 0,
            repeat: [1.0; 2],
            offset: [0.0; 2],
            use_index: false,
            use_alpha: false,
        };
        check(plain, [0.125, 0.25, 0.0], Some([0.0, 1.0]));
        check(plain, [0.125, 0.75, 0.0], Some([0.0, 0.0]));
        check(plain, [0.25, 0.5, 0.0], Some([1.0, 0.0]));
        check(plain, [-0.1, -0.1, 0.0], Some([3.0, 0.0]));
        check(plain, [1.0, 1.0, 0.0], Some([0.0, 1.0]));
        let once = Mapping { once: true, ..plain };
        check(once, [1.0, 1.0, 0.0], Some([0.0, 1.0]));
        check(once, [0.5, 1.0, 0.0], Some([2.0, 1.0]));
        check(once, [1.0001, 0.5, 0.0], None);
        let linear = Mapping { interpolate: 2, ..plain };
        check(linear, [0.25, 0.25, 0.0], Some([0.5, 1.0]));
        check(linear, [0.2, 0.3, 0.0], Some([0.3, 0.9]));
        check(linear, [0.0, 0.25, 0.0], Some([1.5, 1.0]));
        check(Mapping { once: true, ..linear }, [0.0, 0.25, 0.0], Some([0.0, 1.0]));
        check(Mapping { interpolate: 3, ..plain }, [0.25, 0.25, 0.0], Some([0.25, 1.0]));
        check(Mapping { interpolate: 3, ..plain }, [0.2, 0.3, 0.0], Some([0.006, 0.972]));
        check(Mapping { interpolate: 4, ..plain }, [0.25, 0.25, 0.0], Some([0.5, 0.8333]));
        check(Mapping { interpolate: 4, ..plain }, [0.2, 0.3, 0.0], Some([0.1995, 0.8645]));
        check(Mapping { offset: [0.25, 0.5], ..plain }, [0.3, 0.1, 0.0], Some([0.0, 0.0]));
        check(Mapping { repeat: [2.0, 3.0], ..plain }, [0.2, 0.2, 0.0], Some([1.0, 0.0]));
        check(Mapping { repeat: [2.0, 1.0], ..once }, [0.49, 0.2, 0.0], Some([3.0, 1.0]));
        check(Mapping { repeat: [2.0, 1.0], ..once }, [0.6, 0.2, 0.0], None);
    }
}
