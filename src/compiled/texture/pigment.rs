//! Colours for points.

use super::{Blend, Context, ImageMap, Pattern, Pick};
use crate::math::{Color, DVec3, LANES, Points, Rgb};

/// A colour for each point.
#[derive(Clone, Debug)]
pub enum Pigment {
    /// The same everywhere.
    Solid(Color),
    /// A pattern through colours.
    Colors(Pattern, Blend<Color>),
    /// A pattern through other pigments.
    Pigments(Pattern, Blend<Pigment>),
    /// A picture; the pattern carries its warps.
    Image(Pattern, Box<ImageMap>),
    /// Everything inside is looked up at (u, v, 0).
    Uv(Box<Pigment>),
}

/// White and clear: what a picture shows outside of itself.
const CLEAR: Color = Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };

impl Pigment {
    /// The colour at a point of the containing space; `None` where a picture shown once leaves a hole.
    pub fn color(&self, point: DVec3, context: &Context) -> Option<Color> {
        match self {
            Self::Solid(color) => Some(*color),
            Self::Colors(pattern, colors) => Some(blended(pattern, colors, point, context)),
            Self::Pigments(pattern, pigments) => {
                let (pick, warped) = pattern.pick(pigments, point, context);
                Some(match pick {
                    Pick::One(pigment) => pigment.color_or_clear(warped, context),
                    Pick::Two(lower, upper, share) => {
                        lower.color_or_clear(warped, context).lerp(upper.color_or_clear(warped, context), share)
                    }
                    Pick::All(all) => weighted_sum(all.iter().map(|(w, p)| (*w, p.color_or_clear(warped, context)))),
                })
            }
            Self::Image(pattern, image) => image.color(pattern.warp(point)),
            Self::Uv(pigment) => pigment.color(context.uv_point(), context),
        }
    }

    /// The colour at a point; white and clear in holes.
    pub fn color_or_clear(&self, point: DVec3, context: &Context) -> Color {
        match self {
            Self::Colors(pattern, colors) => blended(pattern, colors, point, context),
            _ => self.color(point, context).unwrap_or(CLEAR),
        }
    }

    /// [`color`](Self::color) at four points, each with its context.
    pub fn colors(&self, points: &Points, contexts: [&Context; LANES]) -> [Option<Color>; LANES] {
        match self {
            Self::Colors(..) | Self::Pigments(..) => self.colors_or_clear(points, contexts).map(Some),
            Self::Uv(pigment) => pigment.colors(&uv_points(contexts), contexts),
            Self::Solid(_) | Self::Image(..) => std::array::from_fn(|i| self.color(points.lane(i), contexts[i])),
        }
    }

    /// [`color_or_clear`](Self::color_or_clear) at four points, each with its context.
    fn colors_or_clear(&self, points: &Points, contexts: [&Context; LANES]) -> [Color; LANES] {
        let (pattern, items) = match self {
            Self::Colors(pattern, colors) => {
                let warped = pattern.warp_points(points);
                let values = pattern.values_at_warped(&warped, contexts);
                return values.map(|value| picked(colors.pick(value)));
            }
            Self::Pigments(pattern, pigments) => (pattern, pigments),
            _ => return self.colors(points, contexts).map(|color| color.unwrap_or(CLEAR)),
        };
        let warped = pattern.warp_points(points);
        if let Blend::Average(all) = items {
            let mut sums = [Color::default(); LANES];
            for (weight, pigment) in all {
                let colors = pigment.colors_or_clear(&warped, contexts);
                sums = std::array::from_fn(|i| plus(sums[i], *weight, colors[i]));
            }
            return sums;
        }
        let values = pattern.values_at_warped(&warped, contexts);
        // Neighbours mostly show the same items.
        match values.map(|value| items.pick(value)) {
            [Pick::One(a), Pick::One(b), Pick::One(c), Pick::One(d)] if [b, c, d].iter().all(|p| std::ptr::eq(*p, a)) => {
                a.colors_or_clear(&warped, contexts)
            }
            picks => std::array::from_fn(|i| {
                let color = |pigment: &Self| pigment.color_or_clear(warped.lane(i), contexts[i]);
                match picks[i] {
                    Pick::One(pigment) => color(pigment),
                    Pick::Two(lower, upper, share) => color(lower).lerp(color(upper), share),
                    Pick::All(all) => weighted_sum(all.iter().map(|(w, p)| (*w, color(p)))),
                }
            }),
        }
    }

