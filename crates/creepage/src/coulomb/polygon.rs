//! Displacement by constant tractions on polygons: the integrals of Boussinesq and Cerruti in
//! closed form, edge by edge.

/// Coefficients of a symmetric 2 x 2 response: `[u by X, u by Y = v by X, v by Y]`.
pub(crate) type Response = [f64; 3];

/// What an edge of a loaded polygon adds to the displacement difference `u`, in units of
/// `traction * length / (pi G)`; its ends lead from the field point, and the load lies on the left
/// of the way from the first to the second.
///
/// (2.11c) is integrated over the load with the divergence theorem: `x^2/R^3 = 1/R - d/dx (x/R)`,
/// and so on; `1/R` is the divergence of the position over `R`.
pub(crate) fn edge(poisson: f64, from: [f64; 2], to: [f64; 2]) -> Response {
    let [across, up] = [to[0] - from[0], to[1] - from[1]];
    let length = norm(across, up);
    if length == 0.0 {
        return [0.0; 3];
    }
    let ([tx, ty], [nx, ny]) = ([across / length, up / length], [up / length, -across / length]);
    let distance = nx * from[0] + ny * from[1];
    let ends = [from, to].map(|[x, y]| tx * x + ty * y);
    let radii = ends.map(|end| norm(distance, end));
    let inverse = distance_times_log(distance, ends, radii);
    let radial = radii[1] - radii[0];
    // Integrals of x/R and y/R along the edge.
    let [x, y] = [nx * inverse + tx * radial, ny * inverse + ty * radial];
    [inverse - poisson * nx * x, -poisson * nx * y, inverse - poisson * ny * y]
}

/// A third of the time went into `hypot`, whose care for overflow nothing needs here.
fn norm(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// Integral of `distance / R` along an edge; the logarithm is taken where nothing cancels.
fn distance_times_log(distance: f64, ends: [f64; 2], radii: [f64; 2]) -> f64 {
    if distance == 0.0 {
        return 0.0;
    }
    let ([t0, t1], [r0, r1]) = (ends, radii);
    let ratio = if t0 >= 0.0 {
        (t1 + r1) / (t0 + r0)
    } else if t1 <= 0.0 {
        (r0 - t0) / (r1 - t1)
    } else {
        (t1 + r1) / distance * ((r0 - t0) / distance)
    };
    distance * ratio.ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(poisson: f64, x: [f64; 2], y: [f64; 2]) -> Response {
        let corners = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
        std::array::from_fn(|k| {
            (0..4).map(|i| edge(poisson, corners[i], corners[(i + 1) % 4])[k]).sum()
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
    /// A parallelogram cut in two along a diagonal, with the field point inside, on an edge, at a
    /// corner and outside: the edge in common cancels.
    #[test]
    fn pieces_add_up() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.5, 1.0], [0.5, 1.0]];
        let sum = |at: [f64; 2], of: &[usize]| -> Response {
            let lead = |k: usize| [corners[k][0] - at[0], corners[k][1] - at[1]];
            std::array::from_fn(|k| {
                let ends = of.iter().zip(of.iter().cycle().skip(1));
                ends.map(|(from, to)| edge(0.3, lead(*from), lead(*to))[k]).sum()
            })
        };
        for at in [[1.0, 0.3], [1.0, 0.0], [2.0, 0.0], [4.0, -3.0]] {
            let whole = sum(at, &[0, 1, 2, 3]);
            let pieces = [sum(at, &[0, 1, 2]), sum(at, &[0, 2, 3])];
            for k in 0..3 {
                assert!((pieces[0][k] + pieces[1][k] - whole[k]).abs() < 1e-14);
            }
            assert!(whole[0] > 0.0 && whole[2] > 0.0);
        }
    }
}
