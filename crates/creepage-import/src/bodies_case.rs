//! A case of module 3 as a case file of creepage.

use crate::bodies::{Bodies, Shape};
use crate::read::{Extra, Friction, Law, Materials};
use crate::text::{comments, list, number, quoted, section};
use crate::{File, Written};

/// What has no counterpart, as the cause.
type Cause = String;

/// How the bodies touch, in SI units.
#[derive(Debug, Clone, PartialEq)]
enum Geometry {
    /// Radii along and across.
    Radii([f64; 2]),
    SemiAxes([f64; 2]),
    /// Radius, length.
    Line([f64; 2]),
    /// The section `[gap]`.
    Gap(String),
}

/// Load (N, N/m on a line) or approach (m).
#[derive(Debug, Clone, Copy, PartialEq)]
enum Pressed {
    Load(f64),
    Approach(f64),
}

/// What a file needs of a case.
#[derive(Debug, Clone, PartialEq)]
struct Parts<'a> {
    case: &'a Bodies,
    materials: &'a Materials,
    geometry: Geometry,
    pressed: Pressed,
    /// Coefficient at rest.
    friction: f64,
    friction_text: String,
    needs_speed: bool,
    /// Whether it rolls in -x, so that the axes are turned.
    turned: bool,
}

/// Writes a case; `chain` are the cases whose history it has, itself the last.
pub(crate) fn write(
    chain: &[Bodies],
    name: &str,
    title: &str,
    notes: &mut Vec<String>,
) -> Result<Written, Cause> {
    let Some(case) = chain.last() else { return Err("there is no case".into()) };
    let parts = Parts::of(case, notes)?;
    parts.note_what_is_left(notes);
    match case.control.tangential() {
        0 => parts.pressing(name, title, notes),
        1 => parts.shift(chain, name, title, notes),
        2 => parts.history(chain, name, title, notes),
        3 if matches!(parts.geometry, Geometry::Line(_)) => {
            parts.history(&chain[chain.len() - 1..], name, title, notes)
        }
        3 => parts.steady(name, title, notes),
        other => Err(format!("T = {other} is no kind of motion that we know")),
    }
}

impl<'a> Parts<'a> {
    fn of(case: &'a Bodies, notes: &mut Vec<String>) -> Result<Self, Cause> {
        let materials = case.materials.as_ref().ok_or("no case has given materials (C = 2)")?;
        let chi = case.rolling.map_or(0.0, |rolling| rolling[0]);
        let turned = match case.control.tangential() {
            2 | 3 if (chi.abs() - std::f64::consts::PI).abs() < 1e-5 => true,
            2 | 3 if chi.abs() > 1e-9 => {
                return Err(format!("it rolls at {} rad to x", number(chi)));
            }
            _ => false,
        };
        if let Extra::Viscoelastic { times } = &materials.extra
            && times.iter().any(|time| *time > 0.0)
        {
            return Err("viscoelastic bodies (M = 1)".into());
        }
        if case.has_added_slip {
            return Err("slip added element by element (E)".into());
        }
        if case.planform != 1 {
            return Err("a contact area that is bounded beforehand (IPLAN)".into());
        }
        let (geometry, pressed) = geometry(case, materials, turned, notes)?;
        let (friction, friction_text, needs_speed) = friction(case, turned, notes)?;
        Ok(Self {
            case,
            materials,
            geometry,
            pressed,
            friction,
            friction_text,
            needs_speed,
            turned,
        })
    }

    fn note_what_is_left(&self, notes: &mut Vec<String>) {
        let control = self.case.control;
        if control.heat() >= 1 {
            notes.push("the temperature (H) has no counterpart".into());
        }
        if control.stress() >= 1 {
            notes.push("points below the surface (S): ask `creepage stresses` for them".into());
        }
        if control.influence() == 3 {
            notes.push("influence numbers C = 3: our elements have their own".into());
        }
        if matches!(control.influence(), 4 | 9) {
            notes.push(
                "influence numbers other than a half-space's (C = 4, 9) have no counterpart".into(),
            );
        }
        let hertzian = matches!(self.geometry, Geometry::Radii(_) | Geometry::SemiAxes(_));
        if control.bound() >= 2 && !(hertzian && control.bound() <= 3) {
            notes.push(
                "the simplified pressure (B) has no counterpart: ours is the half-space's".into(),
            );
        }
        if control.bound() == 3 && !matches!(self.materials.extra, Extra::ThreeFlexibilities { .. })
        {
            notes.push("the parabolic bound (B = 3) has no counterpart in this theory".into());
        }
    }

