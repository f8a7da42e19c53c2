//! Textures, pigments, normals and finishes, each declared once where several things share it.

use super::number::{color, double, float, rgb};
use super::writer::Writer;
use crate::math::Color;
use crate::scene::{
    Blend, Density, Finish, ImageMap, MapEntry, Normal, NormalKind, PatternKind, PatternedTexture, Pigment,
    PigmentKind, PlacedTexture, RarePigment, Texture, TextureLayer,
};
use crate::stack::roomy;
use std::sync::Arc;

impl Writer<'_> {
    /// `texture` or `interior_texture` of an object, with the place where it was put.
    pub(super) fn placed_texture(&mut self, word: &str, placed: &PlacedTexture) {
        let PlacedTexture { texture, place } = placed;
        let moved = !place.transform().is_identity();
        // Where the transformations of a pattern end and those of the place begin, only a name can tell.
        let plain = matches!(&**texture, Texture::Layers(layers) if layers.len() == 1);
        if let Some(name) = self.texture_name(texture, moved && !plain) {
            self.open(word);
            self.line(name);
            self.place(place);
            return self.close();
        }
        match &**texture {
            Texture::Layers(layers) => {
                for layer in layers {
                    self.open(word);
                    self.layer(layer);
                    self.place(place);
                    self.close();
                }
            }
            Texture::Patterned(patterned) => {
                self.open(word);
                self.patterned(patterned);
                self.place(place);
                self.close();
            }
        }
    }

    /// A texture's name, if it has one.
    pub(super) fn texture_name(&mut self, texture: &Arc<Texture>, always: bool) -> Option<String> {
        let always = always || self.textures_ahead;
        self.shared(texture, "Texture", always, |w| w.texture_blocks(texture))
    }

    /// `texture { … }` for each layer.
    pub(super) fn texture_blocks(&mut self, texture: &Texture) {
        match texture {
            Texture::Layers(layers) => {
                for layer in layers {
                    self.open("texture");
                    self.layer(layer);
                    self.close();
                }
            }
            Texture::Patterned(patterned) => {
                self.open("texture");
                self.patterned(patterned);
                self.close();
            }
        }
    }

    /// The inside of a texture within another.
    fn texture_content(&mut self, texture: &Arc<Texture>) {
        let layered = matches!(&**texture, Texture::Layers(layers) if layers.len() != 1);
        if let Some(name) = self.texture_name(texture, layered) {
            return self.line(name);
        }
        match &**texture {
            Texture::Layers(layers) => layers.iter().for_each(|layer| self.layer(layer)),
            Texture::Patterned(patterned) => roomy(|| self.patterned(patterned)),
        }
    }

    /// A texture within another, in its braces.
    pub(super) fn inner_texture(&mut self, texture: &Arc<Texture>) {
        self.open("texture");
        self.texture_content(texture);
        self.close();
    }

    fn layer(&mut self, layer: &TextureLayer) {
        let TextureLayer { pigment, normal, finish, no_bump_scale, unfiltered } = layer;
        self.open("pigment");
        self.pigment_content(pigment);
        self.close();
        if let Some(normal) = normal {
            self.normal_block(normal);
        }
        self.finish(finish);
        if *no_bump_scale {
            self.line("no_bump_scale");
        }
        if *unfiltered {
            self.note("unfiltered");
        }
    }

    fn patterned(&mut self, texture: &PatternedTexture) {
        let PatternedTexture { pattern, map, no_bump_scale, uv_mapping, depth: _, span: _ } = texture;
        if *uv_mapping {
            self.line("uv_mapping");
        }
        if *no_bump_scale {
            self.line("no_bump_scale");
        }
        if let PatternKind::Material(image) = &pattern.kind {
            self.open("material_map");
            self.image(&image.0);
            self.mapping(&image.1);
            map.items().for_each(|texture| self.inner_texture(texture));
            self.close();
            return self.pattern(pattern, |_| {});
        }
        self.pattern(pattern, |w| {
            if let Blend::List(list) = map {
                list.iter().for_each(|texture| w.inner_texture(texture));
            }
        });
        self.blend("texture_map", map, |w, texture| w.texture_content(texture));
    }

    /// A map or an average; lists stand behind their pattern's word, and a pattern's own colours nowhere.
    fn blend<T>(&mut self, word: &str, blend: &Blend<T>, mut item: impl FnMut(&mut Self, &T)) {
        match blend {
            Blend::Default | Blend::List(_) => {}
            Blend::Map(entries) | Blend::Average(entries) => {
                self.open(word);
                for MapEntry { value, item: content } in entries {
                    self.open_entry(*value);
                    item(self, content);
                    self.close_with("]");
                }
                self.close();
            }
        }
    }

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

    fn inner_pigment(&mut self, pigment: &Arc<Pigment>) {
        self.open("pigment");
        self.pigment_content(pigment);
        self.close();
    }

    /// Colours of a block pattern.
    fn color_list(&mut self, colors: &Blend<Color>) {
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

    /// `finish { … }`, as far as it is not the default one.
    fn finish(&mut self, finish: &Arc<Finish>) {
        if **finish == Finish::default() {
            return;
        }
        let write = |w: &mut Self| {
            w.open("finish");
            w.finish_terms(finish);
            w.close();
        };
        match self.shared(finish, "Finish", false, write) {
            Some(name) => self.block("finish", name),
            None => write(self),
        }
    }

    fn finish_terms(&mut self, finish: &Finish) {
        let Finish {
            ambient,
            emission,
            diffuse,
            diffuse_back,
            raw_diffuse,
            brilliance,
            crand,
            phong,
            phong_size,
            specular,
            specular_exponent,
            metallic,
            irid_amount,
            irid_thickness,
            irid_turbulence,
            reflection_min,
            reflection_max,
            reflection_fresnel: _,
            reflection_falloff: _,
            reflection_exponent,
            reflection_metallic: _,
            conserve_energy,
            subsurface_translucency,
            ior,
            caustics,
            refraction,
        } = finish;
        let plain = Finish::default();
        if *ambient != plain.ambient {
            self.line(format_args!("ambient {}", rgb(*ambient)));
        }
        if *emission != plain.emission {
            self.line(format_args!("emission {}", rgb(*emission)));
        }
        self.diffuse([*diffuse, *diffuse_back], *raw_diffuse, *brilliance);
        let numbers = [
            ("brilliance", *brilliance, plain.brilliance),
            ("crand", *crand, plain.crand),
            ("phong", *phong, plain.phong),
            ("phong_size", *phong_size, plain.phong_size),
            ("specular", *specular, plain.specular),
            ("metallic", *metallic, plain.metallic),
            ("reflection_exponent", *reflection_exponent, plain.reflection_exponent),
        ];
        let mut words: Vec<String> = numbers
            .into_iter()
            .filter(|(_, value, default)| value.to_bits() != default.to_bits())
            .map(|(word, value, _)| format!("{word} {}", float(value)))
            .collect();
        if *specular_exponent != plain.specular_exponent {
            words.push(format!("roughness {}", roughness(*specular_exponent)));
        }
        if *conserve_energy {
            words.push("conserve_energy".to_owned());
        }
        for (word, value) in [("ior", ior), ("caustics", caustics), ("refraction", refraction)] {
            words.extend(value.map(|value| format!("{word} {}", float(value))));
        }
        if !words.is_empty() {
            self.line(words.join(" "));
        }
        if [*irid_amount, *irid_thickness, *irid_turbulence] != [0.0; 3] {
            let [amount, thickness, turbulence] = [irid_amount, irid_thickness, irid_turbulence].map(|v| float(*v));
            self.line(format_args!("irid {{ {amount} thickness {thickness} turbulence {turbulence} }}"));
        }
        self.reflection(finish, [*reflection_min, *reflection_max].map(rgb), plain);
        if let Some(translucency) = subsurface_translucency {
            self.line(format_args!("subsurface {{ translucency {} }}", rgb(*translucency)));
        }
    }

    /// `diffuse`, with `albedo` where that alone explains what stands beside it.
    fn diffuse(&mut self, [front, back]: [f32; 2], raw: f32, brilliance: f32) {
        let plain = Finish::default();
        if front == raw {
            if [front, back] != [plain.diffuse, plain.diffuse_back] {
                self.line(format_args!("diffuse {}, {}", float(front), float(back)));
            }
            return;
        }
        let scale = (brilliance + 1.0) / 2.0;
        let near = back / scale;
        let raw_back = [near, near.next_up(), near.next_down()].into_iter().find(|v| *v * scale == back);
        match raw_back.filter(|_| raw * scale == front) {
            Some(raw_back) => self.line(format_args!("diffuse albedo {}, {}", float(raw), float(raw_back))),
            None => {
                self.line(format_args!("diffuse {}, {}", float(front), float(back)));
                self.note(format_args!("raw_diffuse {}", float(raw)));
            }
        }
    }

    fn reflection(&mut self, finish: &Finish, [min, max]: [String; 2], plain: Finish) {
        let same = finish.reflection_min == plain.reflection_min
            && finish.reflection_max == plain.reflection_max
            && finish.reflection_fresnel == plain.reflection_fresnel
            && finish.reflection_falloff == plain.reflection_falloff
            && finish.reflection_metallic == plain.reflection_metallic;
        if same {
            return;
        }
        let mut text = format!("reflection {{ {min}, {max}");
        if finish.reflection_fresnel {
            text += " fresnel";
        }
        let (falloff, metallic) = (finish.reflection_falloff, finish.reflection_metallic);
        if falloff != plain.reflection_falloff {
            text += &format!(" falloff {}", float(falloff));
        }
        if metallic != plain.reflection_metallic {
            text += &format!(" metallic {}", float(metallic));
        }
        self.line(text + " }");
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

    /// `[value …`, an entry of a map.
    fn open_entry(&mut self, value: f32) {
        self.open_with(format_args!("[{}", float(value)));
    }
}

/// The roughness from which the exponent of a highlight comes: one of few digits, if there is one.
fn roughness(exponent: f32) -> String {
    if exponent == 0.0 {
        return "0".to_owned();
    }
    let exact = 1.0 / f64::from(exponent);
    let short = float(exact as f32);
    let fits = short.parse::<f64>().is_ok_and(|roughness| (1.0 / roughness) as f32 == exponent);
    if fits { short } else { double(exact) }
}
