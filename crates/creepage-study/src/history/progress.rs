//! What a history has come to so far: what its pictures need, and bytes of it to go on from.

use creepage::Region;
use creepage::coulomb::ElementField;
use creepage::unsteady::Rolled;

/// Distance (m), creepage and force at the end of a row, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moment {
    pub distance: f64,
    pub creepage: [f64; 3],
    pub force: [f64; 3],
}

/// The contact at some distance.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Station {
    /// Distance rolled (m).
    pub distance: f64,
    /// Corners of each element over the unit of length, and whether it slides.
    pub elements: Vec<([[f64; 2]; 4], bool)>,
}

#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Progress {
    pub moments: Vec<Moment>,
    pub stations: Vec<Station>,
}

impl Moment {
    pub(super) fn new(distance: f64, rolled: &Rolled) -> Self {
        let (creepage, force) = (rolled.creepage.components(), rolled.solution.force.components());
        Self { distance, creepage, force }
    }
}

impl Station {
    pub(super) fn new(distance: f64, elements: Vec<ElementField>) -> Self {
        let elements = elements.into_iter();
        let elements =
            elements.map(|one| (one.corners, one.point.region == Region::Slip)).collect();
        Self { distance, elements }
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
        numbers.push(self.stations.len() as f64);
        for Station { distance, elements } in &self.stations {
            numbers.extend([*distance, elements.len() as f64]);
            for (corners, slides) in elements {
                numbers.extend(corners.as_flattened());
                numbers.push(f64::from(u8::from(*slides)));
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
            let mut station = Station { distance: from.next()?, elements: Vec::new() };
            for _ in 0..count(from)? {
                let [a, b, c, d, e, f, g, h, slides] = several(from)?;
                station.elements.push(([[a, b], [c, d], [e, f], [g, h]], slides != 0.0));
            }
            progress.stations.push(station);
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