    fn head(&self, title: &str, command: &str, notes: &[String]) -> String {
        let signs = match (self.case.control.tangential(), self.turned) {
            (0, _) => String::new(),
            (_, false) => {
                "Signs: F_x, F_y, M_z of reports act on the lower body: CONTACT's, on body 1, \
                           with the other sign."
                    .into()
            }
            (_, true) => {
                "Signs: it rolled in -x. Our x, y are CONTACT's -x, -y: F_x, F_y are its own, \
                          M_z has the other sign."
                    .into()
            }
        };
        let mut lines = vec![title.to_string(), format!("Run: {command}")];
        lines.extend((!signs.is_empty()).then_some(signs));
        lines.extend(notes.iter().map(|note| format!("Not as it was: {note}")));
        comments(&lines)
    }

    fn bodies(&self) -> String {
        let mut text = String::new();
        for (index, body) in ["upper", "lower"].into_iter().enumerate() {
            let mut keys = vec![
                ("shear_modulus", number(self.materials.shear_modulus[index] * 1e6)),
                ("poisson", number(self.materials.poisson[index])),
            ];
            if let Geometry::Radii(radii) = self.geometry {
                let flat = || quoted("flat");
                let radius = |axis: usize| if index == 0 { number(radii[axis]) } else { flat() };
                keys.extend([("radius_rolling", radius(0)), ("radius_lateral", radius(1))]);
            }
            text += &section(body, &keys);
        }
        text
    }

    fn contact(&self, with_friction: bool) -> String {
        let mut keys = Vec::new();
        match (&self.geometry, self.pressed) {
            (Geometry::Line([radius, length]), Pressed::Load(load)) => {
                keys.push(("line_load", number(load)));
                keys.push(("radius_rolling", number(*radius)));
                keys.push(("length", number(*length)));
            }
            (_, Pressed::Load(load)) => keys.push(("normal_force", number(load))),
            (_, Pressed::Approach(approach)) => keys.push(("approach", number(approach))),
        }
        if let Geometry::SemiAxes([a, b]) = self.geometry {
            keys.push(("semi_axis_rolling", number(a)));
            keys.push(("semi_axis_lateral", number(b)));
        }
        if with_friction {
            keys.push(("friction", self.friction_text.clone()));
        }
        let gap = match &self.geometry {
            Geometry::Gap(text) => format!("\n[gap]\n{text}"),
            _ => String::new(),
        };
        gap + &section("contact", &keys)
    }

    fn layer(&self) -> Result<String, Cause> {
        let Extra::Layer([modulus, thickness, yield_stress, slope]) = self.materials.extra else {
            return Ok(String::new());
        };
        if thickness <= 0.0 {
            return Err("a layer (M = 4) without thickness, which yields only".into());
        }
        let mut keys =
            vec![("thickness", number(thickness * 1e-3)), ("shear_modulus", number(modulus * 1e6))];
        if yield_stress > 0.0 {
            keys.push(("yield_stress", number(yield_stress * 1e6)));
            keys.push(("slope", number(slope * 1e9)));
        }
        Ok(section("layer", &keys))
    }

    /// Bodies pressed together without friction.
    fn pressing(&self, name: &str, title: &str, notes: &[String]) -> Result<Written, Cause> {
        if matches!(self.geometry, Geometry::Line(_)) {
            return Err("a line contact that is pressed only".into());
        }
        let command = format!("creepage hertz {name}.toml");
        let head = self.head(title, &command, notes);
        let is_gap = matches!(self.geometry, Geometry::Gap(_));
        let text = head + &self.bodies() + &self.contact(is_gap);
        Ok(Written::of(command, File::text(format!("{name}.toml"), text)))
    }

