//! Conversion of a case of module 1 to a wheelset file of creepage.

use crate::bodies_case::law_text;
use crate::profiles::{Profiles, Side};
use crate::read::{Extra, Friction, FrictionRead, Law};
use crate::text::{comments, heat_section, list, number, quoted, section};
use crate::wheels::{ProfileFile, Wheels};
use creepage_rail::Role;

use crate::{File, NotWritten, Written, wheels_steps};

/// Friction in place of none, which wheelset files do not take.
const FRICTIONLESS: f64 = 1e-6;

type Keys = Vec<(&'static str, String)>;
type Cause = NotWritten;

/// A profile or slices, as they lie beside the case file.
struct Named<'a> {
    file: &'a ProfileFile,
    /// `profile` or `slices`.
    key: &'static str,
    name: String,
    /// The profile, or the first one of the slices, as the input has it.
    first: String,
    side: Side,
}

impl<'a> Named<'a> {
    fn new(
        file: &'a ProfileFile,
        role: Role,
        profiles: &mut Profiles,
        notes: &mut Vec<String>,
    ) -> Result<Self, Cause> {
        if !is_slices(&file.name) {
            let name = profiles.name(&file.name)?;
            let side = profiles.side(file, role);
            return Ok(Self { file, key: "profile", name, first: file.name.clone(), side });
        }
        let read = profiles.slices(&file.name, role)?;
        if read.approximates {
            notes.push(format!(
                "slices of the {role} (INTPOL = 2): that program's surface goes near them, ours through them"
            ));
        }
        if read.accelerations > 0 {
            notes.push(format!("P_ACCEL of the {role}'s slices has no counterpart"));
        }
        let (name, first) = (read.file.name, read.first);
        Ok(Self { file, key: "slices", name, first, side: Side::AsRead })
    }
}

/// Whether a name is that of a list of slices.
fn is_slices(name: &str) -> bool {
    let extension = name.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
    matches!(extension.as_str(), "slcs" | "slcw")
}

/// Writes the last case of a history of one wheel on its rail; the error names what has no counterpart.
pub(crate) fn write(
    chain: &[Wheels],
    (name, title): (&str, &str),
    profiles: &mut Profiles,
    notes: &mut Vec<String>,
) -> Result<Written, Cause> {
    let case = chain.last().ok_or("no case")?;
    check(case)?;
    let (Some(rail), Some(wheel)) = (&case.rail, &case.wheel) else {
        return Err("no case has given both profiles (Z = 3, E = 3)".into());
    };
    let rolls_in_steps = matches!(case.control.tangential(), 1 | 2);
    let table = if rolls_in_steps { Some(wheels_steps::table(chain, notes)?) } else { None };
    let grooved = !is_slices(&rail.name) && profiles.is_grooved(rail, wheel);
    let wheel = Named::new(wheel, Role::Wheel, profiles, notes)?;
    let files = [wheel, Named::new(rail, Role::Rail, profiles, notes)?];
    let command = match &table {
        None => command(name),
        Some(_) => wheels_steps::command(name),
    };
    let mut text = text(case, (files, grooved), title, &command, notes)?;
    let Some(table) = table else {
        return Ok(Written::of(command, File::text(format!("{name}.toml"), text)));
    };
    text += &section("start", &[("traction", quoted(table.start))]);
    let files = vec![
        File::text(format!("{name}.toml"), text),
        File::text(format!("{name}.csv"), table.rows),
    ];
    Ok(Written { command, files })
}

fn command(name: &str) -> String {
    format!("creepage wheelset {name}.toml")
}

