//! FaStrip: strip theory in the adhesion area, FASTSIM for the direction in the slip area.
//!
//! M. S. Sichani, R. Enblom, M. Berg, An alternative to FASTSIM for tangential solution of the
//! wheel-rail contact, Vehicle System Dynamics 54 (2016) 748-764. The adhesion area and the
//! traction in it are those of strip theory, with creepages and spin scaled so that the linear
//! theory's `C11`, `C22` and `C23` come out; in the slip area the traction is `mu` times the
//! Hertz pressure, in the direction of FASTSIM's.
//!
//! [`Variant::Original`] follows the usual code ([sources](crate::approximate)). Verified by strip
//! theory, with which the adhesion area agrees for the strips' coefficients, by the linear theory's
//! derivatives at zero creepage, and by independent implementations.
//!
//! # Quadrature
//! The grid is that of [FASTSIM](super::fastsim). The strip's own traction, continued with its
//! direction into the slip area, is integrated along the strip in closed form; cells add only
//! what the turned direction changes, in parts where the border of the slip area crosses them.
//! So the force has no jumps as the border moves over the grid, and its derivative is exact.

mod turn;

use turn::{Row, Turn};

use super::dual::{self, Dual, Real};
use super::fastsim::{
    Block, Flexibilities, Flexibility, Grid, Increments, LANES, Place, Profile, Slopes, Sums,
    Totals, Trace, TractionBound, march,
};
use super::linear::CreepageCoefficients;
use super::strip::{Strip, StripNumbers, strip_slope, unit};
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::theory::{Jacobian, Solved, Stateless};
use crate::{Creepage, FieldPoint, Region, Solution, Status, Theory};

/// The original FaStrip, or one whose defects are mended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Variant {
    /// As published in 2016. FASTSIM runs with three flexibilities and a parabolic bound, that
    /// for `a < b` is raised by `1 + (1 - a/b)^4`; with one flexibility in strips that slip from
    /// the leading edge on, which is decided here by the slopes at the edge and not by the first
    /// cell, whose size would matter. Strip theory is used even beyond its bound in spin, where
    /// forces come out several times too large.
    Original,
    /// As in the program CONTACT. FASTSIM runs with blended flexibilities and the elliptic
    /// bound. Beyond the bound in spin, a strip without solution slides; one whose traction
    /// would exceed the largest traction bound takes FASTSIM's traction.
    Modified,
    /// As `Modified`, but with the direction of the strip's traction for which slip vanishes in
    /// the adhesion area; that of the others does so for zero spin or Poisson's ratio only, and
    /// leaves up to 5 % of the creepage otherwise. And beyond the bound in spin (`|psi| >= 1`),
    /// where strip theory does not hold, the whole contact slides. So the force is continuous
    /// but at the bound. The most accurate of the approximate theories: root mean square error
    /// 2.6 % of `mu N`.
    #[default]
    Consistent,
}

/// FaStrip, prepared for one ratio of semi-axes, one Poisson's ratio and one grid.
///
/// ```
/// use creepage::approximate::fastrip::{Fastrip, Variant};
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let circle = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let theory = Fastrip::new(&circle, Variant::default(), [50, 50])?;
/// let force = theory.solve(Creepage::new(0.9, 0.0, 0.0)?).force;
/// assert!((force.fx - 0.733).abs() < 0.02); // the full theory's value is 0.733
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Fastrip {
    contact: Contact,
    variant: Variant,
    flexibilities: Flexibilities,
    profile: Profile,
    march: Grid,
    hertz: Grid,
    /// Width of a strip over `b`.
    width: f64,
    /// Strip theory's creepages and spin per `xi`, `eta`, `chi`.
    scales: [f64; 3],
}

