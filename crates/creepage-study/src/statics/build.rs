//! Statics problems: what each is given, and the quantities of its report.

use creepage::SiForce;
use creepage::halfspace::ResponseError;
use creepage::statics::{Bonded, Die, DieError, PartialSlip};
use creepage::{Ellipse, Hertz, Solid, SolidPair};

use super::StaticsReport;
use super::field::{Field, magnitude};
use super::path::Path;
use super::slip_angle::Slip;
use crate::report::{
    Report, Section,
    Unit::{
        Degree, Metre, Newton, NewtonMetre, NewtonMetrePerRadian, NewtonPerMetre, One, Pascal,
        Percent, Radian,
    },
};

impl<'a> StaticsReport<'a> {
    /// A rigid die with base `base` (m) on the half-space `solid`, under `normal_force` (N) at
    /// `offset` (m); `die` is its solution.
    ///
    /// # Errors
    /// As [`Die::new`]; none for numbers of which there is a solution.
    pub fn die(
        solid: Solid,
        base: Ellipse,
        normal_force: f64,
        offset: [f64; 2],
        die: &'a Die,
    ) -> Result<Self, DieError> {
        // Stiffness does not depend on the load: any offset below the limit gives it.
        let trial = [base.a() / 6.0, base.b() / 6.0];
        let tilt = Die::new(solid, base, normal_force, trial)?.tilt();
        let stiffness = [0, 1].map(|i| normal_force * trial[i] / tilt[i]);
        let mut numbers = Report::default();
        given(&mut numbers)
            .number("normal_force", "normal force N", Newton, normal_force)
            .number("offset_x", "offset of N along x", Metre, offset[0])
            .number("offset_y", "offset of N along y", Metre, offset[1]);
        shape(&mut numbers, base);
        solid_numbers(&mut numbers, solid.shear_modulus(), solid.poisson());
        let [x, y] = die.tilt();
        let edge = (x * base.a()).hypot(y * base.b());
        let centre = die.indentation();
        found(&mut numbers)
            .number("indentation", "indentation at the centre", Metre, centre)
            .number("deepest", "indentation, deepest edge", Metre, centre + edge)
            .number("shallowest", "indentation, opposite edge", Metre, centre - edge)
            .number("tilt_x", "tilt along x", Radian, x)
            .number("tilt_y", "tilt along y", Radian, y)
            .number("stiffness", "stiffness", NewtonPerMetre, normal_force / centre)
            .number(
                "stiffness_tilt_x",
                "tilt stiffness along x",
                NewtonMetrePerRadian,
                stiffness[0],
            )
            .number(
                "stiffness_tilt_y",
                "tilt stiffness along y",
                NewtonMetrePerRadian,
                stiffness[1],
            )
            .number("pressure_centre", "pressure at the centre", Pascal, die.pressure([0.0; 2]))
            .number(
                "lift_off_used",
                "offset, share of lift-off",
                Percent,
                100.0 * (1.0 - die.margin()),
            )
            .number("lift_off_x", "lift-off limit along x", Metre, base.a() / 3.0)
            .number("lift_off_y", "lift-off limit along y", Metre, base.b() / 3.0);
        Ok(Self {
            cautions: Vec::new(),
            problem: "die",
            title: "Rigid die on an elastic half-space",
            ellipse: base,
            numbers,
            field: Field::Die { die, offset },
            path: Path::None,
        })
    }

