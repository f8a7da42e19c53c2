//! `blob { … }`.

use super::modifiers::MODIFIERS;
use super::shape::POV_DEGENERATE;
use super::table::{Block, Item, Takes, Word};
use crate::diag::{SourceResult, Span};
use crate::eval::Evaluator;
use crate::math::{DVec3, Transform};
use crate::scene::{Blob, BlobComponent, Shape};
use crate::syntax::Keyword as K;
use std::sync::Arc;

pub(super) static BLOB: Block<Blob> = Block::<Blob>::new(
    "blob",
    "balls and cylinders that flow into each other",
    &[
        Item::new(
            K::Threshold,
            Takes::Float(|blob| &mut blob.threshold),
            "1",
            "its surface is where the strengths add up to this",
        ),
        Item::new(
            K::Sphere,
            Takes::Other("{ <CENTRE>, RADIUS, [strength] STRENGTH … }", part),
            "",
            "a ball; a negative strength takes away",
        ),
        Item::new(
            K::Cylinder,
            Takes::Other("{ <END>, <END>, RADIUS, [strength] STRENGTH … }", part),
            "",
            "a cylinder with round ends",
        ),
        Item::new(
            K::Component,
            Takes::Other("STRENGTH, RADIUS, <CENTRE>", |e, blob, _| {
                let strength = e.float()?;
                e.comma()?;
                let radius = e.float()?;
                e.comma()?;
                let center = e.vector()?;
                blob.components.push(component([center, center], false, radius, strength));
                Ok(())
            }),
            "",
            "outdated: a ball",
        ),
    ],
)
.with(&[&MODIFIERS]);

pub(super) static COMPONENT: Block<BlobComponent> = Block::moved(
    "blob component",
    "what a ball or cylinder of a blob takes behind its numbers",
    |_, part, transform| {
        part.transform = part.transform.then(transform);
        if let Some(texture) = &mut part.texture {
            texture.place.apply(transform);
        }
    },
    &[
        Item::new(
            K::Texture,
            Takes::Other("{ TEXTURE }", |e, part, at| {
                let texture = e.texture_block()?;
                let below = part.texture.take();
                part.texture = Some(e.layer_over(below, texture, at.span)?);
                Ok(())
            }),
            "",
            "what the blob looks like around here",
        ),
        Item::new(K::Pigment, Takes::Other("{ PIGMENT }", change_top_layer), "", "its colours"),
        Item::new(K::Normal, Takes::Other("{ NORMAL }", change_top_layer), "", "its bumps"),
        Item::new(K::Finish, Takes::Other("{ FINISH }", change_top_layer), "", "how it shines and mirrors"),
    ],
);

impl Evaluator<'_> {
    pub(super) fn blob(&mut self, span: Span) -> SourceResult<Shape> {
        let mut blob = Blob { threshold: 1.0, components: Vec::new(), sturm: false };
        self.comma()?;
        self.items_of(&BLOB, &mut blob)?;
        if blob.components.is_empty() {
            return self.error(span, "a blob needs at least one sphere or cylinder");
        }
        Ok(Shape::Blob(Arc::new(blob)))
    }
}

/// `sphere` and `cylinder`, which take the same behind their ends.
fn part(e: &mut Evaluator<'_>, blob: &mut Blob, at: Word) -> SourceResult<()> {
    let is_cylinder = at.word == K::Cylinder;
    e.open("blob component")?;
    let span = e.span();
    let first = e.vector()?;
    e.comma()?;
    let second = if is_cylinder { e.vector()? } else { first };
    e.comma()?;
    let radius = e.float()?;
    e.comma()?;
    e.accept(K::Strength)?;
    let strength = e.float()?;
    let size = first.abs().max(second.abs()).max_element().max(radius.abs()).min(1.0);
    if is_cylinder && (first == second || (second - first).length() < POV_DEGENERATE * size) {
        return e.error(span, "the two ends of a blob cylinder must not be the same point");
    }
    let mut part = component([first, second], is_cylinder, radius, strength);
    while e.item_of(&COMPONENT, &mut part)? {}
    e.close_of(&COMPONENT)?;
    blob.components.push(part);
    Ok(())
}

fn change_top_layer(e: &mut Evaluator<'_>, part: &mut BlobComponent, at: Word) -> SourceResult<()> {
    let placed = part.texture.take();
    part.texture = Some(e.change_top_layer(placed, at)?);
    Ok(())
}

fn component(ends: [DVec3; 2], is_cylinder: bool, radius: f64, strength: f64) -> BlobComponent {
    BlobComponent { ends, is_cylinder, radius, strength, transform: Transform::IDENTITY, texture: None }
}
