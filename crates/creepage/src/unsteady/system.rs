//! Slip equations of one step: what the past drives, what the creepage does, and how slip depends on the tractions.
//!
//! With `U` the displacements of a particle now, one step of elements upstream and two, and `W` the
//! rigid slips over the ways between, averaged:
//!
//! ```math
//! S_1 = W_1 - \frac{U_0 - U_1}{g_1}, \qquad S_2 = W_2 - \frac{U_1 - U_2}{g_2}, \qquad
//! s = S_1 + \frac{g_1}{g_1 + g_2} (S_1 - S_2)
//! ```
//!
//! Where the second way is cut short by the beginning of the past, the correction grows with it.

use super::elements::{Element, Elements};
use super::history::{Ages, Creep, Past, TimeLevel, Weights};
use super::particle::{Particles, Sample};
use super::rigid::{RigidMotion, RigidSlip};

/// The equations of one step, in the units of the contact's present size.
#[derive(Debug, Clone, Default)]
pub(crate) struct System {
    /// Of every element: points of displacement by the present tractions, and their factors.
    pub weights: Vec<[(usize, f64); 3]>,
    /// Slip by the past and by the pressure, and what is added from place to place.
    past: Vec<[f64; 2]>,
    /// By a unit of creepage: the slip, and what the spin adds to `y` besides.
    present: Vec<[f64; 2]>,
    /// Size of the contact.
    pub scale: f64,
}

impl System {
    /// A step of `length` that brings the contact to the size `scale`; an infinite one is steady
    /// rolling.
    pub(crate) fn of_step(
        elements: &Elements,
        past: &Past,
        length: f64,
        scale: f64,
        smooth: bool,
    ) -> Self {
        let ages = past.seen_after(length, scale, smooth);
        let step = Step {
            elements,
            past,
            ages: &ages,
            motion: RigidMotion::new(past, &ages, length),
            scale,
        };
        let mut system = Self { scale, ..Self::default() };
        for element in &elements.all {
            step.add(element, &mut system);
        }
        system
    }

    /// No rolling: the slip is a shift, `xi` and `eta` its components.
    pub(crate) fn of_shift(elements: &Elements, level: &TimeLevel) -> Self {
        let scale = level.scale;
        let unit = (scale * scale).recip();
        let mut system = Self { scale, ..Self::default() };
        for Element { nodes: [own, _, _], .. } in &elements.all {
            system.weights.push([(*own, -1.0), (*own, 0.0), (*own, 0.0)]);
            let (before, pressure) = (level.at(*own), elements.by_pressure[*own]);
            system.past.push([0, 1].map(|k| unit * before[k] - pressure[k]));
            system.present.push([unit, 0.0]);
        }
        system
    }

    /// Adds a rigid slip, by place, in the units of the nominal load: that of a step is the slip at its end, as the
    /// differences of displacements are.
    pub(crate) fn add_slip(&mut self, elements: &Elements, slip: impl Fn([f64; 2]) -> [f64; 2]) {
        for (all, element) in self.past.iter_mut().zip(&elements.all) {
            let more = slip([element.x, element.y].map(|at| self.scale * at));
            (0..2).for_each(|k| all[k] += more[k] / self.scale);
        }
    }

    /// What drives the slip of an element.
    pub(crate) fn drive(&self, elements: &Elements, index: usize, creep: Creep) -> [f64; 2] {
        let [x, y] = self.by_creep(elements, index, creep);
        let past = self.past[index];
        [past[0] + x, past[1] + y]
    }

    /// The part by the creepage.
    pub(crate) fn by_creep(&self, elements: &Elements, index: usize, creep: Creep) -> [f64; 2] {
        let (Element { x, y, .. }, [xi, eta, chi]) = (&elements.all[index], creep);
        let [slip, turn] = self.present[index];
        let chi_there = chi * self.scale;
        [slip * (xi - chi_there * y), slip * (eta + chi_there * x) + turn * chi]
    }
}

struct Step<'a> {
    elements: &'a Elements,
    past: &'a Past,
    ages: &'a Ages,
    motion: RigidMotion<'a>,
    scale: f64,
}

