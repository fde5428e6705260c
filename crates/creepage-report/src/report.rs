//! All that one solved case is reported from.

use std::fmt;

use creepage::rolling::exact::Known;
use creepage::rolling::{Creepage, FieldPoint, Region, Scaling, Solution, Theory};
use creepage::{Hertz, InvalidValue};
use creepage_plot::Contour;
use creepage_theories::{Detail, LeftOut, SolvedCase, find};

/// What one theory says to one creepage.
pub struct Answer<'a> {
    /// The question.
    pub creepage: Creepage,
    /// The theory's name, as in `variational`.
    pub theory_name: &'a str,
    /// The theory, prepared for the ellipse and Poisson's ratio of the contact; the picture asks
    /// it for its field.
    pub theory: &'a dyn Theory,
    /// Force and status.
    pub solution: Solution,
    /// The field at the theory's own mesh, for `points.csv`.
    pub points: Vec<FieldPoint>,
    /// What only this theory can say.
    pub details: Vec<Detail>,
}

impl fmt::Debug for Answer<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Answer")
            .field("creepage", &self.creepage)
            .field("theory_name", &self.theory_name)
            .field("solution", &self.solution)
            .field("points", &self.points)
            .field("details", &self.details)
            .finish_non_exhaustive()
    }
}

/// What may be known of a case beyond the answer of its theory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Extras {
    /// Rolling velocity (m/s).
    pub speed: Option<f64>,
    /// The frictional power in units of `mu N mu c V / rho`, where it is not just force times
    /// creepage: between unlike bodies the pressure gives power to the slip too.
    pub power: Option<f64>,
    /// The frictional power as a sum of traction times slip over the contact, in units of
    /// `mu N mu c V / rho`.
    pub dissipation: Option<f64>,
    /// What was given where the creepage was found to wanted forces.
    pub known: Option<Known>,
    /// What the theory leaves out of the case though it matters.
    pub left_out: Option<LeftOut>,
}

/// One solved case, ready to be shown.
#[derive(Debug)]
pub struct Report<'a> {
    pub(crate) contact: &'a Hertz,
    pub(crate) friction: f64,
    pub(crate) scaling: Scaling,
    pub(crate) answer: Answer<'a>,
    pub(crate) adhesion: Contour,
    pub(crate) extras: Extras,
}

impl<'a> Report<'a> {
    /// The report of what a theory answered for `contact` with coefficient of friction
    /// `friction`.
    ///
    /// Traces the areas of adhesion and slip: some fifteen thousand points of the theory's field.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn new(
        contact: &'a Hertz,
        friction: f64,
        answer: Answer<'a>,
    ) -> Result<Self, InvalidValue> {
        let scaling = Scaling::new(contact, friction)?;
        let unit = disc_to_theory(contact);
        let adhesion = Contour::trace(|disc| {
            let positions: Vec<_> = disc.iter().map(|d| [d[0] * unit[0], d[1] * unit[1]]).collect();
            let field = answer.theory.field(answer.creepage, &positions);
            field.iter().map(|point| point.region == Region::Adhesion).collect()
        });
        Ok(Self { contact, friction, scaling, answer, adhesion, extras: Extras::default() })
    }

    /// The report of a case that the theory of that name solved.
    ///
    /// # Errors
    /// As [`Report::new`]; none for a case that was read from a file.
    pub fn of_case(solved: &'a SolvedCase, theory_name: &'a str) -> Result<Self, InvalidValue> {
        let SolvedCase { case, known, found } = solved;
        let answer = Answer {
            creepage: case.creepage,
            theory_name,
            theory: found,
            solution: found.answered.solution,
            points: found.points.clone(),
            details: found.details.clone(),
        };
        let extras = Extras {
            known: *known,
            speed: case.speed,
            power: found.power,
            dissipation: found.dissipation,
            left_out: find(theory_name).ok().and_then(|theory| solved.left_out(theory)),
        };
        Ok(Self::new(&case.contact, case.friction, answer)?.with(extras))
    }

    /// The same report with more that is known of the case.
    #[must_use]
    pub fn with(self, extras: Extras) -> Self {
        Self { extras, ..self }
    }

    /// Share of the contact area that sticks, from 0 to 1.
    #[must_use]
    pub fn adhesion_share(&self) -> f64 {
        self.adhesion.share
    }

    /// Energy turned to heat per metre rolled (J/m), from force and creepage.
    #[must_use]
    pub fn power_per_metre(&self) -> f64 {
        let by_creepage =
            || self.scaling.power_per_metre(self.answer.solution.force, self.answer.creepage);
        let unit = self.scaling.force * self.scaling.slip;
        self.extras.power.map_or_else(by_creepage, |power| unit * power)
    }

    /// The same energy (J/m) from traction and slip all over the contact, where the theory gives
    /// it. The two differ by the error of the theory's discretization.
    #[must_use]
    pub fn dissipation_per_metre(&self) -> Option<f64> {
        self.extras.dissipation.map(|power| power * self.scaling.force * self.scaling.slip)
    }

    /// Frictional power (W), where the rolling velocity is known.
    #[must_use]
    pub fn power(&self) -> Option<f64> {
        self.extras.speed.map(|speed| speed * self.power_per_metre())
    }

    /// Frictional power over an area at a point, over the rolling velocity: the energy turned to
    /// heat per metre rolled and square metre of contact (J/m^3). NaN where slip is not given.
    pub(crate) fn power_density(&self, point: &FieldPoint) -> f64 {
        let ([x, y], [u, v]) = (point.traction, point.slip);
        (x * u + y * v) * self.scaling.traction * self.scaling.slip
    }
}

/// Semi-axes in units of `c`: what takes `(x/a, y/b)` to the positions that a theory takes.
pub(crate) fn disc_to_theory(contact: &Hertz) -> [f64; 2] {
    let ellipse = contact.ellipse();
    [ellipse.a() / ellipse.c(), ellipse.b() / ellipse.c()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{CURVE, STICK, contact, report, sliding, sticking};

    #[test]
    fn the_adhesion_share_is_that_of_the_inner_ellipse() {
        for a_over_b in [0.05, 1.0, 20.0] {
            let (contact, theory) = (contact(a_over_b), sticking(a_over_b));
            let share = report(&contact, &theory, CURVE).adhesion_share();
            // Chords over cells of 2/96, and a pointed gap at the leading edge: 0.1 %.
            assert!((share - STICK * STICK).abs() < 1e-3, "{share}");
        }
        let (contact, theory) = (contact(1.0), sliding(1.0));
        assert!(report(&contact, &theory, CURVE).adhesion_share().abs() < 1e-300);
    }

    #[test]
    fn heat_is_force_times_creepage() {
        let (contact, theory) = (contact(1.5), sliding(1.5));
        let json = report(&contact, &theory, CURVE).json();
        let (creepage, force) = (json.creepage, json.lower_body);
        let power = force.longitudinal_n * creepage.longitudinal
            + force.lateral_n * creepage.lateral
            + force.moment_n_m * creepage.spin_rad_per_m;
        let given = json.frictional_power_per_metre_j_per_m;
        // The same three products in another order: rounding only.
        assert!((given - power).abs() < 1e-12 * power.abs());
    }

    #[test]
    fn friction_must_be_positive() {
        let (contact, theory) = (contact(1.0), sliding(1.0));
        let Report { answer, .. } = report(&contact, &theory, CURVE);
        assert_eq!(Report::new(&contact, -0.3, answer).unwrap_err().quantity, "friction");
    }
}
