//! Where a condition ceases to hold, and where a function is least.

/// Halves the stretch between two places until `holds` changes between neighbours of rounding:
/// it holds at the first and not at the second.
pub(crate) fn threshold(
    [mut inside, mut outside]: [f64; 2],
    holds: impl Fn(f64) -> bool,
) -> [f64; 2] {
    for _ in 0..36 {
        let middle = inside.midpoint(outside);
        if holds(middle) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    [inside, outside]
}

/// Where a function with one minimum between `low` and `high` is least: golden sections, to a
/// hundred thousandth of the stretch.
pub(crate) fn least(f: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    let part = 0.5 * (5f64.sqrt() - 1.0);
    let mut inner = [high - part * (high - low), low + part * (high - low)];
    let mut values = inner.map(&f);
    for _ in 0..24 {
        if values[0] < values[1] {
            high = inner[1];
            (inner[1], values[1]) = (inner[0], values[0]);
            inner[0] = high - part * (high - low);
            values[0] = f(inner[0]);
        } else {
            low = inner[0];
            (inner[0], values[0]) = (inner[1], values[1]);
            inner[1] = low + part * (high - low);
            values[1] = f(inner[1]);
        }
    }
    low.midpoint(high)
}
