//! Vertical gap between a wheel's outline and the rail, over the wheel's profile; overlaps and the lowest point.

use crate::curve::CurvePoint;
use crate::search::crossing;
use crate::track::Rail;
use crate::wheel::{Outline, Posed};

/// Rounding of a gap, how well gaps at stations are known, and how far they may fall between
/// two stations (m).
const ROUNDING: f64 = 1e-13;
const SEARCH_TOLERANCE: f64 = 1e-8;
const BETWEEN: f64 = 2e-5;

/// A point of the outline and the rail's point below it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Meeting {
    pub(crate) outline: Outline,
    pub(crate) rail_s: f64,
    pub(crate) rail: CurvePoint,
}

impl Meeting {
    /// Vertical gap (m).
    pub(crate) fn gap(&self) -> f64 {
        self.rail.z - self.outline.z
    }

    /// Change of the gap by the lateral coordinate.
    fn slope(&self) -> f64 {
        self.rail.tangent[1] / self.rail.tangent[0] - self.outline.slope
    }
}

/// A stretch of the wheel's profile that overlaps the rail, by arc length.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Overlap {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// `y` at which a profile ends within the overlap.
    pub(crate) end: Option<f64>,
}

/// A wheel in its position over its rail, both seen as right-hand ones.
#[derive(Clone, Copy)]
pub(crate) struct WheelRailPair<'a> {
    pub(crate) posed: Posed<'a>,
    pub(crate) rail: &'a Rail,
    /// Place along the track (m).
    pub(crate) s: f64,
    /// Whether the rail is the guard rail.
    pub(crate) is_guard: bool,
}

impl std::fmt::Debug for WheelRailPair<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Pair").finish_non_exhaustive()
    }
}

/// The gap at a station of the wheel, to nanometres.
#[derive(Debug, Clone, Copy)]
struct Clearance {
    s: f64,
    y: f64,
    gap: f64,
}

