//! The gap between a wheel's outline and the rail, over the wheel's profile.

use crate::curve::CurvePoint;
use crate::search::threshold;
use crate::track::Rail;
use crate::wheel::{Outline, Posed};

/// Rounding of a gap, and how well gaps at stations are known (m).
const ROUNDING: f64 = 1e-13;
const SLOPPY: f64 = 1e-8;

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
pub(crate) struct Pair<'a> {
    pub(crate) posed: Posed<'a>,
    pub(crate) rail: &'a Rail,
}

impl std::fmt::Debug for Pair<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Pair").finish_non_exhaustive()
    }
}

impl Pair<'_> {
    pub(crate) fn meeting(&self, s: f64) -> Option<Meeting> {
        let outline = self.posed.outline(s)?;
        let (rail_s, rail) = self.rail.at_y(outline.y, 1e-14)?;
        Some(Meeting { outline, rail_s, rail })
    }

    /// Meetings at all stations, to a nanometre across.
    fn meetings(&self) -> Vec<Option<Meeting>> {
        let [low, high] = self.rail.range();
        let near = |outline: &Outline| outline.y >= low && outline.y <= high;
        let stations = self.posed.wheel.stations().iter();
        stations
            .map(|&(s, point)| {
                let outline = self.posed.outline_at(s, point).filter(near)?;
                let (rail_s, rail) = self.rail.at_y(outline.y, 0.1 * SLOPPY)?;
                Some(Meeting { outline, rail_s, rail })
            })
            .collect()
    }

    /// Where the gap is least of all, unless that is where a profile ends.
    pub(crate) fn lowest(&self) -> Option<Meeting> {
        let meetings = self.meetings();
        let bound = meetings.iter().flatten().map(Meeting::gap).fold(f64::INFINITY, f64::min);
        let refined = least(&meetings).map(|[a, b, c]| self.refined(a, b, c));
        refined.min_by(|a, b| a.gap().total_cmp(&b.gap())).filter(|m| m.gap() <= bound + SLOPPY)
    }

    /// The least gap between two neighbours of a station: there its slope changes sign.
    fn refined(&self, before: Meeting, station: Meeting, after: Meeting) -> Meeting {
        // The station itself was met to a nanometre only.
        let station = self.meeting(station.outline.s).unwrap_or(station);
        // Along the wheel's profile `y` falls.
        let falls = |s: f64| self.meeting(s).is_some_and(|meeting| meeting.slope() > 0.0);
        let [s, _] = threshold([before.outline.s, after.outline.s], falls);
        let found = self.meeting(s).unwrap_or(station);
        // Where the outline folds the slope misleads.
        if found.gap() <= station.gap() + ROUNDING { found } else { station }
    }

    /// Stretches on which the bodies overlap, from the field side.
    pub(crate) fn overlaps(&self) -> Vec<Overlap> {
        let meetings = self.meetings();
        let mut overlaps: Vec<Overlap> = Vec::new();
        for [before, lowest, after] in least(&meetings) {
            let lowest = self.refined(before, lowest, after);
            let known = overlaps.last().is_some_and(|last| lowest.outline.s <= last.to);
            if lowest.gap() < 0.0 && !known {
                overlaps.push(self.around(&meetings, lowest));
            }
        }
        overlaps.extend(cut_off(&meetings, &overlaps));
        overlaps
    }

    /// The overlap that holds a place.
    fn around(&self, meetings: &[Option<Meeting>], inside: Meeting) -> Overlap {
        let s = inside.outline.s;
        let here = self.posed.wheel.stations().partition_point(|station| station.0 <= s);
        let (before, after) = meetings.split_at(here.min(meetings.len()));
        let (from, first) = self.edge(before.iter().rev(), inside);
        let (to, last) = self.edge(after.iter(), inside);
        Overlap { from, to, end: first.or(last) }
    }

    /// Walks outwards until the gap opens; the `y` of the last place where it never does.
    fn edge<'m>(
        &self,
        walk: impl Iterator<Item = &'m Option<Meeting>>,
        inside: Meeting,
    ) -> (f64, Option<f64>) {
        let mut held = inside;
        for next in walk {
            match next {
                Some(next) if next.gap() < 0.0 => held = *next,
                Some(next) => return (self.opening(held.outline.s, next.outline.s), None),
                None => break,
            }
        }
        (held.outline.s, Some(held.outline.y))
    }

    /// Where the gap opens between a place inside and one outside.
    fn opening(&self, inside: f64, outside: f64) -> f64 {
        let closed = |s: f64| self.meeting(s).is_some_and(|meeting| meeting.gap() < 0.0);
        threshold([inside, outside], closed)[0]
    }
}

/// An overlap that deepens up to the end of a profile and so has no lowest place.
fn cut_off(meetings: &[Option<Meeting>], overlaps: &[Overlap]) -> Option<Overlap> {
    let known = |s: f64| overlaps.iter().any(|overlap| overlap.from <= s && s <= overlap.to);
    let outside = |m: &&Meeting| m.gap() < -SLOPPY && !known(m.outline.s);
    let Meeting { outline, .. } = meetings.iter().flatten().find(outside)?;
    Some(Overlap { from: outline.s, to: outline.s, end: Some(outline.y) })
}

/// Stations lower than their neighbours, with these.
fn least(meetings: &[Option<Meeting>]) -> impl Iterator<Item = [Meeting; 3]> {
    meetings.windows(3).filter_map(|three| {
        let [Some(a), Some(b), Some(c)] = *three else { return None };
        (b.gap() <= a.gap() && b.gap() < c.gap()).then_some([a, b, c])
    })
}
