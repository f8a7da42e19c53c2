//! OpenEXR in and out.
//!
//! Colours are channels `R`, `G`, `B` and, where there is transparency, `A`; layers are
//! `name.channel`, as Blender, Nuke and OpenImageIO read them. A part of a picture has a data window
//! inside the full picture's display window.

use super::exr_blocks::{self, Channel, Samples};
use super::{ImageError, Layer, Metadata, Picture};
use exr::block::writer::ChunksWriter as _;
use exr::meta::attribute::{ChannelDescription, LineOrder, SampleType};
use exr::meta::header::{Header, ImageAttributes};
use exr::meta::{BlockDescription, MetaData};
use exr::prelude::{Compression, IntegerBounds, LayerAttributes, Text, Vec2, attribute::AttributeValue};
use exr::prelude::{ReadChannels, ReadLayers};
use half::vec::HalfFloatVecExt as _;
use std::io::Cursor;
use std::path::Path;

/// The bytes of an EXR file: scan lines, ZIP compressed, colours in half precision unless `float`.
///
/// Layers are always single precision, because positions and depths need it.
///
/// # Errors
/// [`ImageError::Invalid`] for a picture that the format cannot hold, such as one of no size.
pub(super) fn encode_exr(
    path: &Path,
    picture: &Picture,
    metadata: &Metadata,
    float: bool,
) -> Result<Vec<u8>, ImageError> {
    let channels = channels(picture, float);
    let describe = |channel: &Channel<'_>| {
        let kind = if matches!(channel.samples, Samples::Half(_)) { SampleType::F16 } else { SampleType::F32 };
        ChannelDescription::named(channel.name.clone(), kind)
    };
    let full = IntegerBounds::new(Vec2(0, 0), Vec2(picture.full[0], picture.full[1]));
    let size = Vec2(picture.width, picture.height);
    let header = Header::new(Text::default(), size, channels.iter().map(describe).collect())
        .with_encoding(Compression::ZIP16, BlockDescription::ScanLines, LineOrder::Increasing)
        .with_attributes(attributes(picture, metadata))
        .with_shared_attributes(ImageAttributes::new(full));
    let chunks = exr_blocks::blocks(&channels, [picture.width, picture.height], picture.origin[1]);
    let mut bytes = Cursor::new(Vec::new());
    let write = |_, writer: &mut exr::block::writer::ChunkWriter<_>| {
        chunks.into_iter().enumerate().try_for_each(|(i, chunk)| writer.write_chunk(i, chunk))
    };
    exr::block::write(&mut bytes, [header].into_iter().collect(), true, write).map_err(|e| invalid(path, &e))?;
    let mut bytes = bytes.into_inner();
    sort_attributes(&mut bytes);
    Ok(bytes)
}

/// Puts the attributes of the header in the order of their names: the library's order is another for each file.
///
/// An attribute is a name and a type, each with a zero behind it, the size of its value and the value; a zero in the
/// place of a name ends the header. Source: OpenEXR, "File Layout", 2013.
fn sort_attributes(file: &mut [u8]) {
    const MAGIC_AND_VERSION: usize = 8;
    let attribute = |from: usize| -> Option<usize> {
        let word = |from: usize| Some(from + file.get(from..)?.iter().position(|byte| *byte == 0)? + 1);
        let size = word(word(from)?)?;
        let length = file.get(size..size + 4)?.try_into().ok().map(u32::from_le_bytes)?;
        (file[from] != 0).then_some(size + 4 + length as usize)
    };
    let ends = std::iter::successors(Some(MAGIC_AND_VERSION), |from| attribute(*from)).collect::<Vec<_>>();
    let mut attributes: Vec<Vec<u8>> =
        ends.windows(2).filter_map(|ends| Some(file.get(ends[0]..ends[1])?.to_vec())).collect();
    attributes.sort();
    let sorted = attributes.concat();
    file[MAGIC_AND_VERSION..MAGIC_AND_VERSION + sorted.len()].copy_from_slice(&sorted);
}

