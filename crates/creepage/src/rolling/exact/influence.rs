//! Displacement by constant tractions on rectangles: the integrals of Boussinesq and Cerruti in
//! closed form.

/// Coefficients of a symmetric 2 x 2 response: `[u by X, u by Y = v by X, v by Y]`.
pub(super) type Response = [f64; 3];

/// The displacement difference `u`, in units of `traction * length / (pi G)`, is the alternating
/// sum of this primitive over the corners of the loaded rectangle; `x`, `y` lead from the field
/// point to a corner.
///
/// It integrates `(1 - sigma)/R + sigma x^2/R^3`, `sigma x y/R^3` and `(1 - sigma)/R + sigma
/// y^2/R^3` of (2.11c); what cancels in the alternating sum is left out.
pub(super) fn corner(poisson: f64, x: f64, y: f64) -> Response {
    let along_x = weighted_asinh(x, y);
    let along_y = weighted_asinh(y, x);
    [
        (1.0 - poisson) * along_x + along_y,
        -poisson * x.hypot(y),
        along_x + (1.0 - poisson) * along_y,
    ]
}

/// `p asinh(q / |p|)`, the integral of `p^2/R^3` over the quadrant's rectangle, with its limit 0.
fn weighted_asinh(p: f64, q: f64) -> f64 {
    if p == 0.0 { 0.0 } else { p * (q / p.abs()).asinh() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(poisson: f64, x: [f64; 2], y: [f64; 2]) -> Response {
        std::array::from_fn(|k| {
            corner(poisson, x[1], y[1])[k]
                - corner(poisson, x[0], y[1])[k]
                - corner(poisson, x[1], y[0])[k]
                + corner(poisson, x[0], y[0])[k]
        })
    }

    /// Midpoint sums of the integrand away from the load: their error is of order 1e-6 here.
    #[test]
    fn corners_sum_to_the_integral() {
        let (poisson, steps) = (0.3, 200);
        let (x, y) = ([0.5, 1.3], [-0.2, 0.9]);
        let mut sum = [0.0; 3];
        for i in 0..steps {
            for j in 0..steps {
                let at = |range: [f64; 2], k: usize| {
                    range[0] + (range[1] - range[0]) * (k as f64 + 0.5) / steps as f64
                };
                let (px, py) = (at(x, i), at(y, j));
                let r = px.hypot(py);
                sum[0] += (1.0 - poisson) / r + poisson * px * px / r.powi(3);
                sum[1] += poisson * px * py / r.powi(3);
                sum[2] += (1.0 - poisson) / r + poisson * py * py / r.powi(3);
            }
        }
        let area = (x[1] - x[0]) * (y[1] - y[0]) / (steps * steps) as f64;
        for (closed, sum) in rectangle(poisson, x, y).into_iter().zip(sum) {
            assert!((closed - sum * area).abs() < 1e-5, "{closed} {}", sum * area);
        }
    }

    /// Far away the load acts as a point; cancellation must not spoil what is left of it.
    #[test]
    fn far_away_a_rectangle_is_a_point_load() {
        let (poisson, side, distance) = (0.25, 1e-2, 40.0);
        let (x, y) = ([distance, distance + side], [-0.5 * side, 0.5 * side]);
        let r = distance + 0.5 * side;
        let found = rectangle(poisson, x, y);
        let expected = [side * side / r, 0.0, side * side * (1.0 - poisson) / r];
        for (found, expected) in found.into_iter().zip(expected) {
            // Next term of the expansion: (side/distance)^2 = 6e-8; rounding 1e-16 (r/side)^2.
            assert!((found - expected).abs() < 1e-7 * side * side / r, "{found} {expected}");
        }
    }
}