/// What wheelset files cannot say.
fn check(case: &Wheels) -> Result<(), Cause> {
    let control = case.control;
    match control.config() {
        0 | 1 | 4 | 5 => {}
        other => return Err(format!("C = {other} is no wheel on a rail that we know").into()),
    }
    if control.bound() == 1 {
        return Err("a compressible sheet (B = 1)".into());
    }
    if control.has_load() && case.position.is_some_and(|at| at[2].is_nan() || at[2] <= 0.0) {
        return Err("a load that does not press the wheel on the rail (FZ)".into());
    }
    if control.force() == 2 {
        return Err("a given moment about the axle (F = 2)".into());
    }
    if case.is_flexible {
        return Err("a bent axle (E = 4, 5)".into());
    }
    if case.wheelset.is_some_and(|sizes| sizes[2] <= 0.0) {
        return Err("a wheel whose radius is not above zero (NOMRAD)".into());
    }
    match case.materials.as_ref().map(|materials| &materials.extra) {
        None => Err("no case has given materials (C = 2)".into()),
        Some(Extra::Layer(_)) => Err("a layer between wheel and rail (M = 4)".into()),
        Some(Extra::OneFlexibility) => {
            Err("the simplified theory with a given flexibility (M = 2)".into())
        }
        Some(Extra::Viscoelastic { times, .. }) if times.iter().any(|time| *time > 0.0) => {
            Err("viscoelastic bodies (M = 1)".into())
        }
        Some(Extra::ThreeFlexibilities { changes } | Extra::Fastrip { changes })
            if changes[..2].iter().any(|change| *change != 1.0) =>
        {
            Err("the simplified theory with changed flexibilities (K0_MF, ALFAMF, BETAMF)".into())
        }
        _ => Ok(()),
    }
}

