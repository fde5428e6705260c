//! The elastic half-space: tractions on an ellipse in, displacement differences out.
pub mod harmonics;
