//! Modifiers of patterns: waves, turbulence, and what belongs to one kind of pattern.

use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Topic};
use crate::eval::Evaluator;
use crate::scene::PatternKind as P;
use crate::scene::{FractalColoring, Pattern, PatternKind, Turbulence, Wave};
use crate::syntax::Keyword as K;

/// Modifiers of any pattern; beside them there are [`TURBULENCE`] and [`OF_KINDS`].
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

/// What belongs to one kind of pattern.
pub(super) static OF_KINDS: Block<PatternKind> = Block::new(
    "modifiers of one pattern",
    "what only some patterns take",
    &[
        Item::new(
            K::AgateTurb,
            Takes::Other("FLOAT", |e, p, at| match p {
                P::Agate { turbulence } => e.float().map(|value| *turbulence = value as f32),
                _ => misplaced(e, at),
            }),
            "",
            "agate: its turbulence",
        ),
        Item::new(
            K::BrickSize,
            Takes::Other("VECTOR", |e, p, at| match p {
                P::Brick { size, .. } => e.vector().map(|value| *size = value),
                _ => misplaced(e, at),
            }),
            "",
            "brick: how large one is with its mortar",
        ),
        Item::new(
            K::Mortar,
            Takes::Other("FLOAT", |e, p, at| match p {
                P::Brick { mortar, .. } => e.float().map(|value| *mortar = value as f32),
                _ => misplaced(e, at),
            }),
            "",
            "brick: how thick it is",
        ),
        Item::new(
            K::Control0,
            Takes::Other("FLOAT", |e, p, at| match p {
                P::Quilted { control0, .. } => e.float().map(|value| *control0 = value as f32),
                _ => misplaced(e, at),
            }),
            "",
            "quilted: how steep cushions are at their edges",
        ),
        Item::new(
            K::Control1,
            Takes::Other("FLOAT", |e, p, at| match p {
                P::Quilted { control1, .. } => e.float().map(|value| *control1 = value as f32),
                _ => misplaced(e, at),
            }),
            "",
            "quilted: how steep cushions are in the middle",
        ),
        Item::since(
            350,
            K::Form,
            Takes::Other("VECTOR | 0 to 4", |e, p, at| match p {
                P::Crackle { form, .. } => e.vector().map(|value| *form = value),
                P::Pavement { form, .. } => e.count().map(|value| *form = value),
                _ => misplaced(e, at),
            }),
            "",
            "crackle: weights of the nearest points; pavement: how edges are bent",
        ),
        Item::since(
            350,
            K::Metric,
            Takes::Other("FLOAT", |e, p, at| match p {
                P::Crackle { metric, .. } => e.vector().map(|value| *metric = value.x),
                _ => misplaced(e, at),
            }),
            "",
            "crackle: 1 or 2, how distances are measured",
        ),
        Item::since(
            350,
            K::Offset,
            Takes::Other("FLOAT", |e, p, at| match p {
                P::Crackle { offset, .. } => e.float().map(|value| *offset = value),
                _ => misplaced(e, at),
            }),
            "",
            "crackle: how far out of the plane of points it is",
        ),
        Item::since(
            350,
            K::Solid,
            Takes::Other("[BOOL]", |e, p, at| match p {
                P::Crackle { solid, .. } => e.optional_bool().map(|value| *solid = value),
                _ => misplaced(e, at),
            }),
            "",
            "crackle: the same value all over a cell",
        ),
        Item::since(
            350,
            K::Exponent,
            Takes::Other("INTEGER", |e, p, at| match p {
                P::Julia { exponent, .. } | P::Mandel { exponent, .. } => {
                    let n = e.integer()?;
                    *exponent = if (2..=33).contains(&n) { n as u32 } else { 2 };
                    if !(2..=33).contains(&n) {
                        e.warn(Topic::Range, at.span, "a fractal exponent outside 2 to 33 means 2");
                    }
                    Ok(())
                }
                _ => misplaced(e, at),
            }),
            "",
            "julia, mandel: the power in its formula",
        ),
        Item::since(
            350,
            K::Exterior,
            Takes::Other("0 to 8, FLOAT", |e, p, at| match p {
                P::Julia { exterior: c, .. } | P::Mandel { exterior: c, .. } | P::Magnet { exterior: c, .. } => {
                    coloring(e, at, 8).map(|value| *c = value)
                }
                P::Pavement { exterior, .. } => e.count().map(|value| *exterior = value),
                _ => misplaced(e, at),
            }),
            "",
            "fractals: values outside, and a factor; pavement: how outer corners are cut",
        ),
        Item::since(
            350,
            K::Interior,
            Takes::Other("0 to 6, FLOAT", |e, p, at| match p {
                P::Julia { interior: c, .. } | P::Mandel { interior: c, .. } | P::Magnet { interior: c, .. } => {
                    coloring(e, at, 6).map(|value| *c = value)
                }
                P::Pavement { interior, .. } => e.count().map(|value| *interior = value),
                _ => misplaced(e, at),
            }),
            "",
            "fractals: values inside, and a factor; pavement: how inner corners are cut",
        ),
        Item::since(
            370,
            K::NumberOfSides,
            Takes::Other("3 | 4 | 6", |e, p, at| match p {
                P::Pavement { sides, .. } => e.count().map(|value| *sides = value),
                _ => misplaced(e, at),
            }),
            "",
            "pavement: of the pieces that a tile is made of",
        ),
        Item::since(
            370,
            K::NumberOfTiles,
            Takes::Other("INTEGER", |e, p, at| match p {
                P::Pavement { tiles, .. } => e.count().map(|value| *tiles = value),
                _ => misplaced(e, at),
            }),
            "",
            "pavement: pieces in a tile",
        ),
        Item::since(
            370,
            K::Pattern,
            Takes::Other("INTEGER", |e, p, at| match p {
                P::Pavement { pattern, .. } => e.count().map(|value| *pattern = value),
                _ => misplaced(e, at),
            }),
            "",
            "pavement: which tile of that many pieces",
        ),
        Item::new(
            K::Interpolate,
            Takes::Other("INTEGER", |e, p, at| match p {
                P::DensityFile { interpolation, .. } => {
                    e.integer().map(|value| *interpolation = value.rem_euclid(10) as u8)
                }
                _ => misplaced(e, at),
            }),
            "",
            "density_file: between values, 0 not at all, 1 linearly, 2 smoothly",
        ),
    ],
);

fn misplaced(e: &Evaluator<'_>, at: Word) -> SourceResult<()> {
    e.error(at.span, format!("'{}' does not belong to this pattern", at.word.word()))
}

/// `interior` and `exterior` of a fractal.
fn coloring(e: &mut Evaluator<'_>, at: Word, most: i64) -> SourceResult<FractalColoring> {
    let kind = e.integer()?;
    e.comma()?;
    if !(0..=most).contains(&kind) {
        return e.error(at.span, format!("the fractal colouring type must be between 0 and {most}"));
    }
    Ok(FractalColoring { kind: kind as u32, factor: e.float()? })
}

impl Evaluator<'_> {
    /// One modifier that any pattern takes, if one comes next.
    pub(super) fn pattern_modifier(&mut self, pattern: &mut Pattern) -> SourceResult<bool> {
        Ok(self.item_of(&MODIFIERS, pattern)?
            || self.item_of(&TURBULENCE, &mut pattern.turbulence)?
            || self.item_of(&OF_KINDS, &mut pattern.kind)?)
    }
}
