//! What a scene from anywhere may cost.

use whitted::eval::Limits;

/// Small enough that the dearest scene within them takes a fraction of a second.
pub const LIMITS: Limits = Limits {
    steps: 1_000,
    objects: 500,
    parts: 5_000,
    array_elements: 5_000,
    string_bytes: 10_000,
    include_depth: 6,
    macro_depth: 60,
    nesting: 80,
};