impl WheelRailPair<'_> {
    pub(crate) fn meeting(&self, s: f64) -> Option<Meeting> {
        let outline = self.posed.outline(s)?;
        let (rail_s, rail) = self.rail.at_y(outline.y)?;
        Some(Meeting { outline, rail_s, rail })
    }

    /// The wheel's outline as seen along the track (m), of the right-hand image.
    pub(crate) fn seen_outline(&self) -> Vec<[f64; 2]> {
        let stations = self.posed.wheel.stations().iter();
        let place = |&(s, point): &(f64, CurvePoint)| {
            let seen = self.posed.outline_at(s, point).map(|outline| [outline.y, outline.z]);
            seen.unwrap_or_else(|| {
                let [_, y, z] = self.posed.surface(point, 0.0);
                [y, z]
            })
        };
        stations.map(place).collect()
    }

    fn gaps(&self) -> Vec<Option<Clearance>> {
        let [low, high] = self.rail.range();
        let stations = self.posed.wheel.stations().iter();
        stations
            .map(|&(s, point)| {
                let outline = self.posed.outline_at(s, point)?;
                let y = outline.y;
                if self.rail.beyond_wall(y) {
                    return Some(Clearance { s, y, gap: f64::INFINITY });
                }
                let near = y >= low && y <= high;
                let rail = near.then(|| self.rail.height(y))??;
                Some(Clearance { s, y, gap: rail - outline.z })
            })
            .collect()
    }

    /// Where the gap is least of all.
    ///
    /// # Errors
    /// The `y` of a profile's end where it is least there; `None` where the profiles do not meet.
    pub(crate) fn lowest(&self) -> Result<Meeting, Option<f64>> {
        let gaps = self.gaps();
        let bound = gaps.iter().flatten().min_by(|a, b| a.gap.total_cmp(&b.gap)).ok_or(None)?;
        // Cubics between stations smooth a rough rail by more than the tolerance below.
        let exact = self.meeting(bound.s).map_or(bound.gap, |meeting| meeting.gap().max(bound.gap));
        let low = least(&gaps).filter(|[_, place, _]| place.gap < bound.gap + BETWEEN);
        let refined = low.filter_map(|three| self.refined(three));
        let lowest = refined.min_by(|a, b| a.gap().total_cmp(&b.gap()));
        lowest.filter(|meeting| meeting.gap() <= exact + SEARCH_TOLERANCE).ok_or(Some(bound.y))
    }

    /// The least gap between two neighbours of a station: there its slope changes sign.
    fn refined(&self, [before, station, after]: [Clearance; 3]) -> Option<Meeting> {
        let station = self.meeting(station.s)?;
        // Along the wheel's profile `y` falls.
        let field_side = self.rail.range()[1];
        let rise = |s: f64| {
            if let Some(meeting) = self.meeting(s) {
                return -meeting.slope();
            }
            let is_beyond = self.posed.outline(s).is_some_and(|outline| outline.y > field_side);
            if is_beyond { f64::NEG_INFINITY } else { f64::INFINITY }
        };
        let s = crossing([before.s, after.s], ROUNDING, rise);
        // Where the outline folds the slope misleads.
        let better = |found: &Meeting| found.gap() <= station.gap() + ROUNDING;
        Some(self.meeting(s).filter(better).unwrap_or(station))
    }

    /// Stretches on which the bodies overlap, from the field side.
    pub(crate) fn overlaps(&self) -> Vec<Overlap> {
        let gaps = self.gaps();
        let mut overlaps: Vec<Overlap> = Vec::new();
        for three in least(&gaps).filter(|[_, place, _]| place.gap < BETWEEN) {
            let known = overlaps.last().is_some_and(|last| three[1].s <= last.to);
            let lowest = if known { None } else { self.refined(three) };
            if let Some(lowest) = lowest.filter(|lowest| lowest.gap() < 0.0) {
                overlaps.push(self.around(&gaps, lowest));
            }
        }
        overlaps.extend(cut_off(&gaps, &overlaps));
        overlaps
    }

    /// The overlap that holds a place.
    fn around(&self, gaps: &[Option<Clearance>], inside: Meeting) -> Overlap {
        let Meeting { outline, .. } = inside;
        let inside = Clearance { s: outline.s, y: outline.y, gap: inside.gap() };
        let stations = self.posed.wheel.stations();
        let here = stations.partition_point(|station| station.0 <= inside.s);
        let (before, after) = gaps.split_at(here.min(gaps.len()));
        let (from, first) = self.edge(before.iter().rev(), inside);
        let (to, last) = self.edge(after.iter(), inside);
        Overlap { from, to, end: first.or(last) }
    }

    /// Walks outwards until the gap opens; the `y` of the last place where it never does.
    fn edge<'g>(
        &self,
        walk: impl Iterator<Item = &'g Option<Clearance>>,
        inside: Clearance,
    ) -> (f64, Option<f64>) {
        let mut held = inside;
        for next in walk {
            match next {
                Some(next) if next.gap < 0.0 => held = *next,
                Some(next) => return (self.opening(held.s, next.s), None),
                None => break,
            }
        }
        (held.s, Some(held.y))
    }

    /// Where the gap opens between a place inside and one outside.
    fn opening(&self, inside: f64, outside: f64) -> f64 {
        let gap = |s: f64| self.meeting(s).map_or(f64::INFINITY, |meeting| meeting.gap());
        crossing([inside, outside], ROUNDING, gap)
    }
}

/// An overlap that deepens up to the end of a profile and so has no lowest place.
fn cut_off(gaps: &[Option<Clearance>], overlaps: &[Overlap]) -> Option<Overlap> {
    let known = |s: f64| overlaps.iter().any(|overlap| overlap.from <= s && s <= overlap.to);
    let outside = |place: &&Clearance| place.gap < -SEARCH_TOLERANCE && !known(place.s);
    let place = gaps.iter().flatten().find(outside)?;
    Some(Overlap { from: place.s, to: place.s, end: Some(place.y) })
}

/// Stations lower than their neighbours, with these.
fn least(gaps: &[Option<Clearance>]) -> impl Iterator<Item = [Clearance; 3]> {
    gaps.windows(3).filter_map(|three| {
        let [Some(a), Some(b), Some(c)] = *three else { return None };
        (b.gap <= a.gap && b.gap < c.gap).then_some([a, b, c])
    })
}
