//! Layout of strips in bands, and of bands from strips.

use crate::gap::{Gap, Rectangle};
use crate::normal::chord::{Chord, place};
use crate::normal::lattice::whole;
use crate::normal::level::NormalProblem;
use crate::normal::patch::Patch;
use crate::normal::patch_strip::Band;
use crate::normal::strip_system::{MAX_TERMS, Strip, profile};

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
    /// Lengths by the root of the area, depths by the greatest at the strips.
    pub(super) fn of(task: NormalProblem<'_>, start: &[Patch]) -> Option<Self> {
        let area: f64 = start.iter().map(Patch::area).sum();
        let Rectangle { x, y } = start.first()?.extent();
        let origin = [x, y].map(|[low, high]| f64::midpoint(low, high));
        let depth = start
            .iter()
            .flat_map(Patch::bands)
            .flat_map(|band| band.rows().map(|y| (band.ends(y), y)).collect::<Vec<_>>())
            .filter_map(|(ends, y)| ends.map(|[from, to]| (f64::midpoint(from, to), y)))
            .map(|(x, y)| task.approach - task.gap.at(x, y))
            .fold(0.0, f64::max);
        let length = area.sqrt();
        let pressure = task.modulus * depth / length;
        (depth > 0.0 && length > 0.0).then_some(Self { origin, length, depth, pressure })
    }

    pub(super) fn force(self) -> f64 {
        self.pressure * self.length * self.length
    }
}

/// Strips of the narrowest band.
pub(super) const FEWEST: usize = 4;
/// Newton's matrix has six rows a strip at most.
const MOST_STRIPS: usize = 120;

/// Strips across the widest band, so that none becomes so slender that its ends follow those of its
/// neighbours by chance.
pub(in crate::normal) fn most(start: &[Patch]) -> usize {
    const SLENDEREST: f64 = 200.0;
    const MIN_STRIPS: usize = 6;
    let bands = || start.iter().flat_map(Patch::bands);
    let widest = bands().map(width).fold(0.0, f64::max);
    let most = bands().map(|band| {
        let [from, to] = band.x();
        SLENDEREST * (width(band) * widest).sqrt() / (0.5 * (to - from))
    });
    whole(most.fold(f64::INFINITY, f64::min).min(f64::from(u16::MAX))).max(MIN_STRIPS)
}

/// Strips in all bands, more in the wider ones; `None` if they are too many.
pub(super) fn laid(
    start: &[Patch],
    count: usize,
    terms: usize,
    units: Units,
) -> Option<Vec<Strip>> {
    let bands: Vec<&Band> = start.iter().flat_map(Patch::bands).collect();
    let widest = bands.iter().map(|band| width(band)).fold(0.0, f64::max);
    let strips = bands.iter().enumerate().flat_map(|(index, band)| {
        let share = (width(band) / widest).sqrt();
        let strips = whole((count as f64 * share).round()).clamp(FEWEST.min(count), count);
        lay(band, index, strips, terms, units)
    });
    let strips: Vec<Strip> = strips.collect();
    let usable = strips.len() <= MOST_STRIPS && strips.iter().all(|strip| strip.half > 0.0);
    usable.then_some(strips)
}

/// Lays strips about the x that all sections are symmetric about.
pub(super) fn centre(laid: &mut [Strip], gap: &Gap, units: Units) {
    let Some(axis) = gap.axis() else { return };
    for strip in laid {
        strip.centre = (axis - units.origin[0]) / units.length;
    }
}

fn width(band: &Band) -> f64 {
    band.y()[1] - band.y()[0]
}

/// Lays strips into a band, closer towards its sides.
fn lay(band: &Band, index: usize, count: usize, terms: usize, units: Units) -> Vec<Strip> {
    // Sine of nine tenths of a right angle: the outermost strips are a third as wide.
    const CLUSTER: f64 = 0.8 * std::f64::consts::FRAC_PI_2;
    // Of the shortest chord: at a waist a cubic through squared lengths may fall below zero.
    const MIN_CHORD: f64 = 0.2;
    let least = MIN_CHORD * band.shortest();
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
fn projected(band: &Band, y: f64, terms: usize) -> [f64; MAX_TERMS] {
    const QUADRATURE_POINTS: u32 = 24;
    let mut coefficients = [0.0; MAX_TERMS];
    let line = band.line(y);
    for i in 1..=QUADRATURE_POINTS {
        let angle = std::f64::consts::PI * f64::from(i) / f64::from(QUADRATURE_POINTS + 1);
        let (sin, s) = angle.sin_cos();
        let pressure = line.pressure(s);
        for (k, coefficient) in coefficients.iter_mut().take(terms).enumerate() {
            // U_k(cos t) = sin((k+1) t) / sin t.
            let sine = ((k + 1) as f64 * angle).sin();
            *coefficient += 2.0 / f64::from(QUADRATURE_POINTS + 1) * pressure * sine * sin / sin;
        }
    }
    coefficients
}

/// The areas that strips make, which were laid into `start`.
pub(super) fn patches(start: &[Patch], strips: &[Strip], units: Units) -> Vec<Patch> {
    let mut index = 0;
    start
        .iter()
        .map(|patch| {
            let bands = patch.bands().iter().map(|laid| {
                let own: Vec<Strip> =
                    strips.iter().filter(|strip| strip.band == index).copied().collect();
                index += 1;
                band(&own, units, laid, laid.tips())
            });
            Patch::new(bands.collect())
        })
        .collect()
}

/// The band that strips make; tips lie where the squared half length reaches zero.
fn band(strips: &[Strip], units: Units, laid: &Band, tips: [bool; 2]) -> Band {
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
    const TIP_RANGE: [f64; 2] = [0.5, 1.5];
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
    let most = TIP_RANGE[1] * reach;
    let falls = distance > 0.0 && distance.is_finite();
    y0 - inward * if falls { distance.clamp(TIP_RANGE[0] * reach, most) } else { most }
}
