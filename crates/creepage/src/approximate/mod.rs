//! Approximate theories of rolling: nanoseconds to microseconds a force.
//!
//! | theory | what it assumes |
//! |---|---|
//! | [`fastrip`] | strips stick, springs slide |
//! | [`fastsim`] | a bed of springs |
//! | [`strip`] | plane strips, `a << b` |
//! | [`polach`] | a traction that grows steadily |
//! | [`shen_hedrick_elkins`] | linear forces, cubic saturation |
//! | [`vermeulen_johnson`] | no spin, adhesion in an ellipse |
//! | [`linear`] | no slip anywhere |
//! | [`saturated`] | slip everywhere |
//! | [`non_hertzian`] | four of these on areas of any shape |
//! | [`carter`] | two cylinders: exact, in two dimensions |
//! | [`free_rolling`] | unlike bodies roll freely without slip: exact, on a circle |
//!
//! What each is good for, and how far it is off: [`TheoryFacts`](crate::theory::TheoryFacts).
//!
//! # Sources
//! The original papers of FASTSIM, FaStrip, strip theory, Polach's law and the law of Shen, Hedrick
//! and Elkins were not at hand. These theories follow later descriptions; where those disagree,
//! limits and closed forms decided. Their forces are verified against linear theory, full sliding
//! and the full theory, but a detail of an original paper may differ from ours.

pub mod carter;
pub mod fastrip;
pub mod fastsim;
pub mod free_rolling;
pub mod linear;
pub mod non_hertzian;
pub mod polach;
pub mod saturated;
pub mod shen_hedrick_elkins;
pub mod strip;
pub mod vermeulen_johnson;

mod cubic;
mod dual;
mod outside_chords;
