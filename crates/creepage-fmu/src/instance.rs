//! Instance of the FMU: what answers, its inputs, and the outputs that follow from them.

use creepage_map::{HeightOrLoad, State};

use crate::contacts::{AnswerError, Contacts};
use crate::variables::{INPUTS, OUTPUTS, SWITCHES};

/// Bytes of a saved state.
pub(crate) const STATE_BYTES: usize = 8 * (INPUTS + 1) + SWITCHES.len();

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
    contacts: Contacts,
    pub(crate) inputs: Inputs,
    outputs: Option<[f64; OUTPUTS]>,
    caution: Option<String>,
}

impl Instance {
    pub(crate) fn new(contacts: Contacts) -> Self {
        let inputs = Inputs::start(&contacts);
        Self { contacts, inputs, outputs: None, caution: None }
    }

    pub(crate) fn reset(&mut self) {
        self.set_inputs(Inputs::start(&self.contacts));
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
    pub(crate) fn real(&mut self, place: usize) -> Result<f64, AnswerError> {
        match self.inputs.reals.get(place) {
            Some(input) => Ok(*input),
            None => Ok(self.outputs()?[place - INPUTS]),
        }
    }

    /// Outputs of the present inputs, computed once.
    pub(crate) fn outputs(&mut self) -> Result<[f64; OUTPUTS], AnswerError> {
        if let Some(outputs) = self.outputs {
            return Ok(outputs);
        }
        let (outputs, caution) = self.contacts.answer(&self.inputs.state())?;
        (self.outputs, self.caution) = (Some(outputs), caution);
        Ok(outputs)
    }

    /// The caution of outputs that were computed since it was last taken.
    pub(crate) fn take_caution(&mut self) -> Option<String> {
        self.caution.take()
    }

    /// Change of outputs with a direction of the inputs, by central differences: steps in parts of what each input
    /// counts in, large beside what the search for a free roll and pitch rate leaves. With the caution of either state.
    pub(crate) fn derivative(
        &self,
        outputs_wanted: &[usize],
        direction: &[(usize, f64)],
    ) -> Result<(Vec<f64>, Option<String>), AnswerError> {
        const SCALES: [f64; INPUTS] =
            [1e-3, 1e-5, 1e-3, 1e-3, 1e4, 1.0, 1.0, 1e-2, 1e-2, 1e-2, 1e-2, 0.1];
        let size = |(place, seed): &(usize, f64)| (seed / SCALES[*place]).abs();
        let largest = direction.iter().map(size).fold(0.0, f64::max);
        // No direction, or one that is no number.
        if largest.is_nan() || largest <= 0.0 {
            return Ok((vec![0.0; outputs_wanted.len()], None));
        }
        let step = self.contacts.step() / largest;
        let at = |step: f64| {
            let mut inputs = self.inputs;
            for (place, seed) in direction {
                inputs.reals[*place] += step * seed;
            }
            self.contacts.answer(&inputs.state())
        };
        let ((ahead, caution), (behind, caution_behind)) = (at(step)?, at(-step)?);
        let change = |place: &usize| (ahead[*place] - behind[*place]) / (2.0 * step);
        Ok((outputs_wanted.iter().map(change).collect(), caution.or(caution_behind)))
    }
}

impl Inputs {
    /// The wheelset's own state.
    fn start(contacts: &Contacts) -> Self {
        let (own, radius) = contacts.own();
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
            own.pitch_rate.unwrap_or(own.speed / radius),
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
