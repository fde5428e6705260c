//! Curved contacts, whose surfaces turn across the rolling direction: a ball in its groove, a wheel's throat on a gauge
//! corner. Arc length across in place of a plane, and a normal that turns with it.
//!
//! With `s` the arc length across, `alpha(s)` the direction of the surface there (the angle from the
//! contact's middle, positive where it goes down to the lower body) and `h(x, s)` the undeformed distance
//! along the local normal, an approach `D` in the direction of the middle closes the gap by
//! `D cos(alpha)`. The influence of pressures and tractions is that of the half-space at the distance along the
//! arc. Forces are
//!
//! ```math
//! F_z = \int (p \cos\alpha + q_s \sin\alpha) \, dA, \qquad
//! F_y = \int (-p \sin\alpha + q_s \cos\alpha) \, dA,
//! ```
//!
//! and the rigid slip of a body that rolls with radius `R_w` in the middle is that of its surface place by
//! place: `xi - phi y + H/R_w` along, with `H` the height of the place above the middle (Heathcote's slip), and
//! `(eta + phi x) cos(alpha) + x sin(alpha)/R_w` across (the spin of an inclined contact).
//!
//! What is left out: influence numbers that know the turn of the normals (2 to 5 % of the peak pressure at
//! half angles of 16 to 44 degrees), and that a hollow body is stiffer than a half-space and a round one softer.
//!
//! Sources: J.B. Heathcote, Proc. Inst. Automobile Eng. 15 (1921) 569-702; E. Vollebregt, G. Segal, Vehicle
//! System Dynamics 52 (2014) S455-468.

use crate::Scaling;
use crate::check::{self, InvalidValue};
use crate::coulomb::{NonHertzian, NonHertzianSolved, Resolution};
use crate::gap::{Gap, GapError, Rolling};
use crate::normal::{self, NormalContact, NormalError, Patch};
use crate::theory::{InverseError, Solved, Theory};
use crate::{Contact, Creepage, SiCreepage, SolidPair};

/// The undeformed distance along the normals of a curve across.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvedGap {
    /// Arc length (m), rising.
    s: Vec<f64>,
    /// Distance along the normal, where it is least along x (m).
    gap: Vec<f64>,
    /// Direction of the surface (rad).
    angle: Vec<f64>,
    /// Radius along x of that distance (m).
    radius: Vec<f64>,
    /// Place across and height above the middle (m).
    place: Vec<[f64; 2]>,
    /// Rolling radius in the middle (m).
    rolling: f64,
    /// Radius of the upper body across (m).
    inner: f64,
}

/// Points across by which a groove is given.
const GROOVE_POINTS: u16 = 801;
/// Largest angle of a groove (rad): beyond, a vertical approach does not close it.
const WIDEST: f64 = 1.4;
/// Angle up to which a plane gap is given (rad).
const STEEP: f64 = 1.0;

