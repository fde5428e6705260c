//! Contact that a theory of rolling is prepared for: Hertz's ellipse or areas of any shape.

use std::sync::Arc;

use crate::added_slip::AddedSlip;
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;
use crate::friction_law::RollingFriction;
use crate::hertz::Hertz;
use crate::layer::Layer;
use crate::normal::NormalContact;
use crate::scaling::Scaling;

/// Everything that a theory of rolling is prepared for: what touches, the combined Poisson's ratio, how
/// dissimilar the bodies are, and the units of its quantities; where friction depends on the speed of
/// slip its law, and a layer between the bodies.
///
/// What touches is Hertz's ellipse ([`Contact::new`], [`Hertz::with_friction`]) or areas of any shape that
/// were pressed ([`Contact::of_areas`]). [`TheorySpec::prepare`](crate::TheorySpec::prepare) takes both; a
/// theory that needs an ellipse says so.
///
/// ```
/// use creepage::{Contact, Ellipse};
/// let contact = Contact::new(Ellipse::from_ratio(1.5)?, 0.28)?; // dimensionless, like bodies
/// assert_eq!((contact.poisson(), contact.kappa_over_mu()), (0.28, 0.0));
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    ellipse: Ellipse,
    /// Areas of any shape, for which the ellipse stands; `None` where the ellipse is Hertz's.
    areas: Option<Arc<NormalContact>>,
    poisson: f64,
    kappa_over_mu: f64,
    friction: Option<f64>,
    scaling: Scaling,
    friction_law: Option<RollingFriction>,
    layer: Option<Layer>,
    added_slip: Option<Arc<AddedSlip>>,
}

impl Contact {
    /// A dimensionless contact of like bodies: only the ratio of the ellipse's semi-axes matters,
    /// and the units of [`Contact::scaling`] are one.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `poisson` lies between 0 and 0.5.
    pub fn new(ellipse: Ellipse, poisson: f64) -> Result<Self, InvalidValue> {
        check::poisson(poisson)?;
        let ellipse = Ellipse::from_ratio(ellipse.ratio())?;
        Ok(Self {
            ellipse,
            areas: None,
            poisson,
            kappa_over_mu: 0.0,
            friction: None,
            scaling: Scaling::DIMENSIONLESS,
            friction_law: None,
            layer: None,
            added_slip: None,
        })
    }

    /// Areas of any shape that were pressed, with coefficient of friction `friction`. Lengths count from
    /// the origin of the gap, in the unit of [`NormalContact::scaling`].
    ///
    /// ```
    /// use creepage::gap::{Gap, Term};
    /// use creepage::normal::{NormalContact, Resolution};
    /// use creepage::{Contact, SiCreepage, Solid, SolidPair, TheorySpec};
    /// // A crowned roller: h = x^2/920 + y^4/20000 in millimetres.
    /// let term = |x, y, coefficient| Term { x, y, coefficient };
    /// let gap = Gap::polynomial(&[term(2, 0, 1e3 / 920.0), term(0, 4, 1e9 / 20_000.0)])?;
    /// let steel = Solid::new(82e9, 0.28)?;
    /// let pair = SolidPair::new(steel, steel);
    /// let pressed = NormalContact::under_load(&gap, pair, 40e3, Resolution::STANDARD)?;
    /// let contact = Contact::of_areas(pressed, 0.3)?;
    /// let creepage = SiCreepage { longitudinal: 1e-3, ..SiCreepage::default() };
    /// let creepage = contact.scaling().creepage(creepage)?;
    /// for name in ["exact", "fastsim"] {
    ///     let theory = TheorySpec::named(name)?.prepare(&contact)?;
    ///     let force = contact.scaling().si_force(theory.solve(creepage).force);
    ///     assert!(force.longitudinal > 5e3 && force.longitudinal < 12e3); // newtons
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive, and not below a millionth between
    /// dissimilar bodies.
    pub fn of_areas(
        areas: impl Into<Arc<NormalContact>>,
        friction: f64,
    ) -> Result<Self, InvalidValue> {
        let areas = areas.into();
        let (scaling, pair) = (areas.scaling(friction)?, areas.pair());
        let contact = Self::new(standing_for(&areas)?, pair.poisson())?;
        Self { areas: Some(areas), scaling, friction: Some(friction), ..contact }
            .with_kappa_over_mu(pair.kappa() / friction)
    }

    /// The same areas with another coefficient of friction, constant and without a layer; an ellipse
    /// with its pressure is [`Hertz::with_friction`]'s.
    pub(crate) fn with_friction_on_areas(&self, friction: f64) -> Result<Self, InvalidValue> {
        self.areas
            .as_ref()
            .map_or_else(|| Ok(self.clone()), |areas| Self::of_areas(Arc::clone(areas), friction))
    }

