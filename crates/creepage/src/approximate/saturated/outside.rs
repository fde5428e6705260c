//! The spin pole outside the contact: quadrature over the chords through the pole, along which
//! the direction of the traction is constant.

use crate::approximate::outside_chords::{Chord, OutsideChords};
use crate::ellipse::Ellipse;
use crate::{Creepage, Force};

#[derive(Debug, Clone)]
pub(super) struct PoleOutside {
    ellipse: Ellipse,
    chords: OutsideChords,
}

/// `|chi|` times the pole's distance from the centre, in coordinates in which the ellipse is the
/// unit circle.
pub(super) fn reach(ellipse: Ellipse, creepage: Creepage) -> f64 {
    (creepage.eta / ellipse.a()).hypot(creepage.xi / ellipse.b())
}

impl PoleOutside {
    pub(super) fn new(ellipse: Ellipse) -> Self {
        Self { ellipse, chords: OutsideChords::new(ellipse) }
    }

    pub(super) fn force(&self, creepage: Creepage) -> Force {
        let (a, b) = (self.ellipse.a(), self.ellipse.b());
        let kappa = kappa(self.ellipse, creepage);
        let mut force = Force::default();
        for chord in self.chords(creepage) {
            let ([c, s], [cos, sin]) = (chord.direction, chord.circle);
            let share = chord.weight * chord.half_squared();
            force.fx -= share * chord.cos_delta * s;
            force.fy += share * chord.cos_delta * c;
            // The middle of the chord is off the foot of the centre; the traction, off the middle.
            let arm = chord.offset * (b - a) * (b + a) * sin * cos * chord.per_q;
            let spread = 0.25 * kappa * chord.q * chord.half_squared();
            force.mz += share * (arm * chord.cos_delta + spread);
        }
        let factor = 0.75 * creepage.chi.signum();
        Force { fx: factor * force.fx, fy: factor * force.fy, mz: factor * force.mz }
    }

    /// The sum of `e e^T` over the chords, `e = (c, s, -p ab/Q)` being the derivative of the slip
    /// along the chord.
    pub(super) fn derivative(&self, creepage: Creepage) -> [[f64; 3]; 3] {
        let factor = 0.75 / reach(self.ellipse, creepage);
        let area = self.ellipse.a() * self.ellipse.b();
        let mut matrix = [[0.0; 3]; 3];
        for chord in self.chords(creepage) {
            let [c, s] = chord.direction;
            let e = [c, s, -chord.offset * area * chord.per_q];
            let share = factor * chord.weight * chord.half_squared() * chord.per_q;
            for (row, first) in matrix.iter_mut().zip(e) {
                for (entry, second) in row.iter_mut().zip(e) {
                    *entry += share * first * second;
                }
            }
        }
        matrix
    }

    fn chords(&self, creepage: Creepage) -> impl Iterator<Item = Chord> {
        let scale = creepage.chi.signum() / reach(self.ellipse, creepage);
        let to_centre =
            [creepage.eta / self.ellipse.a() * scale, -creepage.xi / self.ellipse.b() * scale];
        self.chords.through(to_centre, kappa(self.ellipse, creepage))
    }
}

/// One over the pole's distance; 1e-30 stands for a pole at infinity.
fn kappa(ellipse: Ellipse, creepage: Creepage) -> f64 {
    (creepage.chi.abs() / reach(ellipse, creepage)).max(1e-30)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Five times the nodes change nothing: poles on the edge, close to it, and far.
    #[test]
    fn the_quadrature_has_converged() {
        for a_over_b in [1e-3, 0.02, 0.3, 1.0, 7.0, 1e3] {
            let ellipse = Ellipse::from_ratio(a_over_b).unwrap();
            let usual = PoleOutside::new(ellipse);
            let fine = PoleOutside { ellipse, chords: OutsideChords::with_nodes(ellipse, 4000) };
            for (i, distance) in [1.0 + 1e-15, 1.0 + 1e-9, 1.001, 1.5, 40.0]
                .into_iter()
                .cycle()
                .enumerate()
                .take(400)
            {
                let (sin, cos) = (i as f64 * 0.1).sin_cos();
                let (xi, eta) = (distance * ellipse.b() * sin, distance * ellipse.a() * cos);
                let creepage = Creepage { xi, eta, chi: 1.0 };
                let (usual, fine) = (usual.force(creepage), fine.force(creepage));
                assert!(
                    (usual.fx - fine.fx).abs() < 1e-11,
                    "{a_over_b} {creepage:?} {usual:?} {fine:?}"
                );
                assert!(
                    (usual.fy - fine.fy).abs() < 1e-11,
                    "{a_over_b} {creepage:?} {usual:?} {fine:?}"
                );
                assert!(
                    (usual.mz - fine.mz).abs() < 1e-11,
                    "{a_over_b} {creepage:?} {usual:?} {fine:?}"
                );
            }
        }
    }
}