    /// A shift from rest (T = 1).
    fn shift(
        &self,
        chain: &[Bodies],
        name: &str,
        title: &str,
        notes: &mut Vec<String>,
    ) -> Result<Written, Cause> {
        if chain.len() > 1 || self.case.control.history() == 0 {
            return Err("a load path: a shift that follows another case (T = 1, P = 0)".into());
        }
        let [x, y] = self.shift_force(self.case)?;
        if x == 0.0 && y == 0.0 {
            if self.is_unlike() {
                return Err("unlike bodies pressed together with friction".into());
            }
            notes.push("no force shifts the bodies: pressed only".into());
            return self.pressing(name, title, notes);
        }
        if self.needs_speed || self.friction_text.starts_with('{') {
            return Err("a shift with friction that is no constant".into());
        }
        if !self.layer()?.is_empty() {
            return Err("a shift with a layer".into());
        }
        if matches!(self.geometry, Geometry::Line(_) | Geometry::Gap(_)) {
            return Err("a shift with slip on anything but an ellipse".into());
        }
        if self.is_unlike() {
            notes.push("the bodies are unlike: the shift is solved as if they were like".into());
        }
        let command = format!("creepage statics {name}.toml");
        let keys =
            [("problem", quoted("partial-slip")), ("force_x", number(x)), ("force_y", number(y))];
        let head = self.head(title, &command, notes);
        let text = head + &self.bodies() + &self.contact(true) + &section("statics", &keys);
        Ok(Written::of(command, File::text(format!("{name}.toml"), text)))
    }

    /// The force on the lower body of a shift (N).
    fn shift_force(&self, case: &Bodies) -> Result<[f64; 2], Cause> {
        let [_, x, y, turn] = case.kinematics;
        let given = match case.control.force() {
            0 if [x, y, turn].iter().all(|way| *way == 0.0) => return Ok([0.0; 2]),
            1 if y == 0.0 && turn == 0.0 => [x, 0.0],
            2 if turn == 0.0 => [x, y],
            _ => return Err("a shift that is given as a way, not by its force".into()),
        };
        let Pressed::Load(load) = self.pressed else {
            return Err("a shift under a given approach".into());
        };
        Ok(given.map(|part| -part * self.friction * load))
    }

    fn is_unlike(&self) -> bool {
        let [first, second] = [0, 1]
            .map(|k| (1.0 - 2.0 * self.materials.poisson[k]) / self.materials.shear_modulus[k]);
        (first - second).abs() > 1e-9 * first.abs().max(second.abs())
    }

    fn speed(&self) -> f64 {
        self.case.rolling.map_or(0.0, |rolling| rolling[2] * 1e-3)
    }

    /// Creepages in our axes.
    fn creepages(&self, case: &Bodies) -> [f64; 3] {
        let sign = if self.turned { -1.0 } else { 1.0 };
        let [_, x, y, spin] = case.kinematics;
        [sign * x, sign * y, spin * 1e3]
    }

    /// A force on the lower body over `mu N`, in our axes.
    fn relative_force(&self, printed: f64) -> f64 {
        if self.turned { printed } else { -printed }
    }

    /// Steady rolling (T = 3).
    fn steady(&self, name: &str, title: &str, notes: &mut Vec<String>) -> Result<Written, Cause> {
        let creepages = self.creepages(self.case);
        let forces = usize::from(self.case.control.force().min(2));
        let (mut creepage, mut wanted) = (Vec::new(), Vec::new());
        let is_gap = matches!(self.geometry, Geometry::Gap(_));
        for (k, name) in ["longitudinal", "lateral", "spin"].into_iter().enumerate() {
            if k >= forces {
                creepage.push((name, number(creepages[k])));
                continue;
            }
            let force = self.relative_force(self.case.kinematics[1 + k]);
            let Pressed::Load(load) = self.pressed else {
                return Err("a given force over a friction force that is not known (N = 0)".into());
            };
            if is_gap {
                let name = ["longitudinal_force", "lateral_force"][k];
                wanted.push((name, number(force * self.friction * load)));
            } else {
                wanted.push((["fx", "fy"][k], number(force)));
            }
        }
        if self.speed() > 0.0 {
            creepage.push(("speed", number(self.speed())));
        }
        let solve = self.theory(notes)?;
        let command = format!("creepage solve {name}.toml");
        let layer = self.layer()?;
        let head = self.head(title, &command, notes);
        let sections = section("creepage", &creepage) + &section("wanted", &wanted);
        let text = head + &self.bodies() + &self.contact(true) + &layer + &sections;
        Ok(Written::of(
            command,
            File::text(format!("{name}.toml"), text + &section("solve", &solve)),
        ))
    }

