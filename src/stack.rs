//! Room on the stack for functions that call themselves once for each level of what a scene nests.

/// Runs `work` with room for it and all that it calls before it comes back here; where little is left of the stack, on
/// another one.
#[inline]
pub(crate) fn roomy<T>(work: impl FnOnce() -> T) -> T {
    /// What may be used up between two levels: the largest functions for reading blocks take some 10 KB each.
    const ENOUGH: usize = 256 << 10;
    /// Address space of another stack, of which only what is used costs anything.
    const MORE: usize = 16 << 20;
    stacker::maybe_grow(ENOUGH, MORE, work)
}
