//! The grammar of expressions, one for everything that is built of them: values as their tokens arrive
//! (`eval::expressions`), trees for loops ([`super::formula`]), programs of functions (`eval::blocks::function`).
//!
//! ```text
//! expression = chain [ "?" expression ":" expression ]          (not in functions)
//! chain      = operand { operator operand }                     (by strength, then from left to right)
//! ```
//!
//! All operators stand in one table, with what they take and how strongly they bind. What an operand is differs: the
//! one who builds reads it, with the signs in front of it.
//!
//! Source: language facts, sections 4 and 5; function facts, section 2.

use super::{Keyword, TokenKind};

/// How strongly an operator binds, weakest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Strength {
    /// `|`, and in values `&`.
    Or,
    /// `&` in functions.
    And,
    /// `< <= = != >= >`.
    Comparison,
    /// `+ -`.
    Sum,
    /// `* /`.
    Product,
    /// Stronger than any operator: an operand alone.
    Operand,
}

/// Where an expression stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Anywhere but in functions: the expression has a value.
    Values,
    /// In `function { … }`.
    Functions,
}

/// What an operator takes, and gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operands {
    /// Two truths to a truth.
    Truths,
    /// Two numbers, component by component, to truths; outside of functions also two strings to a truth.
    Ordered,
    /// Two numbers to a number, component by component.
    Numbers,
}

