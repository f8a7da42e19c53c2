//! OpenEXR in: colours, and every other channel as a layer.

use super::exr_write::{COLOR_SPACE, DATA};
use super::{ImageError, Layer, Picture};
use exr::meta::MetaData;
use exr::prelude::{AnyChannels, FlatSamples, ReadChannels, ReadLayers, Vec2, attribute::AttributeValue};
use std::io::Cursor;
use std::path::Path;

/// Reads an EXR file: the colours of its first part, and every other channel as a layer, also of further parts that
/// show the same pixels.
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

/// A part of a file.
type Part = exr::image::Layer<AnyChannels<FlatSamples>>;

/// Decodes the bytes of an EXR file as [`read_exr`] does; `path` is what errors call it.
pub(super) fn decode_exr(path: &Path, bytes: &[u8]) -> Result<Picture, ImageError> {
    let (window, parts) = read_parts(bytes).map_err(|e| invalid(path, &e))?;
    let Some(first) = parts.first() else {
        return Err(ImageError::Unsupported(path.to_owned(), "no part that is a picture".into()));
    };
    let Vec2(width, height) = first.size;
    let position = first.attributes.layer_position;
    let mut picture = Picture::filled(width, height, [0.0, 0.0, 0.0, 1.0]);
    picture.origin =
        [position.x().saturating_sub(window.position.x()), position.y().saturating_sub(window.position.y())];
    picture.full = [window.size.width(), window.size.height()];
    let mut has_color = false;
    for part in parts.iter().filter(|part| (part.size, part.attributes.layer_position) == (first.size, position)) {
        has_color |= add_part(&mut picture, part, has_color);
    }
    if has_color {
        Ok(picture)
    } else {
        Err(ImageError::Unsupported(path.to_owned(), "no channel R, G, B or Y".into()))
    }
}

/// All parts and the window that they share; of files with parts of kinds that we do not know, the first that we do.
fn read_parts(bytes: &[u8]) -> exr::error::Result<(exr::prelude::IntegerBounds, Vec<Part>)> {
    let reader = || exr::prelude::read().no_deep_data().largest_resolution_level().all_channels();
    match reader().all_layers().all_attributes().from_buffered(Cursor::new(bytes)) {
        Ok(image) => Ok((image.attributes.display_window, image.layer_data.into_vec())),
        Err(_) => {
            let image = reader().first_valid_layer().all_attributes().from_buffered(Cursor::new(bytes))?;
            Ok((image.attributes.display_window, vec![image.layer_data]))
        }
    }
}

/// Adds a part's channels: colours unless there are some already, else layers. Whether there were colours.
fn add_part(picture: &mut Picture, part: &Part, has_color: bool) -> bool {
    let space = part.attributes.other.iter().find(|(name, _)| name.eq_case_insensitive(COLOR_SPACE));
    let is_data = space.is_some_and(|(_, value)| matches!(value, AttributeValue::Text(text) if *text == *DATA));
    let name = part.attributes.layer_name.as_ref().map_or_else(String::new, ToString::to_string);
    let mut found = false;
    for channel in &part.channel_data.list {
        let values: Vec<f32> = channel.sample_data.values_as_f32().collect();
        let channel = channel.name.to_string();
        let component = ["R", "G", "B", "A"].iter().position(|n| *n == channel);
        match (component, channel.rsplit_once('.')) {
            (Some(i), _) if !has_color => {
                found |= i < 3;
                picture.has_alpha |= i == 3;
                picture.pixels.iter_mut().zip(&values).for_each(|(p, v)| p[i] = *v);
            }
            (None, _) if !has_color && channel == "Y" => {
                found = true;
                picture.pixels.iter_mut().zip(&values).for_each(|(p, v)| p[..3].fill(*v));
            }
            (_, Some((layer, suffix))) => add_channel(&mut picture.layers, layer, suffix, is_data, values),
            // Colours of a further part go by its name.
            (Some(_), None) => add_channel(&mut picture.layers, &name, &channel, is_data, values),
            (None, None) => add_channel(&mut picture.layers, "", &channel, is_data, values),
        }
    }
    found
}

fn add_channel(layers: &mut Vec<Layer>, layer: &str, suffix: &str, is_data: bool, values: Vec<f32>) {
    match layers.iter_mut().find(|l| l.name == layer) {
        Some(found) => found.channels.push((suffix.into(), values)),
        None => {
            // A file of one part does not say it; names do.
            let is_color = !is_data && ["R", "G", "B"].contains(&suffix);
            layers.push(Layer {
                name: layer.into(),
                is_color,
                channels: vec![(suffix.into(), values)],
                attributes: Vec::new(),
            });
        }
    }
}

