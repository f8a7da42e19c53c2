//! `warp { … }`: what bends the space that a pattern stands in.

use super::described::Table;
use super::pattern_modifiers::TURBULENCE;
use super::table::{Block, Item, Takes, Word};
use crate::diag::SourceResult;
use crate::eval::Evaluator;
use crate::math::DVec3;
use crate::scene::{BlackHole, Warp};
use crate::syntax::Keyword as K;

/// Kinds of warp; another is all of [`TURBULENCE`].
pub(super) static WARP: Block<Option<Warp>> = Block::<Option<Warp>>::new(
    "warp",
    "bends the space that a pattern stands in",
    &[
        Item::new(
            K::Repeat,
            Takes::Whole("VECTOR …", |e, _| e.repeat_warp().map(Some)),
            "",
            "the same over and over, along one axis",
        ),
        Item::new(
            K::BlackHole,
            Takes::Whole("<CENTRE>, RADIUS …", |e, _| e.black_hole().map(Some)),
            "",
            "space is drawn to a point, or pushed away",
        ),
        Item::since(
            350,
            K::Cylindrical,
            Takes::Whole("…", |e, _| {
                let Mapping { orientation, dist_exp, .. } = e.mapping()?;
                Ok(Some(Warp::Cylindrical { orientation, dist_exp }))
            }),
            "",
            "x and y are laid around a cylinder",
        ),
        Item::since(
            350,
            K::Spherical,
            Takes::Whole("…", |e, _| {
                let Mapping { orientation, dist_exp, .. } = e.mapping()?;
                Ok(Some(Warp::Spherical { orientation, dist_exp }))
            }),
            "",
            "x and y are laid around a sphere",
        ),
        Item::since(
            350,
            K::Toroidal,
            Takes::Whole("…", |e, _| {
                let Mapping { orientation, dist_exp, major_radius } = e.mapping()?;
                Ok(Some(Warp::Toroidal { orientation, dist_exp, major_radius }))
            }),
            "",
            "x and y are laid around a ring",
        ),
        Item::since(
            350,
            K::Planar,
            Takes::Whole("[VECTOR, DISTANCE]", planar),
            "",
            "all along a direction is as on one plane",
        ),
        Item::since(370, K::Cubic, Takes::Nothing(|warp| *warp = Some(Warp::Cubic)), "", "x and y are laid on a cube"),
    ],
)
.with(&[&TURBULENCE]);

fn planar(e: &mut Evaluator<'_>, _: Word) -> SourceResult<Option<Warp>> {
    let (mut orientation, mut distance) = (DVec3::Z, 0.0);
    if e.starts_expression()? {
        orientation = e.vector()?.normalize_or(DVec3::Z);
        e.comma()?;
        distance = e.float()?;
    }
    Ok(Some(Warp::Planar { orientation, distance }))
}

pub(super) static BLACK_HOLE: Block<BlackHole> = Block::new(
    "black_hole",
    "in a warp: how space is drawn to a point",
    &[
        Item::new(K::Strength, Takes::Float(|hole| &mut hole.strength), "1", "how much; below 1 not all the way"),
        Item::new(K::Falloff, Takes::Float(|hole| &mut hole.falloff), "2", "power by which it falls off outwards"),
        Item::new(K::Inverse, Takes::Nothing(|hole| hole.inverse = true), "", "it pushes away"),
        Item::new(
            K::Type,
            Takes::Other("INTEGER", |e, hole, _| {
                hole.kind = e.integer()? as i32;
                Ok(())
            }),
            "0",
            "without effect",
        ),
        Item::new(
            K::Repeat,
            Takes::Other("VECTOR", |e, hole, _| {
                hole.repeat = Some(e.vector()?);
                Ok(())
            }),
            "",
            "one in each box of this size",
        ),
        Item::new(
            K::Turbulence,
            Takes::Other("VECTOR", |e, hole, _| {
                hole.turbulence = Some(e.vector()?);
                Ok(())
            }),
            "",
            "how far each of those is moved at random",
        ),
    ],
);

