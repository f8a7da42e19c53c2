//! Expressions that stand whole, as trees.
//!
//! An expression inside a loop or a macro is read again and again. Where its tokens form
//! a complete expression in one piece of text (no directive cuts through it), it is
//! parsed into a tree the second time it is met, and from then on walked. Names keep their
//! run-time meaning: [`Formula::demands`] lists what must hold for the tree to be the right
//! reading, and where it does not (a name is a macro, say) the tokens are read instead.

use super::vectors::read_vector;
use super::{Directive, Keyword, Symbol, Token, TokenKind};

/// Index of a node.
pub type NodeId = u16;

/// An expression as a tree; children come before their parents.
#[derive(Clone, Debug, Default)]
pub struct Formula {
    /// The nodes; the last one is the root.
    pub nodes: Vec<Node>,
    /// Operands of calls, vectors and indices.
    pub lists: Vec<NodeId>,
    /// What the names in it must stand for.
    pub demands: Vec<(Symbol, Demand)>,
    /// How many tokens it takes up.
    pub length: usize,
    /// Whether the token behind it might expand into more of it: a name or a directive.
    pub open_ended: bool,
    /// Whether the result is a float when all names that [`Demand::Number`] lists are floats.
    pub scalar: bool,
}

/// What a name must stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Demand {
    /// A float.
    Float,
    /// A float or a vector.
    Number,
    /// A vector with more components than this.
    Component(u8),
    /// An array of floats with that many dimensions.
    FloatArray(u8),
    /// A function of one result with that many arguments.
    Function(u8),
}

/// A range of [`Formula::lists`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct List {
    /// First operand.
    pub start: u16,
    /// How many.
    pub n: u8,
}

/// One operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    /// A literal number.
    Constant(f64),
    /// A literal vector or a named axis.
    Axes([f64; 3], u8),
    /// A variable.
    Name(Symbol),
    /// An array element; the token of its name.
    Element(Symbol, List, u16),
    /// A component of a variable.
    Component(Symbol, u8),
    /// Component of any other operand.
    ComponentOf(NodeId, u8),
    /// `-a`.
    Negate(NodeId),
    /// `!a`.
    Not(NodeId),
    /// `a op b`; the token of the operator.
    Binary(Operator, NodeId, NodeId, u16),
    /// `c ? a : b`.
    Choice(NodeId, NodeId, NodeId),
    /// `<a, b, …>`.
    Vector(List),
    /// `(a)`: the width of operands starts at 1 again.
    Group(NodeId),
    /// A built-in function; the token of its name.
    Call(Keyword, List, u16),
    /// A declared function.
    CallName(Symbol, List),
}

/// Operators of two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Less,
    AtMost,
    Equal,
    Differs,
    AtLeast,
    Greater,
    And,
    Or,
}

/// Reads a formula from the beginning of `tokens`; `full` with comparisons, logic and choice.
///
/// `None` where there is no whole expression, or one that is better read token by token.
pub fn parse(tokens: &[Token], text: &[u8], full: bool) -> Option<Formula> {
    /// Longer expressions are rare in loops, and nesting is bounded by this too.
    const MAX_TOKENS: usize = 200;
    let tokens = &tokens[..tokens.len().min(MAX_TOKENS)];
    let mut parser = Parser { tokens, text, at: 0, formula: Formula::default() };
    let (_, scalar) = if full { parser.full()? } else { parser.sum()? };
    let mut formula = parser.formula;
    // A formula that reaches the end of what is known may go on there.
    let next = tokens.get(parser.at)?;
    // Behind the end of a macro the expression of its caller goes on.
    if next.kind == TokenKind::Directive(Directive::End) {
        return None;
    }
    formula.open_ended = matches!(next.kind, TokenKind::Name(_) | TokenKind::Directive(_));
    (formula.length, formula.scalar) = (parser.at, scalar);
    Some(formula)
}

struct Parser<'a> {
    tokens: &'a [Token],
    text: &'a [u8],
    at: usize,
    formula: Formula,
}

