//! The integrand `T S` of (5.9) at one point, with its derivatives.
//!
//! `T S = | |s| X' - s |^2`, with `X' = (X', Y')` the traction over its bound and `s = (P, Q)`
//! the slip: (5.9) is nonlinear least squares. Written so, nothing cancels in full sliding
//! and nothing divides by a vanishing slip, as in (5.21)-(5.26). Those serve for any other
//! function of `T` and `S`: [`of_terms`].

/// Traction over its bound and slip at a point: `X', Y', P, Q` of (5.18).
pub(super) type State = [f64; 4];

/// `T S` and its derivatives by the state.
pub(super) struct Integrand {
    pub(super) value: f64,
    pub(super) gradient: [f64; 4],
    pub(super) hessian: [[f64; 4]; 4],
}

/// An integrand and its derivatives by `T` and `S` (5.17).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct IntegrandTerms {
    /// `f`, not negative; it should vanish where `T` or `S` does.
    pub f: f64,
    /// `f*`, by `T`.
    pub t: f64,
    /// `f.`, by `S`.
    pub s: f64,
    /// `f**`.
    pub tt: f64,
    /// `f*.`.
    pub ts: f64,
    /// `f..`.
    pub ss: f64,
}

/// Direction of the slip; where there is none the derivatives of `|s|` are taken as zero.
fn direction(slip: [f64; 2], magnitude: f64) -> [f64; 2] {
    if magnitude > 0.0 { slip.map(|component| component / magnitude) } else { [0.0; 2] }
}

/// `|s| X' - s`.
fn residual([x, y, p, q]: State) -> ([f64; 2], f64) {
    let magnitude = p.hypot(q);
    ([magnitude * x - p, magnitude * y - q], magnitude)
}

/// `T = |X' - s/|s||^2` and `S = |s|^2` (5.6).
pub(super) fn t_and_s([x, y, p, q]: State) -> [f64; 2] {
    let magnitude = p.hypot(q);
    let [wx, wy] = direction([p, q], magnitude);
    [(x - wx).powi(2) + (y - wy).powi(2), magnitude * magnitude]
}

/// `T S` with gradient and exact Hessian.
pub(super) fn with_derivatives(state: State) -> Integrand {
    let [x, y, p, q] = state;
    let ([rx, ry], magnitude) = residual(state);
    let [wx, wy] = direction([p, q], magnitude);
    let along = rx * x + ry * y;
    // d r = |s| dX' + slip ds, slip = X' w^T - 1.
    let slip = [[x * wx - 1.0, x * wy], [y * wx, y * wy - 1.0]];
    // Curvature of |s| across its direction; r.X'/|s| = |X'|^2 - w.X' stays bounded.
    let across = if magnitude > 0.0 { x * x + y * y - wx * x - wy * y } else { 0.0 };
    let traction = 2.0 * magnitude * magnitude;
    let cross = |i: usize, j: usize| 2.0 * (magnitude * slip[i][j] + [rx, ry][i] * [wx, wy][j]);
    let normal = [-wy, wx];
    let slipping = |i: usize, j: usize| {
        2.0 * (slip[0][i] * slip[0][j] + slip[1][i] * slip[1][j] + across * normal[i] * normal[j])
    };
    let (xp, xq, yp, yq) = (cross(0, 0), cross(0, 1), cross(1, 0), cross(1, 1));
    let (pp, pq, qq) = (slipping(0, 0), slipping(0, 1), slipping(1, 1));
    Integrand {
        value: rx * rx + ry * ry,
        gradient: [
            2.0 * magnitude * rx,
            2.0 * magnitude * ry,
            2.0 * (along * wx - rx),
            2.0 * (along * wy - ry),
        ],
        hessian: [
            [traction, 0.0, xp, xq],
            [0.0, traction, yp, yq],
            [xp, yp, pp, pq],
            [xq, yq, pq, qq],
        ],
    }
}

