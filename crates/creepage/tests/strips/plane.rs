//! The plane half-space, integrated numerically: independent of the theories' closed forms.

use std::f64::consts::FRAC_PI_2;
use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

/// Principal value of `int traction(t) / (x - t) dt` over `[breaks[0], breaks[last]]`, for a
/// traction that is smooth between the ascending `breaks`, and like a square root at them. `x`
/// lies between the first and the last, and is none of them.
pub(crate) fn principal_value(traction: impl Fn(f64) -> f64, breaks: &[f64], x: f64) -> f64 {
    let rule = GaussLegendre::new(NonZeroUsize::new(120).unwrap());
    // t = middle + half sin(phi) turns square roots at the ends into smooth functions.
    let between = |from: f64, to: f64, f: &dyn Fn(f64) -> f64| {
        let (middle, half) = (f64::midpoint(from, to), 0.5 * (to - from));
        let integrand = |phi: f64| half * phi.cos() * f(middle + half * phi.sin());
        rule.integrate(-FRAC_PI_2, FRAC_PI_2, integrand)
    };
    // Symmetric about the pole, up to the next break on either side, the pole cancels.
    let reach = breaks.iter().map(|b| (b - x).abs()).fold(f64::INFINITY, f64::min);
    let folded = |s: f64| (traction(x - s) - traction(x + s)) / s;
    let mut sum = between(0.0, reach, &folded);
    let kernel = |t: f64| traction(t) / (x - t);
    for pair in breaks.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        if to <= x - reach || from >= x + reach {
            sum += between(from, to, &kernel);
        } else {
            // Towards the pole in steps that double, so that it stays as far as they are long.
            sum += geometric(from, x - reach, &|a, b| between(a, b, &kernel), x);
            sum += geometric(x + reach, to, &|a, b| between(a, b, &kernel), x);
        }
    }
    sum
}

fn geometric(from: f64, to: f64, between: &dyn Fn(f64, f64) -> f64, pole: f64) -> f64 {
    if to - from < 1e-15 {
        return 0.0;
    }
    let middle = f64::midpoint(from, to);
    let distance = (pole - from).abs().min((pole - to).abs());
    if to - from <= 2.0 * distance {
        return between(from, to);
    }
    geometric(from, middle, between, pole) + geometric(middle, to, between, pole)
}

/// `PV int sqrt(1 - t^2) / (x - t) dt = pi x` for `|x| < 1`.
#[test]
fn the_quadrature_knows_the_semicircle() {
    for x in [-0.999, -0.7, -1e-3, 0.4, 0.95] {
        let value = principal_value(|t| (1.0 - t * t).max(0.0).sqrt(), &[-1.0, 1.0], x);
        // Rounding in the folded difference quotient.
        assert!((value / std::f64::consts::PI - x).abs() < 3e-14, "{x}: {value}");
    }
}
