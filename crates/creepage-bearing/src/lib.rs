//! A ball bearing: the equilibrium of every ball under load, centrifugal force and gyroscopic moment, the spin that both
//! races share, and the sliding, friction and heat of every contact.
//!
//! [`BallBearing`] is what it is, [`Operation`] how it runs; [`BallBearing::solve`] gives a [`SolvedBearing`]. In each
//! contact the ball slides by creepage, by spin, and by Heathcote's slip, which grows with the square of the place across
//! because ball and groove conform. Lengths in metres, angles in radians, forces in newtons, angular velocities in rad/s.

mod bearing;
mod equilibrium;
mod error;
mod friction;
mod motion;
mod solved;

pub use bearing::{BallBearing, BearingLoad, Control, Operation};
pub use error::BearingError;
pub use friction::{BearingTheory, RaceField, RaceFriction, RaceSlip};
pub use motion::BallMotion;
pub use solved::{SolvedBall, SolvedBearing, SolvedRace};
