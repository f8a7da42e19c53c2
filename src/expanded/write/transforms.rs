//! Transformations, in the shortest words that give the same bits on both ways.

use super::number::{numbers, vector};
use super::writer::Writer;
use crate::math::{DAffine3, DMat3, DVec3, Transform};
use crate::scene::Place;

impl Writer<'_> {
    /// Where an object or texture stands, if it was moved.
    pub(super) fn place(&mut self, place: &Place) {
        if !place.is_identity() {
            self.transform(&place.transform());
        }
    }

    /// A transformation; nothing for one that leaves all where it is.
    ///
    /// A scene keeps what its rotations and scalings came to, with the way back: this is written as a translation, a
    /// scaling or both where that comes to the same bits, else as a matrix. Where the way back is not what a matrix
    /// alone comes to, a note says what it is: to POV-Ray that is a comment, and its own rounding takes over.
    pub(super) fn transform(&mut self, transform: &Transform) {
        if transform.is_identity() || self.counting {
            return;
        }
        let (linear, moved) = (transform.linear(), transform.origin());
        let stretch = DVec3::new(linear.x_axis.x, linear.y_axis.y, linear.z_axis.z);
        let same = |other: &Transform| is_same(other, transform);
        if same(&Transform::translation(moved)) {
            return self.line(format_args!("translate {}", vector(moved)));
        }
        let scaling = Transform::scaling(stretch);
        if stretch.cmpne(DVec3::ZERO).all() && linear == DMat3::from_diagonal(stretch) {
            if same(&scaling) {
                return self.line(format_args!("scale {}", vector(stretch)));
            }
            if same(&scaling.then(&Transform::translation(moved))) {
                return self.line(format_args!("scale {} translate {}", vector(stretch), vector(moved)));
            }
        }
        self.matrix(transform);
    }

    fn matrix(&mut self, transform: &Transform) {
        let (linear, moved) = (transform.linear(), transform.origin());
        if let Some(turn) = Transform::turning(linear) {
            if is_same(&turn, transform) {
                return self.line(format_args!("matrix {} /*= turn */", rows(&affine(linear, DVec3::ZERO))));
            }
            if is_same(&turn.then(&Transform::translation(moved)), transform) {
                let turn = rows(&affine(linear, DVec3::ZERO));
                return self.line(format_args!("matrix {turn} /*= turn */ translate {}", vector(moved)));
            }
        }
        let there = rows(&affine(linear, moved));
        match Transform::from_columns(linear.x_axis, linear.y_axis, linear.z_axis, moved) {
            Ok(plain) if is_same(&plain, transform) => self.line(format_args!("matrix {there}")),
            _ => {
                self.line(format_args!("matrix {there}"));
                self.note(format_args!("inverse {}", rows(&transform.inverse_affine())));
            }
        }
    }
}

fn affine(matrix3: DMat3, translation: DVec3) -> DAffine3 {
    DAffine3 { matrix3, translation }
}

/// The twelve numbers in POV-Ray's order: where x, y, z and the origin go.
fn rows(map: &DAffine3) -> String {
    numbers(&map.to_cols_array())
}

/// Whether two transformations are the same to the bit, there and back.
fn is_same(a: &Transform, b: &Transform) -> bool {
    let bits = |t: &Transform| {
        let there = affine(t.linear(), t.origin()).to_cols_array().map(f64::to_bits);
        (there, t.inverse_affine().to_cols_array().map(f64::to_bits))
    };
    bits(a) == bits(b)
}
