//! Coupled theory of unlike bodies: the tangential tractions act back on the pressure and on the contact area.
//!
//! Between bodies with `kappa` not zero pressure adds to the slip (6.4), and tangential traction to
//! the normal displacement difference (2.15c):
//!
//! ```math
//! w = \frac{1 - \sigma}{\pi G} \iint \frac{Z}{R} \, dx' dy'
//!   - \frac{\kappa}{\pi G} \iint \frac{(x' - x) X + (y' - y) Y}{R^2} \, dx' dy'
//! ```
//!
//! so that a traction which points to `+x` opens the gap ahead of it and closes it behind. Friction
//! and normal contact are solved in turn until both hold; the area is free. The elements of
//! [`Exact`](super::Exact) move with the area, and only what differs from Hertz's contact is
//! computed by strips: without `kappa` the solution is that of `Exact`.

mod chebyshev;
mod level;
mod normal;
mod normal_tangential_coupling;
mod peak_pressure;
mod shape;
mod sliding;
mod solved;

pub use sliding::{GrossSliding, SlidingError};
pub use solved::CoupledSolved;

use super::automatic::{Resolutions, error_bars};
use super::inverse::search;
use super::{Constraints, Exact, InverseError, Resolution};
use crate::check::{self, InvalidValue};
use crate::theory::Solved;
use crate::{Contact, Creepage, Theory};
use level::{CoupledGrid, Coupling};

/// What stays as it is without friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Prescribed {
    /// The load: the approach is found.
    #[default]
    Load,
    /// The approach: the load is found.
    Approach,
}

impl Prescribed {
    #[cfg(feature = "serde")]
    #[allow(clippy::trivially_copy_pass_by_ref)] // as serde calls it
    pub(crate) fn is_load(&self) -> bool {
        *self == Self::Load
    }
}

/// The full theory between unlike bodies, coupled both ways.
///
/// Creepage, force and position keep the units of the frictionless Hertz contact (its `a`, `b`,
/// `rho` and load), and the moment its centre.
///
/// ```
/// use creepage::coulomb::{Coupled, Prescribed, Resolution};
/// use creepage::{Creepage, Ellipse, Hertz, Solid, SolidPair, Theory};
/// // Steel on a polymer.
/// let pair = SolidPair::new(Solid::new(82e9, 0.28)?, Solid::new(0.5e9, 0.25)?);
/// let contact = Hertz::from_ellipse(pair, Ellipse::new(5e-3, 5e-3)?, 650.0)?.with_friction(0.3)?;
/// let theory = Coupled::new(&contact, Resolution::FAST, Prescribed::Load)?;
/// let solved = theory.solve_contact(Creepage::new(0.5, 0.0, 0.0)?);
/// assert!((solved.peak() - 1.06).abs() < 0.01 && solved.area() < 1.0);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Coupled {
    contact: Contact,
    coupling: Coupling,
    prescribed: Prescribed,
    resolutions: Resolutions<Prepared>,
}

/// One resolution: Hertz's contact, and what is coupled to it.
#[derive(Debug, Clone)]
struct Prepared {
    exact: Exact,
    levels: Option<[CoupledGrid; 2]>,
}

impl Prepared {
    fn new(contact: &Contact, resolution: Resolution) -> Self {
        let exact = Exact::prepare(contact, resolution);
        let [coarse, fine] = [0, 1].map(|k: usize| CoupledGrid::new(contact, &exact.grids[k]));
        Self { levels: coarse.zip(fine).map(|(coarse, fine)| [coarse, fine]), exact }
    }
}

impl Coupled {
    /// Smallest and largest `a/b`.
    pub const RATIO_RANGE: [f64; 2] = [0.05, 20.0];

    /// Prepares the theory for a contact whose friction is known, as [`Hertz::with_friction`] makes.
    ///
    /// # Errors
    /// [`InvalidValue`] for a contact without friction, and unless `a/b` is within
    /// [`Coupled::RATIO_RANGE`].
    ///
    /// [`Hertz::with_friction`]: crate::Hertz::with_friction
    pub fn new(
        contact: &Contact,
        resolution: Resolution,
        prescribed: Prescribed,
    ) -> Result<Self, InvalidValue> {
        Self::prepare(contact, prescribed, || Resolutions::only(Prepared::new(contact, resolution)))
    }

    /// The same at the first of the three named resolutions whose error bars of `fx` and `fy` are below
    /// `accuracy`, as [`Automatic`](super::Automatic).
    ///
    /// # Errors
    /// As [`Coupled::new`], and unless `accuracy` is finite and positive.
    pub fn automatic(
        contact: &Contact,
        accuracy: f64,
        prescribed: Prescribed,
    ) -> Result<Self, InvalidValue> {
        check::positive("accuracy", accuracy)?;
        Self::prepare(contact, prescribed, || {
            Resolutions::new(accuracy, Prepared::new(contact, Resolution::FAST))
        })
    }

    fn prepare(
        contact: &Contact,
        prescribed: Prescribed,
        resolutions: impl FnOnce() -> Resolutions<Prepared>,
    ) -> Result<Self, InvalidValue> {
        check::ratio(contact.hertz_ellipse()?.ratio(), Self::RATIO_RANGE, "between 1/20 and 20")?;
        let friction = contact.friction().unwrap_or(f64::NAN);
        check::require(friction > 0.0, "friction", friction, "known, for a coupled solution")?;
        let coupling = Coupling::new(contact, friction);
        Ok(Self { contact: contact.clone(), coupling, prescribed, resolutions: resolutions() })
    }

    /// Solves, and keeps what was solved.
    #[must_use]
    pub fn solve_contact(&self, creepage: Creepage) -> CoupledSolved<'_> {
        self.resolutions.answer(
            |resolution| Prepared::new(&self.contact, resolution),
            |prepared| CoupledSolved::new(self, prepared, creepage, None),
            |solved| solved.solution().error.unwrap_or_default(),
        )
    }

    /// Finds the creepage at which the constraints hold, as [`Exact::find`].
    ///
    /// # Errors
    /// [`InverseError`] unless three quantities are prescribed, all finite, and within reach.
    pub fn find(&self, constraints: Constraints) -> Result<CoupledSolved<'_>, InverseError> {
        let scale = 1.0 + self.contact.kappa_over_mu().abs();
        self.resolutions.answer(
            |resolution| Prepared::new(&self.contact, resolution),
            |prepared| {
                let solve = |creepage| CoupledSolved::new(self, prepared, creepage, None);
                search(constraints, scale, solve).map(|(solved, _)| solved)
            },
            |found| error_bars(found, |found| found),
        )
    }
}

impl Theory for Coupled {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Box::new(self.solve_contact(creepage))
    }

    fn solved_for(
        &self,
        constraints: Constraints,
    ) -> Option<Result<Box<dyn Solved + '_>, InverseError>> {
        Some(self.find(constraints).map(|found| -> Box<dyn Solved> { Box::new(found) }))
    }
}
