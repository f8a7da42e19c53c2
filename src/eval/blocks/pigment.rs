//! `pigment { … }`.

use super::colors::COLORS;
use super::image::MAPPING;
use super::pattern::PATTERNS;
use super::pattern_modifiers::{MODIFIERS, OF_KINDS, TURBULENCE};
use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Span};
use crate::eval::{Evaluator, Value};
use crate::math::Color;
use crate::scene::{
    Blend, ImageMap, MapEntry, MapType, Pattern, PatternKind, Pigment, PigmentKind, PigmentMap, RarePigment,
    default_colors,
};
use crate::stack::roomy;
use crate::syntax::Keyword as K;
use std::sync::Arc;

/// A pigment while it is being read: what is written changes one part and keeps the rest.
pub(super) struct Draft {
    pattern: Pattern,
    content: Content,
    /// The map under a plain colour or a picture.
    map: Option<PigmentMap>,
    quick_color: Option<Color>,
}

enum Content {
    Solid(Color),
    Map(PigmentMap),
    Image(Arc<ImageMap>),
}

impl Draft {
    fn new(pigment: Pigment) -> Self {
        let rare = pigment.rare.map(|rare| *rare).unwrap_or_default();
        let plain = || Pattern::new(PatternKind::None);
        let (pattern, content) = match pigment.kind {
            PigmentKind::Solid(color) => (rare.pattern.unwrap_or_else(plain), Content::Solid(color)),
            PigmentKind::Colors(pattern, colors) => (*pattern, Content::Map(PigmentMap::Colors(colors))),
            PigmentKind::Pigments(pattern, pigments) => (*pattern, Content::Map(PigmentMap::Pigments(pigments))),
            PigmentKind::Image(pattern, image) => (*pattern, Content::Image(image)),
        };
        Self { pattern, content, map: rare.map, quick_color: rare.quick_color }
    }

    fn finish(self, span: Span) -> Pigment {
        let mut rare = RarePigment { quick_color: self.quick_color, pattern: None, map: self.map };
        let kind = match self.content {
            Content::Solid(color) => {
                rare.pattern = self.pattern.is_modified().then_some(self.pattern);
                PigmentKind::Solid(color)
            }
            Content::Map(PigmentMap::Colors(colors)) => PigmentKind::Colors(self.pattern.into(), colors),
            Content::Map(PigmentMap::Pigments(pigments)) => PigmentKind::Pigments(self.pattern.into(), pigments),
            Content::Image(image) => PigmentKind::Image(self.pattern.into(), image),
        };
        let any = rare.quick_color.is_some() || rare.pattern.is_some() || rare.map.is_some();
        Pigment { kind, rare: any.then(|| rare.into()), depth: 0, span }
    }

    /// After a pattern keyword with the items of a block pattern, if there are some.
    ///
    /// A block pattern without items shows its own colours. Others go on with the entries that are there, whatever
    /// pattern they were written for: items of a block pattern stand at 0, 1, 2 and so on, as in POV-Ray.
    fn adopt_pattern(&mut self, list: Option<PigmentMap>) {
        let block = self.pattern.kind.n_blocks().is_some();
        let average = matches!(self.pattern.kind, PatternKind::Average);
        let hidden = self.map.take();
        let old = match std::mem::replace(&mut self.content, Content::Solid(Color::BLACK)) {
            _ if list.is_some() => list,
            _ if block => Some(PigmentMap::colors(Blend::List(Vec::new()))),
            Content::Map(map) => Some(map),
            Content::Solid(_) | Content::Image(_) => hidden,
        };
        self.content = Content::Map(match old.unwrap_or_else(|| PigmentMap::colors(Blend::Default)) {
            PigmentMap::Colors(colors) if block && matches!(*colors, Blend::List(_)) => {
                let mut colors = entries(Arc::unwrap_or_clone(colors)).unwrap_or_default();
                let have = colors.len();
                colors.extend(default_colors(&self.pattern.kind).into_iter().skip(have));
                PigmentMap::colors(Blend::List(colors.into_iter().map(|entry| entry.item).collect()))
            }
            listed if block => listed,
            PigmentMap::Colors(colors) if matches!(*colors, Blend::Map(_)) => PigmentMap::Colors(colors),
            PigmentMap::Colors(colors) => {
                PigmentMap::colors(entries(Arc::unwrap_or_clone(colors)).map_or(Blend::Default, Blend::Map))
            }
            PigmentMap::Pigments(pigments) if !average && matches!(*pigments, Blend::Map(_)) => {
                PigmentMap::Pigments(pigments)
            }
            PigmentMap::Pigments(pigments) => match entries(Arc::unwrap_or_clone(pigments)) {
                Some(entries) if average => PigmentMap::pigments(Blend::Average(entries)),
                Some(entries) => PigmentMap::pigments(Blend::Map(entries)),
                None => PigmentMap::colors(Blend::Default),
            },
        });
    }