macro_rules! operators {
    ($($(#[$doc:meta])* $name:ident $sign:literal $token:pat, $values:ident $functions:ident $operands:ident;)*) => {
        /// Operators of two operands.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Operator {
            $($(#[$doc])* $name,)*
        }

        impl Operator {
            /// All of them, as in the table.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// The operator that a token is.
            #[inline]
            pub fn of(token: TokenKind) -> Option<Self> {
                match token {
                    $($token => Some(Self::$name),)*
                    _ => None,
                }
            }

            /// How strongly it binds.
            #[inline]
            pub const fn strength(self, language: Language) -> Strength {
                match (self, language) {
                    $((Self::$name, Language::Values) => Strength::$values,
                    (Self::$name, Language::Functions) => Strength::$functions,)*
                }
            }

            /// What it takes and gives.
            pub const fn operands(self) -> Operands {
                match self {
                    $(Self::$name => Operands::$operands,)*
                }
            }

            /// How it is written.
            pub const fn sign(self) -> &'static str {
                match self {
                    $(Self::$name => $sign,)*
                }
            }
        }
    };
}

operators! {
    // Name       Written  As a token               In values  functions   What it takes
    /// Sum.
    Add           "+"      TokenKind::Punct('+'),   Sum        Sum         Numbers;
    /// Difference.
    Subtract      "-"      TokenKind::Punct('-'),   Sum        Sum         Numbers;
    /// Product.
    Multiply      "*"      TokenKind::Punct('*'),   Product    Product     Numbers;
    /// Quotient.
    Divide        "/"      TokenKind::Punct('/'),   Product    Product     Numbers;
    /// Less.
    Less          "<"      TokenKind::Punct('<'),   Comparison Comparison  Ordered;
    /// Less or equal.
    AtMost        "<="     TokenKind::OrEqual('<'), Comparison Comparison  Ordered;
    /// Equal.
    Equal         "="      TokenKind::Punct('='),   Comparison Comparison  Ordered;
    /// Not equal.
    Differs       "!="     TokenKind::OrEqual('!'), Comparison Comparison  Ordered;
    /// Greater or equal.
    AtLeast       ">="     TokenKind::OrEqual('>'), Comparison Comparison  Ordered;
    /// Greater.
    Greater       ">"      TokenKind::Punct('>'),   Comparison Comparison  Ordered;
    /// Both; each side is evaluated.
    And           "&"      TokenKind::Punct('&'),   Or         And         Truths;
    /// One of them or both; each side is evaluated.
    Or            "|"      TokenKind::Punct('|'),   Or         Or          Truths;
}

impl Strength {
    /// What the right side of an operator binds with: those of one strength go from left to right.
    #[inline]
    const fn tighter(self) -> Self {
        match self {
            Self::Or => Self::And,
            Self::And => Self::Comparison,
            Self::Comparison => Self::Sum,
            Self::Sum => Self::Product,
            Self::Product | Self::Operand => Self::Operand,
        }
    }
}

/// Which component of an operand a word behind a dot means; `gray`, which is none, is for who builds.
pub fn component(word: Keyword) -> Option<u8> {
    Some(match word {
        Keyword::X | Keyword::U | Keyword::Red => 0,
        Keyword::Y | Keyword::V | Keyword::Green => 1,
        Keyword::Z | Keyword::Blue => 2,
        Keyword::T | Keyword::Filter => 3,
        Keyword::Transmit => 4,
        _ => return None,
    })
}

/// Reads operands and operators, and makes something of them.
pub trait Build {
    /// What it makes.
    type Built;
    /// What surrounds an operand asks of it.
    type Place: Copy;
    /// Where an expression or operator stands, for messages.
    type Mark;
    /// Why it cannot go on.
    type Stop;
    /// Whose operators these are.
    const LANGUAGE: Language;

    /// The operator that comes next; not taken.
    ///
    /// # Errors
    /// Those of what stands in front of it.
    fn operator(&mut self) -> Result<Option<Operator>, Self::Stop>;

    /// Takes the operator that comes next.
    fn take_operator(&mut self) -> Self::Mark;

    /// An operand with the signs in front of it and the component behind it.
    ///
    /// # Errors
    /// When none comes next.
    fn operand(&mut self, place: Self::Place) -> Result<Self::Built, Self::Stop>;

    /// A comparison of what are no numbers, if one comes next.
    ///
    /// # Errors
    /// When it begins and is not whole.
    #[inline]
    fn comparison(&mut self, _place: Self::Place) -> Result<Option<Self::Built>, Self::Stop> {
        Ok(None)
    }

    /// What is asked of an operand on the right of that, in the same place.
    #[inline]
    fn beside(place: Self::Place, _left: &Self::Built) -> Self::Place {
        place
    }

    /// Puts both sides of an operator together, in place of the left one.
    ///
    /// # Errors
    /// When they do not fit.
    fn combine(
        &mut self,
        operator: Operator,
        left: &mut Self::Built,
        right: Self::Built,
        mark: Self::Mark,
    ) -> Result<(), Self::Stop>;
}

/// Builds choices, too: `condition ? yes : no`.
pub trait Choose: Build {
    /// Where the expression begins that comes next.
    ///
    /// # Errors
    /// Those of what stands in front of it.
    fn start(&mut self) -> Result<Self::Mark, Self::Stop>;

    /// Takes a `?` if one comes next.
    ///
    /// # Errors
    /// Those of what stands in front of it.
    fn accept_question(&mut self) -> Result<bool, Self::Stop>;

    /// Both sides of the `:` behind a condition that began at `start`, and what is chosen.
    ///
    /// # Errors
    /// When there are none, or the condition is none.
    fn choose(
        &mut self,
        condition: Self::Built,
        start: Self::Mark,
        place: Self::Place,
    ) -> Result<Self::Built, Self::Stop>;
}

/// An expression with all that the language has.
///
/// # Errors
/// Those of its parts.
#[inline]
pub fn expression<B: Choose>(build: &mut B, place: B::Place) -> Result<B::Built, B::Stop> {
    let start = build.start()?;
    let condition = chain(build, Strength::Or, place)?;
    if build.accept_question()? { build.choose(condition, start, place) } else { Ok(condition) }
}

/// Operands with operators between them that bind as strongly as `least` or more.
///
/// # Errors
/// Those of its parts.
pub fn chain<B: Build>(build: &mut B, least: Strength, place: B::Place) -> Result<B::Built, B::Stop> {
    if least <= Strength::Comparison
        && let Some(mut compared) = build.comparison(place)?
    {
        go_on(build, &mut compared, least, Strength::And, place)?;
        return Ok(compared);
    }
    let mut left = build.operand(place)?;
    if least < Strength::Operand {
        go_on(build, &mut left, least, Strength::Product, place)?;
    }
    Ok(left)
}

/// Goes on behind what stands left of an operator, with operators from `least` to `most`.
///
/// # Errors
/// Those of the parts that follow.
#[inline]
pub fn go_on<B: Build>(
    build: &mut B,
    left: &mut B::Built,
    least: Strength,
    mut most: Strength,
    place: B::Place,
) -> Result<(), B::Stop> {
    while let Some(operator) = build.operator()? {
        let strength = operator.strength(B::LANGUAGE);
        if strength < least || strength > most {
            break;
        }
        let mark = build.take_operator();
        let beside = B::beside(place, left);
        let right = chain(build, strength.tighter(), beside)?;
        build.combine(operator, left, right, mark)?;
        most = strength;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Build, Choose, Language, Operands, Operator, Strength, chain, expression};
    use crate::syntax::TokenKind;

    /// Puts brackets around everything; operands are letters, a digit is a comparison of its own.
    struct Brackets<'t, const FUNCTIONS: bool>(&'t str);

    impl<const FUNCTIONS: bool> Build for Brackets<'_, FUNCTIONS> {
        type Built = String;
        type Place = ();
        type Mark = ();
        type Stop = &'static str;
        const LANGUAGE: Language = if FUNCTIONS { Language::Functions } else { Language::Values };

        fn operator(&mut self) -> Result<Option<Operator>, Self::Stop> {
            let known =
                |o: &&Operator| self.0.starts_with(o.sign()) && !(o.sign().len() == 1 && self.0[1..].starts_with('='));
            Ok(Operator::ALL.iter().find(known).copied())
        }

        fn take_operator(&mut self) {
            let length = self.operator().ok().flatten().map_or(0, |o| o.sign().len());
            self.0 = &self.0[length..];
        }

        fn operand(&mut self, (): ()) -> Result<String, Self::Stop> {
            let first = self.0.chars().next().filter(char::is_ascii_alphabetic).ok_or("no operand")?;
            self.0 = &self.0[1..];
            Ok(first.into())
        }

        fn comparison(&mut self, (): ()) -> Result<Option<String>, Self::Stop> {
            let Some(digit) = self.0.chars().next().filter(char::is_ascii_digit) else { return Ok(None) };
            self.0 = &self.0[1..];
            Ok(Some(digit.into()))
        }

        fn combine(&mut self, o: Operator, left: &mut String, right: String, (): ()) -> Result<(), Self::Stop> {
            *left = format!("({left}{}{right})", o.sign());
            Ok(())
        }
    }

    impl<const FUNCTIONS: bool> Choose for Brackets<'_, FUNCTIONS> {
        fn start(&mut self) -> Result<(), Self::Stop> {
            Ok(())
        }

        fn accept_question(&mut self) -> Result<bool, Self::Stop> {
            let rest = self.0.strip_prefix('?');
            self.0 = rest.unwrap_or(self.0);
            Ok(rest.is_some())
        }

        fn choose(&mut self, condition: String, (): (), (): ()) -> Result<String, Self::Stop> {
            let yes = expression(self, ())?;
            self.0 = self.0.strip_prefix(':').ok_or("no colon")?;
            Ok(format!("({condition}?{yes}:{})", expression(self, ())?))
        }
    }

    /// The text with brackets, and what was left of it behind a blank.
    fn check(text: &str, expected: &str) {
        let mut brackets = Brackets::<false>(text);
        let built = expression(&mut brackets, ()).unwrap_or_else(str::to_owned);
        assert_eq!(format!("{built} {}", brackets.0).trim_end(), expected, "{text}");
    }

    #[test]
    fn stronger_operators_come_first_then_those_on_the_left() {
        check("a", "a");
        check("a-b-c", "((a-b)-c)");
        check("a+b*c/d-e", "((a+((b*c)/d))-e)");
        check("a*b<c+d", "((a*b)<(c+d))");
        check("a<b<=c", "((a<b)<=c)");
        check("a=b&c!=d|e", "(((a=b)&(c!=d))|e)");
        check("a&b|c&d", "(((a&b)|c)&d)");
        check("a?b+c:d?e:f", "(a?(b+c):(d?e:f))");
        check("a+", "no operand");
        check("a?b", "no colon");
    }

    #[test]
    fn in_functions_and_binds_more_strongly_than_or() {
        let mut brackets = Brackets::<true>("a|b&c=d");
        assert_eq!(chain(&mut brackets, Strength::Or, ()), Ok("(a|(b&(c=d)))".into()));
    }

    #[test]
    fn a_chain_ends_at_what_binds_less() {
        let mut brackets = Brackets::<false>("a+b<c");
        assert_eq!(chain(&mut brackets, Strength::Sum, ()), Ok("(a+b)".into()));
        assert_eq!(brackets.0, "<c");
    }

    #[test]
    fn behind_a_comparison_of_other_things_only_logic_follows() {
        check("1&a", "(1&a)");
        check("a|1&2", "((a|1)&2)");
        check("1+a", "1 +a");
        check("1=a", "1 =a");
        check("a&1*b", "(a&1) *b");
        check("a+1", "no operand 1");
    }

    #[test]
    fn each_token_is_one_operator() {
        assert_eq!(Operator::of(TokenKind::Punct('&')), Some(Operator::And));
        assert_eq!(Operator::of(TokenKind::OrEqual('!')), Some(Operator::Differs));
        assert_eq!(Operator::of(TokenKind::Punct('?')), None);
        for operator in Operator::ALL {
            let ordered = operator.strength(Language::Values) == Strength::Comparison;
            assert_eq!(operator.operands() == Operands::Ordered, ordered, "{}", operator.sign());
        }
    }
}
