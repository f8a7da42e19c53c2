//! The whole scene: geometry first, then everything that its handles refer to.

use super::function::Functions;
use super::geometry::{CompiledGeometry, PlacedLight, Watched, compile_object_sharing};
use super::subsurface::ReducedAlbedos;
use super::texture::{Refusal, TextureCompiler, noise_generator};
use super::{camera, light, medium, photons};
use crate::compiled::atmosphere::{Atmosphere, Background, Fog, FogTurbulence, Rainbow, Sky};
use crate::compiled::geometry::{InteriorId, LightGroupId, TextureId, Touching};
use crate::compiled::interior::{Interior, InteriorFade};
use crate::compiled::medium::Medium;
use crate::compiled::texture::Texture;
use crate::compiled::{Features, Settings, Table, Transfer, World};
use crate::diag::{Diagnostic, SourceResult};
use crate::math::noise::Octaves;
use crate::math::{Color, DVec3};
use crate::omission::{Found, Keep, Ledger, Omission};
use crate::scene::{self, Declared, Gamma, Scene, Working};
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;
use std::ops::Range;
use std::sync::Arc;

/// POV-Ray's own limit below which a distance or width switches a thing off.
const TINY: f64 = 1e-10;

/// A compiled scene with what there is to say about it.
#[derive(Debug)]
pub struct Compiled {
    /// What is rendered.
    pub world: World,
    /// What is left out or unusual.
    pub warnings: Vec<Diagnostic>,
    /// What may have something to say after rendering.
    pub watched: Vec<Watched>,
    /// What this scene does not need.
    pub ledger: Ledger,
}

/// Compiles a scene; warnings come beside the result.
///
/// After this no texture, interior or light is missing, no transformation is the identity, and
/// rendering cannot fail.
///
/// # Errors
/// Everything that is unsupported or wrong, each with its place where one is known.
pub fn compile(scene: &Scene) -> SourceResult<Compiled> {
    compile_with(scene, &Functions::default(), Keep::NONE)
}

/// The same, with what was made of functions while the scene was read, and without leaving out what is to be kept.
///
/// # Errors
/// Those of [`compile`].
pub fn compile_with(scene: &Scene, functions: &Functions, keep: Keep) -> SourceResult<Compiled> {
    let CompiledGeometry {
        mut geometry,
        textures,
        interiors,
        lights,
        light_groups,
        targets,
        labels,
        mut warnings,
        watched,
        mut ledger,
    } = super::geometry::compile(scene, functions, keep)?;
    let mut errors = Vec::new();
    let mut compiler = TextureCompiler::sharing(&scene.settings, functions).keeping(keep);
    let textures: Table<_, _> = textures.iter().filter_map(|t| note(compiler.texture(t), &mut errors)).collect();
    let camera = camera::camera(&scene.camera, &mut compiler).map_err(|r| r.at(scene.camera.span));
    let camera = note(camera, &mut errors);
    let mut media = Vec::new();
    let subsurface = super::subsurface::subsurface(&scene.settings);
    let albedos = subsurface.map(|_| ReducedAlbedos::default());
    let interiors = note(compiled_interiors(&interiors, &mut compiler, &mut media, albedos), &mut errors);
    let atmosphere = note(atmosphere(scene, &mut compiler, &mut media), &mut errors);
    let Lights { all: lights, global: global_lights, of_groups: group_lights } =
        place_lights(lights, &light_groups, &mut warnings)?;
    let photons = photons::photons(&scene.settings, targets, &lights, &global_lights, &mut warnings)?;
    let (Some(camera), Some(interiors), Some(atmosphere), true) = (camera, interiors, atmosphere, errors.is_empty())
    else {
        return Err(errors);
    };
    keep_unused(&scene.unused, functions, &mut compiler);
    ledger.note(Omission::Declarations, Found { count: scene.unused.count, bytes: 0 });
    let opaque = opacity(&textures, &mut ledger);
    geometry.learn_opacity(&opaque);
    ledger.add(compiler.ledger());
    let mut world = World {
        geometry,
        opaque,
        textures,
        interiors,
        media,
        lights,
        global_lights,
        group_lights,
        camera,
        atmosphere,
        settings: settings(&scene.settings),
        photons,
        radiosity: scene.settings.radiosity.as_ref().map(|r| super::radiosity::radiosity(r, &scene.settings)),
        subsurface,
        labels,
        touching: Touching::default(),
        features: Features::default(),
    };
    world.features = Features::of(&world, keep);
    let found = |count: usize| Found { count, bytes: 0 };
    ledger.note(Omission::SpentLights, found(world.features.waning_lights(&world)));
    if !world.features.bends_light() {
        ledger.note(Omission::Interiors, found(world.interiors.len()));
    }
    if world.features.interiors_matter() {
        world.touching = world.geometry.may_touch(|interior| world.interior(interior).is_optical());
    }
    Ok(Compiled { world, warnings, watched, ledger })
}

