//! Normals.

use super::number::{double, float};
use super::writer::Writer;
use crate::scene::{Blend, MapEntry, Normal, NormalKind, PatternKind};
use crate::stack::roomy;
use std::sync::Arc;

impl Writer<'_> {
    /// `normal { … }`.
    pub(super) fn normal_block(&mut self, normal: &Arc<Normal>) {
        self.open("normal");
        self.normal_content(normal);
        self.close();
    }

    fn normal_content(&mut self, normal: &Arc<Normal>) {
        let name = self.shared(normal, "Normal", false, |w| {
            w.open("normal");
            w.normal_parts(normal);
            w.close();
        });
        match name {
            Some(name) => self.line(name),
            None => roomy(|| self.normal_parts(normal)),
        }
    }

    fn normal_parts(&mut self, normal: &Normal) {
        let Normal { kind, amount, accuracy, no_bump_scale, depth: _, span: _ } = normal;
        let scale = |w: &mut Self| {
            let fresh = Normal::default();
            let mut words = Vec::new();
            if amount.to_bits() != fresh.amount.to_bits() {
                words.push(format!("bump_size {}", float(*amount)));
            }
            if accuracy.to_bits() != fresh.accuracy.to_bits() {
                words.push(format!("accuracy {}", float(*accuracy)));
            }
            if *no_bump_scale {
                words.push("no_bump_scale".to_owned());
            }
            if !words.is_empty() {
                w.line(words.join(" "));
            }
        };
        match kind {
            NormalKind::Pattern(pattern, slopes) => {
                self.pattern(pattern, |_| {});
                scale(self);
                if let Some(slopes) = slopes {
                    self.slope_map(slopes);
                }
            }
            NormalKind::Normals(pattern, map) if matches!(pattern.kind, PatternKind::Uv) => {
                self.line("uv_mapping");
                map.items().take(1).for_each(|inner| self.normal_content(inner));
            }
            NormalKind::Normals(pattern, map) => {
                self.pattern(pattern, |w| {
                    if let Blend::List(list) = map {
                        list.iter().for_each(|inner| w.normal_block(inner));
                    }
                });
                scale(self);
                self.blend("normal_map", map, |w, inner| w.normal_content(inner));
            }
            NormalKind::Facets { pattern, coords, size, metric } => {
                let (coords, size, metric) = (double(*coords), double(*size), double(*metric));
                self.line(format_args!("facets coords {coords} size {size} metric {metric}"));
                self.pattern(pattern, |_| {});
                scale(self);
            }
            NormalKind::BumpMap(pattern, image) => {
                self.image_block("bump_map", &image.0, &image.1);
                self.pattern(pattern, |_| {});
                scale(self);
            }
        }
    }

    fn slope_map(&mut self, slopes: &[MapEntry<[f32; 2]>]) {
        self.open("slope_map");
        for MapEntry { value, item: [height, slope] } in slopes {
            self.line(format_args!("[{} <{}, {}>]", float(*value), float(*height), float(*slope)));
        }
        self.close();
    }
}
