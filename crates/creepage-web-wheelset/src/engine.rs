//! Engine of the wheelset explorer: answers of a wheelset in numbers and words.

use std::fmt::Display;

use creepage::approximate::fastsim;
use creepage::coulomb::ElementField;
use creepage::theory::{AreaTheory, ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{Solid, SolidPair, TheorySpec};
use creepage_rail::{Place, Profile, Role, Side, Standard, Track, Wheelset, WheelsetOnTrack, file};
use creepage_wheelset::{
    Load, RailFriction, SolvedContact, SolvedWheelset, WheelsetPose, WheelsetSolver,
    WheelsetVelocity,
};

type Failure = Box<dyn std::error::Error>;

/// Steel.
const SHEAR_MODULUS: f64 = 82e9;
const POISSON: f64 = 0.28;
/// How far to either side radii are compared, and the amplitude of the conicity (m).
const REACH: f64 = 0.010;
const AMPLITUDE: f64 = 3e-3;
/// Cells of FASTSIM along and across a contact: no more than a picture shows.
const CELLS: [usize; 2] = [24, 24];

/// Sizes of wheelset and track (m, rad).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Dimensions {
    pub(crate) radius: f64,
    pub(crate) back_to_back: f64,
    pub(crate) cant: f64,
    pub(crate) gauge: f64,
    pub(crate) gauge_height: f64,
}

/// Where it stands, and how it moves.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Situation {
    pub(crate) y: f64,
    pub(crate) yaw: f64,
    pub(crate) axle_load: f64,
    pub(crate) speed: f64,
    pub(crate) curvature: f64,
    pub(crate) friction: f64,
}

/// Profiles, the wheelset on its track, and the last answer.
pub(crate) struct Engine {
    wheel: Profile,
    rail: Profile,
    running: Option<WheelsetOnTrack>,
    solved: Option<SolvedWheelset>,
    pub(crate) input: Vec<u8>,
    pub(crate) numbers: Vec<f64>,
    pub(crate) words: String,
}

impl Default for Engine {
    fn default() -> Self {
        Self {
            wheel: Standard::S1002.profile(),
            rail: Standard::Uic60.profile(),
            running: None,
            solved: None,
            input: Vec::new(),
            numbers: Vec::new(),
            words: String::new(),
        }
    }
}

impl Engine {
    pub(crate) fn profiles(&mut self) {
        let line = |(name, standard): &(&str, Standard)| {
            let role = if standard.role() == Role::Wheel { "wheel" } else { "rail" };
            format!("{role}\t{name}\n")
        };
        self.words = Standard::NAMES.iter().map(line).collect();
    }

    pub(crate) fn take_named(&mut self, number: usize) -> bool {
        let named = Standard::NAMES.get(number).ok_or("no such profile");
        let Some((_, standard)) = self.checked(named) else { return false };
        self.take(standard.profile());
        true
    }

    pub(crate) fn take_file(&mut self, is_rail: bool, name_length: usize) -> bool {
        let input = std::mem::take(&mut self.input);
        let (name, content) = input.split_at(name_length.min(input.len()));
        let role = if is_rail { Role::Rail } else { Role::Wheel };
        let wanted = file::ReadOptions { role: Some(role), ..file::ReadOptions::default() };
        let reading = file::read(&String::from_utf8_lossy(name), content, &wanted);
        let Some(reading) = self.checked(reading) else { return false };
        let actions: Vec<String> = reading.actions.iter().map(ToString::to_string).collect();
        self.words = actions.join("\n");
        self.take(reading.profile);
        true
    }

    fn take(&mut self, profile: Profile) {
        (self.running, self.solved) = (None, None);
        match profile.role() {
            Role::Wheel => self.wheel = profile,
            Role::Rail => self.rail = profile,
        }
    }

    pub(crate) fn set_on_track(&mut self, sizes: &Dimensions) -> bool {
        (self.running, self.solved) = (None, None);
        let running = self.on_track(sizes);
        let Some(running) = self.checked(running) else { return false };
        // Without roll, as EN 15302 has it.
        let difference = running.radius_differences(REACH, Some(0.0));
        let Some(difference) = self.checked(difference) else { return false };
        self.numbers = vec![difference.conicity(AMPLITUDE).unwrap_or(f64::NAN)];
        self.numbers.extend(difference.rows().flat_map(|(y, by)| [y, by]));
        self.running = Some(running);
        true
    }

