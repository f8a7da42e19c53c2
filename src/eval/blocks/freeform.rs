//! Parameters of freeform shapes: height field, blob, patch, prism, lathe, sor, sweep, text.

use super::table::Word;
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::eval::disk::FONT_FOLDERS;
use crate::eval::world::unreadable;
use crate::math::{DVec2, DVec3, Transform};
use crate::scene::{BicubicPatch, Blob, BlobComponent, HeightField, Prism, Shape, SweepSpline, Text};
use crate::syntax::Keyword as K;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Below this a blob cylinder has no axis, and two points of a sor have the same height, as in POV-Ray; of
/// parts smaller than 1, in units of their size.
const POV_DEGENERATE: f64 = 1e-10;

impl Evaluator<'_> {
    pub(super) fn height_field(&mut self) -> SourceResult<Shape> {
        let image = self.image()?;
        let mut field = HeightField { image, water_level: f64::NEG_INFINITY, smooth: false };
        loop {
            self.comma()?;
            if self.accept(K::WaterLevel)? {
                let level = self.float()?;
                field.water_level = if self.version < 200 { level / 256.0 } else { level };
            } else if self.accept(K::Smooth)? {
                field.smooth = true;
            } else {
                return Ok(Shape::HeightField(Arc::new(field)));
            }
        }
    }

    pub(super) fn blob(&mut self, span: Span) -> SourceResult<Shape> {
        let mut blob = Blob { threshold: 1.0, components: Vec::new(), sturm: false };
        loop {
            self.comma()?;
            match self.keyword()? {
                Some(K::Threshold) => {
                    self.next()?;
                    blob.threshold = self.float()?;
                }
                Some(K::Component) => {
                    self.next()?;
                    let strength = self.float()?;
                    self.comma()?;
                    let radius = self.float()?;
                    self.comma()?;
                    let center = self.vector()?;
                    blob.components.push(component([center, center], false, radius, strength));
                }
                Some(k @ (K::Sphere | K::Cylinder)) => {
                    self.next()?;
                    let part = self.blob_component(k == K::Cylinder)?;
                    blob.components.push(part);
                }
                _ => break,
            }
        }
        if blob.components.is_empty() {
            return self.error(span, "a blob needs at least one sphere or cylinder");
        }
        Ok(Shape::Blob(Arc::new(blob)))
    }

    fn blob_component(&mut self, is_cylinder: bool) -> SourceResult<BlobComponent> {
        self.open("blob component")?;
        let span = self.span();
        let first = self.vector()?;
        self.comma()?;
        let second = if is_cylinder { self.vector()? } else { first };
        self.comma()?;
        let radius = self.float()?;
        self.comma()?;
        self.accept(K::Strength)?;
        let strength = self.float()?;
        let size = first.abs().max(second.abs()).max_element().max(radius.abs()).min(1.0);
        if is_cylinder && (first == second || (second - first).length() < POV_DEGENERATE * size) {
            return self.error(span, "the two ends of a blob cylinder must not be the same point");
        }
        let mut part = component([first, second], is_cylinder, radius, strength);
        loop {
            if let Some(transform) = self.transformation()? {
                part.transform = part.transform.then(&transform);
                if let Some(texture) = &mut part.texture {
                    texture.place.apply(&transform);
                }
                continue;
            }
            let span = self.span();
            match self.keyword()? {
                Some(K::Texture) => {
                    self.next()?;
                    let texture = self.texture_block()?;
                    let below = part.texture.take();
                    part.texture = Some(self.layer_over(below, texture, span)?);
                }
                Some(word @ (K::Pigment | K::Normal | K::Finish)) => {
                    self.next()?;
                    let placed = part.texture.take();
                    part.texture = Some(self.change_top_layer(placed, Word { word, span })?);
                }
                _ => break,
            }
        }
        self.close("blob component")?;
        Ok(part)
    }

    pub(super) fn bicubic_patch(&mut self, span: Span) -> SourceResult<Shape> {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let mut patch =
            BicubicPatch { points: [[DVec3::ZERO; 4]; 4], uv_corners: corners, flatness: 0.0, u_steps: 0, v_steps: 0 };
        let mut typed = false;
        loop {
            self.comma()?;
            match self.keyword()? {
                Some(K::Type) => {
                    self.next()?;
                    typed = true;
                    self.patch_type()?;
                }
                Some(K::Flatness) => {
                    self.next()?;
                    patch.flatness = self.float()?;
                }
                Some(K::USteps) => {
                    self.next()?;
                    patch.u_steps = self.integer()?.clamp(0, 30) as u32;
                }
                Some(K::VSteps) => {
                    self.next()?;
                    patch.v_steps = self.integer()?.clamp(0, 30) as u32;
                }
                Some(K::Accuracy) => {
                    self.next()?;
                    self.float()?;
                }
                Some(K::UvVectors) => {
                    self.next()?;
                    for corner in &mut patch.uv_corners {
                        *corner = self.vector2()?;
                        self.comma()?;
                    }
                }
                _ if !typed && !self.at_vector()? && self.starts_expression()? => {
                    typed = true;
                    self.old_patch(&mut patch, span)?;
                }
                _ => break,
            }
        }
        if !typed {
            return self.error(span, "a bicubic_patch needs a type");
        }
        let points = self.vector_list(16)?;
        for (i, point) in points.into_iter().enumerate() {
            patch.points[i / 4][i % 4] = point;
        }
        Ok(Shape::BicubicPatch(Arc::new(patch)))
    }

    fn patch_type(&mut self) -> SourceResult<i64> {
        let span = self.span();
        let kind = self.integer()?;
        if kind < 0 {
            return self.error(span, "the type of a bicubic_patch is 0 or 1");
        }
        if kind > 1 {
            self.warn(Topic::Range, span, "the type of a bicubic_patch is 0 or 1; 1 is used");
        }
        Ok(kind)
    }

    /// `type [flatness] u v` as bare numbers.
    fn old_patch(&mut self, patch: &mut BicubicPatch, span: Span) -> SourceResult<()> {
        self.warn(
            Topic::Outdated,
            span,
            "this is an old form of bicubic_patch; write 'type 1 flatness F u_steps U v_steps V'",
        );
        let kind = self.patch_type()?;
        self.comma()?;
        if kind >= 2 {
            patch.flatness = self.float()?;
            self.comma()?;
        }
        patch.u_steps = self.integer()?.clamp(0, 30) as u32;
        self.comma()?;
        patch.v_steps = self.integer()?.clamp(0, 30) as u32;
        Ok(())
    }

    pub(super) fn prism(&mut self, span: Span) -> SourceResult<Shape> {
        let (mut spline, mut conic) = (SweepSpline::Linear, false);
        loop {
            if let Some(found) = self.sweep_spline()? {
                spline = found;
            } else if self.accept(K::LinearSweep)? {
                conic = false;
            } else if self.accept(K::ConicSweep)? {
                conic = true;
            } else {
                break;
            }
            self.comma()?;
        }
        let h1 = self.float()?;
        self.comma()?;
        let h2 = self.float()?;
        self.comma()?;
        let points = self.counted_points()?;
        let (least, unit) = match spline {
            SweepSpline::Linear => (3, 1),
            SweepSpline::Quadratic => (5, 1),
            SweepSpline::Cubic => (6, 1),
            SweepSpline::Bezier => (4, 4),
            SweepSpline::B => return self.error(span, "a prism takes no b_spline"),
        };
        self.check_points(points.len(), least, unit, "prism", span)?;
        self.comma()?;
        let open = self.accept(K::Open)?;
        let heights = [h1.min(h2), h1.max(h2)];
        Ok(Shape::Prism(Arc::new(Prism { spline, conic, heights, points, open, sturm: false })))
    }

    fn check_points(&mut self, n: usize, least: usize, unit: usize, what: &str, span: Span) -> SourceResult<()> {
        if n < least {
            return self.error(span, format!("this {what} needs at least {least} points, it has {n}"));
        }
        if !n.is_multiple_of(unit) {
            return self.error(span, format!("a bezier_spline {what} needs a multiple of {unit} points, it has {n}"));
        }
        Ok(())
    }

    pub(super) fn lathe(&mut self, span: Span) -> SourceResult<Shape> {
        let spline = self.sweep_spline()?.unwrap_or(SweepSpline::Linear);
        self.comma()?;
        let points = self.counted_points()?;
        let (least, unit) = match spline {
            SweepSpline::Linear => (2, 1),
            SweepSpline::Quadratic => (3, 1),
            SweepSpline::Cubic => (4, 1),
            SweepSpline::Bezier => (4, 4),
            SweepSpline::B => return self.error(span, "a lathe takes no b_spline"),
        };
        self.check_points(points.len(), least, unit, "lathe", span)?;
        let last = points.len() - 1;
        if points.iter().enumerate().any(|(i, p)| p.x < 0.0 && i != 0 && i != last) {
            return self.error(span, "the points of a lathe must not have a negative radius");
        }
        Ok(Shape::Lathe { spline, points: points.into(), sturm: false })
    }

    pub(super) fn sor(&mut self, span: Span) -> SourceResult<Shape> {
        let points = self.counted_points()?;
        self.check_points(points.len(), 4, 1, "sor", span)?;
        if points.iter().any(|p| p.x < 0.0) {
            return self.error(span, "the points of a sor must not have a negative radius");
        }
        let falls = points[1..points.len() - 1].windows(2).any(|w| w[1].y <= w[0].y);
        let size = points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max).min(1.0);
        let flat = points.windows(3).any(|w| (w[2].y - w[0].y).abs() < POV_DEGENERATE * size);
        if falls || flat {
            return self.error(span, "the heights of a sor's points must rise from point to point");
        }
        self.comma()?;
        let open = self.accept(K::Open)?;
        Ok(Shape::Sor { points: points.into(), open, sturm: false })
    }

    pub(super) fn sphere_sweep(&mut self, span: Span) -> SourceResult<Shape> {
        let Some(spline) = self.sweep_spline()? else {
            return self.expected("'linear_spline', 'b_spline' or 'cubic_spline'");
        };
        let least = match spline {
            SweepSpline::Linear => 2,
            SweepSpline::B | SweepSpline::Cubic => 4,
            _ => return self.error(span, "a sphere_sweep takes linear_spline, b_spline or cubic_spline"),
        };
        self.comma()?;
        let n = self.integer()?.max(0) as usize;
        self.check_points(n, least, 1, "sphere_sweep", span)?;
        let mut spheres = Vec::new();
        for _ in 0..n {
            self.comma()?;
            let center = self.vector()?;
            self.comma()?;
            spheres.push((center, self.float()?));
        }
        self.comma()?;
        let tolerance = if self.accept(K::Tolerance)? { self.float()? } else { 1e-6 }; // POV-Ray's default
        Ok(Shape::SphereSweep { spline, spheres: spheres.into(), tolerance })
    }

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

fn component(ends: [DVec3; 2], is_cylinder: bool, radius: f64, strength: f64) -> BlobComponent {
    BlobComponent { ends, is_cylinder, radius, strength, transform: Transform::IDENTITY, texture: None }
}
