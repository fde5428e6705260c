//! Error of a map, measured on states drawn afresh: each solved by the full theory.

use creepage_wheelset::{Load, PitchRate, SolvedWheel, WheelsetPose, WheelsetVelocity};
use std::sync::atomic::{AtomicUsize, Ordering};

use creepage_map::{CellError, ContactMap, HeightOrLoad, MapAccuracy, Spread, State, WheelAnswer};
use creepage_rail::Side;
use rayon::prelude::*;

use super::{Builder, MapBuildError, MapStage, Wheel};

/// Error of the map at one fresh state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Missed {
    is_transition: bool,
    /// Tangential force, normal force, whole force.
    errors: [f64; 3],
}

/// Roll beyond the free one (rad), creepage along and across, yaw rate over speed (1/m): largest of the draw.
const ROLL: f64 = 5e-4;
const CREEPAGE: f64 = 4e-3;
const TURN: f64 = 5e-3;
/// Most draws of one state.
const MAX_DRAWS: usize = 16;

impl Builder<'_> {
    /// The errors of each cell of a wheel; every state is added to `all`.
    pub(super) fn measure(
        &self,
        map: &ContactMap,
        (side, wheel): (Side, &Wheel),
        all: &mut Vec<Missed>,
    ) -> Result<Vec<CellError>, MapBuildError> {
        let cells = wheel.y.len() - 1;
        let total = cells * self.plan.states;
        let done = AtomicUsize::new(0);
        let one = |cell: usize| -> Result<Vec<Missed>, MapBuildError> {
            let (low, high) = (wheel.y[cell], wheel.y[cell + 1]);
            let is_transition = high - low <= self.plan.transition();
            let mut missed = Vec::new();
            for k in 0..self.plan.states {
                let mut random = Random::of(side, cell, k);
                // Roll and yaw may take a state out of a map: another is drawn in its place.
                for _ in 0..MAX_DRAWS {
                    let y = low + (high - low) * random.next();
                    if let Some(errors) = self.state(map, (side, y), &mut random)? {
                        missed.push(Missed { is_transition, errors });
                        break;
                    }
                }
                let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                self.goes_on(MapStage::States(done, total))?;
            }
            Ok(missed)
        };
        let found = (0..cells).into_par_iter().map(one).collect::<Result<Vec<_>, _>>()?;
        let cell = |missed: &Vec<Missed>| {
            let worst = |k: usize| missed.iter().map(|m| m.errors[k]).fold(0.0, f64::max);
            CellError { states: missed.len(), tangential: worst(0), normal: worst(1) }
        };
        let errors = found.iter().map(cell).collect();
        all.extend(found.into_iter().flatten());
        Ok(errors)
    }

    /// What the map misses of a state at `y` of the image; `None` where that lies outside the map.
    fn state(
        &self,
        map: &ContactMap,
        (side, y): (Side, f64),
        random: &mut Random,
    ) -> Result<Option<[f64; 3]>, MapBuildError> {
        let (image, plan, sense) = (self.image(side), self.plan, side.sense());
        let [least, most] = plan.friction;
        let [light, heavy] = [plan.loads.first(), plan.loads.last()]
            .map(|load| load.copied().unwrap_or(f64::NAN).ln());
        let load = (light + (heavy - light) * (0.1 + 0.8 * random.next())).exp();
        let state = State {
            y: sense * y,
            yaw: plan.yaw * random.both(),
            roll: Some(sense * (image.free_roll(y)? + ROLL * random.both())),
            pressed: HeightOrLoad::Height(0.0),
            speed: 20.0,
            pitch_rate: None,
            lateral_velocity: 0.0,
            vertical_velocity: 0.0,
            roll_rate: 0.0,
            yaw_rate: 20.0 * TURN * random.both(),
            friction: least + (most - least) * random.next(),
        };
        let own =
            if side == Side::Right { creepage_map::Side::Right } else { creepage_map::Side::Left };
        let Ok([z, _]) = map.height_under(own, &state, load) else { return Ok(None) };
        let mut state = State { pressed: HeightOrLoad::Height(z), ..state };
        let creepages = [CREEPAGE * random.both(), CREEPAGE * random.both()];
        // Creepage is drawn about that of rolling without any: by one look at the map.
        let mut nominal = State { pitch_rate: Some(state.speed / self.head.radius), ..state };
        for _ in 0..2 {
            let Ok(wheel) = map.solve_wheel(own, &nominal) else { return Ok(None) };
            let [along, across, _] = wheel.patches[0].creepage;
            let rate = nominal.pitch_rate.unwrap_or(0.0);
            nominal.pitch_rate = Some(rate * (1.0 + along - creepages[0]));
            nominal.lateral_velocity += state.speed * (creepages[1] - across);
        }
        state = nominal;
        let Ok(wheel) = map.solve_wheel(own, &state) else { return Ok(None) };
        Ok(self.exact(side, &state).map(|solved| missed(&wheel, &solved, state.friction)))
    }

    fn exact(&self, side: Side, state: &State) -> Option<SolvedWheel> {
        let solver = self.solver.with_friction(state.friction);
        let HeightOrLoad::Height(z) = state.pressed else { return None };
        let stance = WheelsetPose {
            side: Some(side),
            y: state.y,
            yaw: state.yaw,
            roll: state.roll,
            load: Some(Load::Height(z)),
        };
        let travel = WheelsetVelocity {
            speed: state.speed,
            pitch: PitchRate::Rigid(state.pitch_rate),
            lateral_velocity: state.lateral_velocity,
            yaw_rate: state.yaw_rate,
            ..WheelsetVelocity::default()
        };
        // A state that the full theory does not solve tells nothing of the map.
        let solved = solver.solve(&stance, &travel).ok()?;
        if side == Side::Right { solved.right } else { solved.left }
    }
}

