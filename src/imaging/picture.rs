//! The pixel buffer with its extra layers and what is said about it.

/// A rendered or loaded picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Where the upper left pixel stands in the full picture.
    pub origin: [i32; 2],
    /// Pixels across and down of the full picture, of which this may be a part.
    pub full: [usize; 2],
    /// Height x width x RGBA, row-major, top row first, linear light, premultiplied.
    pub pixels: Vec<[f32; 4]>,
    /// Whether alpha means anything; otherwise it is 1 everywhere and not written.
    pub has_alpha: bool,
    /// Further values for each pixel, such as depth.
    pub layers: Vec<Layer>,
}

/// Named channels beside the colours, each height x width.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Prefix of the channel names in the file, as `depth` in `depth.Z`; empty for channels without.
    pub name: String,
    /// Whether it is a colour in linear light, for which the file's colour space holds; other layers are data.
    pub is_color: bool,
    /// Channel suffix and values.
    pub channels: Vec<(String, Vec<f32>)>,
    /// What the file's header says about the layer: names and texts.
    pub attributes: Vec<(String, String)>,
}

/// What a file says about the picture beside its pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Metadata {
    /// Program and version.
    pub software: String,
    /// The scene file.
    pub scene: String,
    /// The options that made it, in words.
    pub options: String,
    /// The camera in words.
    pub camera: String,
    /// From world space to the camera's and to the picture's, where a matrix can say it.
    pub projection: Option<Projection>,
    /// Rays shot, shadow rays included.
    pub rays: u64,
    /// Further figures of what was done, under names as `whitted:cameraRays`.
    pub figures: Vec<(String, f64)>,
    /// Further words, by name.
    pub notes: Vec<(&'static str, String)>,
}

/// How points of the world come into the picture: rows of matrices that stand behind a row of coordinates.
///
/// Source: OpenEXR, "Standard Attributes", worldToCamera and worldToNDC.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// To camera space: x to the right, y up, z ahead.
    pub camera_from_world: [f32; 16],
    /// To the picture: 0,0 in its upper left corner, 1,1 in its lower right one.
    pub picture_from_world: [f32; 16],
}

impl Picture {
    /// One colour everywhere.
    pub fn filled(width: usize, height: usize, pixel: [f32; 4]) -> Self {
        Self {
            width,
            height,
            origin: [0, 0],
            full: [width, height],
            pixels: vec![pixel; width * height],
            has_alpha: false,
            layers: Vec::new(),
        }
    }

    /// The full picture: black and opaque where this part of it is not. Layers are left out.
    pub fn completed(&self) -> Self {
        let mut full = Self::filled(self.full[0], self.full[1], [0.0, 0.0, 0.0, 1.0]);
        full.has_alpha = self.has_alpha;
        let [left, top] = self.origin.map(|start| usize::try_from(start).unwrap_or(0));
        for (row, y) in self.pixels.chunks(self.width.max(1)).zip(top..) {
            let start = y * full.width + left;
            full.pixels[start..start + row.len()].copy_from_slice(row);
        }
        full
    }

    /// The pixel in column `x` of row `y`.
    pub fn pixel(&self, x: usize, y: usize) -> [f32; 4] {
        self.pixels[y * self.width + x]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_completed_in_their_place() {
        let part = Picture { origin: [1, 1], full: [4, 3], ..Picture::filled(2, 2, [1.0; 4]) };
        let full = part.completed();
        let lit: Vec<usize> = (0..12).filter(|i| full.pixels[*i] == [1.0; 4]).collect();
        assert_eq!((lit, full.pixel(0, 0), full.pixels.len()), (vec![5, 6, 9, 10], [0.0, 0.0, 0.0, 1.0], 12));
    }
}
