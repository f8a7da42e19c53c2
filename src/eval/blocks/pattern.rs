//! Pattern keywords and their parameters.

use crate::diag::SourceResult;
use crate::eval::Evaluator;
use crate::math::DVec3;
use crate::scene::{FractalColoring, Pattern, PatternKind, SlopeDirection, Wave};
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

impl Evaluator<'_> {
    /// A pattern keyword with its parameters, if one comes next.
    ///
    /// A keyword changes only what it sets, so modifiers of a copied pattern stay.
    pub(super) fn pattern_keyword(&mut self, pattern: &mut Pattern, list: ListReader) -> SourceResult<bool> {
        let Some(keyword) = self.keyword()? else { return Ok(false) };
        let Some(kind) = self.pattern_kind(keyword, pattern)? else { return Ok(false) };
        let fresh = Pattern::new(kind);
        if fresh.wave != Wave::Ramp {
            pattern.wave = fresh.wave;
        }
        if fresh.frequency == 0.0 {
            pattern.frequency = 0.0;
        }
        let in_braces = matches!(fresh.kind, PatternKind::Object(_));
        let n_blocks = fresh.kind.n_blocks();
        pattern.kind = fresh.kind;
        if let Some(n) = n_blocks {
            list(self, n)?;
        }
        if in_braces {
            self.close("object pattern")?;
        }
        Ok(true)
    }

    /// Consumes the keyword when it names a pattern.
    fn pattern_kind(&mut self, keyword: K, old: &Pattern) -> SourceResult<Option<PatternKind>> {
        use PatternKind as P;
        if let Some(kind) = simple_kind(keyword) {
            self.next()?;
            return Ok(Some(kind));
        }
        let span = self.span();
        let complex = matches!(
            keyword,
            K::Agate
                | K::Brick
                | K::Crackle
                | K::DensityFile
                | K::Function
                | K::Gradient
                | K::ImagePattern
                | K::Julia
                | K::Magnet
                | K::Mandel
                | K::Object
                | K::Pavement
                | K::PigmentPattern
                | K::Quilted
                | K::Slope
                | K::Spiral1
                | K::Spiral2
                | K::Tiling
        );
        if !complex {
            return Ok(None);
        }
        self.next()?;
        Ok(Some(match keyword {
            K::Agate => P::Agate { turbulence: 1.0 },
            K::Brick => match old.kind {
                P::Brick { size, mortar } => P::Brick { size, mortar },
                _ => P::Brick { size: DVec3::new(8.0, 3.0, 4.5), mortar: 0.5 },
            },
            K::Crackle => P::Crackle { form: DVec3::new(-1.0, 1.0, 0.0), metric: 2.0, offset: 0.0, solid: false },
            K::DensityFile => self.density_file()?,
            K::Function => P::Function(self.plain_function()?),
            K::Gradient => P::Gradient(self.vector()?),
            K::ImagePattern => P::Image(Arc::new(self.image_and_mapping("image_pattern")?)),
            K::Julia => {
                let c = self.vector2()?;
                self.comma()?;
                let iterations = self.count()?;
                P::Julia { c: c.to_array(), iterations, exponent: 2, exterior: OUTSIDE, interior: INSIDE }
            }
            K::Mandel => P::Mandel { iterations: self.count()?, exponent: 2, exterior: OUTSIDE, interior: INSIDE },
            K::Magnet => self.magnet()?,
            K::Object => {
                self.open("object pattern")?;
                let object = self.object()?;
                self.comma()?;
                match object {
                    Some(object) => P::Object(object),
                    None => return self.expected("an object"),
                }
            }
            K::Pavement => P::Pavement { span, sides: 3, tiles: 1, pattern: 1, interior: 0, exterior: 0, form: 0 },
            K::PigmentPattern => P::Pigment(Arc::new(self.pigment_block(Default::default())?)),
            K::Quilted => P::Quilted { control0: 1.0, control1: 1.0 },
            K::Slope => self.slope()?,
            K::Spiral1 => P::Spiral1(self.integer()? as i32),
            K::Spiral2 => P::Spiral2(self.integer()? as i32),
            K::Tiling => match self.integer()? {
                n @ 1..=27 => P::Tiling(n as u32),
                n => return self.error(span, format!("there are tilings 1 to 27, but no tiling {n}")),
            },
            _ => return Ok(None),
        }))
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

/// Patterns that are one word.
fn simple_kind(keyword: K) -> Option<PatternKind> {
    use PatternKind as P;
    Some(match keyword {
        K::Aoi => P::Aoi,
        K::Average => P::Average,
        K::Boxed => P::Boxed,
        K::Bozo => P::Bozo,
        K::Spotted => P::Spotted,
        K::Bumps => P::Bumps,
        K::Cells => P::Cells,
        K::Checker => P::Checker,
        K::Cubic => P::Cubic,
        K::Cylindrical => P::Cylindrical,
        K::Dents => P::Dents,
        K::Granite => P::Granite,
        K::Hexagon => P::Hexagon,
        K::Leopard => P::Leopard,
        K::Marble => P::Marble,
        K::Onion => P::Onion,
        K::Planar => P::Planar,
        K::Radial => P::Radial,
        K::Ripples => P::Ripples,
        K::Spherical => P::Spherical,
        K::Square => P::Square,
        K::Triangular => P::Triangular,
        K::Waves => P::Waves,
        K::Wood => P::Wood,
        K::Wrinkles => P::Wrinkles,
        _ => return None,
    })
}
