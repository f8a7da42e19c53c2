//! OpenEXR out: which channels stand in which part, and what the headers say.
//!
//! Colours are channels `R`, `G`, `B` and, where there is transparency, `A`; layers are
//! `name.channel`, as Blender, Nuke and OpenImageIO read them. A part of a picture has a data window
//! inside the full picture's display window.

use super::exr_blocks::{self, Channel, Samples};
use super::{Encoding, ImageError, Metadata, Picture};
use exr::block::writer::ChunksWriter as _;
use exr::meta::BlockDescription;
use exr::meta::attribute::{ChannelDescription, LineOrder, SampleType};
use exr::meta::header::{Header, ImageAttributes};
use exr::prelude::{Compression, IntegerBounds, LayerAttributes, Text, Vec2, attribute::AttributeValue};
use half::vec::HalfFloatVecExt as _;
use std::io::Cursor;
use std::path::Path;

/// What a part's header calls the space of its values. Chromaticities beside it would be a second say.
///
/// Source: Color Interop Forum, "Color Space Encodings for Texture Assets and CG Rendering", 2026.
pub(super) const COLOR_SPACE: &str = "colorInteropID";
/// Linear light in the primaries of Rec. 709, referred to the scene.
const LIGHT: &str = "lin_rec709_scene";
/// Numbers that are no colours: no change of colour space may touch them.
pub(super) const DATA: &str = "data";

/// The bytes of an EXR file: scan lines, ZIP compressed, colours in half precision unless single is wanted.
///
/// Layers are always single precision, because positions and depths need it. With `encoding.parts` those that are no
/// colours stand in a part of their own, if there are any.
///
/// # Errors
/// [`ImageError::Invalid`] for a picture that the format cannot hold, such as one of no size.
pub(super) fn encode_exr(
    path: &Path,
    picture: &Picture,
    metadata: &Metadata,
    encoding: &Encoding,
) -> Result<Vec<u8>, ImageError> {
    let parts = parts(picture, encoding);
    let headers = parts.iter().map(|part| part.header(picture, metadata)).collect();
    let size = [picture.width, picture.height];
    let mut bytes = Cursor::new(Vec::new());
    let write = |_, writer: &mut exr::block::writer::ChunkWriter<_>| {
        parts.iter().enumerate().try_for_each(|(number, part)| {
            let mut chunks =
                exr_blocks::blocks(number, &part.channels, size, picture.origin[1]).into_iter().enumerate();
            chunks.try_for_each(|(i, chunk)| writer.write_chunk(i, chunk))
        })
    };
    exr::block::write(&mut bytes, headers, true, write)
        .map_err(|error| ImageError::Invalid(path.to_owned(), error.to_string()))?;
    let mut bytes = bytes.into_inner();
    sort_attributes(&mut bytes, parts.len());
    Ok(bytes)
}

/// A picture within the file.
struct Part<'p> {
    /// None where it is the only one.
    name: &'static str,
    space: &'static str,
    /// By name, which is the order of the format.
    channels: Vec<Channel<'p>>,
    attributes: Vec<&'p (String, String)>,
}

/// Everything together, or colours before data.
fn parts<'p>(picture: &'p Picture, encoding: &Encoding) -> Vec<Part<'p>> {
    let has_two = encoding.parts && picture.layers.iter().any(|layer| !layer.is_color);
    let color = if has_two { "color" } else { "" };
    let mut parts = vec![Part::new(color, LIGHT, color_channels(picture, encoding.float))];
    if has_two {
        parts.push(Part::new("data", DATA, Vec::new()));
    }
    for layer in &picture.layers {
        let part = &mut parts[usize::from(has_two && !layer.is_color)];
        part.channels.extend(layer.channels.iter().map(|(channel, values)| {
            let name = if layer.name.is_empty() { channel.clone() } else { format!("{}.{channel}", layer.name) };
            Channel { name: utf8(&name), samples: Samples::Float(values.into()) }
        }));
        part.attributes.extend(&layer.attributes);
    }
    parts.iter_mut().for_each(|part| part.channels.sort_by(|a, b| a.name.cmp(&b.name)));
    parts
}

fn color_channels(picture: &Picture, float: bool) -> Vec<Channel<'static>> {
    let names = if picture.has_alpha { &["R", "G", "B", "A"][..] } else { &["R", "G", "B"] };
    let channel = |(i, name): (usize, &&str)| {
        let values: Vec<f32> = picture.pixels.iter().map(|p| p[i]).collect();
        let samples = if float { Samples::Float(values.into()) } else { Samples::Half(Vec::from_f32_slice(&values)) };
        Channel { name: utf8(name), samples }
    };
    names.iter().enumerate().map(channel).collect()
}