fn invalid(path: &Path, error: &exr::error::Error) -> ImageError {
    ImageError::Invalid(path.to_owned(), error.to_string())
}

#[cfg(test)]
mod tests {
    use super::super::exr_write::encode_exr;
    use super::super::{Encoding, Metadata};
    use super::*;

    fn check([width, height]: [usize; 2], float: bool, has_alpha: bool) {
        let mut picture = Picture::filled(width, height, [0.25, 1.5, -0.5, 1.0]);
        picture.pixels[1] = [65504.0, 0.0, 1.0, if has_alpha { 0.5 } else { 1.0 }];
        picture.has_alpha = has_alpha;
        let depth: Vec<f32> = (0..width * height).map(|i| i as f32 / 3.0).collect();
        let layer = |name: &str, channel: &str| Layer {
            name: name.into(),
            is_color: channel == "R",
            channels: vec![(channel.into(), depth.clone())],
            attributes: Vec::new(),
        };
        picture.layers.extend([layer("albedo", "R"), layer("", "Z"), layer("depth", "Z")]);
        (picture.origin, picture.full) = ([5, 7], [60, 50]);
        let path = Path::new("a.exr");
        let metadata = Metadata { software: "test".into(), rays: 7, ..Metadata::default() };
        for parts in [false, true] {
            let encoding = Encoding { float, parts, ..Encoding::default() };
            let bytes = encode_exr(path, &picture, &metadata, &encoding).unwrap();
            let mut read = decode_exr(path, &bytes).unwrap();
            // A part has its channels in the order of their names.
            read.layers.sort_by_key(|layer| picture.layers.iter().position(|known| known.name == layer.name));
            assert_eq!(read, picture);
        }
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
    fn headers_say_what_their_parts_hold() {
        let mut picture = Picture::filled(2, 2, [0.5, 0.5, 0.5, 1.0]);
        let layer = |name: &str, is_color| Layer {
            name: name.into(),
            is_color,
            channels: vec![("R".into(), vec![0.0; 4])],
            attributes: Vec::new(),
        };
        picture.layers = vec![layer("variance", false), layer("albedo", true)];
        let metadata = Metadata { scene: "世.pov".into(), options: "width=2".into(), ..Metadata::default() };
        let encoding = Encoding { parts: true, ..Encoding::default() };
        let bytes = encode_exr(Path::new("a.exr"), &picture, &metadata, &encoding).unwrap();
        let headers = MetaData::read_from_buffered(&*bytes, true).unwrap().headers;
        let expected = [("color", "lin_rec709_scene", "albedo.R"), ("data", "data", "variance.R")];
        assert_eq!(headers.len(), expected.len());
        for (header, (name, space, channel)) in headers.iter().zip(expected) {
            let own = &header.own_attributes;
            let text =
                |name: &str| own.other.iter().find(|(known, _)| **known == *name).map(|(_, value)| value.clone());
            assert_eq!(own.layer_name.as_ref().map(ToString::to_string).as_deref(), Some(name));
            assert_eq!(own.comments.as_ref().map(ToString::to_string).as_deref(), Some("width=2"));
            assert_eq!(text(COLOR_SPACE), Some(AttributeValue::Text(space.into())));
            let Some(AttributeValue::Text(scene)) = text("scene") else { panic!("no scene") };
            assert_eq!(scene.as_slice(), "世.pov".as_bytes());
            assert!(header.channels.list.iter().any(|known| known.name == *channel), "{channel}");
            assert!(header.channels.list.iter().all(|channel| !channel.quantize_linearly));
        }
    }

    #[test]
    fn figures_are_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.exr");
        let figures = vec![("whitted:shadowRays".to_owned(), 5.0)];
        let metadata = Metadata { rays: 7, figures, ..Metadata::default() };
        let picture = Picture::filled(2, 2, [0.5, 0.5, 0.5, 1.0]);
        std::fs::write(&path, encode_exr(&path, &picture, &metadata, &Encoding::default()).unwrap()).unwrap();
        let expected = [("rays".to_owned(), 7.0), ("whitted:shadowRays".to_owned(), 5.0)];
        assert_eq!(read_exr_figures(&path).unwrap(), expected);
    }

    #[test]
    fn damaged_files_are_refused() {
        assert!(decode_exr(Path::new("a.exr"), b"not an exr file").is_err());
        assert!(decode_exr(Path::new("a.exr"), b"").is_err());
    }
}