    /// Shows a plain colour or a picture; the map that it hides stays for a pattern written after it.
    fn hide_map(&mut self, shown: Content) {
        if let Content::Map(map) = std::mem::replace(&mut self.content, shown) {
            self.map = Some(map);
        }
        self.pattern.kind = PatternKind::None;
    }
}

impl PigmentMap {
    fn colors(colors: Blend<Color>) -> Self {
        Self::Colors(Arc::new(colors))
    }

    fn pigments(pigments: Blend<Arc<Pigment>>) -> Self {
        Self::Pigments(Arc::new(pigments))
    }
}

/// The entries of a map, list or average, if they were written.
fn entries<T>(blend: Blend<T>) -> Option<Vec<MapEntry<T>>> {
    match blend {
        Blend::Default => None,
        Blend::Map(entries) | Blend::Average(entries) => Some(entries),
        Blend::List(items) => {
            Some(items.into_iter().enumerate().map(|(i, item)| MapEntry { value: i as f32, item }).collect())
        }
    }
}

pub(super) static PIGMENT: Block<Draft> = Block::<Draft>::new(
    "pigment",
    "colours of a surface",
    &[
        Item::spelt(
            K::ColourMap,
            K::ColorMap,
            Takes::Other("{ [FLOAT COLOUR] … }", |e, draft, at| {
                e.check_pigment_map(draft, at, false)?;
                draft.content = Content::Map(PigmentMap::colors(Blend::Map(e.color_map()?)));
                Ok(())
            }),
            "",
            "which colour is where in the pattern",
        ),
        Item::new(
            K::PigmentMap,
            Takes::Other("{ [FLOAT PIGMENT] … }", |e, draft, at| {
                e.check_pigment_map(draft, at, true)?;
                let average = matches!(draft.pattern.kind, PatternKind::Average);
                draft.content = Content::Map(PigmentMap::pigments(e.pigment_map(average)?));
                Ok(())
            }),
            "",
            "which pigment is where in the pattern",
        ),
        Item::new(
            K::ImageMap,
            Takes::Other("{ IMAGE … }", |e, draft, _| {
                let image = Content::Image(Arc::new(e.image_map()?));
                draft.hide_map(image);
                Ok(())
            }),
            "",
            "a picture",
        ),
        Item::since(
            350,
            K::UvMapping,
            Takes::Other("", |e, draft, _| {
                // All that follows is of another pigment, which starts from the `#default` one (measured).
                let inner = e.pigment_items((*e.defaults.layer.pigment).clone())?;
                let map = Blend::Map(vec![MapEntry { value: 0.0, item: Arc::new(inner) }]);
                draft.content = Content::Map(PigmentMap::pigments(map));
                draft.pattern.kind = PatternKind::Uv;
                Ok(())
            }),
            "",
            "what follows lies on the surface by its own coordinates",
        ),
        Item::spelt(
            K::QuickColour,
            K::QuickColor,
            Takes::Other("COLOUR", |e, draft, _| {
                draft.quick_color = Some(e.color()?);
                Ok(())
            }),
            "",
            "its colour at low quality",
        ),
    ],
)
.with(&[&COLORS, &PATTERNS, &MODIFIERS, &TURBULENCE, &OF_KINDS]);

pub(super) static IMAGE_MAP: Block<ImageMap> = Block::<ImageMap>::new(
    "image_map",
    "a picture as a pigment",
    &[
        Item::new(
            K::Filter,
            Takes::Other("all FLOAT | NUMBER, FLOAT", transparency),
            "",
            "filter of all colours, or of one by its number",
        ),
        Item::new(
            K::Transmit,
            Takes::Other("all FLOAT | NUMBER, FLOAT", transparency),
            "",
            "transmit of all colours, or of one by its number",
        ),
        // Unlike its kin, it refuses projections that it does not know.
        Item::new(
            K::MapType,
            Takes::Other("INTEGER", |e, map, _| {
                let span = e.span();
                map.mapping.map_type = match e.integer()? {
                    0 => MapType::Planar,
                    1 => MapType::Spherical,
                    2 => MapType::Cylindrical,
                    5 => MapType::Torus,
                    n => return e.error(span, format!("there is no map_type {n}; use 0, 1, 2 or 5")),
                };
                Ok(())
            }),
            "0",
            "0 flat, 1 around a sphere, 2 around a cylinder, 5 around a torus",
        ),
    ],
)
.with(&[&MAPPING]);