    fn on_track(&self, sizes: &Dimensions) -> Result<WheelsetOnTrack, Failure> {
        let place = Place::gauge(sizes.gauge, sizes.gauge_height);
        let track = Track::new(&self.rail, sizes.cant, place)?;
        Ok(Wheelset::like(&self.wheel, sizes.radius, sizes.back_to_back)?.on(track))
    }

    pub(crate) fn solve(
        &mut self,
        resolution: u32,
        warm_start: bool,
        situation: &Situation,
    ) -> bool {
        let before = self.solved.take();
        let answer = self.solved(resolution, before.filter(|_| warm_start).as_ref(), situation);
        let Some((solved, mut numbers)) = self.checked(answer) else { return false };
        numbers.extend(solved.wheels().flat_map(|wheel| {
            let rail = wheel.on_rail();
            let error = rail.force_error.unwrap_or([f64::NAN; 3]);
            let [x, y, z] = rail.force;
            [x, y, z, error[0], error[1], wheel.clearance.unwrap_or(f64::NAN)]
        }));
        let contacts = || solved.wheels().flat_map(creepage_wheelset::SolvedWheel::contacts);
        numbers.push(contacts().count() as f64);
        contacts().for_each(|contact| drawn(contact, &mut numbers));
        let cautions = creepage_study::wheelset_caution_words(&solved);
        self.words = [vec![solved.status().name().into()], cautions].concat().join("\n");
        (self.numbers, self.solved) = (numbers, Some(solved));
        true
    }

    /// The solution, with the numbers of the wheelset: its height (m), roll (rad), pitch rate (rad/s), and the
    /// difference of rolling radii (m), NaN where wheels do not touch without roll.
    fn solved(
        &self,
        resolution: u32,
        before: Option<&SolvedWheelset>,
        situation: &Situation,
    ) -> Result<(SolvedWheelset, Vec<f64>), Failure> {
        let running = self.running.as_ref().ok_or("no wheelset is set on a track")?;
        let steel = Solid::new(SHEAR_MODULUS, POISSON)?;
        let Situation { y, yaw, axle_load, speed, curvature, friction } = *situation;
        if !(friction.is_finite() && friction > 0.0) {
            return Err(
                format!("friction must be finite and greater than zero, got {friction}").into()
            );
        }
        let friction = RailFriction::Constant(friction);
        let friction = [friction.clone(), friction];
        let theory = theory(resolution)?;
        let solver = WheelsetSolver::new(running, SolidPair::new(steel, steel), friction, theory)?;
        let load = Some(Load::Axle(axle_load));
        let pose = WheelsetPose { side: None, y, yaw, roll: None, load };
        let velocity = WheelsetVelocity { speed, curvature, ..WheelsetVelocity::default() };
        pose.checked()?;
        velocity.checked()?;
        let near = before.and_then(|before| solver.next(before, &pose, &velocity).ok());
        let solved = near.map_or_else(|| solver.solve(&pose, &velocity), Ok)?;
        let position = solved.position();
        let by = running.radius_difference(y, Some(0.0)).unwrap_or(f64::NAN);
        let numbers = vec![position.z, position.roll, solved.motion.pitch_rate, by];
        Ok((solved, numbers))
    }

    pub(crate) fn outlines(&mut self, spacing: f64) -> bool {
        let numbers = self.outlined(spacing);
        let Some(numbers) = self.checked(numbers) else { return false };
        self.numbers = numbers;
        true
    }

    fn outlined(&self, spacing: f64) -> Result<Vec<f64>, Failure> {
        let running = self.running.as_ref().ok_or("no wheelset is set on a track")?;
        let position = match &self.solved {
            Some(solved) => solved.position(),
            None => running.resting(0.0, 0.0, None)?,
        };
        let mut numbers = Vec::new();
        for side in [Side::Left, Side::Right] {
            let lines = running.outlines(side, &position, spacing)?;
            numbers.extend(lines.iter().map(|line| line.len() as f64));
            numbers.extend(lines.into_iter().flatten().flatten());
        }
        Ok(numbers)
    }

    /// The value, or nothing with the reason in words.
    fn checked<T, E: Display>(&mut self, result: Result<T, E>) -> Option<T> {
        self.numbers.clear();
        result.map_err(|error| self.words = error.to_string()).ok()
    }
}

