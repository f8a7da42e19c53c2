//! Colours for points.

use super::{Blend, Context, ImageMap, Pattern, PatternKind, Pick};
use crate::math::{Color, DVec3, LANES, Points, Uv, each_lane};
use std::sync::Arc;

/// A colour for each point. Copies that stand elsewhere share everything but the pattern.
#[derive(Clone, Debug)]
pub enum Pigment {
    /// The same everywhere.
    Solid(Color),
    /// A pattern through colours.
    Colors(Box<Pattern>, Arc<Blend<Color>>),
    /// A pattern through other pigments.
    Pigments(Box<Pattern>, Arc<Blend<Pigment>>),
    /// A picture; the pattern carries its warps.
    Image(Box<Pattern>, Arc<ImageMap>),
    /// Everything inside is looked up at (u, v, 0).
    Uv(Box<Pigment>),
}

/// From so many patterns on finding the colours of neighbours together gains more than bringing them together costs,
/// even without noise (measured).
const MANY_PATTERNS: usize = 4;

impl Pigment {
    /// The colour at a point of the containing space; `None` where a picture shown once leaves a hole.
    pub fn color(&self, point: DVec3, context: &Context) -> Option<Color> {
        match self {
            Self::Solid(color) => Some(*color),
            Self::Colors(pattern, colors) => Some(blended(pattern, colors, point, context)),
            Self::Pigments(pattern, pigments) => {
                let (pick, warped) = pattern.pick(pigments, point, context);
                Some(mixed(&pick, warped, context))
            }
            Self::Image(pattern, image) => image.color(pattern.warp(point)),
            Self::Uv(pigment) => pigment.color(context.uv_point(), context),
        }
    }

    /// The colour at a point; white and clear in holes.
    pub fn color_or_clear(&self, point: DVec3, context: &Context) -> Color {
        match self {
            Self::Colors(pattern, colors) => blended(pattern, colors, point, context),
            _ => self.color(point, context).unwrap_or(Color::CLEAR),
        }
    }

    /// [`color_or_clear`](Self::color_or_clear) at four points, each with its surface coordinates; of a pigment that
    /// is [worked out side by side](Self::is_side_by_side) or is part of one.
    pub fn colors(&self, points: &Points, uvs: &[Uv; LANES]) -> [Color; LANES] {
        match self {
            Self::Solid(color) => [*color; LANES],
            Self::Colors(pattern, colors) => {
                let values = pattern.values_at_warped(&pattern.warp_points(points), uvs);
                each_lane(|i| picked(colors.pick(values[i])))
            }
            Self::Pigments(pattern, pigments) => {
                let warped = pattern.warp_points(points);
                if let Blend::Average(all) = &**pigments {
                    let mut sums = [Color::default(); LANES];
                    all.iter().for_each(|(weight, pigment)| pigment.add_colors(&warped, uvs, *weight, &mut sums));
                    return sums;
                }
                let values = pattern.values_at_warped(&warped, uvs);
                let picks = each_lane(|i| pigments.pick(values[i]));
                match picks[0] {
                    Pick::One(pigment) if picks.iter().all(|pick| pick.is_like(&picks[0])) => {
                        pigment.colors(&warped, uvs)
                    }
                    Pick::Two(lower, upper, _) if picks.iter().all(|pick| pick.is_like(&picks[0])) => {
                        let (lower, upper) = (lower.colors(&warped, uvs), upper.colors(&warped, uvs));
                        each_lane(|i| lower[i].lerp(upper[i], picks[i].share()))
                    }
                    _ => each_lane(|i| {
                        let context = Context { uv: uvs[i], ..Context::default() };
                        mixed(&picks[i], warped.lane(i), &context)
                    }),
                }
            }
            Self::Image(pattern, image) => {
                let warped = pattern.warp_points(points);
                each_lane(|i| image.color(warped.lane(i)).unwrap_or(Color::CLEAR))
            }
            Self::Uv(pigment) => pigment.colors(&each_lane(|i| uvs[i].lookup_point()).into(), uvs),
        }
    }