/// How copies of a stretch of space follow each other.
#[derive(Default)]
pub(super) struct Repeat {
    offset: DVec3,
    flip: DVec3,
}

pub(super) static REPEAT: Block<Repeat> = Block::new(
    "repeat",
    "in a warp: how copies follow each other",
    &[
        Item::new(
            K::Offset,
            Takes::Vector(|repeat| &mut repeat.offset),
            "0",
            "each is moved this much from the one before",
        ),
        Item::new(
            K::Flip,
            Takes::Vector(|repeat| &mut repeat.flip),
            "0",
            "every other one is mirrored along these axes",
        ),
    ],
);

/// What a warp takes behind its word.
fn words_of(warp: &Warp) -> &'static dyn Table {
    match warp {
        Warp::Repeat { .. } => &REPEAT,
        Warp::BlackHole(_) => &BLACK_HOLE,
        Warp::Cylindrical { .. } | Warp::Spherical { .. } | Warp::Toroidal { .. } => &MAPPING,
        Warp::Turbulence(_) => &TURBULENCE,
        _ => &WARP,
    }
}

/// How a plane is laid around something.
pub(super) struct Mapping {
    orientation: DVec3,
    dist_exp: f64,
    major_radius: f64,
}

pub(super) static MAPPING: Block<Mapping> = Block::new(
    "mapping warp",
    "behind cylindrical, spherical and toroidal in a warp",
    &[
        Item::since(
            350,
            K::Orientation,
            Takes::Other("VECTOR", |e, mapping, _| {
                mapping.orientation = e.vector()?.normalize_or(DVec3::Z);
                Ok(())
            }),
            "z",
            "where the plane looks",
        ),
        Item::since(
            350,
            K::DistExp,
            Takes::Float(|mapping| &mut mapping.dist_exp),
            "0",
            "power of the distance by which it grows outwards",
        ),
        Item::since(
            350,
            K::MajorRadius,
            Takes::Float(|mapping| &mut mapping.major_radius),
            "1",
            "toroidal: radius of the ring",
        ),
    ],
);

impl Evaluator<'_> {
    /// `{ … }` after `warp`.
    pub(super) fn warp(&mut self) -> SourceResult<Warp> {
        self.open("warp")?;
        let (mut warp, mut turbulence) = (None, None);
        if !self.item_of(&WARP, &mut warp)? {
            while self.item_of(&TURBULENCE, &mut turbulence)? {}
            warp = turbulence.map(Warp::Turbulence);
        }
        let Some(warp) = warp else {
            return match self.keyword()? {
                Some(keyword) => {
                    let span = self.span();
                    self.error(span, format!("'{}' is no kind of warp", keyword.word()))
                }
                None => self.expected_in(&WARP, "a kind of warp"),
            };
        };
        if !self.accept_punct('}')? {
            return self.expected_in(words_of(&warp), "'}' to close warp");
        }
        self.budget.shallower();
        Ok(warp)
    }

    fn repeat_warp(&mut self) -> SourceResult<Warp> {
        let span = self.span();
        let v = self.vector()?;
        let axes: Vec<usize> = (0..3).filter(|&i| v[i] != 0.0).collect();
        let [axis] = axes[..] else {
            return self.error(span, "a repeat warp needs exactly one axis, as in 'repeat 2*x'");
        };
        let mut repeat = Repeat::default();
        while self.item_of(&REPEAT, &mut repeat)? {}
        let Repeat { offset, flip } = repeat;
        Ok(Warp::Repeat { axis, width: v[axis] as f32, offset, flip })
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
        self.comma()?;
        self.items_of(&BLACK_HOLE, &mut hole)?;
        Ok(Warp::BlackHole(hole))
    }

    fn mapping(&mut self) -> SourceResult<Mapping> {
        let mut mapping = Mapping { orientation: DVec3::Z, dist_exp: 0.0, major_radius: 1.0 };
        while self.item_of(&MAPPING, &mut mapping)? {}
        Ok(mapping)
    }
}
