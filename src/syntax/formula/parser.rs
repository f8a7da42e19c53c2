//! From tokens to a tree.

use super::{Demand, Formula, List, MacroCall, Node, NodeId, Operator};
use crate::syntax::vectors::read_vector;
use crate::syntax::{Directive, Keyword, Symbol, Token, TokenKind};

/// Longer expressions are rare in loops, and nesting is bounded by this too.
const MAX_TOKENS: usize = 200;

/// Reads a formula from the beginning of `tokens`; `full` with comparisons, logic and choice.
///
/// `None` where there is no whole expression, or one that is better read token by token.
/// `is_macro` tells which names stand for macros at the time.
pub fn parse(tokens: &[Token], text: &[u8], full: bool, is_macro: &dyn Fn(Symbol) -> bool) -> Option<Formula> {
    let tokens = &tokens[..tokens.len().min(MAX_TOKENS)];
    let formula = parse_part(tokens, text, full, is_macro)?;
    // A formula that reaches the end of what is known may go on there.
    let next = tokens.get(formula.length)?;
    // Behind the end of a macro the expression of its caller goes on.
    (next.kind != TokenKind::Directive(Directive::End)).then_some(formula)
}

/// The same, whatever stands behind it.
pub(super) fn parse_part(
    tokens: &[Token],
    text: &[u8],
    full: bool,
    is_macro: &dyn Fn(Symbol) -> bool,
) -> Option<Formula> {
    let formula = Formula::default();
    let mut parser = Parser { tokens, text, is_macro, at: 0, numeric: false, names: Vec::new(), formula };
    let (_, width) = if full { parser.full()? } else { parser.sum()? };
    parser.settle_names(0, Demand::Number);
    let mut formula = parser.formula;
    let next = tokens.get(parser.at).map(|t| t.kind);
    formula.open_ended = matches!(next, Some(TokenKind::Name(_) | TokenKind::Directive(_)));
    formula.scalar = width == Width::Float;
    formula.length = parser.at;
    Some(formula)
}

/// What is known of the width of a value when the names in it are floats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Width {
    Float,
    Vector,
    /// It comes from a macro.
    Unknown,
}

impl Width {
    fn with(self, other: Self) -> Self {
        match (self, other) {
            (Self::Vector, _) | (_, Self::Vector) => Self::Vector,
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            _ => Self::Float,
        }
    }
}

struct Parser<'a> {
    tokens: &'a [Token],
    text: &'a [u8],
    is_macro: &'a dyn Fn(Symbol) -> bool,
    at: usize,
    /// Whether only numbers can stand here.
    numeric: bool,
    /// Variables whose demand depends on what the operand around them turns out to be.
    names: Vec<Symbol>,
    formula: Formula,
}

type Parsed = Option<(NodeId, Width)>;