/// Colours and layers by name, which is the order of the format.
fn channels(picture: &Picture, float: bool) -> Vec<Channel<'_>> {
    let mut channels = Vec::new();
    let names = if picture.has_alpha { &["R", "G", "B", "A"][..] } else { &["R", "G", "B"] };
    for (i, &name) in names.iter().enumerate() {
        let values: Vec<f32> = picture.pixels.iter().map(|p| p[i]).collect();
        let samples = if float { Samples::Float(values.into()) } else { Samples::Half(Vec::from_f32_slice(&values)) };
        channels.push(Channel { name: Text::from(name), samples });
    }
    for layer in &picture.layers {
        for (channel, values) in &layer.channels {
            let name = if layer.name.is_empty() { channel.clone() } else { format!("{}.{channel}", layer.name) };
            channels.push(Channel { name: Text::from(name.as_str()), samples: Samples::Float(values.into()) });
        }
    }
    channels.sort_by(|a, b| a.name.cmp(&b.name));
    channels
}

fn attributes(picture: &Picture, metadata: &Metadata) -> LayerAttributes {
    let layer_position = Vec2(picture.origin[0], picture.origin[1]);
    let mut attributes = LayerAttributes { layer_position, ..LayerAttributes::default() };
    for (name, value) in picture.layers.iter().flat_map(|layer| &layer.attributes) {
        attributes.other.insert(Text::from(name.as_str()), AttributeValue::Text(Text::from(value.as_str())));
    }
    // Linear light in the primaries of Rec. 709, referred to the scene; chromaticities beside it would be a second say.
    // Source: Color Interop Forum, "Color Space Encodings for Texture Assets and CG Rendering", 2026.
    attributes.other.insert(Text::from("colorInteropID"), AttributeValue::Text(Text::from("lin_rec709_scene")));
    if !metadata.software.is_empty() {
        attributes.software_name = Some(Text::from(metadata.software.as_str()));
    }
    if let Some(projection) = &metadata.projection {
        attributes.world_to_camera = Some(projection.camera_from_world);
        attributes.world_to_normalized_device = Some(projection.picture_from_world);
    }
    for (name, value) in [("scene", &metadata.scene), ("camera", &metadata.camera)] {
        if !value.is_empty() {
            attributes.other.insert(Text::from(name), AttributeValue::Text(Text::from(value.as_str())));
        }
    }
    if metadata.rays > 0 {
        attributes.other.insert(Text::from("rays"), AttributeValue::F64(metadata.rays as f64));
    }
    for (name, value) in &metadata.figures {
        attributes.other.insert(Text::from(name.as_str()), AttributeValue::F64(*value));
    }
    for (name, value) in &metadata.notes {
        attributes.other.insert(Text::from(*name), AttributeValue::Text(Text::from(value.as_str())));
    }
    attributes
}

/// Reads the first part of an EXR file: its colours, and every other channel as a layer.
///
/// A file with only `Y` gives grey.
///
/// # Errors
/// [`ImageError`] when the file cannot be read, is damaged or holds no colour.
pub fn read_exr(path: &Path) -> Result<Picture, ImageError> {
    let bytes = std::fs::read(path).map_err(|e| ImageError::Io(path.to_owned(), e))?;
    decode_exr(path, &bytes)
}

/// The numbers in the header of an EXR file's first part that the format itself does not know, by name.
///
/// # Errors
/// [`ImageError`] when the file cannot be read or is damaged.
pub fn read_exr_figures(path: &Path) -> Result<Vec<(String, f64)>, ImageError> {
    let file = std::fs::File::open(path).map_err(|e| ImageError::Io(path.to_owned(), e))?;
    let meta = MetaData::read_from_buffered(std::io::BufReader::new(file), false).map_err(|e| invalid(path, &e))?;
    let others = meta.headers.into_iter().take(1).flat_map(|header| header.own_attributes.other);
    let mut figures: Vec<(String, f64)> = others
        .filter_map(|(name, value)| match value {
            AttributeValue::F64(number) => Some((name.to_string(), number)),
            AttributeValue::F32(number) => Some((name.to_string(), f64::from(number))),
            _ => None,
        })
        .collect();
    figures.sort_by(|a, b| a.0.cmp(&b.0));
    Ok(figures)
}

