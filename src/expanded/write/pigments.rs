//! Pigments and densities: colours in patterns.

use super::number::{color, float};
use super::writer::Writer;
use crate::math::Color;
use crate::scene::{Blend, Density, ImageMap, MapEntry, PatternKind, Pigment, PigmentKind, RarePigment};
use crate::stack::roomy;
use std::sync::Arc;

impl Writer<'_> {
    /// The inside of a pigment, or its name.
    pub(super) fn pigment_content(&mut self, pigment: &Arc<Pigment>) {
        let name = self.shared(pigment, "Pigment", false, |w| {
            w.open("pigment");
            w.pigment_parts(pigment);
            w.close();
        });
        match name {
            Some(name) => self.line(name),
            None => roomy(|| self.pigment_parts(pigment)),
        }
    }

    /// The inside of a pigment.
    pub(super) fn pigment_parts(&mut self, pigment: &Pigment) {
        let Pigment { kind, rare, depth: _, span: _ } = pigment;
        match kind {
            PigmentKind::Solid(shown) => self.line(color(*shown)),
            // A map of colours written over `uv_mapping` shows its first one everywhere.
            PigmentKind::Colors(pattern, colors) if matches!(pattern.kind, PatternKind::Uv) => {
                self.line(color(colors.items().next().copied().unwrap_or(Color::BLACK)));
            }
            PigmentKind::Colors(pattern, colors) => {
                self.pattern(pattern, |w| w.color_list(colors));
                self.shared_colors(colors);
            }
            PigmentKind::Pigments(pattern, map) if matches!(pattern.kind, PatternKind::Uv) => {
                // All that follows is of the inner one; what moves the whole has no effect.
                self.line("uv_mapping");
                map.items().take(1).for_each(|inner| self.pigment_content(inner));
            }
            PigmentKind::Pigments(pattern, map) => {
                self.pattern(pattern, |w| {
                    if let Blend::List(list) = &**map {
                        list.iter().for_each(|inner| w.inner_pigment(inner));
                    }
                });
                self.shared_pigments(map);
            }
            PigmentKind::Image(pattern, map) => {
                self.image_map(map);
                self.pattern(pattern, |_| {});
            }
        }
        // What a pattern written over this one would take over is for declarations, which are gone.
        if let Some(RarePigment { quick_color: Some(quick), pattern: _, map: _ }) = rare.as_deref() {
            self.line(format_args!("quick_color {}", color(*quick)));
        }
    }

    pub(super) fn inner_pigment(&mut self, pigment: &Arc<Pigment>) {
        self.open("pigment");
        self.pigment_content(pigment);
        self.close();
    }

    /// Colours of a block pattern.
    pub(super) fn color_list(&mut self, colors: &Blend<Color>) {
        if let Blend::List(list) = colors {
            let list: Vec<String> = list.iter().map(|item| color(*item)).collect();
            self.line(list.join(", "));
        }
    }

    fn shared_colors(&mut self, colors: &Arc<Blend<Color>>) {
        if let Blend::Map(entries) | Blend::Average(entries) = &**colors {
            match self.shared(colors, "Color_Map", false, |w| w.color_map(entries)) {
                Some(name) => self.block("color_map", name),
                None => self.color_map(entries),
            }
        }
    }

    /// `color_map { … }`.
    pub(super) fn color_map(&mut self, entries: &[MapEntry<Color>]) {
        self.open("color_map");
        for MapEntry { value, item } in entries {
            self.line(format_args!("[{} {}]", float(*value), color(*item)));
        }
        self.close();
    }

    fn shared_pigments(&mut self, map: &Arc<Blend<Arc<Pigment>>>) {
        let average = matches!(&**map, Blend::Average(_));
        let write = |w: &mut Self| w.blend("pigment_map", map, |w, pigment| w.pigment_content(pigment));
        if average || matches!(&**map, Blend::Default | Blend::List(_)) {
            return write(self);
        }
        match self.shared(map, "Pigment_Map", false, write) {
            Some(name) => self.block("pigment_map", name),
            None => write(self),
        }
    }

    fn image_map(&mut self, map: &ImageMap) {
        let ImageMap { image, mapping, palette_filter, palette_transmit, filter_all, transmit_all } = map;
        self.open("image_map");
        self.image(image);
        self.mapping(mapping);
        let lists = [("filter", palette_filter, filter_all), ("transmit", palette_transmit, transmit_all)];
        for (word, entries, all) in lists {
            if let Some(value) = all {
                self.line(format_args!("{word} all {}", float(*value)));
            }
            for (index, value) in entries {
                self.line(format_args!("{word} {index}, {}", float(*value)));
            }
        }
        self.close();
    }

    /// `density { … }`.
    pub(super) fn density_block(&mut self, density: &Arc<Density>) {
        self.open("density");
        self.density_content(density);
        self.close();
    }

    fn density_content(&mut self, density: &Arc<Density>) {
        let name = self.shared(density, "Density", false, |w| {
            w.open("density");
            w.density_parts(density);
            w.close();
        });
        match name {
            Some(name) => self.line(name),
            None => roomy(|| self.density_parts(density)),
        }
    }

    fn density_parts(&mut self, density: &Density) {
        match density {
            Density::Solid(shown) => self.line(color(*shown)),
            Density::Colors(pattern, colors) => {
                self.pattern(pattern, |w| w.color_list(colors));
                if let Blend::Map(entries) | Blend::Average(entries) = colors {
                    self.color_map(entries);
                }
            }
            Density::Densities(pattern, map) => {
                self.pattern(pattern, |w| {
                    if let Blend::List(list) = map {
                        list.iter().for_each(|inner| w.density_block(inner));
                    }
                });
                self.blend("density_map", map, |w, inner| w.density_content(inner));
            }
        }
    }
}
