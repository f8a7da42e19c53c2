//! Pigments, normals and densities: what patterns choose from.

use super::appearance::blend;
use super::reader::{Reader, Value};
use super::tree::{Items, Node, Read, Rule, place, wrong};
use crate::math::Color;
use crate::scene::{
    Blend, Density, ImageMap, MapEntry, Normal, NormalKind, Pattern, PatternKind, Pigment, PigmentKind, RarePigment,
};
use crate::stack::roomy;
use std::sync::Arc;

impl<'a> Reader<'a> {
    /// `pigment { … }`.
    pub(super) fn pigment(&mut self, node: Node<'a>) -> Read<Arc<Pigment>> {
        let content = Items::of(node).node()?;
        self.pigment_content(content)
    }

    /// The inside of a pigment; a name that nothing is added to stays shared.
    pub(super) fn pigment_content(&mut self, node: Node<'a>) -> Read<Arc<Pigment>> {
        roomy(|| self.whole_pigment(node))
    }

    fn whole_pigment(&mut self, node: Node<'a>) -> Read<Arc<Pigment>> {
        let mut items = Items::of(node.clone());
        let mut pigment = Pigment { span: place(&node), ..Pigment::default() };
        if let Some(name) = items.optional(Rule::identifier) {
            let known = self.known_pigment(&name)?;
            if items.peek().is_none() {
                return Ok(known);
            }
            pigment = (*known).clone();
        } else if let Some(uv) = items.optional(Rule::uv_pigment) {
            let inner = Items::of(uv).node()?;
            pigment = Pigment { span: place(&node), ..Pigment::at_uv(self.pigment_content(inner)?) };
        } else if let Some(map) = items.optional(Rule::image_map) {
            let map = Arc::new(self.image_map(map)?);
            pigment.kind = PigmentKind::Image(Box::new(Pattern::new(PatternKind::None)), map);
        } else if let Some(color) = items.optional(Rule::color) {
            pigment.kind = PigmentKind::Solid(super::tree::color(color)?);
        } else if let Some(pattern) = items.optional(Rule::pattern) {
            let (pattern, list) = self.pattern(pattern)?;
            pigment.kind = self.pattern_of_pigments(pattern, list)?;
        }
        for item in items {
            self.pigment_modifier(item, &mut pigment)?;
        }
        pigment.depth = self.nested(pigment.depth_of_parts(), &node)?;
        Ok(Arc::new(pigment))
    }

    fn known_pigment(&self, name: &Node<'_>) -> Read<Arc<Pigment>> {
        self.known(name, "pigment", |v| if let Value::Pigment(p) = v { Some(Arc::clone(p)) } else { None })
    }

    /// A pattern with the items of its list, if it has one.
    fn pattern_of_pigments(&mut self, pattern: Pattern, list: Option<Node<'a>>) -> Read<PigmentKind> {
        let pattern = Box::new(pattern);
        let Some(list) = list else { return Ok(PigmentKind::Colors(pattern, Arc::new(Blend::Default))) };
        if list.clone().into_inner().any(|item| item.as_rule() == Rule::color) {
            self.check_items(&list, &pattern.kind, Rule::color)?;
            let colors = list.into_inner().map(super::tree::color).collect::<Read<_>>()?;
            return Ok(PigmentKind::Colors(pattern, Arc::new(Blend::List(colors))));
        }
        self.check_items(&list, &pattern.kind, Rule::pigment)?;
        let pigments = list.into_inner().map(|item| self.pigment(item)).collect::<Read<_>>()?;
        Ok(PigmentKind::Pigments(pattern, Arc::new(Blend::List(pigments))))
    }

    fn pigment_modifier(&mut self, node: Node<'a>, pigment: &mut Pigment) -> Read<()> {
        match node.as_rule() {
            Rule::color_map => {
                let map = self.color_map(node.clone())?;
                let pattern = pattern_for_map(&node, pigment)?;
                pigment.kind = PigmentKind::Colors(pattern, map);
            }
            Rule::pigment_map => {
                let pattern = pattern_for_map(&node, pigment)?;
                let average = matches!(pattern.kind, PatternKind::Average);
                pigment.kind = PigmentKind::Pigments(pattern, self.pigment_map(node, average)?);
            }
            Rule::quick_color => {
                let quick_color = Some(Items::of(node).color()?);
                let rare: &mut RarePigment = pigment.rare.get_or_insert_default();
                rare.quick_color = quick_color;
            }
            Rule::transform => {
                let transform = self.transform(node)?;
                pigment.apply(&transform);
            }
            _ => match &mut pigment.kind {
                PigmentKind::Solid(_) => return wrong(&node, "a plain colour has no pattern that this could change"),
                PigmentKind::Colors(p, _) | PigmentKind::Pigments(p, _) | PigmentKind::Image(p, _) => {
                    return self.pattern_modifier(node, p);
                }
            },
        }
        Ok(())
    }

