//! How many elements.

use crate::check::{self, InvalidValue};

/// How finely the contact is cut: the number of elements along and across a circle. On an ellipse
/// the elements become more nearly square: `along s` by `across / s` with `s = (a/b)^0.4`, held
/// between 0.4 and 2.5 (2 across), and at least 8 of each. Between unlike bodies, from
/// `|kappa|/mu = 0.1` on, traction is steeper at the leading edge: there are half as many more along,
/// up to 40 on a circle.
///
/// Errors of the force in parts of `mu N` and costs are in the documentation of
/// [`Exact`](super::Exact).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    along: f64,
    across: f64,
}

impl Resolution {
    /// 14 by 12 elements: less than a millisecond.
    pub const FAST: Self = Self { along: 14.0, across: 12.0 };
    /// 22 by 18 elements: a few milliseconds.
    pub const STANDARD: Self = Self { along: 22.0, across: 18.0 };
    /// 40 by 32 elements: tens of milliseconds.
    pub const FINE: Self = Self { along: 40.0, across: 32.0 };

    /// `along` by `across` elements on a circle.
    ///
    /// # Errors
    /// [`InvalidValue`] unless both lie between 4 and 200, and there are 10,000 elements at most:
    /// fewer resolve nothing, more cost gigabytes.
    pub fn new(along: usize, across: usize) -> Result<Self, InvalidValue> {
        let elements = along.saturating_mul(across);
        check::require(elements <= 10_000, "elements", elements as f64, "at most 10000")?;
        let valid = "between 4 and 200";
        let check = |name, n: usize| check::require((4..=200).contains(&n), name, n as f64, valid);
        Ok(Self { along: check("along", along)?, across: check("across", across)? })
    }

    /// For bodies so unlike: [`Resolution::STANDARD`] is off by 1 % rms with its own elements (60 random
    /// cases with `kappa/mu` to 3), and by 0.12 % with half as many more along (136 other cases).
    pub(crate) fn between_bodies(self, kappa_over_mu: f64) -> Self {
        const UNLIKE: f64 = 0.1;
        if kappa_over_mu.abs() < UNLIKE {
            return self;
        }
        Self { along: (1.5 * self.along).min(self.along.max(Self::FINE.along)), ..self }
    }

    /// Elements along and across of the coarser of the two grids for an ellipse; the finer has
    /// twice as many of each.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // small and positive
    pub(crate) fn coarse(self, a_over_b: f64) -> [usize; 2] {
        let stretch = a_over_b.powf(0.4).clamp(0.4, 2.5);
        let half = |n: f64| (0.5 * n).round().max(4.0) as usize;
        [half(self.along * stretch), half(self.across / stretch.min(2.0))]
    }
}
