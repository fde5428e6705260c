//! Contact forces of a wheelset over lateral position and yaw, for vehicle dynamics.

use creepage_wheelset::{SolvedWheel, SolvedWheelset, WheelsetPose};
use std::path::Path;

use netcdf3::{DataSet, FileWriter, Version};
use rayon::prelude::*;

use super::case::WheelsetCase;
use super::error::{WheelsetFileError, section};
use crate::error::ReportError;

/// A wheelset solved at every position of a grid.
#[derive(Debug, Clone)]
pub struct WheelsetTable {
    y: Vec<f64>,
    yaw: Vec<f64>,
    /// By yaw, then by lateral position; `None` where the position could not be solved.
    cells: Vec<Option<Cell>>,
}

/// What a table holds of one position.
#[derive(Debug, Clone, Copy)]
struct Cell {
    z: f64,
    roll: f64,
    pitch_rate: f64,
    /// Left and right: force and moment on the rail, then rail and wheel place, angle, load,
    /// creepages of the most loaded contact, number of contacts.
    wheels: [[f64; COLUMNS.len()]; 2],
}

/// Names and meanings of what a wheel has.
const COLUMNS: [(&str, &str); 14] = [
    ("longitudinal_n", "force on the rail along x (N)"),
    ("lateral_n", "force on the rail along y (N)"),
    ("vertical_n", "force on the rail along z (N)"),
    ("moment_x_n_m", "moment about x through the origin of the rail's profile (N m)"),
    ("moment_y_n_m", "moment about y (N m)"),
    ("moment_z_n_m", "moment about z (N m)"),
    ("y_rail_m", "place of the most loaded contact in the rail's profile (m)"),
    ("y_wheel_m", "place of the most loaded contact in the wheel's profile (m)"),
    ("contact_angle_rad", "angle of the most loaded contact (rad)"),
    ("normal_force_n", "normal force of the most loaded contact (N)"),
    ("longitudinal_creepage", "longitudinal creepage of the most loaded contact"),
    ("lateral_creepage", "lateral creepage of the most loaded contact"),
    ("spin_rad_per_m", "spin of the most loaded contact (rad/m)"),
    ("contacts", "number of places of contact"),
];

impl WheelsetTable {
    /// Most positions: 300 bytes each, and some hundredths or tenths of a second.
    const MOST_POSITIONS: f64 = 1e6;

