//! Progress of a history: what its pictures need, and bytes of it to go on from.

use creepage::Region;
use creepage::coulomb::ElementField;
use creepage::unsteady::Rolled;

/// Tractions below this part of the largest bound are not drawn.
pub(super) const LEAST_TRACTION: f64 = 0.01;

/// Distance (m), creepage and force at the end of a row, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moment {
    pub distance: f64,
    pub creepage: [f64; 3],
    pub force: [f64; 3],
}

/// The contact at some distance, element by element.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Frame {
    /// Distance rolled (m).
    pub distance: f64,
    /// Size of the contact over that under the nominal load.
    pub scale: f64,
    /// Whether an element slides.
    pub slides: Vec<bool>,
    /// Tractions in the unit of the nominal load.
    pub tractions: Vec<[f64; 2]>,
}

#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Progress {
    pub moments: Vec<Moment>,
    pub frames: Vec<Frame>,
}

impl Moment {
    pub(super) fn new(distance: f64, rolled: &Rolled) -> Self {
        let (creepage, force) = (rolled.creepage.components(), rolled.solution.force.components());
        Self { distance, creepage, force }
    }
}

impl Frame {
    pub(super) fn new(distance: f64, scale: f64, elements: &[ElementField]) -> Self {
        let slides = elements.iter().map(|one| one.point.region == Region::Slip).collect();
        let tractions = elements.iter().map(|one| one.point.traction).collect();
        Self { distance, scale, slides, tractions }
    }

    /// Whether a traction is large enough to be drawn.
    pub(super) fn has_traction(&self) -> bool {
        self.tractions.iter().any(|[x, y]| x.hypot(*y) > LEAST_TRACTION)
    }
}

impl Progress {
    /// Numbers one after the other, each list after its length.
    pub(super) fn to_bytes(&self) -> Vec<u8> {
        let mut numbers = vec![self.moments.len() as f64];
        for Moment { distance, creepage, force } in &self.moments {
            numbers.push(*distance);
            numbers.extend(creepage.iter().chain(force));
        }
        numbers.push(self.frames.len() as f64);
        for Frame { distance, scale, slides, tractions } in &self.frames {
            numbers.extend([*distance, *scale, slides.len() as f64]);
            for (slides, traction) in slides.iter().zip(tractions) {
                numbers.push(f64::from(u8::from(*slides)));
                numbers.extend(traction);
            }
        }
        numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
    }

    /// Reads what [`Progress::to_bytes`] wrote; `None` for other bytes.
    pub(super) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let numbers = bytes.as_chunks::<8>().0.iter().map(|chunk| f64::from_le_bytes(*chunk));
        let from = &mut numbers.into_iter();
        let mut progress = Self::default();
        for _ in 0..count(from)? {
            let [distance, xi, eta, chi, fx, fy, mz] = several(from)?;
            let (creepage, force) = ([xi, eta, chi], [fx, fy, mz]);
            progress.moments.push(Moment { distance, creepage, force });
        }
        for _ in 0..count(from)? {
            let [distance, scale] = several(from)?;
            let (mut slides, mut tractions) = (Vec::new(), Vec::new());
            for _ in 0..count(from)? {
                let [one, x, y] = several(from)?;
                slides.push(one != 0.0);
                tractions.push([x, y]);
            }
            progress.frames.push(Frame { distance, scale, slides, tractions });
        }
        Some(progress)
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // checked
fn count(from: &mut impl Iterator<Item = f64>) -> Option<usize> {
    let value = from.next()?;
    ((0.0..1e9).contains(&value) && value.fract() == 0.0).then_some(value as usize)
}

fn several<const N: usize>(from: &mut impl Iterator<Item = f64>) -> Option<[f64; N]> {
    let mut values = [0.0; N];
    for value in &mut values {
        *value = from.next()?;
    }
    Some(values)
}
