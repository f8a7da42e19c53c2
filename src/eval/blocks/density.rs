//! `density { … }`: where how much of a media is.

use super::colors::COLORS;
use super::pattern::{PATTERNS, no_list};
use super::pattern_modifiers::{MODIFIERS, OF_KINDS, TURBULENCE};
use super::table::{Block, Item, Takes};
use crate::diag::SourceResult;
use crate::eval::{Evaluator, Value};
use crate::math::Color;
use crate::scene::{Blend, Density, Pattern, PatternKind};
use crate::stack::roomy;
use crate::syntax::Keyword as K;
use std::sync::Arc;

pub(super) static DENSITY: Block<Density> = Block::<Density>::new(
    "density",
    "where how much of a media is",
    &[
        Item::spelt(
            K::ColourMap,
            K::ColorMap,
            Takes::Other("{ [FLOAT COLOUR] … }", |e, density, _| {
                let map = Blend::Map(e.color_map()?);
                *density = Density::Colors(density_pattern(density), map);
                Ok(())
            }),
            "",
            "how much is where in the pattern",
        ),
        Item::new(
            K::DensityMap,
            Takes::Other("{ [FLOAT DENSITY] … }", |e, density, _| {
                let pattern = density_pattern(density);
                let map = e.density_map(matches!(pattern.kind, PatternKind::Average))?;
                *density = Density::Densities(pattern, map);
                Ok(())
            }),
            "",
            "which density is where in the pattern",
        ),
    ],
)
.with(&[&COLORS, &PATTERNS, &MODIFIERS, &TURBULENCE, &OF_KINDS]);

impl Evaluator<'_> {
    /// `{ … }` after `density`.
    pub(super) fn density_block(&mut self) -> SourceResult<Density> {
        self.open("density")?;
        let density = self.density_items()?;
        self.close_of(&DENSITY)?;
        Ok(density)
    }

    /// The inside of a density, also of a `density_map` entry.
    pub(super) fn density_items(&mut self) -> SourceResult<Density> {
        roomy(|| self.whole_density())
    }

    fn whole_density(&mut self) -> SourceResult<Density> {
        let pick = |v: &Value| if let Value::Density(d) = v { Some((**d).clone()) } else { None };
        let mut density = self.take_declared(pick)?.unwrap_or(Density::Solid(Color::rgb(1.0, 1.0, 1.0)));
        while self.density_item(&mut density)? {}
        Ok(density)
    }

    fn density_item(&mut self, density: &mut Density) -> SourceResult<bool> {
        self.comma()?;
        if self.item_of(&DENSITY, density)? {
            return Ok(true);
        }
        let mut pattern = density_pattern(density);
        let mut list = Vec::new();
        let mut read_list = |e: &mut Evaluator, n: usize| {
            e.comma()?;
            while list.len() < n && e.accept(K::Density)? {
                list.push(Arc::new(e.density_block()?));
                e.comma()?;
            }
            no_list(e, n)
        };
        if self.pattern_keyword(&mut pattern, &mut read_list)? {
            *density = match density {
                _ if !list.is_empty() => Density::Densities(pattern, Blend::List(list)),
                Density::Colors(_, map) => Density::Colors(pattern, map.clone()),
                _ => Density::Colors(pattern, Blend::Default),
            };
            return Ok(true);
        }
        if self.starts_color()? {
            *density = Density::Solid(self.color()?);
            return Ok(true);
        }
        let more = self.pattern_modifier(&mut pattern)?;
        if more {
            match density {
                Density::Solid(_) => {}
                Density::Colors(p, _) | Density::Densities(p, _) => *p = pattern,
            }
        }
        Ok(more)
    }
}

fn density_pattern(density: &Density) -> Pattern {
    match density {
        Density::Solid(_) => Pattern::new(PatternKind::None),
        Density::Colors(pattern, _) | Density::Densities(pattern, _) => pattern.clone(),
    }
}
