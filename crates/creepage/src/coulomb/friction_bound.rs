//! The friction bound of each element where friction depends on slip or place, or a layer yields.

use std::f64::consts::PI;

use super::mesh::Mesh;
use super::stencil::SlipStencil;
use crate::Scaling;
use crate::friction_law::{RollingFriction, Thermal};
use crate::layer::{Layer, Plasticity};

/// Least of the bound that is ever left, over that at rest: tractions are divided by it.
pub(crate) const MIN_BOUND: f64 = 1e-6;

/// The law of friction and the yield of the layer, prepared for the elements of a mesh.
#[derive(Debug, Clone)]
pub(crate) struct FrictionBound {
    friction: Option<RollingFriction>,
    plasticity: Option<Plasticity>,
    scaling: Scaling,
    /// From where the slip of the element before is taken, or from the leading edge, to where that of
    /// each element is.
    steps: Vec<f64>,
    moment: Moment,
    /// What comes from upstream, of every element; empty in steady rolling, where it is what the
    /// element before has.
    arriving: Vec<Arriving>,
}

/// Present size of the contact, and its motion.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moment {
    /// Size over that of the units.
    pub size: f64,
    /// False while bodies are shifted at rest: nothing slips at a speed.
    pub rolls: bool,
}

/// Friction over that at rest, slip, and plastic displacement of the particle that is now at an element, as
/// it was a step upstream: a part of what the element there has now, and what is known. While bodies are
/// shifted at rest the particle stays where it is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Arriving {
    pub present: f64,
    pub friction: f64,
    pub slip: f64,
    /// In units of slip times length of the nominal load.
    pub plastic: f64,
    /// Distance back, in units of the contact's present size.
    pub step: f64,
}

impl FrictionBound {
    /// `None` where Coulomb's constant friction is all that bounds the traction.
    pub(crate) fn new(
        friction: Option<RollingFriction>,
        layer: Option<Layer>,
        scaling: Scaling,
        stencils: &[SlipStencil],
    ) -> Option<Self> {
        let friction = friction.filter(RollingFriction::varies);
        let plasticity = layer.and_then(|layer| layer.plasticity());
        if friction.is_none() && plasticity.is_none() {
            return None;
        }
        let steps = stencils.iter().flat_map(|stencil| {
            let before = stencil.points.first().into_iter().chain(&stencil.places);
            before.zip(&stencil.places).map(|(before, at)| before[0] - at[0])
        });
        let plasticity = plasticity.map(|plasticity| plasticity.dimensionless(scaling));
        let moment = Moment { size: 1.0, rolls: true };
        let (steps, arriving) = (steps.collect(), Vec::new());
        Some(Self { friction, plasticity, scaling, steps, moment, arriving })
    }

    /// Sets what holds in a step of rolling that is not steady.
    pub(crate) fn at_moment(&mut self, moment: Moment, arriving: Vec<Arriving>) {
        (self.moment, self.arriving) = (moment, arriving);
    }

    /// Whether friction or the layer's yield depends on the slip before.
    pub(crate) fn remembers(&self) -> bool {
        self.yields() || self.friction.is_some_and(|friction| friction.memory().is_some())
    }

    /// Friction at high speed over that at rest, where it falls with the speed.
    pub(crate) fn lowest(&self) -> Option<f64> {
        let falling = self.friction.filter(RollingFriction::falls);
        // By temperature one solution is all: what heats is behind, not at, the place that it cools down.
        let falling = falling.filter(|friction| friction.thermal().is_none());
        falling.map(|friction| friction.lowest().max(MIN_BOUND))
    }

    /// Whether a layer yields, which may answer a step by a larger one back.
    pub(crate) fn yields(&self) -> bool {
        self.plasticity.is_some()
    }

    /// The bound of every element over that at rest, strip by strip from the leading edge, where the
    /// surfaces move over each other by `slip`; `bounds` are those at rest.
    pub(crate) fn limits(
        &self,
        mesh: &Mesh,
        bounds: &[f64],
        slip: impl Fn(usize) -> f64,
        limits: &mut [f64],
    ) {
        if let Some(thermal) = self.friction.as_ref().and_then(RollingFriction::thermal) {
            return self.heated_limits(thermal, mesh, bounds, slip, limits);
        }
        self.march(mesh, bounds, slip, |element, limit, _| limits[element] = limit);
    }

    /// The plastic displacement of the layer at every element, in units of slip times length of the nominal
    /// load; `slip` and `bounds` as in [`FrictionBound::limits`].
    pub(crate) fn plastic_displacements(
        &self,
        mesh: &Mesh,
        bounds: &[f64],
        slip: impl Fn(usize) -> f64,
    ) -> Vec<f64> {
        let mut all = vec![0.0; bounds.len()];
        self.march(mesh, bounds, slip, |element, _, plastic| all[element] = plastic);
        all
    }