/// Error of a curved contact that was not solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CurvedError {
    /// A number out of its range.
    #[error(transparent)]
    Value(#[from] InvalidValue),
    /// The gap at an approach.
    #[error(transparent)]
    Gap(#[from] GapError),
    /// The pressure.
    #[error(transparent)]
    Normal(#[from] NormalError),
    /// No creepage gives the force.
    #[error(transparent)]
    Inverse(#[from] InverseError),
    /// The load was not met.
    #[error("the load of {load} N was not met within {steps} steps: the last was {last} N")]
    Load {
        /// The load that was wanted (N).
        load: f64,
        /// That of the last step (N).
        last: f64,
        /// How many there were.
        steps: usize,
    },
}

impl CurvedGap {
    /// A round body of radius `inner` across, `rolling` along, in a straight groove of radius `outer` (m).
    ///
    /// With `c = outer - inner` the distance is `R - c' cos(a) - sqrt(r^2 - c'^2 sin(a)^2)`,
    /// `c' = c - x^2/(2 R_w)`, here to second order in `x`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless all are finite and positive, and `inner < outer`.
    pub fn groove(inner: f64, outer: f64, rolling: f64) -> Result<Self, InvalidValue> {
        check::positive("inner", inner)?;
        check::positive("outer", outer)?;
        check::positive("rolling", rolling)?;
        check::require(
            inner < outer,
            "inner",
            inner,
            "less than outer: the body lies in the groove",
        )?;
        let clearance = outer - inner;
        let root = |sin: f64| (inner * inner - clearance * clearance * sin * sin).sqrt();
        // How the distance opens along x, over that in the middle.
        let opening = |a: f64| {
            let (sin, cos) = a.sin_cos();
            cos - clearance * sin * sin / root(sin)
        };
        // Up to where normals still meet the body, and its surface still falls away along x.
        let meets = |a: f64| clearance * a.sin() < 0.9 * inner && opening(a) > 0.1;
        let [mut widest, mut beyond] = [0.0, WIDEST];
        if meets(WIDEST) {
            widest = WIDEST;
        }
        while beyond - widest > 1e-3 * WIDEST && widest < WIDEST {
            let middle = 0.5 * (widest + beyond);
            if meets(middle) { widest = middle } else { beyond = middle }
        }
        let half = GROOVE_POINTS / 2;
        let angles =
            (0..GROOVE_POINTS).map(|i| widest * (f64::from(i) - f64::from(half)) / f64::from(half));
        // On the right wall the surface rises: it goes away from the lower body.
        let angle: Vec<f64> = angles.map(|turn| -turn).collect();
        let gap = |a: &f64| {
            let (sin, cos) = a.sin_cos();
            // R - c cos - root without cancellation: c (1 - cos) + (r - root).
            let chord = clearance * sin;
            clearance * (1.0 - cos) + chord * chord / (inner + root(sin))
        };
        let radius = |a: &f64| rolling / opening(*a);
        let gaps: Vec<f64> = angle.iter().map(gap).collect();
        Ok(Self {
            s: angle.iter().map(|a| -outer * a).collect(),
            gap: gaps,
            radius: angle.iter().map(radius).collect(),
            place: angle.iter().map(|a| [-outer * a.sin(), outer * (1.0 - a.cos())]).collect(),
            angle,
            rolling,
            inner,
        })
    }

    /// The same bodies in a plane: the undeformed distance along the middle's normal.
    ///
    /// # Errors
    /// [`GapError`] for a groove that is too wide for it.
    pub fn plane(&self) -> Result<Gap, GapError> {
        // Where the walls are steep, a distance along the middle's normal says nothing.
        let shallow =
            |k: &usize| self.angle[*k].abs() < STEEP && self.place[*k][0].abs() < 0.9 * self.inner;
        let points: Vec<usize> = (0..self.s.len()).filter(shallow).collect();
        let (y, h): (Vec<f64>, Vec<f64>) = points
            .iter()
            .map(|k| {
                let [y, height] = self.place[*k];
                // From the lower body's surface along the middle's normal to the upper's.
                let inner = self.inner;
                let above = y * y / (inner + (inner * inner - y * y).max(0.0).sqrt());
                (y, above - height)
            })
            .unzip();
        Gap::section(&y, &h, Rolling::Radius(self.rolling))
    }

    /// Direction, place across and height at an arc length: linear between points.
    fn at(&self, s: f64) -> [f64; 3] {
        let after = self.s.partition_point(|place| *place <= s).clamp(1, self.s.len() - 1);
        let (before, part) =
            (after - 1, (s - self.s[after - 1]) / (self.s[after] - self.s[after - 1]));
        let between = |one: f64, other: f64| one + part * (other - one);
        let ([y, h], [to_y, to_h]) = (self.place[before], self.place[after]);
        [between(self.angle[before], self.angle[after]), between(y, to_y), between(h, to_h)]
    }

    /// The gap that an even approach closes as this one is closed along the middle's normal.
    fn at_approach(&self, approach: f64) -> Result<Gap, GapError> {
        let away = |a: &f64| approach * (1.0 - a.cos());
        let gap: Vec<f64> =
            self.gap.iter().zip(&self.angle).map(|(gap, a)| gap + away(a)).collect();
        Gap::section(&self.s, &gap, Rolling::Varying { radius: &self.radius, locus: &[] })
    }

    /// Presses the bodies by an approach (m) along the middle's normal.
    ///
    /// # Errors
    /// [`CurvedError`] where they do not touch, or touch beyond the points of the gap.
    pub fn pressed(
        &self,
        pair: SolidPair,
        approach: f64,
        resolution: normal::Resolution,
    ) -> Result<CurvedContact, CurvedError> {
        let normal =
            NormalContact::at_approach(&self.at_approach(approach)?, pair, approach, resolution)?;
        Ok(CurvedContact { gap: self.clone(), normal })
    }

    /// Presses them by a load (N) along the middle's normal, without friction.
    ///
    /// ```
    /// use creepage::curved::CurvedGap;
    /// use creepage::{Solid, SolidPair, normal::Resolution};
    /// let body = Solid::new(80e9, 0.28)?;
    /// let groove = CurvedGap::groove(10e-3, 10.02e-3, 420e-3)?;
    /// let contact = groove.under_load(SolidPair::new(body, body), 10e3, Resolution::FAST)?;
    /// // Hertz, in a plane, has 260.6 MPa.
    /// assert!((contact.normal().peak_pressure().value / 300.9e6 - 1.0).abs() < 5e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CurvedError`], also for a load that is not positive.
    pub fn under_load(
        &self,
        pair: SolidPair,
        load: f64,
        resolution: normal::Resolution,
    ) -> Result<CurvedContact, CurvedError> {
        self.lifted(pair, load, resolution, None, |_| Ok(0.0))
    }

    /// Presses them until pressure and what else carries, `lift` (N), are the load; from an approach, if one
    /// is known.
    fn lifted(
        &self,
        pair: SolidPair,
        load: f64,
        resolution: normal::Resolution,
        start: Option<f64>,
        lift: impl Fn(&CurvedContact) -> Result<f64, CurvedError>,
    ) -> Result<CurvedContact, CurvedError> {
        check::positive("load", load)?;
        let usual = || -> Result<f64, CurvedError> {
            // That without the turn of the normals is a start; else Hertz's of two round bodies.
            let plane = NormalContact::under_load(&self.at_approach(0.0)?, pair, load, resolution);
            let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
            let round = 0.75 * load / (modulus * (self.inner * self.rolling).powf(0.25));
            Ok(plane.map_or_else(|_| round.powf(2.0 / 3.0), |plane| plane.approach().value))
        };
        let mut approach = start.map_or_else(usual, Ok)?;
        let mut last = f64::NAN;
        let mut before: Option<[f64; 2]> = None;
        for _ in 0..MAX_LOAD_STEPS {
            let contact = self.pressed(pair, approach, resolution)?;
            let carried = contact.vertical() + lift(&contact)?;
            if (carried / load - 1.0).abs() < LOAD_TOLERANCE {
                return Ok(contact);
            }
            last = carried;
            // A secant through the last two, in powers of the load: the first step by Hertz's 3/2.
            let slope = before.map(|[a, c]| (carried / c).ln() / (approach / a).ln());
            let power = slope.filter(|slope| (0.5..3.0).contains(slope)).unwrap_or(1.5);
            before = Some([approach, carried]);
            approach *= (load / carried.max(0.1 * load)).powf(1.0 / power).clamp(0.5, 2.0);
        }
        Err(CurvedError::Load { load, last, steps: MAX_LOAD_STEPS })
    }
}

/// How nearly a load is met, and in how many steps.
const LOAD_TOLERANCE: f64 = 1e-5;
const MAX_LOAD_STEPS: usize = 40;

/// Bodies pressed on a curved contact.
#[derive(Debug, Clone)]
pub struct CurvedContact {
    gap: CurvedGap,
    normal: NormalContact,
}

impl CurvedContact {
    /// Pressure and areas over `x` and the arc length; its load is the sum of all pressure along the normals.
    #[must_use]
    pub fn normal(&self) -> &NormalContact {
        &self.normal
    }

    /// The approach along the middle's normal (m).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.normal.approach().value
    }

    /// Force of the pressure along the middle's normal (N).
    #[must_use]
    pub fn vertical(&self) -> f64 {
        self.over_rows(f64::cos)
    }

    /// Force of the pressure on the lower body across (N).
    #[must_use]
    pub fn lateral(&self) -> f64 {
        -self.over_rows(f64::sin)
    }

    /// By how much the surface turns from one side of the areas to the other (rad).
    #[must_use]
    pub fn turn(&self) -> f64 {
        let ends = self.normal.patches().iter().flat_map(|patch| patch.extent().y);
        let angles = ends.map(|s| self.gap.at(s)[0]);
        let [low, high] = angles.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], angle| {
            [low.min(angle), high.max(angle)]
        });
        (high - low).max(0.0)
    }

    /// The pressure times a function of the surface's direction, over all rows.
    fn over_rows(&self, weight: impl Fn(f64) -> f64) -> f64 {
        const ROWS: u16 = 64;
        let bands = self.normal.patches().iter().flat_map(Patch::bands);
        bands
            .map(|band| {
                let [low, high] = band.y();
                let at = |j: u16| low + (high - low) * f64::from(j) / f64::from(ROWS);
                let row = |j: u16| {
                    let moments = band.moments([at(j), at(j + 1)], [-1.0, 1.0]);
                    if moments.force > 0.0 {
                        moments.force * weight(self.gap.at(moments.by_y / moments.force)[0])
                    } else {
                        0.0
                    }
                };
                (0..ROWS).map(row).sum::<f64>()
            })
            .sum()
    }

    /// The full theory for rolling on it.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn rolling(
        &self,
        friction: f64,
        resolution: Resolution,
    ) -> Result<CurvedRolling, InvalidValue> {
        let theory = NonHertzian::new(&self.normal, friction, resolution)?;
        Ok(CurvedRolling { gap: self.gap.clone(), theory })
    }
}

