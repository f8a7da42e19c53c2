//! Answers to what a scene asks about its own objects while it is being read.

use super::geometry::{compile_object, extent};
use super::picture::Pictures;
use super::texture::{Refusal, TextureCompiler};
use crate::compiled::geometry::{Geometry, RayKind, Scratch};
use crate::compiled::texture::{Context, Pattern, Pigment};
use crate::diag::Diagnostic;
use crate::function::Callable;
use crate::math::{Bounds, DVec3, Range, Ray};
use crate::scene::{self, Flags, GeometryQueries, Object, Settings};
use rustc_hash::FxHashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// POV-Ray's least distance of a hit. Scenes that walk over surfaces by `trace` count on not meeting
/// the one on which they stand.
const POV_NEAREST: f64 = 1e-4;

/// Compiles what is asked about, once for each object.
#[derive(Debug, Default)]
pub struct Queries {
    /// By address.
    known: Mutex<FxHashMap<usize, Known>>,
    /// Of functions made of pigments.
    pictures: Pictures,
}

/// The object is kept so that its address stays its own.
#[derive(Debug)]
struct Known {
    _object: Arc<Object>,
    geometry: Arc<Geometry>,
}

impl Queries {
    /// With the pictures of other scenes.
    pub fn sharing(pictures: &Pictures) -> Self {
        Self { pictures: pictures.clone(), ..Self::default() }
    }

    /// Objects that cannot be compiled count as empty here; the scene's own compilation says why.
    fn geometry(&self, object: &Arc<Object>) -> Arc<Geometry> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let address = Arc::as_ptr(object) as usize;
        let compile = || {
            // What no ray sees would be left out, but the scene may ask about it.
            let mut seen = Object::clone(object);
            seen.flags = Flags { no_image: false, no_reflection: false, no_shadow: false, ..seen.flags };
            let geometry = Arc::new(compile_object(&seen).unwrap_or_default());
            Known { _object: Arc::clone(object), geometry }
        };
        Arc::clone(&known.entry(address).or_insert_with(compile).geometry)
    }
}

impl GeometryQueries for Queries {
    fn trace(&self, object: &Arc<Object>, ray: &Ray) -> Option<(DVec3, DVec3)> {
        let geometry = self.geometry(object);
        let hit = geometry.intersect(
            ray,
            Range { min: POV_NEAREST, ..Range::FORWARD },
            RayKind::Probe,
            &mut Scratch::default(),
        )?;
        let surface = geometry.surface(ray, &hit);
        Some((surface.point, surface.normal))
    }

    fn inside(&self, object: &Arc<Object>, point: DVec3) -> Option<bool> {
        Some(self.geometry(object).contains(point))
    }

    fn extent(&self, object: &Arc<Object>) -> Bounds {
        extent(object)
    }

    fn pigment_function(
        &self,
        pigment: &Arc<scene::Pigment>,
        settings: &Settings,
    ) -> Result<Arc<dyn Callable>, Diagnostic> {
        let compiled = TextureCompiler::sharing(&for_functions(settings), &self.pictures).pigment(pigment);
        Ok(Arc::new(PigmentFunction(compiled.map_err(Refusal::diagnostic)?)))
    }

    fn pattern_function(
        &self,
        pattern: &Arc<scene::Pattern>,
        settings: &Settings,
    ) -> Result<Arc<dyn Callable>, Diagnostic> {
        let compiled = TextureCompiler::sharing(&for_functions(settings), &self.pictures).pattern(pattern);
        Ok(Arc::new(PatternFunction(compiled.map_err(Refusal::diagnostic)?)))
    }
}

/// The settings that functions see: the scene's own, but as in POV-Ray 3.7 always the default number of waves.
fn for_functions(settings: &Settings) -> Settings {
    Settings { number_of_waves: Settings::default().number_of_waves, ..settings.clone() }
}

fn point(args: &[f64]) -> DVec3 {
    let at = |i: usize| args.get(i).copied().unwrap_or(0.0);
    DVec3::new(at(0), at(1), at(2))
}

/// Red, green, blue, filter and transmit at a point.
#[derive(Debug)]
struct PigmentFunction(Pigment);

impl Callable for PigmentFunction {
    fn width(&self) -> usize {
        5
    }

    fn call(&self, args: &[f64]) -> [f64; 5] {
        self.0.color_or_clear(point(args), &Context::default()).to_array()
    }
}

/// One value at a point.
#[derive(Debug)]
struct PatternFunction(Pattern);

impl Callable for PatternFunction {
    fn width(&self) -> usize {
        1
    }

    fn call(&self, args: &[f64]) -> [f64; 5] {
        [self.0.value(point(args), &Context::default()), 0.0, 0.0, 0.0, 0.0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::eval::{Memory, Options, evaluate};

    /// What a scene prints after these global settings.
    fn printed(settings: &str, function: &str) -> String {
        let text = format!(
            "#version 3.7; global_settings {{ {settings} }} #declare F = function {{ {function} }}
            #declare V = F(1.3, 2.7, -0.4); #debug str(V.x, 0, 6)"
        );
        let host = Memory::new([("a.pov", text.as_str())]);
        assert!(evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()).is_ok(), "{text}");
        host.messages()
    }

    #[test]
    fn trace_meets_what_shadows_pass_by() {
        let scene = "#version 3.7; #declare S = sphere { 0, 1 no_shadow no_image no_reflection }
            #declare N = <0, 0, 0>; #declare P = trace(S, 2 * y, -y, N); #debug vstr(3, P + N, \",\", 0, 1)";
        let host = Memory::new([("a.pov", scene)]);
        assert!(evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()).is_ok());
        assert_eq!(host.messages(), "0.0,2.0,0.0");
    }

    /// What cannot be made a function is refused where it stands, as POV-Ray does, and is not black.
    #[test]
    fn functions_of_what_is_wrong_are_refused() {
        let refused = |body: &str, place: &str| {
            let text = format!("#version 3.7; #declare F = function {{ {body} }}");
            let host = Memory::new([("a.pov", text.as_str())]).with("a.ppm", b"P6 2".to_vec());
            let failed = evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::default()).err();
            let spans = failed.into_iter().flat_map(|f| f.diagnostics).filter_map(|d| d.span);
            let found: Vec<_> = spans.map(|s| text[s.start as usize..s.end as usize].to_owned()).collect();
            assert!(found.iter().any(|text| text == place), "{text}: {found:?}");
        };
        refused("pigment { image_map { ppm \"a.ppm\" } }", "\"a.ppm\"");
        refused("pattern { density_file df3 \"a.ppm\" }", "\"a.ppm\"");
    }

    /// Values printed by POV-Ray 3.7.0.10.
    #[test]
    fn functions_follow_the_global_settings() {
        let bozo = "pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } }";
        assert_eq!(printed("noise_generator 1", bozo), "0.589639");
        assert_eq!(printed("noise_generator 3", bozo), "0.787601");
        let waves = "pigment { waves color_map { [0 rgb 0] [1 rgb 1] } }";
        assert_eq!(printed("number_of_waves 3", waves), "0.513905");
        assert_eq!(printed("number_of_waves 10", waves), "0.513905");
    }
}
