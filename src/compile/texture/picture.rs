//! Pictures that scenes name, brought into the scene's working space.

use super::pattern::mapping_of;
use super::{Refusal, TextureCompiler};
use crate::compile::picture::{Curve, Making, stored_level};
use crate::compiled::texture::{ImageMap, Raster, Texels, Transparency};
use crate::function::Translate as _;
use crate::imaging::{self, Pixels, Samples};
use crate::scene::{self, Gamma, ImageFormat, ImageSource, Working};
use std::sync::Arc;

impl TextureCompiler<'_> {
    /// `image_map`: colours in working space with the map's own `filter` and `transmit`.
    pub(super) fn image_map(&mut self, map: &scene::ImageMap) -> Result<ImageMap, Refusal> {
        let raster = self.raster(&map.image, |format, pixels| color_curve(&map.image, format, pixels))?;
        let transparency = transparency(map, raster.indices.is_some());
        Ok(ImageMap { raster, mapping: mapping_of(&map.mapping), transparency })
    }

    /// Pictures whose numbers are values, not colours: raw unless a `gamma` was written.
    pub(super) fn value_picture(&mut self, image: &scene::Image) -> Result<Arc<Raster>, Refusal> {
        self.raster(image, |_, _| Curve { decode: image.gamma, encode: None })
    }

    fn raster(
        &mut self,
        image: &scene::Image,
        curve: impl FnOnce(ImageFormat, &Pixels) -> Curve,
    ) -> Result<Arc<Raster>, Refusal> {
        self.raster_of(image, curve).map_err(|r| r.at(image.span))
    }

    fn raster_of(
        &mut self,
        image: &scene::Image,
        curve: impl FnOnce(ImageFormat, &Pixels) -> Curve,
    ) -> Result<Arc<Raster>, Refusal> {
        match &image.source {
            ImageSource::File { file, format } => {
                if *format == ImageFormat::Pot {
                    return Err(format!("{}: pot files are for height fields only", file.path().display()).into());
                }
                let pixels = file.pixels()?;
                let curve = curve(*format, &pixels);
                let made = Making::File(Arc::clone(file), curve, image.premultiplied);
                Ok(self.functions.pictures.raster(made, |_| to_raster(&pixels, &curve, image.premultiplied)))
            }
            ImageSource::Function { width, height, function } => {
                let made = Making::Function(Arc::clone(function), [*width, *height]);
                let function = self.functions.function(function)?;
                Ok(self.functions.pictures.raster(made, |_| sampled(*width, *height, &function)))
            }
        }
    }
}

/// Palette entries take their own transparency; in other pictures `all` adds to what the file says.
fn transparency(map: &scene::ImageMap, is_palette: bool) -> Transparency {
    let all = [map.filter_all, map.transmit_all];
    if !is_palette {
        let more = all.map(|all| all.unwrap_or(0.0));
        return if more == [0.0; 2] { Transparency::AsItIs } else { Transparency::Added(more) };
    }
    if all == [None; 2] && map.palette_filter.is_empty() && map.palette_transmit.is_empty() {
        return Transparency::AsItIs;
    }
    let mut entries = Box::new([all; 256]);
    for (which, list) in [&map.palette_filter, &map.palette_transmit].into_iter().enumerate() {
        for (index, value) in list {
            if let Some(entry) = entries.get_mut(*index as usize) {
                entry[which] = Some(*value);
            }
        }
    }
    Transparency::Palette(entries)
}

impl Curve {
    fn apply(&self, v: f32) -> f32 {
        let linear = match self.decode {
            None => v,
            Some(Working::Srgb) => imaging::linear_from_srgb(v),
            Some(working) if working.is_linear() => v,
            Some(Working::Power(gamma)) => power(v, gamma),
        };
        match self.encode {
            None => linear,
            Some(Working::Srgb) => imaging::srgb_from_linear(linear),
            Some(working) if working.is_linear() => linear,
            Some(Working::Power(gamma)) => power(linear, 1.0 / gamma),
        }
    }
}

