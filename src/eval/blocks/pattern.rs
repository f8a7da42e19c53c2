//! Pattern keywords and their parameters.

use super::table::{Block, Item, Takes, Word};
use crate::diag::SourceResult;
use crate::eval::Evaluator;
use crate::math::DVec3;
use crate::scene::PatternKind as P;
use crate::scene::{FractalColoring, Pattern, PatternKind, SlopeDirection};
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// What a block pattern's list of items is read with; gets the number of blocks.
pub(super) type ListReader<'a> = &'a mut dyn FnMut(&mut Evaluator, usize) -> SourceResult<()>;

/// For patterns that stand where no list may follow.
pub(super) fn no_list(_: &mut Evaluator, _: usize) -> SourceResult<()> {
    Ok(())
}

const OUTSIDE: FractalColoring = FractalColoring { kind: 1, factor: 1.0 };
const INSIDE: FractalColoring = FractalColoring { kind: 0, factor: 1.0 };

/// A pattern that is one word.
const fn plain(word: K, make: fn(&mut PatternKind), help: &'static str) -> Item<PatternKind> {
    Item::new(word, Takes::Nothing(make), "", help)
}

/// A pattern of which something stands behind its word.
const fn by(
    word: K,
    takes: &'static str,
    make: fn(&mut Evaluator<'_>, Word) -> SourceResult<PatternKind>,
    help: &'static str,
) -> Item<PatternKind> {
    Item::new(word, Takes::Whole(takes, make), "", help)
}

pub(super) static PATTERNS: Block<PatternKind> = Block::new(
    "patterns",
    "how values between 0 and 1, or blocks, are spread in space",
    &[
        plain(K::Agate, |p| *p = P::Agate { turbulence: 1.0 }, "bands as of agate"),
        plain(K::Aoi, |p| *p = P::Aoi, "by the angle at which a ray comes"),
        plain(K::Average, |p| *p = P::Average, "all entries of a map mixed, by their weights"),
        plain(K::Boxed, |p| *p = P::Boxed, "1 at the middle of a box, 0 on it"),
        plain(K::Bozo, |p| *p = P::Bozo, "noise"),
        plain(
            K::Brick,
            // What an earlier brick was given stays.
            |p| {
                if !matches!(p, P::Brick { .. }) {
                    *p = P::Brick { size: DVec3::new(8.0, 3.0, 4.5), mortar: 0.5 };
                }
            },
            "two blocks: mortar and bricks",
        ),
        plain(K::Bumps, |p| *p = P::Bumps, "noise"),
        plain(K::Cells, |p| *p = P::Cells, "a random value in each cube"),
        plain(K::Checker, |p| *p = P::Checker, "two blocks: cubes in turn"),
        plain(
            K::Crackle,
            |p| *p = P::Crackle { form: DVec3::new(-1.0, 1.0, 0.0), metric: 2.0, offset: 0.0, solid: false },
            "cells around random points",
        ),
        plain(K::Cubic, |p| *p = P::Cubic, "six blocks: where x, -x, y, -y, z or -z is largest"),
        plain(K::Cylindrical, |p| *p = P::Cylindrical, "1 on the axis y, 0 one unit away"),
        by(K::DensityFile, "df3 FILE", |e, _| e.density_file(), "values from a file"),
        plain(K::Dents, |p| *p = P::Dents, "noise, cubed"),
        by(K::Function, "{ EXPRESSION }", |e, _| Ok(P::Function(e.plain_function()?)), "values of a function"),
        by(K::Gradient, "VECTOR", |e, _| Ok(P::Gradient(e.vector()?)), "from 0 to 1 along a direction, over and over"),
        plain(K::Granite, |p| *p = P::Granite, "noise of many sizes"),
        plain(K::Hexagon, |p| *p = P::Hexagon, "three blocks: hexagons in x and z"),
        by(
            K::ImagePattern,
            "{ IMAGE … }",
            |e, _| Ok(P::Image(Arc::new(e.image_and_mapping("image_pattern")?))),
            "how bright a picture is",
        ),
        by(
            K::Julia,
            "<RE, IM>, ITERATIONS",
            |e, _| {
                let c = e.vector2()?;
                e.comma()?;
                let iterations = e.count()?;
                Ok(P::Julia { c: c.to_array(), iterations, exponent: 2, exterior: OUTSIDE, interior: INSIDE })
            },
            "a Julia set in x and y",
        ),
        plain(K::Leopard, |p| *p = P::Leopard, "regular spots"),
        by(
            K::Magnet,
            "1 | 2 mandel | julia <RE, IM>, ITERATIONS",
            |e, _| e.magnet(),
            "a set of a magnet's formula in x and y",
        ),
        by(
            K::Mandel,
            "ITERATIONS",
            |e, _| Ok(P::Mandel { iterations: e.count()?, exponent: 2, exterior: OUTSIDE, interior: INSIDE }),
            "the Mandelbrot set in x and y",
        ),
        plain(K::Marble, |p| *p = P::Marble, "from 0 to 1 and back along x"),
        by(
            K::Object,
            "{ OBJECT ITEM, ITEM }",
            |e, _| {
                e.open("object pattern")?;
                let object = e.object()?;
                e.comma()?;
                match object {
                    Some(object) => Ok(P::Object(object)),
                    None => e.expected("an object"),
                }
            },
            "two blocks: outside and inside of an object",
        ),
        plain(K::Onion, |p| *p = P::Onion, "shells around a point"),
        Item::since(
            370,
            K::Pavement,
            Takes::Whole("", |_, at| {
                Ok(P::Pavement { span: at.span, sides: 3, tiles: 1, pattern: 1, interior: 0, exterior: 0, form: 0 })
            }),
            "",
            "tiles put together of triangles, squares or hexagons",
        ),
        by(
            K::PigmentPattern,
            "{ PIGMENT }",
            |e, _| Ok(P::Pigment(Arc::new(e.pigment_block(Default::default())?))),
            "how bright a pigment is",
        ),
        plain(K::Planar, |p| *p = P::Planar, "1 where y is 0, 0 one unit away"),
        plain(K::Quilted, |p| *p = P::Quilted { control0: 1.0, control1: 1.0 }, "cubes as of cushions"),
        plain(K::Radial, |p| *p = P::Radial, "once from 0 to 1 around the axis y"),
        plain(K::Ripples, |p| *p = P::Ripples, "rings around random points"),
        by(
            K::Slope,
            "VECTOR | { VECTOR | point_at VECTOR [, LOW, HIGH] [altitude VECTOR [, LOW, HIGH]] }",
            |e, _| e.slope(),
            "by the direction of the surface",
        ),
        plain(K::Spherical, |p| *p = P::Spherical, "1 at a point, 0 one unit away"),
        by(K::Spiral1, "ARMS", |e, _| Ok(P::Spiral1(e.integer()? as i32)), "arms of a spiral around z"),
        by(K::Spiral2, "ARMS", |e, _| Ok(P::Spiral2(e.integer()? as i32)), "arms of two spirals around z"),
        plain(K::Spotted, |p| *p = P::Spotted, "noise"),
        Item::since(370, K::Square, Takes::Nothing(|p| *p = P::Square), "", "four blocks: squares in x and z"),
        Item::since(
            370,
            K::Tiling,
            Takes::Whole("1 to 27", |e, at| match e.integer()? {
                n @ 1..=27 => Ok(P::Tiling(n as u32)),
                n => e.error(at.span, format!("there are tilings 1 to 27, but no tiling {n}")),
            }),
            "",
            "tilings of the plane of x and z",
        ),
        Item::since(370, K::Triangular, Takes::Nothing(|p| *p = P::Triangular), "", "six blocks: triangles in x and z"),
        plain(K::Waves, |p| *p = P::Waves, "rings around random points, of many sizes"),
        plain(K::Wood, |p| *p = P::Wood, "rings around the axis z"),
        plain(K::Wrinkles, |p| *p = P::Wrinkles, "noise of many sizes, folded"),
    ],
);

impl Evaluator<'_> {
    /// A pattern keyword with its parameters, if one comes next.
    ///
    /// A keyword changes only what it sets, so modifiers of a copied pattern stay.
    pub(super) fn pattern_keyword(&mut self, pattern: &mut Pattern, list: ListReader) -> SourceResult<bool> {
        if !self.item_of(&PATTERNS, &mut pattern.kind)? {
            return Ok(false);
        }
        pattern.wave = pattern.kind.own_wave().unwrap_or(pattern.wave);
        if pattern.kind.has_no_frequency() {
            pattern.frequency = 0.0;
        }
        if let Some(n) = pattern.kind.n_blocks() {
            list(self, n)?;
        }
        if matches!(pattern.kind, PatternKind::Object(_)) {
            self.close("object pattern")?;
        }
        Ok(true)
    }

    pub(super) fn count(&mut self) -> SourceResult<u32> {
        Ok(self.integer()?.clamp(0, i64::from(u32::MAX)) as u32)
    }

    fn magnet(&mut self) -> SourceResult<PatternKind> {
        let span = self.span();
        let kind = self.count()?;
        if !(1..=2).contains(&kind) {
            return self.error(span, "magnet must be of type 1 or 2");
        }
        let c = match self.keyword()? {
            Some(K::Mandel) => {
                self.next()?;
                None
            }
            Some(K::Julia) => {
                self.next()?;
                let c = self.vector2()?;
                self.comma()?;
                Some(c.to_array())
            }
            _ => return self.expected("'mandel' or 'julia'"),
        };
        Ok(PatternKind::Magnet { kind, c, iterations: self.count()?, exterior: OUTSIDE, interior: INSIDE })
    }

    /// `slope V` or `slope { V [, lo, hi] [altitude A [, lo, hi]] }`.
    fn slope(&mut self) -> SourceResult<PatternKind> {
        let braces = self.accept_punct('{')?;
        let direction = if braces && self.accept(K::PointAt)? {
            SlopeDirection::PointAt(self.vector()?)
        } else {
            SlopeDirection::Vector(self.vector()?)
        };
        let (mut low, mut high, mut altitude) = (0.0, 0.0, None);
        if braces {
            (low, high) = self.optional_pair()?;
            let span = self.span();
            if self.accept(K::Altitude)? {
                if matches!(direction, SlopeDirection::PointAt(_)) {
                    return self.error(span, "slope takes no altitude with point_at");
                }
                let axis = self.vector()?;
                if axis == DVec3::ZERO && matches!(direction, SlopeDirection::Vector(DVec3::ZERO)) {
                    return self.error(span, "slope and altitude must not both be zero vectors");
                }
                let (low, high) = self.optional_pair()?;
                altitude = Some((axis, low, high));
            }
            self.close("slope")?;
        }
        Ok(PatternKind::Slope { direction, low, high, altitude })
    }

    fn optional_pair(&mut self) -> SourceResult<(f64, f64)> {
        self.comma()?;
        if !self.starts_expression()? {
            return Ok((0.0, 0.0));
        }
        let low = self.float()?;
        self.comma()?;
        let high = if self.starts_expression()? { self.float()? } else { 0.0 };
        Ok((low, high))
    }

    fn density_file(&mut self) -> SourceResult<PatternKind> {
        if !self.accept(K::Df3)? {
            return self.expected("'df3' and a file name");
        }
        let span = self.peek()?.span;
        let name = self.file_name()?;
        let Some(path) = self.find_typed(&name, &["df3", "DF3"]) else {
            return self.error(span, format!("cannot find the density file \"{name}\""));
        };
        let data = self.bytes_of(&path, span)?.into();
        Ok(PatternKind::DensityFile { span, path, interpolation: 0, data })
    }
}