impl Parser<'_> {
    fn peek(&self) -> Option<TokenKind> {
        self.tokens.get(self.at).map(|t| t.kind)
    }

    fn accept(&mut self, c: char) -> bool {
        let found = self.peek() == Some(TokenKind::Punct(c));
        self.at += usize::from(found);
        found
    }

    fn push(&mut self, node: Node) -> NodeId {
        self.formula.nodes.push(node);
        (self.formula.nodes.len() - 1) as NodeId
    }

    fn node(&self, id: NodeId) -> Node {
        self.formula.nodes[usize::from(id)]
    }

    fn list(&mut self, items: &[NodeId]) -> List {
        let start = self.formula.lists.len() as u16;
        self.formula.lists.extend(items);
        List { start, n: items.len() as u8 }
    }

    fn demand(&mut self, name: Symbol, demand: Demand) {
        if !self.formula.demands.contains(&(name, demand)) {
            self.formula.demands.push((name, demand));
        }
    }

    /// Demands the same of all variables met since there were `first` of them.
    fn settle_names(&mut self, first: usize, demand: Demand) {
        for name in self.names.split_off(first) {
            self.demand(name, demand);
        }
    }

    /// An operand in a place that takes only numbers; its variables meet that demand.
    fn operand_of(&mut self, demand: Demand, parse: impl FnOnce(&mut Self) -> Parsed) -> Parsed {
        let first = self.names.len();
        let outside = std::mem::replace(&mut self.numeric, true);
        let parsed = parse(self)?;
        self.numeric = outside;
        self.settle_names(first, demand);
        Some(parsed)
    }

    /// An operand that must be a float: names in it are no vectors.
    fn float(&mut self, parse: impl FnOnce(&mut Self) -> Parsed) -> Option<NodeId> {
        let (node, width) = self.operand_of(Demand::Float, parse)?;
        (width != Width::Vector).then_some(node)
    }

    fn full(&mut self) -> Parsed {
        let start = self.at;
        let (condition, width) = self.logic()?;
        if !self.accept('?') {
            return Some((condition, width));
        }
        // Only a condition without names is sure to be a float.
        let names = self.tokens[start..self.at].iter().any(|t| matches!(t.kind, TokenKind::Name(_)));
        if width != Width::Float || names {
            return None;
        }
        let (yes, a) = self.full()?;
        if !self.accept(':') {
            return None;
        }
        let (no, b) = self.full()?;
        Some((self.push(Node::Choice(condition, yes, no)), a.with(b)))
    }

    fn binary(&mut self, operand: fn(&mut Self) -> Parsed, operator: fn(TokenKind) -> Option<Operator>) -> Parsed {
        let (mut left, mut width) = operand(self)?;
        while let Some(operator) = self.peek().and_then(operator) {
            let token = self.at as u16;
            self.at += 1;
            let (right, w) = operand(self)?;
            width = width.with(w);
            left = self.push(Node::Binary(operator, left, right, token));
        }
        Some((left, width))
    }

    fn logic(&mut self) -> Parsed {
        self.binary(Self::comparison, |kind| match kind {
            TokenKind::Punct('&') => Some(Operator::And),
            TokenKind::Punct('|') => Some(Operator::Or),
            _ => None,
        })
    }

    fn comparison(&mut self) -> Parsed {
        self.binary(Self::sum, |kind| match kind {
            TokenKind::Punct('<') => Some(Operator::Less),
            TokenKind::Punct('>') => Some(Operator::Greater),
            TokenKind::Punct('=') => Some(Operator::Equal),
            TokenKind::OrEqual('<') => Some(Operator::AtMost),
            TokenKind::OrEqual('>') => Some(Operator::AtLeast),
            TokenKind::OrEqual(_) => Some(Operator::Differs),
            _ => None,
        })
    }

    fn sum(&mut self) -> Parsed {
        let (node, width) = self.binary(Self::product, |kind| match kind {
            TokenKind::Punct('+') => Some(Operator::Add),
            TokenKind::Punct('-') => Some(Operator::Subtract),
            _ => None,
        })?;
        if let Node::Macro(call) = self.node(node) {
            self.formula.calls[usize::from(call)].whole = true;
        }
        Some((node, width))
    }

    fn product(&mut self) -> Parsed {
        self.binary(Self::factor, |kind| match kind {
            TokenKind::Punct('*') => Some(Operator::Multiply),
            TokenKind::Punct('/') => Some(Operator::Divide),
            _ => None,
        })
    }

    fn factor(&mut self) -> Parsed {
        let sign = match self.peek()? {
            TokenKind::Punct(sign @ ('-' | '+' | '!')) => sign,
            _ => return self.operand_with_component(),
        };
        self.at += 1;
        let (node, width) = self.factor()?;
        let node = match sign {
            '-' => self.push(Node::Negate(node)),
            '!' => self.push(Node::Not(node)),
            // No longer a name alone.
            _ => self.push(Node::Group(node)),
        };
        Some((node, width))
    }

    fn operand_with_component(&mut self) -> Parsed {
        let start = self.at;
        if let Some(TokenKind::Name(name)) = self.peek() {
            self.at += 1;
            return self.name(name, start);
        }
        let first = self.names.len();
        let (node, width) = self.operand()?;
        if !self.accept('.') {
            return Some((node, width));
        }
        let token = self.at as u16;
        let index = self.component()?;
        self.settle_names(first, Demand::Operand);
        Some((self.push(Node::ComponentOf(node, index, token)), Width::Float))
    }

    fn component(&mut self) -> Option<u8> {
        let TokenKind::Keyword(word) = self.peek()? else { return None };
        self.at += 1;
        Some(match word {
            Keyword::X | Keyword::U | Keyword::Red => 0,
            Keyword::Y | Keyword::V | Keyword::Green => 1,
            Keyword::Z | Keyword::Blue => 2,
            Keyword::T | Keyword::Filter => 3,
            Keyword::Transmit => 4,
            _ => return None,
        })
    }

    /// What stands behind a name decides what it must be.
    fn name(&mut self, name: Symbol, token: usize) -> Parsed {
        match self.peek()? {
            TokenKind::Punct('(') if (self.is_macro)(name) => self.macro_call(name, token as u16),
            TokenKind::Punct('.') => {
                self.at += 1;
                let index = self.component()?;
                self.demand(name, Demand::Component(index));
                Some((self.push(Node::Component(name, index)), Width::Float))
            }
            TokenKind::Punct('[') => {
                let mut indices = Vec::new();
                while self.accept('[') {
                    indices.push(self.float(Self::sum)?);
                    if !self.accept(']') {
                        return None;
                    }
                }
                if self.peek() == Some(TokenKind::Punct('.')) || indices.len() > 5 {
                    return None;
                }
                self.demand(name, Demand::FloatArray(indices.len() as u8));
                let list = self.list(&indices);
                Some((self.push(Node::Element(name, list, token as u16)), Width::Float))
            }
            TokenKind::Punct('(') => {
                let arguments = self.arguments()?;
                if self.peek() == Some(TokenKind::Punct('.')) {
                    return None;
                }
                self.demand(name, Demand::Function(arguments.n));
                Some((self.push(Node::CallName(name, arguments)), Width::Float))
            }
            _ => {
                self.names.push(name);
                Some((self.push(Node::Name(name)), Width::Float))
            }
        }
    }

    /// `( value, value … )` behind the name of a macro.
    fn macro_call(&mut self, name: Symbol, token: u16) -> Parsed {
        let mut items = Vec::new();
        self.accept('(').then_some(())?;
        while !self.accept(')') {
            if !items.is_empty() && !self.accept(',') || items.len() == usize::from(u8::MAX) {
                return None;
            }
            let first = self.names.len();
            let outside = std::mem::replace(&mut self.numeric, false);
            let (item, _) = self.sum()?;
            self.numeric = outside;
            let alone = matches!(self.node(item), Node::Name(_));
            self.settle_names(first, if alone { Demand::Reference } else { Demand::Operand });
            items.push(item);
        }
        // These would belong to the last token of the macro.
        if matches!(self.peek(), Some(TokenKind::Punct('.' | '[' | '('))) {
            return None;
        }
        let arguments = self.list(&items);
        let index = u16::try_from(self.formula.calls.len()).ok()?;
        self.formula.calls.push(MacroCall { name, arguments, token, whole: false, numeric: self.numeric });
        Some((self.push(Node::Macro(index)), Width::Unknown))
    }

    /// `( float, float … )`.
    fn arguments(&mut self) -> Option<List> {
        self.accept('(').then_some(())?;
        let mut items = vec![self.float(Self::sum)?];
        while self.accept(',') {
            items.push(self.float(Self::sum)?);
        }
        let closed = self.accept(')') && items.len() <= usize::from(u8::MAX);
        closed.then(|| self.list(&items))
    }

    /// `( vector, … )`, so many of them and then so many floats.
    fn vector_arguments(&mut self, n_vectors: usize, n_floats: usize) -> Option<List> {
        self.accept('(').then_some(())?;
        let mut items = Vec::new();
        for i in 0..n_vectors + n_floats {
            if i > 0 {
                self.accept(',').then_some(())?;
            }
            let float = i >= n_vectors;
            let item = if float { self.float(Self::sum)? } else { self.operand_of(Demand::Operand, Self::sum)?.0 };
            items.push(item);
        }
        self.accept(')').then(|| self.list(&items))
    }

    fn operand(&mut self) -> Parsed {
        let kind = self.peek()?;
        let token = self.at;
        self.at += 1;
        match kind {
            TokenKind::Number(value) => Some((self.push(Node::Constant(value)), Width::Float)),
            TokenKind::Punct('(') => {
                let (node, width) = self.full()?;
                self.accept(')').then(|| (self.push(Node::Group(node)), width))
            }
            TokenKind::Punct('<') => self.vector(),
            TokenKind::Vectors => {
                let span = self.tokens[token].span;
                let (v, n, end) = read_vector(self.text, span.start as usize);
                let whole = end >= span.end as usize && n <= 3;
                whole.then(|| (self.push(Node::Axes([v[0], v[1], v[2]], n)), Width::Vector))
            }
            TokenKind::Keyword(word) => self.built_in(word, token as u16),
            _ => None,
        }
    }

    fn vector(&mut self) -> Parsed {
        let mut items = Vec::new();
        while items.len() < 5 && self.peek()? != TokenKind::Punct('>') {
            items.push(self.float(Self::sum)?);
            if items.len() < 5 {
                self.accept(',');
            }
        }
        if items.len() < 2 || !self.accept('>') {
            return None;
        }
        let list = self.list(&items);
        Some((self.push(Node::Vector(list)), Width::Vector))
    }

    fn built_in(&mut self, word: Keyword, token: u16) -> Parsed {
        use Keyword as K;
        if let Some(node) = constant(word) {
            let width = if matches!(node, Node::Constant(_)) { Width::Float } else { Width::Vector };
            return Some((self.push(node), width));
        }
        let vectors = match word {
            K::Vnormalize => Some((self.vector_arguments(1, 0)?, Width::Vector)),
            K::Vcross | K::Vrotate => Some((self.vector_arguments(2, 0)?, Width::Vector)),
            K::VaxisRotate => Some((self.vector_arguments(2, 1)?, Width::Vector)),
            K::Vlength => Some((self.vector_arguments(1, 0)?, Width::Float)),
            K::Vdot => Some((self.vector_arguments(2, 0)?, Width::Float)),
            _ => None,
        };
        if let Some((arguments, width)) = vectors {
            return Some((self.push(Node::VectorCall(word, arguments, token)), width));
        }
        let arguments = match word {
            K::Pow | K::Atan2 | K::Div | K::Mod => self.arguments().filter(|a| a.n == 2)?,
            K::Max | K::Min => self.arguments()?,
            K::Select => self.arguments().filter(|a| a.n == 3 || a.n == 4)?,
            word if takes_one_float(word) => {
                self.accept('(').then_some(())?;
                let argument = self.float(Self::full)?;
                self.accept(')').then(|| self.list(&[argument]))?
            }
            _ => return None,
        };
        Some((self.push(Node::Call(word, arguments, token)), Width::Float))
    }
}