fn text(
    case: &Wheels,
    ([wheel, rail], is_grooved): ([Named<'_>; 2], bool),
    title: &str,
    command: &str,
    notes: &mut Vec<String>,
) -> Result<String, Cause> {
    let missing = |what: &str| format!("no case has given {what}");
    let control = case.control;
    let is_roller = control.config() >= 4;
    let stands = case.velocity.is_some_and(|all| all.iter().all(|value| *value == 0.0));
    let moves = control.tangential() >= 1 && !stands;
    let sizes = case.track.ok_or_else(|| missing("the track's dimensions (Z = 1, 3)"))?;
    // A roller's line ends with its radius, not with cant and curvature.
    let (roller, sizes) = if is_roller {
        (Some(sizes[3]), [sizes[0], sizes[1], sizes[2], 0.0, 0.0])
    } else {
        (None, sizes)
    };
    let track = track(sizes, notes);
    let sizes = case.wheelset.ok_or_else(|| missing("the wheelset's dimensions (E = 3)"))?;
    let [s, y, height, roll, yaw, pitch] =
        case.position.ok_or_else(|| missing("the wheelset's position (E)"))?;
    let varies = wheel.key == "slices" || rail.key == "slices";
    let mut wheel_keys = profile(&wheel, "wheel", notes);
    wheel_keys.push(("radius", number(sizes[2] * 1e-3)));
    wheel_keys.push(("flange_back", number(sizes[1] * 1e-3)));
    let mut rail_keys = profile(&rail, "rail", notes);
    rail_keys.extend(track.cant.map(|cant| ("cant", number(cant))));
    rail_keys.extend(deviation(case));
    if let Some(radius) = roller {
        rail_keys.push(("roller_radius", number(radius * 1e-3)));
        notes.push(
            "off the top of the roller the common normal leans along the track, and the pressure pushes along it: \
             that program leaves this part of FX(TR) out"
                .into(),
        );
    }
    if is_grooved {
        rail_keys.push(("guard", "{ grooved = true }".into()));
        notes.push(
            "the rail's profile has a groove: what lies beyond it is a guard rail here, whose forces are a part of the \
             rail's"
                .into(),
        );
    }
    let pressed = if control.has_load() {
        ("wheel_load", number(height))
    } else {
        ("z", number(height * 1e-3))
    };
    let side = if control.config().is_multiple_of(4) { "left" } else { "right" };
    let mut wheelset = vec![
        ("back_to_back", number(sizes[0] * 1e-3)),
        ("side", quoted(side)),
        ("y", number(y * 1e-3)),
        ("roll", number(roll)),
        ("yaw", number(yaw)),
        pressed,
    ];
    if varies {
        // Forward rolling is negative about y to the right.
        wheelset.extend([("s", number(s * 1e-3)), ("pitch", number(-pitch))]);
        notes.push(
            "where surfaces slope along the track the pressure pushes the rail ahead or back: that program leaves this \
             part of FX(TR) out"
                .into(),
        );
    }
    let motion = if moves { motion(case, roller)? } else { rest(sizes[2]) };
    let mut contact = Vec::new();
    if moves {
        contact.push(("friction", friction(case, notes)?));
        if case.method == 4 && control.tangential() == 3 {
            contact.push(("slip", quoted("curved")));
            notes.push(
                "conformal contact (D = 4): ours is plane, with the rigid slip of every place (slip = \
                 \"curved\")"
                    .into(),
            );
        }
    } else {
        contact.push(("friction", number(FRICTIONLESS)));
        notes.push(format!(
            "without friction (T = 0), or at rest: the wheel rolls freely with friction {FRICTIONLESS}, under which forces \
             are those of the pressure"
        ));
    }
    let solve = if moves { theory(case) } else { vec![("theory", quoted("saturated"))] };
    notes_of_rest(case, notes);
    let mut lines = vec![title.to_string(), format!("Run: {command}")];
    lines.push(
        "Signs: forces act on the rail in the track's axes, as CONTACT's FX(TR), FY(TR), FZ(TR)."
            .into(),
    );
    lines.extend(notes.iter().map(|note| format!("Not as it was: {note}")));
    let sections = [
        section("wheel", &wheel_keys),
        section("rail", &rail_keys),
        section("track", &track.keys),
        section("wheelset", &wheelset),
        section("motion", &motion),
        section("contact", &contact),
        materials(case),
        heat(case),
        section("solve", &solve),
    ];
    Ok(comments(&lines) + &sections.concat())
}

struct Track {
    keys: Keys,
    cant: Option<f64>,
}

fn track(values: [f64; 5], notes: &mut Vec<String>) -> Track {
    let [height, second, third, cant, curvature] = values;
    let mut keys = if height > 0.0 {
        if second != 0.0 {
            notes.push("GAUGSQ: the gauge is measured at the nearest points".into());
        }
        vec![("gauge", number(third * 1e-3)), ("gauge_height", number(height * 1e-3))]
    } else {
        vec![("rail_position", number(second * 1e-3)), ("rail_height", number(third * 1e-3))]
    };
    keys.extend((curvature != 0.0).then(|| ("curvature", number(curvature * 1e3))));
    Track { keys, cant: (cant != 0.0).then_some(cant) }
}

fn profile(
    Named { file, key, name, first, side }: &Named<'_>,
    role: &str,
    notes: &mut Vec<String>,
) -> Keys {
    let mut reading = Vec::new();
    let extension = first.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
    let is_plain = !matches!(extension.as_str(), "prr" | "prw" | "ban" | "whl");
    if file.scale <= 0.0 {
        notes.push(format!(
            "SCALE = {} of the {role}'s profile is not above zero: the file's own unit is taken",
            number(file.scale)
        ));
    }
    if file.scale != 1.0 && file.scale > 0.0 {
        reading.push(format!("unit = {}", number(file.scale * 1e-3)));
    } else if is_plain {
        reading.push("unit = 0.001".into());
    }
    if *side == Side::AgainstShape {
        notes.push(format!(
            "MIRRORY of the {role}'s profile would turn its flange to the field side: the shape is followed"
        ));
    } else if is_plain || *side == Side::Said {
        // Formats of their own say where their axes point.
        let y = if file.mirror_y { "track-side" } else { "field-side" };
        reading.push(format!("y = {}", quoted(y)));
    }
    match file.mirror_z {
        1 => reading.push(format!("z = {}", quoted("up"))),
        -1 if is_plain => reading.push(format!("z = {}", quoted("down"))),
        _ => {}
    }
    if file.smoothing > 0.0 && file.is_plain_spline {
        // Every point counts alike in that program's spline; coordinates are scaled before.
        reading.push(format!("smooth_weight = {}", number(file.smoothing * 1e-9)));
    } else if file.smoothing > 0.0 {
        notes.push(format!(
            "SMOOTH = {} of the {role}'s profile (ISMOOTH = 1) has no counterpart; `reading = {{ smooth = ... }}` \
             smooths by wavelength",
            number(file.smoothing)
        ));
    }
    if let Some([turn, rest, reach]) = file.corners {
        reading.push(format!(
            "corners = {{ turn = {}, rest = {}, reach = {} }}",
            number(turn),
            number(rest),
            number(reach * 1e-3)
        ));
    }
    if file.has_zig_zags {
        notes.push(format!(
            "ZIGTHRS of the {role}'s profile has no counterpart: zig-zags are found here by 150 degrees"
        ));
    }
    let mut keys = vec![(*key, quoted(name))];
    if !reading.is_empty() {
        keys.push(("reading", format!("{{ {} }}", reading.join(", "))));
    }
    keys
}

/// The rail beside its place, and its springs.
fn deviation(case: &Wheels) -> Keys {
    let [y, z, roll, y_rate, z_rate, roll_rate] = case.deviation;
    let given = [
        ("dy", y * 1e-3),
        ("dz", z * 1e-3),
        ("droll", roll),
        ("dy_rate", y_rate * 1e-3),
        ("dz_rate", z_rate * 1e-3),
        ("droll_rate", roll_rate),
    ];
    // Springs hold the rail: where it goes is found.
    let mut keys: Keys = given
        .into_iter()
        .filter(|(_, value)| *value != 0.0)
        .map(|(key, value)| (key, number(value)))
        .collect();
    if let Some([stiffness_y, force_y, stiffness_z, force_z]) = case.springs {
        keys.push(("stiffness_y", number(stiffness_y * 1e3)));
        keys.push(("stiffness_z", number(stiffness_z * 1e3)));
        keys.push(("force_y", number(force_y)));
        keys.push(("force_z", number(force_z)));
    }
    keys
}

fn motion(case: &Wheels, roller: Option<f64>) -> Result<Keys, Cause> {
    let [speed, y, z, roll, yaw, last] =
        case.velocity.ok_or("no case has given the wheelset's velocity (E = 2, 3)")?;
    // Of a roller that is its turning, forwards about y to the right.
    let speed = roller.map_or(speed, |radius| speed * radius);
    let mut keys = vec![("speed", number(speed * 1e-3))];
    if case.control.force() == 1 {
        keys.push(("longitudinal_force", number(last)));
    } else {
        // Forward rolling is negative about y to the right.
        keys.push(("pitch_rate", number(-last)));
    }
    let rest = [
        ("lateral_velocity", y * 1e-3),
        ("vertical_velocity", z * 1e-3),
        ("roll_rate", roll),
        ("yaw_rate", yaw),
    ];
    keys.extend(
        rest.into_iter()
            .filter(|(_, value)| *value != 0.0)
            .map(|(key, value)| (key, number(value))),
    );
    Ok(keys)
}

/// A wheel at rest, of that radius (mm): wheelset files have motion, so it rolls freely at 1 m/s.
fn rest(radius: f64) -> Keys {
    vec![("speed", number(1.0)), ("pitch_rate", number(1e3 / radius))]
}

pub(crate) fn friction(case: &Wheels, notes: &mut Vec<String>) -> Result<String, Cause> {
    let read = case.friction.as_ref().ok_or("no case has given friction (L)")?;
    let FrictionRead { friction, memory, .. } = read;
    match friction {
        Friction::One(Law::OfTemperature(_)) => {
            Err("friction by temperature on a rail (L = 6)".into())
        }
        Friction::One(law) => Ok(law_text(law, *memory, notes)?.1),
        Friction::ByRow(_) => Err("friction row by row on a rail".into()),
        Friction::ByAngle(points) => {
            if let Some(law) = same_law(points)
                && !matches!(law, Law::OfTemperature(_))
            {
                return Ok(law_text(law, *memory, notes)?.1);
            }
            let values = coefficients(points, notes)?;
            notes.push(
                "friction by angle (V = 1) bounds each row of elements; that program takes one value for a \
                 plane contact"
                    .into(),
            );
            let angles = list(points.iter().map(|(angle, _)| *angle));
            Ok(format!("{{ angle = {angles}, value = {} }}", list(values)))
        }
        Friction::Along(points) => {
            let place = case.position.map_or(0.0, |position| position[0]);
            let values = coefficients(points, notes)?;
            notes.push("friction along the track (V = 2): its value at this position".into());
            let places: Vec<_> = points.iter().map(|(place, _)| *place).collect();
            Ok(number(between(&places, &values, place)))
        }
    }
}

fn same_law(points: &[(f64, Law)]) -> Option<&Law> {
    let (_, first) = points.first()?;
    points.iter().all(|(_, law)| law == first).then_some(first)
}

fn coefficients(points: &[(f64, Law)], notes: &mut Vec<String>) -> Result<Vec<f64>, Cause> {
    if points.is_empty() || points.windows(2).any(|pair| pair[1].0 <= pair[0].0) {
        return Err("friction at places that do not rise".into());
    }
    let one = |(_, law): &(f64, Law)| match law {
        Law::Coulomb { at_rest, kinetic } => Ok((*at_rest, *kinetic)),
        _ => Err(Cause::from("a law of the speed of slip that differs from place to place")),
    };
    let pairs = points.iter().map(one).collect::<Result<Vec<_>, _>>()?;
    if pairs.iter().any(|(at_rest, kinetic)| at_rest != kinetic) {
        notes.push("FSTAT beside another FKIN: FKIN is taken for both".into());
    }
    Ok(pairs.into_iter().map(|(_, kinetic)| kinetic).collect())
}

/// Linear between places, constant beyond.
fn between(places: &[f64], values: &[f64], place: f64) -> f64 {
    let next = places.partition_point(|known| *known < place);
    match (next.checked_sub(1), places.get(next)) {
        (Some(before), Some(after)) => {
            let part = (place - places[before]) / (after - places[before]);
            values[before] + part * (values[next] - values[before])
        }
        (None, _) => values.first().copied().unwrap_or_default(),
        (Some(before), None) => values[before],
    }
}

fn materials(case: &Wheels) -> String {
    let Some(materials) = &case.materials else { return String::new() };
    let keys = |index: usize| {
        [
            ("shear_modulus", number(materials.shear_modulus[index] * 1e6)),
            ("poisson", number(materials.poisson[index])),
        ]
    };
    if keys(0) == keys(1) {
        return section("materials", &keys(0));
    }
    // Here body 1 is the rail.
    section("upper", &keys(1)) + &section("lower", &keys(0))
}

/// Temperatures, where the case asks for them and the wheel rolls.
fn heat(case: &Wheels) -> String {
    let speed = case.velocity.map_or(0.0, |velocity| velocity[0]);
    let rolls = case.control.tangential() == 3 && speed != 0.0 && case.control.heat() >= 1;
    // Here body 1 is the rail.
    let bodies = case.heat.filter(|_| rolls);
    bodies.map_or(String::new(), |[rail, wheel]| heat_section([wheel, rail]))
}

fn theory(case: &Wheels) -> Keys {
    let name = match case.materials.as_ref().map(|materials| &materials.extra) {
        Some(Extra::ThreeFlexibilities { .. }) => "fastsim",
        Some(Extra::Fastrip { .. }) => "fastrip",
        _ => "exact",
    };
    vec![("theory", quoted(name))]
}

fn notes_of_rest(case: &Wheels, notes: &mut Vec<String>) {
    let control = case.control;
    if control.heat() >= 1 && heat(case).is_empty() {
        notes.push("the temperature (H) is computed in rolling at a speed only".into());
    }
    if control.stress() >= 1 {
        notes.push("points below the surface (S) have no counterpart for a wheelset".into());
    }
    if control.bound() >= 2 {
        notes.push(
            "the simplified pressure (B) has no counterpart: ours is the half-space's".into(),
        );
    }
    if control.influence() >= 3 {
        notes.push("influence numbers other than a half-space's (C) have no counterpart".into());
    }
    if matches!(
        case.materials.as_ref().map(|materials| &materials.extra),
        Some(Extra::ThreeFlexibilities { .. })
    ) {
        notes.push("FASTSIM with three flexibilities: ours blends them here".into());
    }
}

#[cfg(test)]
mod tests {
    use super::between;

    #[test]
    fn friction_along_the_track_is_linear_and_constant_beyond() {
        let at = |place| between(&[0.0, 100.0], &[0.2, 0.3], place);
        assert_eq!([at(-5.0), at(0.0), at(100.0), at(200.0)], [0.2, 0.2, 0.3, 0.3]);
        assert!((at(60.0) - 0.26).abs() < 1e-15);
    }
}