    fn theory(&self, notes: &mut Vec<String>) -> Result<Vec<(&'static str, String)>, Cause> {
        let unchanged = |changes: &[f64; 3]| changes.iter().all(|change| *change == 1.0);
        let is_gap = matches!(self.geometry, Geometry::Gap(_));
        let is_simplified = matches!(
            self.materials.extra,
            Extra::ThreeFlexibilities { .. } | Extra::Fastrip { .. }
        );
        if is_simplified && self.case.control.force() > 0 {
            notes.push(
                "FASTSIM to a wanted force (M = 3, 5 with F = 1, 2): ours finds no creepage, so it is by the \
                 full theory"
                    .into(),
            );
            return Ok(vec![("theory", quoted("exact"))]);
        }
        match &self.materials.extra {
            Extra::OneFlexibility => {
                Err("the simplified theory with a given flexibility (M = 2)".into())
            }
            Extra::ThreeFlexibilities { changes } | Extra::Fastrip { changes }
                if !unchanged(changes) =>
            {
                Err("the simplified theory with changed flexibilities (K0_MF, ALFAMF, BETAMF)"
                    .into())
            }
            Extra::ThreeFlexibilities { .. } => {
                let mut keys = vec![("theory", quoted("fastsim"))];
                if is_gap {
                    notes.push("FASTSIM with three flexibilities: ours blends them here".into());
                    return Ok(keys);
                }
                let bound = if self.case.control.bound() == 3 { "parabolic" } else { "elliptic" };
                keys.push(("flexibility", quoted("three")));
                keys.push(("bound", quoted(bound)));
                keys.extend(self.cells().map(|cells| ("grid", cells)));
                Ok(keys)
            }
            Extra::Fastrip { .. } => {
                let mut keys = vec![("theory", quoted("fastrip"))];
                keys.extend(self.cells().filter(|_| !is_gap).map(|cells| ("grid", cells)));
                Ok(keys)
            }
            _ => {
                let mut keys = vec![("theory", quoted("exact"))];
                if self.is_unlike() && self.case.control.outer_rounds() > 1.0 && !is_gap {
                    keys.push(("coupled", "true".into()));
                }
                Ok(keys)
            }
        }
    }

    /// The cells in the ellipse itself.
    fn cells(&self) -> Option<String> {
        let grid = self.case.grid.filter(|grid| grid.kind < 0 && grid.size[0] > 0.0)?;
        let cells = grid.elements.map(|count| (count as f64 / grid.size[0]).round().max(2.0));
        Some(format!("[{}, {}]", cells[0], cells[1]))
    }

    /// Rolling from step to step (T = 2), or steadily on a line.
    fn history(
        &self,
        chain: &[Bodies],
        name: &str,
        title: &str,
        notes: &mut Vec<String>,
    ) -> Result<Written, Cause> {
        if !self.layer()?.is_empty() {
            return Err("a layer in rolling step by step or on a line".into());
        }
        if !matches!(self.materials.extra, Extra::None | Extra::Viscoelastic { .. }) {
            return Err("a simplified theory in rolling step by step or on a line".into());
        }
        let has_memory = self.case.friction.as_ref().is_some_and(|read| read.memory.is_some());
        if self.needs_speed && !has_memory {
            return Err(
                "falling friction without memory in rolling step by step or on a line".into()
            );
        }
        let mut start = vec![("traction", quoted("none"))];
        let (mut rows, mut distance, mut kind) = (Vec::new(), 0.0, None);
        for (index, case) in chain.iter().enumerate() {
            let parts = Parts::of(case, &mut Vec::new())?;
            if (&parts.geometry, parts.turned) != (&self.geometry, self.turned) && index > 0 {
                return Err("a history in which the shape changes".into());
            }
            match (case.control.tangential(), index) {
                (1, 0) => {
                    let [x, y] = parts.shift_force(case)?;
                    if x != 0.0 || y != 0.0 {
                        start = vec![
                            ("traction", quoted("shift")),
                            ("longitudinal_force", number(x)),
                            ("lateral_force", number(y)),
                        ];
                    }
                    continue;
                }
                (2, _) => {}
                (3, 0) => start = vec![("traction", quoted("steady"))],
                _ => return Err("a history that is not one of rolling steps".into()),
            }
            let forces = case.control.force().min(2);
            if kind.is_some_and(|kind| kind != forces) {
                return Err("a history in which forces and creepages change places".into());
            }
            kind = Some(forces);
            distance += case.rolling.map_or(0.0, |rolling| rolling[1] * 1e-3);
            rows.push(parts.row(distance, usize::from(forces))?);
        }
        let forces = usize::from(kind.unwrap_or(0));
        self.file_of_history(&rows, forces, &start, (name, title), notes)
    }

