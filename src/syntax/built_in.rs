//! Built-in functions and constants: which words they are, what they take and what they give.
//!
//! Whoever reads expressions goes by this table: values as tokens arrive, trees ([`super::formula`]), functions; so do advice
//! and documentation. What a function calculates is with those who call it.

use super::Keyword as K;

/// A built-in function or constant.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// Its name.
    pub word: K,
    /// What stands behind the name.
    pub takes: Takes,
    /// What it gives.
    pub gives: Gives,
    /// Where it may stand.
    pub place: Place,
    /// What it gives, in one line.
    pub help: &'static str,
}

/// What stands behind a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Takes {
    /// Nothing: it is this number.
    Number(f64),
    /// Nothing: it is this vector of so many components.
    Axis([f64; 4], u8),
    /// Nothing: it is something about the scene or the world.
    State,
    /// One float, or a comparison.
    Float,
    /// Two floats.
    TwoFloats,
    /// One float or more.
    Floats,
    /// Three floats or four.
    Choice,
    /// So many vectors, and then so many floats.
    Vectors(usize, usize),
    /// Something of its own, in the manual's words.
    Other(&'static str),
}

/// What a function gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Gives {
    Float,
    Vector,
    String,
}

/// Where a function may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Where values are written.
    Values,
    /// In `function { … }`.
    Functions,
    /// In both.
    Both,
}

impl BuiltIn {
    /// All of them, in the order in which people look for them.
    pub fn all() -> &'static [Self] {
        TABLE
    }

    /// That of a word.
    #[inline]
    pub fn of(word: K) -> Option<&'static Self> {
        TABLE.get(usize::from(NUMBERS[word as usize]).checked_sub(1)?)
    }

    /// That of a word, where values are written.
    #[inline]
    pub fn in_values(word: K) -> Option<&'static Self> {
        Self::of(word).filter(|built_in| built_in.place != Place::Functions)
    }

    /// That of a word, in functions.
    pub fn in_functions(word: K) -> Option<&'static Self> {
        Self::of(word).filter(|built_in| built_in.place != Place::Values)
    }

    /// Whether it stands without arguments.
    pub fn is_constant(&self) -> bool {
        matches!(self.takes, Takes::Number(_) | Takes::Axis(..) | Takes::State)
    }
}

impl Takes {
    /// In the words of the manual.
    pub fn text(self) -> &'static str {
        match self {
            Self::Number(_) | Self::Axis(..) | Self::State => "",
            Self::Float => "(FLOAT)",
            Self::TwoFloats => "(FLOAT, FLOAT)",
            Self::Floats => "(FLOAT, …)",
            Self::Choice => "(FLOAT, LESS, EQUAL [, GREATER])",
            Self::Vectors(1, _) => "(VECTOR)",
            Self::Vectors(_, 0) => "(VECTOR, VECTOR)",
            Self::Vectors(..) => "(VECTOR, VECTOR, FLOAT)",
            Self::Other(text) => text,
        }
    }
}

/// For each keyword the number of its function, counted from 1.
static NUMBERS: [u8; K::ALL.len()] = {
    let mut numbers = [0; K::ALL.len()];
    let mut i = 0;
    while i < TABLE.len() {
        assert!(numbers[TABLE[i].word as usize] == 0, "a function stands twice in the table");
        numbers[TABLE[i].word as usize] = i as u8 + 1;
        i += 1;
    }
    numbers
};

const fn number(word: K, value: f64, help: &'static str) -> BuiltIn {
    BuiltIn { word, takes: Takes::Number(value), gives: Gives::Float, place: Place::Values, help }
}

const fn axis(word: K, value: [f64; 4], n: u8, place: Place, help: &'static str) -> BuiltIn {
    BuiltIn { word, takes: Takes::Axis(value, n), gives: Gives::Vector, place, help }
}

/// A function of floats, which may stand in functions, too.
const fn float(word: K, takes: Takes, help: &'static str) -> BuiltIn {
    BuiltIn { word, takes, gives: Gives::Float, place: Place::Both, help }
}

const fn value(word: K, takes: Takes, gives: Gives, help: &'static str) -> BuiltIn {
    BuiltIn { word, takes, gives, place: Place::Values, help }
}

