//! Strips laid into bands, and bands made of strips.

use crate::normal::band::{Band, Chord, place};

use super::kernel::profile;
use super::rules::MOST;

/// A strip along rolling: lengths and pressures in the solver's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strip {
    pub(crate) y: f64,
    /// Half its width across rolling.
    pub(crate) width: f64,
    pub(crate) centre: f64,
    pub(crate) half: f64,
    /// The pressure is `sqrt(1 - s^2)` times these of Chebyshev's polynomials `U_k(s)`.
    pub(crate) pressure: [f64; MOST],
    /// Which band it belongs to.
    pub(crate) band: usize,
}

impl Strip {
    pub(crate) fn load(&self) -> f64 {
        std::f64::consts::PI * self.width * self.half * self.pressure[0]
    }

    /// The pressure at `s`.
    pub(super) fn at(&self, s: f64) -> f64 {
        (1.0 - s * s).sqrt() * profile(&self.pressure, s)
    }

    pub(super) fn peak(&self) -> f64 {
        const POINTS: i32 = 20;
        (1 - POINTS..POINTS).map(|i| self.at(f64::from(i) / f64::from(POINTS))).fold(0.0, f64::max)
    }
}

/// Units of length, depth and pressure, and the origin, of the solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Units {
    pub(super) origin: [f64; 2],
    pub(super) length: f64,
    /// The greatest undeformed penetration (m).
    pub(super) depth: f64,
    pub(super) pressure: f64,
}

impl Units {
    pub(super) fn force(self) -> f64 {
        self.pressure * self.length * self.length
    }
}

/// Lays strips into a band, closer towards its sides.
pub(super) fn lay(
    band: &Band,
    index: usize,
    count: usize,
    terms: usize,
    units: Units,
) -> Vec<Strip> {
    // Sine of nine tenths of a right angle: the outermost strips are a third as wide.
    const CLUSTER: f64 = 0.8 * std::f64::consts::FRAC_PI_2;
    // Of the shortest chord: at a waist a cubic through squared lengths may fall below zero.
    const LEAST: f64 = 0.2;
    let least = LEAST * band.shortest();
    let [low, high] = band.y();
    let border = |i: usize| {
        let t = 2.0 * i as f64 / count as f64 - 1.0;
        let place = (CLUSTER * t).sin() / CLUSTER.sin();
        f64::midpoint(low, high) + 0.5 * (high - low) * place
    };
    (0..count)
        .map(|i| {
            let [from, to] = [border(i), border(i + 1)];
            let y = f64::midpoint(from, to);
            let [trailing, leading] = band.ends(y).unwrap_or([0.0; 2]);
            let (centre, half) = (f64::midpoint(trailing, leading), 0.5 * (leading - trailing));
            let half = half.max(least);
            Strip {
                y: (y - units.origin[1]) / units.length,
                width: 0.5 * (to - from) / units.length,
                centre: (centre - units.origin[0]) / units.length,
                half: half / units.length,
                pressure: projected(band, y, terms).map(|p| p / units.pressure),
                band: index,
            }
        })
        .collect()
}

/// The band's pressure at a y in the first of Chebyshev's polynomials.
fn projected(band: &Band, y: f64, terms: usize) -> [f64; MOST] {
    const POINTS: u32 = 24;
    let mut coefficients = [0.0; MOST];
    let line = band.line(y);
    for i in 1..=POINTS {
        let angle = std::f64::consts::PI * f64::from(i) / f64::from(POINTS + 1);
        let (sin, s) = angle.sin_cos();
        let pressure = line.pressure(s);
        for (k, coefficient) in coefficients.iter_mut().take(terms).enumerate() {
            // U_k(cos t) = sin((k+1) t) / sin t.
            let sine = ((k + 1) as f64 * angle).sin();
            *coefficient += 2.0 / f64::from(POINTS + 1) * pressure * sine * sin / sin;
        }
    }
    coefficients
}

/// The band that strips make; tips lie where the squared half length reaches zero.
pub(super) fn band(strips: &[Strip], units: Units, laid: &Band, tips: [bool; 2]) -> Band {
    let chords: Vec<Chord> = strips
        .iter()
        .map(|strip| {
            let half = strip.half * units.length;
            let scale = units.pressure / half;
            Chord {
                y: units.origin[1] + strip.y * units.length,
                half,
                centre: units.origin[0] + strip.centre * units.length,
                density: std::array::from_fn(|i| profile(&strip.pressure, place(i)) * scale),
            }
        })
        .collect();
    let squares: Vec<(f64, f64)> = chords.iter().map(|c| (c.y, c.half * c.half)).collect();
    let reversed: Vec<(f64, f64)> = squares.iter().rev().copied().collect();
    let [low, high] = laid.y();
    let y = [
        if tips[0] { tip(&squares, low) } else { low },
        if tips[1] { tip(&reversed, high) } else { high },
    ];
    Band::new(chords, y, tips)
}

/// Where the parabola through the first three squared half lengths reaches zero, or comes nearest to
/// it, within these parts of the way from the first to where the tip was laid: one that lies further
/// is gone towards. It follows the half lengths without a jump.
fn tip(squares: &[(f64, f64)], laid: f64) -> f64 {
    const NEAR: [f64; 2] = [0.5, 1.5];
    let &[(y0, v0), (y1, v1), (y2, v2), ..] = squares else { return laid };
    let inward = (y1 - y0).signum();
    let rise = (v1 - v0) / (y1 - y0).abs();
    let bend = ((v2 - v1) / (y2 - y1).abs() - rise) / (y2 - y0).abs();
    let slope = rise - bend * (y1 - y0).abs();
    // v0 - slope d + bend d^2 = 0, the first root outwards.
    let root = slope * slope - 4.0 * bend * v0;
    let denominator = slope + root.max(0.0).sqrt();
    let distance = if root < 0.0 { slope / (2.0 * bend) } else { 2.0 * v0 / denominator };
    let reach = (laid - y0).abs();
    let most = NEAR[1] * reach;
    let falls = distance > 0.0 && distance.is_finite();
    y0 - inward * if falls { distance.clamp(NEAR[0] * reach, most) } else { most }
}

/// The strip of greatest pressure; the first where there are none.
pub(super) fn top(strips: &[Strip]) -> usize {
    let peaks = strips.iter().map(Strip::peak).enumerate();
    peaks.max_by(|(_, one), (_, other)| one.total_cmp(other)).map_or(0, |(top, _)| top)
}

/// The top of the parabola across through the strip of greatest pressure and its neighbours.
pub(super) fn peak(strips: &[Strip]) -> f64 {
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