    /// Distance, load, then the three components.
    fn row(&self, distance: f64, forces: usize) -> Result<[f64; 5], Cause> {
        let (mut components, mut load) = (self.creepages(self.case), 0.0);
        if let Pressed::Load(given) = self.pressed {
            load = given;
        } else if forces > 0 {
            return Err("a given force over a friction force that is not known (N = 0)".into());
        }
        for (component, printed) in
            components.iter_mut().zip(&self.case.kinematics[1..]).take(forces)
        {
            *component = self.relative_force(*printed) * self.friction * load;
        }
        let [x, y, spin] = components;
        Ok([distance, load, x, y, spin])
    }

    fn file_of_history(
        &self,
        rows: &[[f64; 5]],
        forces: usize,
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
        let load_changes = rows.windows(2).any(|pair| pair[0][1] != pair[1][1]);
        if load_changes && !matches!(self.geometry, Geometry::Radii(_)) {
            return Err("a load that changes from step to step on anything but an ellipse".into());
        }
        if load_changes {
            notes.push(
                "the load changes in a straight line over each step, not at its beginning".into(),
            );
        }
        let is_used = |k: usize| rows.iter().any(|row| row[2 + k] != 0.0);
        if is_line && (is_used(1) && forces < 2 || is_used(2)) {
            notes.push(
                "on a line we take lateral motion and spin where the command does; try it".into(),
            );
        }
        let names = ["longitudinal", "lateral", "spin"];
        let force_names = ["longitudinal_force", "lateral_force"];
        let mut columns = vec![("distance", 0)];
        columns.extend(load_changes.then_some(("normal_force", 1)));
        for k in 0..3 {
            let name = if k < forces { force_names[k] } else { names[k] };
            let needed = k == 0 || is_used(k) || k < forces && !is_line;
            columns.extend(needed.then_some((name, 2 + k)));
        }
        let heads: Vec<_> = columns.iter().map(|(name, _)| *name).collect();
        let mut csv = heads.join(",") + "\n";
        for row in rows {
            let values: Vec<_> = columns.iter().map(|(_, place)| number(row[*place])).collect();
            csv += &(values.join(",") + "\n");
        }
        let speed = if self.needs_speed { number(self.speed()) } else { String::new() };
        let creepage: Vec<_> = self.needs_speed.then_some(("speed", speed)).into_iter().collect();
        let command = format!("creepage roll {name}.toml --history {name}.csv");
        let head = self.head(title, &command, notes);
        let sections = section("creepage", &creepage) + &section("start", start);
        let text = head + &self.bodies() + &self.contact(true) + &sections;
        let solve = section("solve", &[("theory", quoted("exact"))]);
        let mut written = Written::of(command, File::text(format!("{name}.toml"), text + &solve));
        written.files.push(File::text(format!("{name}.csv"), csv));
        Ok(written)
    }
}

fn geometry(
    case: &Bodies,
    materials: &Materials,
    turned: bool,
    notes: &mut Vec<String>,
) -> Result<(Geometry, Pressed), Cause> {
    let grid = case.grid.ok_or("no case has given a grid (D = 2)")?;
    let [load, ..] = case.kinematics;
    let has_load = case.control.has_load();
    if grid.elements == [1, 1] {
        return Err("a single element of constant pressure".into());
    }
    let [first, second] = grid.first;
    let curvatures = match grid.kind {
        -1 => [first, second],
        -2 => [first, first * ratio_of_curvatures(second)?],
        -3 if has_load => {
            return Ok((Geometry::SemiAxes([first * 1e-3, second * 1e-3]), Pressed::Load(load)));
        }
        -3 => return Err("an approach with the semi-axes given (IPOTCN = -3, N = 0)".into()),
        kind if kind < 0 => return Err(format!("IPOTCN = {kind}: two half ellipses, or a box")),
        _ => {
            return shaped(case, materials, turned, notes);
        }
    };
    smooth(case, materials, curvatures, 0.0, notes)
}