impl Evaluator<'_> {
    /// `{ … }` after `pigment`, starting from `start`.
    pub(super) fn pigment_block(&mut self, start: Pigment) -> SourceResult<Pigment> {
        self.open("pigment")?;
        let pigment = self.pigment_items(start)?;
        self.close_of(&PIGMENT)?;
        Ok(pigment)
    }

    /// The inside of a pigment, also of a `pigment_map` entry.
    pub(super) fn pigment_items(&mut self, start: Pigment) -> SourceResult<Pigment> {
        roomy(|| self.whole_pigment(start))
    }

    fn whole_pigment(&mut self, start: Pigment) -> SourceResult<Pigment> {
        let span = self.peek()?.span;
        let mut draft = Draft::new(start);
        let pick = |v: &Value| if let Value::Pigment(p) = v { Some(p.clone()) } else { None };
        if let Some(pigment) = self.take_declared(pick)? {
            draft = Draft::new((*pigment).clone());
        }
        while self.pigment_item(&mut draft)? {}
        let mut pigment = draft.finish(span);
        pigment.depth = self.within(self.budget.levels(pigment.depth_of_parts()), span)?;
        Ok(pigment)
    }

    fn pigment_item(&mut self, draft: &mut Draft) -> SourceResult<bool> {
        if self.item_of(&PIGMENT, draft)? {
            return Ok(true);
        }
        let mut list = None;
        let mut read_list = |e: &mut Evaluator, n: usize| {
            list = e.pigment_list(n)?;
            Ok(())
        };
        if self.pattern_keyword(&mut draft.pattern, &mut read_list)? {
            draft.adopt_pattern(list);
            return Ok(true);
        }
        if self.starts_color()? {
            let color = Content::Solid(self.color()?);
            draft.hide_map(color);
            return Ok(true);
        }
        self.pattern_modifier(&mut draft.pattern)
    }

    fn check_pigment_map(&self, draft: &Draft, at: Word, averages: bool) -> SourceResult<()> {
        if matches!(draft.content, Content::Solid(_) | Content::Image(_)) {
            let what = at.word.word();
            return self.error(at.span, format!("a {what} needs a pattern that runs from 0 to 1 before it"));
        }
        self.check_map(&draft.pattern.kind, at, averages)
    }

    /// The items of a block pattern: all colours or all pigments.
    fn pigment_list(&mut self, n: usize) -> SourceResult<Option<PigmentMap>> {
        self.comma()?;
        if self.keyword()? == Some(K::Pigment) {
            let mut pigments = Vec::new();
            while pigments.len() < n && self.accept(K::Pigment)? {
                let start = (*self.defaults.layer.pigment).clone();
                pigments.push(Arc::new(self.pigment_block(start)?));
                self.comma()?;
            }
            pigments.resize(n, self.defaults.layer.pigment.clone());
            return Ok(Some(PigmentMap::pigments(Blend::List(pigments))));
        }
        let mut colors = Vec::new();
        while colors.len() < n && self.starts_color()? {
            colors.push(self.color()?);
            self.comma()?;
        }
        Ok((!colors.is_empty()).then(|| PigmentMap::colors(Blend::List(colors))))
    }

    /// `image_map { … }`, after the word.
    fn image_map(&mut self) -> SourceResult<ImageMap> {
        self.open("image_map")?;
        let image = self.image()?;
        let mut map = ImageMap {
            image,
            mapping: Default::default(),
            palette_filter: Vec::new(),
            palette_transmit: Vec::new(),
            filter_all: None,
            transmit_all: None,
        };
        loop {
            self.comma()?;
            if !self.item_of(&IMAGE_MAP, &mut map)? && !self.item_of(&MAPPING, &mut map.mapping)? {
                break;
            }
        }
        self.close_of(&IMAGE_MAP)?;
        Ok(map)
    }
}

/// `filter` and `transmit` of a picture: of all its colours, or of one by its number.
fn transparency(e: &mut Evaluator<'_>, map: &mut ImageMap, at: Word) -> SourceResult<()> {
    let filter = at.word == K::Filter;
    if e.accept(K::All)? {
        let value = Some(e.float()? as f32);
        *(if filter { &mut map.filter_all } else { &mut map.transmit_all }) = value;
        return Ok(());
    }
    let index = e.integer()?.clamp(0, i64::from(u32::MAX)) as u32;
    e.comma()?;
    let value = e.float()? as f32;
    (if filter { &mut map.palette_filter } else { &mut map.palette_transmit }).push((index, value));
    Ok(())
}