/// Of each texture, whether no light comes through; where that holds for all, they can be left out of shadows.
fn opacity(textures: &Table<TextureId, Texture>, ledger: &mut Ledger) -> Table<TextureId, bool> {
    let all = textures.iter().all(Texture::is_opaque);
    textures.iter().map(|t| t.is_opaque() && (!all || ledger.omits(Omission::ShadowTextures, 0))).collect()
}

/// Compiles what nothing uses, for nothing. What is wrong with it is nobody's concern.
fn keep_unused(unused: &scene::Unused, functions: &Functions, compiler: &mut TextureCompiler<'_>) {
    for declared in &unused.kept {
        match declared {
            Declared::Object(object) => drop(compile_object_sharing(object, functions)),
            Declared::Texture(texture) => drop(compiler.texture(texture)),
            Declared::Pigment(pigment) => drop(compiler.pigment(pigment)),
            Declared::Normal(normal) => drop(compiler.normal(normal)),
            Declared::Other => {}
        }
    }
}

/// Takes the value or notes the refusal.
fn note<T>(result: Result<T, Refusal>, errors: &mut Vec<Diagnostic>) -> Option<T> {
    result.map_err(|refusal| errors.push(refusal.diagnostic())).ok()
}

/// All lights, and which of them shine outside of groups and in each.
struct Lights {
    all: Vec<crate::compiled::light::Light>,
    global: Vec<usize>,
    of_groups: Table<LightGroupId, Vec<usize>>,
}

/// Global lights first, then those of each group.
fn place_lights(
    placed: Vec<PlacedLight>,
    groups: &Table<LightGroupId, super::geometry::LightGroup>,
    warnings: &mut Vec<Diagnostic>,
) -> SourceResult<Lights> {
    let mut lights = Vec::with_capacity(placed.len());
    let mut add = |members: &mut dyn Iterator<Item = &PlacedLight>| -> SourceResult<std::ops::Range<usize>> {
        let first = lights.len();
        for member in members {
            warnings.extend(light::warnings(member));
            lights.push(light::light(member)?);
        }
        Ok(first..lights.len())
    };
    let global: Vec<usize> = add(&mut placed.iter().filter(|l| l.group.is_none()))?.collect();
    let mut of_groups = Table::with_capacity(groups.len());
    for group in groups.iter() {
        let id = of_groups.next_handle();
        let own = add(&mut placed.iter().filter(|l| l.group == Some(id)))?;
        let shared = global.iter().copied().filter(|_| group.global_lights);
        of_groups.push(shared.chain(own).collect());
    }
    Ok(Lights { all: lights, global, of_groups })
}

/// One for each, of which those of one statement are the same in memory, as most objects have the one that was never
/// written, and those that are alike and follow each other.
fn compiled_interiors(
    interiors: &Table<InteriorId, Arc<scene::Interior>>,
    compiler: &mut TextureCompiler<'_>,
    media: &mut Vec<Medium>,
    mut albedos: Option<ReducedAlbedos>,
) -> Result<Table<InteriorId, Arc<Interior>>, Refusal> {
    let mut known = FxHashMap::default();
    let mut last: Option<Arc<Interior>> = None;
    let mut compiled = |i: &Arc<scene::Interior>| -> Result<_, Refusal> {
        let mut made = interior(i, add_media(&i.media, compiler, media)?);
        made.reduced_albedo = albedos.as_mut().map(|known| known.of(made.ior));
        let like = last.take().filter(|last| **last == made).unwrap_or_else(|| Arc::new(made));
        Ok(Arc::clone(last.insert(like)))
    };
    let each = |i: &Arc<scene::Interior>| match known.entry(Arc::as_ptr(i)) {
        Entry::Occupied(entry) => Ok(Arc::clone(entry.get())),
        Entry::Vacant(entry) => Ok(Arc::clone(entry.insert(compiled(i)?))),
    };
    interiors.iter().map(each).collect()
}

