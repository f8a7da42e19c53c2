//! Transformations.

use super::reader::Reader;
use super::tree::{Items, Node, Read, Rule, components, wrong};
use crate::math::{DAffine3, DMat3, DVec3, Transform};

impl<'a> Reader<'a> {
    /// A transformation.
    pub(super) fn transform(&self, node: Node<'a>) -> Read<Transform> {
        let inner = Items::of(node).node()?;
        let rule = inner.as_rule();
        let mut items = Items::of(inner.clone());
        if rule == Rule::matrix {
            return matrix(inner);
        }
        let v = items.vector()?;
        let made = match rule {
            Rule::translate => Transform::translation(v),
            Rule::rotate => Transform::rotation_deg(v),
            _ => Transform::scaling(v),
        };
        let usable = v.is_finite() && (rule != Rule::scale || v.recip().is_finite());
        if usable { Ok(made) } else { wrong(&inner, "this has no inverse: a number is too large, too small or zero") }
    }
}

/// A matrix, with what its inverse is to the bit where that is said.
fn matrix(node: Node<'_>) -> Read<Transform> {
    let mut items = Items::of(node.clone());
    let forward = DAffine3::from_cols_array(&components::<12>(&items.node()?)?);
    let columns = [forward.matrix3.x_axis, forward.matrix3.y_axis, forward.matrix3.z_axis];
    let made = if let Some(note) = items.optional(Rule::inverse_note) {
        let backward = DAffine3::from_cols_array(&components::<12>(&Items::of(note).node()?)?);
        Transform::from_both_ways(forward, backward).ok()
    } else if items.accept(Rule::turn_note) {
        let turn = Transform::turning(DMat3::from_cols(columns[0], columns[1], columns[2]));
        turn.filter(|_| forward.translation == DVec3::ZERO)
    } else {
        Transform::from_columns(columns[0], columns[1], columns[2], forward.translation).ok()
    };
    match made {
        Some(transform) => Ok(transform),
        None => wrong(&node, "this matrix has no inverse, or not the one that is said"),
    }
}