    /// Goes along every strip from its leading edge: each element's bound, and its plastic displacement.
    fn march(
        &self,
        mesh: &Mesh,
        bounds: &[f64],
        slip: impl Fn(usize) -> f64,
        mut put: impl FnMut(usize, f64, f64),
    ) {
        for strip in 0..mesh.strips.len() {
            let share = self.share(mesh.strips[strip].y());
            let (mut friction, mut last, mut plastic) = (1.0, 0.0, 0.0);
            for element in mesh.elements(strip) {
                let slip = slip(element);
                friction = self.friction_at(element, [friction, last], slip);
                let [before, moved] = self.plastic_at(element, [plastic, last], slip);
                let yields = self.yield_bound(moved) / (self.moment.size * bounds[element]);
                plastic = if yields < share * friction { moved } else { before };
                put(element, (share * friction).min(yields).clamp(MIN_BOUND, 1.0), plastic);
                last = slip;
            }
        }
    }

    /// The same where friction depends on the temperature: each strip is marched from the leading edge, its
    /// elements heated by those ahead and by the leading half of their own.
    fn heated_limits(
        &self,
        thermal: &Thermal,
        mesh: &Mesh,
        bounds: &[f64],
        slip: impl Fn(usize) -> f64,
        limits: &mut [f64],
    ) {
        let Scaling { length, slip: slip_unit, traction, .. } = self.scaling;
        let (law, speed) = (thermal.law, self.friction.map_or(0.0, |friction| friction.speed()));
        let (touching, largest) = (thermal.touching, law.largest());
        // Rise by a unit of traction, slip and root of length.
        let unit =
            2.0 * traction * slip_unit * speed * length.sqrt() / (PI.sqrt() * thermal.weight);
        let mut ahead: Vec<[f64; 3]> = Vec::new();
        for strip in 0..mesh.strips.len() {
            ahead.clear();
            for (i, element) in mesh.elements(strip).enumerate() {
                let [high, low] = [i, i + 1].map(|i| mesh.strips[strip].middle_cut(i)[0]);
                let middle = 0.5 * (low + high);
                let root = |x: f64| (x - middle).max(0.0).sqrt();
                let rise: f64 =
                    ahead.iter().map(|[from, to, heat]| heat * (root(*to) - root(*from))).sum();
                let heat = bounds[element] * slip(element);
                let gain = unit * heat * root(high) / largest;
                let friction = law.heated(touching + unit * rise, gain) / largest;
                let yields = self.yield_bound(0.0) / bounds[element];
                limits[element] = friction.min(yields).clamp(MIN_BOUND, 1.0);
                ahead.push([low, high, limits[element] * heat]);
            }
        }
    }

    /// Friction of an element over that at rest, behind one that has `friction` and slips by `last`.
    fn friction_at(&self, element: usize, [friction, last]: [f64; 2], slip: f64) -> f64 {
        let Some(arriving) = self.arriving.get(element) else {
            return self.friction_after(friction, [last, slip], self.steps[element]);
        };
        let before = arriving.present * friction + arriving.friction;
        let last = arriving.present * last + arriving.slip;
        self.friction_after(before, [last.max(0.0), slip], arriving.step)
    }

    /// Plastic displacement of the layer at an element, behind one that has `plastic` and slips by `last`:
    /// what the particle arrives with, and with the present slip added.
    fn plastic_at(&self, element: usize, [plastic, last]: [f64; 2], slip: f64) -> [f64; 2] {
        let Moment { size, rolls } = self.moment;
        let Some(arriving) = self.arriving.get(element) else {
            return [plastic, plastic + size * size * (0.5 * (last + slip) * self.steps[element])];
        };
        let before = arriving.present * plastic + arriving.plastic;
        let last = (arriving.present * last + arriving.slip).max(0.0);
        // A shift's slip is a displacement already.
        let way = if rolls { 0.5 * (last + slip) * arriving.step } else { slip };
        [before, before + size * size * way]
    }

    fn friction_after(&self, before: f64, slips: [f64; 2], step: f64) -> f64 {
        let Some(friction) = &self.friction else { return 1.0 };
        let Moment { size, rolls } = self.moment;
        if !rolls {
            return 1.0;
        }
        let slips = slips.map(|slip| self.scaling.slip * size * slip);
        friction.after(before, slips, self.scaling.length * size * step)
    }

    /// Friction over the largest at some `y`.
    fn share(&self, y: f64) -> f64 {
        let at = self.scaling.length * self.moment.size * y;
        self.friction.map_or(1.0, |friction| friction.share(at))
    }

    /// The layer's shear yield stress after a plastic displacement.
    fn yield_bound(&self, plastic: f64) -> f64 {
        self.plasticity.map_or(f64::INFINITY, |p| p.yield_stress + p.slope * plastic)
    }
}
