//! Transient line contact of two cylinders with parallel axes, Carter's contact: one strip of elements as long as the
//! cylinders, its displacements taken in the middle.
//!
//! How far two bodies are shifted by a force along a line depends on its length, by a logarithm: so
//! do forces while they change at a prescribed creepage, until they are steady, and creepages at a
//! prescribed force do not.

use super::elements::{Elements, Surface};
use super::rolling::{Rolling, remembered};
use crate::check::{self, InvalidValue};
use crate::coulomb::grid::Grid;
use crate::coulomb::mesh::{Mesh, Strip};
use crate::coulomb::pressure::Pressure;
use crate::coulomb::stencil::SlipStencil;
use crate::coulomb::subdivision::{Pieces, SUBCELLS};
use crate::friction_law::RollingFriction;
use crate::layer::Layer;
use crate::{Ellipse, Scaling};

/// Elements of the coarser grid.
const ELEMENTS: usize = 50;
/// An ellipse so many times wider than the line is long has its pressure, to 1e-6.
const WIDER: f64 = 1e3;

impl Rolling {
    /// A line contact whose length is `length` times its half-width `a`, between bodies of combined
    /// Poisson's ratio `poisson`.
    ///
    /// The unit of length is `a`, that of creepage `mu a / rho` with `1/rho = (1/R+ + 1/R-)/4`, as in
    /// [`Carter`](crate::approximate::carter::Carter); that of force `mu N`, `N` over the whole length.
    /// There is no spin in it.
    ///
    /// ```
    /// use creepage::approximate::carter::Carter;
    /// use creepage::unsteady::{Motion, Rolling};
    /// let mut rolling = Rolling::line(1000.0, 0.28)?;
    /// rolling.shift(0.5, 0.0)?;
    /// let end = rolling.step(8.0, &Motion::forces(0.5, 0.0))?;
    /// assert!((Carter::new(end.creepage.xi())?.force() - 0.5).abs() < 2e-3);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidValue`] unless `length` lies between 10 and 1e6 and `poisson` between 0 and 0.5.
    pub fn line(length: f64, poisson: f64) -> Result<Self, InvalidValue> {
        Self::line_of(length, poisson, |elements| elements)
    }

    /// The same with friction that depends on the slip, in the units `scaling`.
    ///
    /// # Errors
    /// As [`Rolling::line`], and for falling friction without a memory.
    pub fn line_with_friction(
        length: f64,
        poisson: f64,
        friction: RollingFriction,
        scaling: Scaling,
    ) -> Result<Self, InvalidValue> {
        Self::line_with_surface(length, poisson, (Some(friction), None), scaling)
    }

    /// The same with friction that depends on the slip, with a layer between the cylinders, whose plastic
    /// displacement moves with the particles, or with both, in the units `scaling`.
    ///
    /// ```
    /// use creepage::approximate::carter::LineContact;
    /// use creepage::unsteady::{Motion, Rolling};
    /// use creepage::{Layer, Plasticity, Scaling, Solid, SolidPair};
    /// let steel = Solid::new(82e9, 0.28)?;
    /// let line = LineContact::new(SolidPair::new(steel, steel), [0.5, f64::INFINITY], 358e3)?;
    /// let (length, friction) = (line.half_width(), 0.3);
    /// let scaling = Scaling {
    ///     length,
    ///     slip: friction * length / line.rho(),
    ///     force: friction * 358e3,
    ///     traction: friction * line.peak_pressure(),
    /// };
    /// // No elastic shear, a third of what friction bears in the middle.
    /// let soft = Plasticity { yield_stress: scaling.traction / 3.0, slope: 0.0 };
    /// let layer = Layer::elastic(0.0, 1e9)?.with_plasticity(soft)?;
    /// let mut rolling = Rolling::line_with_surface(1000.0, 0.28, (None, Some(layer)), scaling)?;
    /// let motion = Motion::from(scaling.creepage(creepage::SiCreepage { longitudinal: 0.02, ..Default::default() })?);
    /// // The layer bears less than friction everywhere but near the edges.
    /// let force = rolling.step(4.0, &motion)?.solution.force.fx;
    /// assert!(force > 0.4 && force < 0.42, "{force}");
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    ///
    /// # Errors
    /// As [`Rolling::line`], and for falling friction without a memory.
    pub fn line_with_surface(
        length: f64,
        poisson: f64,
        (friction, layer): (Option<RollingFriction>, Option<Layer>),
        scaling: Scaling,
    ) -> Result<Self, InvalidValue> {
        if let Some(friction) = friction {
            remembered(friction)?;
        }
        let surface = Surface { friction, layer };
        Self::line_of(length, poisson, |elements| elements.with_surface(&surface, scaling))
    }

    fn line_of(
        length: f64,
        poisson: f64,
        with: impl Fn(Elements) -> Elements,
    ) -> Result<Self, InvalidValue> {
        let valid = "between 10 and 1e6 half-widths";
        check::require((10.0..=1e6).contains(&length), "length", length, valid)?;
        check::poisson(poisson)?;
        let pressed = Ellipse::new(1.0, (WIDER * length).min(1e6))?;
        Ok(Self::of([1, 2].map(|k| with(elements(pressed, length, poisson, k * ELEMENTS)))))
    }
}

fn elements(pressed: Ellipse, length: f64, poisson: f64, count: usize) -> Elements {
    let across = |k: usize| length * (k as f64 / SUBCELLS as f64 - 0.5);
    let strip = Strip {
        across: std::array::from_fn(across),
        middle: [0.0; 2],
        half_length: [1.0; 2],
        along: Pieces::of_equal_angles(count),
        patch: 0..1,
    };
    let mesh = Mesh::new(vec![strip]);
    let mut pressure = Pressure::hertz(pressed, &mesh);
    pressure.scale(pressure.shares.iter().sum::<f64>().recip(), 1.0);
    let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
    // (1.2): the unit of slip mu a / rho over the largest traction mu p0, in units of G.
    let slip_unit = 0.5 * (1.0 - poisson);
    let grid = Grid::new(mesh, pressure, poisson, slip_unit, &stencils);
    Elements::new(grid, poisson, slip_unit, [1.0, f64::INFINITY])
}
