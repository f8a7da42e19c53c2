//! Objects: what is shared, what they are made of, and all that is said about them.

use super::number::{double, float};
use super::patterns::switch;
use super::writer::Writer;
use crate::scene::{CsgOperation, Flags, Object, PhotonFlags, RareParts, Shape};
use crate::stack::roomy;
use std::sync::Arc;

impl Writer<'_> {
    /// An object within another: by its name, if several share it.
    pub(super) fn object(&mut self, object: &Arc<Object>) {
        match self.shared(object, "Object", false, |w| w.object_block(object)) {
            Some(name) => self.block("object", name),
            None => roomy(|| self.object_block(object)),
        }
    }

    /// A whole object.
    pub(super) fn object_block(&mut self, object: &Object) {
        self.whole_object(object, |_| {});
    }

    /// The same with more at its end.
    pub(super) fn whole_object(&mut self, object: &Object, end: impl FnOnce(&mut Self)) {
        let Object { shape, place, texture, interior, rare, flags, span, name, depth: _, is_patch: _ } = object;
        self.origin(*span);
        match self.shape_name(shape) {
            Some(known) => {
                self.open("object");
                self.line(known);
            }
            None => {
                self.open(shape_word(shape));
                self.shape_parts(shape);
            }
        }
        if let Some(name) = name {
            self.note(format_args!("name {name}"));
        }
        // Lights stand where their location is: it has moved with them.
        if !matches!(shape, Shape::LightSource(_)) {
            self.place(place);
        }
        if flags.uv_mapping {
            self.line("uv_mapping");
        }
        if let Some(texture) = texture {
            self.placed_texture("texture", texture);
        }
        if let Some(texture) = &rare.interior_texture {
            self.placed_texture("interior_texture", texture);
        }
        if let Some(interior) = interior {
            self.interior(interior);
        }
        self.flags(flags);
        self.rare(rare, flags);
        end(self);
        self.close();
    }

    /// The name of a shape that several objects share: of groups and of what is large.
    fn shape_name(&mut self, shape: &Shape) -> Option<String> {
        macro_rules! shared {
            ($thing:expr, $sort:expr) => {
                self.shared($thing, $sort, false, |w| {
                    w.open(shape_word(shape));
                    w.shape_parts(shape);
                    w.close();
                })
            };
        }
        match shape {
            Shape::Csg { children, operation } => match operation {
                CsgOperation::Union => shared!(children, "Union"),
                CsgOperation::Merge => shared!(children, "Merge"),
                CsgOperation::Intersection => shared!(children, "Intersection"),
                CsgOperation::Difference => shared!(children, "Difference"),
            },
            Shape::Mesh(mesh) => shared!(mesh, "Mesh"),
            Shape::HeightField(field) => shared!(field, "Height_Field"),
            Shape::Blob(blob) => shared!(blob, "Blob"),
            Shape::BicubicPatch(patch) => shared!(patch, "Patch"),
            Shape::Prism(prism) => shared!(prism, "Prism"),
            Shape::Text(text) => shared!(text, "Text"),
            Shape::Isosurface(surface) => shared!(surface, "Isosurface"),
            Shape::Parametric(surface) => shared!(surface, "Parametric"),
            Shape::JuliaFractal(julia) => shared!(julia, "Julia"),
            Shape::Polynomial { coefficients, .. } => shared!(coefficients, "Polynomial"),
            Shape::Polygon { points } => shared!(points, "Polygon"),
            Shape::Lathe { points, .. } => shared!(points, "Lathe"),
            Shape::Sor { points, .. } => shared!(points, "Sor"),
            Shape::SphereSweep { spheres, .. } => shared!(spheres, "Sweep"),
            // Not worth a name, or never the same twice.
            Shape::Sphere { .. } | Shape::Box { .. } | Shape::Cylinder { .. } | Shape::Cone { .. } => None,
            Shape::Plane { .. } | Shape::Disc { .. } | Shape::Torus { .. } | Shape::Ovus { .. } => None,
            Shape::Quadric { .. } | Shape::Superellipsoid { .. } | Shape::Triangle { .. } => None,
            Shape::SmoothTriangle(_) | Shape::LightSource(_) | Shape::LightGroup { .. } => None,
        }
    }

    fn flags(&mut self, flags: &Flags) {
        let Flags {
            inverse,
            turned,
            hollow,
            no_shadow,
            no_image,
            no_reflection,
            no_radiosity,
            double_illuminate,
            cutaway_textures,
            uv_mapping: _,
            no_hierarchy,
            keep_union,
            bounds_are_clips: _,
        } = *flags;
        let mut words: Vec<String> = Vec::new();
        let mut add = |on: bool, word: &str| words.extend(on.then(|| word.to_owned()));
        add(inverse, "inverse");
        add(turned && !inverse, "inverse inverse");
        add(no_shadow, "no_shadow");
        add(no_image, "no_image");
        add(no_reflection, "no_reflection");
        add(no_radiosity, "no_radiosity");
        add(cutaway_textures, "cutaway_textures");
        add(no_hierarchy, "hierarchy off");
        add(keep_union, "split_union off");
        words.extend(hollow.map(|on| format!("hollow {}", switch(on))));
        words.extend(double_illuminate.map(|on| format!("double_illuminate {}", switch(on))));
        if !words.is_empty() {
            self.line(words.join(" "));
        }
    }

    fn rare(&mut self, rare: &RareParts, flags: &Flags) {
        let RareParts { interior_texture: _, clipped_by, bounded_by, photons, radiosity_importance } = rare;
        self.photons(photons);
        if let Some(importance) = radiosity_importance {
            self.line(format_args!("radiosity {{ importance {} }}", float(*importance)));
        }
        self.cutters("clipped_by", clipped_by);
        if flags.bounds_are_clips && !clipped_by.is_empty() {
            self.line("bounded_by { clipped_by }");
        } else {
            self.cutters("bounded_by", bounded_by);
        }
    }

    fn cutters(&mut self, word: &str, objects: &[Arc<Object>]) {
        if !objects.is_empty() {
            self.open(word);
            objects.iter().for_each(|object| self.object(object));
            self.close();
        }
    }

    /// `photons { … }` of an object or light, if anything was said.
    pub(super) fn photons(&mut self, photons: &PhotonFlags) {
        let PhotonFlags { target, refraction, reflection, collect, pass_through, area_light } = *photons;
        let mut words: Vec<String> = Vec::new();
        words.extend(target.map(|spacing| format!("target {}", double(spacing))));
        for (word, value) in [("refraction", refraction), ("reflection", reflection), ("collect", collect)] {
            words.extend(value.map(|on| format!("{word} {}", switch(on))));
        }
        for (word, on) in [("pass_through", pass_through), ("area_light", area_light)] {
            words.extend(on.then(|| word.to_owned()));
        }
        if !words.is_empty() {
            self.block("photons", words.join(" "));
        }
    }
}

/// The word of a shape as it is written here.
pub(super) fn shape_word(shape: &Shape) -> &'static str {
    match shape {
        Shape::Mesh(mesh) if mesh.is_mesh2 => "mesh2",
        _ => shape.kind(),
    }
}
