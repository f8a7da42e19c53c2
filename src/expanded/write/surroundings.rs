//! What stands around the objects: settings, camera, background, sky, fog, rainbows.

use super::number::{color, double, float, rgb, vector};
use super::patterns::turbulence_words;
use super::pictures::{file_name, working};
use super::writer::Writer;
use crate::math::DVec3;
use crate::scene::{
    Background, Blend, Camera, CameraKind, FocalBlur, Fog, Gamma, GatherRadius, MeshCamera, PhotonFile, Photons,
    PigmentKind, Radiosity, Rainbow, Settings, SkySphere, Subsurface,
};

impl Writer<'_> {
    /// Whether `assumed_gamma` is written. Where the version implies it, pictures were read before it was known.
    pub(super) fn says_gamma(&self) -> bool {
        let implied = self.settings.version >= 370 && self.settings.gamma == Gamma::implied(370);
        match self.settings.gamma {
            Gamma::None => false,
            Gamma::Linear(_) => !(implied && self.pictures_mode == Some(Gamma::None)),
        }
    }

    /// `global_settings { … }`.
    pub(super) fn global_settings(&mut self) {
        let Settings {
            version: _,
            max_parts: _,
            gamma,
            ambient_light,
            irid_wavelength,
            max_trace_level,
            adc_bailout,
            number_of_waves,
            noise_generator,
            mm_per_unit,
            subsurface,
            radiosity,
            radiosity_importance,
            photons,
        } = self.settings;
        let plain = Settings::default();
        self.open("global_settings");
        if let (Gamma::Linear(curve), true) = (gamma, self.says_gamma()) {
            self.line(format_args!("assumed_gamma {}", working(*curve)));
        }
        if self.unicode {
            self.line("charset utf8");
        }
        if *ambient_light != plain.ambient_light {
            self.line(format_args!("ambient_light {}", rgb(*ambient_light)));
        }
        if *irid_wavelength != plain.irid_wavelength {
            self.line(format_args!("irid_wavelength {}", rgb(*irid_wavelength)));
        }
        if *max_trace_level != plain.max_trace_level {
            self.line(format_args!("max_trace_level {max_trace_level}"));
        }
        if *adc_bailout != plain.adc_bailout {
            self.line(format_args!("adc_bailout {}", double(*adc_bailout)));
        }
        if *number_of_waves != plain.number_of_waves {
            self.line(format_args!("number_of_waves {number_of_waves}"));
        }
        if let Some(generator) = noise_generator {
            self.line(format_args!("noise_generator {generator}"));
        }
        if *mm_per_unit != plain.mm_per_unit {
            self.line(format_args!("mm_per_unit {}", double(*mm_per_unit)));
        }
        if let Some(Subsurface { span: _, samples: [often, once], radiosity }) = subsurface {
            let radiosity = u8::from(*radiosity);
            self.line(format_args!("subsurface {{ samples {often}, {once} radiosity {radiosity} }}"));
        }
        if let Some(radiosity) = radiosity {
            self.radiosity(radiosity);
        }
        if let Some(photons) = photons {
            self.photon_settings(photons);
        }
        self.close();
        if radiosity_importance.to_bits() != plain.radiosity_importance.to_bits() {
            let importance = float(*radiosity_importance);
            self.line(format_args!("#default {{ radiosity {{ importance {importance} }} }}"));
        }
    }

    fn radiosity(&mut self, radiosity: &Radiosity) {
        let Radiosity {
            span: _,
            count,
            directions,
            error_bound,
            low_error_factor,
            nearest_count,
            enough_for_pretrace,
            minimum_reuse,
            maximum_reuse,
            pretrace_start,
            pretrace_end,
            recursion_limit,
            brightness,
            gray_threshold,
            max_sample,
            adc_bailout,
            always_sample,
            normal,
            media,
            subsurface,
        } = radiosity;
        self.open("radiosity");
        self.line(format_args!("count {count}, {directions}"));
        self.line(format_args!("error_bound {} low_error_factor {}", double(*error_bound), double(*low_error_factor)));
        let enough = if *enough_for_pretrace > 0 { format!(", {enough_for_pretrace}") } else { String::new() };
        self.line(format_args!("nearest_count {nearest_count}{enough}"));
        for (word, value) in [("minimum_reuse", minimum_reuse), ("maximum_reuse", maximum_reuse)] {
            if let Some(value) = value {
                self.line(format_args!("{word} {}", double(*value)));
            }
        }
        self.line(format_args!("pretrace_start {} pretrace_end {}", double(*pretrace_start), double(*pretrace_end)));
        self.line(format_args!("recursion_limit {recursion_limit} brightness {}", double(*brightness)));
        self.line(format_args!("gray_threshold {} adc_bailout {}", double(*gray_threshold), double(*adc_bailout)));
        if let Some(most) = max_sample {
            self.line(format_args!("max_sample {}", double(*most)));
        }
        for (word, on) in
            [("always_sample", always_sample), ("normal", normal), ("media", media), ("subsurface", subsurface)]
        {
            self.line(format_args!("{word} {}", u8::from(*on)));
        }
        self.close();
    }

    fn photon_settings(&mut self, photons: &Photons) {
        let Photons {
            span: _,
            spacing,
            count,
            gather: [least, most],
            jitter,
            autostop,
            expand_increase,
            expand_minimum,
            surface_radius,
            media_radius,
            media_steps,
            media_factor,
            max_trace_level,
            adc_bailout,
            file,
        } = photons;
        self.open("photons");
        self.line(format_args!("spacing {}", double(*spacing)));
        if let Some(count) = count {
            self.line(format_args!("count {count}"));
        }
        self.line(format_args!("gather {least}, {most} jitter {} autostop {}", double(*jitter), double(*autostop)));
        self.line(format_args!("expand_thresholds {}, {expand_minimum}", double(*expand_increase)));
        let radius = |GatherRadius { length, factor }: &GatherRadius| {
            format!("{}, {}", double(length.unwrap_or(0.0)), double(*factor))
        };
        self.line(format_args!("radius {}, {}", radius(surface_radius), radius(media_radius)));
        if *media_steps > 0 {
            self.line(format_args!("media {media_steps}, {}", double(*media_factor)));
        }
        if let Some(level) = max_trace_level {
            self.line(format_args!("max_trace_level {level}"));
        }
        if let Some(bailout) = adc_bailout {
            self.line(format_args!("adc_bailout {}", double(*bailout)));
        }
        match file {
            Some(PhotonFile::Save(name)) => self.line(format_args!("save_file {}", file_name(name))),
            Some(PhotonFile::Load(name)) => self.line(format_args!("load_file {}", file_name(name))),
            None => {}
        }
        self.close();
    }

    /// `camera { … }`, with all that look_at, angles and transformations did worked in.
    pub(super) fn camera(&mut self, camera: &Camera) {
        let Camera { span: _, kind, location, direction, up, right, angle_deg, vertical_angle_deg, normal, focal_blur } =
            camera;
        self.open("camera");
        match kind {
            CameraKind::Perspective => self.line("perspective"),
            CameraKind::Orthographic => self.line("orthographic"),
            CameraKind::Fisheye => self.line("fisheye"),
            CameraKind::UltraWideAngle => self.line("ultra_wide_angle"),
            CameraKind::Omnimax => self.line("omnimax"),
            CameraKind::Panoramic => self.line("panoramic"),
            CameraKind::Cylinder(number) => self.line(format_args!("cylinder {number}")),
            CameraKind::Spherical => self.line("spherical"),
            CameraKind::Mesh(mesh) => self.mesh_camera(mesh),
        }
        self.line(format_args!("location {}", vector(*location)));
        self.line(format_args!("direction {}", vector(*direction)));
        self.line(format_args!("up {}", vector(*up)));
        self.line(format_args!("right {}", vector(*right)));
        match kind {
            // Their angle is worked into the direction.
            CameraKind::Perspective | CameraKind::Orthographic | CameraKind::Mesh(_) => {}
            CameraKind::Spherical => {
                self.line(format_args!("angle {}, {}", double(*angle_deg), double(*vertical_angle_deg)));
            }
            _ => self.line(format_args!("angle {}", double(*angle_deg))),
        }
        if let Some(normal) = normal {
            self.normal_block(normal);
        }
        if let Some(blur) = focal_blur {
            self.focal_blur(blur, *location, *direction);
        }
        self.close();
    }

    fn mesh_camera(&mut self, camera: &MeshCamera) {
        let MeshCamera { rays_per_pixel, distribution, max_distance, meshes, smooth } = camera;
        self.open("mesh_camera");
        self.line(format_args!("{rays_per_pixel}, {distribution}, {}", double(*max_distance)));
        meshes.iter().for_each(|mesh| self.object(mesh));
        if *smooth {
            self.line("smooth");
        }
        self.close();
    }

    fn focal_blur(&mut self, blur: &FocalBlur, location: DVec3, direction: DVec3) {
        let FocalBlur { aperture, min_samples, max_samples, confidence, variance, focal_distance, bokeh } = blur;
        let least = if *min_samples > 0 { format!("{min_samples}, ") } else { String::new() };
        self.line(format_args!("aperture {} blur_samples {least}{max_samples}", double(*aperture)));
        self.line(format_args!("confidence {} variance {}", double(*confidence), double(*variance)));
        let point = location + direction.normalize_or(DVec3::Z) * *focal_distance;
        self.line(format_args!("focal_point {}", vector(point)));
        if (point - location).length() != *focal_distance {
            self.note(format_args!("focal_distance {}", double(*focal_distance)));
        }
        if let Some(pigment) = bokeh {
            self.open("bokeh");
            self.open("pigment");
            self.pigment_content(pigment);
            self.close();
            self.close();
        }
    }

    pub(super) fn background(&mut self, background: &Background) {
        let Background { color: shown, legacy } = background;
        self.open("background");
        self.line(color(*shown));
        if *legacy != (self.settings.version < 370) {
            self.note(if *legacy { "legacy" } else { "current" });
        }
        self.close();
    }

    pub(super) fn sky_sphere(&mut self, sky: &SkySphere) {
        let SkySphere { span: _, pigments, emission, transform } = sky;
        self.open("sky_sphere");
        for pigment in pigments {
            self.open("pigment");
            self.pigment_content(pigment);
            self.close();
        }
        if *emission != crate::math::Rgb::ONE {
            self.line(format_args!("emission {}", rgb(*emission)));
        }
        self.transform(transform);
        self.close();
    }

    pub(super) fn fog(&mut self, fog: &Fog) {
        let Fog { span: _, ground, distance, color: shown, offset, alt, up, turbulence, turb_depth } = fog;
        self.open("fog");
        self.line(format_args!("fog_type {} distance {} {}", u8::from(*ground) + 1, double(*distance), color(*shown)));
        if *ground || *offset != 0.0 || *alt != 0.0 || *up != DVec3::Y {
            self.line(format_args!("fog_offset {} fog_alt {} up {}", double(*offset), double(*alt), vector(*up)));
        }
        if let Some(turbulence) = turbulence {
            self.line(format_args!("{} turb_depth {}", turbulence_words(turbulence), double(*turb_depth)));
        }
        self.close();
    }

    pub(super) fn rainbow(&mut self, rainbow: &Rainbow) {
        let Rainbow {
            span: _,
            direction,
            up,
            angle_deg,
            width_deg,
            distance,
            jitter,
            arc_angle_deg,
            falloff_angle_deg,
            pigment,
        } = rainbow;
        self.open("rainbow");
        self.line(format_args!("direction {} up {}", vector(*direction), vector(*up)));
        self.line(format_args!("angle {} width {}", double(*angle_deg), double(*width_deg)));
        self.line(format_args!("distance {} jitter {}", double(*distance), double(*jitter)));
        for (word, angle) in [("arc_angle", arc_angle_deg), ("falloff_angle", falloff_angle_deg)] {
            if let Some(angle) = angle {
                self.line(format_args!("{word} {}", double(*angle)));
            }
        }
        if let PigmentKind::Colors(_, colors) = &pigment.kind
            && let Blend::Map(entries) = &**colors
        {
            self.color_map(entries);
        }
        self.close();
    }
}
