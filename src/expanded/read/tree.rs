//! The tree that pest makes of a text, taken apart item by item.

use super::scan::Scanner;
use crate::diag::{Diagnostic, FileId, Span};
use crate::math::{Color, DVec2, DVec3, DVec4, Rgb};
use pest::iterators::{Pair, Pairs};

/// The parser that pest makes from the grammar.
#[derive(pest_derive::Parser)]
#[grammar = "../grammar/scene.pest"]
pub(super) struct SceneParser;

/// A node of the tree.
pub(super) type Node<'t> = Pair<'t, Rule>;

/// A value, or what is wrong.
pub(super) type Read<T> = Result<T, Box<Diagnostic>>;

/// Where a node stands: an expanded scene is one file.
pub(super) fn place(node: &Node<'_>) -> Span {
    let span = node.as_span();
    Span { file: FileId(0), start: span.start() as u32, end: span.end() as u32 }
}

/// An error at a node.
pub(super) fn wrong<T>(node: &Node<'_>, message: impl Into<String>) -> Read<T> {
    Err(Box::new(Diagnostic::error(place(node), message)))
}

/// The children of a node that are still to come.
#[derive(Clone)]
pub(super) struct Items<'t> {
    pairs: Pairs<'t, Rule>,
    around: Span,
}

impl<'t> Items<'t> {
    pub(super) fn of(node: Node<'t>) -> Self {
        let around = place(&node);
        Self { pairs: node.into_inner(), around }
    }

    /// The next child.
    pub(super) fn node(&mut self) -> Read<Node<'t>> {
        let missing = || Box::new(Diagnostic::error(self.around, "something is missing here"));
        self.pairs.next().ok_or_else(missing)
    }

    /// The next child, if it is one of this rule.
    pub(super) fn optional(&mut self, rule: Rule) -> Option<Node<'t>> {
        let found = self.pairs.peek().filter(|node| node.as_rule() == rule);
        found.and_then(|_| self.pairs.next())
    }

    /// Whether the next child was of this rule; it is taken then.
    pub(super) fn accept(&mut self, rule: Rule) -> bool {
        self.optional(rule).is_some()
    }

    /// The rule of the next child.
    pub(super) fn peek(&self) -> Option<Rule> {
        self.pairs.peek().map(|node| node.as_rule())
    }

    /// The text of the next child.
    pub(super) fn word(&mut self) -> Read<&'t str> {
        Ok(self.node()?.as_str())
    }

    pub(super) fn number(&mut self) -> Read<f64> {
        number(&self.node()?)
    }

    pub(super) fn float(&mut self) -> Read<f32> {
        Ok(self.number()? as f32)
    }

    /// A whole number from 0 to that of a picture's pixels and more.
    pub(super) fn whole(&mut self) -> Read<u32> {
        let node = self.node()?;
        let value = number(&node)?;
        if value >= 0.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0 {
            return Ok(value as u32);
        }
        wrong(&node, "expected a whole number that is not negative")
    }

    /// The same within bounds.
    pub(super) fn whole_within(&mut self, least: u32, most: u32) -> Read<u32> {
        let node = self.node()?;
        let value = number(&node)?;
        if value >= f64::from(least) && value <= f64::from(most) && value.fract() == 0.0 {
            return Ok(value as u32);
        }
        wrong(&node, format!("expected a whole number from {least} to {most}"))
    }

    pub(super) fn vector(&mut self) -> Read<DVec3> {
        Ok(DVec3::from(components(&self.node()?)?))
    }

    pub(super) fn vector2(&mut self) -> Read<DVec2> {
        Ok(DVec2::from(components(&self.node()?)?))
    }

    pub(super) fn vector4(&mut self) -> Read<DVec4> {
        Ok(DVec4::from(components(&self.node()?)?))
    }

    pub(super) fn color(&mut self) -> Read<Color> {
        color(self.node()?)
    }

    pub(super) fn rgb(&mut self) -> Read<Rgb> {
        Ok(self.color()?.rgb)
    }

    /// `on` or `off`; a flag alone is on.
    pub(super) fn switch(&mut self) -> bool {
        self.optional(Rule::switch).is_none_or(|node| matches!(node.as_str(), "on" | "yes" | "true"))
    }
}

impl<'t> Iterator for Items<'t> {
    type Item = Node<'t>;

    fn next(&mut self) -> Option<Node<'t>> {
        self.pairs.next()
    }
}

/// The number that a node is.
pub(super) fn number(node: &Node<'_>) -> Read<f64> {
    Scanner::new(node).number()
}

/// The components of a vector, as many as belong there.
pub(super) fn components<const N: usize>(node: &Node<'_>) -> Read<[f64; N]> {
    let all = numbers(node)?;
    match <[f64; N]>::try_from(all) {
        Ok(components) => Ok(components),
        Err(all) => wrong(node, format!("expected a vector of {N} numbers, not of {}", all.len())),
    }
}

/// All components of a vector.
pub(super) fn numbers(node: &Node<'_>) -> Read<Vec<f64>> {
    Scanner::new(node).vector()
}

/// `rgb <…>` and its kin.
pub(super) fn color(node: Node<'_>) -> Read<Color> {
    let mut items = Items::of(node);
    let model = items.word()?;
    let vector = items.node()?;
    let c = |v: &[f64]| v.iter().map(|v| *v as f32).collect::<Vec<f32>>();
    let (rgb, filter, transmit) = match (model, &c(&numbers(&vector)?)[..]) {
        ("rgb", &[r, g, b]) => ([r, g, b], 0.0, 0.0),
        ("rgbf", &[r, g, b, filter]) => ([r, g, b], filter, 0.0),
        ("rgbt", &[r, g, b, transmit]) => ([r, g, b], 0.0, transmit),
        ("rgbft", &[r, g, b, filter, transmit]) => ([r, g, b], filter, transmit),
        _ => return wrong(&vector, format!("'{model}' takes as many numbers as it has letters")),
    };
    Ok(Color { rgb: Rgb::from(rgb), filter, transmit })
}

/// The name in a file's literal, in which a backslash is itself.
pub(super) fn file_name<'t>(node: &Node<'t>) -> &'t str {
    let text = node.as_str();
    text.get(1..text.len().saturating_sub(1)).unwrap_or_default()
}
