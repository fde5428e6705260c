//! The peak pressure of the coupled solution: a peak at the stick boundary that polynomials cut off.
//!
//! Along a strip let `x = cos t`. Behind the border at `t_0` the traction is that of sliding, ahead of
//! it less by `C sqrt(t_0 - t)`. In waves short against the strip the normal problem is plane: the
//! part `X_n cos nt` of the traction over `mu p_0` has the pressure `q X_n sin nt`. The root is the
//! real part of a series,
//!
//! ```math
//! \frac{1 - i}{\sqrt 2} \sqrt{1 - e^{i (t - t_0)}} = \sum_n f_n e^{i n (t - t_0)}, \qquad
//! \frac{f_n}{f_{n - 1}} = 1 - \frac{3}{2n},
//! ```
//!
//! and the pressure by it, `q C sqrt(t - t_0)` behind the border and none ahead, the imaginary part
//! times `-q C`. What a number of polynomials leave of the series is added to their pressure.

use std::f64::consts::FRAC_PI_2;

use super::level::CoupledState;
use crate::normal::strip_system::MAX_TERMS;

/// Elements from the border to that from which the root is taken; those between it and the border are
/// smeared.
const AHEAD: usize = 2;

/// The root of the traction along `x` at a border: `t_0` and `C`.
#[derive(Debug, Clone, Copy)]
struct Border {
    angle: f64,
    root: f64,
}

/// The largest pressure over Hertz's, and what the polynomials lack at the highest border.
#[derive(Debug, Clone, Copy)]
pub(super) struct PressurePeak {
    pub peak: f64,
    pub lacking: f64,
}

/// The pressure peak of a grid; `q` with the sign of the pressure's part in the slip.
pub(super) fn pressure_peak(settled: &CoupledState, q: f64) -> PressurePeak {
    let strips = settled.grid.mesh.strips.iter().enumerate();
    let lines = strips.flat_map(|(index, strip)| {
        let t = settled.shape.across(strip.y());
        let borders = (0..strip.len()).filter_map(move |i| border(settled, index, i));
        borders.map(move |border| PressurePeak {
            peak: near(settled, border, t, q),
            lacking: (q * border.root * left(0.0)).abs(),
        })
    });
    let none = PressurePeak { peak: 0.0, lacking: 0.0 };
    let highest = lines.fold(none, |high, line| if line.peak > high.peak { line } else { high });
    PressurePeak { peak: highest.peak.max(settled.shape.peak()), ..highest }
}

/// The largest pressure of a line near a border.
fn near(settled: &CoupledState, Border { angle, root }: Border, t: f64, q: f64) -> f64 {
    const SAMPLES: i32 = 20;
    // A wave of the last polynomial.
    let reach = 4.0 * FRAC_PI_2 / MAX_TERMS as f64;
    let pressures = (-SAMPLES..=SAMPLES).map(|k| {
        let beside = reach * f64::from(k) / f64::from(SAMPLES);
        let polynomials = settled.shape.pressure([(angle + beside).cos(), t]);
        polynomials - q * root * left(beside)
    });
    pressures.fold(0.0, f64::max)
}

/// The imaginary part of what the polynomials leave of the series.
fn left(beside: f64) -> f64 {
    let quarter = 0.5 * FRAC_PI_2;
    let turned = if beside > 0.0 { FRAC_PI_2 } else { 0.0 };
    let whole = (2.0 * (0.5 * beside).sin().abs()).sqrt() * (0.25 * beside - turned).sin();
    let (mut factor, mut sum) = (1.0, 0.0);
    for n in 0..=MAX_TERMS {
        sum += factor * (n as f64 * beside - quarter).sin();
        factor *= 1.0 - 1.5 / (n + 1) as f64;
    }
    whole - sum
}

/// The border of adhesion in front of an element of a strip, if it slides and those ahead do not.
fn border(settled: &CoupledState, index: usize, sliding: usize) -> Option<Border> {
    let CoupledState { grid, state, .. } = settled;
    let (first, strip) = (grid.mesh.elements(index).start, &grid.mesh.strips[index]);
    let traction_and_slip = |i: usize| state.traction_and_slip(grid, first + i);
    let far = sliding.checked_sub(AHEAD + 1)?;
    if traction_and_slip(sliding).1.is_none()
        || (far..sliding).any(|i| traction_and_slip(i).1.is_some())
    {
        return None;
    }
    // By how much less the traction is than that of sliding.
    let direction = traction_and_slip(sliding).0[0];
    let less = |i: usize| grid.pressure.bounds[first + i] * (direction - traction_and_slip(i).0[0]);
    let angle = |i: usize| strip.along.middles[i].acos();
    let near = sliding - AHEAD;
    let [from, to] = [less(far), less(near)];
    let slope = (from * from - to * to) / (angle(near) - angle(far));
    if from * to <= 0.0 || slope <= 0.0 {
        return None;
    }
    let at = angle(near) + to * to / slope;
    let between = [near + 1, sliding].map(angle);
    Some(Border { angle: at.clamp(between[0], between[1]), root: slope.sqrt().copysign(from) })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A root that the polynomials met would leave nothing; at the border they lack the product of
    /// `1 - 1/(2n)` over the root of two, and far away little.
    #[test]
    fn what_is_left_is_largest_at_the_border() {
        let lacking =
            (1..=MAX_TERMS).fold(0.5_f64.sqrt(), |product, n| product * (1.0 - 0.5 / n as f64));
        assert!((left(0.0) - lacking).abs() < 1e-12, "{} {lacking}", left(0.0));
        assert!((1..60).all(|k| left(0.05 * f64::from(k)).abs() < lacking));
        assert!(left(2.0).abs() < 0.1 * lacking, "{}", left(2.0));
    }
}
