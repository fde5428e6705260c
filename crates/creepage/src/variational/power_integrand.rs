//! Integrand of the power loss: a functional with one minimum, for slender contacts.
//!
//! Tractions within their bound leave `Z |s| - X.s >= 0` everywhere, and zero where Coulomb's law
//! holds. Summed over the contact the elastic part of the slip takes no power, `X.du/dx`
//! integrates to zero by reciprocity, which leaves the rigid slip `v` in it:
//!
//! `integral of Z (|s| - X'.v) >= 0`, zero for the solution of the problem.
//!
//! This is the principle of Brezis, Ekeland and Nayroles (1976) for rolling. `s` is linear in the
//! unknowns, so that the integral is convex: it has one minimum, which moves continuously with
//! the creepage. So it remains with the bound as a convex penalty,
//!
//! `k/2 (max(0, |X'| - 1 + |v|/k))^2`, `k` = mean of `|v|` over a margin,
//!
//! whose slope at the bound is `|v|`, what the traction there gains in full sliding. Full sliding
//! is exact therefore, and where polynomials ought to jump they may overshoot.
//!
//! Where rolling is not steady `s` has `-du/dq` as well, a difference backwards `u' - c u` of what was
//! and of what is, `c > 0`. Its power `X.(u' - c u)` is taken exactly, by the load-displacement
//! equations, not as a sum over the mesh, from whose errors the small `1/c` would be lost; `c X.u` is
//! twice the elastic energy times `c`, a positive quadratic form, so that all is still convex.

use super::integrand::{Integrand, State};

/// `|s| - X'.v`, with `|s|` rounded off, and the penalty.
pub(super) fn lost(
    [x, y, p, q]: State,
    [vx, vy]: [f64; 2],
    smoothing: f64,
    stiffness: f64,
) -> Integrand {
    let slip = p.hypot(q).hypot(smoothing);
    let curvature = |i: f64, j: f64, same: f64| (same - i * j / (slip * slip)) / slip;
    let mut lost = Integrand {
        value: slip - x * vx - y * vy,
        gradient: [-vx, -vy, p / slip, q / slip],
        hessian: [[0.0; 4]; 4],
    };
    lost.hessian[2][2] = curvature(p, p, 1.0);
    lost.hessian[2][3] = curvature(p, q, 0.0);
    lost.hessian[3][2] = lost.hessian[2][3];
    lost.hessian[3][3] = curvature(q, q, 1.0);
    penalize(&mut lost, [x, y], vx.hypot(vy), stiffness);
    lost
}

fn penalize(lost: &mut Integrand, [x, y]: [f64; 2], slip: f64, stiffness: f64) {
    let magnitude = x.hypot(y);
    let excess = magnitude - 1.0 + slip / stiffness;
    if excess <= 0.0 {
        return;
    }
    let [nx, ny] = [x / magnitude, y / magnitude];
    let around = excess / magnitude;
    lost.value += 0.5 * stiffness * excess * excess;
    lost.gradient[0] += stiffness * excess * nx;
    lost.gradient[1] += stiffness * excess * ny;
    lost.hessian[0][0] += stiffness * (nx * nx + around * ny * ny);
    lost.hessian[1][1] += stiffness * (ny * ny + around * nx * nx);
    let mixed = stiffness * (1.0 - around) * nx * ny;
    lost.hessian[0][1] += mixed;
    lost.hessian[1][0] += mixed;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences of step 1e-5: the smoothing makes derivatives of order 1e3.
    #[test]
    fn derivatives_agree_with_differences() {
        const H: f64 = 1e-5;
        for k in 0..50 {
            let state: State =
                std::array::from_fn(|i| (1.3 * f64::from(k) + 2.1 * i as f64).sin() + 0.1);
            let at = |i: usize, by: f64| {
                let mut moved = state;
                moved[i] += by;
                lost(moved, [0.4, -0.7], 0.2, 6.0)
            };
            let here = at(0, 0.0);
            for i in 0..4 {
                let (up, down) = (at(i, H), at(i, -H));
                let slope = (up.value - down.value) / (2.0 * H);
                assert!((here.gradient[i] - slope).abs() < 1e-7);
                for j in 0..4 {
                    let slope = (up.gradient[j] - down.gradient[j]) / (2.0 * H);
                    assert!((here.hessian[i][j] - slope).abs() < 1e-5);
                }
            }
        }
    }

    /// Convex: no direction of the state lowers the slope.
    #[test]
    fn is_convex() {
        for k in 0..200 {
            let wave = |i: usize| (0.9 * f64::from(k) + 1.9 * i as f64).sin();
            let state: State = std::array::from_fn(|i| 1.3 * wave(i));
            let change: State = std::array::from_fn(|i| wave(i + 7));
            let hessian = lost(state, [wave(20), wave(21)], 0.01, 5.0).hessian;
            let curvature: f64 = (0..16)
                .map(|n| (n / 4, n % 4))
                .fold(0.0, |sum, (i, j)| sum + change[i] * hessian[i][j] * change[j]);
            // Rounding of entries up to 100.
            assert!(curvature > -1e-12, "{curvature}");
        }
    }
}
