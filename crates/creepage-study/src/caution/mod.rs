//! Warnings about a solution: what it neglects, where it may be wrong, what looks like another unit.

mod words;

use std::f64::consts::FRAC_PI_2;

use creepage::gap::Gap;
use creepage::normal::{self, NormalContact, Patch};
use creepage::theory::ExactOptions;
use creepage::{Contact, Ellipse, Hertz, Layer, Scaling, SiCreepage, Solution, Status, TheorySpec};
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
    },
    /// The theory takes friction as constant, though it falls with the speed of slip or differs across
    /// the contact.
    ConstantFriction {
        /// The theory.
        theory: &'static str,
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
    /// No solid bears the pressure: a number may be in another unit.
    HighPressure {
        /// The peak pressure (Pa).
        peak_pressure: f64,
        /// The combined shear modulus (Pa).
        shear_modulus: f64,
    },
    /// Areas of any shape, or a line that rolls in steps, between unlike bodies: the slip that the pressure causes is
    /// left out.
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
    /// A creepage that a wheel does not have: it may be in per cent or in degrees.
    LargeCreepage {
        /// `longitudinal` or `lateral`.
        component: &'static str,
        /// Relative velocity over rolling velocity.
        value: f64,
    },
}

impl Caution {
    /// `|kappa/mu|` from which neglecting it matters: the force may be off by a hundredth of `mu N`
    /// then, about the median error of the best of the theories that neglect it.
    pub const DISSIMILAR: f64 = 0.01;

    /// By how much coupling moves a force, in parts of `mu N`, over `|q|`, `q = kappa mu/(1 - sigma)`:
    /// 0.05 to 0.17 in steel on aluminium and on a polymer, friction 0.05 and 0.3, `a/b` 0.5 and 1. Of 94
    /// random cases (0.004 to 0.5) the caution is right in 81, needless in 4, missing in 9.
    const MOVED_BY_COUPLING: f64 = 0.15;

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
    /// Approach (m) beyond that of any elastic contact of a wheel: 1 MN on a wheel gives .5 mm.
    const DEEP: f64 = 1e-3;

    /// Part by which a layer is stiffer than a thin one from which it is named.
    const THICK: f64 = 0.05;
    /// Peclet number below which temperatures are a caution.
    pub const PECLET: f64 = 5.0;

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

    /// With fewer points of a given gap across an area, that depends on how one interpolates.
    const POINTS: usize = 10;

    /// All warnings about a solution of `theory` for `contact`.
    #[must_use]
    pub fn all(theory: &TheorySpec, contact: &Contact, solution: &Solution) -> Vec<Self> {
        let status = (solution.status != Status::Solved).then_some(Self::Status(solution.status));
        let dissimilar = match contact.areas() {
            Some(_) => Self::like_bodies(contact.kappa_over_mu()),
            None => Self::dissimilar(theory, contact.kappa_over_mu()),
        };
        let one_way = Self::one_way(theory, contact, solution);
        let accuracy =
            theory.prescribed_accuracy().zip(solution.error).map(|(prescribed, error)| {
                Self::Accuracy { prescribed, reached: error.fx.max(error.fy) }
            });
        let accuracy = accuracy.filter(|caution| {
            matches!(caution, Self::Accuracy { prescribed, reached } if reached > prescribed)
        });
        let [friction, layer] = Self::between_surfaces(theory, contact);
        let all = [status, dissimilar, one_way, friction, layer, accuracy].into_iter().flatten();
        all.chain(contact.areas().into_iter().flat_map(|areas| Self::of_areas(areas))).collect()
    }

    /// What an unlike pair loses on areas of any shape.
    pub(crate) fn like_bodies(kappa_over_mu: f64) -> Option<Self> {
        let matters = kappa_over_mu.abs() >= Self::DISSIMILAR;
        matters.then_some(Self::LikeBodies { kappa_over_mu })
    }