/// Compiles media that belong together; gives their places in the world's list.
fn add_media(
    written: &[scene::Media],
    compiler: &mut TextureCompiler<'_>,
    media: &mut Vec<Medium>,
) -> Result<Range<usize>, Refusal> {
    let first = media.len();
    for one in written {
        media.push(medium::medium(one, compiler)?);
    }
    Ok(if written.is_empty() { 0..0 } else { first..media.len() })
}

fn interior(interior: &scene::Interior, media: Range<usize>) -> Interior {
    let has_ior = interior.ior != 0.0;
    let fade =
        InteriorFade { distance: interior.fade_distance, power: interior.fade_power, color: interior.fade_color };
    Interior {
        // Single precision, as in POV-Ray: fine patterns far behind show it.
        ior: if has_ior { f64::from(interior.ior as f32) } else { 1.0 },
        dispersion: if has_ior { interior.dispersion } else { 1.0 },
        dispersion_samples: interior.dispersion_samples,
        fade: (interior.fade_distance.abs() > TINY).then_some(fade),
        caustics: interior.caustics * 45.0,
        refraction: interior.refraction as f32,
        media,
        reduced_albedo: None,
    }
}

fn settings(settings: &scene::Settings) -> Settings {
    let transfer = |working: Working| match working {
        Working::Srgb => Transfer::Srgb,
        working if working.is_linear() => Transfer::Linear,
        Working::Power(gamma) => Transfer::Power(gamma),
    };
    Settings {
        max_trace_level: settings.max_trace_level,
        adc_bailout: settings.adc_bailout as f32,
        irid_wavelength: settings.irid_wavelength,
        legacy_opacity: settings.version < 370,
        transfer: match settings.gamma {
            Gamma::None => Transfer::Srgb,
            Gamma::Linear(working) => transfer(working),
        },
        display_values: matches!(settings.gamma, Gamma::None),
    }
}

fn atmosphere(
    scene: &Scene,
    compiler: &mut TextureCompiler<'_>,
    media: &mut Vec<Medium>,
) -> Result<Atmosphere, Refusal> {
    let sky = match &scene.sky_sphere {
        None => None,
        Some(sky) => Some(Sky {
            pigments: sky
                .pigments
                .iter()
                .map(|p| compiler.pigment(p).map_err(|r| r.at(sky.span)))
                .collect::<Result<_, _>>()?,
            emission: sky.emission,
            sky_from_world: sky.transform.inverse(),
        }),
    };
    let rainbows = scene.rainbows.iter().filter(|r| r.width_deg != 0.0 && r.distance != 0.0);
    Ok(Atmosphere {
        background: scene.background.map(background),
        legacy: scene.settings.version < 370,
        sky,
        fogs: scene.fogs.iter().filter(|f| f.distance.abs() > TINY).map(|f| fog(f, &scene.settings)).collect(),
        rainbows: rainbows.map(|r| rainbow(r, compiler)).collect::<Result<_, _>>()?,
        media: add_media(&scene.media, compiler, media)?,
    })
}

/// Source: camera facts, sections 4.3 and 6.2; versions measured.
fn background(background: scene::Background) -> Background {
    let scene::Background { color, legacy } = background;
    let visible = if legacy { 1.0 } else { 1.0 - color.transmit };
    let translucent = if legacy { Color { filter: 0.0, transmit: 1.0, ..color } } else { color };
    Background { translucent, mirrored: color.rgb, opaque: color.rgb * visible }
}

fn fog(fog: &scene::Fog, settings: &scene::Settings) -> Fog {
    Fog {
        ground: fog.ground,
        distance: fog.distance,
        color: fog.color,
        offset: fog.offset,
        altitude: fog.alt,
        up: fog.up,
        turbulence: fog.turbulence.map(|t| FogTurbulence {
            scale: t.amount,
            octaves: Octaves { count: t.octaves, lambda: t.lambda, omega: t.omega },
            generator: noise_generator(settings),
            depth: fog.turb_depth,
        }),
    }
}