    /// Whether it pays to find the colours of neighbours at once: there is a pattern, and none that looks at normals,
    /// which the bumps of other layers change.
    pub fn is_side_by_side(&self) -> bool {
        match self {
            Self::Solid(_) | Self::Image(..) => false,
            Self::Colors(..) | Self::Pigments(..) => !self.sees_normals(),
            Self::Uv(pigment) => pigment.is_side_by_side(),
        }
    }

    /// Whether the colour depends on the normal.
    pub(super) fn sees_normals(&self) -> bool {
        match self {
            Self::Solid(_) => false,
            Self::Colors(pattern, _) | Self::Image(pattern, _) => pattern.kind.sees_normals(),
            Self::Pigments(pattern, pigments) => {
                pattern.kind.sees_normals() || pigments.iter().any(Self::sees_normals)
            }
            Self::Uv(pigment) => pigment.sees_normals(),
        }
    }

    /// Lets all light through unchanged that was filtered, but for that of pictures.
    pub fn unfilter(&mut self) {
        let unfilter = |c: &mut Color| {
            c.transmit += c.filter;
            c.filter = 0.0;
        };
        match self {
            Self::Solid(color) => unfilter(color),
            Self::Colors(_, colors) => colors.iter_mut().for_each(unfilter),
            Self::Pigments(_, pigments) => pigments.iter_mut().for_each(Self::unfilter),
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

fn weighted_sum(items: impl Iterator<Item = (f32, Color)>) -> Color {
    items.fold(Color::default(), |sum, (weight, color)| plus(sum, weight, color))
}

fn plus(sum: Color, weight: f32, color: Color) -> Color {
    Color {
        rgb: sum.rgb + weight * color.rgb,
        filter: sum.filter + weight * color.filter,
        transmit: sum.transmit + weight * color.transmit,
    }
}

/// Lookups at (u, v, 0).
fn uv_points(contexts: [&Context; LANES]) -> Points {
    contexts.map(Context::uv_point).into()
}

#[cfg(test)]
mod tests {
    use super::super::PatternKind;
    use super::*;

    fn check(pigment: &Pigment, x: f64, expected: [f32; 5]) {
        let found = pigment.color(DVec3::new(x, 0.0, 0.0), &Context::default()).unwrap();
        let found = [found.rgb.x, found.rgb.y, found.rgb.z, found.filter, found.transmit];
        found.iter().zip(expected).for_each(|(f, e)| assert!((f - e).abs() < 1e-6, "{found:?} {expected:?}"));
    }

    #[test]
    fn all_five_components_blend() {
        let gradient = || Pattern::of(PatternKind::Gradient(DVec3::X));
        let red = Color::rgb(1.0, 0.0, 0.0);
        let clear_green = Color { rgb: Rgb::Y, filter: 0.5, transmit: 0.25 };
        let map = Blend::map([(f64::from(0.2f32), red), (f64::from(0.6f32), clear_green)]);
        check(&Pigment::Colors(gradient(), map), 0.3, [0.75, 0.25, 0.0, 0.125, 0.0625]);
        let grey = Blend::map([(0.0, Color::BLACK), (1.0, Color::rgb(1.0, 1.0, 1.0))]);
        let items = [(1.0, Pigment::Solid(Color { transmit: 0.5, ..red })), (3.0, Pigment::Colors(gradient(), grey))];
        let average = Pigment::Pigments(Pattern::of(PatternKind::None), Blend::average(items));
        check(&average, 0.4, [0.55, 0.3, 0.3, 0.0, 0.125]);
    }
}
