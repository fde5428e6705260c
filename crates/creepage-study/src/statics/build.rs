//! What each problem is given, and what an engineer wants to know of it.

use creepage::SiForce;
use creepage::halfspace::ResponseError;
use creepage::statics::{Bonded, Die, DieError, PartialSlip};
use creepage::{Ellipse, Hertz, Solid, SolidPair};

use super::StaticsReport;
use super::field::{Field, magnitude};
use super::path::Path;
use super::quantity::Quantity;
use super::slip_angle::Slip;

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
        let given = vec![
            Quantity::new("normal_force_n", "normal force N", normal_force, "N").symbol("N", ""),
            Quantity::new("offset_x_m", "offset of N along x", offset[0], "m").symbol("x", "N"),
            Quantity::new("offset_y_m", "offset of N along y", offset[1], "m").symbol("y", "N"),
        ];
        let [x, y] = die.tilt();
        let edge = (x * base.a()).hypot(y * base.b());
        let centre = die.indentation();
        let found = vec![
            Quantity::new("indentation_m", "indentation at the centre", centre, "m"),
            Quantity::new("deepest_m", "indentation, deepest edge", centre + edge, "m"),
            Quantity::new("shallowest_m", "indentation, opposite edge", centre - edge, "m"),
            Quantity::new("tilt_x_rad", "tilt along x", x, "rad"),
            Quantity::new("tilt_y_rad", "tilt along y", y, "rad"),
            Quantity::new("stiffness_n_per_m", "stiffness", normal_force / centre, "N/m"),
            Quantity::new(
                "stiffness_tilt_x_n_m_per_rad",
                "tilt stiffness along x",
                stiffness[0],
                "N m/rad",
            ),
            Quantity::new(
                "stiffness_tilt_y_n_m_per_rad",
                "tilt stiffness along y",
                stiffness[1],
                "N m/rad",
            ),
            Quantity::new(
                "pressure_centre_pa",
                "pressure at the centre",
                die.pressure([0.0; 2]),
                "Pa",
            ),
            Quantity::new(
                "lift_off_used_percent",
                "offset, share of lift-off",
                100.0 * (1.0 - die.margin()),
                "%",
            ),
            Quantity::new("lift_off_x_m", "lift-off limit along x", base.a() / 3.0, "m"),
            Quantity::new("lift_off_y_m", "lift-off limit along y", base.b() / 3.0, "m"),
        ];
        Ok(Self {
            cautions: Vec::new(),
            problem: "die",
            title: "Rigid die on an elastic half-space",
            ellipse: base,
            given: [given, shape(base), solid_numbers(solid.shear_modulus(), solid.poisson())]
                .concat(),
            found,
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
        let found = vec![
            Quantity::new("shift_x_m", "shift along x", x, "m"),
            Quantity::new("shift_y_m", "shift along y", y, "m"),
            Quantity::new(
                "force_to_shift_deg",
                "angle from force to shift",
                turn(force, [x, y]),
                "deg",
            ),
            Quantity::new("stiffness_x_n_per_m", "stiffness along x", stiffness.x, "N/m"),
            Quantity::new("stiffness_y_n_per_m", "stiffness along y", stiffness.y, "N/m"),
            Quantity::new(
                "traction_centre_pa",
                "traction at the centre",
                magnitude(bonded.traction([0.0; 2])),
                "Pa",
            ),
            Quantity::new(
                "traction_mean_pa",
                "traction, mean",
                magnitude(force) / ellipse.area(),
                "Pa",
            ),
        ];
        Ok(Self {
            cautions: Vec::new(),
            problem: "shift",
            title: "Shift without slip",
            ellipse,
            given: [forces(force), shape(ellipse), pair_numbers(pair)].concat(),
            found,
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
        let given = vec![Quantity::new("moment_n_m", "moment Mz", moment, "N m").symbol("M", "z")];
        let found = vec![
            Quantity::new("twist_rad", "twist", bonded.twist(), "rad"),
            Quantity::new("stiffness_n_m_per_rad", "stiffness", stiffness, "N m/rad"),
            Quantity::new(
                "traction_half_a_pa",
                "traction half way along x",
                half([0.5 * ellipse.a(), 0.0]),
                "Pa",
            ),
            Quantity::new(
                "traction_half_b_pa",
                "traction half way along y",
                half([0.0, 0.5 * ellipse.b()]),
                "Pa",
            ),
        ];
        Ok(Self {
            cautions: Vec::new(),
            problem: "twist",
            title: "Twist without slip",
            ellipse,
            given: [given, shape(ellipse), pair_numbers(pair)].concat(),
            found,
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
        let (given, peak) = pressed(contact, friction);
        Ok(Self {
            cautions: Vec::new(),
            problem: "partial-slip",
            title: "Shift with slip at the edge",
            ellipse,
            given: [given, forces(force), shape(ellipse), vec![peak], pair_numbers(contact.pair())]
                .concat(),
            found: slip_numbers(contact, friction, force, partial)?,
            field: Field::PartialSlip(partial),
            path: Path::None,
        })
    }
}

fn slip_numbers(
    contact: &Hertz,
    friction: f64,
    force: [f64; 2],
    partial: &PartialSlip,
) -> Result<Vec<Quantity>, ResponseError> {
    let (ellipse, adhesion, [x, y]) = (contact.ellipse(), partial.adhesion(), partial.shift());
    let scale = adhesion.a() / ellipse.a();
    let stuck = Stiffness::new(contact.pair(), ellipse)?;
    let slip = Slip::of(ellipse, partial);
    let used = 100.0 * magnitude(force) / (friction * contact.normal_force());
    let peak = magnitude(partial.traction([adhesion.a(), 0.0]));
    let limit = partial.largest_disagreement().to_degrees();
    Ok(vec![
        Quantity::new("friction_used_percent", "force, share of mu N", used, "%"),
        Quantity::new("shift_x_m", "shift along x", x, "m"),
        Quantity::new("shift_y_m", "shift along y", y, "m"),
        // By (3.65) the compliance grows as (1 - F/(mu N))^(-1/3), the adhesion area's scale.
        Quantity::new("stiffness_x_n_per_m", "stiffness along x, tangent", scale * stuck.x, "N/m"),
        Quantity::new("stiffness_y_n_per_m", "stiffness along y, tangent", scale * stuck.y, "N/m"),
        Quantity::new("peak_traction_pa", "peak traction", peak, "Pa"),
        Quantity::new("largest_slip_m", "largest slip", slip.largest, "m"),
        Quantity::new("adhesion_a_m", "adhesion, semi-axis along x", adhesion.a(), "m"),
        Quantity::new("adhesion_b_m", "adhesion, semi-axis along y", adhesion.b(), "m"),
        Quantity::new("adhesion_percent", "adhesion, share of area", 100.0 * scale * scale, "%"),
        Quantity::new("slip_to_traction_deg", "slip to traction, at most", slip.angle, "deg"),
        Quantity::new(
            "slip_to_traction_edge_deg",
            "slip to traction, on the edge",
            slip.angle_at_edge,
            "deg",
        ),
        Quantity::new("slip_to_traction_at_limit_deg", "the same when F = mu N", limit, "deg"),
    ])
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

/// Load and friction of a contact that is pressed first, and its peak pressure.
pub(super) fn pressed(contact: &Hertz, friction: f64) -> (Vec<Quantity>, Quantity) {
    let given = vec![
        Quantity::new("normal_force_n", "normal force N", contact.normal_force(), "N")
            .symbol("N", ""),
        Quantity::new("friction", "friction mu", friction, "").symbol("μ", ""),
    ];
    (given, Quantity::new("peak_pressure_pa", "peak pressure", contact.peak_pressure(), "Pa"))
}

fn forces(force: [f64; 2]) -> Vec<Quantity> {
    vec![
        Quantity::new("force_x_n", "tangential force Fx", force[0], "N").symbol("F", "x"),
        Quantity::new("force_y_n", "tangential force Fy", force[1], "N").symbol("F", "y"),
    ]
}

pub(super) fn shape(ellipse: Ellipse) -> Vec<Quantity> {
    vec![
        Quantity::new("semi_axis_rolling_m", "semi-axis a, along x", ellipse.a(), "m")
            .symbol("a", ""),
        Quantity::new("semi_axis_lateral_m", "semi-axis b, along y", ellipse.b(), "m")
            .symbol("b", ""),
    ]
}

fn solid_numbers(shear_modulus: f64, poisson: f64) -> Vec<Quantity> {
    vec![
        Quantity::new("shear_modulus_pa", "shear modulus G", shear_modulus, "Pa").symbol("G", ""),
        Quantity::new("poisson", "Poisson's ratio", poisson, "").symbol("σ", ""),
    ]
}

pub(super) fn pair_numbers(pair: SolidPair) -> Vec<Quantity> {
    let mut numbers = solid_numbers(pair.shear_modulus(), pair.poisson());
    numbers.push(Quantity::new("kappa", "dissimilarity kappa", pair.kappa(), ""));
    numbers
}

/// The angle from one vector to another, positive from x to y (degrees).
fn turn(from: [f64; 2], to: [f64; 2]) -> f64 {
    let (cross, dot) = (from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
    cross.atan2(dot).to_degrees()
}
