//! Strip of FaStrip before FASTSIM turns the traction in its slip area.

use crate::approximate::dual::Real;
use crate::approximate::strip::Strip;

/// A strip as strip theory has it, with the direction of its traction kept in the slip area.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row<R> {
    /// Force and moment per width, in units of `3/4 mu N`.
    pub(super) force: [R; 3],
    /// Direction of the traction.
    pub(super) direction: [R; 2],
    /// Where the slip area ends, in units of the half-length; -1 is the trailing edge.
    pub(super) border: R,
    /// FASTSIM's traction is taken as it is, and not brought to the bound.
    pub(super) keeps: bool,
}

impl<R: Real> Row<R> {
    /// The strip at `t = y/b` of half-length `a s`.
    pub(super) fn of_strip(strip: &Strip<R>, [t, s]: [f64; 2], axes: [f64; 2]) -> Self {
        let direction = strip.direction();
        let force = if strip.depth.value() < s {
            strip.force([R::constant(t), R::constant(s)], axes)
        } else {
            let [fx, fy] = direction.map(|n| n * (s * s));
            [fx, fy, fx * (-t * axes[1])]
        };
        Self { force, direction, border: strip.depth * (2.0 / s) + -1.0, keeps: false }
    }

    /// A strip in which all comes from FASTSIM: the border lies ahead of the leading edge.
    pub(super) fn fastsim(keeps: bool) -> Self {
        let zero = R::constant(0.0);
        Self { force: [zero; 3], direction: [zero; 2], border: R::constant(3.0), keeps }
    }
}
