//! Transient rolling of contact areas of any shape that keep their shape.

use super::elements::{Elements, Surface};
use super::rolling::{Rolling, remembered};
use crate::check::InvalidValue;
use crate::coulomb::Resolution;
use crate::coulomb::patch_mesh::{Bands, Frame};
use crate::friction_law::RollingFriction;
use crate::layer::Layer;
use crate::normal::{NormalContact, SLIP_UNIT};

impl Rolling {
    /// One or more contact areas of any shape, pressed together for good, with a coefficient of
    /// friction and how it depends on the slip or the place, if it does.
    ///
    /// Units are those of [`NormalContact::scaling`]; the origin of coordinates, of the spin and of the
    /// moment is that of the gap. Like bodies, as [`NonHertzian`](crate::coulomb::NonHertzian), and the
    /// same when rolling has become steady.
    ///
    /// ```
    /// use creepage::coulomb;
    /// use creepage::gap::{Gap, Term};
    /// use creepage::normal::{NormalContact, Resolution};
    /// use creepage::unsteady::{Motion, Rolling};
    /// use creepage::{Creepage, Solid, SolidPair};
    /// // A crowned roller: h = x^2/920 + y^4/20000 in millimetres.
    /// let term = |x, y, coefficient| Term { x, y, coefficient };
    /// let gap = Gap::polynomial(&[term(2, 0, 1e3 / 920.0), term(0, 4, 1e9 / 20_000.0)])?;
    /// let steel = Solid::new(82e9, 0.28)?;
    /// let pair = SolidPair::new(steel, steel);
    /// let contact = NormalContact::under_load(&gap, pair, 40e3, Resolution::STANDARD)?;
    /// let mut rolling = Rolling::on_areas(&contact, 0.3, None, coulomb::Resolution::FAST)?;
    /// let motion = Motion::from(Creepage::new(0.5, 0.0, 0.0)?);
    /// let [first, later] = [rolling.step(0.5, &motion)?, rolling.step(2.0, &motion)?];
    /// assert!(0.0 < first.solution.force.fx && first.solution.force.fx < later.solution.force.fx);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive, and for falling friction without a
    /// memory.
    pub fn on_areas(
        contact: &NormalContact,
        friction: f64,
        law: Option<RollingFriction>,
        resolution: Resolution,
    ) -> Result<Self, InvalidValue> {
        let surface = Surface { friction: law, layer: None };
        Self::areas_of(contact, friction, &surface, resolution)
    }

    /// The same with a layer between the bodies, whose plastic displacement moves with the particles.
    ///
    /// # Errors
    /// As [`Rolling::on_areas`].
    pub fn on_areas_with_layer(
        contact: &NormalContact,
        friction: f64,
        (law, layer): (Option<RollingFriction>, Layer),
        resolution: Resolution,
    ) -> Result<Self, InvalidValue> {
        let surface = Surface { friction: law, layer: Some(layer) };
        Self::areas_of(contact, friction, &surface, resolution)
    }

    fn areas_of(
        contact: &NormalContact,
        friction: f64,
        surface: &Surface,
        resolution: Resolution,
    ) -> Result<Self, InvalidValue> {
        if let Some(law) = surface.friction {
            remembered(law)?;
        }
        let scaling = contact.scaling(friction)?;
        // Creepages and forces are then those at the origin of coordinates.
        let frame = Frame { origin: [0.0; 2], length: scaling.length };
        let bands = Bands::new(contact, frame, resolution).with_more_along();
        Ok(Self::of([1, 2].map(|times| {
            let grid = bands.grid(times);
            let half = |k: usize| grid.mesh.strips.iter().map(move |strip| strip.half_length[k]);
            let longest = half(0).chain(half(1)).fold(0.0, f64::max);
            let poisson = contact.pair().poisson();
            Elements::new(grid, poisson, SLIP_UNIT, [longest, f64::INFINITY])
                .with_surface(surface, scaling)
        })))
    }
}
