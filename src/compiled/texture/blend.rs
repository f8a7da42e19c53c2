//! From a pattern's value to what stands there.

/// How a value picks among items.
#[derive(Clone, Debug)]
pub enum Blend<T> {
    /// Linear between entries; block patterns have their items at 0, 1, 2, and so on.
    Map {
        /// Where the items stand, in source order.
        values: Box<[f64]>,
        /// As many items.
        items: Box<[T]>,
        /// Whether `values` never decrease, so that a binary search finds the entry.
        sorted: bool,
    },
    /// All items, each with its share; shares add up to 1.
    Average(Box<[(f32, T)]>),
}

/// One item, two neighbours, or all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pick<'a, T> {
    /// A single item.
    One(&'a T),
    /// Lower and upper neighbour and the upper one's share.
    Two(&'a T, &'a T, f32),
    /// All items with their shares.
    All(&'a [(f32, T)]),
}

impl<T> Pick<'_, T> {
    /// Whether another pick has the same items, in whatever shares.
    pub fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::One(a), Self::One(b)) => std::ptr::eq(*a, *b),
            (Self::Two(a, b, _), Self::Two(c, d, _)) => std::ptr::eq(*a, *c) && std::ptr::eq(*b, *d),
            (Self::All(_), Self::All(_)) => true,
            _ => false,
        }
    }

    /// The upper neighbour's share, 0 where there is none.
    pub fn share(&self) -> f32 {
        match self {
            Self::Two(.., share) => *share,
            Self::One(_) | Self::All(_) => 0.0,
        }
    }
}

/// As many entries are looked through one by one.
const FEW: usize = 8;

impl<T> Blend<T> {
    /// Entries in source order; there must be at least one.
    pub fn map(entries: impl IntoIterator<Item = (f64, T)>) -> Self {
        let (values, items): (Vec<_>, Vec<_>) = entries.into_iter().unzip();
        let sorted = values.is_sorted();
        Self::Map { values: values.into(), items: items.into(), sorted }
    }

    /// Items of a block pattern, by index.
    pub fn list(items: impl IntoIterator<Item = T>) -> Self {
        Self::map(items.into_iter().enumerate().map(|(i, item)| (i as f64, item)))
    }

    /// Weighted items; weights are scaled to a sum of 1.
    pub fn average(entries: impl IntoIterator<Item = (f32, T)>) -> Self {
        let mut entries: Vec<_> = entries.into_iter().collect();
        let total: f32 = entries.iter().map(|e| e.0).sum();
        entries.iter_mut().for_each(|e| e.0 /= total);
        Self::Average(entries.into())
    }

    /// All items.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        let (items, weighted): (&[T], &[(f32, T)]) = match self {
            Self::Map { items, .. } => (items, &[]),
            Self::Average(weighted) => (&[], weighted),
        };
        items.iter().chain(weighted.iter().map(|(_, item)| item))
    }

    /// All items, to change.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        let (items, weighted): (&mut [T], &mut [(f32, T)]) = match self {
            Self::Map { items, .. } => (items, &mut []),
            Self::Average(weighted) => (&mut [], weighted),
        };
        items.iter_mut().chain(weighted.iter_mut().map(|(_, item)| item))
    }

    /// What stands at a value.
    ///
    /// The last entry at and above its value; else the first entry not below the value, alone
    /// if it is the first or lies exactly there, blended with its predecessor otherwise. NaN
    /// takes the first. Source: pattern facts, section 11 (measured).
    #[inline(always)]
    pub fn pick(&self, value: f64) -> Pick<'_, T> {
        let (values, items, sorted) = match self {
            Self::Average(all) => return Pick::All(all),
            Self::Map { values, items, sorted } => (values, items, *sorted),
        };
        let last = values.len() - 1;
        if value >= values[last] {
            return Pick::One(&items[last]);
        }
        // The last entry lies above the value, so there is a first such entry unless the value is NaN.
        let j = if let [first, _] = **values {
            usize::from(value > first)
        } else if sorted && values.len() > FEW {
            values.partition_point(|e| *e < value)
        } else {
            values.iter().position(|e| *e >= value).unwrap_or(0)
        };
        if j == 0 || values[j] == value {
            return Pick::One(&items[j]);
        }
        let (above, width) = (value - values[j - 1], values[j] - values[j - 1]);
        // Many maps have one stretch from 0 to 1, and a division takes longer than the rest of this.
        let share = if width == 1.0 { above } else { above / width };
        Pick::Two(&items[j - 1], &items[j], share as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(entries: &[(f64, f32)], value: f64, expected: f32) {
        let blend = Blend::map(entries.iter().copied());
        let found = match blend.pick(value) {
            Pick::One(item) => *item,
            Pick::Two(a, b, t) => a + t * (b - a),
            Pick::All(_) => unreachable!("a map is no average"),
        };
        assert!((found - expected).abs() < 1e-6, "{found} instead of {expected} at {value}");
    }

    #[test]
    fn entries_are_found_as_povray_finds_them() {
        let doubled = [(0.0, 0.0), (0.4, 0.1), (0.4, 0.2), (0.4, 0.3), (1.0, 1.0)];
        check(&doubled, 0.4, 0.1);
        check(&doubled, 0.400_000_1, 0.300_000_1);
        check(&doubled, 0.7, 0.65);
        check(&doubled, -1.0, 0.0);
        check(&doubled, f64::NAN, 0.0);
        check(&[(0.0, 0.0), (0.5, 0.1), (0.5, 0.2)], 0.5, 0.2);
        let unsorted = [(0.8, 0.8), (0.4, 0.4), (1.0, 1.0)];
        check(&unsorted, 0.5, 0.8);
        check(&unsorted, 0.85, 0.8 + (0.85 - 0.4) / 0.6 * 0.0 + 0.05);
    }
}
