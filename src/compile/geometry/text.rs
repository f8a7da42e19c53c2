//! Text: TrueType glyphs become outlines swept along z.

use crate::compiled::geometry::{Outline, Prism, Segment, Shape as Compiled};
use crate::math::{Bounds, DVec2, DVec3, Transform};
use crate::scene::Text;
use ttf_parser::cmap::{Format as Characters, Subtable};
use ttf_parser::{Face, GlyphId, OutlineBuilder, PlatformId, kern::Format};

/// Collects the curves of one glyph, in ems.
struct Pen {
    segments: Vec<Segment>,
    offset: DVec2,
    scale: f64,
    start: DVec2,
    last: DVec2,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> DVec2 {
        DVec2::new(f64::from(x), f64::from(y)) * self.scale + self.offset
    }

    fn line(&mut self, to: DVec2) {
        if to != self.last {
            self.segments.push(Segment::line(self.last, to));
        }
        self.last = to;
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.start = self.at(x, y);
        self.last = self.start;
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.line(self.at(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (a, b, c) = (self.last, self.at(x1, y1), self.at(x, y));
        self.segments.push(Segment::new([a, 2.0 * (b - a), a - 2.0 * b + c, DVec2::ZERO]));
        self.last = c;
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let end = self.at(x, y);
        self.segments.push(Segment::bezier([self.last, self.at(x1, y1), self.at(x2, y2), end]));
        self.last = end;
    }

    fn close(&mut self) {
        self.line(self.start);
    }
}

/// Where POV-Ray 3.7 looks for a character: of the first of these platforms that the font has a table for,
/// the first table (shape facts, section 8).
fn character_map<'a>(face: &Face<'a>, unicode: bool) -> Option<Subtable<'a>> {
    use PlatformId::{Macintosh, Unicode, Windows};
    let order = if unicode { [Unicode, Windows, Macintosh] } else { [Macintosh, Windows, Unicode] };
    let tables = face.tables().cmap?.subtables;
    let usable = |t: &Subtable<'_>| {
        matches!(
            t.format,
            Characters::ByteEncodingTable(_)
                | Characters::SegmentMappingToDeltaValues(_)
                | Characters::TrimmedTableMapping(_)
        )
    };
    order.into_iter().find_map(|platform| tables.into_iter().find(|t| t.platform_id == platform && usable(t)))
}

/// The glyph of a character code.
fn glyph_of(map: Option<&Subtable<'_>>, code: u16) -> GlyphId {
    let find = |c: u32| map.and_then(|map| map.glyph_index(c)).filter(|glyph| glyph.0 > 0);
    // Symbol fonts keep their characters in a private range.
    find(u32::from(code)).or_else(|| find(0xF000 + u32::from(code))).unwrap_or(GlyphId(0))
}

/// Kerning between two glyphs, in font units.
///
/// Pairs are looked through from the first: POV-Ray's own fonts do not hold them sorted, as a binary search needs them.
fn kerning(face: &Face<'_>, left: GlyphId, right: GlyphId) -> f64 {
    let tables = face.tables().kern.iter().flat_map(|kern| kern.subtables);
    let horizontal = tables.filter(|t| t.horizontal && !t.variable);
    let pairs = horizontal.filter_map(|t| match t.format {
        Format::Format0(table) => table.pairs.into_iter().find(|p| p.left() == left && p.right() == right),
        _ => None,
    });
    pairs.map(|p| f64::from(p.value)).sum()
}

/// The glyphs of a line with the places of their origins, in ems.
fn layout(text: &Text, face: &Face<'_>) -> Vec<(GlyphId, DVec2)> {
    let em = f64::from(face.units_per_em());
    let mut placed = Vec::new();
    let mut pen = DVec2::ZERO;
    let mut previous = None;
    let map = character_map(face, text.unicode);
    for code in &text.characters {
        let glyph = glyph_of(map.as_ref(), *code);
        let x_min = face.glyph_bounding_box(glyph).map_or(0.0, |b| f64::from(b.x_min));
        let bearing = f64::from(face.glyph_hor_side_bearing(glyph).unwrap_or(0));
        let advance = f64::from(face.glyph_hor_advance(glyph).unwrap_or(0));
        // The first glyph's left edge stands at x = 0.
        let (at, step) = match previous {
            None => (-x_min, advance - bearing),
            Some(left) => {
                pen += text.offset.truncate();
                let kern = kerning(face, left, glyph);
                (bearing - x_min + kern, advance + kern)
            }
        };
        placed.push((glyph, pen + DVec2::new(at / em, 0.0)));
        pen.x += step / em;
        previous = Some(glyph);
    }
    placed
}

fn face(text: &Text) -> Result<Face<'_>, String> {
    Face::parse(&text.font, 0).map_err(|e| format!("the font cannot be read: {e}"))
}

/// POV-Ray turns all text by a thousandth of a degree.
fn turn() -> Transform {
    Transform::rotation_deg(DVec3::splat(0.001))
}

/// All glyphs of a line beside each other, and what takes the result to text space.
///
/// # Errors
/// A message if the font cannot be read.
pub(super) fn text(text: &Text) -> Result<(Compiled, Transform), String> {
    let face = face(text)?;
    let scale = 1.0 / f64::from(face.units_per_em());
    let mut outlines = Vec::new();
    for (glyph, offset) in layout(text, &face) {
        let mut builder = Pen { segments: Vec::new(), offset, scale, start: offset, last: offset };
        face.outline_glyph(glyph, &mut builder);
        if !builder.segments.is_empty() {
            outlines.push(Outline::new(builder.segments));
        }
    }
    let heights = [text.thickness.min(0.0), text.thickness.max(0.0)];
    let prism = Prism { caps_only: text.thickness < 0.0, outward_caps: true, ..Prism::new(outlines, heights, false) };
    // Prisms stand along y, text along z.
    let upright = Transform::from_columns(DVec3::X, DVec3::Z, DVec3::Y, DVec3::ZERO).unwrap_or_default();
    Ok((Compiled::Prism(prism), upright.then(&turn())))
}

/// POV-Ray's boxes of the glyphs, as the font gives them, in text space.
///
/// # Errors
/// As [`text`].
pub(super) fn glyph_boxes(text: &Text) -> Result<Vec<Bounds>, String> {
    /// Room that POV-Ray leaves in front and behind.
    const ROOM: f64 = 1e-6;
    let face = face(text)?;
    let em = f64::from(face.units_per_em());
    let glyph_box = |(glyph, offset): (GlyphId, DVec2)| {
        let b = face.glyph_bounding_box(glyph)?;
        let corner = |x: i16, y: i16| DVec2::new(x.into(), y.into()) / em + offset;
        let (low, high) = (corner(b.x_min, b.y_min), corner(b.x_max, b.y_max));
        Some(turn().bounds(&Bounds::from_corners(low.extend(-ROOM), high.extend(text.thickness + ROOM))))
    };
    Ok(layout(text, &face).into_iter().filter_map(glyph_box).collect())
}