    /// Warnings about areas of any shape and their pressure, whatever rolls on them.
    pub(crate) fn of_areas(areas: &NormalContact) -> impl Iterator<Item = Self> {
        let peak = areas.peak_pressure().value;
        let pressure = match areas.status() {
            normal::Status::Converged => None,
            normal::Status::NotConverged { residual } => Some(Self::Pressure { residual }),
        };
        let coarse = ["x", "y"].into_iter().zip(areas.gap_points()).filter_map(|(along, n)| {
            n.filter(|n| *n < Self::POINTS).map(|points| Self::CoarseGap { points, along })
        });
        let high = Self::high_pressure(peak, areas.pair().shear_modulus());
        let error = areas.peak_pressure().error;
        let uncertain = (error > Self::UNCERTAIN * peak)
            .then_some(Self::UncertainPeak { peak_pressure: peak, error });
        high.into_iter().chain(pressure).chain(uncertain).chain(coarse)
    }

    /// Whether it says what another does: the numbers of a rough profile matter once.
    pub(crate) fn says(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Rough { body, .. }, Self::Rough { body: of, .. }) => body == of,
            _ => self == other,
        }
    }

    /// Contact areas that are large beside the radius of the gap in them.
    pub(crate) fn large_areas(gap: &Gap, areas: &NormalContact) -> Option<Self> {
        let mut widths = areas.patches().iter().flat_map(|patch| half_widths(gap, patch));
        widths.find_map(|(width, radius)| Self::large_contact(width, radius))
    }

    /// All that a theory neglects in a contact, whatever it creeps.
    #[must_use]
    pub fn neglected(theory: &TheorySpec, contact: &Contact) -> Vec<Self> {
        let dissimilar = match contact.areas() {
            Some(_) => Self::like_bodies(contact.kappa_over_mu()),
            None => Self::dissimilar(theory, contact.kappa_over_mu()),
        };
        let between = Self::between_surfaces(theory, contact).into_iter().flatten();
        dissimilar.into_iter().chain(between).collect()
    }

    /// What a theory neglects between the surfaces: a law of friction, a layer.
    #[must_use]
    pub fn between_surfaces(theory: &TheorySpec, contact: &Contact) -> [Option<Self>; 2] {
        let facts = theory.facts();
        let theory = facts.name;
        let friction = contact.rolling_friction();
        let on_areas = contact.areas().is_some();
        let follows = facts.friction_laws && (!on_areas || theory == "exact");
        // On areas every row of the simplified theories has the friction of its own place.
        let by_row = on_areas && ["fastsim", "fastrip", "saturated"].contains(&theory);
        let left_out = friction.is_some_and(|law| if by_row { law.falls() } else { law.varies() });
        let friction = left_out.then_some(Self::ConstantFriction { theory });
        let friction = friction.filter(|_| !follows);
        let layer = contact.layer().and_then(|layer| {
            if follows { Self::thick_layer(layer, contact) } else { Some(Self::NoLayer { theory }) }
        });
        [friction, layer]
    }

    /// A layer that is not thin beside the contact of which it is a part.
    fn thick_layer(layer: Layer, contact: &Contact) -> Option<Self> {
        let half_width = match contact.areas() {
            Some(areas) => smallest_half_width(areas),
            None => contact.scaling().length * contact.ellipse().minor() / contact.ellipse().c(),
        };
        Self::thick_beside(layer, half_width)
    }

    /// A layer that is not thin beside a half-width (m).
    ///
    /// Tractions of wavelength `2 pi/k` shear a layer of thickness `h` on a stiff body by `tanh(kh)/(kh)` of what each
    /// place does by itself; those of a contact have a half wave over its width at least.
    pub(crate) fn thick_beside(layer: Layer, half_width: f64) -> Option<Self> {
        let share = layer.thickness() / half_width;
        let phase = FRAC_PI_2 * share;
        let stiffer = phase / phase.tanh() - 1.0;
        (stiffer > Self::THICK).then_some(Self::ThickLayer { share, stiffer })
    }

    /// What a theory neglects between bodies that are so dissimilar, if that matters.
    #[must_use]
    pub fn dissimilar(theory: &TheorySpec, kappa_over_mu: f64) -> Option<Self> {
        let facts = theory.facts();
        if facts.dissimilar_bodies { None } else { Self::dissimilar_for(facts.name, kappa_over_mu) }
    }

    /// The same of anything that neglects the dissimilarity, such as a table.
    #[must_use]
    pub fn dissimilar_for(theory: &'static str, kappa_over_mu: f64) -> Option<Self> {
        let matters = kappa_over_mu.abs() >= Self::DISSIMILAR;
        matters.then_some(Self::Dissimilar { theory, kappa_over_mu })
    }

    /// All that a table neglects in a contact.
    #[must_use]
    pub fn all_of_table(contact: &Contact) -> Vec<Self> {
        let theory = "a table";
        let dissimilar = Self::dissimilar_for(theory, contact.kappa_over_mu());
        let varies = contact.rolling_friction().is_some_and(|friction| friction.varies());
        let friction = varies.then_some(Self::ConstantFriction { theory });
        let layer = contact.layer().map(|_| Self::NoLayer { theory });
        [dissimilar, friction, layer].into_iter().flatten().collect()
    }

    /// A semi-axis above this part of the smallest radius, and creepage above it, are cautions: the
    /// bodies are no half-spaces then, and steel does not get there without yielding.
    pub const LARGE: f64 = 0.3;

    /// What looks like a number in another unit, such as megapascals for pascals or degrees for radians.
    ///
    /// ```
    /// use creepage::{Hertz, Radii, SiCreepage, Solid, SolidPair};
    /// use creepage_study::Caution;
    /// let [ball, flat] = [6e-3, f64::INFINITY].map(|r| Radii { rolling: r, lateral: r });
    /// for (shear_modulus, count) in [(82e9, 0), (82e3, 2)] {
    ///     let steel = Solid::new(shear_modulus, 0.28)?; // in MPa: too soft
    ///     let contact = Hertz::new(SolidPair::new(steel, steel), ball, flat, 0.0, 500.0)?;
    ///     let cautions = Caution::units(&contact, Some(6e-3), SiCreepage::default());
    ///     assert_eq!(cautions.len(), count);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn units(hertz: &Hertz, smallest_radius: Option<f64>, creepage: SiCreepage) -> Vec<Self> {
        let [along, across] = hertz.relative_curvatures();
        let radius = smallest_radius.unwrap_or(0.5 / along.max(across));
        let contact = Self::large_contact(hertz.ellipse().major(), radius);
        let pressure = Self::high_pressure(hertz.peak_pressure(), hertz.pair().shear_modulus());
        contact.into_iter().chain(pressure).chain(Self::large_creepage(creepage)).collect()
    }

    /// The same of a line contact: its half-width and the smallest radius (m), its peak pressure and the
    /// shear modulus (Pa).
    #[must_use]
    pub fn line_units(
        [half_width, radius]: [f64; 2],
        [peak_pressure, shear_modulus]: [f64; 2],
    ) -> Vec<Self> {
        let contact = Self::large_contact(half_width, radius);
        contact.into_iter().chain(Self::high_pressure(peak_pressure, shear_modulus)).collect()
    }

    /// What an ellipse is in doubt for, whatever it does: units, a metal that yields.
    pub(crate) fn of_hertz(hertz: &Hertz, smallest_radius: Option<f64>) -> Vec<Self> {
        let mut cautions = Self::units(hertz, smallest_radius, SiCreepage::default());
        if cautions.is_empty() {
            let (peak, pair) = (hertz.peak_pressure(), hertz.pair());
            cautions.extend(Self::yields(peak, pair.shear_modulus(), None));
        }
        cautions
    }

    /// A contact (m) that is large beside the bodies' radius (m).
    pub(crate) fn large_contact(semi_axis: f64, radius: f64) -> Option<Self> {
        (semi_axis > Self::LARGE * radius).then_some(Self::LargeContact { semi_axis, radius })
    }

    /// A pressure (Pa) above the shear modulus (Pa).
    pub(crate) fn high_pressure(peak_pressure: f64, shear_modulus: f64) -> Option<Self> {
        (peak_pressure > shear_modulus)
            .then_some(Self::HighPressure { peak_pressure, shear_modulus })
    }

    /// The components of a creepage that no wheel has.
    pub(crate) fn large_creepage(creepage: SiCreepage) -> impl Iterator<Item = Self> {
        let SiCreepage { longitudinal, lateral, .. } = creepage;
        let components = [("longitudinal", longitudinal), ("lateral", lateral)];
        let large = components.into_iter().filter(|(_, value)| value.abs() > Self::LARGE);
        large.map(|(component, value)| Self::LargeCreepage { component, value })
    }

    /// Whether it is one of [`Caution::units`].
    #[must_use]
    pub fn is_of_units(&self) -> bool {
        matches!(
            self,
            Self::LargeContact { .. } | Self::HighPressure { .. } | Self::LargeCreepage { .. }
        )
    }

    /// Whether coupling would move the force of `exact` by more than its error bars, by a cheap
    /// estimate.
    fn one_way(theory: &TheorySpec, contact: &Contact, solution: &Solution) -> Option<Self> {
        let TheorySpec::Exact(ExactOptions { coupled: false, .. }) = theory else { return None };
        if contact.areas().is_some() {
            return None;
        }
        let (friction, error) = (contact.friction()?, solution.error?);
        let q = contact.kappa_over_mu() * friction * friction / (1.0 - contact.poisson());
        let moved = Self::MOVED_BY_COUPLING * q.abs();
        (moved > error.fx.max(error.fy)).then_some(Self::OneWay { moved })
    }

    /// All of them in words, one after the other.
    #[must_use]
    pub fn words(cautions: &[Self]) -> String {
        cautions.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    }
}

