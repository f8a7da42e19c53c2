//! "Did you mean …?"

/// The candidate that differs least from `word`, if it is near enough to be a slip.
///
/// Near means at most one changed, missing, added or swapped letter for every three.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (word.chars().count() / 3).clamp(1, 3);
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let same_letters = candidate.eq_ignore_ascii_case(word);
        let distance = if same_letters { 0 } else { distance(word, candidate, limit) };
        if distance <= limit && best.is_none_or(|(d, c)| (distance, candidate) < (d, c)) && candidate != word {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// The shortest candidate that begins with a word of some length.
pub fn completed<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    /// Shorter words begin too many others.
    const SHORTEST: usize = 5;
    let longer =
        candidates.into_iter().filter(|c| word.len() >= SHORTEST && c.len() > word.len() && c.starts_with(word));
    longer.min_by_key(|c| (c.len(), *c))
}

/// Edits that turn `a` into `b`, a swap of neighbours counting as one; anything above `limit`
/// may be returned as `limit + 1`. Source: optimal string alignment distance.
fn distance(a: &str, b: &str, limit: usize) -> usize {
    if a.len().abs_diff(b.len()) > limit {
        return limit + 1;
    }
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let substituted = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = substituted.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::{completed, nearest};

    #[test]
    fn beginnings_are_recognised() {
        let words = ["select", "reflection", "reflection_exponent", "box"];
        assert_eq!(completed("reflect", words), Some("reflection"));
        assert_eq!((completed("bo", words), completed("reflection_exponent", words)), (None, None));
    }

    fn check(word: &str, expected: Option<&str>) {
        assert_eq!(nearest(word, ["sphere", "box", "translate", "Chrome_Texture", "T1", "T2"]), expected, "{word}");
    }

    #[test]
    fn slips_are_recognised() {
        check("spere", Some("sphere"));
        check("shpere", Some("sphere"));
        check("Sphere", Some("sphere"));
        check("tanslatee", Some("translate"));
        check("ChromeTexture", Some("Chrome_Texture"));
        check("T3", Some("T1"));
        check("quux", None);
    }
}
