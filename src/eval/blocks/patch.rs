//! Surfaces over a grid: height field and bicubic patch.

use super::modifiers::MODIFIERS;
use super::table::{Block, Item, Takes};
use crate::diag::{SourceResult, Span, Topic};
use crate::eval::Evaluator;
use crate::math::{DVec2, DVec3};
use crate::scene::{BicubicPatch, HeightField, Shape};
use crate::syntax::Keyword as K;
use std::sync::Arc;

pub(super) static HEIGHT_FIELD: Block<HeightField> = Block::<HeightField>::new(
    "height_field",
    "a landscape whose heights are a picture",
    &[
        Item::new(
            K::WaterLevel,
            Takes::Other("FLOAT", |e, field, _| {
                let level = e.float()?;
                field.water_level = if e.version < 200 { level / 256.0 } else { level };
                Ok(())
            }),
            "",
            "what is lower is left out, from 0 to 1",
        ),
        Item::new(K::Smooth, Takes::Nothing(|field| field.smooth = true), "", "it is lit as if it were round"),
    ],
)
.with(&[&MODIFIERS]);

/// A patch, and whether its type was given.
pub(super) struct Draft {
    patch: BicubicPatch,
    typed: bool,
}

pub(super) static BICUBIC_PATCH: Block<Draft> = Block::<Draft>::new(
    "bicubic_patch",
    "a bent surface over a grid of 4 by 4 points",
    &[
        Item::new(
            K::Type,
            Takes::Other("0 | 1", |e, draft, _| {
                draft.typed = true;
                e.patch_type().map(drop)
            }),
            "",
            "how much is kept in memory; without effect on the surface",
        ),
        Item::new(
            K::Flatness,
            Takes::Float(|draft| &mut draft.patch.flatness),
            "0",
            "where it is as flat as this it is not divided any more",
        ),
        Item::new(
            K::USteps,
            Takes::Other("INTEGER", |e, draft, _| {
                draft.patch.u_steps = e.patch_steps()?;
                Ok(())
            }),
            "0",
            "how often it is halved along one side",
        ),
        Item::new(
            K::VSteps,
            Takes::Other("INTEGER", |e, draft, _| {
                draft.patch.v_steps = e.patch_steps()?;
                Ok(())
            }),
            "0",
            "how often it is halved along the other side",
        ),
        Item::new(K::Accuracy, Takes::Other("FLOAT", |e, _, _| e.float().map(drop)), "", "without effect"),
        Item::since(
            350,
            K::UvVectors,
            Takes::Other("4 <U, V>", |e, draft, _| {
                for corner in &mut draft.patch.uv_corners {
                    *corner = e.vector2()?;
                    e.comma()?;
                }
                Ok(())
            }),
            "",
            "coordinates of its corners, for uv_mapping",
        ),
    ],
)
.with(&[&MODIFIERS]);

impl Evaluator<'_> {
    pub(super) fn height_field(&mut self) -> SourceResult<Shape> {
        let image = self.image()?;
        let mut field = HeightField { image, water_level: f64::NEG_INFINITY, smooth: false };
        self.comma()?;
        self.items_of(&HEIGHT_FIELD, &mut field)?;
        Ok(Shape::HeightField(Arc::new(field)))
    }

    pub(super) fn bicubic_patch(&mut self, span: Span) -> SourceResult<Shape> {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let patch =
            BicubicPatch { points: [[DVec3::ZERO; 4]; 4], uv_corners: corners, flatness: 0.0, u_steps: 0, v_steps: 0 };
        let mut draft = Draft { patch, typed: false };
        self.comma()?;
        loop {
            self.items_of(&BICUBIC_PATCH, &mut draft)?;
            if draft.typed || self.at_vector()? || !self.starts_expression()? {
                break;
            }
            draft.typed = true;
            self.old_patch(&mut draft.patch, span)?;
            self.comma()?;
        }
        let Draft { mut patch, typed } = draft;
        if !typed {
            return self.error(span, "a bicubic_patch needs a type");
        }
        let points = self.vector_list(16)?;
        for (i, point) in points.into_iter().enumerate() {
            patch.points[i / 4][i % 4] = point;
        }
        Ok(Shape::BicubicPatch(Arc::new(patch)))
    }

    fn patch_steps(&mut self) -> SourceResult<u32> {
        Ok(self.integer()?.clamp(0, 30) as u32)
    }

    fn patch_type(&mut self) -> SourceResult<i64> {
        let span = self.span();
        let kind = self.integer()?;
        if kind < 0 {
            return self.error(span, "the type of a bicubic_patch is 0 or 1");
        }
        if kind > 1 {
            self.warn(Topic::Range, span, "the type of a bicubic_patch is 0 or 1; 1 is used");
        }
        Ok(kind)
    }

    /// `type [flatness] u v` as bare numbers.
    fn old_patch(&mut self, patch: &mut BicubicPatch, span: Span) -> SourceResult<()> {
        self.warn(
            Topic::Outdated,
            span,
            "this is an old form of bicubic_patch; write 'type 1 flatness F u_steps U v_steps V'",
        );
        let kind = self.patch_type()?;
        self.comma()?;
        if kind >= 2 {
            patch.flatness = self.float()?;
            self.comma()?;
        }
        patch.u_steps = self.patch_steps()?;
        self.comma()?;
        patch.v_steps = self.patch_steps()?;
        Ok(())
    }
}
