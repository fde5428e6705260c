//! Shared computation of the figures of proposition IV: cylinders that roll, and their areas of adhesion over the
//! distance.

use creepage::unsteady::{Motion, Rolled, Rolling};
use creepage::{InvalidValue, Region};

use crate::prelude::*;

/// Length of the cylinders over the half-width of their contact; it counts where creepage is given.
const LENGTH: f64 = 1000.0;
/// Areas of adhesion of two elements and less come and go with the elements.
const MIN_ADHESION_LENGTH: f64 = 0.08;

/// The contact of two cylinders at some distance.
pub(super) struct Station {
    pub(super) rolled: Rolled,
    /// From where to where it adheres, from the leading edge on.
    pub(super) adhesion: Vec<[f64; 2]>,
    /// Traction over `mu p_0`.
    pub(super) traction: Curve,
}

/// Cylinders that have been shifted by a force over `mu N`.
pub(super) fn shifted(force: f64) -> Result<Rolling, InvalidValue> {
    let mut rolling = Rolling::line(LENGTH, STEEL)?;
    if force != 0.0 {
        rolling.shift(force, 0.0)?;
    }
    Ok(rolling)
}

/// Rolls on in steps of one length.
pub(super) fn roll(
    rolling: &mut Rolling,
    motion: &Motion,
    step: f64,
    steps: usize,
) -> Result<Vec<Station>, InvalidValue> {
    let one = |_| {
        let rolled = rolling.advance(step, motion)?;
        let elements = rolling.elements();
        let traction = elements.iter().map(|e| [e.point.position[0], e.point.traction[0]]);
        Ok(Station { rolled, adhesion: adhesion(rolling), traction: traction.collect() })
    };
    (0..steps).map(one).collect()
}

/// From where to where it adheres, from the leading edge on.
pub(super) fn adhesion(rolling: &Rolling) -> Vec<[f64; 2]> {
    let mut areas: Vec<[f64; 2]> = Vec::new();
    let mut adhered = false;
    for element in rolling.elements() {
        let x = element.corners.map(|corner| corner[0]);
        let [low, high] = [x[0].min(x[2]), x[0].max(x[2])];
        let adheres = element.point.region == Region::Adhesion;
        match areas.last_mut() {
            Some(area) if adheres && adhered => area[0] = low,
            _ if adheres => areas.push([low, high]),
            _ => {}
        }
        adhered = adheres;
    }
    areas
}

/// Parts of the area of adhesion that are more than an element or two.
pub(super) fn parts(station: &Station) -> usize {
    station.adhesion.iter().filter(|[low, high]| high - low > MIN_ADHESION_LENGTH).count()
}

/// Where the area of adhesion ends towards the trailing edge.
pub(super) fn border(station: &Station) -> f64 {
    station.adhesion.last().map_or(1.0, |area| area[0])
}

/// Adhesion over distance and place: the leading edge is above.
pub(super) fn panel(stations: &[Station]) -> Panel {
    let last = stations.last().map_or(1.0, |station| station.rolled.distance);
    let x = Label::new("distance rolled ").symbol("q").plain("/").symbol("a");
    let y = Label::default().symbol("x").plain("/").symbol("a");
    let all = vec![vec![[0.0, -1.0], [last, -1.0], [last, 1.0], [0.0, 1.0]]];
    let mut panel = Panel::new(Axis::new([0.0, last], x), Axis::new([-1.0, 1.0], y))
        .height(300.0)
        .area(all, Fill::SLIP);
    let mut before = 0.0;
    for station in stations {
        let now = station.rolled.distance;
        // Areas that only touch would leave a line between them.
        let left = before - 0.5 * (now - before);
        for [low, high] in &station.adhesion {
            let left = left.max(0.0);
            let area = vec![[left, *low], [now, *low], [now, *high], [left, *high]];
            panel = panel.area(vec![area], Fill::ADHESION);
        }
        before = now;
    }
    panel
}

/// The rows of the data: from where to where it adheres.
pub(super) fn collect(data: &mut Data, name: &str, stations: &[Station]) {
    for station in stations {
        let Rolled { distance, creepage, solution, .. } = station.rolled;
        data.points(name, &[distance, creepage.xi(), solution.force.fx], &station.adhesion);
    }
}

/// Their heads.
pub(super) const COLUMNS: [&str; 6] = ["case", "q", "xi", "fx", "adheres from", "adheres to"];
