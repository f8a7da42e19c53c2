//! Expressions that stand whole, as trees.
//!
//! An expression inside a loop or a macro is read again and again. Where its tokens form
//! a complete expression in one piece of text (no directive cuts through it), it is
//! parsed into a tree the second time it is met, and from then on walked. Names keep their
//! run-time meaning: [`Formula::operands`] lists what must hold for the tree to be the right
//! reading, and where it does not (a name is an object, say) the tokens are read instead.
//!
//! So does a [`Statement`] around such expressions. A macro that ends in one ([`result_of`]) can be called
//! from within a tree.

mod body;
mod parser;
mod reader;
mod statement;

pub use body::{MacroResult, result_of};
pub use parser::parse;
pub use statement::{Action, Part, Scope, Statement};

use super::expression::Operator;
use super::{Keyword, Symbol};

/// Index of a node.
pub type NodeId = u16;

/// Most floats that wait for an operation.
pub const MAX_STACK: usize = 16;

/// Most variables of a formula that is called plain.
pub const MAX_PLAIN: usize = 8;

/// An expression as a tree; children come before their parents.
///
/// So the nodes of a tree of floats, one after the other, are also a program for a stack of at most [`MAX_STACK`]
/// floats: each takes its operands from the top and leaves its value there.
#[derive(Clone, Debug, Default)]
pub struct Formula {
    /// The nodes; the last one is the root.
    pub nodes: Vec<Node>,
    /// For each node the first one that belongs to it.
    pub first: Vec<NodeId>,
    /// Operands of calls, vectors and indices.
    pub lists: Vec<NodeId>,
    /// The names in it, and what they must stand for.
    pub operands: Vec<Operand>,
    /// The macros that are called in it.
    pub calls: Vec<MacroCall>,
    /// How many tokens it takes up.
    pub length: usize,
    /// Whether the token behind it might expand into more of it: a name or a directive.
    pub open_ended: bool,
    /// Whether the result is a float when all names of [`Demand::Number`] are floats.
    pub scalar: bool,
    /// Whether it has no more than [`MAX_PLAIN`] variables, which nothing in it changes and which may all be floats.
    pub plain: bool,
}

/// A name, and what it must stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operand {
    /// The name.
    pub name: Symbol,
    /// How many indices stand behind it; it is an array of as many dimensions then, and its elements are what is asked.
    pub n_indices: u8,
    /// What is asked of it.
    pub demand: Demand,
}

impl Operand {
    /// Whether it can be a variable that holds a float.
    fn takes_float(&self) -> bool {
        self.n_indices == 0 && self.demand <= Demand::Component(0)
    }
}

/// What a name or element must stand for. Of the first four each asks for more than the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Demand {
    /// Anything that is passed to a macro by reference.
    Reference,
    /// A float or a vector, in a place that takes either.
    Either,
    /// A float or a vector, on which the width of the formula depends.
    Number,
    /// A float.
    Float,
    /// A vector with more components than this.
    Component(u8),
    /// A function of one result with that many arguments.
    Function(u8),
}

/// Index of a name in [`Formula::operands`].
pub type OperandId = u16;

/// The call of a macro whose tokens end in an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MacroCall {
    /// Its name.
    pub name: Symbol,
    /// Its arguments; a name or element alone goes by reference.
    pub arguments: List,
    /// The token of the name.
    pub token: u16,
    /// Whether neither sign nor `+ - * /` stands beside it, so that the result may be a sum.
    pub whole: bool,
    /// Whether only a number can stand in its place, so that the result may be a name alone.
    pub numeric: bool,
}

impl Formula {
    /// The node that gives its value.
    pub fn root(&self) -> NodeId {
        (self.nodes.len() - 1) as NodeId
    }

    /// How many floats wait at most while the nodes run in order.
    fn stack(&self) -> usize {
        let (mut now, mut most) = (0_usize, 0);
        for node in &self.nodes {
            let (taken, left) = node.arity(&self.calls);
            now = now - taken + left;
            most = most.max(now);
        }
        most
    }

    /// The name, in whatever role, of an operand.
    pub fn name(&self, operand: OperandId) -> Symbol {
        self.operands[usize::from(operand)].name
    }
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
    Name(OperandId),
    /// An array element; the token of its name.
    Element(OperandId, List, u16),
    /// A component of a variable.
    Component(OperandId),
    /// Component of any other operand; the token of the component.
    ComponentOf(NodeId, u8, u16),
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
    /// A built-in function of floats; the token of its name.
    Call(Keyword, List, u16),
    /// A built-in function of vectors; the token of its name.
    VectorCall(Keyword, List, u16),
    /// A declared function.
    CallName(Symbol, List),
    /// One of [`Formula::calls`].
    Macro(u16),
    /// No value. A program of floats goes on at that node, whose operands before it may be vectors.
    Skip(NodeId),
}

impl Node {
    /// How many operands it takes, and values it leaves.
    fn arity(&self, calls: &[MacroCall]) -> (usize, usize) {
        let taken = match self {
            Self::Constant(_) | Self::Axes(..) | Self::Name(_) | Self::Component(_) => 0,
            Self::Negate(_) | Self::Not(_) | Self::Group(_) | Self::ComponentOf(..) => 1,
            Self::Binary(..) => 2,
            Self::Choice(..) => 3,
            Self::Element(_, list, _)
            | Self::Vector(list)
            | Self::Call(_, list, _)
            | Self::VectorCall(_, list, _)
            | Self::CallName(_, list) => usize::from(list.n),
            Self::Macro(call) => usize::from(calls[usize::from(*call)].arguments.n),
            Self::Skip(_) => return (0, 0),
        };
        (taken, 1)
    }
}
