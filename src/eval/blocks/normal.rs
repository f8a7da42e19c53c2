//! `normal { … }`.

use super::image::MAPPING;
use super::pattern::PATTERNS;
use super::pattern_modifiers::{MODIFIERS, OF_KINDS, TURBULENCE};
use super::table::{Block, Item, Takes, Word};
use crate::diag::SourceResult;
use crate::eval::{Evaluator, Value};
use crate::scene::{Blend, MapEntry, Normal, NormalKind, Pattern, PatternKind};
use crate::stack::roomy;
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// The pattern of a normal of any kind.
fn pattern_of(kind: &mut NormalKind) -> &mut Pattern {
    match kind {
        NormalKind::Pattern(p, _) | NormalKind::Normals(p, _) | NormalKind::BumpMap(p, _) => p,
        NormalKind::Facets { pattern, .. } => pattern,
    }
}

/// The pattern, moved out to become part of another kind.
fn take_pattern(kind: &mut NormalKind) -> Pattern {
    std::mem::replace(pattern_of(kind), Pattern::new(PatternKind::None))
}

pub(super) static NORMAL: Block<Normal> = Block::<Normal>::new(
    "normal",
    "bumps of a surface, which only light sees",
    &[
        Item::new(
            K::BumpMap,
            Takes::Other("{ IMAGE … } [AMOUNT]", |e, normal, _| {
                let pattern = take_pattern(&mut normal.kind);
                e.bump_map(normal, pattern)
            }),
            "",
            "heights are a picture",
        ),
        Item::since(
            350,
            K::Facets,
            Takes::Nothing(|normal| {
                let pattern = take_pattern(&mut normal.kind);
                normal.kind = NormalKind::Facets { pattern, coords: 0.0, size: 0.1, metric: 2.0 };
            }),
            "",
            "it is made of flat pieces",
        ),
        Item::new(
            K::SlopeMap,
            Takes::Other("{ [FLOAT <HEIGHT, SLOPE>] … }", |e, normal, at| {
                e.check_map(&pattern_of(&mut normal.kind).kind, at, false)?;
                let map = e.slope_map()?;
                normal.kind = NormalKind::Pattern(take_pattern(&mut normal.kind), Some(map));
                Ok(())
            }),
            "",
            "which height is where in the pattern",
        ),
        Item::new(
            K::NormalMap,
            Takes::Other("{ [FLOAT NORMAL] … }", normal_map),
            "",
            "which normal is where in the pattern",
        ),
        Item::new(K::BumpSize, Takes::Single(|normal| &mut normal.amount), "", "how deep bumps are"),
        Item::since(
            350,
            K::Accuracy,
            Takes::Single(|normal| &mut normal.accuracy),
            "0.02",
            "how far apart the places are from which slopes are taken",
        ),
        Item::since(
            350,
            K::NoBumpScale,
            Takes::Nothing(|normal| normal.no_bump_scale = true),
            "",
            "bumps keep their depth when it is scaled",
        ),
        Item::since(
            350,
            K::UvMapping,
            Takes::Other("", |e, normal, _| {
                let pattern = Pattern { kind: PatternKind::Uv, ..take_pattern(&mut normal.kind) };
                let inner = e.normal_items(e.defaults.layer.normal.clone())?;
                normal.kind = NormalKind::Normals(pattern, Blend::Map(vec![MapEntry { value: 0.0, item: inner }]));
                Ok(())
            }),
            "",
            "what follows lies on the surface by its own coordinates",
        ),
    ],
)
.with(&[&FACETS, &PATTERNS, &MODIFIERS, &TURBULENCE, &OF_KINDS]);

/// What only `facets` take.
static FACETS: Block<Normal> = Block::new(
    "facets",
    "what facets take",
    &[
        Item::since(350, K::Coords, Takes::Other("FLOAT", facet), "", "pieces are equally large; how much they differ"),
        Item::since(350, K::Size, Takes::Other("FLOAT", facet), "0.1", "how large pieces are"),
        Item::since(350, K::Metric, Takes::Other("FLOAT", facet), "2", "how distances are measured"),
    ],
);

pub(super) static BUMP_MAP: Block<Normal> = Block::<Normal>::new(
    "bump_map",
    "a picture as a normal",
    &[Item::new(K::BumpSize, Takes::Single(|normal| &mut normal.amount), "", "how deep bumps are")],
)
.with(&[&MAPPING]);

fn facet(e: &mut Evaluator<'_>, normal: &mut Normal, at: Word) -> SourceResult<()> {
    let value = if at.word == K::Metric { e.vector()?.x } else { e.float()? };
    if let NormalKind::Facets { coords, size, metric, .. } = &mut normal.kind {
        match at.word {
            K::Coords => *coords = value,
            K::Size => *size = value.max(1e-6), // POV-Ray's smallest facet
            _ => *metric = value,
        }
    }
    Ok(())
}