/// Bodies of constant curvatures (1/mm), `offset` apart (mm).
fn smooth(
    case: &Bodies,
    materials: &Materials,
    curvatures: [f64; 2],
    offset: f64,
    notes: &mut Vec<String>,
) -> Result<(Geometry, Pressed), Cause> {
    let [first, second] = curvatures;
    if !(first > 0.0 && second > 0.0) {
        return Err("curvatures that are not above zero".into());
    }
    let radii = curvatures.map(|curvature| 0.5e-3 / curvature);
    let [load, ..] = case.kinematics;
    if case.control.has_load() {
        return Ok((Geometry::Radii(radii), Pressed::Load(load)));
    }
    let approach = (load - offset) * 1e-3;
    if case.control.tangential() < 3 && (first - second).abs() < 1e-6 * first && approach > 0.0 {
        // Hertz's sphere: what shifts and rolls in steps needs a load.
        let compliance: f64 =
            (0..2).map(|k| (1.0 - materials.poisson[k]) / (2e6 * materials.shear_modulus[k])).sum();
        let load = 4.0 / 3.0 / compliance * radii[0].sqrt() * approach.powf(1.5);
        notes.push("the load is Hertz's at the given approach".into());
        return Ok((Geometry::Radii(radii), Pressed::Load(load)));
    }
    let terms = format!(
        "polynomial = [[2, 0, {}], [0, 2, {}]]\n",
        number(first * 1e3),
        number(second * 1e3)
    );
    Ok((Geometry::Gap(terms), Pressed::Approach(approach)))
}

/// A shape on a grid of elements (IPOTCN > 0).
fn shaped(
    case: &Bodies,
    materials: &Materials,
    turned: bool,
    notes: &mut Vec<String>,
) -> Result<(Geometry, Pressed), Cause> {
    let grid = case.grid.ok_or("no case has given a grid (D = 2)")?;
    let shape = case.shape.as_ref().ok_or("no case has given a shape (Z = 1, 2)")?;
    let [load, ..] = case.kinematics;
    if grid.elements[1] == 1 {
        return line(case, shape, notes);
    }
    if let Shape::Quadratic([first, mixed, second, x, y, offset]) = *shape
        && [mixed, x, y].iter().all(|term| *term == 0.0)
    {
        return smooth(case, materials, [first, second], offset, notes);
    }
    let pressed =
        if case.control.has_load() { Pressed::Load(load) } else { Pressed::Approach(load * 1e-3) };
    let sign: f64 = if turned { -1.0 } else { 1.0 };
    let text = match shape {
        Shape::Quadratic(b) => {
            let powers = [[2, 0], [1, 1], [0, 2], [1, 0], [0, 1], [0, 0]];
            let terms: Vec<_> = powers
                .iter()
                .zip(b)
                .filter(|(_, value)| **value != 0.0)
                .map(|([i, j], value)| {
                    // Metres: mm times (1/mm) to the power.
                    let si = value * 1e-3 * 1e3_f64.powi(i + j) * sign.powi(i + j);
                    format!("[{i}, {j}, {}]", number(si))
                })
                .collect();
            format!("polynomial = [{}]\n", terms.join(", "))
        }
        Shape::Circular { radius, middle, first, step, points } => {
            if *radius <= 0.0 || *step <= 0.0 {
                return Err("a radius or a step across that is not above zero (IBASE = 2)".into());
            }
            let mut places: Vec<(f64, f64)> = (0..points.len())
                .map(|k| (sign * (first + k as f64 * step) * 1e-3, points[k] * 1e-3))
                .collect();
            if turned {
                places.reverse();
            }
            let y = list(places.iter().map(|place| place.0));
            let gap = list(places.iter().map(|place| place.1));
            let columns = if *middle == 0.0 {
                format!("{{ y = {y}, gap = {gap} }}")
            } else {
                let x = list(places.iter().map(|_| sign * middle * 1e-3));
                format!("{{ y = {y}, gap = {gap}, x = {x} }}")
            };
            format!("section = {columns}\nradius_rolling = {}\n", number(radius * 1e-3))
        }
        Shape::WithSines => return Err("a shape with sine waves (IBASE = 3)".into()),
        Shape::Points(points) => {
            let [count, _] = grid.elements;
            let place = |axis, index| sign * grid.middle(axis, index) * 1e-3;
            let x = list((0..points.len()).map(|k| place(0, k % count)));
            let y = list((0..points.len()).map(|k| place(1, k / count)));
            let gap = list(points.iter().map(|value| value * 1e-3));
            format!("grid = {{ x = {x}, y = {y}, gap = {gap} }}\n")
        }
    };
    Ok((Geometry::Gap(text), pressed))
}

