//! `[value item]` lists: colour, pigment, normal, slope, texture and density maps.

use super::table::Word;
use crate::diag::SourceResult;
use crate::eval::colors::is_color_word;
use crate::eval::{Evaluator, Value};
use crate::math::Color;
use crate::scene::{Blend, Density, MapEntry, Normal, PatternKind, Pigment, Texture};
use std::sync::Arc;

/// As POV-Ray has it.
const MAX_ENTRIES: usize = 256;

/// Whether entry values are weights that may be left out.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Values {
    Positions,
    Weights,
}

impl Evaluator<'_> {
    /// Refuses the map whose word stands there where the pattern takes a list instead or, but for maps that can be
    /// averaged, is an average.
    pub(super) fn check_map(&self, kind: &PatternKind, Word { word, span }: Word, averages: bool) -> SourceResult<()> {
        let hint = match kind {
            PatternKind::Average if !averages => "average takes a pigment_map, normal_map, texture_map or density_map",
            PatternKind::Average => return Ok(()),
            kind if kind.n_blocks().is_some() => "its items stand behind the pattern's name, without a map",
            _ => return Ok(()),
        };
        self.error_with_hint(span, format!("this pattern takes no {}", word.word()), hint)
    }

    /// `{ IDENTIFIER }` or `{ [v item] … }`, after the keyword.
    ///
    /// `pick` recognises a map identifier; `item` reads what stands after the value and pushes it.
    fn map<T>(
        &mut self,
        what: &str,
        values: Values,
        pick: impl Fn(&Value) -> Option<Vec<MapEntry<T>>>,
        mut item: impl FnMut(&mut Self, f32, &mut Vec<MapEntry<T>>) -> SourceResult<()>,
    ) -> SourceResult<Vec<MapEntry<T>>> {
        self.open(what)?;
        if let Some(entries) = self.take_declared(pick)? {
            self.close(what)?;
            return Ok(entries);
        }
        let mut entries = Vec::new();
        while self.accept_punct('[')? {
            let weightless = values == Values::Weights && !self.starts_expression()?;
            let value = if weightless { 1.0 } else { self.float()? as f32 };
            self.comma()?;
            item(self, value, &mut entries)?;
            self.expect_punct(']', format_args!("to end an entry of the {what}"))?;
            self.comma()?;
        }
        let span = self.span();
        if entries.is_empty() {
            return self.expected(&format!("an entry of the {what}, as in '[0.5 …]'"));
        }
        if entries.len() > MAX_ENTRIES {
            return self
                .error(span, format!("a {what} has at most {MAX_ENTRIES} entries, this one has {}", entries.len()));
        }
        self.close(what)?;
        Ok(entries)
    }

    /// A map of which each entry is one item, or the weighted items of an average.
    fn blend_map<T>(
        &mut self,
        what: &str,
        average: bool,
        pick: impl Fn(&Value) -> Option<Vec<MapEntry<T>>>,
        mut item: impl FnMut(&mut Self) -> SourceResult<T>,
    ) -> SourceResult<Blend<T>> {
        let values = if average { Values::Weights } else { Values::Positions };
        let entries = self.map(what, values, pick, |e, value, entries| {
            let item = item(e)?;
            entries.push(MapEntry { value, item });
            Ok(())
        })?;
        Ok(if average { Blend::Average(entries) } else { Blend::Map(entries) })
    }

    /// `color_map`, after the word: entries, or the old form with two colours an entry.
    pub(super) fn color_map(&mut self) -> SourceResult<Vec<MapEntry<Color>>> {
        let pick = |v: &Value| if let Value::ColorMap(m) = v { Some(m.to_vec()) } else { None };
        self.map("color_map", Values::Positions, pick, |e, value, entries| {
            if e.at_color()? {
                entries.push(MapEntry { value, item: e.color()? });
                return Ok(());
            }
            let end = e.float()? as f32;
            e.comma()?;
            entries.push(MapEntry { value, item: e.color()? });
            e.comma()?;
            entries.push(MapEntry { value: end, item: e.color()? });
            Ok(())
        })
    }

    /// Whether a colour comes next that is not a bare number: a colour word, a vector or the name of one.
    pub(super) fn at_color(&mut self) -> SourceResult<bool> {
        Ok(match self.keyword()? {
            Some(keyword) => is_color_word(keyword),
            None => match self.declared()? {
                Some(Value::Vector(number)) => number.n >= 3,
                Some(Value::Array(array)) => matches!(array.sample(), Some(Value::Vector(n)) if n.n >= 3),
                Some(Value::Function(function)) => function.width() >= 3,
                Some(_) => false,
                None => self.at_vector()?,
            },
        })
    }

    /// `slope_map`, after the word: heights and slopes.
    pub(super) fn slope_map(&mut self) -> SourceResult<Vec<MapEntry<[f32; 2]>>> {
        let pick = |v: &Value| if let Value::SlopeMap(m) = v { Some(m.to_vec()) } else { None };
        self.map("slope_map", Values::Positions, pick, |e, value, entries| {
            let v = e.vector2()?;
            entries.push(MapEntry { value, item: [v.x as f32, v.y as f32] });
            Ok(())
        })
    }

    /// `pigment_map`, after the word.
    pub(super) fn pigment_map(&mut self, average: bool) -> SourceResult<Blend<Arc<Pigment>>> {
        let pick = |v: &Value| if let Value::PigmentMap(m) = v { Some(m.to_vec()) } else { None };
        self.blend_map("pigment_map", average, pick, |e| {
            let start = (*e.defaults.layer.pigment).clone();
            Ok(Arc::new(e.pigment_items(start)?))
        })
    }

    /// `normal_map`, after the word.
    pub(super) fn normal_map(&mut self, average: bool) -> SourceResult<Blend<Arc<Normal>>> {
        let pick = |v: &Value| if let Value::NormalMap(m) = v { Some(m.to_vec()) } else { None };
        self.blend_map("normal_map", average, pick, |e| {
            let start = e.defaults.layer.normal.clone();
            e.normal_items(start)
        })
    }

    /// `texture_map`, after the word.
    pub(super) fn texture_map(&mut self, average: bool) -> SourceResult<Blend<Arc<Texture>>> {
        let pick = |v: &Value| if let Value::TextureMap(m) = v { Some(m.to_vec()) } else { None };
        self.blend_map("texture_map", average, pick, |e| e.texture_items())
    }

    /// `density_map`, after the word; identifiers are not accepted in it, as in POV-Ray.
    pub(super) fn density_map(&mut self, average: bool) -> SourceResult<Blend<Arc<Density>>> {
        let pick = |v: &Value| if let Value::DensityMap(m) = v { Some(m.to_vec()) } else { None };
        self.blend_map("density_map", average, pick, |e| Ok(Arc::new(e.density_items()?)))
    }
}