/// The smaller half-width (m) of the area with the largest load.
fn smallest_half_width(areas: &NormalContact) -> f64 {
    let largest = areas.patches().iter().max_by(|a, b| a.load().total_cmp(&b.load()));
    let size = |patch: &Patch| patch.extent().size();
    largest.map_or(f64::NAN, |patch| size(patch).into_iter().fold(f64::INFINITY, f64::min) / 2.0)
}

/// Along and across, half the width of an area and the radius of the gap in it: that of the parabola
/// through the middle and both ends.
fn half_widths(gap: &Gap, patch: &Patch) -> [(f64, f64); 2] {
    let extent = patch.extent();
    let [x, y] = [extent.x, extent.y].map(|[low, high]| f64::midpoint(low, high));
    let middle = gap.at(x, y);
    let [along, across] =
        [extent.x.map(|end| gap.at(end, y) - middle), extent.y.map(|end| gap.at(x, end) - middle)];
    [(extent.size()[0], along), (extent.size()[1], across)].map(|(size, [one, other])| {
        let half = 0.5 * size;
        // A gap that is hollow there has none.
        (half, half * half / (one + other).max(0.0))
    })
}

#[cfg(test)]
mod tests {
    use creepage::coulomb::{Exact, Resolution};
    use creepage::{Creepage, Ellipse, Theory};

