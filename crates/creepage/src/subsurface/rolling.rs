//! Subsurface fields of a rolling contact under the tractions of a theory.

use super::element::{Element, ElementError};
use super::interior::{Body, Interior, InteriorError};
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::coulomb::quadrilaterals;
use crate::hertz::Hertz;
use crate::solid::Solid;
use crate::theory::Solved;
use crate::theory::field::{Patch, mean};

/// Error of a solved contact without a field below.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RollingError {
    /// The pressure.
    #[error(transparent)]
    Interior(#[from] InteriorError),
    /// The traction of an element.
    #[error(transparent)]
    Element(#[from] ElementError),
}

impl Interior {
    /// Hertz's pressure in closed form, and the tangential tractions of a solved contact on elements
    /// ([`Solved::patches`]; of a theory without elements its field at the middles of those of the
    /// fine resolution). `contact` is what the theory was prepared for. With the tractions of
    /// [`Exact`](crate::coulomb::Exact) at the fine resolution, stresses from a tenth of the smaller
    /// semi-axis downwards are right to 1e-3 of the peak pressure.
    ///
    /// ```
    /// use creepage::approximate::fastsim::{Fastsim, Settings};
    /// use creepage::subsurface::{Body, Interior};
    /// use creepage::{Creepage, Ellipse, Hertz, Solid, SolidPair, Theory};
    /// let steel = Solid::new(82e9, 0.28)?;
    /// let ellipse = Ellipse::new(6e-3, 4e-3)?;
    /// let hertz = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3)?;
    /// let contact = hertz.with_friction(0.3)?;
    /// let theory = Fastsim::new(&contact, Settings::default())?;
    /// let solved = theory.solved(Creepage::new(0.5, 0.0, 0.0)?);
    /// let rail = Interior::rolling(&hertz, &contact, &*solved, steel, Body::Lower)?;
    /// assert!(rail.stress([0.0, 0.0, 1e-3])?.xz < 0.0); // pushed forwards from above
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RollingError`] for tractions that are not finite.
    pub fn rolling(
        hertz: &Hertz,
        contact: &Contact,
        solved: &dyn Solved,
        solid: Solid,
        body: Body,
    ) -> Result<Self, RollingError> {
        let (length, unit) = (hertz.ellipse().c(), contact.scaling().traction);
        let patches = solved.patches().unwrap_or_else(|| of_field(contact, solved));
        let element = |Patch { corners, traction: [x, y] }: Patch| {
            let corners = corners.map(|corner| corner.map(|at| length * at));
            Element::new(&corners, [unit * x, unit * y, 0.0])
        };
        let elements = patches.into_iter().map(element).collect::<Result<Vec<_>, _>>()?;
        Ok(Self::sliding(hertz, [0.0, 0.0], solid, body)?.with_elements(&elements))
    }
}

impl Interior {
    /// Pressure and tangential tractions of a contact on areas of any shape, both on the elements of its
    /// solution, the pressure scaled so that it carries the load to rounding.
    ///
    /// # Errors
    /// [`RollingError`] for tractions that are not finite, and for a contact that is Hertz's ellipse.
    pub fn rolling_on_areas(
        contact: &Contact,
        solved: &dyn Solved,
        solid: Solid,
        body: Body,
    ) -> Result<Self, RollingError> {
        let valid = "at least one: Hertz's ellipse has its pressure in closed form";
        let none = InvalidValue { quantity: "areas of any shape", value: 0.0, valid };
        let areas = contact.areas().ok_or(InteriorError::Invalid(none))?;
        let (length, unit) = (contact.scaling().length, contact.scaling().traction);
        let patches = solved.patches().unwrap_or_default();
        let pressed = patches.into_iter().map(|Patch { corners, traction }| {
            let corners = corners.map(|corner| corner.map(|at| length * at));
            let [x, y] = mean(&corners);
            (corners, traction, areas.pressure(x, y))
        });
        let pressed: Vec<_> = pressed.collect();
        let load =
            |(corners, _, pressure): &([[f64; 2]; 4], [f64; 2], f64)| pressure * area(corners);
        let carried = pressed.iter().map(load).sum::<f64>();
        let share = areas.load().value / carried.max(f64::MIN_POSITIVE);
        let element = |(corners, [x, y], pressure): ([[f64; 2]; 4], [f64; 2], f64)| {
            Element::new(&corners, [unit * x, unit * y, share * pressure])
        };
        let elements = pressed.into_iter().map(element).collect::<Result<Vec<_>, _>>()?;
        Ok(Self::new(solid, body).with_elements(&elements))
    }
}

/// Area of a quadrilateral.
fn area([p, q, r, s]: &[[f64; 2]; 4]) -> f64 {
    0.5 * ((r[0] - p[0]) * (s[1] - q[1]) - (s[0] - q[0]) * (r[1] - p[1])).abs()
}

fn of_field(contact: &Contact, solved: &dyn Solved) -> Vec<Patch> {
    let corners: Vec<_> = quadrilaterals(contact.ellipse()).collect();
    let middles: Vec<_> = corners.iter().map(|corners| mean(corners)).collect();
    let field = solved.field(&middles).into_iter().map(|point| point.traction);
    corners.into_iter().zip(field).map(|(corners, traction)| Patch { corners, traction }).collect()
}
