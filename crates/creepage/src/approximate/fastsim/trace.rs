//! March of FASTSIM through one strip to one position.

use super::flexibility::Slopes;
use super::grid::Grid;
use super::grid::Profile;
use crate::Ellipse;

/// A position within the contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// Place across, `y`.
    pub(crate) y: f64,
    /// `y / b`.
    pub(crate) t: f64,
    /// The strip's half-length over `a`.
    pub(crate) s: f64,
    /// The strip's half-length.
    pub(crate) half_length: f64,
    /// Place along in units of the half-length, between -1 and 1.
    pub(crate) along: f64,
}

impl Place {
    /// `None` outside the contact and at its lateral ends, where strips have no length.
    pub(crate) fn new(ellipse: &Ellipse, [x, y]: [f64; 2]) -> Option<Self> {
        let t = y / ellipse.b();
        let s = ((1.0 - t) * (1.0 + t)).max(0.0).sqrt();
        let half_length = ellipse.a() * s;
        let inside = s > 0.0 && x.abs() <= half_length;
        inside.then(|| Self { y, t, s, half_length, along: x / half_length })
    }
}

/// What the march finds at its end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trace {
    /// Traction in units of `mu N / c^2`.
    pub(crate) traction: [f64; 2],
    /// Traction that the last step would have added, had there been no bound, per length.
    pub(crate) lost: [f64; 2],
}

impl Trace {
    /// Whether the end of the march slips.
    pub(crate) fn slides(&self) -> bool {
        self.lost.iter().any(|v| *v != 0.0)
    }

    /// Marches with the cells of `grid`, and a last shorter step that ends at `place`.
    pub(crate) fn new(grid: &Grid, profile: Profile, slopes: &Slopes<f64>, place: &Place) -> Self {
        let peak = profile.peak(place.s);
        let mut trace = Self { traction: [0.0; 2], lost: [0.0; 2] };
        for (from, to) in grid.walk(place.along) {
            let length = (from - to) * place.half_length;
            let middle = 0.5 * (from + to) * place.half_length;
            let growth = slopes.at([middle, place.y]);
            let trial = [0, 1].map(|i| trace.traction[i] + length * growth[i]);
            let (bound, size) = (peak * profile.along(to), trial[0].hypot(trial[1]));
            let scale = if size > bound { bound / size } else { 1.0 };
            trace.traction = trial.map(|v| v * scale);
            trace.lost = trial.map(|v| v * (1.0 - scale) / length);
        }
        trace
    }
}
