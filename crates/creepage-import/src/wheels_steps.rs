//! Conversion of steps of a wheel on a rail (T = 1, 2) to a table of positions.

use std::fmt::Write as _;

use crate::NotWritten;
use crate::text::number;
use crate::wheels::Wheels;
use crate::wheels_case::friction;

type Cause = NotWritten;

/// Where a wheel begins, and a row a case.
pub(crate) struct Table {
    /// `none` or `steady`.
    pub(crate) start: &'static str,
    pub(crate) rows: String,
}

/// What solves it.
pub(crate) fn command(name: &str) -> String {
    format!("creepage roll {name}.toml --history {name}.csv")
}

/// The table of a history whose last case rolls in steps or is shifted.
pub(crate) fn table(chain: &[Wheels], notes: &mut Vec<String>) -> Result<Table, Cause> {
    let [first, ..] = chain else { return Err("no case".into()) };
    let start = match (first.control.tangential(), first.control.history()) {
        (3, _) => "steady",
        (0, _) | (1 | 2, 2) => "none",
        _ => return Err("a step before which nothing is known (P = 0)".into()),
    };
    let has_load = first.control.has_load();
    let pressed = if has_load { "wheel_load" } else { "z" };
    let mut rows = format!(
        "distance,s,pitch,y,roll,yaw,{pressed},speed,pitch_rate,lateral_velocity,vertical_velocity,roll_rate,yaw_rate\n"
    );
    let (mut distance, mut place): (f64, Option<f64>) = (0.0, None);
    for case in chain {
        alike(first, case)?;
        let [s, y, height, roll, yaw, pitch] =
            case.position.ok_or("no case has given the wheelset's position (E)")?;
        let kind = case.control.tangential();
        if kind == 0 {
            // Pressed without friction: the next one begins without traction.
            continue;
        }
        let motion = case.velocity.ok_or("no case has given the wheelset's velocity (E = 2, 3)")?;
        let step = if kind == 1 { motion[0] } else { case.step };
        if step <= 0.0 {
            return Err(if kind == 1 {
                "a shift of a wheel that does not go ahead (T = 1, SHFT_S)".into()
            } else {
                "a step whose length (DX, DQREL) is not above zero".into()
            });
        }
        if let Some(before) = place
            && kind == 1
            && s != before
            && (s - before - step).abs() > 1e-6 * step
        {
            notes.push(format!(
                "S goes from {} to {} mm while the shift is {} mm long (SHFT_S): the latter is rolled",
                number(before),
                number(s),
                number(step)
            ));
        }
        place = Some(s);
        distance += step;
        let height = if has_load { height } else { height * 1e-3 };
        let [along, y_rate, z_rate, roll_rate, yaw_rate, pitch_rate] = motion;
        // Forward rolling is negative about y to the right; of T = 1 the shifts are those of a second.
        let numbers = [
            distance * 1e-3,
            s * 1e-3,
            -pitch,
            y * 1e-3,
            roll,
            yaw,
            height,
            along * 1e-3,
            -pitch_rate,
            y_rate * 1e-3,
            z_rate * 1e-3,
            roll_rate,
            yaw_rate,
        ];
        let row: Vec<_> = numbers.into_iter().map(number).collect();
        let _ = writeln!(rows, "{}", row.join(","));
    }
    notes.push(
        "rolling in steps: heights under a given load are those of steady rolling, and a row is divided into finer \
         steps where forces ask for it"
            .into(),
    );
    Ok(Table { start, rows })
}

/// A history has one wheel on one rail.
fn alike(first: &Wheels, case: &Wheels) -> Result<(), Cause> {
    let differs = |what: &str| Err(format!("a history in which {what} change").into());
    if (&first.rail, &first.wheel) != (&case.rail, &case.wheel) {
        return differs("profiles");
    }
    if (first.track, first.wheelset, first.deviation) != (case.track, case.wheelset, case.deviation)
    {
        return differs("the sizes of track and wheelset or the rail's place");
    }
    if first.materials != case.materials {
        return differs("the bodies");
    }
    if first.control.config() != case.control.config()
        || first.control.has_load() != case.control.has_load()
    {
        return differs("what is given of the wheel");
    }
    if case.control.config() >= 4 {
        return Err("steps of a wheel on a roller".into());
    }
    if case.control.force() != 0 {
        return Err("steps of a wheel with a given force or on springs (F = 1, 3)".into());
    }
    let own = |case: &Wheels| friction(case, &mut Vec::new());
    if own(first)? != own(case)? {
        return differs("coefficients of friction");
    }
    Ok(())
}
