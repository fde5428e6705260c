//! March of FASTSIM where friction depends on the slip, or where a layer yields.
//!
//! The speed of slip is taken as that of the rigid slip. With the bed's own slip in it, which is the
//! slope of the traction, falling friction has no steady traction: each spring would jump. Where a
//! spring has begun to slide it goes on until sliding friction is enough to hold it.

use std::f64::consts::PI;

use crate::Scaling;
use crate::contact::Contact;
use crate::friction_law::{RollingFriction, Thermal};
use crate::layer::Plasticity;

use super::grid::Profile;

/// What bounds the traction besides the pressure.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FrictionBound {
    friction: Option<RollingFriction>,
    plasticity: Option<Plasticity>,
    scaling: Scaling,
    /// Whether a spring slides as soon as friction by the rigid slip cannot hold it.
    is_eager: bool,
}

/// One step of a march; lengths in units of `c`, tractions of `mu N / c^2`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    pub(crate) length: f64,
    /// What the traction would grow by.
    pub(crate) growth: [f64; 2],
    /// The traction bound by friction at rest where the step ends.
    pub(crate) bound: f64,
    /// Rigid slip where the step ends, as `xi` and `eta`.
    pub(crate) rigid_slip: [f64; 2],
    /// Slip over the traction that a unit of length loses.
    pub(crate) flexibility: f64,
}

/// The state of a march, from the leading edge on.
#[derive(Debug, Clone)]
pub(crate) struct Walk {
    pub(crate) traction: [f64; 2],
    /// Traction that the last step would have added, had there been no bound.
    pub(crate) lost: [f64; 2],
    /// Friction over that at rest.
    pub(crate) friction: f64,
    /// Slip after the last step; zero in adhesion.
    pub(crate) slip: f64,
    /// Plastic displacement.
    plastic: f64,
    /// Distance marched.
    gone: f64,
    /// Steps that were heated: where each began and ended, and its heat, traction times slip.
    heated: Vec<[f64; 3]>,
}

impl Walk {
    pub(crate) fn start() -> Self {
        Self {
            traction: [0.0; 2],
            lost: [0.0; 2],
            friction: 1.0,
            slip: 0.0,
            plastic: 0.0,
            gone: 0.0,
            heated: Vec::new(),
        }
    }
}

impl FrictionBound {
    /// `None` where Coulomb's constant friction is all that bounds the traction.
    pub(crate) fn new(contact: &Contact) -> Option<Self> {
        let friction = contact.rolling_friction().filter(RollingFriction::varies);
        let scaling = contact.scaling();
        let plasticity = contact.layer().and_then(|layer| layer.plasticity());
        let plasticity = plasticity.map(|plasticity| {
            let Plasticity { yield_stress, slope } = plasticity.dimensionless(scaling);
            let peak = Profile::HERTZ_PEAK;
            Plasticity { yield_stress: peak * yield_stress, slope: peak * slope }
        });
        let bounds = friction.is_some() || plasticity.is_some();
        bounds.then_some(Self { friction, plasticity, scaling, is_eager: false })
    }

    /// The same where friction is that of the rigid slip in all of the contact: none holds by friction at rest.
    pub(crate) fn eager(self) -> Self {
        Self { is_eager: true, ..self }
    }

    /// Friction at `y`, in units of `c`, over the largest.
    pub(crate) fn share(&self, y: f64) -> f64 {
        self.friction.map_or(1.0, |friction| friction.share(self.scaling.length * y))
    }

    /// Takes a step.
    pub(crate) fn advance(&self, walk: &mut Walk, step: &Step) {
        let trial = [0, 1].map(|i| walk.traction[i] + step.growth[i]);
        let size = trial[0].hypot(trial[1]);
        let rigid = step.rigid_slip[0].hypot(step.rigid_slip[1]);
        let mut friction = walk.friction;
        if let Some(thermal) = self.friction.as_ref().and_then(RollingFriction::thermal) {
            friction = self.heated_friction(thermal, walk, step, rigid);
        } else if let Some(law) = &self.friction {
            let after = |slip: f64| {
                let slips = [walk.slip, slip].map(|slip| self.scaling.slip * slip);
                law.after(walk.friction, slips, self.scaling.length * step.length)
            };
            let sliding = after(rigid);
            let slides = walk.slip > 0.0 || self.is_eager;
            let goes_on = slides && size > sliding * step.bound;
            friction = if goes_on { sliding } else { after(0.0) };
            if !goes_on && size > friction * step.bound {
                friction = sliding;
            }
        }
        let (limit, plastic) = self.limit(walk, step, size, friction * step.bound);
        let scale = if size > limit { limit / size } else { 1.0 };
        walk.slip = if scale < 1.0 && !plastic { rigid } else { 0.0 };
        walk.friction = friction;
        if self.friction.is_some_and(|friction| friction.thermal().is_some()) {
            let gone = walk.gone + step.length;
            if walk.slip > 0.0 {
                walk.heated.push([walk.gone, gone, limit.min(size) * walk.slip]);
            }
            walk.gone = gone;
        }
        walk.traction = trial.map(|v| v * scale);
        walk.lost = trial.map(|v| v * (1.0 - scale));
        if plastic {
            walk.plastic += step.flexibility * (1.0 - scale) * size;
        }
    }

    /// Friction over the largest by the temperature where the step ends, should it slide all along.
    fn heated_friction(&self, thermal: &Thermal, walk: &Walk, step: &Step, rigid: f64) -> f64 {
        let Scaling { length, slip, traction, .. } = self.scaling;
        let (law, speed) = (thermal.law, self.friction.map_or(0.0, |friction| friction.speed()));
        // Tractions of a march are in units of mu N over c squared.
        let traction = traction / Profile::HERTZ_PEAK;
        let unit = 2.0 * traction * slip * speed * length.sqrt() / (PI.sqrt() * thermal.weight);
        let here = walk.gone + step.length;
        let root = |from: f64| (here - from).max(0.0).sqrt();
        let rise: f64 =
            walk.heated.iter().map(|[from, to, heat]| heat * (root(*from) - root(*to))).sum();
        let gain = unit * step.bound * rigid * root(walk.gone) / law.largest();
        law.heated(thermal.touching + unit * rise, gain) / law.largest()
    }

    /// The smaller of the bound by friction and that by the layer, and whether it is the layer's. What
    /// is lost there is the plastic displacement, by which the bound rises.
    fn limit(&self, walk: &Walk, step: &Step, size: f64, by_friction: f64) -> (f64, bool) {
        let Some(Plasticity { yield_stress, slope }) = self.plasticity else {
            return (by_friction, false);
        };
        let rise = slope * step.flexibility;
        let by_layer = (yield_stress + slope * walk.plastic + rise * size) / (1.0 + rise);
        (by_friction.min(by_layer.max(0.0)), by_layer < by_friction && by_layer < size)
    }
}