    /// A shift without slip; `bonded` is its solution under `force`.
    ///
    /// # Errors
    /// As [`Bonded::new`]; none for numbers of which there is a solution.
    pub fn shift(
        pair: SolidPair,
        ellipse: Ellipse,
        force: [f64; 2],
        bonded: &'a Bonded,
    ) -> Result<Self, ResponseError> {
        let [x, y] = bonded.shift();
        let stiffness = Stiffness::new(pair, ellipse)?;
        let mut numbers = Report::default();
        forces(&mut numbers, force);
        shape(&mut numbers, ellipse);
        pair_numbers(&mut numbers, pair);
        found(&mut numbers)
            .number("shift_x", "shift along x", Metre, x)
            .number("shift_y", "shift along y", Metre, y)
            .number("force_to_shift", "angle from force to shift", Degree, turn(force, [x, y]))
            .number("stiffness_x", "stiffness along x", NewtonPerMetre, stiffness.x)
            .number("stiffness_y", "stiffness along y", NewtonPerMetre, stiffness.y)
            .number(
                "traction_centre",
                "traction at the centre",
                Pascal,
                magnitude(bonded.traction([0.0; 2])),
            )
            .number("traction_mean", "traction, mean", Pascal, magnitude(force) / ellipse.area());
        Ok(Self {
            cautions: Vec::new(),
            problem: "shift",
            title: "Shift without slip",
            ellipse,
            numbers,
            field: Field::Bonded(bonded),
            path: Path::None,
        })
    }

    /// A twist without slip; `bonded` is its solution under `moment` (N m).
    ///
    /// # Errors
    /// As [`Bonded::new`]; none for numbers of which there is a solution.
    pub fn twist(
        pair: SolidPair,
        ellipse: Ellipse,
        moment: f64,
        bonded: &'a Bonded,
    ) -> Result<Self, ResponseError> {
        let stiffness = Stiffness::new(pair, ellipse)?.twist;
        let half = |point| magnitude(bonded.traction(point));
        let mut numbers = Report::default();
        given(&mut numbers).number("moment", "moment Mz", NewtonMetre, moment);
        shape(&mut numbers, ellipse);
        pair_numbers(&mut numbers, pair);
        found(&mut numbers)
            .number("twist", "twist", Radian, bonded.twist())
            .number("stiffness", "stiffness", NewtonMetrePerRadian, stiffness)
            .number(
                "traction_half_a",
                "traction half way along x",
                Pascal,
                half([0.5 * ellipse.a(), 0.0]),
            )
            .number(
                "traction_half_b",
                "traction half way along y",
                Pascal,
                half([0.0, 0.5 * ellipse.b()]),
            );
        Ok(Self {
            cautions: Vec::new(),
            problem: "twist",
            title: "Twist without slip",
            ellipse,
            numbers,
            field: Field::Bonded(bonded),
            path: Path::None,
        })
    }

    /// A shift with slip at the edge; `partial` is its solution under `force` (N).
    ///
    /// # Errors
    /// As [`Bonded::new`]; none for numbers of which there is a solution.
    pub fn partial_slip(
        contact: &Hertz,
        friction: f64,
        force: [f64; 2],
        partial: &'a PartialSlip,
    ) -> Result<Self, ResponseError> {
        let ellipse = contact.ellipse();
        let mut numbers = Report::default();
        pressed(&mut numbers, contact.normal_force(), friction);
        forces(&mut numbers, force);
        shape(&mut numbers, ellipse);
        peak_pressure(&mut numbers, contact);
        pair_numbers(&mut numbers, contact.pair());
        slip_numbers(&mut numbers, contact, friction, force, partial)?;
        Ok(Self {
            cautions: Vec::new(),
            problem: "partial-slip",
            title: "Shift with slip at the edge",
            ellipse,
            numbers,
            field: Field::PartialSlip(partial),
            path: Path::None,
        })
    }
}