    /// Adds `weight` times the colours at four points; the most frequent pigments do so without another array.
    fn add_colors(&self, points: &Points, uvs: &[Uv; LANES], weight: f32, sums: &mut [Color; LANES]) {
        if let Self::Colors(pattern, colors) = self {
            let values = pattern.values_at_warped(&pattern.warp_points(points), uvs);
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum = sum.plus(weight, picked(colors.pick(value))));
        } else {
            let colors = self.colors(points, uvs);
            sums.iter_mut().zip(colors).for_each(|(sum, color)| *sum = sum.plus(weight, color));
        }
    }

    /// Whether it pays to find the colours of neighbours at once: there is noise, or there are many patterns; none looks
    /// at normals, which the bumps of other layers change; and no picture may leave holes.
    pub fn is_side_by_side(&self) -> bool {
        match self {
            Self::Solid(_) | Self::Image(..) => false,
            Self::Colors(..) | Self::Pigments(..) => {
                (self.has(&Pattern::is_noisy) || self.n_patterns() >= MANY_PATTERNS) && !self.sees_normals()
            }
            Self::Uv(pigment) => pigment.is_side_by_side(),
        }
    }

    /// Whether looking it up takes long: there is noise, or a search.
    pub fn is_dear(&self) -> bool {
        let searches = |pattern: &Pattern| {
            matches!(pattern.kind, PatternKind::Crackle(_) | PatternKind::Fractal(_) | PatternKind::Function(_))
        };
        self.has(&|pattern| pattern.is_noisy() || searches(pattern))
    }

    /// How many patterns it is made of.
    fn n_patterns(&self) -> usize {
        match self {
            Self::Solid(_) => 0,
            Self::Colors(..) | Self::Image(..) => 1,
            Self::Pigments(_, pigments) => 1 + pigments.iter().map(Self::n_patterns).sum::<usize>(),
            Self::Uv(pigment) => pigment.n_patterns(),
        }
    }

    /// Whether the colour depends on the normal.
    pub fn sees_normals(&self) -> bool {
        self.has(&|pattern| pattern.kind.sees_normals())
    }

    /// Whether a pattern of some sort is among its own.
    pub(super) fn has(&self, is_such: &impl Fn(&Pattern) -> bool) -> bool {
        match self {
            Self::Solid(_) => false,
            Self::Colors(pattern, _) | Self::Image(pattern, _) => is_such(pattern),
            Self::Pigments(pattern, pigments) => is_such(pattern) || pigments.iter().any(|p| p.has(is_such)),
            Self::Uv(pigment) => pigment.has(is_such),
        }
    }

    /// Lets all light through unchanged that was filtered, but for that of pictures.
    pub fn unfilter(&mut self) {
        match self {
            Self::Solid(color) => color.unfilter(),
            Self::Colors(_, colors) => Arc::make_mut(colors).iter_mut().for_each(Color::unfilter),
            Self::Pigments(_, pigments) => Arc::make_mut(pigments).iter_mut().for_each(Self::unfilter),
            Self::Uv(pigment) => pigment.unfilter(),
            Self::Image(..) => {}
        }
    }

    /// Whether no light comes through anywhere.
    pub fn is_opaque(&self) -> bool {
        let opaque = |c: &Color| c.filter == 0.0 && c.transmit == 0.0;
        match self {
            Self::Solid(color) => opaque(color),
            Self::Colors(_, colors) => colors.iter().all(opaque),
            Self::Pigments(_, pigments) => pigments.iter().all(Self::is_opaque),
            Self::Image(_, image) => image.is_opaque(),
            Self::Uv(pigment) => pigment.is_opaque(),
        }
    }
}

#[inline]
fn blended(pattern: &Pattern, colors: &Blend<Color>, point: DVec3, context: &Context) -> Color {
    picked(pattern.pick_at_warped(colors, pattern.warp(point), context))
}

#[inline]
fn picked(pick: Pick<'_, Color>) -> Color {
    match pick {
        Pick::One(color) => *color,
        Pick::Two(lower, upper, share) => lower.lerp(*upper, share),
        Pick::All(all) => weighted_sum(all.iter().copied()),
    }
}

/// The colour of what was picked of some pigments.
fn mixed(pick: &Pick<'_, Pigment>, point: DVec3, context: &Context) -> Color {
    let color = |pigment: &Pigment| pigment.color_or_clear(point, context);
    match pick {
        Pick::One(pigment) => color(pigment),
        Pick::Two(lower, upper, share) => color(lower).lerp(color(upper), *share),
        Pick::All(all) => weighted_sum(all.iter().map(|(w, p)| (*w, color(p)))),
    }
}

fn weighted_sum(items: impl Iterator<Item = (f32, Color)>) -> Color {
    items.fold(Color::default(), |sum, (weight, color)| sum.plus(weight, color))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn check(pigment: &Pigment, x: f64, expected: [f32; 5]) {
        let found = pigment.color(DVec3::new(x, 0.0, 0.0), &Context::default()).unwrap();
        let found = [found.rgb.x, found.rgb.y, found.rgb.z, found.filter, found.transmit];
        found.iter().zip(expected).for_each(|(f, e)| assert!((f - e).abs() < 1e-6, "{found:?} {expected:?}"));
    }

    #[test]
    fn all_five_components_blend() {
        let gradient = || Box::new(Pattern::of(PatternKind::Gradient(DVec3::X)));
        let red = Color::rgb(1.0, 0.0, 0.0);
        let clear_green = Color { rgb: Rgb::Y, filter: 0.5, transmit: 0.25 };
        let map = Blend::map([(f64::from(0.2f32), red), (f64::from(0.6f32), clear_green)]);
        check(&Pigment::Colors(gradient(), Arc::new(map)), 0.3, [0.75, 0.25, 0.0, 0.125, 0.0625]);
        let grey = Blend::map([(0.0, Color::BLACK), (1.0, Color::rgb(1.0, 1.0, 1.0))]);
        let items =
            [(1.0, Pigment::Solid(Color { transmit: 0.5, ..red })), (3.0, Pigment::Colors(gradient(), Arc::new(grey)))];
        let average = Pigment::Pigments(Box::new(Pattern::of(PatternKind::None)), Arc::new(Blend::average(items)));
        check(&average, 0.4, [0.55, 0.3, 0.3, 0.0, 0.125]);
    }
}