/// A node, and whether it is a float when the names in it are.
type Parsed = Option<(NodeId, bool)>;

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

    /// An operand that must be a float: names in it are no vectors.
    fn float(&mut self, parse: impl FnOnce(&mut Self) -> Parsed) -> Option<NodeId> {
        let first = self.formula.demands.len();
        let (node, scalar) = parse(self)?;
        for demand in &mut self.formula.demands[first..] {
            if demand.1 == Demand::Number {
                demand.1 = Demand::Float;
            }
        }
        // A name demanded before, outside of this operand, is not in that part of the list.
        let names: Vec<Symbol> =
            self.formula.nodes.iter().filter_map(|n| if let Node::Name(s) = n { Some(*s) } else { None }).collect();
        for name in names {
            if self.formula.demands[..first].contains(&(name, Demand::Number)) {
                self.demand(name, Demand::Float);
            }
        }
        scalar.then_some(node)
    }

    fn full(&mut self) -> Parsed {
        let start = self.at;
        let (condition, scalar) = self.logic()?;
        if !self.accept('?') {
            return Some((condition, scalar));
        }
        // Only a condition without names is sure to be a float.
        let names = self.tokens[start..self.at].iter().any(|t| matches!(t.kind, TokenKind::Name(_)));
        if !scalar || names {
            return None;
        }
        let (yes, a) = self.full()?;
        if !self.accept(':') {
            return None;
        }
        let (no, b) = self.full()?;
        Some((self.push(Node::Choice(condition, yes, no)), a && b))
    }

    fn binary(&mut self, operand: fn(&mut Self) -> Parsed, operator: fn(TokenKind) -> Option<Operator>) -> Parsed {
        let (mut left, mut scalar) = operand(self)?;
        while let Some(operator) = self.peek().and_then(operator) {
            let token = self.at as u16;
            self.at += 1;
            let (right, s) = operand(self)?;
            scalar &= s;
            left = self.push(Node::Binary(operator, left, right, token));
        }
        Some((left, scalar))
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
        self.binary(Self::product, |kind| match kind {
            TokenKind::Punct('+') => Some(Operator::Add),
            TokenKind::Punct('-') => Some(Operator::Subtract),
            _ => None,
        })
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
        let (node, scalar) = self.factor()?;
        let node = match sign {
            '-' => self.push(Node::Negate(node)),
            '!' => self.push(Node::Not(node)),
            _ => node,
        };
        Some((node, scalar))
    }

    fn operand_with_component(&mut self) -> Parsed {
        let start = self.at;
        if let Some(TokenKind::Name(name)) = self.peek() {
            self.at += 1;
            return self.name(name, start);
        }
        let (node, scalar) = self.operand()?;
        if !self.accept('.') {
            return Some((node, scalar));
        }
        let index = self.component()?;
        // Whether a computed value has that component is known only when it is there.
        match self.formula.nodes[node as usize] {
            Node::Vector(List { n, .. }) | Node::Axes(_, n) if index < n => {
                Some((self.push(Node::ComponentOf(node, index)), true))
            }
            _ => None,
        }
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
            TokenKind::Punct('.') => {
                self.at += 1;
                let index = self.component()?;
                self.demand(name, Demand::Component(index));
                Some((self.push(Node::Component(name, index)), true))
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
                Some((self.push(Node::Element(name, list, token as u16)), true))
            }
            TokenKind::Punct('(') => {
                let arguments = self.arguments()?;
                if self.peek() == Some(TokenKind::Punct('.')) {
                    return None;
                }
                self.demand(name, Demand::Function(arguments.n));
                Some((self.push(Node::CallName(name, arguments)), true))
            }
            _ => {
                self.demand(name, Demand::Number);
                Some((self.push(Node::Name(name)), true))
            }
        }
    }

    /// `( float, float … )`.
    fn arguments(&mut self) -> Option<List> {
        if !self.accept('(') {
            return None;
        }
        let mut items = vec![self.float(Self::sum)?];
        while self.accept(',') {
            items.push(self.float(Self::sum)?);
        }
        let closed = self.accept(')') && items.len() <= usize::from(u8::MAX);
        closed.then(|| self.list(&items))
    }

    fn operand(&mut self) -> Parsed {
        let kind = self.peek()?;
        let token = self.at;
        self.at += 1;
        match kind {
            TokenKind::Number(value) => Some((self.push(Node::Constant(value)), true)),
            TokenKind::Punct('(') => {
                let (node, scalar) = self.full()?;
                self.accept(')').then(|| (self.push(Node::Group(node)), scalar))
            }
            TokenKind::Punct('<') => self.vector(),
            TokenKind::Vectors => {
                let span = self.tokens[token].span;
                let (v, n, end) = read_vector(self.text, span.start as usize);
                let whole = end >= span.end as usize && n <= 3;
                whole.then(|| (self.push(Node::Axes([v[0], v[1], v[2]], n)), false))
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
        Some((self.push(Node::Vector(list)), false))
    }

    fn built_in(&mut self, word: Keyword, token: u16) -> Parsed {
        use Keyword as K;
        let constant = match word {
            K::Pi => Some(std::f64::consts::PI),
            K::True | K::Yes | K::On => Some(1.0),
            K::False | K::No | K::Off => Some(0.0),
            _ => None,
        };
        if let Some(value) = constant {
            return Some((self.push(Node::Constant(value)), true));
        }
        let axes = match word {
            K::X => ([1.0, 0.0, 0.0], 3),
            K::Y => ([0.0, 1.0, 0.0], 3),
            K::Z => ([0.0, 0.0, 1.0], 3),
            K::U => ([1.0, 0.0, 0.0], 2),
            K::V => ([0.0, 1.0, 0.0], 2),
            _ => ([0.0; 3], 0),
        };
        if axes.1 > 0 {
            return Some((self.push(Node::Axes(axes.0, axes.1)), false));
        }
        let arguments = match word {
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
            | K::Sqrt => {
                if !self.accept('(') {
                    return None;
                }
                let argument = self.float(Self::full)?;
                self.accept(')').then(|| self.list(&[argument]))?
            }
            K::Pow | K::Atan2 | K::Div | K::Mod => self.arguments().filter(|a| a.n == 2)?,
            K::Max | K::Min => self.arguments()?,
            K::Select => self.arguments().filter(|a| a.n == 3 || a.n == 4)?,
            _ => return None,
        };
        Some((self.push(Node::Call(word, arguments, token)), true))
    }
}
