//! The map of one wheel, on the right-hand image of its side.

use creepage::table::Table;

use crate::blend::Hermite;
use crate::error::{MapError, Quantity};
use crate::normal::{Heights, Placed};
use crate::patch::{From, Patch, PatchForces, Prepared, Report, WheelsetState};
use crate::scalar::Scalar;

/// Most places of contact of one wheel that are kept apart in reports.
pub const PLACES: usize = 2;

/// A place of wheel on rail with the contacts that the wheel has there under each load.
#[derive(Debug, Clone, PartialEq)]
pub struct RollingNode {
    /// The map's coordinate (m).
    pub place: f64,
    /// Of each load of the map, the contacts.
    pub loads: Vec<Vec<Patch>>,
}

/// Measured errors of a stretch of the map.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CellError {
    /// Number of fresh states.
    pub states: usize,
    /// Largest difference of the tangential force over them, in parts of `mu N`.
    pub tangential: f64,
    /// Largest difference of the normal force over them, in parts of `N`.
    pub normal: f64,
}

/// The map of one wheel.
#[derive(Debug, Clone)]
pub struct WheelMap {
    pub(crate) heights: Heights,
    places: Vec<f64>,
    /// Logarithms of the loads.
    loads: Vec<f64>,
    /// Ends of each record's patches, by node, then by load.
    ends: Vec<usize>,
    patches: Vec<Prepared>,
    /// Of each cell between rolling nodes.
    pub(crate) errors: Vec<CellError>,
}

/// Force and moments of a wheel on its rail.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WheelActs<S> {
    /// Vertical part of the normal forces (N).
    pub(crate) load: S,
    /// Force along the track's axes (N).
    pub(crate) force: [S; 3],
    /// Moment about [`WheelsetState::about`] (N m).
    pub(crate) moment: [S; 3],
    /// Friction's moment about the axle (N m).
    pub(crate) axle: S,
    /// Places of contact: forces over the load.
    pub(crate) reports: [Report; PLACES],
    pub(crate) error: CellError,
}

impl<S: Scalar> WheelActs<S> {
    fn nothing() -> Self {
        let zero = S::constant(0.0);
        Self {
            load: zero,
            force: [zero; 3],
            moment: [zero; 3],
            axle: zero,
            reports: [Report::default(); PLACES],
            error: CellError::default(),
        }
    }
}

impl WheelMap {
    /// From its heights, its rolling nodes of rising place, and the loads (N, rising) of these.
    ///
    /// # Errors
    /// [`MapError::Senseless`] and [`MapError::Invalid`] where numbers are those of no map.
    pub fn new(
        heights: Heights,
        nodes: &[RollingNode],
        loads: &[f64],
        errors: Vec<CellError>,
        (table, poisson): (&Table, f64),
    ) -> Result<Self, MapError> {
        let places: Vec<f64> = nodes.iter().map(|node| node.place).collect();
        let rises = |values: &[f64]| {
            values.iter().all(|v| v.is_finite()) && values.windows(2).all(|pair| pair[0] < pair[1])
        };
        let makes_sense = places.len() >= 2
            && rises(&places)
            && loads.len() >= 2
            && loads[0] > 0.0
            && rises(loads)
            && errors.len() + 1 == places.len()
            && nodes.iter().all(|node| node.loads.len() == loads.len())
            && nodes.iter().flat_map(|node| &node.loads).all(|record| !record.is_empty());
        if !makes_sense {
            return Err(MapError::Senseless("rolling nodes"));
        }
        let mut map = Self {
            heights,
            places,
            loads: loads.iter().map(|load| load.ln()).collect(),
            ends: Vec::new(),
            patches: Vec::new(),
            errors,
        };
        for patch in nodes.iter().flat_map(|node| &node.loads) {
            for patch in patch {
                map.patches.push(Prepared::new(patch, table, poisson)?);
            }
            map.ends.push(map.patches.len());
        }
        Ok(map)
    }

    /// The heights.
    #[must_use]
    pub fn heights(&self) -> &Heights {
        &self.heights
    }

    /// Places (m) of its rolling nodes.
    #[must_use]
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// Errors between rolling nodes.
    #[must_use]
    pub fn errors(&self) -> &[CellError] {
        &self.errors
    }

    /// Vertical loads (N) of its rolling nodes.
    pub fn loads(&self) -> impl Iterator<Item = f64> {
        self.loads.iter().map(|load| load.exp())
    }

    /// The contacts of a node under a load.
    pub fn patches(&self, node: usize, load: usize) -> impl Iterator<Item = &Patch> {
        self.record(node, load).iter().map(|prepared| &prepared.patch)
    }

