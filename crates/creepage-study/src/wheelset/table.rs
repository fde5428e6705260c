//! Table of a wheelset's forces over a grid of positions and loads, for vehicle dynamics.

use std::path::Path;

use creepage_wheelset::{
    ASKED, SolvedContact, SolvedWheel, SolvedWheelset, WheelsetPose, WheelsetVelocity,
};
use netcdf3::{DataSet, FileWriter, Version};
use rayon::prelude::*;

use super::case::WheelsetCase;
use super::error::WheelsetFileError;
use super::report::wheelset_caution_words;
use crate::error::ReportError;

/// A wheelset solved at every position of a grid.
#[derive(Debug, Clone)]
pub struct WheelsetTable {
    axes: Vec<TableAxis>,
    /// The last axis runs fastest; `None` where the position could not be solved.
    cells: Vec<Option<Cell>>,
}

/// Axis of a table, and its values.
#[derive(Debug, Clone, PartialEq)]
pub struct TableAxis {
    /// One of [`TableAxis::NAMES`].
    pub name: &'static str,
    /// In SI units.
    pub values: Vec<f64>,
}

impl TableAxis {
    /// What a table may go over, as of [`ASKED`]: places, turns and loads.
    pub const NAMES: [&str; 5] = ["y", "z", "roll", "yaw", "axle_load"];

    fn unit(&self) -> &'static str {
        match self.name {
            "roll" | "yaw" => "rad",
            "axle_load" => "N",
            _ => "m",
        }
    }

    fn meaning(&self) -> &'static str {
        match self.name {
            "y" => "lateral position, to the right",
            "z" => "height, down",
            "roll" => "turn about x",
            "yaw" => "turn about z",
            _ => "vertical force of the wheelset on the track",
        }
    }
}

/// What a table holds of one position.
#[derive(Debug, Clone)]
struct Cell {
    whole: [f64; WHOLE.len()],
    /// Of the left and the right wheel.
    wheels: [[f64; OF_WHEEL.len()]; 2],
    contacts: [[[f64; OF_CONTACT.len()]; CONTACTS]; 2],
    /// In words.
    cautions: Vec<String>,
}

/// Places of contact of one wheel that a table holds, the most loaded ones.
const CONTACTS: usize = 3;