    /// Solves a case at all lateral positions (m) and yaws (rad), the rows of one yaw after each
    /// other from their neighbours, the yaws side by side on all cores. `goes_on` is asked before every
    /// position: once it says no, those that are left are not solved.
    ///
    /// # Errors
    /// [`WheelsetFileError`] where the case cannot be prepared or the first position of every row
    /// fails.
    pub fn solve(
        case: &WheelsetCase,
        y: &[f64],
        yaw: &[f64],
        goes_on: impl Fn() -> bool + Sync,
    ) -> Result<Self, WheelsetFileError> {
        let positions = y.len() as f64 * yaw.len() as f64;
        if positions > Self::MOST_POSITIONS {
            return Err(WheelsetFileError::Positions {
                asked: positions,
                most: Self::MOST_POSITIONS,
            });
        }
        let travel = case.travel.ok_or_else(|| section("motion", "speed"))?;
        let solver = case.solver()?;
        let row = |yaw: &f64| -> Result<Vec<Option<Cell>>, WheelsetFileError> {
            let mut last: Option<SolvedWheelset> = None;
            let mut failure = None;
            let cells: Vec<Option<Cell>> = y
                .iter()
                .map(|&y| {
                    if !goes_on() {
                        return None;
                    }
                    let stance = WheelsetPose { y, yaw: *yaw, ..case.stance };
                    let near = last.as_ref().map(|last| solver.next(last, &stance, &travel));
                    let solved = match near {
                        Some(Ok(solved)) => Ok(solved),
                        _ => solver.solve(&stance, &travel),
                    };
                    match solved {
                        Ok(solved) => {
                            let cell = Cell::new(&solved);
                            last = Some(solved);
                            Some(cell)
                        }
                        Err(error) => {
                            failure = Some(error);
                            None
                        }
                    }
                })
                .collect();
            match failure {
                Some(error) if cells.iter().all(Option::is_none) => Err(error.into()),
                _ => Ok(cells),
            }
        };
        let rows = yaw.par_iter().map(row).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { y: y.to_vec(), yaw: yaw.to_vec(), cells: rows.concat() })
    }

    /// Positions that could not be solved: `NaN` in the file.
    #[must_use]
    pub fn lacking(&self) -> usize {
        self.cells.iter().filter(|cell| cell.is_none()).count()
    }

    /// Writes the table as NetCDF (classic format), over the dimensions `yaw` and `y`.
    ///
    /// # Errors
    /// [`ReportError`].
    pub fn netcdf(&self, path: &Path) -> Result<(), ReportError> {
        let definition = self.definition()?;
        let mut file = FileWriter::open(path)?;
        file.set_def(&definition, Version::Offset64Bit, 0)?;
        file.write_var_f64("y", &self.y)?;
        file.write_var_f64("yaw", &self.yaw)?;
        for (name, values) in self.columns() {
            file.write_var_f64(&name, &values)?;
        }
        Ok(file.close()?)
    }

    /// What the table holds, by name: by yaw, then by lateral position; NaN where the position could
    /// not be solved.
    pub fn columns(&self) -> impl Iterator<Item = (String, Vec<f64>)> {
        let whole = WHOLE.into_iter().map(|(name, _, value)| (name.to_owned(), self.column(value)));
        let of_wheels = SIDES.into_iter().enumerate().flat_map(move |(index, side)| {
            COLUMNS.iter().enumerate().map(move |(k, (name, _))| {
                (format!("{side}_{name}"), self.column(|cell: &Cell| cell.wheels[index][k]))
            })
        });
        whole.chain(of_wheels)
    }

    fn column(&self, value: impl Fn(&Cell) -> f64) -> Vec<f64> {
        self.cells.iter().map(|cell| cell.as_ref().map_or(f64::NAN, &value)).collect()
    }

    fn definition(&self) -> Result<DataSet, netcdf3::InvalidDataSet> {
        let mut set = DataSet::new();
        set.add_fixed_dim("yaw", self.yaw.len())?;
        set.add_fixed_dim("y", self.y.len())?;
        for (name, meaning) in
            [("y", "lateral position, to the right (m)"), ("yaw", "turn about z (rad)")]
        {
            set.add_var_f64(name, &[name])?;
            set.add_var_attr_string(name, "long_name", meaning)?;
        }
        let mut over_both = |name: &str, meaning: &str| {
            set.add_var_f64(name, &["yaw", "y"])?;
            set.add_var_attr_string(name, "long_name", meaning)
        };
        for (name, meaning, _) in WHOLE {
            over_both(name, meaning)?;
        }
        for side in SIDES {
            for (name, meaning) in COLUMNS {
                over_both(&format!("{side}_{name}"), &format!("{side} wheel: {meaning}"))?;
            }
        }
        Ok(set)
    }
}

const SIDES: [&str; 2] = ["left", "right"];

/// A variable of the file: name, meaning, and its value.
type Variable = (&'static str, &'static str, fn(&Cell) -> f64);

/// What the wheelset as a whole has.
const WHOLE: [Variable; 3] = [
    ("z_m", "height, down (m)", |cell| cell.z),
    ("roll_rad", "turn about x (rad)", |cell| cell.roll),
    ("pitch_rate_rad_per_s", "angular velocity about the axle (rad/s)", |cell| cell.pitch_rate),
];

impl Cell {
    fn new(solved: &SolvedWheelset) -> Self {
        let position = solved.position();
        let columns =
            |wheel: &Option<SolvedWheel>| wheel.as_ref().map_or([f64::NAN; COLUMNS.len()], columns);
        Self {
            z: position.z,
            roll: position.roll,
            pitch_rate: solved.motion.pitch_rate,
            wheels: [columns(&solved.left), columns(&solved.right)],
        }
    }
}

fn columns(wheel: &SolvedWheel) -> [f64; COLUMNS.len()] {
    let on_rail = wheel.on_rail();
    let ([x, y, z], [mx, my, mz]) = (on_rail.force, on_rail.moment);
    let count = wheel.contacts().len() as f64;
    let of_contact = wheel.contacts().first().map_or([f64::NAN; 7], |contact| {
        let creepage = contact.creepage;
        [
            contact.y_rail,
            contact.y_wheel,
            contact.angle,
            contact.load(),
            creepage.longitudinal,
            creepage.lateral,
            creepage.spin,
        ]
    });
    let [y_rail, y_wheel, angle, load, xi, eta, spin] = of_contact;
    [x, y, z, mx, my, mz, y_rail, y_wheel, angle, load, xi, eta, spin, count]
}
