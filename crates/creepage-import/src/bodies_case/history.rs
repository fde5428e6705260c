//! Conversion of transient cases: a table of steps, after a shift or steady rolling.

use super::{Cause, Geometry, LoadOrApproach, Parts};
use crate::bodies::Bodies;
use crate::read::Extra;
use crate::text::{number, quoted, section};
use crate::{File, Written};

/// What stands for no memory of friction: forces on a line differ by a ten-thousandth of `mu N` from those of a tenth
/// of it.
const SHORTEST_MEMORY: &str = "memory_distance = 1e-8, memory_speed = 0.001";

/// By how much semi-axes of one ellipse may differ, whose numbers have four digits.
const SAME: f64 = 1e-3;

/// The state in which rolling starts.
struct Start {
    is_steady: bool,
    /// What shifted the bodies before (N).
    force: [f64; 2],
    /// Load or approach at that time.
    pressed: Option<LoadOrApproach>,
}

impl Start {
    /// A shift from rest, or one that goes on from that before.
    fn shift(&mut self, force: [f64; 2], pressed: LoadOrApproach) -> Result<(), Cause> {
        let [from, to] = [self.force, force].map(|force| force[0].hypot(force[1]));
        let dot = self.force[0] * force[0] + self.force[1] * force[1];
        // Rounding of the file's digits turns no direction.
        let goes_on = to >= from && dot >= (1.0 - 1e-12) * from * to;
        if self.pressed.is_some_and(|before| before != pressed) || !goes_on {
            return Err("a load path before the first step of rolling".into());
        }
        self.force = force;
        self.pressed = Some(pressed);
        Ok(())
    }

    fn keys(&self) -> Vec<(&'static str, String)> {
        let [x, y] = self.force;
        if self.is_steady {
            vec![("traction", quoted("steady"))]
        } else if x == 0.0 && y == 0.0 {
            vec![("traction", quoted("none"))]
        } else {
            vec![
                ("traction", quoted("shift")),
                ("longitudinal_force", number(x)),
                ("lateral_force", number(y)),
            ]
        }
    }
}