    /// `color_map { … }`.
    pub(super) fn color_map(&mut self, node: Node<'a>) -> Read<Arc<Blend<Color>>> {
        let mut items = Items::of(node);
        if let Some(name) = items.optional(Rule::identifier) {
            let pick = |v: &Value| if let Value::ColorMap(m) = v { Some(Arc::clone(m)) } else { None };
            return self.known(&name, "color_map", pick);
        }
        let mut entries = Vec::new();
        for entry in items {
            let mut inner = Items::of(entry);
            entries.push(MapEntry { value: inner.float()?, item: inner.color()? });
        }
        Ok(Arc::new(Blend::Map(entries)))
    }

    /// `pigment_map { … }`.
    pub(super) fn pigment_map(&mut self, node: Node<'a>, average: bool) -> Read<Arc<Blend<Arc<Pigment>>>> {
        let mut items = Items::of(node);
        if let Some(name) = items.optional(Rule::identifier) {
            let pick = |v: &Value| if let Value::PigmentMap(m) = v { Some(Arc::clone(m)) } else { None };
            return self.known(&name, "pigment_map", pick);
        }
        let mut entries = Vec::new();
        for entry in items {
            let mut inner = Items::of(entry);
            let value = inner.float()?;
            let content = inner.node()?;
            entries.push(MapEntry { value, item: self.pigment_content(content)? });
        }
        Ok(Arc::new(if average { Blend::Average(entries) } else { Blend::Map(entries) }))
    }

    fn image_map(&mut self, node: Node<'a>) -> Read<ImageMap> {
        let mut items = Items::of(node);
        let (image, mapping) = self.image_and_mapping(items.node()?)?;
        let (palette_filter, palette_transmit) = (Vec::new(), Vec::new());
        let mut map =
            ImageMap { image, mapping, palette_filter, palette_transmit, filter_all: None, transmit_all: None };
        for item in items {
            let mut inner = Items::of(item);
            let filter = inner.word()? == "filter";
            let first = inner.node()?;
            if inner.peek().is_none() {
                let value = super::tree::number(&first)? as f32;
                *(if filter { &mut map.filter_all } else { &mut map.transmit_all }) = Some(value);
                continue;
            }
            let index = super::tree::number(&first)?;
            if !(0.0..=f64::from(u32::MAX)).contains(&index) {
                return wrong(&first, "expected the number of a palette's entry");
            }
            let list = if filter { &mut map.palette_filter } else { &mut map.palette_transmit };
            list.push((index as u32, inner.float()?));
        }
        Ok(map)
    }

    /// `normal { … }`.
    pub(super) fn normal(&mut self, node: Node<'a>) -> Read<Arc<Normal>> {
        let content = Items::of(node).node()?;
        self.normal_content(content)
    }

    fn normal_content(&mut self, node: Node<'a>) -> Read<Arc<Normal>> {
        roomy(|| self.whole_normal(node))
    }

    fn whole_normal(&mut self, node: Node<'a>) -> Read<Arc<Normal>> {
        let mut items = Items::of(node.clone());
        let mut normal = Normal { span: place(&node), ..Normal::default() };
        if let Some(name) = items.optional(Rule::identifier) {
            let pick = |v: &Value| if let Value::Normal(n) = v { Some(Arc::clone(n)) } else { None };
            let known = self.known(&name, "normal", pick)?;
            if items.peek().is_none() {
                return Ok(known);
            }
            normal = (*known).clone();
        } else if let Some(uv) = items.optional(Rule::uv_normal) {
            let inner = Items::of(uv).node()?;
            normal = Normal { span: place(&node), ..Normal::at_uv(self.normal_content(inner)?) };
        } else if let Some(map) = items.optional(Rule::bump_map) {
            let image = self.image_and_mapping(Items::of(map).node()?)?;
            normal.kind = NormalKind::BumpMap(Pattern::new(PatternKind::None), Arc::new(image));
        } else if let Some(facets) = items.optional(Rule::facets) {
            let mut inner = Items::of(facets);
            let pattern = Pattern::new(PatternKind::None);
            let (coords, size, metric) = (inner.number()?, inner.number()?, inner.number()?);
            normal.kind = NormalKind::Facets { pattern, coords, size, metric };
        } else if let Some(pattern) = items.optional(Rule::pattern) {
            let (pattern, list) = self.pattern(pattern)?;
            normal.kind = match list {
                None => NormalKind::Pattern(pattern, None),
                Some(list) => {
                    self.check_items(&list, &pattern.kind, Rule::normal)?;
                    let list = list.into_inner().map(|item| self.normal(item)).collect::<Read<_>>()?;
                    NormalKind::Normals(pattern, Blend::List(list))
                }
            };
        }
        for item in items {
            self.normal_modifier(item, &mut normal)?;
        }
        normal.depth = self.nested(normal.depth_of_parts(), &node)?;
        Ok(Arc::new(normal))
    }

