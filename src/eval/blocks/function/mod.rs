//! `function … { … }`: bodies have an expression language of their own, which becomes a program.
//!
//! Section 2 of the function facts.

mod expression;

use super::pattern::no_list;
use crate::diag::{Diagnostic, SourceResult, Span};
use crate::eval::Evaluator;
use crate::function::{FunctionBody, Internal};
use crate::math::noise::NoiseGenerator;
use crate::scene::{Function, Pattern, PatternKind, Pigment, PointFunction, PointSource};
use crate::syntax::{Keyword as K, TokenKind};
use expression::program;
use std::rc::Rc;
use std::sync::Arc;

/// As POV-Ray has it.
const MAX_PARAMETERS: usize = 56;

impl Evaluator<'_> {
    /// `[(parameters)] { … }` after `function` in a declaration.
    pub(in crate::eval) fn function_block(&mut self) -> SourceResult<Arc<Function>> {
        let mut names: Vec<Rc<str>> = Vec::new();
        let span = self.span();
        let listed = self.accept_punct('(')?;
        if listed {
            while !self.accept_punct(')')? {
                names.push(self.parameter_name()?);
                self.comma()?;
            }
            if names.is_empty() || names.len() > MAX_PARAMETERS {
                return self.error(span, format!("a function takes 1 to {MAX_PARAMETERS} parameters"));
            }
        }
        self.open("function")?;
        let function = match self.keyword()? {
            Some(k @ (K::Pigment | K::Pattern | K::Transform | K::Spline | K::Internal)) => {
                if listed && k != K::Internal {
                    let word = k.word();
                    return self
                        .error(span, format!("a {word} function takes no parameter list; it is called at a point"));
                }
                self.special_body(k)?
            }
            _ if listed => program(self, &names)?,
            _ => program(self, &["x".into(), "y".into(), "z".into()])?,
        };
        self.close("function")?;
        Ok(Arc::new(function))
    }

    /// `{ expression }` of x, y and z, or any other body, after `function` in a pattern or object.
    pub(super) fn plain_function(&mut self) -> SourceResult<Arc<Function>> {
        self.open("function")?;
        let function = self.plain_function_items(&["x", "y", "z"])?;
        self.close("function")?;
        Ok(function)
    }

    /// The inside of a body whose braces are read by the caller.
    pub(super) fn plain_function_items(&mut self, names: &[&str]) -> SourceResult<Arc<Function>> {
        let function = match self.keyword()? {
            Some(k @ (K::Pigment | K::Pattern | K::Transform | K::Spline | K::Internal)) => self.special_body(k)?,
            _ => {
                let names: Vec<Rc<str>> = names.iter().map(|n| Rc::from(*n)).collect();
                program(self, &names)?
            }
        };
        Ok(Arc::new(function))
    }

    fn parameter_name(&mut self) -> SourceResult<Rc<str>> {
        let token = self.next()?;
        match &token.kind {
            TokenKind::Keyword(k @ (K::X | K::Y | K::Z | K::U | K::V)) => Ok(k.word().into()),
            TokenKind::Name(name) if self.names.get(*name).is_none() => Ok(self.names.words.word(*name).clone()),
            TokenKind::Name(name) => {
                let name = self.names.words.word(*name).clone();
                self.error(token.span, format!("'{name}' is already declared and cannot name a parameter"))
            }
            _ => self.error(token.span, "expected a parameter name"),
        }
    }

    fn special_body(&mut self, keyword: K) -> SourceResult<Function> {
        self.next()?;
        let span = self.span();
        let (n_parameters, body) = match keyword {
            K::Pigment => {
                let pigment = self.pigment_block(Pigment::default())?;
                (3, FunctionBody::External(self.point_function(PointSource::Pigment(pigment), span)?))
            }
            K::Pattern => {
                self.open("pattern")?;
                let mut pattern = Pattern::new(PatternKind::None);
                if !self.pattern_keyword(&mut pattern, &mut no_list)? {
                    return self.expected("a pattern");
                }
                while self.pattern_modifier(&mut pattern)? {
                    self.comma()?;
                }
                self.close("pattern")?;
                (3, FunctionBody::External(self.point_function(PointSource::Pattern(pattern), span)?))
            }
            K::Transform => (3, FunctionBody::Transform(self.transform_block()?)),
            K::Spline => (1, FunctionBody::Spline(self.spline_block()?)),
            _ => {
                self.expect_punct('(', "before the number of an internal function")?;
                let number = self.float()?;
                self.expect_punct(')', "to close it")?;
                let generator = self.noise_generator();
                let found = (number >= 0.0).then(|| Internal::new(number as u32, generator)).flatten();
                let Some(internal) = found else {
                    return self.error(span, format!("there is no internal function {number}"));
                };
                (3 + internal.n_extra(), FunctionBody::Internal(internal))
            }
        };
        Ok(Function { n_parameters, body })
    }

    /// A function of a pigment or pattern, with the settings of here; what is wrong with it stands at `span` at least.
    fn point_function(&self, source: PointSource, span: Span) -> SourceResult<Arc<PointFunction>> {
        let settings = Arc::new(self.scene.settings.clone());
        let function = Arc::new(PointFunction { source, settings });
        self.queries.check(&function).map_err(|wrong| {
            let span = wrong.span.or(Some(span));
            vec![self.with_trace(Diagnostic { span, ..wrong })]
        })?;
        Ok(function)
    }

    /// The scene's noise generator as it stands now.
    fn noise_generator(&self) -> NoiseGenerator {
        match self.scene.settings.noise_generator {
            Some(1) => NoiseGenerator::Original,
            Some(3) => NoiseGenerator::Perlin,
            None if self.version < 350 => NoiseGenerator::Original,
            _ => NoiseGenerator::Corrected,
        }
    }
}