/// Rolling on a curved contact, by the full theory.
#[derive(Debug, Clone)]
pub struct CurvedRolling {
    gap: CurvedGap,
    theory: NonHertzian,
}

impl Theory for CurvedRolling {
    fn contact(&self) -> &Contact {
        self.theory.contact()
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Box::new(self.solve_in(creepage, self.theory.scaling()))
    }
}

/// Forces of a curved contact on the lower body, in the axes of its middle (N).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CurvedForce {
    /// Of the tractions, along the rolling direction.
    pub longitudinal: f64,
    /// Of the tractions across.
    pub lateral: f64,
    /// Of the tractions along the middle's normal, into the lower body.
    pub vertical: f64,
}

impl CurvedRolling {
    /// The full theory of the areas, whose units are those of the slip.
    #[must_use]
    pub fn theory(&self) -> &NonHertzian {
        &self.theory
    }

    /// Slip over the rolling velocity at `(x, s)` (m) beyond creepage and spin in the plane of arc length.
    fn more(&self, creepage: SiCreepage, [x, s]: [f64; 2]) -> [f64; 2] {
        let [angle, y, height] = self.gap.at(s);
        let (sin, cos) = angle.sin_cos();
        let along = height / self.gap.rolling - creepage.spin * (y - s);
        let across = (creepage.lateral + creepage.spin * x) * (cos - 1.0);
        [along, across + x * sin / self.gap.rolling]
    }

