//! `text { … }`, and where its fonts are.

use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::eval::disk::FONT_FOLDERS;
use crate::eval::world::unreadable;
use crate::scene::{Shape, Text};
use crate::syntax::Keyword as K;
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl Evaluator<'_> {
    pub(super) fn text(&mut self, span: Span) -> SourceResult<Shape> {
        let (font, font_file) = match self.keyword()? {
            Some(K::Ttf) => {
                self.next()?;
                let span = self.span();
                let name = self.file_name()?;
                self.font_file(&name, span)?
            }
            Some(K::Internal) => {
                self.next()?;
                let name = match self.integer()? {
                    1 => "timrom.ttf",
                    2 => "cyrvetic.ttf",
                    3 => "crystal.ttf",
                    _ => "povlogo.ttf",
                };
                self.font_file(name, span)?
            }
            _ => return self.expected("'ttf' and a font file, or 'internal' and a number"),
        };
        self.comma()?;
        let text = self.string()?;
        self.comma()?;
        let thickness = self.float()?;
        self.comma()?;
        let offset = self.vector()?;
        let unicode = self.utf8;
        let characters = text.encode_utf16().collect();
        Ok(Shape::Text(Arc::new(Text { font, font_file, characters, unicode, thickness, offset })))
    }

    /// A font of the system in place of one that comes with POV-Ray.
    fn system_font(&mut self, name: &str, span: Span) -> SourceResult<(Arc<Vec<u8>>, PathBuf)> {
        let stem = name.rsplit(['/', '\\']).next().unwrap_or(name).trim_end_matches(".ttf").to_ascii_lowercase();
        let fonts = STANDARD_FONTS.iter().find(|(standard, _)| *standard == stem).map_or(&[][..], |(_, fonts)| fonts);
        let found = fonts.iter().find_map(|font| {
            let path = FONT_FOLDERS.iter().map(|folder| Path::new(folder).join(font));
            path.into_iter().find_map(|path| Some((self.world.font(&path).ok()?, path)))
        });
        let Some((font, path)) = found else {
            return self.error(span, format!("cannot find the font \"{name}\""));
        };
        let message = format!("\"{name}\" comes with POV-Ray, which is not installed; {} stands in", path.display());
        self.warn_here(Topic::Files, span, message);
        Ok((font, path))
    }

    fn font_file(&mut self, name: &str, span: Span) -> SourceResult<(Arc<Vec<u8>>, PathBuf)> {
        let Some(path) = self.find_typed(name, &["ttf", "TTF", "ttc", "TTC"]) else {
            return self.system_font(name, span);
        };
        match self.world.font(&path) {
            Ok(font) => Ok((font, path)),
            Err(problem) => self.error(span, unreadable(&path, &problem)),
        }
    }
}

/// The fonts that come with POV-Ray, by what resembles them: a Roman, a Roman with Cyrillic letters, a
/// monospaced one; nothing resembles the logo, for which any font has to do.
const STANDARD_FONTS: [(&str, &[&str]); 4] = {
    const ROMAN: &[&str] = &[
        "liberation/LiberationSerif-Regular.ttf",
        "freefont/FreeSerif.ttf",
        "dejavu/DejaVuSerif.ttf",
        "times.ttf",
        "Supplemental/Times New Roman.ttf",
        "TTF/DejaVuSerif.ttf",
    ];
    const FIXED: &[&str] = &[
        "liberation/LiberationMono-Regular.ttf",
        "freefont/FreeMono.ttf",
        "dejavu/DejaVuSansMono.ttf",
        "cour.ttf",
        "Supplemental/Courier New.ttf",
        "TTF/DejaVuSansMono.ttf",
    ];
    [("timrom", ROMAN), ("cyrvetic", ROMAN), ("crystal", FIXED), ("povlogo", ROMAN)]
};