fn theory(resolution: u32) -> Result<AreaTheory, Failure> {
    let named = match resolution {
        0 => {
            let settings = fastsim::Settings { grid: CELLS, ..fastsim::Settings::default() };
            return Ok(AreaTheory::new(&TheorySpec::Fastsim(settings))?);
        }
        1 => NamedResolution::Fast,
        2 => NamedResolution::Standard,
        _ => NamedResolution::Fine,
    };
    let resolution = ResolutionSpec::Named(named);
    Ok(AreaTheory::Exact(ExactOptions { resolution, ..ExactOptions::default() }))
}

/// A contact: its side (-1 left, 1 right), reference point (m), angle (rad), load and its error bar (N), creepage and
/// spin (rad/m), longitudinal and lateral force (N) and moment (N m) on the rail, error bars of both forces (NaN
/// without), largest pressure (Pa), area (m2), adhesion over area, energy turned to heat (J/m, NaN where unknown), the
/// number of elements, and [`element`] for each.
fn drawn(contact: &SolvedContact, numbers: &mut Vec<f64>) {
    let (creepage, force) = (contact.creepage, contact.force);
    let error = contact.force_error.map_or([f64::NAN; 2], |e| [e.longitudinal, e.lateral]);
    let elements = contact.elements();
    numbers.push(contact.side.sense());
    numbers.extend(contact.reference);
    numbers.extend([contact.angle, contact.load(), contact.load_error]);
    numbers.extend([creepage.longitudinal, creepage.lateral, creepage.spin]);
    numbers.extend([force.longitudinal, force.lateral, force.moment, error[0], error[1]]);
    let (peak, area) = (contact.normal.peak_pressure().value, contact.normal.area().value);
    let heat = contact.heat();
    numbers.extend([peak, area, contact.adhesion_share(), heat, elements.len() as f64]);
    numbers.extend(elements.iter().flat_map(|one| element(contact, one)));
}

