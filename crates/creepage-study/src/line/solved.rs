//! Solved line contact: edges, pressure, traction, force and creepage.

use creepage::approximate::carter::Carter;
use creepage::coulomb::{Cylinders, CylindersSolved};
use creepage::viscoelastic::{ViscoelasticCylinders, ViscoelasticRolling};
use creepage::{SiCreepage, Status};

use super::file::{Given, LineCase, LineTheory};
use crate::{CaseError, Caution};

/// Points from edge to edge of closed forms, closer towards the edges.
const PROFILE_POINTS: u16 = 201;
/// A force below this part of `mu N` is what the search for the creepage of free rolling leaves: zero.
const ZERO: f64 = 2e-9;
/// `kappa/mu` from which on leaving it out is worth a caution.
const UNLIKE: f64 = 0.01;

/// A line contact with its solution; forces and energies are per length of the cylinders.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedLine {
    /// The case.
    pub case: LineCase,
    /// Whether it converged.
    pub status: Status,
    /// Longitudinal creepage of the upper body against the lower.
    pub creepage: f64,
    /// Longitudinal force on the lower body (N/m).
    pub force: f64,
    /// Trailing and leading edge (m), from the line of the centres.
    pub edges: [f64; 2],
    /// The largest pressure (Pa) and its place (m).
    pub peak: [f64; 2],
    /// Part of the width that adheres.
    pub adhesion_share: f64,
    /// Energy that friction turns to heat per metre rolled (J/m2).
    pub friction_heat: f64,
    /// How far the centre of pressure lies ahead of the line of the centres (m).
    pub pressure_centre: f64,
    /// Force against which viscoelastic cylinders roll (N/m), also the energy lost in them per metre rolled (J/m2).
    pub rolling_resistance: Option<f64>,
    /// From the trailing edge to the leading one.
    pub points: Vec<LinePoint>,
    /// Cautions about it.
    pub cautions: Vec<Caution>,
}

/// A place in a line contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePoint {
    /// Along the rolling direction (m).
    pub x: f64,
    /// Pressure (Pa).
    pub pressure: f64,
    /// Traction on the lower body (Pa).
    pub traction: f64,
    /// Whether the surfaces adhere.
    pub adheres: bool,
}

impl LineCase {
    /// Solves it.
    ///
    /// ```
    /// use creepage_study::LineFile;
    /// let text = "
    /// upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46 }
    /// lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat' }
    /// contact = { line_load = 2e6, friction = 0.3 }
    /// wanted = { fx = 0.75 }
    /// ";
    /// let solved = LineFile::read(text)?.case()?.solve()?;
    /// // Carter: three quarters of mu N at half of the creepage of full sliding.
    /// assert!((solved.force - 0.45e6).abs() < 1.0 && (solved.adhesion_share - 0.5).abs() < 1e-12);
    /// # Ok::<(), creepage_study::CaseError>(())
    /// ```
    ///
    /// # Errors
    /// [`CaseError`] for numbers beyond the theory's range.
    pub fn solve(&self) -> Result<SolvedLine, CaseError> {
        let solved = match self.relaxation {
            Some(relaxation) => {
                let (modulus, poisson) = (self.pair.shear_modulus(), self.pair.poisson());
                let speed = self.speed.unwrap_or(f64::NAN);
                let cylinders =
                    ViscoelasticCylinders::new(modulus, poisson, relaxation, self.radius, speed)
                        .map_err(CaseError::invalid("relaxation"))?;
                self.viscoelastic(&cylinders)?
            }
            None if self.theory == LineTheory::Carter || self.kappa_over_mu() == 0.0 => {
                self.carter()?
            }
            None => self.unlike()?,
        };
        let si = SiCreepage { longitudinal: solved.creepage, lateral: 0.0, spin: 0.0 };
        let mut cautions = self.cautions.clone();
        if solved.status != Status::Solved {
            cautions.push(Caution::Status(solved.status));
        }
        cautions.extend(Caution::large_friction(self.friction));
        let kappa_over_mu = self.kappa_over_mu();
        if self.theory == LineTheory::Carter && kappa_over_mu.abs() >= UNLIKE {
            cautions.push(Caution::dissimilar_on_line(kappa_over_mu));
        }
        cautions.extend(Caution::large_creepage(si));
        cautions.extend(Caution::yields(solved.peak[0], self.pair.shear_modulus(), None));
        Ok(SolvedLine { cautions, ..solved })
    }

    fn kappa_over_mu(&self) -> f64 {
        self.pair.kappa() / self.friction
    }

    /// Creepage over its unit `mu a / rho`.
    fn unit(&self) -> f64 {
        self.friction * self.line.half_width() / self.line.rho()
    }

    /// Like elastic bodies, in closed form.
    fn carter(&self) -> Result<SolvedLine, CaseError> {
        let half = self.line.half_width();
        let most = self.friction * self.load;
        let xi = match self.given {
            Given::Creepage(creepage) => creepage / self.unit(),
            // f = xi (8 - |xi|)/16.
            Given::Force(force) => {
                let part = (force / most).abs();
                // Without cancellation at small forces.
                (4.0 * part / (1.0 + (1.0 - part).sqrt())).copysign(force)
            }
        };
        let carter = Carter::new(xi).map_err(CaseError::invalid("creepage"))?;
        let (creepage, force) = (xi * self.unit(), carter.force() * most);
        let largest = self.line.peak_pressure();
        let points = places(&even([-half, half]), |x| {
            let field = carter.at(x / half);
            let pressure = largest * ((1.0 - x / half) * (1.0 + x / half)).max(0.0).sqrt();
            let traction = self.friction * largest * field.traction[0];
            (pressure, traction, field.region == creepage::Region::Adhesion)
        });
        Ok(SolvedLine {
            status: Status::Solved,
            creepage,
            force,
            edges: [-half, half],
            peak: [largest, 0.0],
            adhesion_share: carter.adhesion_half_width(),
            friction_heat: force * creepage,
            pressure_centre: 0.0,
            rolling_resistance: None,
            points,
            ..self.empty()
        })
    }

