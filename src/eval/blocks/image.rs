//! Pictures: the file or function behind `image_map` and its kin, and how they lie in space.

use super::table::{Block, Item, Takes};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::imaging::Encoded;
use crate::scene::{Image, ImageFormat, ImageMapping, ImageSource, MapType, Working};
use crate::syntax::Keyword as K;
use std::path::PathBuf;
use std::sync::Arc;

/// Type keywords, the extensions a file of that type may have, and the format, if it can be read.
const TYPES: &[(K, &[&str], Option<ImageFormat>)] = &[
    (K::Png, &["png", "PNG"], Some(ImageFormat::Png)),
    (K::Gif, &["gif", "GIF"], Some(ImageFormat::Gif)),
    (K::Tga, &["tga", "TGA"], Some(ImageFormat::Tga)),
    (K::Bmp, &["bmp", "BMP"], Some(ImageFormat::Bmp)),
    (K::Ppm, &["ppm", "PPM"], Some(ImageFormat::Pnm)),
    (K::Pgm, &["pgm", "PGM"], Some(ImageFormat::Pnm)),
    (K::Jpeg, &["jpg", "JPG", "jpeg", "JPEG"], Some(ImageFormat::Jpeg)),
    (K::Tiff, &["tif", "TIF", "tiff", "TIFF"], Some(ImageFormat::Tiff)),
    (K::Iff, &["iff", "IFF"], None),
    (K::Exr, &["exr", "EXR"], Some(ImageFormat::Exr)),
    (K::Hdr, &["hdr", "HDR"], Some(ImageFormat::Hdr)),
    (K::Pot, &["pot", "POT"], Some(ImageFormat::Pot)),
];

pub(super) static MAPPING: Block<ImageMapping> = Block::new(
    "image",
    "how a picture lies in space",
    &[
        Item::new(K::Once, Takes::Nothing(|m| m.once = true), "", "one copy alone; nothing outside of it"),
        Item::new(
            K::MapType,
            Takes::Other("INTEGER", |e, m, _| {
                m.map_type = match e.integer()? {
                    1 => MapType::Spherical,
                    2 => MapType::Cylindrical,
                    5 => MapType::Torus,
                    _ => MapType::Planar,
                };
                Ok(())
            }),
            "0",
            "0 flat, 1 around a sphere, 2 around a cylinder, 5 around a torus",
        ),
        Item::new(
            K::Interpolate,
            Takes::Other("INTEGER", |e, m, _| {
                m.interpolate = match e.integer()? {
                    n @ 2..=4 => n as u8,
                    _ => 0,
                };
                Ok(())
            }),
            "0",
            "between pixels: 0 not at all, 2 linearly, 3 bicubically, 4 by distance",
        ),
        Item::since(
            370,
            K::Repeat,
            Takes::Other("VECTOR2", |e, m, at| {
                let repeat = e.vector2()?;
                if repeat.min_element() <= 0.0 {
                    return e.error(at.span, "an image must be repeated a positive number of times");
                }
                m.repeat = repeat.to_array();
                Ok(())
            }),
            "<1, 1>",
            "how often it stands side by side and on top of each other",
        ),
        Item::since(
            370,
            K::Offset,
            Takes::Other("VECTOR2", |e, m, _| {
                m.offset = e.vector2()?.to_array();
                Ok(())
            }),
            "<0, 0>",
            "where it begins",
        ),
        Item::spelt(
            K::UseColour,
            K::UseColor,
            Takes::Nothing(|m| m.use_index = Some(false)),
            "",
            "heights and materials come from colours",
        ),
        Item::new(
            K::UseIndex,
            Takes::Nothing(|m| m.use_index = Some(true)),
            "",
            "heights and materials come from numbers of colours",
        ),
        Item::new(K::UseAlpha, Takes::Nothing(|m| m.use_alpha = true), "", "the pattern comes from transparency"),
    ],
);

