//! Pictures: the file or function behind `image_map` and its kin, and how they lie in space.

use super::number::{double, vector2};
use super::patterns::switch;
use super::writer::Writer;
use crate::math::DVec2;
use crate::scene::{Gamma, Image, ImageFormat, ImageMapping, ImageSource, MapType, Working};
use std::path::Path;

impl Writer<'_> {
    /// `WORD { IMAGE options }`.
    pub(super) fn image_block(&mut self, word: &str, image: &Image, mapping: &ImageMapping) {
        self.open(word);
        self.image(image);
        self.mapping(mapping);
        self.close();
    }

    /// A picture: a file by its name, or a function.
    pub(super) fn image(&mut self, image: &Image) {
        let Image { span: _, source, gamma, premultiplied, mode, legacy } = image;
        if self.counting {
            self.pictures_mode.get_or_insert(*mode);
        }
        match source {
            ImageSource::File { file, format } => {
                let name = (self.style.file_name)(file.path());
                let mut text = format!("{} {}", format_word(*format, file.path()), file_name(&name));
                if let Some(gamma) = gamma {
                    text += &format!(" gamma {}", working(*gamma));
                }
                if let Some(premultiplied) = premultiplied {
                    text += &format!(" premultiplied {}", switch(*premultiplied));
                }
                self.line(text);
            }
            ImageSource::Function { width, height, function } => {
                self.function_head(&format!("function {width}, {height}"), function, &["x", "y", "z"]);
            }
        }
        if *mode != self.mode_here() {
            self.note(match mode {
                Gamma::None => "mode none".to_owned(),
                Gamma::Linear(curve) => format!("mode {}", working(*curve)),
            });
        }
        if *legacy != (self.settings.version < 370) {
            self.note(if *legacy { "legacy" } else { "current" });
        }
    }

    /// How colours relate to light as far as a reader knows where the first picture stands.
    fn mode_here(&self) -> Gamma {
        if self.says_gamma() { self.settings.gamma } else { Gamma::None }
    }

    /// How a picture lies in space, as far as it says so.
    pub(super) fn mapping(&mut self, mapping: &ImageMapping) {
        let ImageMapping { map_type, once, interpolate, repeat, offset, use_index, use_alpha } = *mapping;
        let mut words = Vec::new();
        let map_type = match map_type {
            MapType::Planar => 0,
            MapType::Spherical => 1,
            MapType::Cylindrical => 2,
            MapType::Torus => 5,
        };
        if map_type != 0 {
            words.push(format!("map_type {map_type}"));
        }
        if once {
            words.push("once".to_owned());
        }
        if interpolate != 0 {
            words.push(format!("interpolate {interpolate}"));
        }
        if repeat != [1.0; 2] {
            words.push(format!("repeat {}", vector2(DVec2::from(repeat))));
        }
        if offset != [0.0; 2] {
            words.push(format!("offset {}", vector2(DVec2::from(offset))));
        }
        words.extend(use_index.map(|index| if index { "use_index" } else { "use_color" }.to_owned()));
        if use_alpha {
            words.push("use_alpha".to_owned());
        }
        if !words.is_empty() {
            self.line(words.join(" "));
        }
    }
}

/// The name of a file as a literal, in which a backslash is itself.
pub(super) fn file_name(name: &str) -> String {
    format!("\"{}\"", name.replace('"', "'"))
}

/// A power or `srgb`.
pub(super) fn working(working: Working) -> String {
    match working {
        Working::Power(gamma) => double(gamma),
        Working::Srgb => "srgb".to_owned(),
    }
}

fn format_word(format: ImageFormat, path: &Path) -> &'static str {
    match format {
        ImageFormat::Pnm if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("pgm")) => "pgm",
        ImageFormat::Pnm => "ppm",
        _ => format.decoder(),
    }
}