impl Fastrip {
    /// Prepares the theory for a contact and `[nx, ny]` cells; interpolates the creepage coefficients.
    ///
    /// # Errors
    /// [`InvalidValue`] as of [`Fastsim::new`](super::fastsim::Fastsim::new).
    pub fn new(
        contact: &Contact,
        variant: Variant,
        grid: [usize; 2],
    ) -> Result<Self, InvalidValue> {
        Self::with_coefficients(
            contact,
            &CreepageCoefficients::interpolated(contact)?,
            variant,
            grid,
        )
    }

    fn with_coefficients(
        contact: &Contact,
        coefficients: &CreepageCoefficients,
        variant: Variant,
        grid: [usize; 2],
    ) -> Result<Self, InvalidValue> {
        use std::f64::consts::PI;
        let (ellipse, poisson) = (contact.ellipse(), contact.poisson());
        let slope = strip_slope(&ellipse, poisson);
        let CreepageCoefficients { c11, c22, c23, .. } = *coefficients;
        let profile = match variant {
            Variant::Original => {
                TractionBound::Parabolic.profile(1.0 + (1.0 - ellipse.ratio()).max(0.0).powi(4))
            }
            Variant::Modified | Variant::Consistent => TractionBound::Elliptic.profile(1.0),
        };
        Ok(Self {
            flexibilities: Flexibilities::new(&ellipse, slope, coefficients)?,
            profile,
            march: Grid::new(&ellipse, grid, profile)?,
            hertz: Grid::new(&ellipse, grid, Profile::Elliptic)?,
            width: 2.0 / grid[1] as f64,
            scales: [4.0 / (PI * PI) * c11, 4.0 / (PI * PI) * c22, 3.0 / PI * c23]
                .map(|v| v * slope),
            contact: contact.clone(),
            variant,
        })
    }

    fn numbers<R: Real>(&self, [xi, eta, chi]: [R; 3]) -> StripNumbers<R> {
        StripNumbers {
            longitudinal: xi * self.scales[0],
            lateral: eta * self.scales[1],
            spin: chi * self.scales[2],
            shear: self.contact.ellipse().b()
                / (self.contact.ellipse().a() * (1.0 - self.contact.poisson())),
        }
    }

    /// What is to be done with the strip at `t = y/b` of half-length `a s`.
    fn treatment<R: Real>(&self, numbers: &StripNumbers<R>, t: f64, s: f64) -> Treatment<R> {
        let strip = numbers.strip(t);
        let psi = numbers.spin.value().abs();
        if self.variant == Variant::Consistent {
            return if psi < 1.0 { Treatment::Strip(strip) } else { Treatment::Slides };
        }
        // Near one the published algorithm lets all strips slide.
        let solved = (psi - 1.0).abs() >= 1e-6 && strip.depth.value() >= 0.0;
        if !solved {
            return Treatment::Slides;
        }
        let strip = strip.with_published_direction(1.0 - self.contact.poisson());
        if self.variant == Variant::Modified && psi > 1.0 && self.exceeds(&strip, s) {
            Treatment::Fastsim
        } else {
            Treatment::Strip(strip)
        }
    }

    /// Whether the traction exceeds the largest bound somewhere in the adhesion area. For
    /// `|psi| <= 1` it never exceeds even the local bound, as `|m|^2 <= 2 (n, m)` then.
    fn exceeds<R: Real>(&self, strip: &Strip<R>, s: f64) -> bool {
        let strip = strip.value();
        self.hertz.cells.iter().any(|cell| {
            let u = s * cell.x;
            let [x, y] = strip.traction(u, s);
            strip.inside(u, s) > 0.0 && x.hypot(y) > 1.0
        })
    }

    /// Slopes of FASTSIM's traction in the strip at `y` of half-length `a s`.
    fn slopes<R: Real>(&self, slopes: &[Slopes<R>; 2], y: f64, s: f64) -> Slopes<R> {
        let [usual, one] = *slopes;
        let half_length = self.contact.ellipse().a() * s;
        let [x, y] = usual.at([half_length, y]).map(R::value);
        // The parabola's slope at the leading edge; an ellipse's is infinite.
        let slips = x.hypot(y) * half_length > 2.0 * self.profile.peak(s);
        if self.variant == Variant::Original && slips { one } else { usual }
    }

