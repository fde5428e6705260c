//! The full theory on contact areas of any shape.

use super::bands::{Bands, Frame};
use super::extrapolation::{error_bar, extrapolate_force};
use super::grid::Grid;
use super::influence::Influence;
use super::resolution::Resolution;
use super::stencil::SlipStencil;
use super::workspace::{Pool, Workspace};
use crate::check::{self, InvalidValue};
use crate::normal::NormalContact;
use crate::theory::{Region, Statistics, Status};
use crate::{Creepage, Force, SiCreepage, SiForce};

/// Unit of slip over the largest traction bound in units of `G`: the elastic slip is of order one.
const SLIP_UNIT: f64 = 0.5;

/// The full theory of steady rolling, prepared for a contact of any shape: one or more areas, all
/// in one half-space.
///
/// Creepages are those of (4.15) at the origin of coordinates of the gap; positive `x` is the
/// rolling direction. Forces are of the upper body on the lower. Like bodies: between dissimilar
/// ones the slip by the pressure (6.4) is neglected.
///
/// ```
/// use creepage::coulomb::{NonHertzian, Resolution};
/// use creepage::gap::{Gap, Term};
/// use creepage::normal::{self, NormalContact};
/// use creepage::{SiCreepage, Solid, SolidPair};
/// // A crowned roller: h = x^2/920 + y^4/20000 in millimetres.
/// let term = |x, y, coefficient| Term { x, y, coefficient };
/// let gap = Gap::polynomial(&[term(2, 0, 1e3 / 920.0), term(0, 4, 1e9 / 20_000.0)])?;
/// let steel = Solid::new(82e9, 0.28)?;
/// let pair = SolidPair::new(steel, steel);
/// let contact = NormalContact::under_load(&gap, pair, 40e3, normal::Resolution::STANDARD)?;
/// let theory = NonHertzian::new(&contact, 0.3, Resolution::FAST)?;
/// let solved = theory.solve(SiCreepage { longitudinal: 1e-3, ..SiCreepage::default() });
/// assert!(solved.force().longitudinal > 5e3 && solved.force().longitudinal < 12e3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct NonHertzian {
    grids: [Grid; 2],
    pool: Pool,
    units: Units,
}

/// What the dimensionless quantities of the grids are multiples of.
#[derive(Debug, Clone, Copy)]
struct Units {
    frame: Frame,
    /// Slip over the rolling velocity.
    slip: f64,
    /// `mu N`.
    force: f64,
    /// Largest traction bound (Pa).
    traction: f64,
}

impl Units {
    /// Creepage and spin about the frame's origin.
    fn creepage(&self, creepage: SiCreepage) -> Creepage {
        let SiCreepage { longitudinal, lateral, spin } = creepage;
        let [x, y] = self.frame.origin;
        Creepage {
            xi: (longitudinal - spin * y) / self.slip,
            eta: (lateral + spin * x) / self.slip,
            chi: spin * self.frame.length / self.slip,
        }
    }

    /// Force and moment about a point (m).
    fn force(&self, Force { fx, fy, mz }: Force, about: [f64; 2]) -> SiForce {
        let [x, y] = self.frame.inward(about);
        SiForce {
            longitudinal: self.force * fx,
            lateral: self.force * fy,
            moment: self.force * self.frame.length * (mz - x * fy + y * fx),
        }
    }

    /// Error bars of [`Units::force`].
    fn error(&self, Force { fx, fy, mz }: Force, about: [f64; 2]) -> SiForce {
        let [x, y] = self.frame.inward(about);
        SiForce {
            longitudinal: self.force * fx,
            lateral: self.force * fy,
            moment: self.force * self.frame.length * (mz + x.abs() * fy + y.abs() * fx),
        }
    }
}

impl NonHertzian {
    /// Prepares for a solved normal contact and a coefficient of friction.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn new(
        contact: &NormalContact,
        friction: f64,
        resolution: Resolution,
    ) -> Result<Self, InvalidValue> {
        check::positive("friction", friction)?;
        let frame = Frame { origin: contact.centroid(), length: (contact.area().value / 3.0).sqrt() };
        let bands = Bands::new(contact, frame, resolution);
        let poisson = contact.pair().poisson();
        let grids = [1, 2].map(|times| {
            let mesh = bands.mesh(times);
            let pressure = bands.pressure(&mesh);
            let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
            let influence = Influence::with_far_field(&mesh, poisson, &stencils);
            Grid::new(mesh, pressure, influence, SLIP_UNIT, &stencils)
        });
        let traction = friction * contact.peak_pressure().value;
        let units = Units {
            frame,
            slip: SLIP_UNIT * traction / contact.pair().shear_modulus(),
            force: friction * contact.load().value,
            traction,
        };
        Ok(Self { grids, pool: Pool::default(), units })
    }

    /// Solves for creepage and spin.
    #[must_use]
    pub fn solve(&self, creepage: SiCreepage) -> NonHertzianSolved<'_> {
        self.solve_curved(creepage, |_| [0.0; 2])
    }

    /// Solves for creepage and spin, to which `more` adds creepages `[longitudinal, lateral]` that
    /// vary with `y` (m): on curved contact areas the rolling radius, and the direction of the
    /// tangent plane, are not the same everywhere.
    #[must_use]
    pub fn solve_curved(
        &self,
        creepage: SiCreepage,
        more: impl Fn(f64) -> [f64; 2],
    ) -> NonHertzianSolved<'_> {
        let mut workspace = self.pool.take(&self.grids);
        let rigid = self.units.creepage(creepage);
        workspace.solve(&self.grids, false, |grid, forcing| {
            grid.set_forcing(rigid, 0.0, forcing);
            for (slip, place) in forcing.slip.iter_mut().zip(&grid.places) {
                let more = more(self.units.frame.outward(*place)[1]);
                *slip = [0, 1].map(|k| slip[k] + more[k] / self.units.slip);
            }
        });
        NonHertzianSolved { theory: self, workspace }
    }

    /// Elements on the finer grid.
    #[must_use]
    pub fn elements(&self) -> usize {
        self.grids[1].mesh.len()
    }
}