/// Any function of `T` and `S` with gradient and Hessian by the state: (5.21)-(5.26), with the
/// derivatives of the slip's direction taken as zero where there is no slip.
pub(super) fn of_terms(state: State, terms: &IntegrandTerms) -> Integrand {
    let [x, y, p, q] = state;
    let magnitude = p.hypot(q);
    let [wx, wy] = direction([p, q], magnitude);
    let rate = if magnitude > 0.0 { magnitude.recip() } else { 0.0 };
    let normal = [-wy * rate, wx * rate];
    // T = |X'|^2 - 2 X'.w + 1 turns with the direction w of the slip only.
    let (along, across) = (x * wx + y * wy, y * wx - x * wy);
    let t = [2.0 * (x - wx), 2.0 * (y - wy), -2.0 * across * normal[0], -2.0 * across * normal[1]];
    let s = [0.0, 0.0, 2.0 * p, 2.0 * q];
    let unit = [-wy, wx];
    let turning = |i: usize, j: usize| {
        let radial = [wx * rate, wy * rate];
        2.0 * (along * normal[i] * normal[j]
            + across * (radial[i] * normal[j] + normal[i] * radial[j]))
    };
    let tt = |i: usize, j: usize| match (i, j) {
        (0 | 1, 0 | 1) => f64::from(u8::from(i == j)) * 2.0,
        (0 | 1, _) => -2.0 * unit[i] * normal[j - 2],
        (_, 0 | 1) => -2.0 * unit[j] * normal[i - 2],
        _ => turning(i - 2, j - 2),
    };
    let ss = |i: usize, j: usize| if i == j && i > 1 { 2.0 } else { 0.0 };
    let hessian = |i: usize, j: usize| {
        terms.t * tt(i, j)
            + terms.s * ss(i, j)
            + terms.tt * t[i] * t[j]
            + terms.ts * (t[i] * s[j] + s[i] * t[j])
            + terms.ss * s[i] * s[j]
    };
    Integrand {
        value: terms.f,
        gradient: std::array::from_fn(|i| terms.t * t[i] + terms.s * s[i]),
        hessian: std::array::from_fn(|i| std::array::from_fn(|j| hessian(i, j))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences of step h: error h^2 times a third derivative of order ten.
    const TOLERANCE: f64 = 1e-7;
    const H: f64 = 1e-5;

    fn shifted(state: State, i: usize, by: f64) -> State {
        let mut moved = state;
        moved[i] += by;
        moved
    }

    #[test]
    fn derivatives_agree_with_differences() {
        for k in 0..50 {
            let state: State =
                std::array::from_fn(|i| (1.3 * f64::from(k) + 2.1 * i as f64).sin() + 0.1);
            let integrand = with_derivatives(state);
            for i in 0..4 {
                let (up, down) = (shifted(state, i, H), shifted(state, i, -H));
                let slope = (with_derivatives(up).value - with_derivatives(down).value) / (2.0 * H);
                assert!((integrand.gradient[i] - slope).abs() < TOLERANCE);
                let (up, down) = (with_derivatives(up), with_derivatives(down));
                for j in 0..4 {
                    let slope = (up.gradient[j] - down.gradient[j]) / (2.0 * H);
                    assert!((integrand.hessian[i][j] - slope).abs() < 1e-5);
                }
            }
        }
    }

    /// (5.21)-(5.26) for `f = T S` against the least-squares form.
    #[test]
    fn the_general_form_agrees_for_the_product() {
        for k in 0..50 {
            let state: State =
                std::array::from_fn(|i| (1.7 * f64::from(k) + 2.3 * i as f64).sin() + 0.05);
            let [t, s] = t_and_s(state);
            let terms = IntegrandTerms { f: t * s, t: s, s: t, ts: 1.0, ..Default::default() };
            let (general, product) = (of_terms(state, &terms), with_derivatives(state));
            // Rounding of entries of order ten that cancel once, over slips down to 0.1.
            assert!((general.value - product.value).abs() < 1e-13);
            for i in 0..4 {
                assert!((general.gradient[i] - product.gradient[i]).abs() < 1e-12);
                for j in 0..4 {
                    assert!((general.hessian[i][j] - product.hessian[i][j]).abs() < 1e-11);
                }
            }
        }
    }

    #[test]
    fn is_the_product_of_t_and_s() {
        for k in 0..50 {
            let state: State = std::array::from_fn(|i| (0.7 * f64::from(k) + i as f64).cos());
            let [t, s] = t_and_s(state);
            // Rounding of a product of order one.
            assert!((t * s - with_derivatives(state).value).abs() < 1e-14);
        }
    }

    #[test]
    fn no_slip_is_no_singularity() {
        let integrand = with_derivatives([0.3, -0.4, 0.0, 0.0]);
        assert!(integrand.value.abs() < f64::MIN_POSITIVE);
        assert!(integrand.gradient.iter().all(|entry| entry.abs() < f64::MIN_POSITIVE));
        assert!(integrand.hessian.iter().flatten().all(|entry| entry.is_finite()));
    }
}
