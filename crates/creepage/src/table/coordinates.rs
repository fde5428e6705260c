//! Coordinates of a creepage in a table: from zero to infinity in a box.
//!
//! Creepages are scaled, `u = (s_x xi, s_y eta, s_z chi)`, and turned into spherical coordinates
//! about the spin's axis. What bends the force most then lies at about the same place for every
//! shape: at `|u| = 2`, where the leading edge begins to slide, and far from the axis, where the
//! spin's pole is on the edge. The coordinates are:
//!
//! - `theta`, from pure spin (0) to no spin (pi/2);
//! - `phi`, from `-eta` (-pi/2) over `xi` (0) to `eta` (pi/2);
//! - `t = r/(2 + r)`, from no creepage (0) to infinite creepage (1), with `r = |u|`.
//!
//! Along a ray forces are smooth in `t`: analytic at 0, and with an error of order `1/r` from
//! full sliding. The other three quarters of space are mirror images by (4.28).

use crate::Creepage;

/// Angles that are as good as zero: nearer to the axis a derivative is taken a little aside.
const NUDGE: f64 = 1e-7;
/// `r` at `t = 1/2`.
const MIDDLE: f64 = 2.0;
/// `r` that stands for infinity: elastic displacements are less than rounding beside its slip.
const INFINITY: f64 = 1e12;

/// The scales of one ratio `a/b`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Coordinates {
    scale: [f64; 3],
}

/// A creepage in the coordinates of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    /// Sine and cosine of the angle.
    pub(crate) theta: [f64; 2],
    /// Sine and cosine of the angle.
    pub(crate) phi: [f64; 2],
    pub(crate) t: f64,
    /// The reflections that took it there: of `xi`, and of `eta` and `chi`.
    pub(crate) mirror: [f64; 2],
    /// Whether it is not quite the creepage's place, but where there is a derivative.
    pub(crate) aside: bool,
}

impl Coordinates {
    pub(crate) fn new(a_over_b: f64) -> Self {
        let root = a_over_b.sqrt();
        let (per_root, fourth) = (root.recip(), root.sqrt());
        let steep = 0.5 * a_over_b * root;
        Self {
            scale: [
                steep + 0.5 * fourth * per_root,
                0.7 * a_over_b + 0.3 * per_root * per_root,
                steep + 0.5 * per_root,
            ],
        }
    }

    #[inline]
    pub(crate) fn place(&self, creepage: Creepage) -> Place {
        let (u, mirror) = self.folded(creepage);
        let (across, r) = (length([u[0], u[1], 0.0]), length(u));
        let (theta, phi) = (unit([across, u[2]], r), unit([u[1], u[0]], across));
        Place { theta, phi, t: r / (MIDDLE + r), mirror, aside: false }
    }

    /// The place, and the derivative of `theta`, `phi`, `t` (rows) by `xi`, `eta`, `chi`. On the
    /// axis of spin and at zero, where there is none, the place is a little [aside](Place::aside).
    #[inline]
    pub(crate) fn place_and_slopes(&self, creepage: Creepage) -> (Place, [[f64; 3]; 3]) {
        let (mut u, mirror) = self.folded(creepage);
        let at_zero = length(u) < NUDGE;
        u[2] = if at_zero { NUDGE } else { u[2] };
        let on_axis = length([u[0], u[1], 0.0]) < NUDGE * u[2];
        u[0] = if on_axis { NUDGE * u[2] } else { u[0] };
        let (across, r) = (length([u[0], u[1], 0.0]), length(u));
        let (theta, phi) = (unit([across, u[2]], r), unit([u[1], u[0]], across));
        let ([sin_theta, cos_theta], [sin_phi, cos_phi]) = (theta, phi);
        let (per_r, per_across, per_both) = (r.recip(), across.recip(), (MIDDLE + r).recip());
        let by_r = MIDDLE * per_both * per_both;
        let by_u = [
            [cos_theta * cos_phi * per_r, cos_theta * sin_phi * per_r, -sin_theta * per_r],
            [-sin_phi * per_across, cos_phi * per_across, 0.0],
            [sin_theta * cos_phi * by_r, sin_theta * sin_phi * by_r, cos_theta * by_r],
        ];
        let [x, y, z] = self.scale;
        let scale = [x * mirror[0], y * mirror[1], z * mirror[1]];
        let mut slopes = by_u;
        slopes.iter_mut().flat_map(|row| row.iter_mut().zip(scale)).for_each(|(s, k)| *s *= k);
        (Place { theta, phi, t: r / (MIDDLE + r), mirror, aside: at_zero || on_axis }, slopes)
    }