/// What happens in one element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SiElement {
    /// Centroid of the pressure (m).
    pub position: [f64; 2],
    /// Mean traction on the lower body (Pa).
    pub traction: [f64; 2],
    /// Mean of the traction bound `mu Z` (Pa).
    pub bound: f64,
    /// Slip of the upper body relative to the lower over the rolling velocity.
    pub slip: [f64; 2],
    /// Stick or slip.
    pub region: Region,
    /// Normal force that it carries (N) over that of the whole contact.
    pub share: f64,
    /// Corners of the element, all around (m).
    pub corners: [[f64; 2]; 4],
}

/// One contact of any shape solved; made by [`NonHertzian::solve`].
#[derive(Debug)]
pub struct NonHertzianSolved<'a> {
    theory: &'a NonHertzian,
    workspace: Workspace,
}

impl NonHertzianSolved<'_> {
    /// Force, and moment about the origin of coordinates, of the upper body on the lower.
    #[must_use]
    pub fn force(&self) -> SiForce {
        self.force_about([0.0; 2])
    }

    /// Force, and moment about a point (m).
    #[must_use]
    pub fn force_about(&self, point: [f64; 2]) -> SiForce {
        let [coarse, fine] = self.workspace.sums(&self.theory.grids, 0.0);
        self.theory.units.force(extrapolate_force(coarse.force, fine.force), point)
    }

    /// Error bars of [`NonHertzianSolved::force_about`], by the discretization of the tractions.
    #[must_use]
    pub fn error_about(&self, point: [f64; 2]) -> SiForce {
        let [coarse, fine] = self.workspace.sums(&self.theory.grids, 0.0);
        self.theory.units.error(error_bar(coarse.force, fine.force, self.theory.elements()), point)
    }

    /// Whether the iteration met its tolerance.
    #[must_use]
    pub fn status(&self) -> Status {
        self.workspace.solution(Force::default(), Force::default()).status
    }

    /// What it cost.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.workspace.solution(Force::default(), Force::default()).statistics
    }

    /// Derivative of force and moment about the origin of coordinates: rows longitudinal, lateral,
    /// moment; columns by longitudinal and lateral creepage and spin.
    #[must_use]
    pub fn jacobian(&mut self) -> [[f64; 3]; 3] {
        let units = self.theory.units;
        let columns = self.workspace.derivative(&self.theory.grids);
        let directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let by = directions.map(|[longitudinal, lateral, spin]| {
            let weights = units.creepage(SiCreepage { longitudinal, lateral, spin }).components();
            let sum = |k: fn(&Force) -> f64| {
                columns.iter().zip(weights).map(|(column, weight)| weight * k(column)).sum()
            };
            let force = Force { fx: sum(|f| f.fx), fy: sum(|f| f.fy), mz: sum(|f| f.mz) };
            let force = units.force(force, [0.0; 2]);
            [force.longitudinal, force.lateral, force.moment]
        });
        std::array::from_fn(|i| std::array::from_fn(|k| by[k][i]))
    }

    /// The elements of the finer grid, strip by strip, each from the leading edge.
    #[must_use]
    pub fn elements(&self) -> Vec<SiElement> {
        let grid = &self.theory.grids[1];
        grid.mesh.all().enumerate().map(|(element, place)| self.element(element, place)).collect()
    }

    fn element(&self, element: usize, (strip, i): (usize, usize)) -> SiElement {
        let (grid, state) = (&self.theory.grids[1], self.workspace.fine());
        let Units { frame, slip, traction, .. } = self.theory.units;
        let (slides, bound) = (state.slides(element), traction * grid.pressure.bounds[element]);
        SiElement {
            position: frame.outward(grid.pressure.centroids[element]),
            traction: state.traction.at(element).map(|t| bound * t),
            bound,
            slip: if slides { state.slip(element).map(|s| slip * s) } else { [0.0; 2] },
            region: if slides { Region::Slip } else { Region::Adhesion },
            share: grid.pressure.shares[element],
            corners: grid.mesh.strips[strip].corners(i).map(|corner| frame.outward(corner)),
        }
    }
}

impl Drop for NonHertzianSolved<'_> {
    fn drop(&mut self) {
        self.theory.pool.give_back(std::mem::take(&mut self.workspace));
    }
}