    /// Solves for creepage and spin of the middle.
    ///
    /// # Errors
    /// [`InvalidValue`] for creepages that are not finite.
    pub fn solve(&self, creepage: SiCreepage) -> Result<NonHertzianSolved<'_>, InvalidValue> {
        let scaling = self.theory.scaling();
        let dimensionless = scaling.creepage(creepage)?;
        Ok(self.solve_in(dimensionless, scaling))
    }

    fn solve_in(&self, creepage: Creepage, scaling: Scaling) -> NonHertzianSolved<'_> {
        let si = scaling.si_creepage(creepage);
        self.theory.solve_curved(creepage, |at| {
            self.more(si, at.map(|at| at * scaling.length)).map(|slip| slip / scaling.slip)
        })
    }

    /// Forces of the tractions of a solution.
    #[must_use]
    pub fn force(&self, solved: &NonHertzianSolved<'_>) -> CurvedForce {
        let scaling = self.theory.scaling();
        let mut sum = CurvedForce::default();
        for element in solved.elements() {
            let [p, q, r, s] = element.corners;
            let cross = (r[0] - p[0]) * (s[1] - q[1]) - (s[0] - q[0]) * (r[1] - p[1]);
            let area = 0.5 * cross.abs() * scaling.length * scaling.length;
            let [x, y] = element.point.traction.map(|traction| area * traction * scaling.traction);
            let (sin, cos) = self.gap.at(element.point.position[1] * scaling.length)[0].sin_cos();
            sum.longitudinal += x;
            sum.lateral += y * cos;
            sum.vertical += y * sin;
        }
        sum
    }

    /// The longitudinal creepage at which a wanted force (N) along the rolling direction is met, with the
    /// solution there; lateral creepage and spin stay.
    ///
    /// # Errors
    /// [`InverseError`] where no creepage gives it.
    pub fn find(
        &self,
        wanted: f64,
        given: SiCreepage,
    ) -> Result<(SiCreepage, NonHertzianSolved<'_>), CurvedError> {
        let scaling = self.theory.scaling();
        let at = |longitudinal: f64| -> Result<_, CurvedError> {
            let creepage = SiCreepage { longitudinal, ..given };
            let solved = self.solve(creepage)?;
            let missing = scaling.si_force(solved.solution().force).longitudinal - wanted;
            Ok((creepage, solved, missing))
        };
        let unit = scaling.slip;
        let (mut low, mut high) = (given.longitudinal - unit, given.longitudinal + unit);
        let reach = 2.0_f64.powi(20) * unit;
        while at(low)?.2 > 0.0 {
            low = 2.0 * low - high;
            check::require(
                low > -reach,
                "longitudinal force",
                wanted,
                "within what friction bears",
            )?;
        }
        while at(high)?.2 < 0.0 {
            high = 2.0 * high - low;
            check::require(
                high < reach,
                "longitudinal force",
                wanted,
                "within what friction bears",
            )?;
        }
        // Regula falsi with the Illinois rule.
        let (mut of_low, mut of_high) = (at(low)?.2, at(high)?.2);
        for _ in 0..MAX_LOAD_STEPS {
            let middle = if of_high - of_low > 0.0 {
                (low * of_high - high * of_low) / (of_high - of_low)
            } else {
                0.5 * (low + high)
            };
            let (creepage, solved, missing) = at(middle)?;
            if missing.abs() < 1e-5 * scaling.force || high - low < 1e-9 * unit {
                return Ok((creepage, solved));
            }
            if missing > 0.0 {
                (high, of_high) = (middle, missing);
                of_low *= 0.5;
            } else {
                (low, of_low) = (middle, missing);
                of_high *= 0.5;
            }
        }
        let (creepage, solved, _) = at(0.5 * (low + high))?;
        Ok((creepage, solved))
    }
}

