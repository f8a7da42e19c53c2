//! Normals.

use super::pattern::mapping_of;
use super::{Refusal, TextureCompiler};
use crate::compiled::texture::{Blend, Facets, Normal, NormalKind};
use crate::math::DMat3;
use crate::scene;

impl TextureCompiler<'_> {
    /// Compiles a normal by itself, for cameras.
    ///
    /// # Errors
    /// As [`texture`](Self::texture).
    pub fn normal(&mut self, normal: &scene::Normal) -> Result<Normal, Refusal> {
        self.part(|compiler| compiler.whole_normal(normal)).map_err(|r| r.at(normal.span))
    }

    fn whole_normal(&mut self, normal: &scene::Normal) -> Result<Normal, Refusal> {
        let (kind, linear) = match &normal.kind {
            scene::NormalKind::Pattern(pattern, slopes) => {
                let pattern = self.pattern(pattern)?;
                let slopes = slopes.as_ref().filter(|s| !s.is_empty());
                let slopes = slopes.map(|s| Blend::map(s.iter().map(|e| (f64::from(e.value), e.item.map(f64::from)))));
                let linear = pattern.linear();
                (NormalKind::Pattern(pattern, slopes), linear)
            }
            scene::NormalKind::Normals(pattern, normals) if matches!(pattern.kind, scene::PatternKind::Uv) => {
                let inner = normals.items().next().ok_or("a map is missing")?;
                (NormalKind::Uv(Box::new(self.normal(inner)?)), DMat3::IDENTITY)
            }
            scene::NormalKind::Normals(pattern, normals) => {
                let pattern = self.pattern(pattern)?;
                let normals = self.blend(normals, |compiler, n| compiler.shared_normal(n))?;
                let linear = pattern.linear();
                (NormalKind::Normals(pattern, normals), linear)
            }
            scene::NormalKind::BumpMap(pattern, picture) => {
                let pattern = self.pattern(pattern)?;
                let raster = self.value_picture(&picture.0)?;
                let linear = pattern.linear();
                (NormalKind::BumpMap(pattern, raster, mapping_of(&picture.1)), linear)
            }
            scene::NormalKind::Facets { pattern, coords, size, metric } => {
                let pattern = self.pattern(pattern)?;
                let linear = pattern.linear();
                (NormalKind::Facets(pattern, Facets { coords: *coords, size: *size, metric: *metric }), linear)
            }
        };
        let mut compiled = Normal {
            kind,
            amount: f64::from(normal.amount),
            accuracy: f64::from(normal.accuracy),
            no_bump_scale: false,
            pattern_from_outer: linear,
        };
        if normal.no_bump_scale {
            compiled.keep_bump_depth();
        }
        Ok(compiled)
    }
}
