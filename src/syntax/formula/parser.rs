//! From tokens to a tree.

mod operands;

use super::{Demand, Formula, List, MAX_PLAIN, MAX_STACK, Node, NodeId, Operand, OperandId};
use crate::syntax::expression::{Build, Choose, Language, Operator, Strength, chain, expression};
use crate::syntax::{Directive, Symbol, Token, TokenKind};

/// Longer expressions are rare in loops, and nesting is bounded by this too.
const MAX_TOKENS: usize = 200;

/// An array has no more dimensions.
const MAX_INDICES: usize = 5;

/// Reads a formula from the beginning of `tokens`; `full` with comparisons, logic and choice.
///
/// `None` where there is no whole expression, or one that is better read token by token.
/// `is_macro` tells which names stand for macros at the time.
pub fn parse(tokens: &[Token], text: &[u8], full: bool, is_macro: &dyn Fn(Symbol) -> bool) -> Option<Formula> {
    let formula = parse_part(tokens, text, full, is_macro)?;
    // A formula that reaches the end of what is known may go on there.
    let next = tokens.get(formula.length)?;
    // Behind the end of a macro the expression of its caller goes on.
    (next.kind != TokenKind::Directive(Directive::End)).then_some(formula)
}

/// The same, whatever stands behind it; the caller makes sure that it does not go on there.
pub(super) fn parse_part(
    tokens: &[Token],
    text: &[u8],
    full: bool,
    is_macro: &dyn Fn(Symbol) -> bool,
) -> Option<Formula> {
    let tokens = &tokens[..tokens.len().min(MAX_TOKENS)];
    let formula = Formula::default();
    let mut parser = Parser { tokens, text, is_macro, at: 0, numeric: false, names: Vec::new(), formula };
    let (_, width) = if full { parser.full()? } else { parser.sum()? };
    parser.settle_names(0, Demand::Number);
    let mut formula = parser.formula;
    let next = tokens.get(parser.at).map(|t| t.kind);
    formula.open_ended = matches!(next, Some(TokenKind::Name(_) | TokenKind::Directive(_)));
    formula.scalar = width == Width::Float;
    formula.length = parser.at;
    formula.plain = formula.calls.is_empty()
        && formula.operands.len() <= MAX_PLAIN
        && formula.operands.iter().all(Operand::takes_float);
    (formula.stack() <= MAX_STACK).then_some(formula)
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
    /// Variables whose demand depends on what the expression around them turns out to be.
    names: Vec<OperandId>,
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

    /// Adds a node whose operands begin with `first`.
    fn push(&mut self, node: Node, first: NodeId) -> NodeId {
        self.formula.nodes.push(node);
        self.formula.first.push(first);
        (self.formula.nodes.len() - 1) as NodeId
    }

    fn leaf(&mut self, node: Node) -> NodeId {
        let at = self.next_id();
        self.push(node, at)
    }

    /// A node of operands that come one after the other from `first` on.
    fn parent(&mut self, node: Node, first_operand: NodeId) -> NodeId {
        let first = self.formula.first[usize::from(first_operand)];
        self.push(node, first)
    }

    fn next_id(&self) -> NodeId {
        self.formula.nodes.len() as NodeId
    }

    /// What comes before operands that may be vectors, until it is known what takes them.
    fn skip(&mut self) -> NodeId {
        let next = self.next_id() + 1;
        self.leaf(Node::Skip(next))
    }

    /// A node that takes operands which may be vectors, all those behind `skip`.
    fn skipped_to(&mut self, node: Node, skip: NodeId) -> NodeId {
        let id = self.push(node, skip);
        self.formula.nodes[usize::from(skip)] = Node::Skip(id);
        id
    }

    fn node(&self, id: NodeId) -> Node {
        self.formula.nodes[usize::from(id)]
    }

    fn list(&mut self, items: &[NodeId]) -> List {
        let start = self.formula.lists.len() as u16;
        self.formula.lists.extend(items);
        List { start, n: items.len() as u8 }
    }

    /// A name of which that is asked; a variable stands once in the list, for whatever is asked of it.
    fn demand(&mut self, name: Symbol, n_indices: u8, demand: Demand) -> OperandId {
        let operands = &mut self.formula.operands;
        let same = |o: &Operand| {
            (o.name, o.n_indices) == (name, n_indices) && (o.demand == demand || o.demand.max(demand) <= Demand::Float)
        };
        let known = operands.iter().position(same);
        let at = known.unwrap_or_else(|| {
            operands.push(Operand { name, n_indices, demand });
            operands.len() - 1
        });
        operands[at].demand = operands[at].demand.max(demand);
        at as OperandId
    }

    /// A variable or element of which the expression around it decides what it must be.
    fn variable(&mut self, name: Symbol, n_indices: u8) -> OperandId {
        let operand = self.demand(name, n_indices, Demand::Reference);
        self.names.push(operand);
        operand
    }

    /// Demands the same of all variables met since there were `first` of them.
    fn settle_names(&mut self, first: usize, demand: Demand) {
        for name in self.names.split_off(first) {
            let operand = &mut self.formula.operands[usize::from(name)];
            operand.demand = operand.demand.max(demand);
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
        let (node, width) = expression(self, ()).ok()?;
        self.stands_whole(node);
        Some((node, width))
    }

    fn sum(&mut self) -> Parsed {
        let (node, width) = chain(self, Strength::Sum, ()).ok()?;
        self.stands_whole(node);
        Some((node, width))
    }

    /// No sign and no arithmetic stands beside a node.
    fn stands_whole(&mut self, node: NodeId) {
        if let Node::Macro(call) = self.node(node) {
            self.formula.calls[usize::from(call)].whole = true;
        }
    }

    fn factor(&mut self) -> Parsed {
        let sign = match self.peek()? {
            TokenKind::Punct(sign @ ('-' | '+' | '!')) => sign,
            _ => return self.operand_with_component(),
        };
        self.at += 1;
        let (node, width) = self.factor()?;
        let node = match sign {
            '-' => self.parent(Node::Negate(node), node),
            '!' => self.parent(Node::Not(node), node),
            // No longer a name alone.
            _ => self.parent(Node::Group(node), node),
        };
        Some((node, width))
    }
}

/// There is no whole expression, or one that is better read token by token.
struct NotWhole;

impl Build for Parser<'_> {
    type Built = (NodeId, Width);
    type Place = ();
    /// The number of a token.
    type Mark = usize;
    type Stop = NotWhole;
    const LANGUAGE: Language = Language::Values;

    fn operator(&mut self) -> Result<Option<Operator>, NotWhole> {
        Ok(self.peek().and_then(Operator::of))
    }

    fn take_operator(&mut self) -> usize {
        self.at += 1;
        self.at - 1
    }

    fn operand(&mut self, (): ()) -> Result<Self::Built, NotWhole> {
        self.factor().ok_or(NotWhole)
    }

    fn combine(
        &mut self,
        operator: Operator,
        (left, width): &mut Self::Built,
        (right, other): Self::Built,
        token: usize,
    ) -> Result<(), NotWhole> {
        if operator.strength(Self::LANGUAGE) <= Strength::Comparison {
            self.stands_whole(*left);
            self.stands_whole(right);
        }
        *left = self.parent(Node::Binary(operator, *left, right, token as u16), *left);
        *width = width.with(other);
        Ok(())
    }
}

impl Choose for Parser<'_> {
    fn start(&mut self) -> Result<usize, NotWhole> {
        Ok(self.at)
    }

    fn accept_question(&mut self) -> Result<bool, NotWhole> {
        Ok(self.accept('?'))
    }

    fn choose(&mut self, (condition, width): Self::Built, start: usize, (): ()) -> Result<Self::Built, NotWhole> {
        // Only a condition without names is sure to be a float.
        let names = self.tokens[start..self.at].iter().any(|t| matches!(t.kind, TokenKind::Name(_)));
        if width != Width::Float || names {
            return Err(NotWhole);
        }
        let (yes, a) = self.full().ok_or(NotWhole)?;
        if !self.accept(':') {
            return Err(NotWhole);
        }
        let (no, b) = self.full().ok_or(NotWhole)?;
        Ok((self.parent(Node::Choice(condition, yes, no), condition), a.with(b)))
    }
}
