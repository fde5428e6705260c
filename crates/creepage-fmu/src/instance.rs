//! Instance of the FMU: a map, its inputs, and the outputs that follow from them.

use std::sync::Arc;

use creepage_map::{Answer, ContactMap, HeightOrLoad, MapError, PatchAnswer, State, WheelAnswer};

use crate::variables::{INPUTS, OUTPUTS, SWITCHES};

/// Bytes of a saved state.
pub(crate) const STATE_BYTES: usize = 8 * (INPUTS + 1) + SWITCHES.len();

/// Error of making an instance.
#[derive(Debug, thiserror::Error)]
pub(crate) enum InstanceError {
    #[error("cannot read {path}: {source}")]
    Read { path: String, source: std::io::Error },
    #[error("the map in the resources has the token {found}, the description {expected}")]
    Token { found: String, expected: String },
    #[error(transparent)]
    Map(#[from] MapError),
}

/// Inputs from outside: all that an instance remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inputs {
    pub(crate) reals: [f64; INPUTS],
    pub(crate) switches: [bool; SWITCHES.len()],
    pub(crate) time: f64,
}

/// An instance of the FMU.
#[derive(Debug)]
pub(crate) struct Instance {
    map: Arc<ContactMap>,
    pub(crate) inputs: Inputs,
    outputs: Option<[f64; OUTPUTS]>,
}

/// The token that binds a description to its map.
pub(crate) fn token(map: &[u8]) -> String {
    // A GUID's form, of a checksum and the length.
    let (sum, length) = (crc32fast::hash(map), map.len() as u64);
    format!("{{{sum:08x}-0000-4000-8000-{length:012x}}}")
}

impl Instance {
    pub(crate) fn open(path: &str, expected: &str) -> Result<Self, InstanceError> {
        let read = |source| InstanceError::Read { path: path.into(), source };
        let bytes = std::fs::read(path).map_err(read)?;
        let found = token(&bytes);
        if found != expected {
            return Err(InstanceError::Token { found, expected: expected.into() });
        }
        Ok(Self::new(Arc::new(ContactMap::from_bytes(bytes)?)))
    }

    pub(crate) fn new(map: Arc<ContactMap>) -> Self {
        let inputs = Inputs::start(&map);
        Self { map, inputs, outputs: None }
    }

    pub(crate) fn reset(&mut self) {
        self.inputs = Inputs::start(&self.map);
        self.outputs = None;
    }

    pub(crate) fn set_real(&mut self, place: usize, value: f64) -> bool {
        let Some(input) = self.inputs.reals.get_mut(place) else { return false };
        *input = value;
        self.outputs = None;
        true
    }

    pub(crate) fn set_switch(&mut self, place: usize, value: bool) {
        self.inputs.switches[place] = value;
        self.outputs = None;
    }

    pub(crate) fn set_inputs(&mut self, inputs: Inputs) {
        self.inputs = inputs;
        self.outputs = None;
    }

    /// The number at a place among all.
    pub(crate) fn real(&mut self, place: usize) -> Result<f64, MapError> {
        match self.inputs.reals.get(place) {
            Some(input) => Ok(*input),
            None => Ok(self.outputs()?[place - INPUTS]),
        }
    }

    /// Outputs of the present inputs, computed once.
    pub(crate) fn outputs(&mut self) -> Result<[f64; OUTPUTS], MapError> {
        if let Some(outputs) = self.outputs {
            return Ok(outputs);
        }
        let outputs = outputs(&self.map.solve(&self.inputs.state())?);
        self.outputs = Some(outputs);
        Ok(outputs)
    }

    /// Change of outputs with a direction of the inputs, by central differences of the map, which is smooth:
    /// steps of a hundredth of what each input counts in, large beside what the search for a free roll and pitch
    /// rate leaves.
    pub(crate) fn derivative(
        &self,
        outputs_wanted: &[usize],
        direction: &[(usize, f64)],
    ) -> Result<Vec<f64>, MapError> {
        const SCALES: [f64; INPUTS] =
            [1e-3, 1e-5, 1e-3, 1e-3, 1e4, 1.0, 1.0, 1e-2, 1e-2, 1e-2, 1e-2, 0.1];
        const PART: f64 = 1e-2;
        let size = |(place, seed): &(usize, f64)| (seed / SCALES[*place]).abs();
        let largest = direction.iter().map(size).fold(0.0, f64::max);
        // No direction, or one that is no number.
        if largest.is_nan() || largest <= 0.0 {
            return Ok(vec![0.0; outputs_wanted.len()]);
        }
        let step = PART / largest;
        let at = |step: f64| {
            let mut inputs = self.inputs;
            for (place, seed) in direction {
                inputs.reals[*place] += step * seed;
            }
            Ok::<_, MapError>(outputs(&self.map.solve(&inputs.state())?))
        };
        let (ahead, behind) = (at(step)?, at(-step)?);
        let change = |place: &usize| (ahead[*place] - behind[*place]) / (2.0 * step);
        Ok(outputs_wanted.iter().map(change).collect())
    }
}

