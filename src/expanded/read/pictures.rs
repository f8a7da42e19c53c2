//! Pictures: the file or function behind `image_map` and its kin, and how they lie in space.

use super::reader::Reader;
use super::tree::{Items, Node, Read, Rule, file_name, number, place, wrong};
use crate::scene::{Gamma, Image, ImageFormat, ImageMapping, ImageSource, MapType, Working};

impl<'a> Reader<'a> {
    /// A picture with how it lies in space.
    pub(super) fn image_and_mapping(&mut self, node: Node<'a>) -> Read<(Image, ImageMapping)> {
        let mut mapping = ImageMapping::default();
        for item in node.clone().into_inner().filter(|item| item.as_rule() == Rule::mapping) {
            set_mapping(item, &mut mapping)?;
        }
        Ok((self.image(node)?, mapping))
    }

    /// A picture.
    pub(super) fn image(&mut self, node: Node<'a>) -> Read<Image> {
        let mut items = Items::of(node);
        let source = items.node()?;
        let (mode, legacy) = (self.scene.settings.gamma, self.version < 370);
        let mut image = self.image_source(source, mode, legacy)?;
        if let Some(note) = items.optional(Rule::mode_note) {
            let inner = Items::of(note).node()?;
            let is_none = inner.as_rule() == Rule::none;
            image.mode = if is_none { Gamma::None } else { Gamma::Linear(working(&inner)?) };
        }
        if let Some(note) = items.optional(Rule::age_note) {
            image.legacy = Items::of(note).word()? == "legacy";
        }
        Ok(image)
    }

    fn image_source(&mut self, node: Node<'a>, mode: Gamma, legacy: bool) -> Read<Image> {
        let is_function = node.as_rule() == Rule::image_function;
        let mut items = Items::of(node.clone());
        let (mut gamma, mut premultiplied) = (None, None);
        if is_function {
            let limit = self.options.limits.array_elements;
            let (width, height) = (items.whole_within(1, 65535)?, items.whole_within(1, 65535)?);
            if width as usize * height as usize > limit {
                return wrong(&node, format!("this picture has more than {limit} pixels"));
            }
            let function = self.function_body(items.node()?, &["x", "y", "z"])?;
            let source = ImageSource::Function { width, height, function };
            return Ok(Image { span: place(&node), source, gamma, premultiplied, mode, legacy });
        }
        let format = format(items.word()?);
        let name = items.node()?;
        let path = self.find(file_name(&name), &name)?;
        for item in items {
            let rule = item.as_rule();
            let mut inner = Items::of(item);
            match rule {
                Rule::file_gamma => gamma = Some(working(&inner.node()?)?),
                _ => premultiplied = Some(inner.switch()),
            }
        }
        let source = ImageSource::File { file: self.picture(path, format, &name)?, format };
        Ok(Image { span: place(&name), source, gamma, premultiplied, mode, legacy })
    }
}

/// A power or `srgb`.
pub(super) fn working(node: &Node<'_>) -> Read<Working> {
    if node.as_rule() == Rule::srgb {
        return Ok(Working::Srgb);
    }
    let gamma = number(node)?;
    if gamma > 0.0 { Ok(Working::Power(gamma)) } else { wrong(node, "gamma must be greater than 0") }
}

fn format(word: &str) -> ImageFormat {
    match word {
        "gif" => ImageFormat::Gif,
        "tga" => ImageFormat::Tga,
        "bmp" => ImageFormat::Bmp,
        "ppm" | "pgm" => ImageFormat::Pnm,
        "jpeg" => ImageFormat::Jpeg,
        "tiff" => ImageFormat::Tiff,
        "exr" => ImageFormat::Exr,
        "hdr" => ImageFormat::Hdr,
        "pot" => ImageFormat::Pot,
        _ => ImageFormat::Png,
    }
}

fn set_mapping(node: Node<'_>, mapping: &mut ImageMapping) -> Read<()> {
    let mut items = Items::of(node.clone());
    match items.word()? {
        "map_type" => {
            mapping.map_type = match items.number()? {
                0.0 => MapType::Planar,
                1.0 => MapType::Spherical,
                2.0 => MapType::Cylindrical,
                5.0 => MapType::Torus,
                n => return wrong(&node, format!("there is no map_type {n}; use 0, 1, 2 or 5")),
            };
        }
        "once" => mapping.once = true,
        "interpolate" => mapping.interpolate = items.whole_within(0, 4)? as u8,
        "repeat" => {
            mapping.repeat = items.vector2()?.to_array();
            if mapping.repeat.iter().any(|n| *n <= 0.0) {
                return wrong(&node, "an image must be repeated a positive number of times");
            }
        }
        "offset" => mapping.offset = items.vector2()?.to_array(),
        "use_index" => mapping.use_index = Some(true),
        "use_color" => mapping.use_index = Some(false),
        _ => mapping.use_alpha = true,
    }
    Ok(())
}