    /// The creepage at a place that is not reflected. No creepage for `t = 0`; beyond all
    /// elasticity for `t = 1`.
    pub(crate) fn creepage(&self, [theta, phi, t]: [f64; 3]) -> Creepage {
        let r = if t < 1.0 { MIDDLE * t / (1.0 - t) } else { INFINITY };
        let direction = direction(theta, phi);
        let [xi, eta, chi] = [0, 1, 2].map(|k| r * direction[k] / self.scale[k]);
        Creepage { xi, eta, chi }
    }

    /// Derivative of the creepage by `t` at zero.
    pub(crate) fn departure(&self, theta: f64, phi: f64) -> [f64; 3] {
        let direction = direction(theta, phi);
        [0, 1, 2].map(|k| MIDDLE * direction[k] / self.scale[k])
    }

    /// Scaled, `xi` and `chi` (or `eta`, without spin) made positive, with the signs taken away.
    fn folded(&self, Creepage { xi, eta, chi }: Creepage) -> ([f64; 3], [f64; 2]) {
        let sign = |negative| if negative { -1.0 } else { 1.0 };
        let mirror = [sign(xi < 0.0), sign(chi < 0.0 || (chi == 0.0 && eta < 0.0))];
        let [x, y, z] = self.scale;
        ([x * xi.abs(), y * eta * mirror[1], z * chi.abs()], mirror)
    }
}

/// Quicker than `hypot`; squares do not overflow, and where they vanish so does the force.
fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// Sine and cosine of the angle of a right triangle; straight on where there is none.
#[inline]
fn unit([opposite, adjacent]: [f64; 2], length: f64) -> [f64; 2] {
    if length > 0.0 { [opposite / length, adjacent / length] } else { [0.0, 1.0] }
}

/// A unit vector; exact where a component vanishes.
fn direction(theta: f64, phi: f64) -> [f64; 3] {
    let ([sin_theta, cos_theta], [sin_phi, cos_phi]) = (sin_cos(theta), sin_cos(phi));
    [sin_theta * cos_phi, sin_theta * sin_phi, cos_theta]
}

/// Sine and cosine; of a right angle the cosine is zero.
fn sin_cos(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [sin, if cos.abs() < 1e-15 { 0.0 } else { cos }]
}

#[cfg(test)]
// Reflections and zeros are exact.
#[allow(clippy::float_cmp)]
mod tests {
    use super::*;

    /// Largest difference of a place's coordinates.
    fn off(place: &Place, [theta, phi, t]: [f64; 3]) -> f64 {
        let angle = |[sin, cos]: [f64; 2]| f64::atan2(sin, cos);
        let off = [angle(place.theta) - theta, angle(place.phi) - phi, place.t - t];
        off.into_iter().map(f64::abs).fold(0.0, f64::max)
    }

    /// There and back again, to rounding; at other places of the octants with the mirrors.
    #[test]
    fn a_place_is_found_again() {
        let coordinates = Coordinates::new(0.3);
        for at in [[0.4, -0.7, 0.2], [1.2, 1.1, 0.9], [0.9, 0.3, 0.5]] {
            let Creepage { xi, eta, chi } = coordinates.creepage(at);
            for [x, y] in [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
                let place = coordinates.place(Creepage { xi: x * xi, eta: y * eta, chi: y * chi });
                assert_eq!(place.mirror, [x, y]);
                assert!(off(&place, at) < 1e-14, "{place:?}");
            }
        }
    }

    /// Central differences of step 1e-5 are good to 1e-9 or so.
    #[test]
    fn slopes_are_those_of_differences() {
        let coordinates = Coordinates::new(2.0);
        let at = Creepage { xi: -0.7, eta: 0.4, chi: -1.3 };
        let (place, slopes) = coordinates.place_and_slopes(at);
        assert_eq!(place, coordinates.place(at));
        for k in 0..3 {
            let moved = |h: f64| {
                let mut v = [at.xi, at.eta, at.chi];
                v[k] += h;
                let place = coordinates.place(Creepage { xi: v[0], eta: v[1], chi: v[2] });
                let angle = |[sin, cos]: [f64; 2]| f64::atan2(sin, cos);
                [angle(place.theta), angle(place.phi), place.t]
            };
            let (ahead, behind) = (moved(1e-5), moved(-1e-5));
            for i in 0..3 {
                assert!((slopes[i][k] - (ahead[i] - behind[i]) / 2e-5).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn zero_and_huge_creepage_have_places() {
        let coordinates = Coordinates::new(1.0);
        assert_eq!(off(&coordinates.place(Creepage::default()), [0.0; 3]), 0.0);
        let huge = Creepage { xi: Creepage::MAX, eta: -Creepage::MAX, chi: 0.0 };
        let (place, slopes) = coordinates.place_and_slopes(huge);
        assert!((place.t - 1.0).abs() < 1e-15);
        assert!(slopes.as_flattened().iter().all(|slope| slope.is_finite()));
    }
}