/// Name, unit and meaning.
type Column = (&'static str, &'static str, &'static str);

/// What the wheelset as a whole has.
const WHOLE: [Column; 3] = [
    ("z_m", "m", "height, down"),
    ("roll_rad", "rad", "turn about x"),
    ("pitch_rate_rad_per_s", "rad s-1", "angular velocity about the axle"),
];

/// What a wheel has; from the seventh on of its most loaded contact.
const OF_WHEEL: [Column; 14] = [
    ("longitudinal_n", "N", "force on the rail along x"),
    ("lateral_n", "N", "force on the rail along y"),
    ("vertical_n", "N", "force on the rail along z"),
    ("moment_x_n_m", "N m", "moment about x through the origin of the rail's profile"),
    ("moment_y_n_m", "N m", "moment about y"),
    ("moment_z_n_m", "N m", "moment about z"),
    ("y_rail_m", "m", "place of the most loaded contact in the rail's profile"),
    ("y_wheel_m", "m", "place of the most loaded contact in the wheel's profile"),
    ("contact_angle_rad", "rad", "angle of the most loaded contact"),
    ("normal_force_n", "N", "normal force of the most loaded contact"),
    ("longitudinal_creepage", "1", "longitudinal creepage of the most loaded contact"),
    ("lateral_creepage", "1", "lateral creepage of the most loaded contact"),
    ("spin_rad_per_m", "rad m-1", "spin of the most loaded contact"),
    ("contacts", "1", "number of places of contact"),
];

/// What each place of contact has, by falling load.
const OF_CONTACT: [Column; 13] = [
    ("y_rail_m", "m", "place in the rail's profile"),
    ("y_wheel_m", "m", "place in the wheel's profile"),
    ("contact_angle_rad", "rad", "angle from the track's z to the normal into the rail"),
    ("normal_force_n", "N", "normal force"),
    ("longitudinal_n", "N", "tangential force along x"),
    ("lateral_n", "N", "tangential force across, in the plane of contact"),
    ("longitudinal_creepage", "1", "longitudinal creepage"),
    ("lateral_creepage", "1", "lateral creepage"),
    ("spin_rad_per_m", "rad m-1", "spin"),
    ("length_m", "m", "extent of its areas along x"),
    ("width_m", "m", "extent of its areas across"),
    ("area_m2", "m2", "area"),
    ("peak_pressure_pa", "Pa", "peak pressure"),
];

const SIDES: [&str; 2] = ["left", "right"];

impl WheelsetTable {
    /// Most positions: a kilobyte each, and some hundredths or tenths of a second.
    const MOST_POSITIONS: f64 = 1e6;

    /// Solves a case at all positions of a grid, those of the last axis after each other from their neighbours,
    /// these rows side by side on all cores. What is no axis is the case's own. `goes_on` is asked before every
    /// position: once it says no, those that are left are not solved.
    ///
    /// # Errors
    /// [`WheelsetFileError`] where the case cannot be prepared, axes contradict each other or the case (`z` and a
    /// load), or no position of a row is solved.
    pub fn solve(
        case: &WheelsetCase,
        axes: &[TableAxis],
        goes_on: impl Fn() -> bool + Sync,
    ) -> Result<Self, WheelsetFileError> {
        let positions: f64 = axes.iter().map(|axis| axis.values.len() as f64).product();
        if positions > Self::MOST_POSITIONS {
            return Err(WheelsetFileError::Positions {
                asked: positions,
                most: Self::MOST_POSITIONS,
            });
        }
        let solver = case.solver()?;
        let rows = rows(case, axes)?;
        let row = |row: &Vec<(WheelsetPose, WheelsetVelocity)>| -> Result<Vec<Option<Cell>>, WheelsetFileError> {
            let mut last: Option<SolvedWheelset> = None;
            let mut failure = None;
            let cells = row.iter().map(|(pose, velocity)| {
                if !goes_on() {
                    return None;
                }
                let near = last.as_ref().map(|last| solver.next(last, pose, velocity));
                let solved = match near {
                    Some(Ok(solved)) => Ok(solved),
                    _ => solver.solve(pose, velocity),
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
            });
            let cells: Vec<Option<Cell>> = cells.collect();
            match failure {
                Some(error) if cells.iter().all(Option::is_none) => Err(error.into()),
                _ => Ok(cells),
            }
        };
        let cells = rows.par_iter().map(row).collect::<Result<Vec<_>, _>>()?.concat();
        Ok(Self { axes: axes.to_vec(), cells })
    }

    /// Positions that could not be solved: `NaN` in the file.
    #[must_use]
    pub fn lacking(&self) -> usize {
        self.cells.iter().filter(|cell| cell.is_none()).count()
    }

    /// At how many positions there are cautions, and those of the first of them in words.
    #[must_use]
    pub fn cautions(&self) -> Option<(usize, &[String])> {
        let cautious = || self.cells.iter().flatten().filter(|cell| !cell.cautions.is_empty());
        Some((cautious().count(), &cautious().next()?.cautions))
    }

    /// Writes the table as NetCDF (classic format, names and units as CF 1.11 asks), over the axes, and of the
    /// places of contact over `contact` too.
    ///
    /// # Errors
    /// [`ReportError`].
    pub fn netcdf(&self, path: &Path) -> Result<(), ReportError> {
        let definition = self.definition()?;
        let mut file = FileWriter::open(path)?;
        file.set_def(&definition, Version::Offset64Bit, 0)?;
        for axis in &self.axes {
            file.write_var_f64(axis.name, &axis.values)?;
        }
        for (name, values) in self.columns().chain(self.contact_columns()) {
            file.write_var_f64(&name, &values)?;
        }
        Ok(file.close()?)
    }

    /// What the wheelset and its wheels have, by name, the last axis fastest; NaN where the position could not be
    /// solved.
    pub fn columns(&self) -> impl Iterator<Item = (String, Vec<f64>)> {
        let whole = WHOLE
            .iter()
            .enumerate()
            .map(|(k, (name, ..))| ((*name).to_owned(), self.column(|cell: &Cell| cell.whole[k])));
        let of_wheels = SIDES.into_iter().enumerate().flat_map(move |(index, side)| {
            OF_WHEEL.iter().enumerate().map(move |(k, (name, ..))| {
                (format!("{side}_{name}"), self.column(|cell: &Cell| cell.wheels[index][k]))
            })
        });
        whole.chain(of_wheels)
    }

    /// What each place of contact has, by name, `left_contact_area_m2` and so on: the three most loaded ones of each
    /// position, NaN where there are fewer.
    pub fn contact_columns(&self) -> impl Iterator<Item = (String, Vec<f64>)> {
        SIDES.into_iter().enumerate().flat_map(move |(index, side)| {
            OF_CONTACT.iter().enumerate().map(move |(k, (name, ..))| {
                let of = |cell: &Option<Cell>| match cell {
                    Some(cell) => cell.contacts[index].map(|contact| contact[k]),
                    None => [f64::NAN; CONTACTS],
                };
                (format!("{side}_contact_{name}"), self.cells.iter().flat_map(of).collect())
            })
        })
    }

    /// Places of contact of each wheel in [`WheelsetTable::contact_columns`].
    pub const CONTACTS: usize = CONTACTS;

    fn column(&self, value: impl Fn(&Cell) -> f64) -> Vec<f64> {
        self.cells.iter().map(|cell| cell.as_ref().map_or(f64::NAN, &value)).collect()
    }

    fn definition(&self) -> Result<DataSet, netcdf3::InvalidDataSet> {
        let mut set = DataSet::new();
        set.add_global_attr_string("Conventions", "CF-1.11")?;
        set.add_global_attr_string("title", "forces of a wheelset on its rails")?;
        set.add_global_attr_string("source", concat!("creepage ", env!("CARGO_PKG_VERSION")))?;
        let mut over: Vec<&str> = self.axes.iter().map(|axis| axis.name).collect();
        for axis in &self.axes {
            set.add_fixed_dim(axis.name, axis.values.len())?;
            described(&mut set, axis.name, &[axis.name], (axis.unit(), axis.meaning().to_owned()))?;
        }
        for (name, unit, meaning) in WHOLE {
            described(&mut set, name, &over, (unit, meaning.to_owned()))?;
        }
        for side in SIDES {
            for (name, unit, meaning) in OF_WHEEL {
                let meaning = format!("{side} wheel: {meaning}");
                described(&mut set, &format!("{side}_{name}"), &over, (unit, meaning))?;
            }
        }
        set.add_fixed_dim("contact", CONTACTS)?;
        over.push("contact");
        for side in SIDES {
            for (name, unit, meaning) in OF_CONTACT {
                let meaning = format!("{side} wheel, each place of contact: {meaning}");
                described(&mut set, &format!("{side}_contact_{name}"), &over, (unit, meaning))?;
            }
        }
        Ok(set)
    }
}

/// A variable with its unit and meaning.
fn described(
    set: &mut DataSet,
    name: &str,
    over: &[&str],
    (unit, meaning): (&str, String),
) -> Result<(), netcdf3::InvalidDataSet> {
    set.add_var_f64(name, over)?;
    set.add_var_attr_string(name, "units", unit)?;
    set.add_var_attr_string(name, "long_name", meaning)
}

/// Positions and motions of the grid, a row for all values of the last axis.
fn rows(
    case: &WheelsetCase,
    axes: &[TableAxis],
) -> Result<Vec<Vec<(WheelsetPose, WheelsetVelocity)>>, WheelsetFileError> {
    let mut asked = vec![[f64::NAN; ASKED.len()]];
    for axis in axes {
        let place = ASKED.iter().position(|name| *name == axis.name).unwrap_or_default();
        let one = |row: &[f64; ASKED.len()]| {
            let row = *row;
            axis.values.iter().map(move |value| {
                let mut with = row;
                with[place] = *value;
                with
            })
        };
        asked = asked.iter().flat_map(one).collect();
    }
    let length = axes.last().map_or(1, |axis| axis.values.len()).max(1);
    let row = |row: &[[f64; ASKED.len()]]| row.iter().map(|numbers| case.asked(numbers)).collect();
    asked.chunks(length).map(row).collect()
}

impl Cell {
    fn new(solved: &SolvedWheelset) -> Self {
        let position = solved.position();
        let wheels = [&solved.left, &solved.right];
        Self {
            whole: [position.z, position.roll, solved.motion.pitch_rate],
            wheels: wheels.map(|wheel| wheel.as_ref().map_or([f64::NAN; OF_WHEEL.len()], of_wheel)),
            contacts: wheels.map(|wheel| {
                let contacts = wheel.as_ref().map_or(&[][..], SolvedWheel::contacts);
                std::array::from_fn(|k| {
                    contacts.get(k).map_or([f64::NAN; OF_CONTACT.len()], of_contact)
                })
            }),
            cautions: wheelset_caution_words(solved),
        }
    }
}

fn of_wheel(wheel: &SolvedWheel) -> [f64; OF_WHEEL.len()] {
    let on_rail = wheel.on_rail();
    let ([x, y, z], [mx, my, mz]) = (on_rail.force, on_rail.moment);
    let count = wheel.contacts().len() as f64;
    let most_loaded = wheel.contacts().first().map_or([f64::NAN; OF_CONTACT.len()], of_contact);
    let [y_rail, y_wheel, angle, load, _, _, xi, eta, spin, ..] = most_loaded;
    [x, y, z, mx, my, mz, y_rail, y_wheel, angle, load, xi, eta, spin, count]
}

fn of_contact(contact: &SolvedContact) -> [f64; OF_CONTACT.len()] {
    let (creepage, force, normal) = (contact.creepage, contact.force, &contact.normal);
    let [length, width] = contact.extent().map(|[from, to]| to - from);
    [
        contact.y_rail,
        contact.y_wheel,
        contact.angle,
        contact.load(),
        force.longitudinal,
        force.lateral,
        creepage.longitudinal,
        creepage.lateral,
        creepage.spin,
        length,
        width,
        normal.area().value,
        normal.peak_pressure().value,
    ]
}