impl Evaluator<'_> {
    /// A picture: `[type] "file"` or `function w, h { … }`, with `gamma` and `premultiplied`.
    pub(super) fn image(&mut self) -> SourceResult<Image> {
        if self.accept(K::Function)? {
            let span = self.span();
            let width = self.image_side()?;
            self.comma()?;
            let height = self.image_side()?;
            self.within(self.budget.elements(width as usize * height as usize, "picture", "pixels"), span)?;
            let function = self.plain_function()?;
            return Ok(Image {
                span,
                source: ImageSource::Function { width, height, function },
                gamma: None,
                premultiplied: None,
                mode: self.scene.settings.gamma,
                legacy: self.effective_version() < 370,
            });
        }
        if self.starts_expression()? {
            let span = self.span();
            self.vector()?;
            self.comma()?;
            self.warn(Topic::Ignored, span, "an orientation vector before the file name has no effect");
        }
        let (source, span) = self.image_file()?;
        let (mode, legacy) = (self.scene.settings.gamma, self.effective_version() < 370);
        let (mut gamma, mut premultiplied) = (None, None);
        loop {
            if self.accept(K::Gamma)? {
                gamma = Some(self.gamma_value()?);
            } else if self.accept(K::Premultiplied)? {
                premultiplied = Some(self.optional_bool()?);
            } else {
                return Ok(Image { span, source, gamma, premultiplied, mode, legacy });
            }
        }
    }

    fn image_side(&mut self) -> SourceResult<u32> {
        let span = self.span();
        let side = self.float()?;
        if (0.5..65536.0).contains(&side) {
            Ok((side + 0.5) as u32)
        } else {
            self.error(span, "a function image needs a width and a height between 1 and 65535")
        }
    }

    /// A number above 0, or `srgb`.
    pub(super) fn gamma_value(&mut self) -> SourceResult<Working> {
        if self.accept(K::Srgb)? {
            return Ok(Working::Srgb);
        }
        let span = self.span();
        let gamma = self.float()?;
        if gamma > 0.0 { Ok(Working::Power(gamma)) } else { self.error(span, "gamma must be greater than 0") }
    }

    /// A picture file with the place of its name.
    fn image_file(&mut self) -> SourceResult<(ImageSource, Span)> {
        let mut chosen = None;
        if let Some(keyword) = self.keyword()?
            && let Some(entry) = TYPES.iter().find(|t| t.0 == keyword)
        {
            self.next()?;
            chosen = Some(entry);
        }
        if !self.starts_string()? {
            return self.expected("an image file name");
        }
        let span = self.span();
        let name = self.file_name()?;
        if chosen.is_none() {
            let extension = std::path::Path::new(&*name).extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
            chosen = match extension {
                None => TYPES.first(),
                Some(e) => TYPES.iter().find(|t| t.1.contains(&e.as_str())),
            };
        }
        let Some((_, extensions, format)) = chosen else {
            return self.error(span, format!("the type of the image \"{name}\" cannot be told from its name"));
        };
        let Some(format) = *format else {
            let hint = "POV-Ray 3.7 finds an unexpected end in every such file; PNG can hold the same picture";
            return self.error_with_hint(span, format!("IFF pictures such as \"{name}\" cannot be read"), hint);
        };
        match self.find_typed(&name, extensions) {
            Some(path) => Ok((ImageSource::File { file: self.picture_file(path, format, span)?, format }, span)),
            None => self.error(span, format!("cannot find the image \"{name}\"")),
        }
    }

    /// The bytes of a picture.
    fn picture_file(&mut self, path: PathBuf, format: ImageFormat, span: Span) -> SourceResult<Arc<Encoded>> {
        self.world.picture(path, format).or_else(|message| self.error(span, message))
    }

    /// A file of a type: a name that has the type's extension is tried as it is first, others last.
    pub(super) fn find_typed(&mut self, name: &str, extensions: &[&str]) -> Option<std::path::PathBuf> {
        let mut endings: Vec<String> = extensions.iter().map(|e| format!(".{e}")).collect();
        let typed = endings.iter().any(|e| name.ends_with(e.as_str()));
        endings.insert(if typed { 0 } else { endings.len() }, String::new());
        self.find_file(name, &endings.iter().map(String::as_str).collect::<Vec<_>>())
    }

    /// `{ IMAGE options }` of `bump_map`, `image_pattern` and `material_map` up to what does
    /// not belong to the picture; opens and closes the braces.
    pub(super) fn image_and_mapping(&mut self, what: &str) -> SourceResult<(Image, ImageMapping)> {
        self.open(what)?;
        let image = self.image()?;
        let mut mapping = ImageMapping::default();
        while self.image_option(&mut mapping)? {}
        self.close(what)?;
        Ok((image, mapping))
    }

    /// One option of how a picture lies in space, if one comes next.
    pub(super) fn image_option(&mut self, mapping: &mut ImageMapping) -> SourceResult<bool> {
        self.comma()?;
        self.item_of(&MAPPING, mapping)
    }
}
