//! Warnings about a solution: what it neglects, where it may be wrong, what looks like another unit.

mod of_theory;
mod of_units;
mod words;

use creepage::normal::{self, NormalContact};
use creepage::{Ellipse, Scaling, Status};
use creepage_rail::Role;

/// A warning about a solution; in words by [`Display`](std::fmt::Display). Text, JSON,
/// `batch`, Python and C all show it.
///
/// ```
/// use creepage::{Contact, Creepage, Ellipse, TheorySpec};
/// use creepage_study::Caution;
/// let unlike = Contact::new(Ellipse::from_ratio(1.0)?, 0.3)?.with_kappa_over_mu(0.3)?;
/// for (name, count) in [("exact", 0), ("fastsim", 1)] {
///     let theory = TheorySpec::named(name)?;
///     let solution = theory.prepare(&unlike)?.solve(Creepage::new(0.5, 0.0, 0.0)?);
///     assert_eq!(Caution::all(&theory, &unlike, &solution).len(), count);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Caution {
    /// The theory did not solve the case, or does not hold in it.
    Status(Status),
    /// The theory neglects the slip by the pressure between dissimilar bodies, though it matters.
    Dissimilar {
        /// The theory.
        theory: &'static str,
        /// How dissimilar the bodies are.
        kappa_over_mu: f64,
        /// By how much the force may be off for that, over `mu N`.
        share: f64,
    },
    /// The theory takes friction as constant, though it falls with the speed of slip or differs across
    /// the contact.
    ConstantFriction {
        /// The theory.
        theory: &'static str,
    },
    /// The coefficient of friction is one that no pair of bodies has.
    LargeFriction {
        /// The coefficient.
        friction: f64,
    },
    /// The force is larger than friction allows: the theory knows no slip.
    BeyondFriction {
        /// The theory.
        theory: &'static str,
        /// The tangential force over `mu N`.
        share: f64,
    },
    /// A load without slip that takes more friction than bodies have.
    NeedsFriction {
        /// The coefficient of friction that it takes at least.
        friction: f64,
    },
    /// The theory neglects the layer between the bodies.
    NoLayer {
        /// The theory.
        theory: &'static str,
    },
    /// The layer is not thin beside the contact, as the theory has it.
    ThickLayer {
        /// Its thickness over the smaller half-width of the contact.
        share: f64,
        /// By how much it is stiffer in truth than where each place shears by itself, about.
        stiffer: f64,
    },
    /// The contact reaches beyond the points of a rigid slip that is added from place to place.
    SlipBeyond {
        /// Along which axis.
        along: &'static str,
        /// How far, over the contact's length there.
        share: f64,
    },
    /// Pressure and contact area are taken to be Hertz's, though what tractions change about them matters.
    OneWay {
        /// By how much that may move the force, in parts of `mu N`.
        moved: f64,
    },
    /// The error bars are above the prescribed accuracy at the finest resolution.
    Accuracy {
        /// The prescribed accuracy of the forces, in parts of `mu N`.
        prescribed: f64,
        /// The larger error bar of both forces.
        reached: f64,
    },
    /// The contact is too large for bodies of that radius: a number may be in another unit.
    LargeContact {
        /// The larger semi-axis (m).
        semi_axis: f64,
        /// The smallest radius of the bodies (m); that of the contact where none is given.
        radius: f64,
    },
    /// A load moves the bodies as far as no solid: a number may be in another unit.
    LargeShift {
        /// How far (m).
        shift: f64,
        /// The smaller half-width of the contact (m).
        half_width: f64,
    },
    /// No solid bears the pressure: a number may be in another unit.
    HighPressure {
        /// The peak pressure (Pa).
        peak_pressure: f64,
        /// The combined shear modulus (Pa).
        shear_modulus: f64,
    },
    /// Both bodies are stiffer than any solid: a modulus may be in another unit.
    HighModulus {
        /// The combined shear modulus (Pa).
        shear_modulus: f64,
    },
    /// Areas of any shape, a line that rolls in steps, or a shift with slip without rolling, between unlike bodies: the
    /// slip that the pressure causes is left out.
    LikeBodies {
        /// How unlike the bodies are.
        kappa_over_mu: f64,
    },
    /// The equations of the pressure were solved only up to a residual.
    Pressure {
        /// Largest distance of a pressed point from touching, over the greatest depth.
        residual: f64,
    },
    /// Few points of the given gap lie in a contact area.
    CoarseGap {
        /// The fewest points across an area.
        points: usize,
        /// `x` or `y`.
        along: &'static str,
    },
    /// A measured profile has short waves where it touches.
    Rough {
        /// The wheel or the rail.
        body: Role,
        /// Mean length of the waves (m).
        length: f64,
        /// How far the profile turns from one side of a wave to the other (rad).
        swing: f64,
        /// Pressure on their crests that presses them flat (Pa).
        pressure: f64,
    },
    /// A profile has no points where it touches: its shape there is made up.
    Unmeasured {
        /// The wheel or the rail.
        body: Role,
        /// Length of the stretch without points (m).
        length: f64,
    },
    /// The pressure makes a metal flow: an elastic contact would be larger and its pressure lower.
    Yields {
        /// The peak pressure (Pa).
        peak_pressure: f64,
        /// Shear yield stress (Pa).
        shear_yield: f64,
        /// Whether that is given; else it is the one of a typical rail steel.
        is_given: bool,
    },
    /// The peak of the pressure did not converge, as at an edge.
    UncertainPeak {
        /// The peak pressure (Pa).
        peak_pressure: f64,
        /// Its error bar (Pa).
        error: f64,
    },
    /// A roller's pressure has a peak by an end.
    RollerEnd {
        /// The peak (Pa).
        peak: f64,
        /// The largest pressure in the middle half (Pa).
        middle: f64,
        /// Where (m).
        y: f64,
        /// Whether the contact reaches a rounded edge.
        on_edge: bool,
    },
    /// The surfaces turn within a contact that is solved in one plane.
    Turns {
        /// From one side of the contact to the other (rad).
        angle: f64,
    },
    /// The back of the flange does not touch its guard rail.
    GuardApart {
        /// What lies between them (m).
        clearance: f64,
    },
    /// A wheel carries another load than the one asked of it: that jumps as the wheel goes down.
    LoadMissed {
        /// What it carries beyond the load asked of it (N).
        missed: f64,
        /// That load (N).
        load: f64,
    },
    /// A wheel has climbed its rail, or its flange rides on it.
    Climbs {
        /// By how much it stands above the height of its tread (m).
        height: f64,
    },
    /// Bodies are pressed into each other farther than any elastic contact.
    Deep {
        /// The approach (m).
        approach: f64,
        /// The load (N).
        load: f64,
    },
    /// A wheel is pressed on its rail by less than both are rough: its load may be in another unit.
    Shallow {
        /// The approach (m).
        approach: f64,
        /// The wheel's load (N).
        load: f64,
    },
    /// A part of a rail begins or ends within a contact.
    CutPatch,
    /// A contact lies beyond the first or the last slice of a rail.
    BeyondSlices,
    /// The curvature of conforming bodies, as of a ball in its groove, makes the slip vary across the contact.
    Groove {
        /// By how much from the middle to the side, over the rolling velocity.
        slip: f64,
        /// The same over the creepage that makes bodies slide.
        share: f64,
    },
    /// A wheel that spins or is locked.
    Slides {
        /// `longitudinal` or `lateral`.
        component: &'static str,
        /// Creepage, over the mean speed of both surfaces.
        value: f64,
    },
    /// Temperatures are wanted of a theory that gives no slip.
    NoHeat {
        /// The theory.
        theory: &'static str,
    },
    /// Temperatures are wanted where one surface stands still or runs back.
    RunsBack {
        /// Longitudinal creepage.
        longitudinal: f64,
    },
    /// Heat spreads along and across too: the surfaces pass slowly.
    SlowHeat {
        /// The smaller Peclet number of both bodies.
        peclet: f64,
    },
    /// The surfaces get so hot that steel transforms.
    Hot {
        /// The highest temperature of the contact (°C).
        temperature: f64,
    },
    /// A spin that no rolling body has: it may not be in radians per metre.
    LargeSpin {
        /// Spin (rad/m).
        spin: f64,
        /// The slip that it makes at the side of the contact, over the rolling velocity.
        slip: f64,
    },
    /// A wheelset yaws as none runs: the angle may be in degrees or milliradians.
    LargeYaw {
        /// Yaw (rad).
        yaw: f64,
    },
    /// The guard rails are left out.
    NoGuard,
    /// The smallest radius is that of no machine: it may be in millimetres.
    LargeRadius {
        /// The radius (m).
        radius: f64,
    },
    /// A creepage that a wheel does not have: it may be in per cent or in degrees.
    LargeCreepage {
        /// `longitudinal` or `lateral`.
        component: &'static str,
        /// Relative velocity over rolling velocity.
        value: f64,
    },
}

