//! Which cell sides are tile borders in each of the 112 pavements.
//!
//! Provenance: recovered from the running POV-Ray 3.7.0.10 by `scripts/probe_pavement.py`, which looks at the pattern's
//! value just inside the middle of every cell side. Written by the script: do not edit.
//!
//! Cells are squares or triangles over the lattice points `i * A + j * B`, with `A = (1, 0)` and `B = (0, 1)` for four
//! sides, `B = (1/2, sqrt(3)/2)` for three and six. Each edge belongs to one lattice point: edge 0 leads along `A`, edge
//! 1 along `B`, and edge 2 (triangles only) joins the ends of these two.
//!
//! No table is needed for the corners that `form` bends: the script found that a triangle's corner is bent exactly where
//! the wedge of its tile around that corner is two triangles wide.

/// The borders of one pavement over one period.
pub(super) struct PavementMap {
    /// Periods: the map repeats after (`width`, 0) and after (`shift`, `height`), in lattice steps.
    pub(super) width: u8,
    pub(super) height: u8,
    pub(super) shift: u8,
    /// Bit `(j * width + i) * k + edge` tells whether an edge is a border; `k` is 2 for squares, 3 for triangles.
    pub(super) borders: u128,
}

const fn map(width: u8, height: u8, shift: u8, borders: u128) -> PavementMap {
    PavementMap { width, height, shift, borders }
}

/// Pavements with `number_of_sides 3`, by `number_of_tiles` and then `pattern`, each less one.
pub(super) const TRIANGLE_PAVEMENTS: [&[PavementMap]; 6] = [
    &[map(1, 1, 0, 0x7)],
    &[map(1, 1, 0, 0x5)],
    &[map(3, 1, 1, 0x6b)],
    &[map(2, 1, 1, 0xd), map(2, 1, 1, 0x2a), map(2, 2, 0, 0x1ab)],
    &[map(5, 1, 2, 0x134b), map(5, 1, 2, 0x628b), map(5, 1, 2, 0x4a8d), map(5, 1, 3, 0x78b)],
    &[
        map(3, 1, 0, 0x4b),
        map(3, 1, 0, 0x4e),
        map(3, 1, 1, 0x4e),
        map(3, 2, 1, 0x634b),
        map(3, 2, 1, 0x34cb),
        map(3, 2, 2, 0x1145b),
        map(2, 3, 1, 0x1194b),
        map(2, 3, 1, 0x18b0b),
        map(3, 2, 1, 0x546b),
        map(3, 1, 0, 0x63),
        map(3, 1, 1, 0x2b),
        map(3, 1, 1, 0x62),
    ],
];

/// Pavements with `number_of_sides 4`, by `number_of_tiles` and then `pattern`, each less one.
pub(super) const SQUARE_PAVEMENTS: [&[PavementMap]; 6] = [
    &[map(1, 1, 0, 0x3)],
    &[map(1, 2, 0, 0xb)],
    &[map(3, 1, 0, 0x17), map(3, 2, 0, 0x99f)],
    &[map(4, 1, 0, 0x57), map(4, 2, 0, 0x965f), map(4, 1, 2, 0x97), map(2, 2, 0, 0x27), map(2, 2, 1, 0x3d)],
    &[
        map(5, 1, 0, 0x157),
        map(5, 2, 0, 0x9595f),
        map(5, 2, 2, 0x20ddd),
        map(5, 1, 3, 0x257),
        map(5, 1, 3, 0x393),
        map(10, 1, 9, 0xa5d6b),
        map(10, 1, 9, 0x6766e),
        map(10, 1, 7, 0x1bb97),
        map(5, 1, 4, 0x25b),
        map(5, 2, 2, 0xe5a4f),
        map(5, 2, 1, 0x1cf5d),
        map(10, 1, 2, 0xba4d7),
    ],
    &[
        map(6, 1, 0, 0x557),
        map(6, 2, 0, 0x15ed57),
        map(6, 2, 0, 0x179d57),
        map(6, 2, 0, 0x1e5d57),
        map(6, 1, 1, 0x573),
        map(6, 2, 0, 0x72757),
        map(6, 2, 0, 0x2435dd),
        map(6, 1, 1, 0x5c7),
        map(3, 2, 0, 0xdd),
        map(3, 2, 0, 0x97),
        map(4, 3, 0, 0x92265f),
        map(6, 1, 5, 0x997),
        map(4, 3, 0, 0x46bb57),
        map(3, 4, 0, 0xd1ae57),
        map(3, 2, 1, 0x2c7),
        map(6, 1, 4, 0x24f),
        map(6, 2, 5, 0x47bb53),
        map(6, 2, 5, 0xb5617b),
        map(6, 1, 5, 0xa5b),
        map(6, 1, 1, 0xc5e),
        map(6, 1, 1, 0x57a),
        map(4, 3, 0, 0x61be57),
        map(4, 3, 0, 0xbb964e),
        map(6, 2, 2, 0x65b877),
        map(2, 3, 0, 0x697),
        map(2, 3, 0, 0x927),
        map(2, 3, 0, 0x6c7),
        map(6, 1, 5, 0x65b),
        map(6, 2, 2, 0x7196e7),
        map(6, 2, 3, 0x79396d),
        map(6, 2, 3, 0xc5eb47),
        map(6, 1, 2, 0x47b),
        map(3, 4, 0, 0x58e9d7),
        map(12, 1, 5, 0x17bb53),
        map(4, 3, 2, 0xbe961e),
    ],
];

/// Pavements with `number_of_sides 6`, by `number_of_tiles` and then `pattern`, each less one.
pub(super) const HEXAGON_PAVEMENTS: [&[PavementMap]; 5] = [
    &[map(3, 1, 1, 0x62)],
    &[map(3, 2, 2, 0x20262)],
    &[map(3, 6, 0, 0x10910112122262), map(9, 2, 5, 0x20111809080462), map(9, 1, 4, 0x100c462)],
    &[
        map(3, 8, 2, 0x880890910112122262),
        map(6, 2, 2, 0xc44c002),
        map(6, 2, 5, 0x88c448042),
        map(12, 1, 1, 0x301884422),
        map(12, 2, 2, 0x8c460311111084062),
        map(12, 2, 2, 0x88c02210101108c422),
        map(6, 2, 2, 0x8404c462),
    ],
    &[
        map(3, 10, 1, 0x4484880890910112122262),
        map(15, 1, 1, 0x62110884460),
        map(3, 10, 1, 0x4088880890910312020262),
        map(3, 10, 1, 0x448c801090910312020222),
        map(15, 1, 1, 0x6211088c420),
        map(3, 10, 1, 0x4080808890911102020262),
        map(3, 10, 1, 0x4080809880810102222202),
        map(30, 1, 4, 0xc06201088842010188c460),
        map(15, 2, 11, 0x22301884442262110888440),
        map(15, 2, 2, 0x31080806026231088c462),
        map(15, 2, 11, 0x20101088020202311880462),
        map(15, 1, 10, 0x62000808462),
        map(15, 2, 8, 0x31180842226221088c442),
        map(15, 1, 13, 0x22211084462),
        map(15, 1, 13, 0x42210884462),
        map(15, 2, 11, 0x2231108440224011088c042),
        map(15, 2, 5, 0x22111808400222311884060),
        map(15, 2, 11, 0x2021088444026211088c462),
        map(15, 2, 8, 0x2021100c42206211088c462),
        map(3, 10, 1, 0x4088088890911212020262),
        map(15, 1, 13, 0x42111084462),
        map(15, 2, 11, 0x31088404222211188c462),
    ],
];
