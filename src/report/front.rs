//! Which rungs are worth climbing, and what equal error costs elsewhere.

/// What a rung costs and how wrong it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Point {
    /// In any unit.
    pub(super) cost: f64,
    /// In any unit.
    pub(super) error: f64,
}

/// Indices of the points to which no other is at least as good in both figures, cheap to dear.
pub(super) fn front(points: &[Point]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).filter(|&i| points[i].error.is_finite()).collect();
    order.sort_by(|&a, &b| {
        points[a].cost.total_cmp(&points[b].cost).then(points[a].error.total_cmp(&points[b].error)).then(a.cmp(&b))
    });
    let mut best = f64::INFINITY;
    order.retain(|&i| {
        let is_better = points[i].error < best;
        best = best.min(points[i].error);
        is_better
    });
    order
}

/// What an error costs on the front of `points`, between two of them on a straight line of logarithms.
///
/// An error above that of the cheapest point costs what that does; one that no point reaches has no cost.
pub(super) fn cost_of(points: &[Point], error: f64) -> Option<f64> {
    let front: Vec<Point> = front(points).into_iter().map(|i| points[i]).collect();
    let reached = front.iter().position(|point| point.error <= error)?;
    let here = front[reached];
    let Some(before) = reached.checked_sub(1).map(|i| front[i]) else { return Some(here.cost) };
    // Nothing that is exact has a logarithm.
    if here.error <= 0.0 || before.cost <= 0.0 {
        return Some(here.cost);
    }
    let share = (before.error / error).ln() / (before.error / here.error).ln();
    Some(before.cost * (here.cost / before.cost).powf(share))
}

/// Geometric mean; `None` of nothing.
pub(super) fn geometric_mean(values: &[f64]) -> Option<f64> {
    let mean = values.iter().map(|value| value.ln()).sum::<f64>() / values.len() as f64;
    (!values.is_empty()).then(|| mean.exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [Point; 5] = [
        Point { cost: 4.0, error: 0.04 },
        Point { cost: 1.0, error: 0.16 },
        Point { cost: 5.0, error: 0.05 },
        Point { cost: 16.0, error: 0.01 },
        Point { cost: 2.0, error: f64::NAN },
    ];

    #[test]
    fn the_front_leaves_out_what_others_beat() {
        assert_eq!(front(&POINTS), [1, 0, 3]);
        assert_eq!(front(&[]), [0; 0]);
    }

    #[test]
    fn costs_lie_between_those_of_neighbours() {
        let check = |error: f64, cost: Option<f64>| {
            let found = cost_of(&POINTS, error);
            assert!(found.zip(cost).map_or(found == cost, |(a, b)| (a / b - 1.0).abs() < 1e-12), "{error}: {found:?}");
        };
        check(0.5, Some(1.0));
        check(0.16, Some(1.0));
        check(0.08, Some(2.0));
        check(0.02, Some(8.0));
        check(0.01, Some(16.0));
        check(0.005, None);
    }

    #[test]
    fn the_geometric_mean_of_a_half_and_two_is_one() {
        assert_eq!(geometric_mean(&[]), None);
        assert!((geometric_mean(&[0.5, 2.0]).unwrap() - 1.0).abs() < 1e-12);
    }
}