impl Parts<'_> {
    /// Rolling from step to step (T = 2), a shape that moves on from shift to shift (T = 1), or a line contact.
    /// `places` are those of the shape's middle in each case (mm).
    pub(super) fn history(
        &self,
        chain: &[Bodies],
        places: &[[f64; 2]],
        (name, title): (&str, &str),
        notes: &mut Vec<String>,
    ) -> Result<Written, Cause> {
        self.is_of_steps()?;
        let turned = self.goes_backward(chain, places)?;
        let mut own = Self { turned, ..self.clone() };
        let mut start = Start { is_steady: false, force: [0.0; 2], pressed: None };
        let (mut rows, mut distance, mut has_other_digits) = (Vec::new(), 0.0, false);
        for (index, case) in chain.iter().enumerate() {
            let parts = Parts { turned, ..Parts::of(case, &mut Vec::new())? };
            // Before it rolls, nothing has been turned.
            if parts.geometry != own.geometry && !(index == 0 && turned) {
                if !are_same_ellipse(&parts, &own) {
                    return Err("a history in which the shape changes".into());
                }
                has_other_digits = true;
            }
            if (parts.materials, &parts.friction_text) != (own.materials, &own.friction_text) {
                return Err("a history in which friction or the bodies change".into());
            }
            if case.control.tangential() >= 2 && parts.slip != own.slip {
                return Err(
                    "slip added element by element (E) that changes from step to step".into()
                );
            }
            let way = way(places, index)?;
            match case.control.tangential() {
                0 if index == 0 => {
                    start.pressed = Some(parts.pressed);
                    continue;
                }
                1 if way == 0.0 && rows.is_empty() => {
                    start.shift(parts.shift_force(case)?, parts.pressed)?;
                    continue;
                }
                1 if way != 0.0 => distance += way.abs() * 1e-3,
                2 if way == 0.0 => {
                    distance += case.rolling.map_or(0.0, |rolling| rolling[1] * 1e-3);
                }
                3 if index == 0 => {
                    start.is_steady = true;
                    distance += case.rolling.map_or(0.0, |rolling| rolling[1] * 1e-3);
                }
                _ => return Err("a history that is not one of rolling steps".into()),
            }
            // The load of a shift is that from which rolling sets out.
            if rows.is_empty() {
                own.pressed = start.pressed.unwrap_or(own.pressed);
            }
            let is_given = |pressed| matches!(pressed, LoadOrApproach::Approach(_));
            if (is_given(parts.pressed) || is_given(own.pressed)) && parts.pressed != own.pressed {
                return Err("an approach that changes from step to step".into());
            }
            let mut row = parts.row(distance, usize::from(case.control.force().min(2)))?;
            if case.control.tangential() == 1 {
                // A shift by its way over that of the shape.
                for component in row.motion.iter_mut().skip(row.forces) {
                    *component /= way.abs();
                }
            }
            rows.push(row);
        }
        if has_other_digits {
            notes.push(
                "the shape is given in other words from case to case: it is the same to a thousandth, and taken as that \
                 of the last"
                    .into(),
            );
        }
        own.put_memory(notes);
        own.file_of_history(&rows, &start.keys(), (name, title), notes)
    }

    /// Whether bodies and friction are such that they roll step by step.
    fn is_of_steps(&self) -> Result<(), Cause> {
        let extra = &self.materials.extra;
        if !matches!(extra, Extra::None | Extra::Viscoelastic { .. } | Extra::Layer(_)) {
            return Err("a simplified theory in rolling step by step or on a line".into());
        }
        if self.needs_heat {
            return Err("friction by temperature in rolling step by step or on a line".into());
        }
        if self.needs_speed && self.case.control.tangential() == 1 {
            return Err("falling friction in shifts, which have no speed".into());
        }
        Ok(())
    }

    /// Gives falling friction without a memory the shortest one that rolling in steps knows.
    fn put_memory(&mut self, notes: &mut Vec<String>) {
        let has_memory = self.case.friction.as_ref().is_some_and(|read| read.memory.is_some());
        if !self.needs_speed || has_memory {
            return;
        }
        if let Some(law) = self.friction_text.strip_suffix(" }") {
            self.friction_text = format!("{law}, {SHORTEST_MEMORY} }}");
            notes.push(
                "falling friction without a memory (MEMDST = 0) has several solutions, between which tractions jump: ours \
                 has a memory of 10 nm of slip, less than any step resolves, and is the one that is reached from friction \
                 at rest. How that program searches (INISLP) has no counterpart"
                    .into(),
            );
        }
    }

    /// Whether it rolls, or the shape moves, in -x.
    fn goes_backward(&self, chain: &[Bodies], places: &[[f64; 2]]) -> Result<bool, Cause> {
        let mut found = None;
        for (index, case) in chain.iter().enumerate() {
            let way = way(places, index)?;
            let backward = match case.control.tangential() {
                2 | 3 => Parts::of(case, &mut Vec::new())?.turned,
                1 if way != 0.0 => way < 0.0,
                _ => continue,
            };
            if found.replace(backward).is_some_and(|before| before != backward) {
                return Err("a history that goes to and fro".into());
            }
        }
        let backward = found.unwrap_or(self.turned);
        if backward != self.turned && self.friction_text.starts_with('{') {
            return Err("a shape that moves in -x, with friction that is no constant".into());
        }
        Ok(backward)
    }

    /// What a step is given.
    fn row(&self, distance: f64, forces: usize) -> Result<Row, Cause> {
        let (mut motion, mut load) = (self.creepages(self.case), 0.0);
        if let LoadOrApproach::Load(given) = self.pressed {
            load = given;
        } else if forces > 0 {
            return Err("a given force over a friction force that is not known (N = 0)".into());
        }
        for (component, printed) in motion.iter_mut().zip(&self.case.kinematics[1..]).take(forces) {
            *component = self.relative_force(*printed) * self.friction * load;
        }
        Ok(Row { distance, load, motion, forces })
    }

    fn file_of_history(
        &self,
        rows: &[Row],
        start: &[(&str, String)],
        (name, title): (&str, &str),
        notes: &mut Vec<String>,
    ) -> Result<Written, Cause> {
        let is_line = matches!(self.geometry, Geometry::Line(_));
        if self.is_unlike() {
            notes.push(
                "the bodies are unlike: `roll` takes them as like, so the creepage of free rolling is lost".into(),
            );
        }
        let nominal = match (self.pressed, rows.first()) {
            (LoadOrApproach::Load(load), _) => load,
            (LoadOrApproach::Approach(_), first) => first.map_or(0.0, |row| row.load),
        };
        let load_changes = rows.iter().any(|row| row.load != nominal);
        let layer = self.layer();
        if load_changes && !layer.is_empty() {
            return Err("a load that changes from step to step, with a layer".into());
        }
        if load_changes && !matches!(self.geometry, Geometry::Radii(_)) {
            return Err("a load that changes from step to step on anything but an ellipse".into());
        }
        if load_changes {
            notes.push(
                "the load changes in a straight line over each step, not at its beginning".into(),
            );
        }
        let is_held = |row: &Row, k: usize| k < row.forces;
        let moves = |k: usize| rows.iter().any(|row| !is_held(row, k) && row.motion[k] != 0.0);
        if is_line && (moves(1) || moves(2)) {
            notes.push(
                "on a line we take lateral motion and spin where the command does; try it".into(),
            );
        }
        let csv = table(rows, load_changes, is_line);
        let speed = if self.needs_speed { number(self.speed()) } else { String::new() };
        let creepage: Vec<_> = self.needs_speed.then_some(("speed", speed)).into_iter().collect();
        let command = format!("creepage roll {name}.toml --history {name}.csv");
        let head = self.head(title, &command, notes);
        let sections = section("creepage", &creepage) + &section("start", start);
        let text = head + &self.bodies() + &self.contact(true) + &layer + &sections;
        let solve = section("solve", &[("theory", quoted("exact"))]);
        let mut written = Written::of(command, File::text(format!("{name}.toml"), text + &solve));
        written.files.push(File::text(format!("{name}.csv"), csv));
        Ok(written)
    }
}