    fn normal_modifier(&mut self, node: Node<'a>, normal: &mut Normal) -> Read<()> {
        match node.as_rule() {
            Rule::normal_number => {
                let mut items = Items::of(node);
                let field = if items.word()? == "bump_size" { &mut normal.amount } else { &mut normal.accuracy };
                *field = items.float()?;
            }
            Rule::no_bump_scale => normal.no_bump_scale = true,
            Rule::slope_map => {
                let NormalKind::Pattern(pattern, slopes) = &mut normal.kind else {
                    return wrong(&node, "a slope_map needs a pattern before it");
                };
                if matches!(pattern.kind, PatternKind::None) {
                    return wrong(&node, "a slope_map needs a pattern before it");
                }
                *slopes = Some(slope_map(node)?);
            }
            Rule::normal_map => {
                let pattern = match &normal.kind {
                    NormalKind::Pattern(pattern, None) if !matches!(pattern.kind, PatternKind::None) => pattern.clone(),
                    _ => return wrong(&node, "a normal_map needs a pattern before it"),
                };
                let mut entries = Vec::new();
                for entry in node.into_inner() {
                    let mut inner = Items::of(entry);
                    let value = inner.float()?;
                    let content = inner.node()?;
                    entries.push(MapEntry { value, item: self.normal_content(content)? });
                }
                let map = blend(entries, &pattern);
                normal.kind = NormalKind::Normals(pattern, map);
            }
            _ => match &mut normal.kind {
                NormalKind::Pattern(p, _) | NormalKind::Normals(p, _) | NormalKind::BumpMap(p, _) => {
                    self.pattern_modifier(node, p)?;
                }
                NormalKind::Facets { pattern, .. } => self.pattern_modifier(node, pattern)?,
            },
        }
        Ok(())
    }

    /// `density { … }`.
    pub(super) fn density(&mut self, node: Node<'a>) -> Read<Arc<Density>> {
        let content = Items::of(node).node()?;
        self.density_content(content)
    }

    fn density_content(&mut self, node: Node<'a>) -> Read<Arc<Density>> {
        roomy(|| self.whole_density(node))
    }

    fn whole_density(&mut self, node: Node<'a>) -> Read<Arc<Density>> {
        let mut items = Items::of(node);
        let mut density = Density::Solid(Color::rgb(1.0, 1.0, 1.0));
        if let Some(name) = items.optional(Rule::identifier) {
            let pick = |v: &Value| if let Value::Density(d) = v { Some(Arc::clone(d)) } else { None };
            let known = self.known(&name, "density", pick)?;
            if items.peek().is_none() {
                return Ok(known);
            }
            density = (*known).clone();
        } else if let Some(color) = items.optional(Rule::color) {
            density = Density::Solid(super::tree::color(color)?);
        } else if let Some(pattern) = items.optional(Rule::pattern) {
            let (pattern, list) = self.pattern(pattern)?;
            density = self.pattern_of_densities(pattern, list)?;
        }
        for item in items {
            self.density_modifier(item, &mut density)?;
        }
        Ok(Arc::new(density))
    }

    fn pattern_of_densities(&mut self, pattern: Pattern, list: Option<Node<'a>>) -> Read<Density> {
        let Some(list) = list else { return Ok(Density::Colors(pattern, Blend::Default)) };
        self.check_items(&list, &pattern.kind, Rule::density)?;
        let list = list.into_inner().map(|item| self.density(item)).collect::<Read<_>>()?;
        Ok(Density::Densities(pattern, Blend::List(list)))
    }

    fn density_modifier(&mut self, node: Node<'a>, density: &mut Density) -> Read<()> {
        let rule = node.as_rule();
        let (Density::Colors(pattern, _) | Density::Densities(pattern, _)) = density else {
            return match rule {
                Rule::transform => Ok(()),
                _ => wrong(&node, "a plain density has no pattern that this could change"),
            };
        };
        match rule {
            Rule::color_map => {
                let pattern = std::mem::take(pattern);
                *density = Density::Colors(pattern, Arc::unwrap_or_clone(self.color_map(node)?));
            }
            Rule::density_map => {
                let pattern = std::mem::take(pattern);
                let mut entries = Vec::new();
                for entry in node.into_inner() {
                    let mut inner = Items::of(entry);
                    let value = inner.float()?;
                    let content = inner.node()?;
                    entries.push(MapEntry { value, item: self.density_content(content)? });
                }
                let map = blend(entries, &pattern);
                *density = Density::Densities(pattern, map);
            }
            _ => self.pattern_modifier(node, pattern)?,
        }
        Ok(())
    }
}

/// The pattern of a pigment that gets a map.
fn pattern_for_map(node: &Node<'_>, pigment: &mut Pigment) -> Read<Box<Pattern>> {
    match &mut pigment.kind {
        PigmentKind::Colors(pattern, _) | PigmentKind::Pigments(pattern, _) => Ok(std::mem::take(pattern)),
        PigmentKind::Solid(_) | PigmentKind::Image(..) => {
            wrong(node, "a map needs a pattern that runs from 0 to 1 before it")
        }
    }
}

fn slope_map(node: Node<'_>) -> Read<Vec<MapEntry<[f32; 2]>>> {
    let mut entries = Vec::new();
    for entry in node.into_inner() {
        let mut inner = Items::of(entry);
        let value = inner.float()?;
        let v = inner.vector2()?;
        entries.push(MapEntry { value, item: [v.x as f32, v.y as f32] });
    }
    Ok(entries)
}
