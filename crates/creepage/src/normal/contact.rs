//! The solved normal contact of two bodies of any shape: its patches and their pressure.

use super::lattice::Lattice;
use super::patch::Patch;
use super::patch_strip::{Band, Moments};
use super::strip_system::Factors;
use crate::Scaling;
use crate::check::{self, InvalidValue};
use crate::solid::SolidPair;
use std::sync::Arc;

/// A number and how far the true one may lie from it.
///
/// Of 145 random gaps that had no part in choosing them, at [`Resolution::STANDARD`] against three times as
/// many strips, the bars cover all errors of the load, 98 of 100 of the peak pressure and 97 of the area,
/// and half of them are more than six, seven and five times as long as the error. None knows of a
/// summit of pressure at a kink along x, which strips round off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Its error bar, from two resolutions; zero for what was prescribed.
    pub error: f64,
}

/// Resolution of contact areas: the number of strips across an area, or of elements along a mean chord of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    pub(super) count: usize,
    /// Whether a solution with half as many strips tells the error.
    pub(super) with_errors: bool,
}

impl Resolution {
    /// 12 strips, or some 170 elements in a compact area.
    pub const FAST: Self = Self::of(12);
    /// 20 strips, or some 450 elements in a compact area.
    pub const STANDARD: Self = Self::of(20);
    /// 32 strips, or some 1,200 elements in a compact area.
    pub const FINE: Self = Self::of(32);
    /// 12 strips at once: the load errs by less than one per cent, and no error bar knows by how
    /// much. For searches.
    pub const COARSE: Self = Self { with_errors: false, ..Self::FAST };

    const fn of(count: usize) -> Self {
        Self { count, with_errors: true }
    }

    /// A number of strips across, or of elements along a chord, from 6 to 120.
    ///
    /// # Errors
    /// [`crate::InvalidValue`] outside that range.
    pub fn new(count: usize) -> Result<Self, crate::InvalidValue> {
        check::require((6..=120).contains(&count), "resolution", count as f64, "from 6 to 120")?;
        Ok(Self::of(count))
    }
}

impl Default for Resolution {
    fn default() -> Self {
        Self::STANDARD
    }
}

/// Convergence of the normal solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Status {
    /// To the solver's tolerance.
    Converged,
    /// Only up to a residual.
    NotConverged {
        /// Largest distance of a pressed point from touching, over the greatest depth.
        residual: f64,
    },
}

/// Method by which the contact was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// By strips whose pressure vanishes as a root at fitted ends.
    Strips,
    /// By rectangles of constant pressure, where the strips did not settle.
    Elements,
}

/// Least and greatest y of all bands (m).
fn sides(patches: &[Patch]) -> Vec<[f64; 2]> {
    patches.iter().flat_map(Patch::bands).map(Band::y).collect()
}

/// The contact of two bodies of any shape, solved: `u + h = approach` where pressed, with all
/// patches in one half-space.
///
/// ```
/// use creepage::gap::{Gap, Term};
/// use creepage::normal::{NormalContact, Resolution};
/// use creepage::{Solid, SolidPair};
/// // A crowned roller: h = x^2/920 + y^4/20000 in millimetres.
/// let term = |x, y, coefficient| Term { x, y, coefficient };
/// let gap = Gap::polynomial(&[term(2, 0, 1e3 / 920.0), term(0, 4, 1e9 / 20_000.0)])?;
/// let steel = Solid::new(82e9, 0.28)?;
/// let pair = SolidPair::new(steel, steel);
/// let contact = NormalContact::at_approach(&gap, pair, 50e-6, Resolution::STANDARD)?;
/// assert!((contact.load().value - 40.08e3).abs() < 40.0); // newtons
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct NormalContact {
    pub(super) pair: SolidPair,
    pub(super) approach: Estimate,
    pub(super) load: Estimate,
    pub(super) peak: Estimate,
    pub(super) area: Estimate,
    pub(super) stiffness: f64,
    pub(super) status: Status,
    pub(super) method: Method,
    pub(super) patches: Vec<Patch>,
    pub(super) gap_points: [Option<usize>; 2],
    pub(super) rule: Option<StripRule>,
    /// The lattice on which elements found it.
    pub(super) elements: Option<ElementRule>,
    /// The matrix with which strips found it.
    pub(super) factors: Option<Arc<Factors>>,
}