impl Inputs {
    /// The wheelset's own state.
    fn start(map: &ContactMap) -> Self {
        let own = map.head().own;
        let (z, load) = match own.pressed {
            HeightOrLoad::Height(z) => (z, 0.0),
            HeightOrLoad::AxleLoad(load) => (0.0, load),
        };
        let reals = [
            own.y,
            z,
            own.roll.unwrap_or(0.0),
            own.yaw,
            load,
            own.speed,
            own.pitch_rate.unwrap_or(own.speed / map.head().radius),
            own.lateral_velocity,
            own.vertical_velocity,
            own.roll_rate,
            own.yaw_rate,
            own.friction,
        ];
        let switches = [matches!(own.pressed, HeightOrLoad::Height(_)), own.pitch_rate.is_none()];
        Self { reals, switches, time: 0.0 }
    }

    fn state(&self) -> State {
        let [y, z, roll, yaw, load, speed, rate, lateral, vertical, roll_rate, yaw_rate, friction] =
            self.reals;
        let [by_height, pitch_free] = self.switches;
        State {
            y,
            yaw,
            roll: by_height.then_some(roll),
            pressed: if by_height { HeightOrLoad::Height(z) } else { HeightOrLoad::AxleLoad(load) },
            speed,
            pitch_rate: (!pitch_free).then_some(rate),
            lateral_velocity: lateral,
            vertical_velocity: vertical,
            roll_rate,
            yaw_rate,
            friction,
        }
    }

    pub(crate) fn to_bytes(self) -> [u8; STATE_BYTES] {
        let mut bytes = [0; STATE_BYTES];
        let numbers = self.reals.iter().chain([&self.time]).flat_map(|value| value.to_le_bytes());
        let switches = self.switches.iter().map(|switch| u8::from(*switch));
        bytes.iter_mut().zip(numbers.chain(switches)).for_each(|(to, from)| *to = from);
        bytes
    }

    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let bytes: &[u8; STATE_BYTES] = bytes.try_into().ok()?;
        let (numbers, switches) = bytes.split_at(8 * (INPUTS + 1));
        let mut reals = [0.0; INPUTS + 1];
        for (real, bytes) in reals.iter_mut().zip(numbers.as_chunks().0) {
            *real = f64::from_le_bytes(*bytes);
        }
        let [inputs @ .., time] = reals;
        let mut all = [false; SWITCHES.len()];
        all.iter_mut().zip(switches).for_each(|(to, from)| *to = *from != 0);
        Some(Self { reals: inputs, switches: all, time })
    }
}

/// The outputs of an answer, in the order of the variables.
fn outputs(answer: &Answer) -> [f64; OUTPUTS] {
    let wheels = [&answer.left, &answer.right];
    let mut all = [0.0; OUTPUTS];
    let sums: [f64; 2] =
        wheels.map(|wheel| wheel.patches.iter().map(|patch| patch.normal_force).sum());
    let creepages = wheels.map(|wheel| most_loaded(wheel).creepage);
    let heat: [f64; 2] =
        wheels.map(|wheel| wheel.patches.iter().map(PatchAnswer::dissipation).sum());
    let errors = wheels.map(|wheel| wheel.error.tangential);
    let counts: [f64; 2] = wheels.map(|wheel| {
        wheel.patches.iter().filter(|patch| patch.normal_force > 0.0).map(|_| 1.0).sum()
    });
    let found = [answer.z, answer.roll, answer.pitch_rate];
    let parts = answer.wrench.into_iter().chain(wheels.into_iter().flat_map(|wheel| wheel.force));
    let parts = parts.chain(sums).chain(creepages.into_iter().flatten()).chain(heat);
    let parts = parts.chain(found).chain(errors).chain(counts);
    all.iter_mut().zip(parts).for_each(|(to, from): (&mut f64, f64)| *to = from);
    all
}

fn most_loaded(wheel: &WheelAnswer) -> PatchAnswer {
    let patches = wheel.patches.iter().copied();
    let most = patches.max_by(|a, b| a.normal_force.total_cmp(&b.normal_force));
    most.unwrap_or_default()
}
