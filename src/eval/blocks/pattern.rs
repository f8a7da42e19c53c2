//! Pattern keywords, their parameters and the modifiers that all patterns share.

use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::math::DVec3;
use crate::scene::{BlackHole, FractalColoring, Pattern, PatternKind, SlopeDirection, Turbulence, Warp, Wave};
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

    fn count(&mut self) -> SourceResult<u32> {
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

    /// One modifier that any pattern takes, if one comes next.
    pub(super) fn pattern_modifier(&mut self, pattern: &mut Pattern) -> SourceResult<bool> {
        if let Some(transform) = self.transformation()? {
            pattern.apply(&transform);
            return Ok(true);
        }
        let Some(keyword) = self.keyword()? else { return Ok(false) };
        if self.turbulence_item(keyword, &mut pattern.turbulence)? {
            return Ok(true);
        }
        let wave = match keyword {
            K::RampWave => Some(Wave::Ramp),
            K::TriangleWave => Some(Wave::Triangle),
            K::SineWave => Some(Wave::Sine),
            K::ScallopWave => Some(Wave::Scallop),
            K::CubicWave => Some(Wave::Cubic),
            _ => None,
        };
        if let Some(wave) = wave {
            self.next()?;
            pattern.wave = wave;
            return Ok(true);
        }
        match keyword {
            K::Frequency => {
                self.next()?;
                pattern.frequency = self.float()? as f32;
            }
            K::Phase => {
                self.next()?;
                pattern.phase = self.float()? as f32;
            }
            K::PolyWave => {
                self.next()?;
                let kept = if let Wave::Poly(e) = pattern.wave { e } else { 1.0 };
                pattern.wave = Wave::Poly(if self.starts_expression()? { self.float()? as f32 } else { kept });
            }
            K::NoiseGenerator => {
                self.next()?;
                let span = self.span();
                let n = self.integer()?;
                if !(0..=3).contains(&n) {
                    return self.error(span, "noise_generator must be 0, 1, 2 or 3");
                }
                // Repeated choices combine by bits, as in POV-Ray.
                let combined = pattern.noise_generator.unwrap_or(0) | n as u8;
                pattern.noise_generator = (combined != 0).then_some(combined);
            }
            K::Warp => {
                self.next()?;
                let warp = self.warp()?;
                pattern.add(warp);
            }
            _ => return self.kind_modifier(keyword, pattern),
        }
        Ok(true)
    }

    /// `turbulence`, `octaves`, `omega` or `lambda`.
    pub(super) fn turbulence_item(&mut self, keyword: K, turbulence: &mut Option<Turbulence>) -> SourceResult<bool> {
        if !matches!(keyword, K::Turbulence | K::Octaves | K::Omega | K::Lambda) {
            return Ok(false);
        }
        self.next()?;
        let mut t = turbulence.unwrap_or_default();
        match keyword {
            K::Turbulence => t.amount = self.vector()?,
            K::Octaves => t.octaves = self.integer()?.clamp(1, 10) as u32,
            K::Omega => t.omega = self.float()? as f32,
            _ => t.lambda = self.float()? as f32,
        }
        *turbulence = Some(t);
        Ok(true)
    }

    /// A modifier that belongs to one kind of pattern.
    fn kind_modifier(&mut self, keyword: K, pattern: &mut Pattern) -> SourceResult<bool> {
        use PatternKind as P;
        let span = self.span();
        let known = matches!(
            keyword,
            K::AgateTurb
                | K::BrickSize
                | K::Mortar
                | K::Control0
                | K::Control1
                | K::Form
                | K::Metric
                | K::Offset
                | K::Solid
                | K::Exponent
                | K::Exterior
                | K::Interior
                | K::NumberOfSides
                | K::NumberOfTiles
                | K::Pattern
        ) || (keyword == K::Interpolate && matches!(pattern.kind, P::DensityFile { .. }));
        if !known {
            return Ok(false);
        }
        self.next()?;
        match (keyword, &mut pattern.kind) {
            (K::AgateTurb, P::Agate { turbulence }) => *turbulence = self.float()? as f32,
            (K::Interpolate, P::DensityFile { interpolation, .. }) => {
                *interpolation = self.integer()?.rem_euclid(10) as u8;
            }
            (K::BrickSize, P::Brick { size, .. }) => *size = self.vector()?,
            (K::Mortar, P::Brick { mortar, .. }) => *mortar = self.float()? as f32,
            (K::Control0, P::Quilted { control0, .. }) => *control0 = self.float()? as f32,
            (K::Control1, P::Quilted { control1, .. }) => *control1 = self.float()? as f32,
            (K::Form, P::Crackle { form, .. }) => *form = self.vector()?,
            (K::Metric, P::Crackle { metric, .. }) => *metric = self.vector()?.x,
            (K::Offset, P::Crackle { offset, .. }) => *offset = self.float()?,
            (K::Solid, P::Crackle { solid, .. }) => *solid = self.optional_bool()?,
            (K::Exponent, P::Julia { exponent, .. } | P::Mandel { exponent, .. }) => {
                let n = self.integer()?;
                *exponent = if (2..=33).contains(&n) { n as u32 } else { 2 };
                if !(2..=33).contains(&n) {
                    self.warn(Topic::Range, span, "a fractal exponent outside 2 to 33 means 2");
                }
            }
            (
                K::Exterior,
                P::Julia { exterior: c, .. } | P::Mandel { exterior: c, .. } | P::Magnet { exterior: c, .. },
            )
            | (
                K::Interior,
                P::Julia { interior: c, .. } | P::Mandel { interior: c, .. } | P::Magnet { interior: c, .. },
            ) => {
                let kind = self.integer()?;
                self.comma()?;
                let most = if keyword == K::Exterior { 8 } else { 6 };
                if !(0..=most).contains(&kind) {
                    return self.error(span, format!("the fractal colouring type must be between 0 and {most}"));
                }
                *c = FractalColoring { kind: kind as u32, factor: self.float()? };
            }
            (_, P::Pavement { sides, tiles, pattern, interior, exterior, form, .. }) => {
                let field = match keyword {
                    K::NumberOfSides => sides,
                    K::NumberOfTiles => tiles,
                    K::Pattern => pattern,
                    K::Interior => interior,
                    K::Exterior => exterior,
                    _ => form,
                };
                *field = self.count()?;
            }
            _ => return self.error(span, format!("'{}' does not belong to this pattern", keyword.word())),
        }
        Ok(true)
    }

    /// `warp { … }`, after the word.
    fn warp(&mut self) -> SourceResult<Warp> {
        self.open("warp")?;
        let span = self.span();
        let Some(keyword) = self.keyword()? else { return self.expected("a kind of warp") };
        let warp = match keyword {
            K::Repeat => {
                self.next()?;
                self.repeat_warp()?
            }
            K::BlackHole => {
                self.next()?;
                self.black_hole()?
            }
            K::Turbulence | K::Octaves | K::Omega | K::Lambda => {
                let mut turbulence = None;
                while let Some(k) = self.keyword()? {
                    if !self.turbulence_item(k, &mut turbulence)? {
                        break;
                    }
                }
                Warp::Turbulence(turbulence.unwrap_or_default())
            }
            K::Cylindrical | K::Spherical | K::Toroidal => {
                self.next()?;
                self.mapping_warp(keyword)?
            }
            K::Planar => {
                self.next()?;
                let (mut orientation, mut distance) = (DVec3::Z, 0.0);
                if self.starts_expression()? {
                    orientation = self.vector()?.normalize_or(DVec3::Z);
                    self.comma()?;
                    distance = self.float()?;
                }
                Warp::Planar { orientation, distance }
            }
            K::Cubic => {
                self.next()?;
                Warp::Cubic
            }
            _ => return self.error(span, format!("'{}' is no kind of warp", keyword.word())),
        };
        self.close("warp")?;
        Ok(warp)
    }

    fn repeat_warp(&mut self) -> SourceResult<Warp> {
        let span = self.span();
        let v = self.vector()?;
        let axes: Vec<usize> = (0..3).filter(|&i| v[i] != 0.0).collect();
        let [axis] = axes[..] else {
            return self.error(span, "a repeat warp needs exactly one axis, as in 'repeat 2*x'");
        };
        let (mut offset, mut flip) = (DVec3::ZERO, DVec3::ZERO);
        loop {
            if self.accept(K::Offset)? {
                offset = self.vector()?;
            } else if self.accept(K::Flip)? {
                flip = self.vector()?;
            } else {
                return Ok(Warp::Repeat { axis, width: v[axis] as f32, offset, flip });
            }
        }
    }

    fn black_hole(&mut self) -> SourceResult<Warp> {
        let center = self.vector()?;
        self.comma()?;
        let radius = self.float()?;
        let mut hole = BlackHole {
            center,
            radius,
            strength: 1.0,
            falloff: 2.0,
            inverse: false,
            kind: 0,
            repeat: None,
            turbulence: None,
        };
        loop {
            self.comma()?;
            if self.accept(K::Strength)? {
                hole.strength = self.float()?;
            } else if self.accept(K::Falloff)? {
                hole.falloff = self.float()?;
            } else if self.accept(K::Inverse)? {
                hole.inverse = true;
            } else if self.accept(K::Type)? {
                hole.kind = self.integer()? as i32;
            } else if self.accept(K::Repeat)? {
                hole.repeat = Some(self.vector()?);
            } else if self.accept(K::Turbulence)? {
                hole.turbulence = Some(self.vector()?);
            } else {
                return Ok(Warp::BlackHole(hole));
            }
        }
    }

    fn mapping_warp(&mut self, keyword: K) -> SourceResult<Warp> {
        let (mut orientation, mut dist_exp, mut major_radius) = (DVec3::Z, 0.0, 1.0);
        loop {
            if self.accept(K::Orientation)? {
                orientation = self.vector()?.normalize_or(DVec3::Z);
            } else if self.accept(K::DistExp)? {
                dist_exp = self.float()?;
            } else if self.accept(K::MajorRadius)? {
                major_radius = self.float()?;
            } else {
                break;
            }
        }
        Ok(match keyword {
            K::Cylindrical => Warp::Cylindrical { orientation, dist_exp },
            K::Spherical => Warp::Spherical { orientation, dist_exp },
            _ => Warp::Toroidal { orientation, dist_exp, major_radius },
        })
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