/// What a step is given.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Row {
    /// So far (m).
    distance: f64,
    /// (N), zero at a given approach.
    load: f64,
    /// Creepages, spin (1/m), and in place of the first ones forces (N).
    motion: [f64; 3],
    /// How many of them are forces.
    forces: usize,
}

/// What a column has in a row, if anything.
type Cell = Box<dyn Fn(&Row) -> Option<f64>>;

/// The table of a history; of a component that is a force in some rows and a creepage in others it has both columns.
fn table(rows: &[Row], load_changes: bool, is_line: bool) -> String {
    let mut columns: Vec<(&str, Cell)> = vec![("distance", Box::new(|row| Some(row.distance)))];
    if load_changes {
        columns.push(("normal_force", Box::new(|row| Some(row.load))));
    }
    let names = ["longitudinal", "lateral", "spin"];
    for (k, force) in ["longitudinal_force", "lateral_force", ""].into_iter().enumerate() {
        let is_force = |row: &Row| k < row.forces;
        let is_other_than_zero = rows.iter().any(|row| row.motion[k] != 0.0);
        let held = rows.iter().any(is_force);
        let moves = rows.iter().any(|row| !is_force(row));
        if held && (k == 0 || !is_line || is_other_than_zero) {
            let value = move |row: &Row| (k < row.forces).then_some(row.motion[k]);
            columns.push((force, Box::new(value)));
        }
        if moves && (k == 0 || held || is_other_than_zero) {
            let value = move |row: &Row| (k >= row.forces).then_some(row.motion[k]);
            columns.push((names[k], Box::new(value)));
        }
    }
    let heads: Vec<_> = columns.iter().map(|(name, _)| *name).collect();
    let mut csv = heads.join(",") + "\n";
    for row in rows {
        let cells = columns.iter().map(|(_, value)| value(row).map_or(String::new(), number));
        csv += &(cells.collect::<Vec<_>>().join(",") + "\n");
    }
    csv
}

/// Whether two cases have one ellipse, to the digits of a file, in whatever words.
fn are_same_ellipse(one: &Parts<'_>, other: &Parts<'_>) -> bool {
    let semi_axes = |parts: &Parts<'_>| parts.geometry.semi_axes(parts.materials, parts.pressed);
    let (Some(one), Some(other)) = (semi_axes(one), semi_axes(other)) else { return false };
    (0..2).all(|axis| (one[axis] / other[axis] - 1.0).abs() < SAME)
}

/// How far the shape's middle has moved along x since the case before (mm).
fn way(places: &[[f64; 2]], index: usize) -> Result<f64, Cause> {
    let before = places[index.saturating_sub(1)];
    let [along, across] = [0, 1].map(|axis| places[index][axis] - before[axis]);
    if across == 0.0 { Ok(along) } else { Err("a shape that moves other than along x".into()) }
}