/// Corners `x`, `s` all around (m, 8 numbers), traction on the rail along `x` and `s` (Pa), relative slip (2), pressure
/// (Pa), and how far each corner is from the border of adhesion, positive in slip.
fn element(contact: &SolvedContact, element: &ElementField) -> [f64; 17] {
    let scaling = contact.scaling;
    let [a, b, c, d] = element.corners.map(|corner| corner.map(|at| scaling.length * at));
    let area = 0.5 * ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])).abs();
    let traction = element.point.traction.map(|part| scaling.traction * part);
    let slip = element.point.slip.map(|part| scaling.slip * part);
    let beyond = element.beyond;
    let pressure = element.share * contact.load() / area;
    [
        a[0],
        a[1],
        b[0],
        b[1],
        c[0],
        c[1],
        d[0],
        d[1],
        traction[0],
        traction[1],
        slip[0],
        slip[1],
        pressure,
        beyond[0],
        beyond[1],
        beyond[2],
        beyond[3],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: Dimensions = Dimensions {
        radius: 0.46,
        back_to_back: 1.360,
        cant: 0.024_994_793_618_920,
        gauge: 1.435,
        gauge_height: 0.014,
    };
    const RUNS: Situation = Situation {
        y: 0.003,
        yaw: 0.002,
        axle_load: 120e3,
        speed: 20.0,
        curvature: 0.0,
        friction: 0.3,
    };
    const HEAD: usize = 4;
    const WHEEL: usize = 6;
    const CONTACT: usize = 20;
    const ELEMENT: usize = 17;

    fn set() -> Engine {
        let mut engine = Engine::default();
        assert!(engine.set_on_track(&SIZES), "{}", engine.words);
        engine
    }

    /// Forces of the elements of each contact, and both wheels' loads, are what is said of the whole.
    #[test]
    fn what_is_drawn_adds_up() {
        for resolution in [0, 1, 2] {
            let mut engine = set();
            assert!(engine.solve(resolution, false, &RUNS), "{}", engine.words);
            let numbers = &engine.numbers;
            let down = numbers[HEAD + 2] + numbers[HEAD + WHEEL + 2];
            // The load that was asked for is met to 2e-4 of it.
            assert!((down / RUNS.axle_load - 1.0).abs() < 2e-4, "{down}");
            let (count, mut rest) = (numbers[HEAD + 2 * WHEEL], &numbers[HEAD + 2 * WHEEL + 1..]);
            assert!(count >= 2.0);
            let mut met = 0.0_f64;
            while !rest.is_empty() {
                let (contact, others) = rest.split_at(CONTACT);
                let (load, force) = (contact[5], [contact[10], contact[11]]);
                let count = (0..10_000_u32).filter(|k| f64::from(*k) < contact[19]).count();
                let elements = others[..ELEMENT * count].chunks_exact(ELEMENT);
                let mut sums = [0.0; 3];
                for one in elements {
                    let area = 0.5
                        * ((one[4] - one[0]) * (one[7] - one[3])
                            - (one[5] - one[1]) * (one[6] - one[2]))
                            .abs();
                    sums[0] += area * one[8];
                    sums[1] += area * one[9];
                    sums[2] += area * one[12];
                }
                // Tractions stand for a whole element at one point of it: a part in fifty of mu N.
                for (sum, force) in sums.iter().zip(force) {
                    assert!(
                        (sum - force).abs() < 0.02 * 0.3 * load,
                        "{resolution} {sums:?} {force}"
                    );
                }
                assert!((sums[2] / load - 1.0).abs() < 0.02, "{} {load}", sums[2]);
                rest = &others[ELEMENT * count..];
                met += 1.0;
            }
            assert_eq!(met.to_bits(), count.to_bits());
        }
    }

    /// From the position before as from nothing, within the tolerance of the load and the error bars.
    #[test]
    fn a_warm_start_changes_nothing_but_the_time() {
        let (mut one, mut other) = (set(), set());
        assert!(one.solve(2, false, &Situation { y: 0.0029, ..RUNS }));
        assert!(one.solve(2, true, &RUNS) && other.solve(2, false, &RUNS));
        for k in HEAD..HEAD + 3 {
            let apart = (one.numbers[k] - other.numbers[k]).abs();
            assert!(apart < 5e-3 * 0.3 * 60e3, "{k} {apart}");
        }
    }

    /// What the command cautions against is said here too, in its words.
    #[test]
    fn cautions_are_the_commands() {
        let mut engine = set();
        assert!(engine.solve(2, false, &RUNS), "{}", engine.words);
        assert_eq!(engine.words, "solved");
        let flange = Situation { y: 0.0066, yaw: 0.003, ..RUNS };
        assert!(engine.solve(2, false, &flange), "{}", engine.words);
        let said: Vec<&str> = engine.words.lines().collect();
        assert_eq!(said[0], "solved");
        assert!(said[1..].iter().any(|words| words.starts_with("right wheel: ")), "{said:?}");
    }

    #[test]
    fn profiles_come_from_files() {
        let mut engine = set();
        let text = file::write(&Standard::Cone20.profile(), file::Format::Columns, 5e-4);
        let name = "cone.txt";
        engine.input = [name.as_bytes(), text.as_bytes()].concat();
        assert!(engine.take_file(false, name.len()), "{}", engine.words);
        assert!(engine.set_on_track(&SIZES), "{}", engine.words);
        // Twice the slope of a cone: the difference of radii over twice the shift.
        assert!((engine.numbers[0] - 0.05).abs() < 1e-3, "{}", engine.numbers[0]);
        assert!(engine.outlines(1e-3) && engine.numbers[0] > 100.0);
    }

    #[test]
    fn nonsense_is_answered_in_words() {
        let mut engine = Engine::default();
        assert!(!engine.solve(2, false, &RUNS) && engine.words.contains("no wheelset"));
        assert!(
            !engine.set_on_track(&Dimensions { radius: -1.0, ..SIZES })
                && engine.words.contains("radius")
        );
        assert!(engine.set_on_track(&SIZES));
        for wrong in [
            Situation { y: f64::NAN, ..RUNS },
            Situation { y: 0.5, ..RUNS },
            Situation { axle_load: 0.0, ..RUNS },
            Situation { speed: 0.0, ..RUNS },
            Situation { friction: -0.1, ..RUNS },
        ] {
            assert!(!engine.solve(1, false, &wrong) && !engine.words.is_empty(), "{wrong:?}");
        }
        engine.input = b"x.txtthis is no profile".to_vec();
        assert!(!engine.take_file(true, 5) && !engine.words.is_empty());
        assert!(!engine.take_named(99));
    }
}