    /// Unlike elastic bodies.
    fn unlike(&self) -> Result<SolvedLine, CaseError> {
        let cylinders =
            Cylinders::new(self.pair, self.friction).map_err(CaseError::invalid("contact"))?;
        let solved: CylindersSolved = match self.given {
            Given::Creepage(creepage) => {
                cylinders.solve(creepage / self.unit()).map_err(CaseError::invalid("creepage"))?
            }
            Given::Force(force) => cylinders
                .find(force / (self.friction * self.load))
                .map_err(CaseError::invalid("wanted"))?,
        };
        let (half, largest) = (self.line.half_width(), self.line.peak_pressure());
        let edges = solved.ends().map(|end| half * end);
        let middles = solved.middles().into_iter().map(|x| half * x);
        let [first, last] = edges;
        let elements: Vec<f64> = [first].into_iter().chain(middles).chain([last]).collect();
        let points = places(&elements, |x| {
            let (pressure, traction) = (solved.pressure(x / half), solved.traction(x / half));
            let adheres = traction.abs() < (1.0 - 1e-6) * pressure;
            (largest * pressure, self.friction * largest * traction, adheres)
        });
        let (creepage, used) = (solved.creepage() * self.unit(), solved.force());
        Ok(SolvedLine {
            status: solved.status(),
            creepage,
            force: if used.abs() < ZERO { 0.0 } else { used * self.friction * self.load },
            edges,
            peak: highest(&points),
            adhesion_share: solved.adhesion(),
            friction_heat: solved.dissipation() * self.friction * self.load * self.unit(),
            pressure_centre: centre(&points, self.load),
            rolling_resistance: None,
            points,
            ..self.empty()
        })
    }

    fn viscoelastic(&self, cylinders: &ViscoelasticCylinders) -> Result<SolvedLine, CaseError> {
        let wrong = |source| CaseError::Viscoelastic { source };
        let rolling: ViscoelasticRolling = match self.given {
            Given::Creepage(creepage) => {
                cylinders.rolling_at(self.load, self.friction, creepage).map_err(wrong)?
            }
            Given::Force(force) => {
                cylinders.rolling_under(self.load, self.friction, force).map_err(wrong)?
            }
        };
        let pressed = rolling.pressure();
        let edges = pressed.ends();
        let edge = rolling.adhesion_edge().unwrap_or(edges[1]);
        let points = places(&even(edges), |x| (pressed.at(x), rolling.traction(x), x > edge));
        let (creepage, force) = (rolling.creepage(), rolling.force());
        Ok(SolvedLine {
            status: Status::Solved,
            creepage,
            force,
            edges,
            peak: pressed.largest(),
            adhesion_share: (edges[1] - edge) / (edges[1] - edges[0]),
            friction_heat: force * creepage,
            pressure_centre: pressed.centre(),
            rolling_resistance: Some(pressed.rolling_resistance()),
            points,
            ..self.empty()
        })
    }

    fn empty(&self) -> SolvedLine {
        SolvedLine {
            case: self.clone(),
            status: Status::NotConverged,
            creepage: f64::NAN,
            force: f64::NAN,
            edges: [f64::NAN; 2],
            peak: [f64::NAN; 2],
            adhesion_share: f64::NAN,
            friction_heat: f64::NAN,
            pressure_centre: f64::NAN,
            rolling_resistance: None,
            points: Vec::new(),
            cautions: Vec::new(),
        }
    }
}

/// Places from edge to edge at even angles.
fn even([from, to]: [f64; 2]) -> Vec<f64> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let angle = |k: u16| std::f64::consts::PI * f64::from(k) / f64::from(PROFILE_POINTS - 1);
    (0..PROFILE_POINTS).map(|k| middle - half * angle(k).cos()).collect()
}

/// Pressure, traction, and whether surfaces adhere, at these places.
fn places(places: &[f64], at: impl Fn(f64) -> (f64, f64, bool)) -> Vec<LinePoint> {
    let point = |x: &f64| {
        let (pressure, traction, adheres) = at(*x);
        LinePoint { x: *x, pressure, traction, adheres }
    };
    places.iter().map(point).collect()
}

fn highest(points: &[LinePoint]) -> [f64; 2] {
    let best = points.iter().max_by(|a, b| a.pressure.total_cmp(&b.pressure));
    best.map_or([f64::NAN; 2], |point| [point.pressure, point.x])
}

/// Of the pressure, by the trapezoid rule.
fn centre(points: &[LinePoint], load: f64) -> f64 {
    let parts = points.windows(2).map(|pair| {
        let moment = |point: &LinePoint| point.pressure * point.x;
        0.5 * (moment(&pair[0]) + moment(&pair[1])) * (pair[1].x - pair[0].x)
    });
    parts.sum::<f64>() / load
}
