//! Expressions that stand whole, as trees.
//!
//! An expression inside a loop or a macro is read again and again. Where its tokens form
//! a complete expression in one piece of text (no directive cuts through it), it is
//! parsed into a tree the second time it is met, and from then on walked. Names keep their
//! run-time meaning: [`Formula::demands`] lists what must hold for the tree to be the right
//! reading, and where it does not (a name is an object, say) the tokens are read instead.
//!
//! A macro that ends in such an expression ([`result_of`]) can be called from within a tree.

mod body;
mod parser;

pub use body::{MacroResult, result_of};
pub use parser::parse;

use super::{Keyword, Symbol};

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
    /// The macros that are called in it.
    pub calls: Vec<MacroCall>,
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
    /// A float or a vector, of which the width of the formula depends.
    Number,
    /// A float or a vector, in a place that takes either.
    Operand,
    /// A vector with more components than this.
    Component(u8),
    /// An array of floats with that many dimensions.
    FloatArray(u8),
    /// A function of one result with that many arguments.
    Function(u8),
    /// Anything that is passed to a macro by reference.
    Reference,
}

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
