//! Every theory, with what it assumes, costs, and errs by.

use std::fmt;

use crate::{Bound, Solve};
use creepage::Hertz;
use creepage::rolling::Theory;

use crate::theories::prepare::{self, TheoryError};
use crate::theories::prepared::PreparedTheory;
use crate::theories::unlike::kappa_over_mu;

/// One theory: its name, what a user should know of it, and how to prepare it.
pub struct Entry {
    /// As in case files: `vermeulen-johnson`.
    pub name: &'static str,
    /// Year of publication.
    pub year: u16,
    /// What sets it apart, in a few words.
    pub assumes: &'static str,
    /// One force on one core, by the library's benchmarks.
    pub cost: &'static str,
    /// Root mean square error of the force in per cent of `mu N`, by `creepage accuracy`.
    pub error: f64,
    /// Where to use it.
    pub good_for: &'static str,
    /// The options in `[solve]` that it knows.
    pub options: &'static [&'static str],
    /// Which bounds it can be given, where `bound` is an option of its own.
    pub bounds: &'static [Bound],
    /// Whether its forces come with error bars.
    pub error_bars: bool,
    /// Whether it counts the slip by the pressure between unlike bodies (6.4).
    pub unlike_bodies: bool,
    prepare: fn(a_over_b: f64, poisson: f64, &Solve) -> Result<PreparedTheory, TheoryError>,
}

impl Entry {
    /// The theory prepared for the ratio `a/b` of the semi-axes and the combined Poisson's ratio;
    /// options of `solve` that are not among its own are passed over ([`choose`](crate::choose)
    /// refuses them).
    ///
    /// # Errors
    /// [`TheoryError`] for ratios and options out of the theory's range.
    pub fn prepare(
        &self,
        a_over_b: f64,
        poisson: f64,
        solve: &Solve,
    ) -> Result<PreparedTheory, TheoryError> {
        (self.prepare)(a_over_b, poisson, solve)
    }

    /// As [`Entry::prepare`], for those who ask what any theory can be asked.
    ///
    /// # Errors
    /// As [`Entry::prepare`].
    pub fn boxed(
        &self,
        a_over_b: f64,
        poisson: f64,
        solve: &Solve,
    ) -> Result<Box<dyn Theory>, TheoryError> {
        Ok(Box::new(self.prepare(a_over_b, poisson, solve)?))
    }

    /// Whether the option of that name, as `solve` has it, is one of its own.
    #[must_use]
    pub fn takes(&self, option: &str, solve: &Solve) -> bool {
        let own_word = || solve.bound.is_none_or(|bound| self.bounds.contains(&bound));
        self.options.contains(&option) && (option != "bound" || own_word())
    }

    /// The theory prepared for a contact with coefficient of friction `friction`, which matters
    /// between unlike bodies.
    ///
    /// # Errors
    /// As [`Entry::prepare`].
    pub fn for_contact(
        &self,
        contact: &Hertz,
        friction: f64,
        solve: &Solve,
    ) -> Result<PreparedTheory, TheoryError> {
        let theory = self.prepare(contact.ellipse().ratio(), contact.pair().poisson(), solve)?;
        Ok(theory.with_unlikeness(kappa_over_mu(contact, friction))?)
    }
}

impl fmt::Debug for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Entry").field(&self.name).finish()
    }
}

/// In the order of a reader's interest: the general ones first.
pub static ENTRIES: &[Entry] = &[
    Entry {
        name: "exact",
        year: 2026,
        assumes: "Coulomb on elements",
        cost: "2 ms",
        error: 0.1,
        good_for: "any case, with error bars",
        options: &["resolution", "accuracy"],
        bounds: &[],
        error_bars: true,
        unlike_bodies: true,
        prepare: prepare::exact,
    },
    Entry {
        name: "variational",
        year: 1967,
        assumes: "polynomial tractions",
        cost: "130 us",
        error: 5.8,
        good_for: "any but the smallest creepage",
        options: &["degree", "mesh", "weight", "bound"],
        bounds: &[Bound::Automatic, Bound::Unchecked, Bound::Kept],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::variational,
    },
    Entry {
        name: "fastrip",
        year: 2016,
        assumes: "strips stick, springs slide",
        cost: "16 us",
        error: 2.6,
        good_for: "any creepage and spin",
        options: &["grid", "variant"],
        bounds: &[],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::fastrip,
    },
    Entry {
        name: "fastsim",
        year: 1982,
        assumes: "a bed of springs",
        cost: "5.1 us",
        error: 3.5,
        good_for: "any creepage and spin, fast",
        options: &["grid", "flexibility", "bound"],
        bounds: &[Bound::Elliptic, Bound::Parabolic],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::fastsim,
    },
    Entry {
        name: "strip",
        year: 1967,
        assumes: "plane strips, a << b",
        cost: "0.9 us",
        error: 21.3,
        good_for: "slender contacts, little spin",
        options: &[],
        bounds: &[],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::strip,
    },
    Entry {
        name: "polach",
        year: 1999,
        assumes: "traction that grows steadily",
        cost: "41 ns",
        error: 13.9,
        good_for: "vehicle dynamics with little spin",
        options: &["reduction"],
        bounds: &[],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::polach,
    },
    Entry {
        name: "shen-hedrick-elkins",
        year: 1983,
        assumes: "linear forces, cubic saturation",
        cost: "29 ns",
        error: 30.0,
        good_for: "vehicle dynamics, spin below 0.5",
        options: &[],
        bounds: &[],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::shen_hedrick_elkins,
    },
    Entry {
        name: "vermeulen-johnson",
        year: 1964,
        assumes: "no spin, adhesion in an ellipse",
        cost: "7.5 ns",
        error: 41.0,
        good_for: "creepage without spin",
        options: &[],
        bounds: &[],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::vermeulen_johnson,
    },
    Entry {
        name: "linear",
        year: 1967,
        assumes: "no slip anywhere",
        cost: "11 ns",
        error: 336.0,
        good_for: "creepage and spin near zero",
        options: &[],
        bounds: &[],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::linear,
    },
    Entry {
        name: "saturated",
        year: 1967,
        assumes: "slip everywhere, as if rigid",
        cost: "0.8 us",
        error: 40.5,
        good_for: "large creepage or spin",
        options: &[],
        bounds: &[],
        error_bars: false,
        unlike_bodies: false,
        prepare: prepare::saturated,
    },
];
