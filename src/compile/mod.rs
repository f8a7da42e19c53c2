//! From the evaluated scene to the compiled one, as named passes.

pub mod geometry;