/// How strips found a contact: so many across the widest area, and what the load at the limit of many is over
/// theirs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StripRule {
    pub(super) count: usize,
    pub(super) load: f64,
    /// The load and the area of the contact where that was found.
    pub(super) origin: [f64; 2],
}

/// How elements found a contact: their lattice, and the load and the area of the contact where that was laid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ElementRule {
    pub(super) lattice: Lattice,
    pub(super) origin: [f64; 2],
}

/// Whether error bars found at a load and an area hold for others.
fn reaches(origin: [f64; 2], load: f64, area: f64) -> bool {
    /// Of load or area: error bars, in parts of what they belong to, change by some hundredths then.
    const MAX_CHANGE: f64 = 0.03;
    (load / origin[0] - 1.0).abs() < MAX_CHANGE && (area / origin[1] - 1.0).abs() < MAX_CHANGE
}

/// Warm start from a contact close by: its areas, the matrix of its strips, and how many it took.
#[derive(Debug, Clone)]
pub(super) struct NormalWarmStart<'a> {
    pub(super) areas: Vec<Patch>,
    pub(super) factors: Option<&'a Arc<Factors>>,
    pub(super) taken: Option<usize>,
}

impl NormalWarmStart<'_> {
    /// Areas alone.
    pub(super) fn of(areas: Vec<Patch>) -> Self {
        Self { areas, factors: None, taken: None }
    }
}

impl NormalContact {
    /// Whether load and area differ by less than three hundredths from those of the contact that found the
    /// error bars, from which this one may have followed; else [`NormalContact::next`] from here finds them anew.
    #[must_use]
    pub fn keeps_error_bars(&self) -> bool {
        let area = self.patches.iter().map(Patch::area).sum();
        let origin = self.rule.map(|rule| rule.origin);
        let origin = origin.or(self.elements.map(|elements| elements.origin));
        origin.is_none_or(|origin| reaches(origin, self.load.value, area))
    }