const TABLE: &[BuiltIn] = {
    use Gives::{Float, String, Vector};
    use Place::{Both, Functions, Values};
    use Takes::{Choice, Floats, Other, State, TwoFloats, Vectors};
    &[
        BuiltIn { place: Both, ..number(K::Pi, std::f64::consts::PI, "3.14159…") },
        number(K::True, 1.0, "1"),
        number(K::Yes, 1.0, "1"),
        number(K::On, 1.0, "1"),
        number(K::False, 0.0, "0"),
        number(K::No, 0.0, "0"),
        number(K::Off, 0.0, "0"),
        float(K::Clock, State, "where in an animation the picture is, mostly from 0 to 1"),
        value(K::ClockOn, State, Float, "whether this is a picture of an animation"),
        value(K::Version, State, Float, "the version of the language in force"),
        value(K::Now, State, Float, "days since 1 January 2000, at Greenwich"),
        float(K::Abs, Takes::Float, "without its sign"),
        float(K::Acos, Takes::Float, "arc cosine, in radians"),
        float(K::Acosh, Takes::Float, "inverse hyperbolic cosine"),
        float(K::Asin, Takes::Float, "arc sine, in radians"),
        float(K::Asinh, Takes::Float, "inverse hyperbolic sine"),
        float(K::Atan, Takes::Float, "arc tangent, in radians"),
        float(K::Atanh, Takes::Float, "inverse hyperbolic tangent"),
        float(K::Atan2, TwoFloats, "the angle of a point, given as y and x, in radians"),
        value(K::BitwiseAnd, Other("(INTEGER, …)"), Float, "the bits that all have"),
        value(K::BitwiseOr, Other("(INTEGER, …)"), Float, "the bits that any has"),
        value(K::BitwiseXor, Other("(INTEGER, …)"), Float, "the bits that an odd number of them has"),
        float(K::Ceil, Takes::Float, "the next whole number that is not below it"),
        float(K::Cos, Takes::Float, "cosine of an angle in radians"),
        float(K::Cosh, Takes::Float, "hyperbolic cosine"),
        float(K::Degrees, Takes::Float, "radians in degrees"),
        float(K::Div, TwoFloats, "the quotient without its fraction"),
        float(K::Exp, Takes::Float, "e to a power"),
        float(K::Floor, Takes::Float, "the next whole number that is not above it"),
        float(K::Int, Takes::Float, "without its fraction"),
        float(K::Ln, Takes::Float, "natural logarithm"),
        float(K::Log, Takes::Float, "logarithm to the base 10"),
        float(K::Max, Floats, "the largest"),
        float(K::Min, Floats, "the smallest"),
        float(K::Mod, TwoFloats, "what is left by a division"),
        float(K::Pow, TwoFloats, "a power"),
        float(K::Radians, Takes::Float, "degrees in radians"),
        float(K::Select, Choice, "by whether the first is below 0, 0, or above 0"),
        float(K::Sin, Takes::Float, "sine of an angle in radians"),
        float(K::Sinh, Takes::Float, "hyperbolic sine"),
        float(K::Sqrt, Takes::Float, "square root"),
        float(K::Tan, Takes::Float, "tangent of an angle in radians"),
        float(K::Tanh, Takes::Float, "hyperbolic tangent"),
        value(K::Seed, Other("(INTEGER)"), Float, "a new stream of random numbers, for rand"),
        value(K::Rand, Takes::Float, Float, "the next random number of a stream, from 0 to 1"),
        BuiltIn {
            place: Functions,
            ..float(K::Sum, Other("(NAME, FROM, TO, FLOAT)"), "the sum for all values of a name")
        },
        BuiltIn {
            place: Functions,
            ..float(K::Prod, Other("(NAME, FROM, TO, FLOAT)"), "the product for all values of a name")
        },
        value(K::Vdot, Vectors(2, 0), Float, "scalar product"),
        value(K::Vlength, Vectors(1, 0), Float, "how long it is"),
        value(K::Inside, Other("(OBJECT, VECTOR)"), Float, "whether a point is inside of an object"),
        value(K::Defined, Other("(NAME)"), Float, "whether a name, or an element of an array, has a value"),
        value(K::Dimensions, Other("(ARRAY)"), Float, "how many indices an array has"),
        value(
            K::DimensionSize,
            Other("(ARRAY, INTEGER)"),
            Float,
            "how large one dimension of an array is, counted from 1",
        ),
        value(K::FileExists, Other("(STRING)"), Float, "whether there is a file of that name"),
        value(K::Asc, Other("(STRING)"), Float, "the code of the first character"),
        value(K::Strcmp, Other("(STRING, STRING)"), Float, "below 0, 0 or above 0 by which comes first"),
        value(K::Strlen, Other("(STRING)"), Float, "how many characters it has"),
        value(K::Val, Other("(STRING)"), Float, "the number that a string begins with"),
        axis(K::X, [1.0, 0.0, 0.0, 0.0], 3, Both, "<1, 0, 0>; in functions the argument of that name"),
        axis(K::Y, [0.0, 1.0, 0.0, 0.0], 3, Both, "<0, 1, 0>; in functions the argument of that name"),
        axis(K::Z, [0.0, 0.0, 1.0, 0.0], 3, Both, "<0, 0, 1>; in functions the argument of that name"),
        axis(K::T, [0.0, 0.0, 0.0, 1.0], 4, Values, "<0, 0, 0, 1>"),
        axis(K::U, [1.0, 0.0, 0.0, 0.0], 2, Both, "<1, 0>; in functions the argument of that name"),
        axis(K::V, [0.0, 1.0, 0.0, 0.0], 2, Both, "<0, 1>; in functions the argument of that name"),
        value(K::Vcross, Vectors(2, 0), Vector, "vector product"),
        value(K::Vnormalize, Vectors(1, 0), Vector, "at length 1"),
        value(K::Vrotate, Vectors(2, 0), Vector, "turned about x, then y, then z, in degrees"),
        value(K::VaxisRotate, Vectors(2, 1), Vector, "turned about an axis, in degrees"),
        value(K::Vturbulence, Other("(LAMBDA, OMEGA, OCTAVES, VECTOR)"), Vector, "how far turbulence moves a point"),
        value(
            K::Trace,
            Other("(OBJECT, FROM, DIRECTION [, NAME])"),
            Vector,
            "where a ray meets an object; its normal goes to a name",
        ),
        value(K::MinExtent, Other("(OBJECT)"), Vector, "the lower corner of an object's box"),
        value(
            K::MaxExtent,
            Other("(OBJECT | PIGMENT)"),
            Vector,
            "the upper corner of an object's box; the size of a picture",
        ),
        value(K::Chr, Other("(INTEGER)"), String, "the character of a code"),
        value(K::Concat, Other("(STRING, …)"), String, "strings one behind the other"),
        value(K::Datetime, Other("(DAYS [, FORMAT])"), String, "a date, of days as now counts them"),
        value(K::Str, Other("(FLOAT, WIDTH, DECIMALS)"), String, "a number as text"),
        value(K::Strlwr, Other("(STRING)"), String, "in small letters"),
        value(K::Strupr, Other("(STRING)"), String, "in capital letters"),
        value(K::Substr, Other("(STRING, FIRST, LENGTH)"), String, "a part of a string, counted from 1"),
        value(K::Vstr, Other("(N, VECTOR, SEPARATOR, WIDTH, DECIMALS)"), String, "a vector as text"),
    ]
};

#[cfg(test)]
mod tests {
    use super::{BuiltIn, Gives, Place, Takes};
    use crate::syntax::Keyword as K;

    #[test]
    fn words_find_their_functions() {
        let of = |word| BuiltIn::of(word).map(|b| (b.takes, b.gives, b.place));
        assert_eq!(of(K::Vdot), Some((Takes::Vectors(2, 0), Gives::Float, Place::Values)));
        assert_eq!(of(K::Sphere), None);
        assert!(BuiltIn::in_values(K::Sum).is_none() && BuiltIn::in_functions(K::Sum).is_some());
        assert!(BuiltIn::in_values(K::Vdot).is_some() && BuiltIn::in_functions(K::Vdot).is_none());
        assert!(BuiltIn::all().iter().all(|b| BuiltIn::of(b.word).is_some_and(|found| found.word == b.word)));
    }
}
