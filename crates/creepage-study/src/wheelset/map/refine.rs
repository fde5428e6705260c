//! Refinement of a map: rolling nodes along a wheel's places, halved until the middle of each cell is met.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use creepage_map::{
    CellError, HeightOrLoad, Heights, Patch, RollingNode, State, WheelAnswer, WheelMap,
    interpolated, slopes,
};
use creepage_rail::Side;
use rayon::prelude::*;

use super::{Builder, MapBuildError, MapPlan, MapStage};

/// A rolling node with its `y` (m) and the height (m) under each load.
#[derive(Debug, Clone)]
pub(super) struct Rolled {
    pub(super) y: f64,
    pub(super) roll: f64,
    pub(super) z: Vec<f64>,
    pub(super) node: RollingNode,
    /// Slopes by place of share, angle, y and z of all contacts, by load; none where contacts come or go.
    slopes: Vec<f64>,
}

/// How far beside a node (m) it is pressed again, for the slopes of its geometry.
const DIFFERENCE_STEP: f64 = 2e-5;

/// Solved nodes of a wheel, by `y` in steps.
type SolvedNodes = Mutex<BTreeMap<i64, Rolled>>;

impl Builder<'_> {
    /// The rolling nodes between two `y` (m) of the image.
    pub(super) fn rolling(
        &self,
        side: Side,
        [first, last]: [f64; 2],
        heights: &Heights,
    ) -> Result<(Vec<f64>, Vec<RollingNode>), MapBuildError> {
        let [wide, narrow] = self.plan.widths;
        // Cells are the narrowest ones times powers of two.
        let mut halves = 0_u32;
        while narrow * f64::from(1 << halves) < 0.75 * wide && halves < 12 {
            halves += 1;
        }
        let step = wide / f64::from(1 << halves);
        let whole = 1_i64 << halves;
        #[allow(clippy::cast_possible_truncation)] // some thousand at most
        let ends = [(first / wide).ceil() as i64, (last / wide).floor() as i64];
        if ends[1] - ends[0] < 2 {
            return Err(MapBuildError::Short { places: 0 });
        }
        let count = AtomicUsize::new(0);
        let found: SolvedNodes = Mutex::default();
        let node = |key: i64| -> Result<Rolled, MapBuildError> {
            let rolled = self.rolled((side, key), key as f64 * step, heights)?;
            let done = count.fetch_add(1, Ordering::Relaxed) + 1;
            let all = (ends[1] - ends[0]) as f64;
            self.goes_on(MapStage::Nodes(done, (done as f64 / (2.0 * all)).min(1.0)))?;
            if let Ok(mut found) = found.lock() {
                found.insert(key, rolled.clone());
            }
            Ok(rolled)
        };
        let coarse = (ends[0]..=ends[1]).into_par_iter().map(|k| node(k * whole));
        let coarse = coarse.collect::<Result<Vec<_>, _>>()?;
        let cells = coarse.windows(2).enumerate().collect::<Vec<_>>();
        cells.into_par_iter().try_for_each(|(k, pair)| {
            let low = (ends[0] + i64::try_from(k).unwrap_or(0)) * whole;
            self.halve([low, low + whole], [&pair[0], &pair[1]], heights, &node)
        })?;
        let found = found.into_inner().unwrap_or_default();
        let y = found.values().map(|rolled| rolled.y).collect();
        let nodes = self.sloped(&found.values().collect::<Vec<_>>())?;
        Ok((y, nodes))
    }

    /// Adds the middle of a cell, and goes on in both halves where it was not met.
    fn halve(
        &self,
        [low, high]: [i64; 2],
        ends: [&Rolled; 2],
        heights: &Heights,
        node: &(dyn Fn(i64) -> Result<Rolled, MapBuildError> + Sync),
    ) -> Result<(), MapBuildError> {
        if high - low < 2 {
            return Ok(());
        }
        let middle = i64::midpoint(low, high);
        let rolled = node(middle)?;
        if self.missed(ends, &rolled, heights)? <= self.plan.tolerance {
            return Ok(());
        }
        let (one, other) = rayon::join(
            || self.halve([low, middle], [ends[0], &rolled], heights, node),
            || self.halve([middle, high], [&rolled, ends[1]], heights, node),
        );
        one.and(other)
    }

    fn rolled(
        &self,
        (side, key): (Side, i64),
        y: f64,
        heights: &Heights,
    ) -> Result<Rolled, MapBuildError> {
        let place = self.place(side, y)?;
        let along = y - self.head.radius * place.roll;
        let z =
            self.plan.loads.iter().map(|load| height(heights, along, *load)).collect::<Vec<_>>();
        let loads = self.journal.node((side, key), || {
            let each = self.plan.loads.par_iter().zip(&z);
            let of = (&*self.table, self.head.poisson);
            each.map(|(load, z)| place.patches(&self.solver, of, [*load, *z])).collect()
        })?;
        let slopes =
            self.journal.slopes((side, key), || self.beside(side, (y, &loads), heights))?;
        let node = RollingNode { place: along, loads };
        Ok(Rolled { y, roll: place.roll, z, node, slopes })
    }

    /// Nodes with their slopes: of the geometry as pressed beside them, else as neighbours have it.
    fn sloped(&self, rolled: &[&Rolled]) -> Result<Vec<RollingNode>, MapBuildError> {
        let mut nodes: Vec<RollingNode> = rolled.iter().map(|one| one.node.clone()).collect();
        let of = (&*self.table, self.head.poisson);
        slopes(&mut nodes, &self.plan.loads, self.head.radius, of)?;
        for (node, rolled) in nodes.iter_mut().zip(rolled) {
            let own = rolled.slopes.as_chunks::<4>().0;
            for (patch, [share, angle, y, z]) in node.loads.iter_mut().flatten().zip(own) {
                let parts = [&mut patch.share, &mut patch.angle, &mut patch.y, &mut patch.z];
                for (part, slope) in parts.into_iter().zip([share, angle, y, z]) {
                    if slope.is_finite() {
                        part.by_place = *slope;
                    }
                }
            }
        }
        Ok(nodes)
    }

    /// The geometry's slopes by place: pressed on both sides of a node, at the heights of its loads.
    fn beside(
        &self,
        side: Side,
        (y, loads): (f64, &[Vec<Patch>]),
        heights: &Heights,
    ) -> Result<Vec<f64>, MapBuildError> {
        let places =
            [self.place(side, y - DIFFERENCE_STEP)?, self.place(side, y + DIFFERENCE_STEP)?];
        let along = places.each_ref().map(|place| place.y - self.head.radius * place.roll);
        let inside = |place: f64| (heights.range()[0]..=heights.range()[1]).contains(&place);
        let mut all = Vec::new();
        for (patches, load) in loads.iter().zip(&self.plan.loads) {
            let count = patches.len();
            let geometry = |k: usize| -> Result<Option<Vec<[f64; 4]>>, MapBuildError> {
                if !inside(along[k]) {
                    return Ok(None);
                }
                let z = height(heights, along[k], *load);
                places[k].geometry(&self.solver, z, count)
            };
            let none = vec![[f64::NAN; 4]; count];
            let [before, after] =
                [geometry(0)?, geometry(1)?].map(|one| one.unwrap_or_else(|| none.clone()));
            let step = along[1] - along[0];
            for (one, other) in before.iter().zip(&after) {
                all.extend([0, 1, 2, 3].map(|k: usize| (other[k] - one[k]) / step));
            }
        }
        Ok(all)
    }

    /// By how much the forces of the two ends of a cell miss those of its middle, in parts of `mu N`.
    fn missed(
        &self,
        ends: [&Rolled; 2],
        middle: &Rolled,
        heights: &Heights,
    ) -> Result<f64, MapBuildError> {
        let loads = &self.plan.loads;
        let map = |nodes: &[&Rolled]| -> Result<WheelMap, MapBuildError> {
            let nodes = self.sloped(nodes)?;
            let errors = vec![CellError::default(); nodes.len() - 1];
            let of = (&*self.table, self.head.poisson);
            Ok(WheelMap::new(heights.clone(), &nodes, loads, errors, of)?)
        };
        let (without, with) = (map(&ends)?, map(&[ends[0], middle])?);
        let mut worst = 0.0_f64;
        for (load, z) in loads.iter().zip(&middle.z) {
            for state in motions(middle, *z, self.head.radius) {
                let of = (&self.head, &*self.table);
                let at = [middle.node.place, *load];
                let [found, right] = [&without, &with].map(|map| map.forces_under(of, &state, at));
                let (found, right) = (friction(&found?), friction(&right?));
                let miss = (0..3).map(|k| (found[k] - right[k]).powi(2)).sum::<f64>().sqrt();
                worst = worst.max(miss / state.friction);
            }
        }
        Ok(worst)
    }
}

