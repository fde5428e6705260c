//! All that one solved case is reported from.

use std::fmt;

use creepage::rolling::{Creepage, FieldPoint, Scaling, Solution, Theory};
use creepage::{Hertz, InvalidValue};

use crate::areas::Areas;

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

/// A number that only one theory gives, such as the value of its functional.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Detail {
    /// Its key in `report.json`.
    pub key: &'static str,
    /// Its name in the text.
    pub label: &'static str,
    /// The number.
    pub value: f64,
}

/// One solved case, ready to be shown.
#[derive(Debug)]
pub struct Report<'a> {
    pub(crate) contact: &'a Hertz,
    pub(crate) friction: f64,
    pub(crate) scaling: Scaling,
    pub(crate) answer: Answer<'a>,
    pub(crate) areas: Areas,
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
        let areas = Areas::trace(|disc| {
            let positions: Vec<_> = disc.iter().map(|d| [d[0] * unit[0], d[1] * unit[1]]).collect();
            answer.theory.field(answer.creepage, &positions).iter().map(|p| p.region).collect()
        });
        Ok(Self { contact, friction, scaling, answer, areas })
    }

    /// Share of the contact area that sticks, from 0 to 1.
    #[must_use]
    pub fn adhesion_share(&self) -> f64 {
        self.areas.adhesion_share
    }

    /// Energy turned to heat per metre rolled [J/m].
    #[must_use]
    pub fn power_per_metre(&self) -> f64 {
        self.scaling.power_per_metre(self.answer.solution.force, self.answer.creepage)
    }
}

/// Semi-axes in units of `c`: what takes `(x/a, y/b)` to the positions that a theory takes.
pub(crate) fn disc_to_theory(contact: &Hertz) -> [f64; 2] {
    let ellipse = contact.ellipse();
    [ellipse.a() / ellipse.c(), ellipse.b() / ellipse.c()]
}
