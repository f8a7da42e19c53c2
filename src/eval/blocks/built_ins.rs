//! Built-in functions as tables, for whoever asks what there is; [`crate::syntax::built_in`] is what readers go by.

use super::described::{Described, Table};
use crate::syntax::built_in::{BuiltIn, Gives, Place};

/// Some of the built-in functions.
pub(super) struct Functions {
    name: &'static str,
    help: &'static str,
    holds: fn(&BuiltIn) -> bool,
    parts: &'static [&'static dyn Table],
}

pub(super) static ALL: Functions = Functions {
    name: "functions",
    help: "built-in functions and constants",
    holds: |_| false,
    parts: &[&FLOATS, &VECTORS, &STRINGS, &IN_FUNCTIONS],
};

static FLOATS: Functions = Functions {
    name: "float functions",
    help: "functions and constants that give a float",
    holds: |built_in| built_in.gives == Gives::Float && built_in.place != Place::Functions,
    parts: &[],
};

static VECTORS: Functions = Functions {
    name: "vector functions",
    help: "functions and constants that give a vector",
    holds: |built_in| built_in.gives == Gives::Vector,
    parts: &[],
};

static STRINGS: Functions = Functions {
    name: "string functions",
    help: "functions that give a string",
    holds: |built_in| built_in.gives == Gives::String,
    parts: &[],
};

pub(super) static IN_FUNCTIONS: Functions = Functions {
    name: "function",
    help: "what may stand in function { … }, beside declared functions and floats",
    holds: |built_in| built_in.place != Place::Values,
    parts: &[],
};

impl Table for Functions {
    fn name(&self) -> &'static str {
        self.name
    }

    fn help(&self) -> &'static str {
        self.help
    }

    fn own_words(&self) -> Vec<Described> {
        let held = BuiltIn::all().iter().filter(|built_in| (self.holds)(built_in));
        held.map(|built_in| Described {
            word: built_in.word.word(),
            alias: None,
            takes: built_in.takes.text(),
            default: "",
            since: 0,
            help: built_in.help,
        })
        .collect()
    }

    fn parts(&self) -> &'static [&'static dyn Table] {
        self.parts
    }
}