    /// By how much each band's least and greatest y lie further out (m) than from `near`, a contact close by,
    /// was to be expected at this approach; `None` where that has other areas.
    ///
    /// ```
    /// use creepage::gap::{Gap, Rolling};
    /// use creepage::normal::{NormalContact, Resolution};
    /// use creepage::{Solid, SolidPair};
    /// // A rail head of radius 0.3 m that moves by 0.3 mm a step.
    /// let y: Vec<f64> = (-240..=240).map(|i| f64::from(i) * 0.05e-3).collect();
    /// let gap = |at: f64| {
    ///     let h: Vec<f64> = y.iter().map(|y| (y - at).powi(2) / 0.6).collect();
    ///     Gap::section(&y, &h, Rolling::Radius(0.46))
    /// };
    /// let steel = Solid::new(82e9, 0.28)?;
    /// let first = NormalContact::at_approach(
    ///     &gap(0.0)?,
    ///     SolidPair::new(steel, steel),
    ///     50e-6,
    ///     Resolution::FAST,
    /// )?;
    /// let second = first.next(&gap(0.3e-3)?, 50e-6, Resolution::FAST)?;
    /// let drift = second.sides_beyond(&first).ok_or("other areas")?;
    /// // The third one is found from where it is to be expected.
    /// let third = second.with_sides_moved(&drift, 1.0).follow(&gap(0.6e-3)?, 50e-6);
    /// assert!(third.is_some_and(|third| third.keeps_error_bars()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn sides_beyond(&self, near: &Self) -> Option<Vec<[f64; 2]>> {
        let expected = near.grown(self.approach.value);
        let [own, expected] = [&self.patches, &expected].map(|patches| sides(patches));
        let beyond = |([low, high], [from, to]): ([f64; 2], [f64; 2])| [from - low, high - to];
        let is_like = own.len() == expected.len();
        is_like.then(|| own.into_iter().zip(expected).map(beyond).collect())
    }

    /// Predictor of the next contact like this one: its patches' sides, extrapolated by `times` their growth `beyond`.
    #[must_use]
    pub fn with_sides_moved(&self, beyond: &[[f64; 2]], times: f64) -> Self {
        let mut moved = self.clone();
        let bands = moved.patches.iter_mut().flat_map(Patch::bands_mut);
        for (band, beyond) in bands.zip(beyond) {
            *band = band.stretched(beyond.map(|by| times * by));
        }
        moved
    }

    /// What it tells of another approach close by.
    pub(super) fn near(&self, approach: f64) -> NormalWarmStart<'_> {
        let taken = self.rule.map(|rule| rule.count);
        NormalWarmStart { areas: self.grown(approach), factors: self.factors.as_ref(), taken }
    }

    /// The areas as they would be at another approach if they kept their shape: a load that goes
    /// as the depth to the power 3/2 tells the depth, whose root lengths and pressures follow.
    fn grown(&self, approach: f64) -> Vec<Patch> {
        const LIMITS: [f64; 2] = [0.5, 2.0];
        let more = self.stiffness * (approach - self.approach.value) / self.load.value;
        let factor = (1.0 + 2.0 / 3.0 * more).max(0.0).sqrt().clamp(LIMITS[0], LIMITS[1]);
        self.patches.iter().map(|patch| patch.grown(factor)).collect()
    }

    /// The equivalent solid.
    #[must_use]
    pub fn pair(&self) -> SolidPair {
        self.pair
    }

    /// Approach (m).
    #[must_use]
    pub fn approach(&self) -> Estimate {
        self.approach
    }

    /// Normal force (N).
    #[must_use]
    pub fn load(&self) -> Estimate {
        self.load
    }

    /// Largest pressure (Pa).
    #[must_use]
    pub fn peak_pressure(&self) -> Estimate {
        self.peak
    }

    /// Area of all patches (m^2).
    #[must_use]
    pub fn area(&self) -> Estimate {
        self.area
    }

    /// `dN/d(approach)` (N/m).
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Whether the equations are solved.
    #[must_use]
    pub fn status(&self) -> Status {
        self.status
    }

    /// How the contact was found.
    #[must_use]
    pub fn method(&self) -> Method {
        self.method
    }

    /// The connected areas, from low to high y.
    #[must_use]
    pub fn patches(&self) -> &[Patch] {
        &self.patches
    }

    /// The fewest given points of the gap across a patch, along x and along y; `None` where the
    /// gap is a formula. With fewer than about ten the area depends on how one interpolates.
    #[must_use]
    pub fn gap_points(&self) -> [Option<usize>; 2] {
        self.gap_points
    }

    /// Centre of pressure (m).
    #[must_use]
    pub fn centroid(&self) -> [f64; 2] {
        let mut sum = Moments::default();
        for patch in &self.patches {
            sum += patch.moments();
        }
        [sum.by_x / sum.force, sum.by_y / sum.force]
    }

    /// First and last place of all its areas along `x` and along `y` (m).
    #[must_use]
    pub fn extent(&self) -> [[f64; 2]; 2] {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let around = |one: [f64; 2], other: [f64; 2]| [one[0].min(other[0]), one[1].max(other[1])];
        let extents = self.patches.iter().map(Patch::extent);
        extents.fold([nothing; 2], |[x, y], area| [around(x, area.x), around(y, area.y)])
    }

    /// Pressure at a place (Pa), zero outside.
    #[must_use]
    pub fn pressure(&self, x: f64, y: f64) -> f64 {
        self.patches.iter().map(|patch| patch.pressure(x, y)).fold(0.0, f64::max)
    }
}

/// Unit of slip over the largest traction bound in units of `G`: the elastic slip is of order one.
pub(crate) const SLIP_UNIT: f64 = 0.5;

impl NormalContact {
    /// Units of creepage, force and position for a coefficient of friction: those of every theory
    /// of rolling on this contact. The unit of length is a root of the area, that of slip half the
    /// largest traction bound over the shear modulus.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn scaling(&self, friction: f64) -> Result<Scaling, InvalidValue> {
        check::positive("friction", friction)?;
        let traction = friction * self.peak_pressure().value;
        Ok(Scaling {
            length: (self.area().value / 3.0).sqrt(),
            slip: SLIP_UNIT * traction / self.pair().shear_modulus(),
            force: friction * self.load().value,
            traction,
        })
    }
}