    /// The same between dissimilar bodies, whose pressure adds to the slip (6.4): `kappa` of
    /// [`SolidPair::kappa`](crate::SolidPair::kappa) over the coefficient of friction. `exact` counts
    /// it, the other theories neglect it.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `kappa_over_mu` lies between -1e6 and 1e6: `kappa` is at most 0.5,
    /// and friction is not as small as a millionth.
    pub fn with_kappa_over_mu(self, kappa_over_mu: f64) -> Result<Self, InvalidValue> {
        let valid = "between -1e6 and 1e6";
        check::require(kappa_over_mu.abs() <= 1e6, "kappa_over_mu", kappa_over_mu, valid)?;
        Ok(Self { kappa_over_mu, ..self })
    }

    /// The same with friction that depends on the speed of slip or on the place across the contact: `mu`
    /// of all units and quantities is that at rest, and the largest. `exact` and `fastsim` follow it, the other theories take `mu` as constant. The
    /// speed of slip is in the units of [`Contact::scaling`].
    #[must_use]
    pub fn with_rolling_friction(self, friction: RollingFriction) -> Self {
        Self { friction_law: Some(friction), ..self }
    }

    /// The same with a layer between the bodies, in the units of [`Contact::scaling`]. `exact` and
    /// `fastsim` follow it.
    #[must_use]
    pub fn with_layer(self, layer: Layer) -> Self {
        Self { layer: Some(layer), ..self }
    }

    /// The same with a rigid slip beside that of creepage and spin. `exact` follows it, one-way;
    /// [`TheorySpec::prepare`](crate::TheorySpec::prepare) refuses such a contact for the other theories.
    ///
    /// ```
    /// use creepage::{AddedSlip, Contact, Creepage, Ellipse, TheorySpec};
    /// // A slip that is the same everywhere is a creepage.
    /// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
    /// let slipping = contact.clone().with_added_slip(AddedSlip::new(&[[0.0, 0.0, 0.5, 0.0]])?);
    /// let force = |contact: &Contact, xi: f64| -> Result<f64, Box<dyn std::error::Error>> {
    ///     let theory = TheorySpec::named("exact")?.prepare(contact)?;
    ///     Ok(theory.solve(Creepage::new(xi, 0.0, 0.0)?).force.fx)
    /// };
    /// assert!((force(&slipping, 0.3)? - force(&contact, 0.8)?).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_added_slip(self, slip: impl Into<Arc<AddedSlip>>) -> Self {
        Self { added_slip: Some(slip.into()), ..self }
    }

    /// The same with another law of friction and another layer, or without.
    pub(crate) fn with_resistance(
        &self,
        friction_law: Option<RollingFriction>,
        layer: Option<Layer>,
    ) -> Self {
        Self { friction_law, layer, ..self.clone() }
    }

    /// The law of friction, where it is not constant.
    #[must_use]
    pub fn rolling_friction(&self) -> Option<RollingFriction> {
        self.friction_law
    }

    /// The layer between the bodies.
    #[must_use]
    pub fn layer(&self) -> Option<Layer> {
        self.layer
    }

    /// The rigid slip beside that of creepage and spin, where there is one.
    #[must_use]
    pub fn added_slip(&self) -> Option<&Arc<AddedSlip>> {
        self.added_slip.as_ref()
    }

    /// That at a place, in the units of [`Contact::scaling`]; none without one.
    pub(crate) fn slip_beside(&self, place: [f64; 2]) -> [f64; 2] {
        let Some(slip) = &self.added_slip else { return [0.0; 2] };
        let [x, y] = place.map(|at| self.scaling.length * at);
        slip.at(x, y).map(|slip| slip / self.scaling.slip)
    }

    /// The same contact with creepage and spin alone.
    #[must_use]
    pub fn without_added_slip(&self) -> Self {
        Self { added_slip: None, ..self.clone() }
    }

    /// For a theory that has one creepage and spin.
    ///
    /// # Errors
    /// [`InvalidValue`] with a rigid slip beside them.
    pub(crate) fn require_no_added_slip(&self) -> Result<(), InvalidValue> {
        let largest = self.added_slip.as_ref().map_or(0.0, |slip| slip.largest());
        let valid = "zero in this theory, which has one creepage and spin for the whole contact; exact, without \
                     coupling, has a slip from place to place";
        check::require(self.added_slip.is_none(), "added slip", largest, valid).map(drop)
    }

    /// Hertz's contact ellipse, whose `c = sqrt(a b)` is the unit of length. For areas of any shape the
    /// ellipse that stands for them where a ratio is needed: as long as they are along the rolling
    /// direction to their width.
    #[must_use]
    pub fn ellipse(&self) -> Ellipse {
        self.ellipse
    }

    /// The areas of any shape; `None` for Hertz's ellipse.
    #[must_use]
    pub fn areas(&self) -> Option<&Arc<NormalContact>> {
        self.areas.as_ref()
    }

    /// Hertz's ellipse, for a theory that needs one.
    ///
    /// # Errors
    /// [`InvalidValue`] for areas of any shape.
    pub(crate) fn hertz_ellipse(&self) -> Result<Ellipse, InvalidValue> {
        let patches = self.areas.as_ref().map_or(0, |areas| areas.patches().len());
        let valid = "none: this theory needs Hertz's ellipse; exact, fastsim, fastrip, linear and \
                     saturated take areas of any shape";
        check::require(self.areas.is_none(), "areas of any shape", patches as f64, valid)?;
        Ok(self.ellipse)
    }

    /// First and last place of the contact along `x` and along `y` (m): from the centre of the ellipse, or from the
    /// origin of the gap.
    #[must_use]
    pub fn extent(&self) -> [[f64; 2]; 2] {
        self.areas.as_ref().map_or_else(
            || {
                let unit = self.scaling.length / self.ellipse.c();
                [self.ellipse.a(), self.ellipse.b()].map(|half| [-half * unit, half * unit])
            },
            |areas| areas.extent(),
        )
    }

    /// Combined Poisson's ratio.
    #[must_use]
    pub fn poisson(&self) -> f64 {
        self.poisson
    }

    /// How dissimilar the bodies are: `kappa` of (2.10) over the coefficient of friction.
    #[must_use]
    pub fn kappa_over_mu(&self) -> f64 {
        self.kappa_over_mu
    }

    /// The coefficient of friction, where it is known: one-way, only `kappa/mu` counts.
    #[must_use]
    pub fn friction(&self) -> Option<f64> {
        self.friction
    }

    /// The units of creepage and force.
    #[must_use]
    pub fn scaling(&self) -> Scaling {
        self.scaling
    }
}