fn normal_map(e: &mut Evaluator<'_>, normal: &mut Normal, at: Word) -> SourceResult<()> {
    if matches!(normal.kind, NormalKind::Facets { .. }) {
        return e.error(at.span, "facets take no normal_map");
    }
    e.check_map(&pattern_of(&mut normal.kind).kind, at, true)?;
    let average = matches!(pattern_of(&mut normal.kind).kind, PatternKind::Average);
    let map = e.normal_map(average)?;
    normal.kind = NormalKind::Normals(take_pattern(&mut normal.kind), map);
    Ok(())
}

impl Evaluator<'_> {
    /// `{ … }` after `normal`, starting from `start`; nothing where no pattern was given at all.
    pub(super) fn normal_block(&mut self, start: Option<Arc<Normal>>) -> SourceResult<Option<Arc<Normal>>> {
        self.open("normal")?;
        let normal = self.normal_items(start)?;
        self.close_of(&NORMAL)?;
        Ok(Some(normal))
    }

    /// The inside of a normal, also of a `normal_map` entry.
    pub(super) fn normal_items(&mut self, start: Option<Arc<Normal>>) -> SourceResult<Arc<Normal>> {
        roomy(|| self.whole_normal(start))
    }

    fn whole_normal(&mut self, start: Option<Arc<Normal>>) -> SourceResult<Arc<Normal>> {
        let span = self.peek()?.span;
        let mut normal = start.map(|n| (*n).clone()).unwrap_or_default();
        let pick = |v: &Value| if let Value::Normal(n) = v { Some(n.clone()) } else { None };
        if let Some(known) = self.take_declared(pick)? {
            normal = (*known).clone();
        }
        while self.normal_item(&mut normal)? {}
        normal.span = span;
        normal.depth = self.within(self.budget.levels(normal.depth_of_parts()), span)?;
        Ok(Arc::new(normal))
    }

    fn normal_item(&mut self, normal: &mut Normal) -> SourceResult<bool> {
        self.comma()?;
        let facets = matches!(normal.kind, NormalKind::Facets { .. });
        if self.item_of(&NORMAL, normal)? || facets && self.item_of(&FACETS, normal)? {
            return Ok(true);
        }
        self.normal_pattern(normal)
    }

    /// A pattern keyword with an optional amount, or a pattern modifier.
    fn normal_pattern(&mut self, normal: &mut Normal) -> SourceResult<bool> {
        let mut list = None;
        let mut read_list = |e: &mut Evaluator, n: usize| {
            let mut normals = Vec::new();
            e.comma()?;
            while normals.len() < n && e.accept(K::Normal)? {
                let start = e.defaults.layer.normal.clone();
                normals.extend(e.normal_block(start)?);
                e.comma()?;
            }
            if !normals.is_empty() {
                normals.resize_with(n, || e.defaults.layer.normal.clone().unwrap_or_default());
                list = Some(normals);
            }
            Ok(())
        };
        if !self.pattern_keyword(pattern_of(&mut normal.kind), &mut read_list)? {
            return self.pattern_modifier(pattern_of(&mut normal.kind));
        }
        let pattern = take_pattern(&mut normal.kind);
        if pattern.kind.n_blocks().is_some() {
            normal.accuracy = 0.02; // a block pattern resets it, as in POV-Ray
        }
        normal.kind = match (list, std::mem::replace(&mut normal.kind, NormalKind::Pattern(Pattern::default(), None))) {
            (Some(list), _) => NormalKind::Normals(pattern, Blend::List(list)),
            (None, NormalKind::Normals(_, map)) if pattern.kind.n_blocks().is_none() => {
                NormalKind::Normals(pattern, map)
            }
            (None, NormalKind::Pattern(_, slopes)) => NormalKind::Pattern(pattern, slopes),
            (None, _) => NormalKind::Pattern(pattern, None),
        };
        self.comma()?;
        if self.starts_expression()? {
            normal.amount = self.float()? as f32;
        }
        Ok(true)
    }

    /// `bump_map { … }`, after the word.
    fn bump_map(&mut self, normal: &mut Normal, mut pattern: Pattern) -> SourceResult<()> {
        self.open("bump_map")?;
        let image = self.image()?;
        let mut mapping = Default::default();
        loop {
            self.comma()?;
            if !self.item_of(&BUMP_MAP, normal)? && !self.item_of(&MAPPING, &mut mapping)? {
                break;
            }
        }
        self.close_of(&BUMP_MAP)?;
        pattern.kind = PatternKind::None;
        normal.kind = NormalKind::BumpMap(pattern, Arc::new((image, mapping)));
        self.comma()?;
        if self.starts_expression()? {
            normal.amount = self.float()? as f32;
        }
        Ok(())
    }
}
