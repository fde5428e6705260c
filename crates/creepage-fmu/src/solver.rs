//! The wheelset solver in an instance: each answer from nothing, so that it is the same whatever was asked before.

use std::path::Path;
use std::sync::Mutex;
use std::thread::JoinHandle;

use creepage_map::{HeightOrLoad, State};
use creepage_study::{
    ASKED, Load, PitchRate, RailFriction, SolvedContact, SolvedWheel, SolvedWheelset, WheelsetCase,
    WheelsetError, WheelsetFile, WheelsetFileError, WheelsetPose, WheelsetVelocity, asked,
    wheelset_caution_words,
};
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::contacts::{AnswerError, Answered, ContactsError};
use crate::variables::OUTPUTS;

/// The wheelset of a file, and the thread that solves it.
#[derive(Debug)]
pub(crate) struct Solver {
    case: WheelsetCase,
    own: State,
    worker: Worker,
}

/// One thread, which has ended when this is dropped: a host may unload the library then.
#[derive(Debug)]
struct Worker {
    pool: Option<ThreadPool>,
    thread: Mutex<Option<JoinHandle<()>>>,
}

impl Worker {
    fn new() -> Result<Self, ContactsError> {
        let thread = Mutex::new(None);
        let spawn = |worker: rayon::ThreadBuilder| {
            let handle = std::thread::Builder::new().spawn(|| worker.run())?;
            if let Ok(mut place) = thread.lock() {
                *place = Some(handle);
            }
            Ok(())
        };
        let pool = ThreadPoolBuilder::new().num_threads(1).spawn_handler(spawn).build()?;
        Ok(Self { pool: Some(pool), thread })
    }

    fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // It ends when its pool is gone.
        self.pool = None;
        let thread = self.thread.get_mut().ok().and_then(Option::take);
        // A panic on it was that of some work, and told there.
        let _ = thread.map(JoinHandle::join);
    }
}

impl Solver {
    /// Of a wheelset's file, its profiles in `folder`.
    pub(crate) fn new(text: &str, folder: &Path) -> Result<Self, ContactsError> {
        let worker = Worker::new()?;
        let case = worker.run(|| {
            let file = WheelsetFile::read(text).map_err(WheelsetFileError::from)?;
            let case = file.case(folder)?;
            case.solver()?;
            Ok::<_, WheelsetFileError>(case)
        })?;
        let own = own(&case)?;
        Ok(Self { case, own, worker })
    }

    pub(crate) fn own(&self) -> State {
        self.own
    }

    pub(crate) fn radius(&self) -> f64 {
        self.case.running.wheelset().radius()
    }

    pub(crate) fn answer(&self, state: &State) -> Result<Answered, AnswerError> {
        let solved = self.worker.run(|| self.solve(state))?;
        let words = wheelset_caution_words(&solved).join("; ");
        Ok((outputs(&solved, self.radius()), (!words.is_empty()).then_some(words)))
    }

    fn solve(&self, state: &State) -> Result<SolvedWheelset, AnswerError> {
        let both = [(); 2].map(|()| RailFriction::Constant(state.friction));
        let case = WheelsetCase { friction: Some(both), ..self.case.clone() };
        let (pose, velocity) = self.posed(state)?;
        Ok(case.solver()?.solve(&pose, &velocity)?)
    }

    /// Position and motion of a state; all else is the file's own.
    fn posed(&self, state: &State) -> Result<(WheelsetPose, WheelsetVelocity), WheelsetError> {
        let load = match state.pressed {
            HeightOrLoad::Height(z) => Load::Height(z),
            HeightOrLoad::AxleLoad(load) => Load::Axle(load),
        };
        let travel = self.case.travel.unwrap_or_default();
        let pose = WheelsetPose {
            y: state.y,
            yaw: state.yaw,
            roll: state.roll,
            load: Some(load),
            ..self.case.stance
        };
        let velocity = WheelsetVelocity {
            speed: state.speed,
            pitch: match travel.pitch {
                PitchRate::Rigid(_) => PitchRate::Rigid(state.pitch_rate),
                PitchRate::Independent(_) => PitchRate::Independent([state.pitch_rate; 2]),
            },
            lateral_velocity: state.lateral_velocity,
            vertical_velocity: state.vertical_velocity,
            roll_rate: state.roll_rate,
            yaw_rate: state.yaw_rate,
            ..travel
        };
        // Its numbers are checked as any others.
        asked((pose, velocity), &[f64::NAN; ASKED.len()])
    }
}

