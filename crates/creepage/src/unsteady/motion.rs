//! Motion of the bodies in a step: creepage or force of each component.

use crate::Creepage;
use crate::check::{self, InvalidValue};

/// Prescribed creepage or force of one component of the motion; the other of the two is the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Prescribed {
    /// The creepage: `xi`, `eta` or `chi`.
    Creepage(f64),
    /// The force or moment on the lower body: `fx`, `fy` or `mz`.
    Force(f64),
}

/// Motion of the bodies in a step: of each component the creepage or the force, dimensionless in the units of the
/// contact's nominal load.
///
/// ```
/// use creepage::unsteady::{Motion, Prescribed};
/// // A driven wheel that pulls with half of the friction force.
/// let pulling = Motion { longitudinal: Prescribed::Force(0.5), ..Motion::default() };
/// assert_eq!(pulling.lateral, Prescribed::Creepage(0.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Along the rolling direction.
    pub longitudinal: Prescribed,
    /// Across.
    pub lateral: Prescribed,
    /// About the normal.
    pub spin: Prescribed,
}

impl Default for Motion {
    /// Free rolling: no creepage.
    fn default() -> Self {
        Self::from(Creepage::default())
    }
}

impl From<Creepage> for Motion {
    fn from(creepage: Creepage) -> Self {
        let [longitudinal, lateral, spin] = creepage.components().map(Prescribed::Creepage);
        Self { longitudinal, lateral, spin }
    }
}

impl Motion {
    /// Forces along and across the rolling direction, without spin.
    #[must_use]
    pub fn forces(fx: f64, fy: f64) -> Self {
        let [longitudinal, lateral] = [fx, fy].map(Prescribed::Force);
        Self { longitudinal, lateral, spin: Prescribed::Creepage(0.0) }
    }

    pub(crate) fn components(&self) -> [Prescribed; 3] {
        [self.longitudinal, self.lateral, self.spin]
    }

    /// Size of the prescribed forces along and across the rolling direction.
    pub(crate) fn force(&self) -> f64 {
        let [fx, fy] = [self.longitudinal, self.lateral].map(|one| one.force().unwrap_or(0.0));
        fx.hypot(fy)
    }

    /// Whether the prescribed forces are nearly what friction can give under a load, or beyond: no shift
    /// meets them, for it grows without bound towards that.
    pub(crate) fn nearly_slides(&self, load: f64) -> bool {
        const NEARLY: f64 = 0.999;
        self.force() >= NEARLY * load
    }

    /// The same forces, and no creepage where that is prescribed.
    pub(crate) fn without_creepage(&self) -> Self {
        let [longitudinal, lateral, spin] = self.components().map(|one| match one {
            Prescribed::Creepage(_) => Prescribed::Creepage(0.0),
            Prescribed::Force(_) => one,
        });
        Self { longitudinal, lateral, spin }
    }

    /// Every number is finite.
    pub(crate) fn check(&self) -> Result<(), InvalidValue> {
        let names = [["xi", "fx"], ["eta", "fy"], ["chi", "mz"]];
        for (prescribed, [creepage, force]) in self.components().into_iter().zip(names) {
            let valid = "between -1e100 and 1e100";
            let (name, value) = match prescribed {
                Prescribed::Creepage(value) => (creepage, value),
                Prescribed::Force(value) => (force, value),
            };
            check::require(value.abs() <= Creepage::MAX, name, value, valid)?;
        }
        Ok(())
    }

    /// Whether it goes on from another without a jump.
    pub(crate) fn continues(&self, before: &Self) -> bool {
        let pairs = self.components().into_iter().zip(before.components());
        let size = |of: fn(&Prescribed) -> Option<f64>| {
            let all = self.components().into_iter().chain(before.components());
            all.filter_map(|one| of(&one)).fold(0.0, |size: f64, value| size.max(value.abs()))
        };
        let [creepage, force] = [size(Prescribed::creepage), size(Prescribed::force)];
        pairs.into_iter().all(|pair| match pair {
            (Prescribed::Creepage(now), Prescribed::Creepage(then)) => {
                (now - then).abs() <= SMOOTH * creepage
            }
            (Prescribed::Force(now), Prescribed::Force(then)) => {
                (now - then).abs() <= SMOOTH * force
            }
            _ => false,
        })
    }
}

/// A change by more than this fraction is a jump.
const SMOOTH: f64 = 0.5;

impl Prescribed {
    pub(crate) fn creepage(&self) -> Option<f64> {
        if let Self::Creepage(value) = self { Some(*value) } else { None }
    }

    pub(crate) fn force(&self) -> Option<f64> {
        if let Self::Force(value) = self { Some(*value) } else { None }
    }
}