impl Caution {
    /// Peak pressure over shear yield stress from which a contact is fully plastic: the mean pressure is the
    /// hardness, three times the yield stress in tension (Tabor 1951), the peak 3/2 of it, by von Mises.
    pub const FULLY_PLASTIC: f64 = 7.8;
    /// Shear modulus over the shear yield stress of a typical rail steel (82e9 and 300e6 Pa).
    const TYPICAL_YIELD: f64 = 273.0;
    /// Least shear modulus (Pa) of what is taken for a metal.
    const METAL: f64 = 20e9;
    /// Error bar of the peak pressure over it from which the peak is a caution.
    const UNCERTAIN: f64 = 0.1;
    /// Pressure by a roller's end over that in its middle half from which it is named.
    pub(crate) const EDGE: f64 = 1.1;
    /// Turn of the surfaces (rad) from which a plane contact is a caution: the undeformed distance along one
    /// normal errs by 3 % then.
    const TURN: f64 = 0.244;
    /// Height (m) above the tread's from which a wheel climbs: in a flange's throat it stands less than
    /// 1 mm high.
    const CLIMB: f64 = 2e-3;
    /// Height (m) from which a flange rides on the rail; flanges are 27 to 36 mm high.
    const RIDES: f64 = 15e-3;
    /// Yaw (rad) from which a wheelset does not run: between axles 2 m apart on a curve of 10 m it is .1.
    const YAW: f64 = 0.15;
    /// Part of its load that a wheel may miss without a word: ten times what loads are met to.
    const MISSED: f64 = 1e-3;
    /// Approach (m) beyond that of any elastic contact of a wheel: 1 MN on a wheel gives .5 mm.
    const DEEP: f64 = 1e-3;
    /// Approach (m) below which running surfaces, rough by some micrometres, touch at their crests alone.
    const SHALLOW: f64 = 2e-6;