/// Friction over the normal force, by track axes.
pub(super) fn friction(wheel: &WheelAnswer) -> [f64; 3] {
    let mut sum = [0.0; 3];
    let mut load = 0.0;
    for patch in &wheel.patches {
        let (sin, cos) = patch.angle.sin_cos();
        let [x, s, _] = patch.friction;
        for (sum, part) in sum.iter_mut().zip([x, s * cos, s * sin]) {
            *sum += part;
        }
        load += patch.normal_force;
    }
    sum.map(|part| part / load)
}

/// Height (m) under a load at a place: as the map has it.
fn height(heights: &Heights, place: f64, load: f64) -> f64 {
    let power = |load: f64| (load * load).cbrt();
    let powers: Vec<f64> = heights.loads().iter().map(|load| power(*load)).collect();
    let places: Vec<f64> = heights.nodes().iter().map(|node| node.place).collect();
    let at = |k: usize| {
        let column: Vec<f64> = heights.nodes().iter().map(|node| node.heights[k]).collect();
        interpolated(&places, &column, place)
    };
    let column: Vec<f64> = (0..powers.len()).map(at).collect();
    interpolated(&powers, &column, power(load))
}

/// Motions by which a cell is judged: pure rolling, and creepage along and across.
fn motions(middle: &Rolled, z: f64, radius: f64) -> impl Iterator<Item = State> {
    const FRICTION: f64 = 0.3;
    const CREEPAGE: f64 = 1.2e-3;
    let reference = middle.node.loads.first().and_then(|patches| patches.first());
    let rolling = reference.map_or(radius, |patch| patch.z.value - (z - radius));
    let state = State {
        y: middle.y,
        yaw: 0.0,
        roll: Some(middle.roll),
        pressed: HeightOrLoad::Height(z),
        speed: 1.0,
        pitch_rate: Some(1.0 / rolling),
        lateral_velocity: 0.0,
        vertical_velocity: 0.0,
        roll_rate: 0.0,
        yaw_rate: 0.0,
        friction: FRICTION,
    };
    [[0.0, 0.0], [1.0, 0.0], [-1.0, 0.5], [0.0, 1.0], [0.0, -1.0]].into_iter().map(move |[x, y]| {
        State {
            pitch_rate: Some((1.0 - CREEPAGE * x) / rolling),
            lateral_velocity: CREEPAGE * y,
            ..state
        }
    })
}

impl MapPlan {
    /// Cells up to this width (m) lie where areas join.
    pub(super) fn transition(&self) -> f64 {
        0.3 * self.widths[0]
    }
}