/// The ellipse of the ratio of all areas' length along rolling to their width.
fn standing_for(areas: &NormalContact) -> Result<Ellipse, InvalidValue> {
    let [x, y] = areas.extent();
    Ellipse::from_ratio((x[1] - x[0]) / (y[1] - y[0]))
}

impl Hertz {
    /// The contact for a theory of rolling, with coefficient of friction `friction`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive, and not below a millionth between
    /// dissimilar bodies.
    ///
    /// ```
    /// use creepage::{Ellipse, Hertz, Solid, SolidPair};
    /// let (steel, aluminium) = (Solid::new(82e9, 0.28)?, Solid::new(26e9, 0.33)?);
    /// let ellipse = Ellipse::new(6e-3, 4e-3)?;
    /// let hertz = Hertz::from_ellipse(SolidPair::new(steel, aluminium), ellipse, 80e3)?;
    /// let contact = hertz.with_friction(0.3)?;
    /// assert!((contact.kappa_over_mu() - hertz.pair().kappa() / 0.3).abs() < 1e-15);
    /// assert_eq!(contact.scaling().force, 24e3); // mu N
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    pub fn with_friction(&self, friction: f64) -> Result<Contact, InvalidValue> {
        let scaling = Scaling::new(self, friction)?;
        let contact = Contact::new(self.ellipse(), self.pair().poisson())?;
        Contact { scaling, friction: Some(friction), ..contact }
            .with_kappa_over_mu(self.pair().kappa() / friction)
    }

    /// The contact for a theory of rolling where friction depends on the speed of slip or on the place;
    /// its largest value is the `mu` of all units and quantities.
    ///
    /// # Errors
    /// As [`Hertz::with_friction`].
    pub fn with_friction_law(&self, friction: RollingFriction) -> Result<Contact, InvalidValue> {
        let contact = self.with_friction(friction.law().at_rest())?;
        Ok(contact.with_rolling_friction(friction))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_ratio_of_a_dimensionless_ellipse_counts() {
        let contact = Contact::new(Ellipse::new(6e-3, 3e-3).unwrap(), 0.3).unwrap();
        assert!((contact.ellipse().c() - 1.0).abs() < 1e-15);
        assert!((contact.ellipse().ratio() - 2.0).abs() < 1e-15);
    }

    #[test]
    fn nonsense_is_an_error_that_names_the_quantity() {
        let circle = Ellipse::from_ratio(1.0).unwrap();
        assert_eq!(Contact::new(circle, f64::NAN).unwrap_err().quantity, "poisson");
        let contact = Contact::new(circle, 0.3).unwrap();
        for kappa in [f64::NAN, f64::INFINITY, 2e6] {
            assert_eq!(
                contact.clone().with_kappa_over_mu(kappa).unwrap_err().quantity,
                "kappa_over_mu"
            );
        }
    }
}
