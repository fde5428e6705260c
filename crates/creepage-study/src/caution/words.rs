//! Warnings in words.

use std::fmt;

use creepage::Status;
use creepage_plot::format::{quantity, significant};

use super::Caution;

impl fmt::Display for Caution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::LikeBodies { .. }
            | Self::Pressure { .. }
            | Self::CoarseGap { .. }
            | Self::Rough { .. }
            | Self::Unmeasured { .. } => self.write_of_areas(f),
            Self::Yields { .. }
            | Self::UncertainPeak { .. }
            | Self::RollerEnd { .. }
            | Self::Turns { .. }
            | Self::Groove { .. } => self.write_of_bodies(f),
            Self::CutPatch
            | Self::BeyondSlices
            | Self::Climbs { .. }
            | Self::GuardApart { .. }
            | Self::NoGuard
            | Self::LargeYaw { .. }
            | Self::LoadMissed { .. }
            | Self::Deep { .. }
            | Self::Slides { .. } => self.write_of_wheelset(f),
            Self::Status(status) => f.write_str(status_words(status)),
            Self::Dissimilar { theory, kappa_over_mu, share } => write!(
                f,
                "{theory} takes the bodies for like ones (kappa/mu = {kappa_over_mu:.3}): for \
                 that the force may be off by some {:.0} % of mu N; exact counts it",
                100.0 * share
            ),
            Self::ConstantFriction { theory } => write!(
                f,
                "{theory} takes friction as constant at its largest value here; exact follows it with the speed \
                 of slip and across the contact, fastsim on ellipses"
            ),
            Self::BeyondFriction { theory, share } => write!(
                f,
                "{theory} knows no slip: its force is {} times what friction allows, mu N; it holds at small creepage \
                 and spin",
                significant(share, 3)
            ),
            Self::NeedsFriction { friction } => write!(
                f,
                "without slip this load takes a coefficient of friction of {} at least: in truth all slides",
                significant(friction, 3)
            ),
            Self::NoLayer { theory } => write!(
                f,
                "{theory} leaves out the layer between the bodies; exact counts it, fastsim on ellipses"
            ),
            Self::ThickLayer { share, stiffer } => write!(
                f,
                "the layer's thickness is {} of the contact's half-width: taken as thin, each place of it shears by \
                 itself; one so thick is about {:.0} % stiffer{}",
                significant(share, 2),
                100.0 * stiffer,
                if share > 10.0 { " (check the unit of thickness: m)" } else { "" }
            ),
            Self::SlipBeyond { along, share } => write!(
                f,
                "the contact reaches beyond the points of [contact] slip along {along}, by {} of its length there: the \
                 slip of the last point goes on unchanged{}",
                significant(share, 2),
                if share > 0.5 { " (check the unit: m)" } else { "" }
            ),
            Self::OneWay { moved } => write!(
                f,
                "pressure and contact area are those without friction: what tractions change about \
                 them may move the force by some {:.1} % of mu N; coupled = true counts it",
                100.0 * moved
            ),
            Self::Accuracy { prescribed, reached } => write!(
                f,
                "at the finest resolution the error bars reach {reached:.2e} of mu N, above the \
                 prescribed accuracy of {prescribed:e}"
            ),
            Self::NoHeat { .. }
            | Self::RunsBack { .. }
            | Self::SlowHeat { .. }
            | Self::Hot { .. } => self.write_heat(f),
            Self::LargeContact { .. }
            | Self::LargeShift { .. }
            | Self::HighPressure { .. }
            | Self::HighModulus { .. }
            | Self::LargeFriction { .. }
            | Self::Shallow { .. }
            | Self::LargeSpin { .. }
            | Self::LargeRadius { .. }
            | Self::LargeCreepage { .. } => self.write_units(f),
        }
    }
}

/// What a status says.
fn status_words(status: Status) -> &'static str {
    match status {
        Status::NotConverged => "did not converge: the force is that of the last iterate",
        Status::CreepageTooSmall => "the creepage is too small for the theory's resolution",
        Status::SpinTooLarge => "the spin is beyond the bound up to which the theory holds",
        Status::SeveralSolutions => {
            "friction falls so steeply that another solution, with more slip, exists; this one \
             is reached from friction at rest"
        }
        Status::NoContact => "no load presses the bodies together: no contact, and no force",
        other => other.name(),
    }
}