/// Errors of tangential, normal and whole force.
fn missed(wheel: &WheelAnswer, solved: &SolvedWheel, friction: f64) -> [f64; 3] {
    let (mut load, mut tangential) = (0.0, [0.0; 3]);
    for contact in solved.contacts() {
        let (sin, cos) = contact.angle.sin_cos();
        load += contact.load();
        let force = contact.force;
        let parts = [force.longitudinal, force.lateral * cos, force.lateral * sin];
        tangential = [0, 1, 2].map(|k: usize| tangential[k] + parts[k]);
    }
    // Where one of both hangs in the air, all is missed.
    let found: f64 = wheel.patches.iter().map(|patch| patch.normal_force).sum();
    if load <= 0.0 || found <= 0.0 {
        return if load.max(found) > 0.0 { [1.0; 3] } else { [0.0; 3] };
    }
    let own = super::refine::friction(wheel);
    let length = |a: [f64; 3]| a.iter().map(|part| part * part).sum::<f64>().sqrt();
    let apart = |a: [f64; 3], b: [f64; 3]| length([0, 1, 2].map(|k: usize| a[k] - b[k]));
    [
        apart(own, tangential.map(|part| part / load)) / friction,
        (found / load - 1.0).abs(),
        apart(wheel.force, solved.on_rail().force) / (friction * load),
    ]
}

/// The distribution of all errors: away from places where areas join, and there.
pub(super) fn accuracy(all: &[Missed]) -> MapAccuracy {
    let spread = |kind: usize| {
        [false, true].map(|is_transition| {
            let own = all.iter().filter(|missed| missed.is_transition == is_transition);
            let mut errors: Vec<f64> = own.map(|missed| missed.errors[kind]).collect();
            errors.sort_by(f64::total_cmp);
            let states = errors.len();
            let at = |part: f64| {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 0 to states
                let k = (part * states as f64) as usize;
                errors.get(k.min(states.saturating_sub(1))).copied().unwrap_or(0.0)
            };
            let squares = errors.iter().fold(0.0, |sum, error| sum + error * error);
            let rms = (squares / states.max(1) as f64).sqrt();
            Spread { states, rms, median: at(0.5), p95: at(0.95), worst: at(1.0) }
        })
    };
    MapAccuracy { tangential: spread(0), normal: spread(1), total: spread(2) }
}

/// `SplitMix64` (Steele, Lea, Flood 2014): the same states in every build.
struct Random(u64);

impl Random {
    fn of(side: Side, cell: usize, state: usize) -> Self {
        let side = u64::from(side == Side::Right);
        Self(1967 + 4 * cell as u64 + 2 * (state as u64) * 1_000_003 + side)
    }

    /// Between 0 and 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((bits ^ (bits >> 31)) >> 11) as f64) / (1_u64 << 53) as f64
    }

    /// Between -1 and 1.
    fn both(&mut self) -> f64 {
        2.0 * self.next() - 1.0
    }
}
