//! Recognition of a profile by its shape: a wheel's flange, a rail's head, and which way up they are.
//!
//! Only plain shapes count. A disc, a groove, a crossing or part of a profile show nothing, and
//! what the file says of them is believed.

use super::rows::Point;
use crate::Role;

/// Heights of a flange over its tread, and of a head over the ends of its sides at least (m).
const FLANGE: std::ops::RangeInclusive<f64> = 0.012..=0.045;
const HEAD: f64 = 0.008;
/// How wide a flange is at half of its height, how far from the profile's end it stands, and how
/// wide the tread beside it is at least (m).
const FLANGE_WIDTH: std::ops::RangeInclusive<f64> = 0.008..=0.055;
const FLANGE_END: f64 = 0.010;
const TREAD: f64 = 0.035;
/// Over its height the tread departs by less than this part of the flange's.
const TREAD_DEPTH: f64 = 0.35;
/// A flange's tip stands at least so far from the profile's end (m).
const TIP: f64 = 0.003;
/// Widths of a head, of its sides from half of their depth on, and of the middle part that is level to the last (m).
const HEAD_WIDTH: std::ops::RangeInclusive<f64> = 0.045..=0.095;
const SIDE_WIDTH: f64 = 0.012;
const CROWN: f64 = 0.006;
/// What goes down does so this many times as far as anything goes up.
const CLEARLY: f64 = 1.5;

/// Recognized shape of a profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// A tread with a flange at the lower or the higher `y`; `z` may point up.
    Wheel { low: bool, up: bool },
    /// A head with its crown between two steep sides.
    Rail { up: bool },
}

impl Shape {
    pub(super) fn role(self) -> Role {
        match self {
            Self::Wheel { .. } => Role::Wheel,
            Self::Rail { .. } => Role::Rail,
        }
    }

    /// Whether `z` points up.
    pub(super) fn up(self) -> bool {
        match self {
            Self::Wheel { up, .. } | Self::Rail { up } => up,
        }
    }

    /// The shape of points (m) in any sense and order; `None` where it shows nothing.
    pub(super) fn of(points: &[Point]) -> Option<Self> {
        // A wide underside hides the level of the crown: without it the head shows, from the crown's side.
        let head = |up: bool| {
            let rest = without_underside(points, up);
            let found = (rest.len() < points.len()).then(|| Self::plain(rest)).flatten();
            found.filter(|shape| *shape == Self::Rail { up })
        };
        Self::plain(points).or_else(|| [true, false].into_iter().find_map(head))
    }

    fn plain(points: &[Point]) -> Option<Self> {
        let up = up(points)?;
        let sense = if up { -1.0 } else { 1.0 };
        let level = level(points, 0.5);
        let stretches: Vec<Stretch> = points
            .windows(2)
            .map(|pair| Stretch {
                y: [0, 1].map(|i| pair[i].at[0]),
                depth: sense * (pair[0].at[1].midpoint(pair[1].at[1]) - level),
            })
            .collect();
        let depth = sense * (self::level(points, if up { 0.03 } else { 0.97 }) - level);
        let range = extent(points, 0);
        flange(&stretches, depth, range)
            .map(|low| Self::Wheel { low, up })
            .or_else(|| is_head(&stretches, depth, range).then_some(Self::Rail { up }))
    }
}

/// A stretch between two points: its ends and how far it lies below the level of the running surface (m).
struct Stretch {
    y: [f64; 2],
    depth: f64,
}

impl Stretch {
    fn middle(&self) -> f64 {
        self.y[0].midpoint(self.y[1])
    }
}

/// Whether the flange is at the end of lower `y`; `None` for a profile without a flange.
fn flange(stretches: &[Stretch], depth: f64, [inner, outer]: [f64; 2]) -> Option<bool> {
    let deep = stretches.iter().filter(|stretch| stretch.depth > 0.5 * depth);
    let [from, to] = deep.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], stretch| {
        [low.min(stretch.y[0]).min(stretch.y[1]), high.max(stretch.y[0]).max(stretch.y[1])]
    });
    let low = from - inner < outer - to;
    let (end, tread) = if low { (from - inner, outer - to) } else { (outer - to, from - inner) };
    let far = |stretch: &&Stretch| {
        let from_end = if low { outer - stretch.middle() } else { stretch.middle() - inner };
        from_end < 0.7 * tread
    };
    let rest = stretches.iter().filter(far).map(|stretch| stretch.depth).fold(0.0, f64::max);
    // The deepest place is a tip, from which a side of a head or of a crossing does not come back.
    let tip = stretches.iter().max_by(|a, b| a.depth.total_cmp(&b.depth))?.middle();
    let tip = if low { tip - inner } else { outer - tip };
    let fits = tip > TIP
        && FLANGE.contains(&depth)
        && FLANGE_WIDTH.contains(&(to - from))
        && end < FLANGE_END
        && tread > TREAD
        && rest < TREAD_DEPTH * depth;
    fits.then_some(low)
}

