//! Reader of module 1 of CONTACT: a wheel on a rail or a roller. What is read of each case.

use crate::ImportError;
use crate::lines::Lines;
use crate::read::{Control, FrictionRead, Heat, Materials, read_heat, read_points_below};

/// A case of module 1, in mm, N, rad, s.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Wheels {
    pub(crate) control: Control,
    pub(crate) friction: Option<FrictionRead>,
    pub(crate) materials: Option<Materials>,
    pub(crate) heat: Option<Heat>,
    /// Digit D of the case that last gave one.
    pub(crate) method: u8,
    /// How far the wheel rolls in a step of T = 2 (mm): DX times DQREL.
    pub(crate) step: f64,
    /// GAUGHT and the three numbers after it, then the curvature.
    pub(crate) track: Option<[f64; 5]>,
    pub(crate) rail: Option<ProfileFile>,
    /// DY, DZ, DROLL, VY, VZ, VROLL.
    pub(crate) deviation: [f64; 6],
    /// KY, FY, KZ, FZ of a rail on springs.
    pub(crate) springs: Option<[f64; 4]>,
    /// FBDIST, FBPOS, NOMRAD.
    pub(crate) wheelset: Option<[f64; 3]>,
    pub(crate) wheel: Option<ProfileFile>,
    /// S, Y, Z or FZ, ROLL, YAW, PITCH.
    pub(crate) position: Option<[f64; 6]>,
    /// VS, VY, VZ, VROLL, VYAW, VPITCH or a force.
    pub(crate) velocity: Option<[f64; 6]>,
    /// Whether the axle is bent.
    pub(crate) is_flexible: bool,
}

/// The file of a profile, and how it is to be read.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ProfileFile {
    pub(crate) name: String,
    /// Whether y is mirrored.
    pub(crate) mirror_y: bool,
    pub(crate) scale: f64,
    pub(crate) smoothing: f64,
    /// Whether that is the weight of a cubic smoothing spline (ISMOOTH = 0), in mm3.
    pub(crate) is_plain_spline: bool,
    /// KNKHGH, KNKLOW (rad) and KNKWID (mm), where they differ from what is usual here.
    pub(crate) corners: Option<[f64; 3]>,
    /// Whether zig-zags are found by another number than here.
    pub(crate) has_zig_zags: bool,
    /// 1 where z is mirrored, -1 where it is not, 0 where its shape says.
    pub(crate) mirror_z: i32,
}

/// ZIGTHRS, KNKHGH, KNKLOW (rad), KNKWID (mm) by which corners and zig-zags are found here too.
const USUAL_KINKS: [f64; 4] = [
    150.0 * std::f64::consts::PI / 180.0,
    30.0 * std::f64::consts::PI / 180.0,
    6.0 * std::f64::consts::PI / 180.0,
    2.0,
];

impl ProfileFile {
    fn read(lines: &mut Lines, what: &str) -> Result<Self, ImportError> {
        let error = lines.expected(&format!("{what}: name, MIRRORY, SCALE, SMOOTH"));
        let (name, numbers) = lines.file(what)?;
        let [mirror_y, scale, smoothing] = *numbers.get(..3).unwrap_or(&[]) else {
            return Err(error);
        };
        let at = |place: usize| numbers.get(place).copied().unwrap_or(0.0);
        let (mut smoothing_kind, mut corners, mut has_zig_zags) = (0.0, None, false);
        if at(4) >= 1.0 {
            let options = lines.numbers(5, "ISMOOTH, ZIGTHRS, KNKHGH, KNKLOW, KNKWID")?;
            smoothing_kind = options[0];
            // Angles of zero are the usual ones, a width of zero is one.
            let or_usual = |place: usize| {
                if options[place + 1] == 0.0 { USUAL_KINKS[place] } else { options[place + 1] }
            };
            let own = [or_usual(1), or_usual(2), options[4]];
            let differs = |(one, usual): (&f64, &f64)| (one - usual).abs() > 1e-9;
            corners = own.iter().zip(&USUAL_KINKS[1..]).any(differs).then_some(own);
            has_zig_zags = differs((&or_usual(0), &USUAL_KINKS[0]));
        }
        let is_plain_spline = smoothing_kind == 0.0;
        Ok(Self {
            name,
            mirror_y: mirror_y >= 1.0,
            scale,
            smoothing,
            is_plain_spline,
            corners,
            has_zig_zags,
            mirror_z: at(3) as i32,
        })
    }
}

impl Wheels {
    /// Reads the next case; what it keeps is that of the case before, `self`.
    pub(crate) fn next(&self, lines: &mut Lines) -> Result<Self, ImportError> {
        let control = Control::read(lines, self.control)?;
        let mut case = Self { control, ..self.clone() };
        case.friction = FrictionRead::read(lines, control, self.friction.as_ref())?;
        case.materials = Materials::read(lines, control, self.materials.as_ref())?;
        case.heat = read_heat(lines, control, self.heat)?;
        if control.discretisation() >= 2 {
            case.method = control.discretisation();
            let numbers = lines.numbers(6, "DX, DS, DQREL, A_SEP, D_SEP, D_COMB")?;
            case.step = numbers[0] * numbers[2];
        }
        case.read_track(lines)?;
        case.read_wheelset(lines)?;
        read_points_below(lines, control)?;
        Ok(case)
    }

    fn read_track(&mut self, lines: &mut Lines) -> Result<(), ImportError> {
        let digit = self.control.shape();
        if matches!(digit, 1 | 3) {
            let values = lines.numbers(4, "GAUGHT and the track's three other numbers")?;
            let at = |place: usize| values.get(place).copied().unwrap_or(0.0);
            self.track = Some(std::array::from_fn(at));
        }
        if digit == 3 {
            self.rail = Some(ProfileFile::read(lines, "profile of the rail")?);
        }
        if digit >= 2 {
            self.deviation = lines.array("DY, DZ, DROLL, VY, VZ, VROLL")?;
        }
        if self.control.force() == 3 {
            if digit >= 2 {
                self.springs = Some(lines.array("KYRAIL, FYRAIL, KZRAIL, FZRAIL")?);
            }
        } else {
            self.springs = None;
        }
        Ok(())
    }

    fn read_wheelset(&mut self, lines: &mut Lines) -> Result<(), ImportError> {
        let digit = self.control.last_of_second();
        if matches!(digit, 3 | 5) {
            self.wheelset = Some(lines.array("FBDIST, FBPOS, NOMRAD")?);
            self.wheel = Some(ProfileFile::read(lines, "profile of the wheel")?);
        }
        if digit >= 1 {
            self.position = Some(lines.array("S, Y, Z or FZ, ROLL, YAW, PITCH")?);
        }
        // Without friction (T = 0) nothing moves; some files have the line all the same.
        let moves = self.control.tangential() >= 1 || lines.numbers_ahead() >= 3;
        if digit >= 2 && moves {
            self.velocity = Some(lines.array("VS, VY, VZ, VROLL, VYAW, VPITCH")?);
        }
        if matches!(digit, 4 | 5) {
            let bent: [f64; 12] = lines.array("six displacements of the wheel, six velocities")?;
            self.is_flexible = bent.iter().any(|value| *value != 0.0);
        }
        Ok(())
    }
}