    use super::*;

    fn contact(ratio: f64, poisson: f64, kappa_over_mu: f64) -> Contact {
        let like = Contact::new(Ellipse::from_ratio(ratio).unwrap(), poisson).unwrap();
        like.with_kappa_over_mu(kappa_over_mu).unwrap()
    }

    #[test]
    fn the_force_may_be_off_by_about_kappa_over_mu() {
        // The ends of the range that is claimed: slender one way and the other.
        for (ratio, poisson, resolution, range) in [
            (1.0, 0.28, Resolution::STANDARD, 0.95..1.05),
            (0.05, 0.1, Resolution::FAST, 0.35..2.2),
            (0.05, 0.45, Resolution::FAST, 0.35..2.2),
            (20.0, 0.1, Resolution::FAST, 0.35..2.2),
            (20.0, 0.45, Resolution::FAST, 0.35..2.2),
        ] {
            let change = |kappa_over_mu: f64, creepage| {
                let [like, unlike] = [0.0, kappa_over_mu].map(|kappa| {
                    let contact = contact(ratio, poisson, kappa);
                    Exact::new(&contact, resolution).unwrap().solve(creepage).force
                });
                (unlike.fx - like.fx).hypot(unlike.fy - like.fy) / kappa_over_mu
            };
            let at_rest = change(Caution::DISSIMILAR, Creepage::default());
            assert!(range.contains(&at_rest), "{ratio} {poisson}: {at_rest}");
            for [xi, eta, chi] in [[0.2, 0.0, 0.0], [0.0, 0.5, 0.5], [-0.5, 0.0, 2.0]] {
                let creepage = Creepage::new(xi, eta, chi).unwrap();
                // Nowhere more than where all adheres; 5 % for the coarse elements.
                assert!(change(0.3, creepage) < 1.05 * at_rest, "{ratio} {poisson} {xi}");
            }
        }
    }

