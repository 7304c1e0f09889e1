//! Where a smooth function first becomes positive, without sampling luck: bounds on its second derivative.

/// Narrower intervals are not split: there the function is known to bend·10⁻¹⁷.
const NARROW: f64 = 1e-8;

/// The first t in [`from`, `to`] with f > 0, right after the root, or None if f ≤ 0 throughout, up to rises
/// that end below `bend`·10⁻¹⁷. `f` gives value and derivative, `bend` bounds |f″|. Cost: O(log) evaluations
/// a simple root, more where f comes close to 0.
pub(super) fn first_rise(f: &impl Fn(f64) -> [f64; 2], bend: f64, from: f64, to: f64) -> Option<f64> {
    let (centre, half) = ((from + to) / 2.0, (to - from) / 2.0);
    let [value, slope] = f(centre);
    if value + slope.abs() * half + bend * half * half / 2.0 <= 0.0 {
        return None;
    }
    if f(from)[0] > 0.0 {
        return Some(from);
    }
    if slope.abs() > bend * half || half < NARROW {
        // Monotone (or too narrow for more than one sign change to matter).
        return (f(to)[0] > 0.0).then(|| bisect(f, from, to));
    }
    first_rise(f, bend, from, centre).or_else(|| first_rise(f, bend, centre, to))
}

/// The last double of the bracket f(from) ≤ 0 < f(to).
fn bisect(f: &impl Fn(f64) -> [f64; 2], mut from: f64, mut to: f64) -> f64 {
    loop {
        let centre = (from + to) / 2.0;
        if centre <= from || centre >= to {
            return to;
        }
        if f(centre)[0] > 0.0 { to = centre } else { from = centre }
    }
}

#[cfg(test)]
mod tests {
    use super::first_rise;

    #[test]
    fn narrow_rises_are_found_and_touching_is_none() {
        for height in [1e-3, 1e-9, 1e-14] {
            let f = |t: f64| [height - 1.0 + (3.0 * (t - 2.0)).cos(), -3.0 * (3.0 * (t - 2.0)).sin()];
            let root = 2.0 - (1.0f64 - height).acos() / 3.0;
            let t = first_rise(&f, 9.0, 0.1, 6.0).unwrap();
            assert!((t - root).abs() < 1e-16 / height.sqrt() + 1e-15, "{height:e}: {t} {root}");
            assert!(f(t)[0] > 0.0);
        }
        let below = |t: f64| [-1e-12 - 1.0 + t.cos(), -t.sin()];
        assert_eq!(first_rise(&below, 1.0, 0.5, 20.0), None);
        assert_eq!(first_rise(&|t| [t, 1.0], 0.0, 1.0, 2.0), Some(1.0));
    }
}