/// The value of a word that stands for a number or an axis.
fn constant(word: Keyword) -> Option<Node> {
    Some(match word {
        Keyword::Pi => Node::Constant(std::f64::consts::PI),
        Keyword::True | Keyword::Yes | Keyword::On => Node::Constant(1.0),
        Keyword::False | Keyword::No | Keyword::Off => Node::Constant(0.0),
        Keyword::X => Node::Axes([1.0, 0.0, 0.0], 3),
        Keyword::Y => Node::Axes([0.0, 1.0, 0.0], 3),
        Keyword::Z => Node::Axes([0.0, 0.0, 1.0], 3),
        Keyword::U => Node::Axes([1.0, 0.0, 0.0], 2),
        Keyword::V => Node::Axes([0.0, 1.0, 0.0], 2),
        _ => return None,
    })
}

/// Functions of one full expression that have no other effect than on `rand`'s streams.
fn takes_one_float(word: Keyword) -> bool {
    use Keyword as K;
    matches!(
        word,
        K::Abs
            | K::Ceil
            | K::Floor
            | K::Cos
            | K::Sin
            | K::Tan
            | K::Atan
            | K::Sinh
            | K::Cosh
            | K::Tanh
            | K::Asinh
            | K::Acosh
            | K::Atanh
            | K::Exp
            | K::Int
            | K::Degrees
            | K::Radians
            | K::Rand
            | K::Acos
            | K::Asin
            | K::Ln
            | K::Log
            | K::Sqrt
    )
}
