use super::{Names, Place};
use crate::eval::Value;
use crate::syntax::Symbol;

fn float(names: &Names, name: Symbol) -> Option<f64> {
    names.find(name)?.get()?.number().map(|n| n.v[0])
}

#[test]
fn inner_tables_hide_outer_ones_until_they_close() {
    let (mut names, name) = (Names::default(), Symbol(3));
    names.bind(Names::GLOBAL, name, Place::new(Value::Float(1.0)));
    names.push();
    let inner = names.innermost();
    assert!(names.find_innermost(name).is_none());
    names.bind(inner, name, Place::new(Value::Float(2.0)));
    assert_eq!(float(&names, name), Some(2.0));
    names.pop();
    assert_eq!(float(&names, name), Some(1.0));
    names.push();
    names.bind(inner, name, Place::new(Value::Float(3.0)));
    assert_eq!(float(&names, name), Some(1.0), "a closed table takes nothing");
}

#[test]
fn a_global_made_under_a_local_stays_hidden() {
    let (mut names, name) = (Names::default(), Symbol(0));
    names.push();
    names.bind(names.innermost(), name, Place::new(Value::Float(1.0)));
    names.bind(Names::GLOBAL, name, Place::new(Value::Float(2.0)));
    assert_eq!(float(&names, name), Some(1.0));
    names.pop();
    assert_eq!(float(&names, name), Some(2.0));
    assert!(names.unbind(name) && !names.unbind(name));
}

#[test]
fn names_are_described_by_what_they_stand_for() {
    let mut names = Names::default();
    let [a, b] = ["A", "B"].map(|word| names.words.intern(word));
    names.bind(Names::GLOBAL, a, Place::new(Value::Float(2.0)));
    assert_eq!(names.describe(a), "the float 'A'");
    assert_eq!(names.describe(b), "the undeclared name 'B'");
    assert_eq!((names.number(a).map(|n| n.v[0]), names.number(b)), (Some(2.0), None));
    assert!(names.stands_for(a, |value| matches!(value, Value::Float(_))) && !names.stands_for(b, |_| true));
    assert!(names.macro_named(a).is_none() && !names.is_macro(a));
}

#[test]
fn deprecated_names_are_warned_of_always_or_once() {
    let mut names = Names::default();
    let [a, b] = ["A", "B"].map(|word| names.words.intern(word));
    assert!(!names.any_deprecated() && names.deprecation(a).is_none());
    names.deprecate(a, true, "old".into());
    names.deprecate(b, false, "older".into());
    let said: Vec<_> = [a, a, b, b].into_iter().filter_map(|name| names.deprecation(name)).collect();
    assert_eq!(said, ["old", "older", "older"].map(std::rc::Rc::from));
}

#[test]
fn what_was_never_used_is_known() {
    let mut names = Names::default();
    let [a, b] = ["A", "B"].map(|word| names.words.intern(word));
    names.bind(Names::GLOBAL, a, Place::new(Value::Float(1.0)));
    names.bind(Names::GLOBAL, b, Place::new(Value::Float(2.0)));
    names.note_use(a);
    assert_eq!(names.unused().filter_map(Place::float).collect::<Vec<_>>(), [2.0]);
}