    fn usual_and_one<R: Real>(&self, creepage: [R; 3]) -> [Slopes<R>; 2] {
        let usual = match self.variant {
            Variant::Original => Flexibility::Three,
            Variant::Modified | Variant::Consistent => Flexibility::Blended,
        };
        [usual, Flexibility::One].map(|use_of| self.flexibilities.slopes(use_of, creepage))
    }

    /// Force, and its derivative by each of the `K` tangents of `creepage`.
    fn force<R: Real, const K: usize>(&self, creepage: [R; 3]) -> Totals<K> {
        let mut totals = Totals::zero();
        let slopes = self.usual_and_one(creepage);
        let numbers = self.numbers(creepage);
        let [a, b] = [self.contact.ellipse().a(), self.contact.ellipse().b()];
        for (block, hertz) in self.march.blocks.iter().zip(&self.hertz.blocks) {
            let rows = block.y.map(|y| self.row(&numbers, y / b));
            let weighty = rows.iter().zip(hertz.weight).filter(|(_, weight)| *weight > 0.0);
            weighty.for_each(|(row, _)| totals.add(row.force, 0.75 * self.width));
            let slopes: [Slopes<R>; LANES] =
                std::array::from_fn(|l| self.slopes(&slopes, block.y[l], block.half_length[l] / a));
            let increments = Increments::new(block, &slopes);
            self.turn(&increments, &Turn::new(&rows), hertz, &mut totals);
        }
        // As published, forces may be several times too large.
        if self.variant == Variant::Original { totals } else { totals.within_friction() }
    }

    fn row<R: Real>(&self, numbers: &StripNumbers<R>, t: f64) -> Row<R> {
        let s = ((1.0 - t) * (1.0 + t)).sqrt();
        match self.treatment(numbers, t, s) {
            Treatment::Strip(strip) => Row::of_strip(
                &strip,
                [t, s],
                [self.contact.ellipse().a(), self.contact.ellipse().b()],
            ),
            Treatment::Slides => Row::fastsim(false),
            Treatment::Fastsim => Row::fastsim(true),
        }
    }

    /// Adds what the slip areas' cells change: there the traction has FASTSIM's direction.
    fn turn<const K: usize>(
        &self,
        increments: &Increments<K>,
        turn: &Turn<K>,
        hertz: &Block,
        totals: &mut Totals<K>,
    ) {
        let mut sums = Sums::zero();
        let mut bounds = self.hertz.cells.iter().map(|cell| cell.bound);
        let cells_per_length = 0.5 * self.hertz.cells.len() as f64;
        march(&self.march, increments, |cell, state| {
            let bound = bounds.next().unwrap_or(0.0);
            sums.add(cell.x, &turn.at(cell.x, cells_per_length, bound, state));
        });
        sums.collect(hertz, totals);
    }

    fn field_point(&self, creepage: [f64; 3], position: [f64; 2]) -> FieldPoint {
        let Some(place) = Place::new(&self.contact.ellipse(), position) else {
            return FieldPoint::outside(position);
        };
        let adhesion =
            |traction| FieldPoint { position, traction, slip: [0.0; 2], region: Region::Adhesion };
        let slip =
            |traction| FieldPoint { position, traction, slip: [f64::NAN; 2], region: Region::Slip };
        let treatment = self.treatment(&self.numbers(creepage), place.t, place.s);
        let u = place.along * place.s;
        if let Treatment::Strip(strip) = &treatment
            && strip.inside(u, place.s) > 0.0
        {
            return adhesion(strip.traction(u, place.s));
        }
        let slopes = self.slopes(&self.usual_and_one(creepage), place.y, place.s);
        let trace = Trace::new(&self.march, self.profile, &slopes, &place);
        if matches!(treatment, Treatment::Fastsim) {
            let traction = trace.traction.map(|v| v / Profile::HERTZ_PEAK);
            return if trace.slides() { slip(traction) } else { adhesion(traction) };
        }
        let bound = place.s * Profile::Elliptic.along(place.along);
        slip(unit(trace.traction).map(|n| n * bound))
    }
}

