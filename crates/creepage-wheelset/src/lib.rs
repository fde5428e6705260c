//! A wheelset on its track: where it stands under its load, what each of its contacts carries, how it rolls, and
//! how all of that changes with its position and motion.
//!
//! [`WheelsetSolver`] takes wheels and rails ([`creepage_rail::WheelsetOnTrack`]), materials, friction and a theory;
//! [`WheelsetSolver::solve`] takes a [`WheelsetPose`] and a [`WheelsetVelocity`] and gives a [`SolvedWheelset`].
//! Lengths in metres, angles in radians, forces in newtons; `x` forward, `y` to the right, `z` down.
//!
//! ```
//! use creepage::theory::{AreaTheory, ExactOptions};
//! use creepage::{Solid, SolidPair};
//! use creepage_rail::{Place, Standard, Track, Wheelset};
//! use creepage_wheelset::{Load, RailFriction, WheelsetPose, WheelsetSolver, WheelsetVelocity};
//!
//! let track = Track::new(&Standard::Uic60.profile(), 0.025f64.atan(), Place::gauge(1.435, 0.014))?;
//! let running = Wheelset::like(&Standard::S1002.profile(), 0.46, 1.360)?.on(track);
//! let steel = Solid::new(82e9, 0.28)?;
//! let friction = [RailFriction::Constant(0.3), RailFriction::Constant(0.3)];
//! let theory = AreaTheory::Exact(ExactOptions::default());
//! let solver = WheelsetSolver::new(&running, SolidPair::new(steel, steel), friction, theory)?;
//!
//! let load = Some(Load::Axle(100e3));
//! let pose = WheelsetPose { side: None, y: 0.003, yaw: 0.0, roll: None, load };
//! let solved = solver.solve(&pose, &WheelsetVelocity { speed: 30.0, ..WheelsetVelocity::default() })?;
//! let [force, _] = solved.wrench(running.wheelset().radius()); // of the rails on the wheelset (N)
//! assert!((force[2] + 100e3).abs() < 100.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod asked;
mod correction;
mod curving;
mod derivatives;
mod error;
mod field;
mod friction;
mod pose;
mod resultant;
mod rough;
mod solved;
mod solver;
mod springs;
mod steps;
mod tilt;
mod warm_start;

pub use asked::{ANSWERS, ASKED, asked};
pub use derivatives::{ForceDerivative, StateVariable, WheelsetDerivatives};
pub use error::{WheelsetError, side_word};
pub use friction::{FrictionOfPlace, PlaceOnRail, RailFriction};
pub use pose::{Drive, Load, Patches, PitchRate, RigidSlip, WheelsetPose, WheelsetVelocity};
pub use resultant::Resultant;
pub use rough::{Roughness, Unmeasured, rough_profiles, unmeasured_profiles};
pub use solved::{SolvedContact, SolvedWheel, SolvedWheelset, SurfaceLimits};
pub use solver::{PressedContacts, WheelsetSolver};
pub use springs::RailSprings;
pub use steps::{ContactChanges, SteppedWheelset, StepsStart, WheelSteps};