/// Decodes the bytes of an EXR file as [`read_exr`] does; `path` is what errors call it.
pub(super) fn decode_exr(path: &Path, bytes: &[u8]) -> Result<Picture, ImageError> {
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(|e| invalid(path, &e))?;
    let Vec2(width, height) = image.layer_data.size;
    let mut picture = Picture::filled(width, height, [0.0, 0.0, 0.0, 1.0]);
    let (window, position) = (image.attributes.display_window, image.layer_data.attributes.layer_position);
    picture.origin =
        [position.x().saturating_sub(window.position.x()), position.y().saturating_sub(window.position.y())];
    picture.full = [window.size.width(), window.size.height()];
    let mut has_color = false;
    for channel in image.layer_data.channel_data.list {
        let values: Vec<f32> = channel.sample_data.values_as_f32().collect();
        let name = channel.name.to_string();
        let component = ["R", "G", "B", "A"].iter().position(|n| *n == name);
        match (component, name.rsplit_once('.')) {
            (Some(i), _) => {
                has_color |= i < 3;
                picture.has_alpha |= i == 3;
                picture.pixels.iter_mut().zip(&values).for_each(|(p, v)| p[i] = *v);
            }
            (None, _) if name == "Y" => {
                has_color = true;
                picture.pixels.iter_mut().zip(&values).for_each(|(p, v)| p[..3].fill(*v));
            }
            (None, Some((layer, suffix))) => add_channel(&mut picture.layers, layer, suffix, values),
            (None, None) => add_channel(&mut picture.layers, "", &name, values),
        }
    }
    if has_color {
        Ok(picture)
    } else {
        Err(ImageError::Unsupported(path.to_owned(), "no channel R, G, B or Y".into()))
    }
}

fn add_channel(layers: &mut Vec<Layer>, layer: &str, suffix: &str, values: Vec<f32>) {
    match layers.iter_mut().find(|l| l.name == layer) {
        Some(found) => found.channels.push((suffix.into(), values)),
        None => {
            layers.push(Layer { name: layer.into(), channels: vec![(suffix.into(), values)], attributes: Vec::new() })
        }
    }
}

fn invalid(path: &Path, error: &exr::error::Error) -> ImageError {
    ImageError::Invalid(path.to_owned(), error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check([width, height]: [usize; 2], float: bool, has_alpha: bool) {
        let mut picture = Picture::filled(width, height, [0.25, 1.5, -0.5, 1.0]);
        picture.pixels[1] = [65504.0, 0.0, 1.0, if has_alpha { 0.5 } else { 1.0 }];
        picture.has_alpha = has_alpha;
        let depth: Vec<f32> = (0..width * height).map(|i| i as f32 / 3.0).collect();
        let layer = |name: &str| Layer {
            name: name.into(),
            channels: vec![("Z".into(), depth.clone())],
            attributes: Vec::new(),
        };
        picture.layers.extend([layer(""), layer("depth")]);
        (picture.origin, picture.full) = ([5, 7], [60, 50]);
        let path = Path::new("a.exr");
        let metadata = Metadata { software: "test".into(), rays: 7, ..Metadata::default() };
        let bytes = encode_exr(path, &picture, &metadata, float).unwrap();
        assert_eq!(decode_exr(path, &bytes).unwrap(), picture);
    }

    #[test]
    fn what_is_written_is_read_back() {
        // Too small to be packed, then three blocks that are.
        for size in [[3, 2], [40, 37]] {
            check(size, false, false);
            check(size, true, true);
        }
    }

    #[test]
    fn figures_are_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.exr");
        let figures = vec![("whitted:shadowRays".to_owned(), 5.0)];
        let metadata = Metadata { rays: 7, figures, ..Metadata::default() };
        let picture = Picture::filled(2, 2, [0.5, 0.5, 0.5, 1.0]);
        std::fs::write(&path, encode_exr(&path, &picture, &metadata, false).unwrap()).unwrap();
        let expected = [("rays".to_owned(), 7.0), ("whitted:shadowRays".to_owned(), 5.0)];
        assert_eq!(read_exr_figures(&path).unwrap(), expected);
    }

    #[test]
    fn damaged_files_are_refused() {
        assert!(decode_exr(Path::new("a.exr"), b"not an exr file").is_err());
        assert!(decode_exr(Path::new("a.exr"), b"").is_err());
    }
}
