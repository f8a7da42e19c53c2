//! Functions of a scene become functions that rays can call.

use super::picture::Pictures;
use super::texture::{Refusal, TextureCompiler};
use crate::compiled::Function;
use crate::compiled::texture::PointFunction;
use crate::function::Translate;
use crate::scene::{self, PointSource, Settings};
use crate::stack::roomy;
use rustc_hash::FxHashMap;
use std::sync::{Arc, Mutex, PoisonError, Weak};

/// What was made of the functions of one scene, and of the pigments and patterns that they call, once of each; copies of
/// this share it, so what the scene calls while it is read need not be made again.
#[derive(Clone, Debug, Default)]
pub struct Functions {
    functions: Made<scene::Function, Function>,
    externals: Made<scene::PointFunction, PointFunction>,
    pub(super) pictures: Pictures,
}

/// What was made of things, by their addresses.
type Made<S, T> = Arc<Mutex<Memo<S, T>>>;

/// Things may go while a scene is read, but their addresses stay their own until they are forgotten here.
#[derive(Debug)]
struct Memo<S, T> {
    known: FxHashMap<usize, (Weak<S>, Arc<T>)>,
    /// From how many on it is worth looking for those that have gone.
    many: usize,
}

impl<S, T> Default for Memo<S, T> {
    fn default() -> Self {
        Self { known: FxHashMap::default(), many: 64 }
    }
}

/// What was made of a thing before, or is made now.
fn once<S, T, E>(made: &Made<S, T>, source: &Arc<S>, make: impl FnOnce() -> Result<T, E>) -> Result<Arc<T>, E> {
    // A panic of another thread does not matter to plain data.
    let memo = || made.lock().unwrap_or_else(PoisonError::into_inner);
    let address = Arc::as_ptr(source).addr();
    if let Some((_, known)) = memo().known.get(&address) {
        return Ok(Arc::clone(known));
    }
    let new = Arc::new(make()?);
    let mut memo = memo();
    if memo.known.len() >= memo.many {
        memo.known.retain(|_, (source, _)| source.strong_count() > 0);
        memo.many = 2 * memo.known.len().max(32);
    }
    memo.known.insert(address, (Arc::downgrade(source), Arc::clone(&new)));
    Ok(new)
}

impl Functions {
    /// With the pictures of other scenes.
    pub fn sharing(pictures: &Pictures) -> Self {
        Self { pictures: pictures.clone(), ..Self::default() }
    }
}

impl Translate<scene::PointFunction, PointFunction> for Functions {
    type Error = Refusal;

    fn external(&self, external: &Arc<scene::PointFunction>) -> Result<Arc<PointFunction>, Refusal> {
        let make = || {
            let settings = for_functions(&external.settings);
            let mut compiler = TextureCompiler::sharing(&settings, self);
            Ok(match &external.source {
                PointSource::Pigment(pigment) => PointFunction::Pigment(compiler.pigment(pigment)?),
                PointSource::Pattern(pattern) => PointFunction::Pattern(compiler.pattern(pattern)?),
            })
        };
        once(&self.externals, external, || roomy(make))
    }

    fn function(&self, function: &Arc<scene::Function>) -> Result<Arc<Function>, Refusal> {
        once(&self.functions, function, || roomy(|| function.translated(self)))
    }
}

/// The settings that functions see: those where they stand, but as in POV-Ray 3.7 always the default number of waves.
fn for_functions(settings: &Settings) -> Settings {
    Settings { number_of_waves: Settings::default().number_of_waves, ..settings.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::{Queries, compile_with};
    use crate::compiled::geometry::Shape;
    use crate::eval::{Memory, Options, evaluate};
    use crate::function::{Callee, FunctionBody, Op};
    use crate::scene::Scene;

    /// A scene, and what was made of its functions while it was read.
    fn read(text: &str) -> (Scene, Functions) {
        let functions = Functions::default();
        let host = Memory::new([("a.pov", &*format!("#version 3.7; {text}"))]);
        let read = evaluate("a.pov".as_ref(), &Options::default(), &host, &Queries::sharing(&functions));
        (read.expect("a right scene").scene, functions)
    }

    /// What the functions of a compiled scene's isosurfaces call.
    fn called(scene: &Scene, functions: &Functions) -> Vec<Arc<PointFunction>> {
        let world = compile_with(scene, functions, crate::omission::Keep::NONE).expect("a right scene").world;
        let surfaces = world.geometry.primitives.iter().filter_map(|primitive| match &primitive.shape {
            Shape::Isosurface(surface) => Some(Arc::clone(&surface.function)),
            _ => None,
        });
        let called = |function: Arc<Function>| match &function.body {
            FunctionBody::Program(program) => program.ops().iter().find_map(|op| match op {
                Op::Call { callee: Callee::External(external), .. } => Some(Arc::clone(external)),
                _ => None,
            }),
            _ => None,
        };
        surfaces.filter_map(called).collect()
    }

    #[test]
    fn what_functions_call_is_made_once() {
        let (scene, functions) = read(
            "#declare P = function { pigment { bozo } } #declare V = P(1, 2, 3);
            #declare S = isosurface { function { P(x, y, z).red - 0.5 } contained_by { sphere { 0, 1 } } }
            object { S } object { S translate x } isosurface { function { P(x, 0, z).gray } open }",
        );
        let together = called(&scene, &functions);
        assert!(together.len() == 3 && together.iter().all(|p| Arc::ptr_eq(p, &together[0])));
        // A scene is data: it can be compiled again, from nothing.
        let again = called(&scene, &Functions::default());
        assert!(again.len() == 3 && !Arc::ptr_eq(&again[0], &together[0]));
        let at = [0.3, 0.4, 0.5];
        assert_eq!(
            crate::function::Callable::call(&*again[0], &at),
            crate::function::Callable::call(&*together[0], &at)
        );
    }

    #[test]
    fn what_a_scene_has_forgotten_is_forgotten() {
        let (_, functions) = read("#for (I, 1, 1000) #local P = function { pigment { bozo scale I } } #undef P #end");
        let n_known = functions.externals.lock().unwrap_or_else(PoisonError::into_inner).known.len();
        assert!((1..=64).contains(&n_known), "{n_known}");
    }
}
