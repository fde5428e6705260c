//! Conversion of the motion of a case's bodies: shifts and steady rolling.

use super::{Cause, Geometry, LoadOrApproach, Parts};
use crate::bodies::Bodies;
use crate::read::{Extra, Friction, Law};
use crate::text::{list, number, quoted, section};
use crate::{File, Written};

impl Parts<'_> {
    /// A shift from rest (T = 1).
    pub(super) fn shift(
        &self,
        chain: &[Bodies],
        name: &str,
        title: &str,
        notes: &mut Vec<String>,
    ) -> Result<Written, Cause> {
        let follows = self.case.control.history() == 0;
        if follows && chain.len() == 1 {
            return Err("a shift that follows a case which is not at hand (T = 1, P = 0)".into());
        }
        let [_, x, y, turn] = self.case.kinematics;
        let is_path = follows || (self.case.control.force() == 0 && (x != 0.0 || y != 0.0));
        let [x, y] = if is_path { [x, y] } else { self.shift_force(self.case)? };
        if self.is_unlike() && [x, y, turn] == [0.0; 3] {
            return self.compression(chain, name, title, notes);
        }
        if x == 0.0 && y == 0.0 && !is_path {
            notes.push("no force shifts the bodies: pressed only".into());
            return self.pressing(name, title, notes);
        }
        if self.needs_speed || self.friction_text.starts_with('{') {
            return Err("a shift with friction that is no constant".into());
        }
        if !self.layer().is_empty() {
            return Err("a shift with a layer".into());
        }
        if matches!(self.geometry, Geometry::Line(_) | Geometry::Gap(_)) {
            return Err("a shift with slip on anything but an ellipse".into());
        }
        if self.is_unlike() {
            notes.push("the bodies are unlike: the shift is solved as if they were like".into());
        }
        let command = format!("creepage statics {name}.toml");
        let keys = if is_path {
            self.path(chain)?
        } else {
            let problem = ("problem", quoted("partial-slip"));
            [problem, ("force_x", number(x)), ("force_y", number(y))]
        };
        let head = self.head(title, &command, notes);
        let text = head + &self.bodies() + &self.contact(true) + &section("statics", &keys);
        Ok(Written::of(command, File::text(format!("{name}.toml"), text)))
    }

    /// Unlike balls pressed together with friction, under a load that grew.
    fn compression(
        &self,
        chain: &[Bodies],
        name: &str,
        title: &str,
        notes: &[String],
    ) -> Result<Written, Cause> {
        let is_ball = match self.geometry {
            Geometry::Radii([first, second]) => first == second,
            Geometry::SemiAxes([a, b]) => a == b && chain.len() == 1,
            _ => false,
        };
        if !is_ball || self.friction_text.starts_with('{') {
            return Err(
                "unlike bodies pressed together with friction, other than balls under one \
                        coefficient of friction"
                    .into(),
            );
        }
        if !self.layer().is_empty() {
            return Err("a shift with a layer".into());
        }
        let mut before = 0.0;
        for case in chain {
            let parts = Parts::of(case, &mut Vec::new())?;
            let is_alone = matches!(case.control.tangential(), 0 | 1)
                && case.kinematics[1..] == [0.0; 3]
                && parts.geometry == self.geometry
                && parts.materials == self.materials
                && parts.friction_text == self.friction_text;
            match parts.pressed {
                LoadOrApproach::Load(load) if is_alone && load >= before => before = load,
                _ => {
                    return Err(
                        "unlike bodies pressed together with friction, other than under a load \
                                that grows"
                            .into(),
                    );
                }
            }
        }
        let command = format!("creepage statics {name}.toml");
        let keys = [("problem", quoted("compression"))];
        let head = self.head(title, &command, notes);
        let text = head + &self.bodies() + &self.contact(true) + &section("statics", &keys);
        Ok(Written::of(command, File::text(format!("{name}.toml"), text)))
    }

    /// One element sheared to and fro (T = 1), with a layer or without.
    pub(super) fn sheared_rectangle(
        &self,
        chain: &[Bodies],
        name: &str,
        title: &str,
        notes: &mut Vec<String>,
    ) -> Result<Written, Cause> {
        if self.case.control.history() == 0 && chain.len() == 1 {
            return Err("a shift that follows a case which is not at hand (T = 1, P = 0)".into());
        }
        if self.needs_speed || self.friction_text.starts_with('{') {
            return Err("a shift with friction that is no constant".into());
        }
        if self.is_unlike() {
            notes.push("the bodies are unlike: the shift is solved as if they were like".into());
        }
        let command = format!("creepage statics {name}.toml");
        let [_, along, steps] = self.path(chain)?;
        let keys = [("problem", quoted("sheared-rectangle")), along, steps];
        let head = self.head(title, &command, notes);
        let sections = self.layer() + &section("statics", &keys);
        let text = head + &self.bodies() + &self.contact(true) + &sections;
        Ok(Written::of(command, File::text(format!("{name}.toml"), text)))
    }

    /// The keys of a path of shifts along one axis, of which this case is the last.
    ///
    /// Where the load grows, that program first presses and then shifts; where it falls, friction gives way meanwhile.
    fn path(&self, chain: &[Bodies]) -> Result<[(&'static str, String); 3], Cause> {
        let is_way = self.case.control.force() == 0;
        let key = if is_way { "shift" } else { "force" };
        let LoadOrApproach::Load(nominal) = self.pressed else {
            return Err("a load path at a given approach of bodies other than balls (N = 0)".into());
        };
        let (mut steps, mut axis, mut at, mut under) = (Vec::new(), None, 0.0, nominal);
        for case in chain {
            let parts = Parts::of(case, &mut Vec::new())?;
            let is_like = parts.geometry == self.geometry
                && parts.materials.extra == self.materials.extra
                && parts.friction_text == self.friction_text;
            if !is_like {
                return Err("a load path along which shape, friction or layer change".into());
            }
            let LoadOrApproach::Load(load) = parts.pressed else {
                return Err(
                    "a load path at a given approach of bodies other than balls (N = 0)".into()
                );
            };
            let [_, x, y, turn] = case.kinematics;
            let here = match case.control.tangential() {
                0 => continue,
                1 if is_way && case.control.force() == 0 && turn == 0.0 => [x * 1e-3, y * 1e-3],
                1 if !is_way && case.control.force() > 0 => parts.shift_force(case)?,
                1 => return Err("a load path by forces and ways in turn, or with a twist".into()),
                _ => return Err("a load path that goes on from rolling".into()),
            };
            let along = match here {
                [_, 0.0] => 0,
                [0.0, _] => 1,
                _ => return Err("a load path that is not along one axis".into()),
            };
            if here != [0.0; 2] && axis.replace(along).is_some_and(|before| before != along) {
                return Err("a load path that changes its axis".into());
            }
            if load != under && matches!(self.geometry, Geometry::Rectangle(_)) {
                return Err("a load that changes over a single element of uniform pressure".into());
            }
            if load > under {
                let pressed = number(load);
                steps.push(format!("{{ normal_force = {pressed}, {key} = {} }}", number(at)));
            }
            // A way counts from the case before, a force by itself.
            at = if is_way { at + here[along] } else { here[along] };
            let falls = if load < under {
                format!("normal_force = {}, ", number(load))
            } else {
                String::new()
            };
            steps.push(format!("{{ {falls}{key} = {} }}", number(at)));
            under = load;
        }
        let along = quoted(if axis == Some(1) { "y" } else { "x" });
        let steps = format!("[{}]", steps.join(", "));
        Ok([("problem", quoted("shift-path")), ("along", along), ("steps", steps)])
    }

    /// The force on the lower body of a shift (N).
    pub(super) fn shift_force(&self, case: &Bodies) -> Result<[f64; 2], Cause> {
        let [_, x, y, turn] = case.kinematics;
        let given = match case.control.force() {
            0 if [x, y, turn].iter().all(|way| *way == 0.0) => return Ok([0.0; 2]),
            1 if y == 0.0 && turn == 0.0 => [x, 0.0],
            2 if turn == 0.0 => [x, y],
            _ => return Err("a shift that is given as a way, not by its force".into()),
        };
        let LoadOrApproach::Load(load) = self.pressed else {
            return Err("a shift under a given approach".into());
        };
        Ok(given.map(|part| self.relative_force(part) * self.friction * load))
    }

    pub(super) fn is_unlike(&self) -> bool {
        let [first, second] = [0, 1]
            .map(|k| (1.0 - 2.0 * self.materials.poisson[k]) / self.materials.shear_modulus[k]);
        (first - second).abs() > 1e-9 * first.abs().max(second.abs())
    }

    pub(super) fn speed(&self) -> f64 {
        self.case.rolling.map_or(0.0, |rolling| rolling[2] * 1e-3)
    }

    /// Creepages in our axes.
    pub(super) fn creepages(&self, case: &Bodies) -> [f64; 3] {
        let sign = if self.turned { -1.0 } else { 1.0 };
        let [_, x, y, spin] = case.kinematics;
        [sign * x, sign * y, spin * 1e3]
    }

    /// A force on the lower body over `mu N`, in our axes. That program's forces are over `FSTAT FN`, under friction row by
    /// row over `FN`.
    pub(super) fn relative_force(&self, printed: f64) -> f64 {
        let theirs = match self.case.friction.as_ref().map(|read| &read.friction) {
            Some(Friction::ByRow(_)) => 1.0,
            Some(Friction::One(Law::Coulomb { at_rest, .. })) => *at_rest,
            Some(Friction::One(Law::OfTemperature([reference, ..]))) => *reference,
            _ => self.friction,
        };
        let force =
            if theirs == self.friction { printed } else { printed * theirs / self.friction };
        if self.turned { force } else { -force }
    }

    /// Steady rolling (T = 3).
    pub(super) fn steady(
        &self,
        name: &str,
        title: &str,
        notes: &mut Vec<String>,
    ) -> Result<Written, Cause> {
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
            let LoadOrApproach::Load(load) = self.pressed else {
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
        let layer = self.layer();
        let heat = if self.needs_heat { self.heat()? } else { self.heat().unwrap_or_default() };
        let head = self.head(title, &command, notes);
        let sections = section("creepage", &creepage) + &section("wanted", &wanted) + &heat;
        let text = head + &self.bodies() + &self.contact(true) + &layer + &sections;
        Ok(Written::of(
            command,
            File::text(format!("{name}.toml"), text + &section("solve", &solve)),
        ))
    }

    fn theory(&self, notes: &mut Vec<String>) -> Result<Vec<(&'static str, String)>, Cause> {
        let changes = match self.materials.extra {
            Extra::ThreeFlexibilities { changes } | Extra::Fastrip { changes } => changes,
            _ => [1.0; 3],
        };
        // Without a fall, BETAMF says nothing.
        let is_changed = changes[0] != 1.0 || changes[1] != 1.0;
        let is_gap = matches!(self.geometry, Geometry::Gap(_));
        let is_simplified = matches!(
            self.materials.extra,
            Extra::ThreeFlexibilities { .. } | Extra::Fastrip { .. }
        );
        let is_wanted = self.case.control.force() > 0;
        let is_fastrip = matches!(self.materials.extra, Extra::Fastrip { .. });
        if is_changed && (is_wanted || is_gap || is_fastrip) {
            return Err("flexibilities that fall with creepage (K0_MF, ALFAMF, BETAMF) to a wanted force, on any \
                        shape, or in Fastrip"
                .into());
        }
        if is_simplified && !is_wanted && self.slip.is_some() {
            return Err("slip added element by element (E) in a simplified theory".into());
        }
        if is_simplified && is_wanted {
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
            Extra::ThreeFlexibilities { .. } => {
                let mut keys = vec![("theory", quoted("fastsim"))];
                if is_gap {
                    notes.push("FASTSIM with three flexibilities: ours blends them here".into());
                    return Ok(keys);
                }
                let bound = if self.case.control.bound() == 3 { "parabolic" } else { "elliptic" };
                keys.push(("flexibility", quoted("three")));
                keys.push(("bound", quoted(bound)));
                if is_changed {
                    keys.push(("reduction", list(changes)));
                }
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
                    if self.slip.is_some() {
                        notes.push(
                            "slip added element by element (E) is followed one-way: what traction does to the pressure \
                             of unlike bodies is left out"
                                .into(),
                        );
                    } else {
                        keys.push(("coupled", "true".into()));
                    }
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

    /// Whether it is a line contact in steady rolling along its own direction, under one coefficient of friction.
    pub(super) fn is_steady_line(&self) -> bool {
        let [_, _, y, spin] = self.case.kinematics;
        let is_along = y == 0.0 && spin == 0.0 && self.case.control.force() <= 2;
        matches!(self.geometry, Geometry::Line(_))
            && self.case.control.tangential() == 3
            && is_along
            && !self.needs_speed
            && !self.friction_text.starts_with('{')
            && !matches!(self.materials.extra, Extra::Layer(_))
    }

    /// Steady rolling on a line (T = 3).
    pub(super) fn steady_line(
        &self,
        name: &str,
        title: &str,
        notes: &[String],
    ) -> Result<Written, Cause> {
        let relaxation = match self.materials.extra {
            Extra::Viscoelastic { ratios: [ratio, other], times: [time, last] } => {
                let are_like = ratio == other && time == last && !self.is_unlike();
                if time == 0.0 && last == 0.0 {
                    String::new()
                } else if are_like {
                    section("relaxation", &[("ratio", number(ratio)), ("time", number(time))])
                } else {
                    return Err("viscoelastic bodies that are not alike (M = 1)".into());
                }
            }
            Extra::None => String::new(),
            _ => return Err("a simplified theory in rolling step by step or on a line".into()),
        };
        let (mut creepage, mut wanted) = (Vec::new(), Vec::new());
        if self.case.control.force() == 0 {
            let [along, ..] = self.creepages(self.case);
            creepage.push(("longitudinal", number(along)));
        } else if let LoadOrApproach::Load(_) = self.pressed {
            wanted.push(("fx", number(self.relative_force(self.case.kinematics[1]))));
        } else {
            return Err("a given force over a friction force that is not known (N = 0)".into());
        }
        if self.speed() > 0.0 {
            creepage.push(("speed", number(self.speed())));
        }
        let command = format!("creepage solve {name}.toml");
        let sections = section("creepage", &creepage) + &section("wanted", &wanted) + &relaxation;
        let text = self.head(title, &command, notes) + &self.bodies() + &self.contact(true);
        Ok(Written::of(command, File::text(format!("{name}.toml"), text + &sections)))
    }
}