/// A curve with the values that it gave last: pictures have few different ones, and powers are slow.
struct Memo<'a> {
    curve: &'a Curve,
    /// What a value became, at a place that its bits choose.
    known: Vec<(f32, f32)>,
}

impl<'a> Memo<'a> {
    /// Room for the values of 8 bits without many meeting in one place.
    const PLACES: u32 = 4096;

    fn new(curve: &'a Curve) -> Self {
        Self { curve, known: vec![(0.0, curve.apply(0.0)); Self::PLACES as usize] }
    }

    fn apply(&mut self, v: f32) -> f32 {
        /// Source of the multiplier: Knuth, The Art of Computer Programming, volume 3, section 6.4.
        const GOLDEN: u32 = 0x9e37_79b1;
        let place = v.to_bits().wrapping_mul(GOLDEN) >> (u32::BITS - Self::PLACES.ilog2());
        let known = &mut self.known[place as usize];
        if known.0.to_bits() != v.to_bits() {
            *known = (v, self.curve.apply(v));
        }
        known.1
    }
}

/// A power law, which takes what is below 0 for 0.
fn power(v: f32, gamma: f64) -> f32 {
    f64::from(v.max(0.0)).powf(gamma) as f32
}

/// Section 12 of the freeform facts.
fn color_curve(image: &scene::Image, format: ImageFormat, pixels: &Pixels) -> Curve {
    let own = match format {
        ImageFormat::Exr | ImageFormat::Hdr => Some(Working::Power(1.0)),
        _ if pixels.srgb => Some(Working::Srgb),
        _ => pixels.gamma.map(Working::Power),
    };
    let Gamma::Linear(working) = image.mode else { return Curve { decode: image.gamma, encode: None } };
    let assumed = match format {
        ImageFormat::Pnm | ImageFormat::Tiff => None,
        _ => (!image.legacy).then_some(Working::Srgb),
    };
    match image.gamma.or(own).or(assumed) {
        Some(decode) => Curve { decode: Some(decode), encode: Some(working) },
        None => Curve { decode: None, encode: None },
    }
}

fn to_raster(pixels: &Pixels, curve: &Curve, premultiplied: Option<bool>) -> Raster {
    // Grey of up to 8 bits is stored in 8 bits again after decoding, as in POV-Ray.
    let requantised = |v: f32| ((255.0 * (0.297 * v + 0.589 * v + 0.114 * v)) as u32 as f32) / 255.0;
    let texels = match &pixels.samples {
        Samples::Bytes(bytes) => {
            let value = |v: usize| {
                let value = curve.apply(v as f32 / 255.0);
                if pixels.grey8 { requantised(value) } else { value }
            };
            Texels::Bytes(Arc::clone(bytes), Box::new(std::array::from_fn(value)))
        }
        Samples::Floats(floats) if *curve == (Curve { decode: None, encode: None }) => {
            Texels::Floats(Arc::clone(floats))
        }
        Samples::Floats(floats) => {
            let mut curve = Memo::new(curve);
            let floats = floats.iter().map(|[r, g, b, a]| [curve.apply(*r), curve.apply(*g), curve.apply(*b), *a]);
            Texels::Floats(Arc::new(floats.collect()))
        }
    };
    Raster {
        width: pixels.width,
        height: pixels.height,
        texels,
        indices: pixels.indices.clone(),
        premultiplied: premultiplied.unwrap_or(pixels.premultiplied),
        has_alpha: pixels.has_alpha,
    }
}