    /// Peclet number below which temperatures are a caution.
    pub const PECLET: f64 = 5.0;
    /// Temperature (°C) above which they are one: plain steel becomes austenite from 723 °C on.
    pub const HOT: f64 = 720.0;

    /// Whether a metal flows under a peak pressure (Pa), for its shear modulus and, where it is given, its
    /// shear yield stress (Pa).
    pub(crate) fn yields(
        peak_pressure: f64,
        shear_modulus: f64,
        given: Option<f64>,
    ) -> Option<Self> {
        let typical = (shear_modulus > Self::METAL).then_some(shear_modulus / Self::TYPICAL_YIELD);
        let (shear_yield, is_given) = (given.or(typical)?, given.is_some());
        (peak_pressure > Self::FULLY_PLASTIC * shear_yield).then_some(Self::Yields {
            peak_pressure,
            shear_yield,
            is_given,
        })
    }

    /// A turn of the surfaces (rad) within one plane contact.
    pub(crate) fn turns(angle: f64) -> Option<Self> {
        (angle > Self::TURN).then_some(Self::Turns { angle })
    }

    /// Bodies that are pressed into each other too far.
    pub(crate) fn deep(normal: &NormalContact) -> Option<Self> {
        let (approach, load) = (normal.approach().value, normal.load().value);
        (approach > Self::DEEP).then_some(Self::Deep { approach, load })
    }