impl<'p> Part<'p> {
    fn new(name: &'static str, space: &'static str, channels: Vec<Channel<'p>>) -> Self {
        Self { name, space, channels, attributes: Vec::new() }
    }

    fn header(&self, picture: &Picture, metadata: &Metadata) -> Header {
        let full = IntegerBounds::new(Vec2(0, 0), Vec2(picture.full[0], picture.full[1]));
        let size = Vec2(picture.width, picture.height);
        Header::new(Text::default(), size, self.channels.iter().map(described).collect())
            .with_encoding(Compression::ZIP16, BlockDescription::ScanLines, LineOrder::Increasing)
            .with_attributes(self.attributes(picture, metadata))
            .with_shared_attributes(ImageAttributes::new(full))
    }

    fn attributes(&self, picture: &Picture, metadata: &Metadata) -> LayerAttributes {
        let layer_position = Vec2(picture.origin[0], picture.origin[1]);
        let text = |value: &str| (!value.is_empty()).then(|| utf8(value));
        let mut attributes = LayerAttributes {
            layer_position,
            layer_name: text(self.name),
            software_name: text(&metadata.software),
            comments: text(&metadata.options),
            world_to_camera: metadata.projection.map(|projection| projection.camera_from_world),
            world_to_normalized_device: metadata.projection.map(|projection| projection.picture_from_world),
            ..LayerAttributes::default()
        };
        let mut words = vec![(COLOR_SPACE, self.space), ("scene", &metadata.scene), ("camera", &metadata.camera)];
        words.extend(self.attributes.iter().map(|(name, value)| (name.as_str(), value.as_str())));
        words.extend(metadata.notes.iter().map(|(name, value)| (*name, value.as_str())));
        for (name, value) in words {
            attributes.other.extend(text(value).map(|value| (utf8(name), AttributeValue::Text(value))));
        }
        if metadata.rays > 0 {
            attributes.other.insert(utf8("rays"), AttributeValue::F64(metadata.rays as f64));
        }
        for (name, value) in &metadata.figures {
            attributes.other.insert(utf8(name), AttributeValue::F64(*value));
        }
        attributes
    }
}

/// As the format wants it: the library's own way from text refuses what is not Latin-1.
fn utf8(text: &str) -> Text {
    Text::from_slice_unchecked(text.as_bytes())
}

/// A channel as the header has it.
fn described(channel: &Channel<'_>) -> ChannelDescription {
    ChannelDescription {
        name: channel.name.clone(),
        sample_type: if matches!(channel.samples, Samples::Half(_)) { SampleType::F16 } else { SampleType::F32 },
        // pLinear tells packing with loss that even steps look even. Light is seen by ratios; other numbers have no
        // such packing, and false is what OpenEXR's own library writes. Source: OpenEXR, ImfChannelList.h.
        quantize_linearly: false,
        sampling: Vec2(1, 1),
    }
}

/// Puts the attributes of each header in the order of their names: the library's order is another for each file.
///
/// An attribute is a name and a type, each with a zero behind it, the size of its value and the value; a zero in the
/// place of a name ends the header. Headers follow one another. Source: OpenEXR, "File Layout", 2013.
fn sort_attributes(file: &mut [u8], n_headers: usize) {
    const MAGIC_AND_VERSION: usize = 8;
    (0..n_headers).fold(MAGIC_AND_VERSION, |from, _| sort_header(file, from) + 1);
}

/// Sorts the header that begins there; where the zero stands that ends it.
fn sort_header(file: &mut [u8], from: usize) -> usize {
    let attribute = |from: usize| -> Option<usize> {
        let word = |from: usize| Some(from + file.get(from..)?.iter().position(|byte| *byte == 0)? + 1);
        let size = word(word(from)?)?;
        let length = file.get(size..size + 4)?.try_into().ok().map(u32::from_le_bytes)?;
        (file[from] != 0).then_some(size + 4 + length as usize)
    };
    let ends = std::iter::successors(Some(from), |from| attribute(*from)).collect::<Vec<_>>();
    let mut attributes: Vec<Vec<u8>> =
        ends.windows(2).filter_map(|ends| Some(file.get(ends[0]..ends[1])?.to_vec())).collect();
    attributes.sort();
    let sorted = attributes.concat();
    file[from..from + sorted.len()].copy_from_slice(&sorted);
    from + sorted.len()
}