    /// A layer is thin up to about a quarter of the half-width, on ellipses across as along; theories that leave it out
    /// say that instead.
    #[test]
    fn a_thick_layer_is_a_caution() {
        let exact = TheorySpec::named("exact").unwrap();
        for (ratio, thickness, is_thick) in
            [(1.0, 0.2, false), (1.0, 0.3, true), (0.25, 0.12, false), (4.0, 0.2, true)]
        {
            let layer = Layer::elastic(thickness, 1.0).unwrap();
            let contact = contact(ratio, 0.28, 0.0).with_layer(layer);
            let thick =
                Caution::neglected(&exact, &contact).into_iter().find_map(
                    |caution| match caution {
                        Caution::ThickLayer { share, stiffer } => Some((share, stiffer)),
                        _ => None,
                    },
                );
            assert_eq!(thick.is_some(), is_thick, "{ratio} {thickness}");
            // By the second order of tanh, and less.
            assert!(
                thick.is_none_or(|(share, stiffer)| stiffer < (FRAC_PI_2 * share).powi(2) / 3.0)
            );
            let polach = TheorySpec::named("polach").unwrap();
            let others = Caution::neglected(&polach, &contact);
            assert_eq!(others, [Caution::NoLayer { theory: "polach" }]);
        }
    }

    #[test]
    fn what_matters_is_a_caution_for_all_but_the_full_theory() {
        for theory in TheorySpec::all() {
            for kappa_over_mu in [-5.0, -0.01, 0.01, 0.4] {
                let caution = Caution::dissimilar(&theory, kappa_over_mu);
                let counts = ["exact", "variational"].contains(&theory.facts().name);
                assert_eq!(caution.is_some(), !counts);
            }
            assert_eq!(Caution::dissimilar(&theory, -0.009), None);
        }
        let polach = TheorySpec::named("polach").unwrap();
        let words = Caution::dissimilar(&polach, -0.37).unwrap().to_string();
        assert!(words.contains("kappa/mu = -0.370") && words.contains("37 % of mu N"), "{words}");
    }

    #[test]
    fn numbers_in_other_units_are_cautions_from_their_bounds_on() {
        let steel = creepage::Solid::new(1e9, 0.25).unwrap();
        let ellipse = Ellipse::new(3e-3, 2e-3).unwrap();
        let hertz = |load| {
            Hertz::from_ellipse(creepage::SolidPair::new(steel, steel), ellipse, load).unwrap()
        };
        let units = |load, radius, longitudinal, lateral| {
            let creepage = SiCreepage { longitudinal, lateral, spin: 9.0 };
            Caution::units(&hertz(load), radius, creepage)
        };
        assert_eq!(units(1e3, Some(10.1e-3), 0.3, -0.3), []);
        assert_eq!(units(1e3, Some(9.9e-3), 0.0, 0.0).len(), 1);
        assert_eq!(units(1e3, None, 0.31, -0.31).len(), 2);
        // Peak pressure 3N / (2 pi a b), with the modulus of 1 GPa: from 12.57 kN on. The ellipse
        // then belongs to bodies of its own size.
        assert_eq!(units(12.5e3, Some(1.0), 0.0, 0.0), []);
        assert_eq!(units(12.6e3, Some(1.0), 0.0, 0.0).len(), 1);
        let words = Caution::words(&units(12.6e3, None, 2.0, 0.0));
        for part in ["0.003 m is more", "1.003 GPa exceeds", "longitudinal creepage of 2 "] {
            assert!(words.contains(part), "{part} is not in {words}");
        }
        assert!(units(12.6e3, None, 2.0, 0.0).iter().all(Caution::is_of_units));
    }

    #[test]
    fn an_accuracy_out_of_reach_is_a_caution() {
        let auto = crate::theory_spec("exact", &["resolution=auto", "accuracy=1e-9"]).unwrap();
        let contact = contact(1.0, 0.3, 0.0);
        let solution = Solution {
            force: creepage::Force::default(),
            error: Some(creepage::Force { fx: 1e-4, fy: 0.0, mz: 0.0 }),
            status: Status::NotConverged,
            statistics: creepage::Statistics::default(),
        };
        let cautions = Caution::all(&auto, &contact, &solution);
        assert_eq!(cautions.len(), 2);
        assert!(Caution::words(&cautions).contains("1.00e-4 of mu N"));
    }
}
