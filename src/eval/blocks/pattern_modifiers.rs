//! Modifiers of patterns: waves, turbulence, warps, and what belongs to one kind of pattern.

use super::table::{Block, Item, Takes};
use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::math::DVec3;
use crate::scene::{BlackHole, FractalColoring, Pattern, PatternKind, Turbulence, Warp, Wave};
use crate::syntax::Keyword as K;

/// Modifiers of any pattern; beside them there are [`TURBULENCE`] and what belongs to one kind of pattern.
pub(super) static MODIFIERS: Block<Pattern> = Block::moved(
    "pattern",
    "what any pattern takes",
    |_, pattern, transform| pattern.apply(transform),
    &[
        Item::new(K::Frequency, Takes::Single(|p| &mut p.frequency), "", "how often its map is gone through"),
        Item::new(K::Phase, Takes::Single(|p| &mut p.phase), "", "where in its map it begins"),
        Item::new(K::RampWave, Takes::Nothing(|p| p.wave = Wave::Ramp), "", "its values go up and begin anew"),
        Item::new(K::TriangleWave, Takes::Nothing(|p| p.wave = Wave::Triangle), "", "its values go up and down"),
        Item::new(K::SineWave, Takes::Nothing(|p| p.wave = Wave::Sine), "", "its values go up and down smoothly"),
        Item::new(K::ScallopWave, Takes::Nothing(|p| p.wave = Wave::Scallop), "", "its values go as arcs do"),
        Item::new(K::CubicWave, Takes::Nothing(|p| p.wave = Wave::Cubic), "", "its values go up and down by a cubic"),
        Item::new(
            K::PolyWave,
            Takes::Other("[FLOAT]", |e, p, _| {
                let kept = if let Wave::Poly(exponent) = p.wave { exponent } else { 1.0 };
                p.wave = Wave::Poly(if e.starts_expression()? { e.float()? as f32 } else { kept });
                Ok(())
            }),
            "",
            "its values are raised to a power",
        ),
        Item::since(
            350,
            K::NoiseGenerator,
            Takes::Other("INTEGER", |e, p, at| {
                let n = e.integer()?;
                if !(0..=3).contains(&n) {
                    return e.error(at.span, "noise_generator must be 0, 1, 2 or 3");
                }
                // Repeated choices combine by bits, as in POV-Ray.
                let combined = p.noise_generator.unwrap_or(0) | n as u8;
                p.noise_generator = (combined != 0).then_some(combined);
                Ok(())
            }),
            "",
            "the noise that it is made of, if not that of global_settings",
        ),
        Item::new(
            K::Warp,
            Takes::Other("{ WARP }", |e, p, _| {
                let warp = e.warp()?;
                p.add(warp);
                Ok(())
            }),
            "",
            "bends the space that it stands in",
        ),
    ],
);

/// How points are displaced at random.
pub(super) static TURBULENCE: Block<Option<Turbulence>> = Block::new(
    "turbulence",
    "how points are displaced at random",
    &[
        Item::new(
            K::Turbulence,
            Takes::Other("VECTOR", |e, t, _| {
                let amount = e.vector()?;
                t.get_or_insert_default().amount = amount;
                Ok(())
            }),
            "",
            "how far along each axis",
        ),
        Item::new(
            K::Octaves,
            Takes::Other("INTEGER", |e, t, _| {
                let octaves = e.integer()?.clamp(1, 10) as u32;
                t.get_or_insert_default().octaves = octaves;
                Ok(())
            }),
            "",
            "steps of finer and finer noise; 6 if not given",
        ),
        Item::new(
            K::Omega,
            Takes::Other("FLOAT", |e, t, _| {
                let omega = e.float()? as f32;
                t.get_or_insert_default().omega = omega;
                Ok(())
            }),
            "",
            "strength of each step by that of the one before; 0.5 if not given",
        ),
        Item::new(
            K::Lambda,
            Takes::Other("FLOAT", |e, t, _| {
                let lambda = e.float()? as f32;
                t.get_or_insert_default().lambda = lambda;
                Ok(())
            }),
            "",
            "fineness of each step by that of the one before; 2 if not given",
        ),
    ],
);

impl Evaluator<'_> {
    /// One modifier that any pattern takes, if one comes next.
    pub(super) fn pattern_modifier(&mut self, pattern: &mut Pattern) -> SourceResult<bool> {
        if self.item_of(&MODIFIERS, pattern)? || self.item_of(&TURBULENCE, &mut pattern.turbulence)? {
            return Ok(true);
        }
        match self.keyword()? {
            Some(keyword) => self.kind_modifier(keyword, pattern),
            None => Ok(false),
        }
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
                while self.item_of(&TURBULENCE, &mut turbulence)? {}
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
