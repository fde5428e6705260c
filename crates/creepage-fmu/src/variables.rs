//! Table of the FMU's variables: names, units and meanings, from which the description and the access are made.

/// Causality of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Causality {
    Input,
    Output,
}

/// A number of the FMU; its value reference is its place in [`REALS`] plus one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Real {
    pub(crate) name: &'static str,
    pub(crate) unit: &'static str,
    pub(crate) causality: Causality,
    pub(crate) meaning: &'static str,
}

const fn input(name: &'static str, unit: &'static str, meaning: &'static str) -> Real {
    Real { name, unit, causality: Causality::Input, meaning }
}

const fn output(name: &'static str, unit: &'static str, meaning: &'static str) -> Real {
    Real { name, unit, causality: Causality::Output, meaning }
}

/// How many of [`REALS`] are inputs.
pub(crate) const INPUTS: usize = 12;
/// How many are outputs.
pub(crate) const OUTPUTS: usize = REALS.len() - INPUTS;

/// All numbers: inputs first.
pub(crate) const REALS: [Real; 41] = [
    input("y", "m", "centre of the wheelset to the right of the track centre"),
    input("z", "m", "its height, down, where by_height is true"),
    input("roll", "rad", "turn about x, where by_height is true"),
    input("yaw", "rad", "turn about z: positive turns the axle's right end back"),
    input("axle_load", "N", "vertical force on the track, where by_height is false"),
    input("speed", "m/s", "along the track"),
    input(
        "pitch_rate",
        "rad/s",
        "about the axle, positive when it rolls forward, where pitch_free is false",
    ),
    input("lateral_velocity", "m/s", "to the right"),
    input("vertical_velocity", "m/s", "down"),
    input("roll_rate", "rad/s", "about x"),
    input("yaw_rate", "rad/s", "about z"),
    input("friction", "1", "coefficient of friction"),
    output("wrench_x", "N", "force of the rails on the wheelset along x, forward"),
    output("wrench_y", "N", "along y, to the right"),
    output("wrench_z", "N", "along z, down"),
    output(
        "wrench_moment_x",
        "N.m",
        "moment of the rails on the wheelset about its centre, about x",
    ),
    output("wrench_moment_y", "N.m", "about y"),
    output("wrench_moment_z", "N.m", "about z"),
    output("left_x", "N", "force of the left wheel on its rail along x"),
    output("left_y", "N", "along y"),
    output("left_z", "N", "along z"),
    output("right_x", "N", "force of the right wheel on its rail along x"),
    output("right_y", "N", "along y"),
    output("right_z", "N", "along z"),
    output("left_normal_force", "N", "sum of the normal forces of the left wheel's contacts"),
    output("right_normal_force", "N", "of the right wheel's"),
    output("left_longitudinal_creepage", "1", "of the left wheel's most loaded contact"),
    output("left_lateral_creepage", "1", "of the left wheel's most loaded contact"),
    output("left_spin", "rad/m", "of the left wheel's most loaded contact"),
    output("right_longitudinal_creepage", "1", "of the right wheel's most loaded contact"),
    output("right_lateral_creepage", "1", "of the right wheel's most loaded contact"),
    output("right_spin", "rad/m", "of the right wheel's most loaded contact"),
    output(
        "left_dissipation",
        "J/m",
        "heat of friction per metre rolled at the left wheel: T gamma",
    ),
    output("right_dissipation", "J/m", "at the right wheel"),
    output("found_z", "m", "height, given or found"),
    output("found_roll", "rad", "roll, given or found"),
    output(
        "found_pitch_rate",
        "rad/s",
        "pitch rate, given or found; the mean of independent wheels",
    ),
    output(
        "left_error",
        "1",
        "error of the left tangential force over mu N: the largest measured there in the map, or the solver's bar",
    ),
    output("right_error", "1", "the same at the right wheel"),
    output("left_contacts", "1", "places of contact of the left wheel"),
    output("right_contacts", "1", "of the right wheel"),
];

/// Value reference of the first number.
pub(crate) const FIRST_REAL: u32 = 1;

/// A switch; its value reference is its place plus [`FIRST_SWITCH`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Switch {
    pub(crate) name: &'static str,
    pub(crate) meaning: &'static str,
}

/// Value reference of the first switch.
pub(crate) const FIRST_SWITCH: u32 = 101;

/// What is given and what is found.
pub(crate) const SWITCHES: [Switch; 2] = [
    Switch {
        name: "by_height",
        meaning: "true: z and roll are inputs; false: both rails carry half of axle_load",
    },
    Switch {
        name: "pitch_free",
        meaning: "true: the pitch rate is that at which friction has no moment about the axle",
    },
];

/// Place of a number among [`REALS`] by its value reference.
pub(crate) fn real(reference: u32) -> Option<usize> {
    let place = reference.checked_sub(FIRST_REAL)? as usize;
    (place < REALS.len()).then_some(place)
}

/// Place of a switch by its value reference.
pub(crate) fn switch(reference: u32) -> Option<usize> {
    let place = reference.checked_sub(FIRST_SWITCH)? as usize;
    (place < SWITCHES.len()).then_some(place)
}
