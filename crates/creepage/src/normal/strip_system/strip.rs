//! Strip along rolling and its pressure; the peak of several.

use super::kernel::profile;
use super::rules::MAX_TERMS;

/// A strip along rolling: lengths and pressures in the solver's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strip {
    pub(crate) y: f64,
    /// Half its width across rolling.
    pub(crate) width: f64,
    pub(crate) centre: f64,
    pub(crate) half: f64,
    /// The pressure is `sqrt(1 - s^2)` times these of Chebyshev's polynomials `U_k(s)`.
    pub(crate) pressure: [f64; MAX_TERMS],
    /// Which band it belongs to.
    pub(crate) band: usize,
}

impl Strip {
    pub(crate) fn load(&self) -> f64 {
        std::f64::consts::PI * self.width * self.half * self.pressure[0]
    }

    /// The pressure at `s`.
    fn at(&self, s: f64) -> f64 {
        (1.0 - s * s).sqrt() * profile(&self.pressure, s)
    }

    /// No tension anywhere in it.
    pub(in crate::normal) fn is_compressive(&self) -> bool {
        const SAMPLES: i32 = 8;
        (-SAMPLES..=SAMPLES)
            .all(|i| profile(&self.pressure, f64::from(i) / f64::from(SAMPLES)) >= 0.0)
    }

    pub(in crate::normal) fn peak(&self) -> f64 {
        const SAMPLES: i32 = 20;
        (1 - SAMPLES..SAMPLES)
            .map(|i| self.at(f64::from(i) / f64::from(SAMPLES)))
            .fold(0.0, f64::max)
    }
}

/// The strip of greatest pressure; the first where there are none.
pub(in crate::normal) fn top(strips: &[Strip]) -> usize {
    let peaks = strips.iter().map(Strip::peak).enumerate();
    peaks.max_by(|(_, one), (_, other)| one.total_cmp(other)).map_or(0, |(top, _)| top)
}

/// The top of the parabola across through the strip of greatest pressure and its neighbours.
pub(in crate::normal) fn peak(strips: &[Strip]) -> f64 {
    let top = top(strips);
    let highest = strips.get(top).map_or(0.0, Strip::peak);
    let neighbour = |at: Option<usize>| {
        let at = at.filter(|&at| at < strips.len() && strips[at].band == strips[top].band)?;
        Some((strips[at].y - strips[top].y, strips[at].peak() - highest))
    };
    let (Some((low, below)), Some((high, above))) =
        (neighbour(top.checked_sub(1)), neighbour(Some(top + 1)))
    else {
        return highest;
    };
    let bend = (above / high - below / low) / (high - low);
    let slope = above / high - bend * high;
    if bend < 0.0 { highest - 0.25 * slope * slope / bend } else { highest }
}
