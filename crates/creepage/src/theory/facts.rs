//! Facts of every theory that a user should know, in one place: the command, the guide, Python and C show it from here.

/// Facts of a theory that a user should know.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[allow(clippy::struct_excessive_bools)] // facts that do not depend on one another
pub struct TheoryFacts {
    /// As in case files: `vermeulen-johnson`.
    pub name: &'static str,
    /// Year of publication.
    pub year: u16,
    /// What sets it apart, in a few words.
    pub assumes: &'static str,
    /// One force on one core, by the library's benchmarks.
    pub cost: &'static str,
    /// Root mean square error of the force in per cent of `mu N` over 132 cases of the full theory,
    /// `a/b` from 0.2 to 5, spin to 10, by `creepage accuracy`.
    pub error_percent: f64,
    /// Where to use it.
    pub good_for: &'static str,
    /// Its options, as in `[solve]` of a case file.
    pub options: &'static [&'static str],
    /// Whether its forces come with error bars.
    pub error_bars: bool,
    /// Whether it has a derivative by the creepage.
    pub derivative: bool,
    /// Whether it counts the slip by the pressure between dissimilar bodies (6.4).
    pub dissimilar_bodies: bool,
    /// Whether it has a moment about the normal; else `mz` is zero without being a result.
    pub moment: bool,
    /// Whether it follows friction that depends on the speed of slip, and a layer between the bodies.
    pub friction_laws: bool,
}

const CLOSED_FORM: TheoryFacts = TheoryFacts {
    name: "",
    year: 1967,
    assumes: "",
    cost: "",
    error_percent: 0.0,
    good_for: "",
    options: &[],
    error_bars: false,
    derivative: true,
    dissimilar_bodies: false,
    moment: true,
    friction_laws: false,
};

pub(super) const EXACT: TheoryFacts = TheoryFacts {
    name: "exact",
    year: 2026,
    assumes: "Coulomb on elements",
    cost: "1 ms",
    error_percent: 0.1,
    good_for: "any case, with error bars",
    options: &["resolution", "accuracy", "coupled", "prescribed"],
    error_bars: true,
    dissimilar_bodies: true,
    friction_laws: true,
    ..CLOSED_FORM
};

pub(super) const VARIATIONAL: TheoryFacts = TheoryFacts {
    name: "variational",
    assumes: "polynomial tractions",
    cost: "130 us",
    error_percent: 5.8,
    good_for: "any but the smallest creepage",
    options: &["degree", "mesh", "weight", "bound"],
    derivative: false,
    dissimilar_bodies: true,
    ..CLOSED_FORM
};

pub(super) const FASTRIP: TheoryFacts = TheoryFacts {
    name: "fastrip",
    year: 2016,
    assumes: "strips stick, springs slide",
    cost: "16 us",
    error_percent: 2.6,
    good_for: "any creepage and spin",
    options: &["grid", "variant"],
    ..CLOSED_FORM
};

pub(super) const FASTSIM: TheoryFacts = TheoryFacts {
    name: "fastsim",
    year: 1982,
    assumes: "a bed of springs",
    cost: "5.1 us",
    error_percent: 3.5,
    good_for: "any creepage and spin, fast",
    options: &["grid", "flexibility", "bound", "reduction"],
    friction_laws: true,
    ..CLOSED_FORM
};

pub(super) const STRIP: TheoryFacts = TheoryFacts {
    name: "strip",
    assumes: "plane strips, a << b",
    cost: "0.9 us",
    error_percent: 21.3,
    good_for: "slender contacts, little spin",
    ..CLOSED_FORM
};

pub(super) const POLACH: TheoryFacts = TheoryFacts {
    name: "polach",
    year: 1999,
    assumes: "traction that grows steadily",
    cost: "41 ns",
    error_percent: 13.9,
    good_for: "vehicle dynamics with little spin",
    options: &["reduction"],
    moment: false,
    ..CLOSED_FORM
};

pub(super) const SHEN_HEDRICK_ELKINS: TheoryFacts = TheoryFacts {
    name: "shen-hedrick-elkins",
    year: 1983,
    assumes: "linear forces, cubic saturation",
    cost: "29 ns",
    error_percent: 30.0,
    good_for: "vehicle dynamics, spin below 0.5",
    ..CLOSED_FORM
};

pub(super) const VERMEULEN_JOHNSON: TheoryFacts = TheoryFacts {
    name: "vermeulen-johnson",
    year: 1964,
    assumes: "no spin, adhesion in an ellipse",
    cost: "7.5 ns",
    error_percent: 41.0,
    good_for: "creepage without spin",
    moment: false,
    ..CLOSED_FORM
};

pub(super) const LINEAR: TheoryFacts = TheoryFacts {
    name: "linear",
    assumes: "no slip anywhere",
    cost: "11 ns",
    error_percent: 336.0,
    good_for: "creepage and spin near zero",
    ..CLOSED_FORM
};

pub(super) const SATURATED: TheoryFacts = TheoryFacts {
    name: "saturated",
    assumes: "slip everywhere, as if rigid",
    cost: "0.8 us",
    error_percent: 40.5,
    good_for: "large creepage or spin",
    ..CLOSED_FORM
};
