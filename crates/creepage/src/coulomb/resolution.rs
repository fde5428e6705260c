//! Grid resolutions by name, and how element counts follow from them.

use crate::check::{self, InvalidValue};
use crate::contact::Contact;

/// How many times as many elements along and across there are as on a circle between like bodies.
struct Refinement {
    times: [f64; 2],
    /// Of `a/b`, powers and how far they go: on contacts wider than long, and longer than wide.
    wide: Powers,
    long: Powers,
}

type Powers = [(f64, [f64; 2]); 2];

/// Chosen on 200 random cases (a/b .15-6, creepage to 3, spin to 8) against 96 x 80 elements, so that errors
/// are about the same at every `a/b`.
const LIKE: Refinement = Refinement {
    times: [1.0, 1.0],
    wide: [(0.2, [0.4, 1.0]), (-0.43, [1.0, 2.7])],
    long: [(0.6, [1.0, 2.5]), (-0.3, [0.5, 1.0])],
};
/// Chosen on 700 such cases with `kappa/mu` to 3: with the elements of like bodies
/// [`Resolution::STANDARD`] is off by 1 % rms, with half as many more along by 0.08 %, with these by 0.045 %.
const UNLIKE: Refinement = Refinement {
    times: [1.5, 1.25],
    wide: [(0.0, [1.0, 1.0]), (-0.4, [1.0, 2.5])],
    long: [(0.6, [1.0, 2.5]), (-0.15, [0.5, 1.0])],
};

/// How finely the contact is cut: the number of elements along and across a circle.
///
/// On an ellipse longer in the rolling direction [`Exact`](super::Exact) has `(a/b)^0.6` times as many
/// along, up to 2.5, and `(a/b)^0.3` times fewer across, up to 2; on a wider one `(b/a)^0.2` times
/// fewer along and `(b/a)^0.43` times as many across, up to 2.7. On areas of any shape and in unsteady
/// rolling elements become more nearly square: `along s` by `across / s` with `s = (a/b)^0.4`, held
/// between 0.4 and 2.5 (2 across). There are at least 8 of each. Between unlike bodies, from
/// `|kappa|/mu = 0.1` on, traction is steeper at the leading edge: [`Exact`](super::Exact) has 1.5 times as
/// many along and 1.25 times as many across, up to 40 on a circle; the powers are 0.6 and 0.15 on a longer
/// ellipse, 0 and 0.4 on a wider one, up to 2.5.
///
/// Errors of the force in parts of `mu N` and costs are in the documentation of
/// [`Exact`](super::Exact).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    along: f64,
    across: f64,
}

impl Resolution {
    /// 10 by 8 elements: .2 milliseconds; errors twice as large as those of [`Resolution::FAST`].
    pub const COARSE: Self = Self { along: 10.0, across: 8.0 };
    /// 14 by 12 elements: less than a millisecond.
    pub const FAST: Self = Self { along: 14.0, across: 12.0 };
    /// 22 by 18 elements: a millisecond.
    pub const STANDARD: Self = Self { along: 22.0, across: 18.0 };
    /// 40 by 32 elements: some milliseconds.
    pub const FINE: Self = Self { along: 40.0, across: 32.0 };

    /// `along` by `across` elements on a circle. With thousands of them slight creepage on a long contact may
    /// end as [`NotConverged`](crate::Status::NotConverged): elements are much shorter than their strips are
    /// wide.
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

    /// Most elements on an ellipse.
    pub(crate) const MOST_ELEMENTS: usize = 12_000;

    /// Elements along and across that [`Exact`](super::Exact) has for a contact.
    #[must_use]
    pub fn elements(self, contact: &Contact) -> [usize; 2] {
        let ratio = contact.ellipse().ratio();
        self.coarse_steady(ratio, contact.kappa_over_mu()).map(|half| 2 * half)
    }

    /// Elements along and across of the coarser of two grids, nearly square; the finer has twice as
    /// many of each.
    pub(crate) fn coarse(self, a_over_b: f64) -> [usize; 2] {
        let stretch = a_over_b.powf(0.4).clamp(0.4, 2.5);
        self.halved([stretch, stretch.min(2.0).recip()])
    }

    /// The same for steady rolling on an ellipse of bodies so unlike.
    pub(crate) fn coarse_steady(self, a_over_b: f64, kappa_over_mu: f64) -> [usize; 2] {
        const UNLIKE_FROM: f64 = 0.1;
        let is_like = kappa_over_mu.abs() < UNLIKE_FROM;
        let Refinement { times, wide, long } = if is_like { LIKE } else { UNLIKE };
        let more = |times: f64, given: f64| (times * given).min(given.max(Self::FINE.along));
        let (along, across) = (more(times[0], self.along), more(times[1], self.across));
        let powers = if a_over_b < 1.0 { wide } else { long };
        let times = powers.map(|(power, [least, most])| a_over_b.powf(power).clamp(least, most));
        Self { along, across }.halved(times)
    }

    /// Half as many along and across, times `more`.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // small and positive
    fn halved(self, [along, across]: [f64; 2]) -> [usize; 2] {
        [self.along * along, self.across * across].map(|n| (0.5 * n).round().max(4.0) as usize)
    }
}