impl Theory for Fastrip {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        let totals = self.force::<f64, 0>(dual::plain(creepage));
        Solution::closed_form(dual::force(totals.force), Status::Solved)
    }

    /// The theory does not give the slip in the slip area.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let plain = dual::plain(creepage);
        positions.iter().map(|&position| self.field_point(plain, position)).collect()
    }

    /// Exact derivative of the force (of its discrete value): rows `fx`, `fy`, `mz`; columns
    /// `xi`, `eta`, `chi`. At a kink it is one of the one-sided values.
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        Some(self.force::<Dual, 3>(dual::variables(creepage)).jacobian())
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}

/// How a strip is treated.
#[derive(Debug, Clone, Copy)]
enum Treatment<R> {
    /// By strip theory.
    Strip(Strip<R>),
    /// It slides all over, in FASTSIM's direction.
    Slides,
    /// It has FASTSIM's traction.
    Fastsim,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::approximate::strip::StripTheory;
    use crate::ellipse::Ellipse;

    /// Those of narrow strips in plane strain, the limit of `a/b -> 0` (for `nu = 0`; strips cannot
    /// see how `C23` grows for others).
    fn strip_coefficients(a_over_b: f64, poisson: f64) -> CreepageCoefficients {
        let c23 = std::f64::consts::PI / 3.0 * a_over_b.sqrt();
        let (c22, c33) = (
            std::f64::consts::PI * std::f64::consts::PI / 4.0,
            std::f64::consts::PI * std::f64::consts::PI / (16.0 * (1.0 - poisson)) / a_over_b,
        );
        CreepageCoefficients { c11: c22 / (1.0 - poisson), c22, c23, c32: -c23, c33 }
    }

    /// With the strips' own coefficients, the consistent variant is strip theory in the adhesion
    /// area, which has no slip there; the published direction is not, unless spin or Poisson's ratio
    /// is zero.
    #[test]
    fn adhesion_is_that_of_strip_theory() {
        let difference = |variant, poisson: f64, at| {
            let a_over_b = 0.5_f64;
            let contact = Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), poisson).unwrap();
            let c = strip_coefficients(a_over_b, poisson);
            let theory = Fastrip::with_coefficients(&contact, &c, variant, [20, 20]).unwrap();
            let strips = StripTheory::new(&contact);
            let (a, b) = (a_over_b.sqrt(), a_over_b.sqrt().recip());
            let mut largest = 0.0_f64;
            let mut seen = 0;
            for k in 0..300 {
                let (radius, angle) = (f64::from(k) / 301.0, f64::from(k) * 2.4);
                let position = [a * radius * angle.cos(), b * radius * angle.sin()];
                let [one, other] =
                    [&theory as &dyn Theory, &strips].map(|t| t.field(at, &[position])[0]);
                assert_eq!(one.region, other.region);
                if one.region == Region::Adhesion {
                    seen += 1;
                    let [dx, dy] = [0, 1].map(|i| one.traction[i] - other.traction[i]);
                    largest = largest.max(dx.hypot(dy));
                }
            }
            assert!(seen > 30, "{seen}");
            largest
        };
        let with_spin = Creepage { xi: 0.3, eta: -0.4, chi: 0.4 };
        let without = Creepage { chi: 0.0, ..with_spin };
        assert!(difference(Variant::Consistent, 0.28, with_spin) < 1e-12);
        assert!(difference(Variant::Modified, 0.28, with_spin) > 1e-3);
        assert!(difference(Variant::Modified, 0.28, without) < 1e-12);
        assert!(difference(Variant::Modified, 0.0, with_spin) < 1e-12);
    }
}
