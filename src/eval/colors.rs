//! Colour expressions.

use super::{Evaluator, Number, Value};
use crate::diag::{SourceResult, Span, Topic};
use crate::math::{Color, Rgb};
use crate::scene::{Gamma, Working};
use crate::syntax::{Keyword, TokenKind};

#[allow(clippy::missing_errors_doc)]
impl Evaluator<'_> {
    /// Whether the next token can start a colour.
    pub fn starts_color(&mut self) -> SourceResult<bool> {
        Ok(match self.fill(false)? {
            TokenKind::Keyword(word) if is_color_word(word) => true,
            _ => self.starts_expression()?,
        })
    }

    /// A colour in any notation.
    pub fn color(&mut self) -> SourceResult<Color> {
        self.color_number().map(|number| Color::from_array(number.v))
    }

    /// A colour of which only red, green and blue count; warns if it has more.
    pub fn rgb_only(&mut self, what: &str) -> SourceResult<Rgb> {
        self.fill(false)?;
        let span = self.span();
        let color = self.color()?;
        // A lone float fills all five components; that is meant as a grey.
        let [red, rest @ ..] = color.to_array();
        if (color.filter != 0.0 || color.transmit != 0.0) && rest != [red; 4] {
            self.warn_here(Topic::Ignored, span, format!("filter and transmit have no meaning in {what}"));
        }
        Ok(color.rgb)
    }

    /// A colour at full precision, always five components wide.
    pub(super) fn color_number(&mut self) -> SourceResult<Number> {
        let introduced = match self.keyword()? {
            Some(Keyword::Color | Keyword::Colour) => {
                self.take();
                true
            }
            _ => false,
        };
        let first = match self.keyword()? {
            Some(word) if color_model(word).is_some() => self.model_color()?,
            Some(word) if is_component(word) => Number { n: 5, v: [0.0; 5] },
            _ if self.starts_expression()? => self.full(5)?,
            _ if introduced => Number { n: 5, v: [0.0; 5] },
            _ => return self.expected("a colour"),
        };
        self.color_components(first)
    }

    /// `red F`, `filter F` and so on behind a colour, overwriting its components.
    pub(super) fn color_components(&mut self, color: Number) -> SourceResult<Number> {
        let mut color = color.widened(5);
        while let TokenKind::Keyword(word) = self.fill(self.bare)? {
            let index = match word {
                Keyword::Red => 0,
                Keyword::Green => 1,
                Keyword::Blue => 2,
                Keyword::Filter | Keyword::Alpha => 3,
                Keyword::Transmit => 4,
                _ => break,
            };
            if word == Keyword::Alpha {
                let span = self.span();
                self.warn_here(Topic::Outdated, span, "'alpha' is an old word for 'filter'");
            }
            self.take();
            color.v[index] = self.float()?;
        }
        Ok(color)
    }

    /// `rgb E` and its relatives.
    fn model_color(&mut self) -> SourceResult<Number> {
        let Some((n, srgb)) = self.keyword()?.and_then(color_model) else { return self.expected("a colour") };
        let transmit = matches!(self.keyword()?, Some(Keyword::Rgbt | Keyword::Srgbt));
        let span = self.span();
        self.take();
        let given = self.full(n)?;
        if given.n > n {
            self.warn_here(
                Topic::Ignored,
                span,
                format!("this colour has {} components where {n} are wanted", given.n),
            );
        }
        let mut v = given.v;
        if transmit {
            (v[3], v[4]) = (0.0, v[3]);
        }
        if srgb {
            self.to_working_gamma(&mut v, span)?;
        }
        Ok(Number { n: 5, v })
    }

    /// Takes sRGB values to the gamma the scene works in.
    fn to_working_gamma(&self, v: &mut [f64; 5], span: Span) -> SourceResult<()> {
        let working = match self.scene.settings.gamma {
            Gamma::Linear(working) if self.defaults.gamma_given => working,
            _ => {
                return self.error_with_hint(
                    span,
                    "srgb colours need to know what gamma the scene works in",
                    "write global_settings { assumed_gamma 1 } before",
                );
            }
        };
        if let Working::Power(gamma) = working {
            for c in &mut v[..3] {
                // Source: IEC 61966-2-1.
                let linear = if *c <= 0.04045 { *c / 12.92 } else { ((*c + 0.055) / 1.055).powf(2.4) };
                // A power has no value below 0: it yields 0, as when pictures are read and when this one is written.
                *c = if working.is_linear() { linear } else { linear.max(0.0).powf(1.0 / gamma) };
            }
        }
        Ok(())
    }

    /// The declared colour or number that comes next, with what may follow it, as a value.
    pub(super) fn color_value(&mut self) -> SourceResult<Value> {
        self.color_number().map(Value::from)
    }
}

/// Width of the expression behind a colour model, and whether it is sRGB.
fn color_model(word: Keyword) -> Option<(u8, bool)> {
    Some(match word {
        Keyword::Rgb => (3, false),
        Keyword::Rgbf | Keyword::Rgbt => (4, false),
        Keyword::Rgbft => (5, false),
        Keyword::Srgb => (3, true),
        Keyword::Srgbf | Keyword::Srgbt => (4, true),
        Keyword::Srgbft => (5, true),
        _ => return None,
    })
}

fn is_component(word: Keyword) -> bool {
    matches!(word, Keyword::Red | Keyword::Green | Keyword::Blue | Keyword::Filter | Keyword::Transmit | Keyword::Alpha)
}

/// Whether a colour may start with that word and nothing else may.
pub(super) fn is_color_word(word: Keyword) -> bool {
    matches!(word, Keyword::Color | Keyword::Colour) || color_model(word).is_some() || is_component(word)
}

#[cfg(test)]
mod tests {
    use crate::eval::host::NoQueries;
    use crate::eval::{Memory, Options, evaluate};

    /// POV-Ray printed these.
    #[test]
    fn srgb_in_the_gamma_of_the_scene() {
        for (gamma, expected) in [
            ("1", "-0.0774 0.214 2.5372"),
            ("1.0099", "-0.0774 0.214 2.5372"),
            ("1.011", "0.0000 0.218 2.5116"),
            ("0.98", "0.0000 0.207 2.5858"),
            ("2", "0.0000 0.463 1.5928"),
            ("srgb", "-1.0000 0.500 1.5000"),
        ] {
            let text = format!(
                "#version 3.7; global_settings {{ assumed_gamma {gamma} }} #declare C = srgb <-1, 0.5, 1.5>;
                #debug concat(str(C.red, 0, 4), \" \", str(C.green, 0, 3), \" \", str(C.blue, 0, 4))"
            );
            let host = Memory::new([("a.pov", text.as_str())]);
            assert!(evaluate("a.pov".as_ref(), &Options::default(), &host, &NoQueries).is_ok(), "{text}");
            assert_eq!(host.messages(), expected, "{gamma}");
        }
    }
}
