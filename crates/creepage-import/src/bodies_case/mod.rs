//! Conversion of a case of module 3 to a case file of creepage.

mod friction;
mod geometry;
mod history;
mod motion;
mod slip;

use crate::bodies::Bodies;
use crate::read::{Extra, FrictionRead, Materials};
use crate::text::{comments, heat_section, number, quoted, section};
use crate::{File, Written};
use friction::friction;
pub(crate) use friction::law_text;
use geometry::{centred, geometry};
use slip::added_slip;

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
    /// One element of uniform pressure: half-lengths.
    Rectangle([f64; 2]),
    /// The section `[gap]`.
    Gap(String),
}

/// Load (N, N/m on a line) or approach (m).
#[derive(Debug, Clone, Copy, PartialEq)]
enum LoadOrApproach {
    Load(f64),
    Approach(f64),
}

/// What a file needs of a case.
#[derive(Debug, Clone, PartialEq)]
struct Parts<'a> {
    case: &'a Bodies,
    materials: &'a Materials,
    geometry: Geometry,
    pressed: LoadOrApproach,
    /// Coefficient at rest.
    friction: f64,
    friction_text: String,
    needs_speed: bool,
    /// Whether friction depends on the temperature.
    needs_heat: bool,
    /// Rigid slip from place to place.
    slip: Option<String>,
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
    let (chain, places): (Vec<_>, Vec<_>) = chain.iter().map(centred).unzip();
    let Some(case) = chain.last() else { return Err("there is no case".into()) };
    let parts = Parts::of(case, notes)?;
    parts.note_what_is_left(notes);
    let moves = places.windows(2).any(|pair| pair[0] != pair[1]);
    match case.control.tangential() {
        0 => parts.pressing(name, title, notes),
        1 if matches!(parts.geometry, Geometry::Rectangle(_)) => {
            parts.sheared_rectangle(&chain, name, title, notes)
        }
        2 | 3 if matches!(parts.geometry, Geometry::Rectangle(_)) => {
            Err("rolling of a single element of uniform pressure".into())
        }
        1 if !moves => parts.shift(&chain, name, title, notes),
        1 | 2 => parts.history(&chain, &places, (name, title), notes),
        _ if parts.is_steady_line() => parts.steady_line(name, title, notes),
        3 if matches!(parts.geometry, Geometry::Line(_)) && case.kinematics[3] != 0.0 => {
            Err("spin on a line contact (CPHI)".into())
        }
        3 if matches!(parts.geometry, Geometry::Line(_)) => {
            let last = chain.len() - 1;
            parts.history(&chain[last..], &places[last..], (name, title), notes)
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
        if case.planform != 1 {
            return Err("a contact area that is bounded beforehand (IPLAN)".into());
        }
        if case.control.force() == 3 {
            return Err("F = 3 between bodies that are given".into());
        }
        let (geometry, pressed) = geometry(case, materials, turned, notes)?;
        if matches!(pressed, LoadOrApproach::Load(load) if load.is_nan() || load <= 0.0) {
            return Err("a load that does not press the bodies together (FN)".into());
        }
        let (friction, friction_text, needs_speed) = friction(case, turned, notes)?;
        if case.control.tangential() != 0 && (friction.is_nan() || friction <= 0.0) {
            return Err(format!(
                "a coefficient of friction of {}: without friction there is no traction to be found",
                number(friction)
            ));
        }
        let slip = added_slip(case, materials, (&geometry, pressed), turned)?;
        let needs_heat = case.friction.as_ref().is_some_and(FrictionRead::needs_heat);
        let parts = Self {
            case,
            materials,
            geometry,
            pressed,
            friction,
            friction_text,
            needs_speed,
            needs_heat,
            slip,
            turned,
        };
        let relaxes =
            matches!(materials.extra, Extra::Viscoelastic { times, .. } if times != [0.0; 2]);
        if relaxes && !parts.is_steady_line() {
            return Err("viscoelastic bodies (M = 1) other than cylinders that roll steadily, along, under one \
                        coefficient of friction"
                .into());
        }
        Ok(parts)
    }

    fn note_what_is_left(&self, notes: &mut Vec<String>) {
        let control = self.case.control;
        if control.heat() >= 1 && self.heat().is_err() {
            notes.push(
                "the temperature (H) is computed in steady rolling of two bodies at a speed only"
                    .into(),
            );
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

    /// Temperatures, where the case asks for them.
    fn heat(&self) -> Result<String, Cause> {
        if self.case.control.heat() == 0 && !self.needs_heat {
            return Ok(String::new());
        }
        let heat = self.case.heat.ok_or("no case has given how the bodies conduct heat (H = 3)")?;
        let is_line = matches!(self.geometry, Geometry::Line(_));
        if self.case.control.tangential() != 3 || is_line || self.speed() <= 0.0 {
            return Err("temperatures other than in steady rolling at a speed (H)".into());
        }
        Ok(heat_section(heat))
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
            let mut modulus = self.materials.shear_modulus[index] * 1e6;
            // What gives way at once is as soft as it will be.
            if let Extra::Viscoelastic { ratios, times } = self.materials.extra
                && times[index] == 0.0
            {
                modulus /= 1.0 + ratios[index];
            }
            let mut keys = vec![
                ("shear_modulus", number(modulus)),
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
            (Geometry::Line([radius, length]), LoadOrApproach::Load(load)) => {
                keys.push(("line_load", number(load)));
                keys.push(("radius_rolling", number(*radius)));
                keys.push(("length", number(*length)));
            }
            (_, LoadOrApproach::Load(load)) => keys.push(("normal_force", number(load))),
            (_, LoadOrApproach::Approach(approach)) => keys.push(("approach", number(approach))),
        }
        if let Geometry::Rectangle([along, across]) = self.geometry {
            keys.push(("half_length_rolling", number(along)));
            keys.push(("half_length_lateral", number(across)));
        }
        if let Geometry::SemiAxes([a, b]) = self.geometry {
            keys.push(("semi_axis_rolling", number(a)));
            keys.push(("semi_axis_lateral", number(b)));
        }
        if with_friction {
            // Bodies of any shape have a coefficient even where they are pressed only.
            let is_none = self.friction.is_nan() || self.friction <= 0.0;
            keys.push((
                "friction",
                if is_none { "1.0".into() } else { self.friction_text.clone() },
            ));
            keys.extend(self.slip.clone().map(|slip| ("slip", slip)));
        }
        let gap = match &self.geometry {
            Geometry::Gap(text) => format!("\n[gap]\n{text}"),
            _ => String::new(),
        };
        gap + &section("contact", &keys)
    }

    fn layer(&self) -> String {
        let Extra::Layer([modulus, thickness, yield_stress, slope]) = self.materials.extra else {
            return String::new();
        };
        let yields = yield_stress > 0.0;
        if thickness <= 0.0 && !yields {
            return String::new();
        }
        let mut keys = vec![
            ("thickness", number(thickness.max(0.0) * 1e-3)),
            ("shear_modulus", number(modulus * 1e6)),
        ];
        if yields {
            keys.push(("yield_stress", number(yield_stress * 1e6)));
            keys.push(("slope", number(slope * 1e9)));
        }
        section("layer", &keys)
    }

    /// Bodies pressed together without friction.
    fn pressing(&self, name: &str, title: &str, notes: &[String]) -> Result<Written, Cause> {
        match self.geometry {
            Geometry::Line(_) => return Err("a line contact that is pressed only".into()),
            Geometry::Rectangle(_) => {
                return Err("a single element of uniform pressure that is not sheared".into());
            }
            _ => {}
        }
        let command = format!("creepage hertz {name}.toml");
        let head = self.head(title, &command, notes);
        let is_gap = matches!(self.geometry, Geometry::Gap(_));
        let text = head + &self.bodies() + &self.contact(is_gap);
        Ok(Written::of(command, File::text(format!("{name}.toml"), text)))
    }
}