/// One row of elements: a line contact.
fn line(
    case: &Bodies,
    shape: &Shape,
    notes: &mut Vec<String>,
) -> Result<(Geometry, Pressed), Cause> {
    let grid = case.grid.ok_or("no case has given a grid (D = 2)")?;
    let radius = match *shape {
        Shape::Quadratic([curvature, _, _, _, _, _]) if curvature > 0.0 => 0.5 / curvature,
        Shape::Circular { radius, .. } if radius > 0.0 => radius,
        _ => return Err("a line contact that is not of cylinders".into()),
    };
    if let Shape::Quadratic([_, _, _, x, _, _]) = *shape
        && x != 0.0
    {
        notes.push("the line contact's place along x (B4) is put at x = 0".into());
    }
    if !case.control.has_load() {
        return Err("a line contact at a given approach, which depends on the length".into());
    }
    // Forces of a line contact are per length.
    let [load, ..] = case.kinematics;
    let length = grid.size[1] * 1e-3;
    notes.push(format!(
        "one row of elements {} m wide is a line contact: forces are per metre",
        number(length)
    ));
    Ok((Geometry::Line([radius * 1e-3, length]), Pressed::Load(load / length)))
}

/// Curvature across over that along, for semi-axes a, b in the ratio a/b.
fn ratio_of_curvatures(ratio: f64) -> Result<f64, Cause> {
    if !(ratio > 0.0 && ratio.is_finite()) {
        return Err("a ratio of semi-axes that is not above zero".into());
    }
    if (ratio - 1.0).abs() < 1e-9 {
        return Ok(1.0);
    }
    // Hertz: curvatures along the longer and the shorter axis are as K - E to E/(1 - e2) - K.
    let shorter = ratio.min(1.0 / ratio);
    let squared = 1.0 - shorter * shorter;
    let [first, second] = elliptic_integrals(shorter);
    let longer_over_shorter = (first - second) / (second / (1.0 - squared) - first);
    Ok(if ratio > 1.0 { 1.0 / longer_over_shorter } else { longer_over_shorter })
}

/// Complete elliptic integrals K and E at the complementary modulus, by arithmetic-geometric means.
fn elliptic_integrals(complementary: f64) -> [f64; 2] {
    let (mut a, mut b) = (1.0_f64, complementary);
    let mut sum = 0.5 * (1.0 - b * b);
    let mut power = 1.0;
    // Each mean doubles the digits.
    for _ in 0..12 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        sum += power * c * c;
        power *= 2.0;
    }
    let first = std::f64::consts::FRAC_PI_2 / a;
    [first, first * (1.0 - sum)]
}

/// The coefficient at rest, the text of it, and whether the speed counts.
fn friction(
    case: &Bodies,
    turned: bool,
    notes: &mut Vec<String>,
) -> Result<(f64, String, bool), Cause> {
    let read = case.friction.as_ref().ok_or("no case has given friction (L)")?;
    match &read.friction {
        Friction::One(law) => law_text(law, read.memory, notes),
        Friction::ByRow(laws) => by_row(case, laws, turned),
        Friction::ByAngle(_) | Friction::Along(_) => {
            Err("friction by angle or along the track on given bodies".into())
        }
    }
}

