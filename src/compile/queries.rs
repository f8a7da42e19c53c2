//! Answers to what a scene asks about its own objects while it is being read.

use super::function::Functions;
use super::geometry::{compile_object_sharing, extent};
use super::texture::Refusal;
use crate::compiled::geometry::{Geometry, RayKind, Scratch};
use crate::diag::Diagnostic;
use crate::function::{Callable as _, Caller, Translate as _};
use crate::math::{Bounds, DVec3, Range, Ray};
use crate::scene::{Flags, GeometryQueries, Object, PointFunction};
use rustc_hash::FxHashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// POV-Ray's least distance of a hit; where all of an object is nearer than 1, a share of that. Scenes that walk over surfaces by `trace` count on not meeting
/// the one on which they stand.
const POV_NEAREST: f64 = 1e-4;

/// Compiles what is asked about, once for each object.
#[derive(Debug, Default)]
pub struct Queries {
    /// By address.
    known: Mutex<FxHashMap<usize, Known>>,
    functions: Functions,
}

/// The object is kept so that its address stays its own.
#[derive(Debug)]
struct Known {
    _object: Arc<Object>,
    geometry: Arc<Geometry>,
}

impl Queries {
    /// Keeping what it makes of functions for others.
    pub fn sharing(functions: &Functions) -> Self {
        Self { functions: functions.clone(), ..Self::default() }
    }

    /// Objects that cannot be compiled count as empty here; the scene's own compilation says why.
    fn geometry(&self, object: &Arc<Object>) -> Arc<Geometry> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let address = Arc::as_ptr(object) as usize;
        let compile = || {
            // What no ray sees would be left out, but the scene may ask about it.
            let mut seen = Object::clone(object);
            seen.flags = Flags { no_image: false, no_reflection: false, no_shadow: false, ..seen.flags };
            let geometry = Arc::new(compile_object_sharing(&seen, &self.functions).unwrap_or_default());
            Known { _object: Arc::clone(object), geometry }
        };
        Arc::clone(&known.entry(address).or_insert_with(compile).geometry)
    }
}

impl GeometryQueries for Queries {
    fn trace(&self, object: &Arc<Object>, ray: &Ray) -> Option<(DVec3, DVec3)> {
        let geometry = self.geometry(object);
        let nearest = POV_NEAREST * geometry.reach(ray.origin).unwrap_or(1.0).min(1.0);
        let range = Range { min: nearest, ..Range::FORWARD };
        let hit = geometry.intersect(ray, range, RayKind::Probe, &mut Scratch::default())?;
        let surface = geometry.surface(ray, &hit);
        Some((surface.point, surface.normal))
    }

    fn inside(&self, object: &Arc<Object>, point: DVec3) -> Option<bool> {
        Some(self.geometry(object).contains(point))
    }

    fn extent(&self, object: &Arc<Object>) -> Bounds {
        extent(object)
    }

    fn check(&self, function: &Arc<PointFunction>) -> Result<(), Diagnostic> {
        self.functions.external(function).map(drop).map_err(Refusal::diagnostic)
    }
}

impl Caller<PointFunction> for Queries {
    /// What cannot be called has been refused before.
    fn call(&self, function: &Arc<PointFunction>, args: &[f64]) -> [f64; 5] {
        self.functions.external(function).map_or([0.0; 5], |function| function.call(args))
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