/// The state that the file has, where the inputs can say all of it.
fn own(case: &WheelsetCase) -> Result<State, ContactsError> {
    let wrong = |what| Err(ContactsError::NotInFmu { what });
    let (stance, travel) = (case.stance, case.travel.unwrap_or_default());
    if stance.side.is_some() {
        return wrong("[wheelset] side");
    }
    if case.running.varies() {
        return wrong("[wheel] slices, flat, waviness, [rail] slices, corrugation");
    }
    let (pressed, is_by_load) = match stance.load {
        Some(Load::Axle(load)) => (HeightOrLoad::AxleLoad(load), true),
        Some(Load::Wheel(load)) => (HeightOrLoad::AxleLoad(2.0 * load), true),
        Some(Load::Height(z)) => (HeightOrLoad::Height(z), false),
        Some(Load::Wheels(_) | Load::Loaded { .. }) => {
            return wrong("[wheelset] roll_moment, wheel_load_left, mass");
        }
        None => return Err(WheelsetFileError::from(WheelsetError::NoLoad).into()),
    };
    if is_by_load && stance.roll.is_some() {
        return wrong("[wheelset] roll = a number under a load");
    }
    let friction = match &case.friction {
        Some([RailFriction::Constant(left), RailFriction::Constant(right)])
            if left.to_bits() == right.to_bits() =>
        {
            *left
        }
        _ => return wrong("[contact] friction by place or speed of slip, and different rails'"),
    };
    let pitch_rate = match travel.pitch {
        PitchRate::Rigid(rate) => rate,
        PitchRate::Independent([left, right]) if left == right => left,
        PitchRate::Independent(_) => return wrong("[motion] different pitch rates of both wheels"),
    };
    Ok(case.state(pressed, pitch_rate, friction))
}

/// Outputs in the order of the variables.
fn outputs(solved: &SolvedWheelset, radius: f64) -> [f64; OUTPUTS] {
    let wheels = [&solved.left, &solved.right];
    let contacts = wheels.map(|wheel| wheel.as_ref().map_or(&[][..], SolvedWheel::contacts));
    let wrench = solved.wrench(radius);
    let force = |wheel: &SolvedWheel| wheel.on_rail().force;
    let forces = wheels.map(|wheel| wheel.as_ref().map_or([0.0; 3], force));
    let sums = contacts.map(|all| all.iter().map(SolvedContact::load).sum::<f64>());
    let creepages = contacts.map(|all| {
        let most = all.iter().max_by(|a, b| a.load().total_cmp(&b.load()));
        most.map_or([0.0; 3], |one| {
            [one.creepage.longitudinal, one.creepage.lateral, one.creepage.spin]
        })
    });
    let heat = contacts.map(|all| all.iter().map(SolvedContact::heat).sum::<f64>());
    let position = solved.position();
    // Both wheels are there.
    let rate = 0.5 * solved.wheels().map(|wheel| wheel.pitch_rate).sum::<f64>();
    let errors = contacts.map(error);
    let counts = contacts.map(|all| all.iter().map(|_| 1.0).sum::<f64>());
    let mut all = [0.0; OUTPUTS];
    let parts = wrench.iter().chain(&forces).flatten().chain(&sums);
    let parts = parts.chain(creepages.as_flattened()).chain(&heat);
    let parts = parts.chain([&position.z, &position.roll, &rate]).chain(&errors).chain(&counts);
    all.iter_mut().zip(parts).for_each(|(to, from)| *to = *from);
    all
}

/// Error bar of a wheel's tangential force over `mu N`; NaN where the theory has none.
fn error(contacts: &[SolvedContact]) -> f64 {
    let limit: f64 = contacts.iter().map(|one| one.friction * one.load()).sum();
    let bar = |one: &SolvedContact| {
        one.force_error.map_or(f64::NAN, |bar| bar.longitudinal.hypot(bar.lateral))
    };
    let bars: f64 = contacts.iter().map(bar).sum();
    if limit > 0.0 { bars / limit } else { 0.0 }
}