    /// First and last place (m) of the map.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        let [low, high] = self.heights.range();
        let [first, last] = [self.places.first(), self.places.last()];
        [first.map_or(low, |first| first.max(low)), last.map_or(high, |last| last.min(high))]
    }

    fn record(&self, node: usize, load: usize) -> &[Prepared] {
        let record = node * self.loads.len() + load;
        let first = record.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.patches[first..self.ends[record]]
    }

    /// What the wheel does where it is placed, at the height there.
    pub(crate) fn act<S: Scalar>(
        &self,
        table: &Table,
        placed: &Placed<S>,
        asked: &WheelsetState<S>,
    ) -> Result<WheelActs<S>, MapError> {
        match self.heights.load(placed)? {
            Some([load, place]) => self.act_under(table, place, load, asked),
            None => Ok(WheelActs::nothing()),
        }
    }

    /// What it does at a place under a load: forces of neighbouring nodes, blended.
    pub(crate) fn act_under<S: Scalar>(
        &self,
        table: &Table,
        place: S,
        load: S,
        asked: &WheelsetState<S>,
    ) -> Result<WheelActs<S>, MapError> {
        let outside = |quantity, value: f64, low: f64, high: f64| {
            let inside = (low..=high).contains(&value);
            inside.then_some(()).ok_or(MapError::Outside { quantity, value, low, high })
        };
        let [low, high] = self.range();
        outside(Quantity::Place, place.value(), low, high)?;
        let log = load.ln();
        let ends = [self.loads.first(), self.loads.last()].map(|end| end.map_or(0.0, |l| l.exp()));
        let value = load.value();
        outside(Quantity::Load, value, ends[0] * (1.0 - 1e-9), ends[1] * (1.0 + 1e-9))?;
        let by_place = Hermite::at(&self.places, place);
        let by_load = Hermite::at(&self.loads, log);
        let mut acts = WheelActs { error: self.errors[by_place.first], ..WheelActs::nothing() };
        let mut weights = [0.0; PLACES];
        let one = S::constant(1.0);
        let nodes = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[k, l]: [usize; 2]| {
            let record = self.record(by_place.first + k, by_load.first + l);
            let from = From::new(by_place.away[k], by_load.away[l]);
            (by_place.weights[k] * by_load.weights[l], record, from)
        });
        let mut add = |acting: &PatchForces<S>, weight: S, slot: usize| {
            acts.add(acting, weight);
            let slot = slot.min(PLACES - 1);
            weights[slot] += acts.reports[slot].add(&acting.report, weight.value());
        };
        let count = nodes[0].1.len();
        if nodes.iter().all(|(_, record, _)| record.len() == count) {
            for slot in 0..count {
                let shares = nodes.map(|(weight, record, from)| (weight, &record[slot], from));
                add(&PatchForces::of(&shares, table, asked), one, slot);
            }
        } else {
            // Nodes of one plane and of two: each acts where it has its own.
            for (weight, record, from) in nodes {
                for (slot, patch) in record.iter().enumerate() {
                    add(&PatchForces::of(&[(one, patch, from)], table, asked), weight, slot);
                }
            }
        }
        for (report, weight) in acts.reports.iter_mut().zip(weights) {
            report.mean(weight);
        }
        acts.load = load;
        acts.force = acts.force.map(|force| force * load);
        acts.moment = acts.moment.map(|moment| moment * load);
        acts.axle = acts.axle * load;
        Ok(acts)
    }
}

impl<S: Scalar> WheelActs<S> {
    fn add(&mut self, acting: &PatchForces<S>, weight: S) {
        for k in 0..3 {
            self.force[k] = self.force[k] + acting.force[k] * weight;
            self.moment[k] = self.moment[k] + acting.moment[k] * weight;
        }
        self.axle = self.axle + acting.axle * weight;
    }
}

impl Report {
    /// Adds a neighbour's: forces by its weight, the rest also by its share of the load. Gives the weight
    /// of the rest.
    fn add(&mut self, other: &Self, weight: f64) -> f64 {
        let of = weight * other.share;
        let add = |to: &mut [f64; 3], from: [f64; 3], weight: f64| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to += weight * from);
        };
        self.share += of;
        add(&mut self.friction, other.friction, weight);
        add(&mut self.reference, other.reference, of);
        add(&mut self.creepage, other.creepage, of);
        self.angle += of * other.angle;
        self.peak_pressure += of * other.peak_pressure;
        self.area += weight * other.area;
        of
    }

    fn mean(&mut self, weight: f64) {
        if weight <= 0.0 {
            return;
        }
        let per = weight.recip();
        self.reference = self.reference.map(|part| part * per);
        self.creepage = self.creepage.map(|part| part * per);
        self.angle *= per;
        self.peak_pressure *= per;
    }
}