impl Caution {
    /// Those of what the bodies bear in words.
    fn write_of_bodies(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Yields { peak_pressure, shear_yield, is_given } => {
                let whose = if is_given { "given" } else { "of a typical rail steel" };
                let times = significant(peak_pressure / shear_yield, 3);
                write!(
                    f,
                    "the peak pressure of {} is {times} times the shear yield stress {whose}, {}: from \
                     {} times on the contact flows, so that it is larger and its pressure lower",
                    quantity(peak_pressure, "Pa", 4),
                    quantity(shear_yield, "Pa", 3),
                    Self::FULLY_PLASTIC
                )?;
                if is_given {
                    return Ok(());
                }
                f.write_str(
                    "; a harder steel bears more: a case with [damage] takes its shear_yield",
                )
            }
            Self::UncertainPeak { peak_pressure, error } => write!(
                f,
                "the peak pressure of {} has an error bar of {}: it does not converge, as at an edge",
                quantity(peak_pressure, "Pa", 3),
                quantity(error, "Pa", 2)
            ),
            Self::RollerEnd { peak, middle, y, on_edge } => write!(
                f,
                "by the end at y = {} the pressure is {}, {} times that of the middle half{}",
                quantity(y, "m", 3),
                quantity(peak, "Pa", 3),
                significant(peak / middle, 3),
                if on_edge {
                    ": the contact reaches the rounded edge, whose radius sets the peak"
                } else {
                    ""
                }
            ),
            Self::Turns { angle } => write!(
                f,
                "the surfaces turn by {} degrees within the contact, which is solved in one plane: from \
                 14 degrees on the undeformed distance errs by 3 % and more",
                significant(angle.to_degrees(), 3)
            ),
            Self::Groove { slip, share } => write!(
                f,
                "the bodies conform: by the curvature of the groove the slip at the sides differs by {} of \
                 the rolling velocity from that in the middle, {} times the unit mu c / rho (Heathcote); it is \
                 left out, and heat, force and moment lack it",
                significant(slip, 3),
                significant(share, 2)
            ),
            _ => Ok(()),
        }
    }

    /// Those of a wheelset on its rails in words.
    fn write_of_wheelset(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::CutPatch => f.write_str(
                "a part of the rail or wheel begins or ends within the contact: the area is cut there, and how high \
                 the pressure is at that edge depends on the resolution",
            ),
            Self::BeyondSlices => f.write_str(
                "the contact lies before the first or behind the last slice of the rail, where the surface is taken \
                 to go on alike",
            ),
            Self::GuardApart { clearance } => write!(
                f,
                "the back of the flange does not touch the guard rail: {} mm lie between them",
                significant(1e3 * clearance, 4)
            ),
            Self::NoGuard => {
                f.write_str("the guard rail is left out: this is of the running rails alone")
            }
            Self::LargeYaw { yaw } => write!(
                f,
                "the wheelset yaws by {} rad, {} degrees, as none runs: angles are in radians",
                significant(yaw, 3),
                significant(yaw.to_degrees(), 3)
            ),
            Self::LoadMissed { missed, load } => write!(
                f,
                "carries {} {} than the {} asked of it, which is within its error bar: the load jumps there as the \
                 wheel goes down",
                quantity(missed.abs(), "N", 3),
                if missed < 0.0 { "less" } else { "more" },
                quantity(load, "N", 4)
            ),
            Self::Climbs { height } if height > Self::RIDES => write!(
                f,
                "the flange rides on the rail, {} mm above the height of the tread: this is no running \
                 wheelset",
                significant(1e3 * height, 3)
            ),
            Self::Climbs { height } => write!(
                f,
                "the wheel has climbed its rail by {} mm above the height of its tread",
                significant(1e3 * height, 3)
            ),
            Self::Deep { approach, load } => write!(
                f,
                "the bodies are pressed {} mm into each other ({}): this is no elastic contact of a \
                 wheel and a rail",
                significant(1e3 * approach, 3),
                quantity(load, "N", 3)
            ),
            Self::Slides { component, value } => write!(
                f,
                "the wheel spins or is locked: its {component} creepage is {}, over the mean speed of \
                 both surfaces, by which heat and wear go too: a metre rolled is no metre of track",
                significant(value, 4)
            ),
            _ => Ok(()),
        }
    }

    /// Those of temperatures in words.
    fn write_heat(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoHeat { theory } => write!(
                f,
                "[heat] gives no temperatures: {theory} has no slip, which heats; exact and fastsim have it"
            ),
            Self::RunsBack { longitudinal } => write!(
                f,
                "[heat] gives no temperatures: at a longitudinal creepage of {} one surface stands still or \
                 runs back, and the heat stays in the contact",
                significant(longitudinal, 4)
            ),
            // Jaeger's band of elliptic heat: 6.3 % at 1, 2.3 % at 2, 1.1 % at 3, 0.4 % at 5.
            Self::SlowHeat { peclet } => write!(
                f,
                "the Peclet number is {}, below {}: heat spreads along the surface too, and the rise by \
                 friction is too large, by some {:.1} %",
                significant(peclet, 3),
                Self::PECLET,
                6.3 * peclet.max(0.1).powf(-1.6)
            ),
            Self::Hot { temperature } => write!(
                f,
                "the contact reaches {} °C: above {} °C steel transforms, and flows; speeds are in m/s",
                significant(temperature, 4),
                Self::HOT
            ),
            _ => Ok(()),
        }
    }

    /// Those of areas of any shape in words.
    fn write_of_areas(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::LikeBodies { kappa_over_mu } => write!(
                f,
                "on areas of any shape, on a line that rolls in steps, and without rolling the bodies are taken for like ones (kappa/mu = \
                 {kappa_over_mu:.3}): the slip by the pressure is left out, and for that the force \
                 may be off by some {:.0} % of mu N",
                100.0 * kappa_over_mu.abs().min(1.0)
            ),
            Self::Pressure { residual } => write!(
                f,
                "the pressure did not converge: pressed points are up to {residual:.1e} of the \
                 depth from touching"
            ),
            Self::CoarseGap { points, along } => write!(
                f,
                "[gap] has only {points} points along {along} across a contact area: with fewer \
                 than {} the area depends on the interpolation",
                Self::MIN_GAP_POINTS
            ),
            Self::Rough { body, length, swing, pressure } => write!(
                f,
                "the {body}'s profile is rough: in the contact it turns to and fro by {} mrad in waves \
                 of {} mm, which only {} would press flat, and its crests carry the load; unless it \
                 is so, smooth it ([{body}] reading = {{ smooth = ... }}, 5 to 10 times that length)",
                significant(1e3 * swing, 2),
                significant(1e3 * length, 2),
                quantity(pressure, "Pa", 2)
            ),
            Self::Unmeasured { body, length } => write!(
                f,
                "the {body}'s profile has no points over {} mm where it touches: its shape there is a curve laid across, \
                 not measured",
                significant(1e3 * length, 3)
            ),
            _ => Ok(()),
        }
    }

    /// Those of [`Caution::units`] in words.
    fn write_units(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::LargeContact { semi_axis, radius } => write!(
                f,
                "the contact's semi-axis of {} m is more than 0.3 of the smallest radius, {} m: \
                 check the units of moduli, radii and load (Pa, m, N)",
                significant(semi_axis, 4),
                significant(radius, 4)
            ),
            Self::LargeShift { shift, half_width } => write!(
                f,
                "the load moves the bodies by {} m, more than 0.3 of the contact's half-width, {} m: no solid \
                 bears that; check the units of moduli, lengths and load (Pa, m, N)",
                significant(shift, 4),
                significant(half_width, 4)
            ),
            Self::HighPressure { peak_pressure, shear_modulus } => write!(
                f,
                "the peak pressure of {} exceeds the shear modulus of {}: check the units of \
                 moduli, radii and load (Pa, m, N)",
                quantity(peak_pressure, "Pa", 4),
                quantity(shear_modulus, "Pa", 4)
            ),
            Self::HighModulus { shear_modulus } => write!(
                f,
                "the combined shear modulus of {} is above that of diamond: check the units of moduli (Pa)",
                quantity(shear_modulus, "Pa", 4)
            ),
            Self::LargeFriction { friction } => write!(
                f,
                "the coefficient of friction of {} is above {}: it is a ratio of forces, not per cent",
                significant(friction, 4),
                Self::FRICTION
            ),
            Self::Shallow { approach, load } => write!(
                f,
                "the load of {} presses wheel and rail {} µm into each other, less than their surfaces are \
                 rough: loads are in N",
                quantity(load, "N", 3),
                significant(1e6 * approach, 2)
            ),
            Self::LargeSpin { spin, slip } => write!(
                f,
                "the spin of {} rad/m makes the surfaces slip at the side of the contact by {} of the rolling \
                 velocity, above 0.3: it is in radians per metre rolled",
                significant(spin, 4),
                significant(slip, 3)
            ),
            Self::LargeRadius { radius } => write!(
                f,
                "the smallest radius of the bodies is {} m: radii are in metres",
                significant(radius, 4)
            ),
            Self::LargeCreepage { component, value } => write!(
                f,
                "the {component} creepage of {} is above 0.3: it is a ratio of velocities, not per \
                 cent or degrees",
                significant(value, 4)
            ),
            _ => Ok(()),
        }
    }
}