fn is_head(stretches: &[Stretch], depth: f64, [inner, outer]: [f64; 2]) -> bool {
    let width = outer - inner;
    let middle = inner.midpoint(outer);
    // The underside of a head lies below its crown and inside of its sides.
    let is_under = |stretch: &Stretch| {
        let inside = (stretch.middle() - middle).abs() < 0.5 * width - SIDE_WIDTH;
        let covers = |above: &Stretch| {
            let [a, b] = above.y;
            above.depth < stretch.depth - 0.3 * depth
                && (a.min(b)..=a.max(b)).contains(&stretch.middle())
        };
        inside && stretches.iter().any(covers)
    };
    let deep = |stretch: &&Stretch| stretch.depth > 0.5 * depth && !is_under(stretch);
    let mut sides = [0.0_f64; 2];
    for stretch in stretches.iter().filter(deep) {
        let [a, b] = stretch.y;
        let is_high = stretch.middle() > middle;
        let reach = if is_high { outer - a.min(b) } else { a.max(b) - inner };
        sides[usize::from(is_high)] = sides[usize::from(is_high)].max(reach);
    }
    let central = |s: &&Stretch| (s.middle() - middle).abs() < 0.2 * width && !is_under(s);
    let crown = stretches.iter().filter(central);
    let uneven = crown.map(|stretch| stretch.depth.abs()).fold(0.0, f64::max);
    depth > HEAD
        && HEAD_WIDTH.contains(&width)
        && uneven < CROWN
        && sides.iter().all(|side| *side > 0.0 && *side < SIDE_WIDTH)
}

/// Without what comes back at both ends under the rest, where `z` points up or not.
fn without_underside(points: &[Point], up: bool) -> &[Point] {
    let outside = |one: f64, other: f64| if up { one > other } else { one < other };
    let is_under = |end: &[Point]| {
        let [y, z] = [0, 1].map(|axis| end[0].at[axis].midpoint(end[1].at[axis]));
        points.windows(2).any(|pair| {
            let [a, b] = [pair[0].at, pair[1].at];
            (a[0].min(b[0])..=a[0].max(b[0])).contains(&y)
                && outside(a[1].min(b[1]), z)
                && outside(a[1].max(b[1]), z)
        })
    };
    let (mut from, mut to) = (0, points.len());
    while to - from > 2 && is_under(&points[from..from + 2]) {
        from += 1;
    }
    while to - from > 2 && is_under(&points[to - 2..to]) {
        to -= 1;
    }
    &points[from..to]
}

/// Whether `z` points up. The running surface is wide and level; what departs from it far and has
/// some width is the corners of a rail or the flange of a wheel, and both go down.
pub(super) fn up(points: &[Point]) -> Option<bool> {
    let [low, level, high] = [0.03, 0.5, 0.97].map(|part| level(points, part));
    let (above, below) = (level - low, high - level);
    if below > CLEARLY * above {
        return Some(false);
    }
    (above > CLEARLY * below).then_some(true)
}

/// The `z` below which a part of the profile lies, each stretch counted by its width.
pub(super) fn level(points: &[Point], part: f64) -> f64 {
    let mut stretches: Vec<(f64, f64)> = points
        .windows(2)
        .map(|pair| (pair[0].at[1].midpoint(pair[1].at[1]), (pair[1].at[0] - pair[0].at[0]).abs()))
        .collect();
    stretches.sort_by(|a, b| a.0.total_cmp(&b.0));
    let wanted = part * stretches.iter().map(|stretch| stretch.1).sum::<f64>();
    let mut passed = 0.0;
    let found = stretches.iter().find(|stretch| {
        passed += stretch.1;
        passed >= wanted
    });
    found.map_or(0.0, |stretch| stretch.0)
}

/// Least and greatest coordinate.
pub(super) fn extent(points: &[Point], axis: usize) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    points
        .iter()
        .fold(start, |[low, high], point| [low.min(point.at[axis]), high.max(point.at[axis])])
}
