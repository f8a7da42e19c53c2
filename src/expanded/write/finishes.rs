//! Finishes.

use super::number::{double, float, rgb};
use super::writer::Writer;
use crate::scene::Finish;
use std::sync::Arc;

impl Writer<'_> {
    /// `finish { … }`, as far as it is not the default one.
    pub(super) fn finish(&mut self, finish: &Arc<Finish>) {
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