impl Step<'_> {
    fn add(&self, element: &Element, system: &mut System) {
        let particles = Particles { elements: self.elements, ages: self.ages };
        let first = particles.sample(element, false, 0.0);
        let second = (element.steps[1] > 0.0).then(|| particles.sample(element, true, first.age));
        let (g1, to) = (first.age, second.as_ref().map_or(first.age, |second| second.age));
        let [correction, by_second] = self.correction(element, g1, second.as_ref());
        let by_first = (1.0 + correction) / g1;
        let [(way, own), (whole, both)] = [g1, to].map(|age| self.motion.back_to(age));
        let by_way = by_first + by_second;
        let moved: RigidSlip = std::array::from_fn(|k| by_way * way[k] - by_second * whole[k]);
        let present = [0, 1].map(|k| (by_way * own[k] - by_second * both[k]) / self.scale);
        system.present.push(present);
        let mut slip = self.rigid(element, moved);
        let mut weights = element.nodes.map(|node| (node, 0.0));
        self.displaced(element, (0, None), -by_first, &mut weights, &mut slip);
        let at_first = (0, Some(&first));
        self.displaced(element, at_first, by_first + by_second, &mut weights, &mut slip);
        if second.is_some() {
            self.displaced(element, (1, second.as_ref()), -by_second, &mut weights, &mut slip);
        }
        system.weights.push(weights);
        system.past.push(slip);
    }

    /// Factor of the difference of both slips, and that over the second way's length. None where the
    /// load jumps on the way: displacements then change by all of themselves.
    fn correction(&self, element: &Element, g1: f64, second: Option<&Sample>) -> [f64; 2] {
        let Some(second) = second else { return [0.0; 2] };
        if !self.ages.keeps_size(second.age) {
            return [0.0; 2];
        }
        let g2 = second.age - g1;
        let whole = if second.is_whole { g2 } else { element.steps[1] * self.scale };
        let factor = g1 / (g1 + whole);
        let part = (g2 / whole).min(1.0);
        [factor * part, if g2 > whole { factor / g2 } else { factor / whole }]
    }

    /// Slip by rigid motion that is known.
    fn rigid(&self, element: &Element, [xi, eta, chi, moment]: RigidSlip) -> [f64; 2] {
        let [x, y] = [element.x * self.scale, element.y * self.scale];
        [(xi - chi * y) / self.scale, (eta + chi * x + moment) / self.scale]
    }

    /// Adds `factor` times the displacement of a sample, which lies upstream of the element's point
    /// `down`, or is that point now if there is none.
    fn displaced(
        &self,
        element: &Element,
        (down, sample): (usize, Option<&Sample>),
        factor: f64,
        weights: &mut [(usize, f64); 3],
        slip: &mut [f64; 2],
    ) {
        // From distances to those over the contact's size, in which tractions act.
        let (factor, unit) = (factor * self.scale, (self.scale * self.scale).recip());
        let (age, ahead) = sample.map_or((0.0, 0.0), |sample| (sample.age, sample.ahead));
        let at = if sample.is_some() { self.ages.weights(age) } else { Weights::PRESENT };
        let up = (down + 1).min(2);
        let now = [(down, 1.0 - ahead), (up, ahead)];
        for (node, weight) in now {
            let own = factor * at.present * weight;
            weights[node].1 += own;
            let pressure = self.elements.by_pressure[element.nodes[node]];
            (0..2).for_each(|k| slip[k] += own * pressure[k]);
        }
        let Some(sample) = sample else { return };
        let known = self.known(element, sample, &at, now);
        (0..2).for_each(|k| slip[k] += factor * unit * known[k]);
    }

    /// What is known of the displacement of a sample: that of the past, and how the present one
    /// differs from that of the points next to it, taken from the latest level.
    fn known(
        &self,
        element: &Element,
        sample: &Sample,
        at: &Weights,
        now: [(usize, f64); 2],
    ) -> [f64; 2] {
        let mut sum = [0.0; 2];
        let mut add = |value: [f64; 2], weight: f64| {
            (0..2).for_each(|k| sum[k] += weight * value[k]);
        };
        let upstream = element.nodes[now[1].0];
        for (level, weight) in at.levels {
            if weight != 0.0 {
                add(self.level(level, sample, upstream), weight);
            }
        }
        if at.present != 0.0 && sample.between.is_some() {
            add(self.level(0, sample, upstream), at.present);
            for (node, weight) in now {
                add(self.past.0[0].at(element.nodes[node]), -weight * at.present);
            }
        }
        sum
    }

    fn level(&self, level: usize, sample: &Sample, upstream: usize) -> [f64; 2] {
        let level = &self.past.0[level];
        let Some(spread) = &sample.between else { return level.at(upstream) };
        spread.iter().fold([0.0; 2], |sum, (point, weight)| {
            let value = level.at(*point);
            [sum[0] + weight * value[0], sum[1] + weight * value[1]]
        })
    }
}

impl TimeLevel {
    /// Displacement of a point.
    pub(crate) fn at(&self, point: usize) -> [f64; 2] {
        [self.displacement[0][point], self.displacement[1][point]]
    }
}