fn rainbow(rainbow: &scene::Rainbow, compiler: &mut TextureCompiler<'_>) -> Result<Rainbow, Refusal> {
    let direction = rainbow.direction.normalize_or(DVec3::Z);
    let right = rainbow.up.cross(direction).normalize_or(DVec3::X);
    let half = |degrees: Option<f64>| degrees.map(|d| (d * 0.5).to_radians());
    // Without an arc POV-Ray's limit is 180 in radians: none at all.
    let arc = half(rainbow.arc_angle_deg).unwrap_or(180.0);
    Ok(Rainbow {
        direction,
        up: direction.cross(right).normalize_or(DVec3::Y),
        right,
        angle: rainbow.angle_deg.to_radians(),
        width: rainbow.width_deg.to_radians(),
        distance: rainbow.distance,
        jitter: rainbow.jitter,
        arc,
        falloff: half(rainbow.falloff_angle_deg).unwrap_or(arc),
        pigment: compiler.pigment(&rainbow.pigment).map_err(|r| r.at(rainbow.span))?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::Queries;
    use crate::diag::SourceMap;
    use crate::eval::{Memory, Options, evaluate};

    /// The text that a message points at; nothing if it has no place.
    fn pointed_at(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
        let Some(span) = diagnostic.span else { return String::new() };
        let text = sources.file(span.file).map(|f| f.text[span.start as usize..span.end as usize].to_vec());
        String::from_utf8(text.unwrap_or_default()).unwrap_or_default()
    }

    /// Compiling a scene says this about that part of its text, and nothing else.
    fn check(text: &str, message: &str, place: &str) {
        let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }} sphere {{ 0, 1 }} {text}");
        let files = [("bad.ppm", b"P6 2".to_vec()), ("bad.df3", b"short".to_vec()), ("bad.pot", b"x".to_vec())];
        let host = files.into_iter().fold(Memory::new([("a.pov", text.as_str())]), |host, (n, b)| host.with(n, b));
        let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default());
        let read = read.unwrap_or_else(|failed| panic!("{text}: {:?}", failed.diagnostics));
        let said = compile(&read.scene).map_or_else(|errors| errors, |compiled| compiled.warnings);
        let found: Vec<_> = said.iter().map(|d| (&*d.message, pointed_at(d, &read.sources))).collect();
        assert!(found.len() == 1 && found[0].0.contains(message) && found[0].1 == place, "{text}: {found:?}");
    }

    #[test]
    fn refusals_point_at_what_is_refused() {
        let picture = |around: &str| check(&around.replace('@', "ppm \"bad.ppm\""), "", "\"bad.ppm\"");
        picture("box { 0, 1 pigment { image_map { @ } } }");
        picture(
            "#declare T = texture { pigment { image_map { @ } } } union { sphere { 0, 1 } box { 0, 1 texture { T } } }",
        );
        picture("plane { y, 0 pigment { checker pigment { image_map { @ } } pigment { rgb 1 } } rotate x }");
        picture("plane { y, 0 pigment { rgb 1 } normal { bump_map { @ } } }");
        picture("plane { y, 0 pigment { image_pattern { @ } } }");
        picture("plane { y, 0 texture { material_map { @ texture { pigment { rgb 1 } } } } }");
        picture("sky_sphere { pigment { image_map { @ } } }");
        picture("camera { location -z normal { bump_map { @ } } }");
        picture("camera { location -z aperture 1 blur_samples 4 bokeh { pigment { image_map { @ } } } }");
        check("box { 0, 1 pigment { image_map { pot \"bad.pot\" } } }", "height fields only", "\"bad.pot\"");
        let density = "box { 0, 1 pigment { density_file df3 \"bad.df3\" } }";
        check(density, "density file's length", "\"bad.df3\"");
        check(
            "box { 0, 1 pigment { pavement number_of_sides 3 number_of_tiles 90 } }",
            "no pavement of 90 tiles",
            "pavement",
        );
    }

    #[test]
    fn warnings_point_at_what_is_left_out() {
        let ball = "sphere { 0, 1 photons { target reflection on } } light_source { 9, 1 }";
        check(&format!("global_settings {{ photons {{ save_file \"a\" }} }} {ball}"), "neither saved", "photons");
        let light = "light_source { 0, 1 area_light x, y, 2000, 2000 }";
        check(light, "2000 x 2000 samples", "light_source");
    }
}
