//! `normal { … }`.

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

impl Evaluator<'_> {
    /// `{ … }` after `normal`, starting from `start`; nothing where no pattern was given at all.
    pub(super) fn normal_block(&mut self, start: Option<Arc<Normal>>) -> SourceResult<Option<Arc<Normal>>> {
        self.open("normal")?;
        let normal = self.normal_items(start)?;
        self.close("normal")?;
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
        match self.keyword()? {
            Some(K::BumpMap) => {
                self.next()?;
                let pattern = take_pattern(&mut normal.kind);
                self.bump_map(normal, pattern)?;
            }
            Some(K::Facets) => {
                self.next()?;
                let pattern = take_pattern(&mut normal.kind);
                normal.kind = NormalKind::Facets { pattern, coords: 0.0, size: 0.1, metric: 2.0 };
            }
            Some(k @ (K::Coords | K::Size | K::Metric)) if matches!(normal.kind, NormalKind::Facets { .. }) => {
                self.next()?;
                let value = if k == K::Metric { self.vector()?.x } else { self.float()? };
                if let NormalKind::Facets { coords, size, metric, .. } = &mut normal.kind {
                    match k {
                        K::Coords => *coords = value,
                        K::Size => *size = value.max(1e-6), // POV-Ray's smallest facet
                        _ => *metric = value,
                    }
                }
            }
            Some(K::SlopeMap) => {
                self.check_map(&pattern_of(&mut normal.kind).kind, "slope_map", false)?;
                self.next()?;
                let map = self.slope_map()?;
                normal.kind = NormalKind::Pattern(take_pattern(&mut normal.kind), Some(map));
            }
            Some(K::NormalMap) => {
                if matches!(normal.kind, NormalKind::Facets { .. }) {
                    let span = self.span();
                    return self.error(span, "facets take no normal_map");
                }
                self.check_map(&pattern_of(&mut normal.kind).kind, "normal_map", true)?;
                self.next()?;
                let average = matches!(pattern_of(&mut normal.kind).kind, PatternKind::Average);
                let map = self.normal_map(average)?;
                normal.kind = NormalKind::Normals(take_pattern(&mut normal.kind), map);
            }
            Some(K::BumpSize) => {
                self.next()?;
                normal.amount = self.float()? as f32;
            }
            Some(K::Accuracy) => {
                self.next()?;
                normal.accuracy = self.float()? as f32;
            }
            Some(K::NoBumpScale) => {
                self.next()?;
                normal.no_bump_scale = true;
            }
            Some(K::UvMapping) => {
                self.next()?;
                let pattern = Pattern { kind: PatternKind::Uv, ..take_pattern(&mut normal.kind) };
                let inner = self.normal_items(self.defaults.layer.normal.clone())?;
                normal.kind = NormalKind::Normals(pattern, Blend::Map(vec![MapEntry { value: 0.0, item: inner }]));
            }
            _ => return self.normal_pattern(normal),
        }
        Ok(true)
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
            if self.accept(K::BumpSize)? {
                normal.amount = self.float()? as f32;
            } else if !self.image_option(&mut mapping)? {
                break;
            }
        }
        self.close("bump_map")?;
        pattern.kind = PatternKind::None;
        normal.kind = NormalKind::BumpMap(pattern, Arc::new((image, mapping)));
        self.comma()?;
        if self.starts_expression()? {
            normal.amount = self.float()? as f32;
        }
        Ok(())
    }
}
