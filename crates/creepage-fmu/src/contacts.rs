//! What answers in an instance: a contact map, or the solver of the wheelset's file.

use creepage_map::{Answer, ContactMap, MapError, PatchAnswer, State, WheelAnswer};
use creepage_study::{WheelsetError, WheelsetFileError};

use crate::resources::{MAP, Resources, WHEELSET};
use crate::solver::Solver;
use crate::variables::OUTPUTS;

/// A contact map or the solver.
#[derive(Debug)]
pub(crate) enum Contacts {
    Map(Box<ContactMap>),
    Solver(Box<Solver>),
}

/// Error of a resource, or of what it describes.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ContactsError {
    /// Bytes that are not those of a map.
    #[error(transparent)]
    Map(#[from] MapError),
    /// A wheelset file that makes no sense.
    #[error(transparent)]
    Wheelset(#[from] WheelsetFileError),
    /// What the inputs of the FMU cannot say.
    #[error("{what}: not in an FMU, which has no input for it; leave it out")]
    NotInFmu {
        /// The keys.
        what: &'static str,
    },
    /// The solver's thread cannot be had.
    #[error("the solver's thread cannot be started: {0}")]
    Thread(#[from] rayon::ThreadPoolBuildError),
    /// A file of the resources cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: std::path::PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Other resources than those of the description.
    #[error("the resources have the token {found}, the description {expected}")]
    Token {
        /// That of the resources.
        found: String,
        /// That of the description.
        expected: String,
    },
}

/// Error of an answer.
#[derive(Debug, thiserror::Error)]
pub(crate) enum AnswerError {
    #[error(transparent)]
    Map(#[from] MapError),
    #[error(transparent)]
    Wheelset(#[from] WheelsetError),
    #[error(transparent)]
    File(#[from] WheelsetFileError),
}

/// Outputs, and a caution in words.
pub(crate) type Answered = ([f64; OUTPUTS], Option<String>);

impl Contacts {
    /// Of the resources of an FMU.
    pub(crate) fn open(resources: &Resources) -> Result<Self, ContactsError> {
        if let Some(map) = resources.get(MAP) {
            return Ok(Self::Map(Box::new(ContactMap::from_bytes(map.to_vec())?)));
        }
        let text = String::from_utf8_lossy(resources.get(WHEELSET).unwrap_or_default());
        Ok(Self::Solver(Box::new(Solver::new(&text, resources.folder())?)))
    }

    /// The state that the wheelset's file has, and the nominal radius of its wheels (m).
    pub(crate) fn own(&self) -> (State, f64) {
        match self {
            Self::Map(map) => (map.head().own, map.head().radius),
            Self::Solver(solver) => (solver.own(), solver.radius()),
        }
    }

    /// Step of differences, in parts of what an input counts in: the map is smooth, the solver errs by what its
    /// elements do.
    pub(crate) fn step(&self) -> f64 {
        match self {
            Self::Map(_) => 1e-2,
            Self::Solver(_) => 1e-1,
        }
    }

    pub(crate) fn answer(&self, state: &State) -> Result<Answered, AnswerError> {
        match self {
            Self::Map(map) => Ok((outputs(&map.solve(state)?), None)),
            Self::Solver(solver) => solver.answer(state),
        }
    }
}

/// Outputs of a map's answer, in the order of the variables.
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