    /// A wheel under `load` (N) that is pressed on its rail by no more than both are rough.
    pub(crate) fn shallow(approach: f64, load: f64) -> Option<Self> {
        (approach > 0.0 && approach < Self::SHALLOW).then_some(Self::Shallow { approach, load })
    }

    /// The yaw (rad) of a wheelset that no track gives it.
    pub(crate) fn large_yaw(yaw: f64) -> Option<Self> {
        (yaw.abs() > Self::YAW).then_some(Self::LargeYaw { yaw })
    }

    /// Of a wheel a large creepage says that it spins or is locked.
    pub(crate) fn of_a_wheel(self) -> Self {
        match self {
            Self::LargeCreepage { component, value } => Self::Slides { component, value },
            other => other,
        }
    }

    /// Slip by the curvature of the contact over the unit of slip from which it is named.
    const BY_GROOVE: f64 = 0.1;

    /// The slip that conforming bodies have across the contact, where it matters.
    pub(crate) fn groove(
        by_square: Option<f64>,
        ellipse: Ellipse,
        scaling: Scaling,
    ) -> Option<Self> {
        let slip = by_square? * ellipse.b() * ellipse.b();
        let share = slip / scaling.slip;
        (share > Self::BY_GROOVE).then_some(Self::Groove { slip, share })
    }

    /// The height (m) of a wheel above that of its tread on its rail.
    pub(crate) fn climbs(height: f64) -> Option<Self> {
        (height > Self::CLIMB).then_some(Self::Climbs { height })
    }

    /// A wheel that carries `carried` (N), by `missed` more than is asked of it.
    pub(crate) fn load_missed(carried: f64, missed: f64) -> Option<Self> {
        let load = carried - missed;
        (missed.abs() > Self::MISSED * load.abs()).then_some(Self::LoadMissed { missed, load })
    }

    /// With fewer points of a given gap across an area, that depends on how one interpolates.
    const MIN_GAP_POINTS: usize = 10;

    /// Warnings about areas of any shape and their pressure, whatever rolls on them.
    pub(crate) fn of_areas(areas: &NormalContact) -> impl Iterator<Item = Self> {
        let peak = areas.peak_pressure().value;
        let pressure = match areas.status() {
            normal::Status::Converged => None,
            normal::Status::NotConverged { residual } => Some(Self::Pressure { residual }),
        };
        let coarse = ["x", "y"].into_iter().zip(areas.gap_points()).filter_map(|(along, n)| {
            n.filter(|n| *n < Self::MIN_GAP_POINTS).map(|points| Self::CoarseGap { points, along })
        });
        let high = Self::moduli(peak, areas.pair().shear_modulus());
        let error = areas.peak_pressure().error;
        let uncertain = (error > Self::UNCERTAIN * peak)
            .then_some(Self::UncertainPeak { peak_pressure: peak, error });
        high.chain(pressure).chain(uncertain).chain(coarse)
    }

    /// Whether it says what another does: the numbers of a rough profile matter once.
    pub(crate) fn says(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Rough { body, .. }, Self::Rough { body: of, .. }) => body == of,
            _ => self == other,
        }
    }

    /// All of them in words, one after the other.
    #[must_use]
    pub fn words(cautions: &[Self]) -> String {
        cautions.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    }
}
