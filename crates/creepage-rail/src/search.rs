//! Scalar searches: bisection for a threshold, Chandrupatla's root, golden-section minimum.

/// After which neighbours are those of rounding.
const HALVINGS: i32 = 36;

/// Halves the stretch between two places until `holds` changes between neighbours of rounding:
/// it holds at the first and not at the second.
pub(crate) fn threshold(
    [mut inside, mut outside]: [f64; 2],
    holds: impl Fn(f64) -> bool,
) -> [f64; 2] {
    for _ in 0..HALVINGS {
        let middle = inside.midpoint(outside);
        if holds(middle) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    [inside, outside]
}

/// Where a function, negative at the first of two places and not at the second, crosses zero: by the parabola
/// through three places where that is sure to help, else by halves (Chandrupatla 1997), as where it is infinite.
/// As near as [`threshold`], or until it is `small`; the first place where it is not negative even there.
pub(crate) fn crossing(ends: [f64; 2], small: f64, f: impl Fn(f64) -> f64) -> f64 {
    const MAX_EVALUATIONS: usize = 100;
    let least = 0.5_f64.powi(HALVINGS) * (ends[1] - ends[0]).abs();
    let [mut new, mut other] = ends.map(|place| (place, f(place)));
    let mut part = 0.5;
    if new.1 >= 0.0 {
        return new.0;
    }
    for _ in 0..MAX_EVALUATIONS {
        let place = new.0 + part * (other.0 - new.0);
        let (found, mut third) = ((place, f(place)), new);
        if (found.1 < 0.0) != (new.1 < 0.0) {
            (other, third) = (new, other);
        }
        new = found;
        let stretch = (other.0 - new.0).abs();
        if new.1.abs() <= small || stretch <= least {
            break;
        }
        let edge = (0.5 * least / stretch).min(0.5);
        part = parabola([new, other, third]).unwrap_or(0.5).clamp(edge, 1.0 - edge);
    }
    new.0
}

/// Where the parabola of place by value through three points crosses zero between the first two: the part of the way
/// from the first. `None` unless it rises or falls all along.
fn parabola([(a, fa), (b, fb), (c, fc)]: [(f64, f64); 3]) -> Option<f64> {
    let (along, height) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
    let is_monotone = height.powi(2) < along && (1.0 - height).powi(2) < 1.0 - along;
    is_monotone.then(|| {
        fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
    })
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    type Function = fn(f64) -> f64;

    /// Smooth, bent beside the place, steep at it, and infinite beside it.
    #[test]
    fn a_crossing_is_found_in_few_steps() {
        let place = 0.312_7;
        let functions: [(Function, usize); 4] = [
            (|x| x.exp() - 1.0, 11),
            (|x| if x < 0.1 { x } else { 30.0 * x - 2.9 }, 11),
            (|x| x.abs().sqrt().copysign(x), 40),
            (|x| if x < -0.2 { f64::NEG_INFINITY } else { x * (1.0 + x) }, 12),
        ];
        for (k, (function, most)) in functions.into_iter().enumerate() {
            for ends in [[0.0, 1.0], [0.3, 0.9]] {
                let calls = Cell::new(0);
                let found = crossing(ends, 1e-13, |x| {
                    calls.set(calls.get() + 1);
                    function(x - place)
                });
                assert!((found - place).abs() < 1e-10, "{k}: {found}");
                assert!(calls.get() <= most, "{k}: {} calls", calls.get());
            }
        }
        assert!(crossing([0.0, 1.0], 1e-13, |x| 1.0 + x).abs() < 1e-15);
        assert!((crossing([0.0, 1.0], 1e-13, |x| x - 2.0) - 1.0).abs() < 1e-10);
    }
}