/// `function W, H { … }`: sampled from corner to corner, the top row at y = 0, in 16 bits that wrap around.
///
/// Source: section 8.2 of the function facts; a picture one pixel wide is sampled at 0 / 0, as in POV-Ray.
fn sampled(width: u32, height: u32, function: &crate::compiled::Function) -> Raster {
    let quantise = |v: f64| (stored_level(v) / 65535.0) as f32;
    let scalar = function.width() == 1;
    let pixel = |x: u32, y: u32| {
        let at = [f64::from(x) / (f64::from(width) - 1.0), f64::from(y) / (f64::from(height) - 1.0), 0.0];
        let v = function.call(&at);
        if scalar {
            return [quantise(v[0]), quantise(v[0]), quantise(v[0]), 1.0];
        }
        [quantise(v[0]), quantise(v[1]), quantise(v[2]), quantise(1.0 - v[4])]
    };
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| pixel(x, y)).collect();
    Raster {
        width: width as usize,
        height: height as usize,
        texels: Texels::Floats(Arc::new(pixels)),
        indices: None,
        premultiplied: false,
        has_alpha: !scalar,
    }
}

#[cfg(test)]
mod tests {
    use crate::compile::{Queries, compile};
    use crate::compiled::texture::{Layer, Pigment, Raster, Texture};
    use crate::eval::{Memory, Options, evaluate};
    use std::sync::Arc;

    /// The pigments of the textures of a scene with a small picture `a.ppm`.
    fn pigments(text: &str) -> Vec<Pigment> {
        let scene = format!("#version 3.7; global_settings {{ assumed_gamma 1 }}\n{text}");
        let picture = b"P6\n2 1\n255\n\xff\x00\xff\x00\x00\xff".to_vec();
        let host = Memory::new([("a.pov", scene.as_str())]).with("a.ppm", picture);
        let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()).unwrap();
        let world = compile(&read.scene).unwrap().world;
        let layer = |texture: Texture| match texture {
            Texture::Layers(mut layers) => layers.pop().unwrap().pigment,
            Texture::Patterned(_) => panic!("no patterned texture was written"),
        };
        // The texture of objects without one is among them.
        world.textures.into_iter().map(layer).filter(|p| !matches!(p, Pigment::Solid(_))).collect()
    }

    fn raster(pigment: &Pigment) -> &Arc<Raster> {
        match pigment {
            Pigment::Image(_, map) => &map.raster,
            other => panic!("{other:?} shows no picture"),
        }
    }

    /// The textures of these objects show the same picture in memory.
    fn check(text: &str, n: usize) {
        let pigments = pigments(text);
        assert_eq!(pigments.len(), n, "{text}");
        assert!(pigments.iter().all(|p| Arc::ptr_eq(raster(p), raster(&pigments[0]))), "{text}");
    }

    #[test]
    fn a_picture_is_held_once() {
        let declared = "#declare P = pigment { image_map { ppm \"a.ppm\" interpolate 2 } }";
        check(&format!("{declared} #for (I, 1, 5) sphere {{ I*x, 1 pigment {{ P translate I*y }} }} #end"), 5);
        let texture = format!("{declared} #declare T = texture {{ pigment {{ P }} finish {{ phong .5 }} }}");
        check(&format!("{texture} #for (I, 1, 5) sphere {{ I*x, 1 texture {{ T scale I }} }} #end"), 5);
        let written = "#for (I, 1, 5) sphere { I*x, 1 pigment { image_map { ppm \"a.ppm\" transmit all I/9 } } } #end";
        check(written, 5);
        check("#for (I, 1, 3) plane { y, I pigment { image_map { ppm \"a.ppm\" once } rotate I*x } } #end", 3);
    }

    #[test]
    fn maps_and_finishes_are_held_once() {
        let text = "#declare P = pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } }
            #for (I, 1, 5) sphere { I*x, 1 pigment { P scale I } } #end";
        let pigments = pigments(text);
        let colors = |p: &Pigment| match p {
            Pigment::Colors(_, colors) => Arc::as_ptr(colors),
            other => panic!("{other:?}"),
        };
        assert!(pigments.len() == 5 && pigments.iter().all(|p| colors(p) == colors(&pigments[0])));
        // A hundred thousand objects have a texture each.
        assert!(size_of::<Layer>() <= 80 && size_of::<crate::scene::Pigment>() <= 56);
    }
}