impl CurvedGap {
    /// Presses and rolls the bodies until pressure and friction together carry a load (N) along the middle's
    /// normal, at a given creepage, or, with `longitudinal_force` (N), at the creepage that gives that.
    /// Gives the contact, rolling on it, and the creepage.
    ///
    /// # Errors
    /// [`CurvedError`].
    pub fn rolled(
        &self,
        pair: SolidPair,
        load: f64,
        friction: f64,
        creepage: SiCreepage,
        longitudinal_force: Option<f64>,
        (press, roll): (normal::Resolution, Resolution),
    ) -> Result<(CurvedContact, CurvedRolling, SiCreepage), CurvedError> {
        let at = |contact: &CurvedContact| -> Result<_, CurvedError> {
            let rolling = contact.rolling(friction, roll)?;
            let (creepage, force) = match longitudinal_force {
                None => (creepage, rolling.force(&rolling.solve(creepage)?)),
                Some(wanted) => {
                    let (creepage, solved) = rolling.find(wanted, creepage)?;
                    (creepage, rolling.force(&solved))
                }
            };
            Ok((rolling, creepage, force))
        };
        let unrubbed = self.under_load(pair, load, press)?;
        let start = Some(unrubbed.approach());
        let contact =
            self.lifted(pair, load, press, start, |contact| Ok(at(contact)?.2.vertical))?;
        let (rolling, creepage, _) = at(&contact)?;
        Ok((contact, rolling, creepage))
    }
}