/// A law as a case file has it: the coefficient at rest, the text, whether the speed counts.
pub(crate) fn law_text(
    law: &Law,
    memory: Option<[f64; 2]>,
    notes: &mut Vec<String>,
) -> Result<(f64, String, bool), Cause> {
    match law {
        Law::Coulomb { at_rest, kinetic } => {
            if at_rest != kinetic {
                notes.push(format!(
                    "FSTAT = {} beside FKIN = {}: FKIN is taken for both",
                    number(*at_rest),
                    number(*kinetic)
                ));
            }
            Ok((*kinetic, number(*kinetic), false))
        }
        Law::Falling { name, kinetic, terms } => {
            // In rational laws a term's place is its power.
            let used = if terms[1][0] == 0.0 { usize::from(terms[0][0] != 0.0) } else { 2 };
            let texts: Vec<_> = terms[..used]
                .iter()
                .map(|[drop, speed]| {
                    let (drop, speed) = (number(*drop), number(speed * 1e-3));
                    format!("{{ drop = {drop}, half_speed = {speed} }}")
                })
                .collect();
            let rest = kinetic + terms[..used].iter().map(|term| term[0]).sum::<f64>();
            let memory = memory.map_or(String::new(), |[distance, speed]| {
                let (distance, speed) = (number(distance * 1e-3), number(speed * 1e-3));
                format!(", memory_distance = {distance}, memory_speed = {speed}")
            });
            if used == 0 {
                return Ok((rest, number(rest), false));
            }
            let text = format!(
                "{{ law = {}, kinetic = {}, terms = [{}]{memory} }}",
                quoted(name),
                number(*kinetic),
                texts.join(", ")
            );
            Ok((rest, text, true))
        }
        Law::OfTemperature => Err("friction that depends on the temperature (L = 6)".into()),
    }
}

/// Friction row by row, where few straight lines say it.
fn by_row(case: &Bodies, laws: &[Law], turned: bool) -> Result<(f64, String, bool), Cause> {
    let grid = case.grid.filter(|grid| grid.kind > 0);
    let grid = grid.ok_or("friction row by row on an ellipse that is given by its axes")?;
    let sign = if turned { -1.0 } else { 1.0 };
    let mut points = Vec::new();
    for (row, law) in laws.iter().enumerate() {
        match law {
            Law::Coulomb { at_rest, kinetic } if at_rest == kinetic => {
                points.push([sign * grid.middle(1, row) * 1e-3, *kinetic]);
            }
            _ => return Err("friction row by row by a law, or with two coefficients".into()),
        }
    }
    if turned {
        points.reverse();
    }
    let corners = corners(&points);
    if corners.len() > 7 {
        return Err("friction row by row that takes more than seven straight points".into());
    }
    let largest = points.iter().map(|point| point[1]).fold(0.0, f64::max);
    let pairs: Vec<_> = corners.iter().map(|point| list(*point)).collect();
    Ok((largest, format!("{{ across = [{}] }}", pairs.join(", ")), false))
}

/// The points at which a line through all of them bends.
fn corners(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let inner = points.windows(3).filter(|three| {
        let slope = |k: usize| (three[k + 1][1] - three[k][1]) / (three[k + 1][0] - three[k][0]);
        let bend = (slope(1) - slope(0)) * (three[2][0] - three[0][0]);
        // A millionth of a coefficient is what the digits of a file can tell.
        bend.abs() > 1e-6
    });
    let ends = points.first().into_iter().copied();
    let last = points.last().filter(|_| points.len() > 1).copied();
    ends.chain(inner.map(|three| three[1])).chain(last).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hertzs_ratio_is_that_of_tables() {
        // a/b = 2 along the longer axis: K and E at e2 = 3/4 are 2.15651565 and 1.21105603
        // (Abramowitz and Stegun, table 17.1, by interpolation to 1e-6).
        let expected = (1.211_056 / 0.25 - 2.156_516) / (2.156_516 - 1.211_056);
        let found = ratio_of_curvatures(2.0).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected}");
        assert!((ratio_of_curvatures(0.5).unwrap() * found - 1.0).abs() < 1e-12);
        assert!((ratio_of_curvatures(1.001).unwrap() - 1.0).abs() < 0.01);
    }

    #[test]
    fn corners_are_where_lines_bend() {
        let points = [[0.0, 0.1], [1.0, 0.2], [2.0, 0.3], [3.0, 0.3], [4.0, 0.3]];
        assert_eq!(corners(&points), [[0.0, 0.1], [2.0, 0.3], [4.0, 0.3]]);
    }
}