fn slip_numbers(
    numbers: &mut Report,
    contact: &Hertz,
    friction: f64,
    force: [f64; 2],
    partial: &PartialSlip,
) -> Result<(), ResponseError> {
    let (ellipse, adhesion, [x, y]) = (contact.ellipse(), partial.adhesion(), partial.shift());
    let scale = adhesion.a() / ellipse.a();
    let stuck = Stiffness::new(contact.pair(), ellipse)?;
    let slip = Slip::of(ellipse, partial);
    let used = 100.0 * magnitude(force) / (friction * contact.normal_force());
    let peak = magnitude(partial.traction([adhesion.a(), 0.0]));
    let limit = partial.largest_disagreement().to_degrees();
    found(numbers)
        .number("friction_used", "force, share of mu N", Percent, used)
        .number("shift_x", "shift along x", Metre, x)
        .number("shift_y", "shift along y", Metre, y)
        // By (3.65) the compliance grows as (1 - F/(mu N))^(-1/3), the adhesion area's scale.
        .number("stiffness_x", "stiffness along x, tangent", NewtonPerMetre, scale * stuck.x)
        .number("stiffness_y", "stiffness along y, tangent", NewtonPerMetre, scale * stuck.y)
        .number("peak_traction", "peak traction", Pascal, peak)
        .number("largest_slip", "largest slip", Metre, slip.largest)
        .number("adhesion_a", "adhesion, semi-axis along x", Metre, adhesion.a())
        .number("adhesion_b", "adhesion, semi-axis along y", Metre, adhesion.b())
        .number("adhesion", "adhesion, share of area", Percent, 100.0 * scale * scale)
        .number("slip_to_traction", "slip to traction, at most", Degree, slip.angle)
        .number(
            "slip_to_traction_edge",
            "slip to traction, on the edge",
            Degree,
            slip.angle_at_edge,
        )
        .number("slip_to_traction_at_limit", "the same when F = mu N", Degree, limit);
    Ok(())
}

/// Resistance to shifts and to a twist without slip.
struct Stiffness {
    /// Along x [N/m].
    x: f64,
    /// Along y [N/m].
    y: f64,
    /// About z [N m/rad].
    twist: f64,
}

impl Stiffness {
    fn new(pair: SolidPair, ellipse: Ellipse) -> Result<Self, ResponseError> {
        let unit = SiForce { longitudinal: 1.0, lateral: 1.0, moment: 1.0 };
        let bonded = Bonded::new(pair, ellipse, unit)?;
        let [x, y] = bonded.shift();
        Ok(Self { x: x.recip(), y: y.recip(), twist: bonded.twist().recip() })
    }
}

/// What a problem was given.
pub(super) fn given(numbers: &mut Report) -> Section<'_> {
    numbers.statics("given")
}

/// What was found.
pub(super) fn found(numbers: &mut Report) -> Section<'_> {
    numbers.statics("found")
}

/// Load and friction of a contact that is pressed first.
pub(super) fn pressed(numbers: &mut Report, normal_force: f64, friction: f64) {
    given(numbers).number("normal_force", "normal force N", Newton, normal_force).number(
        "friction",
        "friction mu",
        One,
        friction,
    );
}

/// The peak pressure of a contact that is pressed first.
pub(super) fn peak_pressure(numbers: &mut Report, contact: &Hertz) {
    given(numbers).number("peak_pressure", "peak pressure", Pascal, contact.peak_pressure());
}

fn forces(numbers: &mut Report, [x, y]: [f64; 2]) {
    given(numbers).number("force_x", "tangential force Fx", Newton, x).number(
        "force_y",
        "tangential force Fy",
        Newton,
        y,
    );
}

pub(super) fn shape(numbers: &mut Report, ellipse: Ellipse) {
    given(numbers).number("semi_axis_rolling", "semi-axis a, along x", Metre, ellipse.a()).number(
        "semi_axis_lateral",
        "semi-axis b, along y",
        Metre,
        ellipse.b(),
    );
}

fn solid_numbers(numbers: &mut Report, shear_modulus: f64, poisson: f64) {
    given(numbers).number("shear_modulus", "shear modulus G", Pascal, shear_modulus).number(
        "poisson",
        "Poisson's ratio",
        One,
        poisson,
    );
}

pub(super) fn pair_numbers(numbers: &mut Report, pair: SolidPair) {
    solid_numbers(numbers, pair.shear_modulus(), pair.poisson());
    given(numbers).number("kappa", "dissimilarity kappa", One, pair.kappa());
}

/// The angle from one vector to another, positive from x to y (degrees).
fn turn(from: [f64; 2], to: [f64; 2]) -> f64 {
    let (cross, dot) = (from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
    cross.atan2(dot).to_degrees()
}
