//! Wells of a polynomial gap: the places from which it rises all around, where bodies touch first, and the polynomial in
//! powers of the distance from each.

use super::polynomial::Term;

/// A well, and the polynomial about it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Well {
    pub(super) place: [f64; 2],
    pub(super) terms: Vec<Term>,
    /// The gap there (m).
    pub(super) height: f64,
}

/// Slope, and curvatures along x, across and along y.
type Slopes = ([f64; 2], [f64; 3]);

/// Distances from which one goes downhill, at most.
const DISTANCES: usize = 12;

/// The wells, the deepest first; the origin alone where the gap falls without end, or has no slope to follow.
pub(super) fn wells(terms: &[Term], at: impl Fn([f64; 2]) -> f64) -> Vec<Well> {
    let from_origin = descend(terms, &at, [0.0; 2]);
    let mut places: Vec<[f64; 2]> = from_origin.into_iter().collect();
    if !rises_everywhere(terms) {
        let around = (0..8).map(|k| (f64::from(k) * std::f64::consts::FRAC_PI_4).sin_cos());
        let directions: Vec<_> = around.collect();
        for distance in distances(terms) {
            for (y, x) in &directions {
                let Some(found) = descend(terms, &at, [distance * x, distance * y]) else {
                    continue;
                };
                let apart = |other: &[f64; 2]| (found[0] - other[0]).hypot(found[1] - other[1]);
                // Newton's method ends within rounding of a well, whose size is that of the distances.
                if places.iter().all(|other| apart(other) > 1e-4 * distance) {
                    places.push(found);
                }
            }
        }
    }
    if places.is_empty() {
        places.push([0.0; 2]);
    }
    let mut wells: Vec<_> = places.into_iter().map(|place| Well::at(terms, place)).collect();
    // Of equal ones that next to the origin: the sort is stable.
    wells.sort_by(|one, other| one.height.total_cmp(&other.height));
    wells
}

/// Whether all powers are even and rise: the origin is the only well.
fn rises_everywhere(terms: &[Term]) -> bool {
    let rises = |term: &Term| {
        [term.x, term.y].iter().all(|power| power.is_multiple_of(2)) && term.coefficient >= 0.0
    };
    terms.iter().filter(|term| term.x + term.y > 0).all(rises)
}

/// Distances at which two terms are alike in size: about which the gap may turn. One of those within a factor of two.
fn distances(terms: &[Term]) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    for low in terms {
        for high in terms {
            let (degree, higher) = (low.x + low.y, high.x + high.y);
            if degree == 0 || higher <= degree || low.coefficient == 0.0 || high.coefficient == 0.0
            {
                continue;
            }
            let ratio = (low.coefficient / high.coefficient).abs();
            let distance = ratio.powf(f64::from(higher - degree).recip());
            let is_new = found.iter().all(|other| (distance / other).log2().abs() > 1.0);
            if is_new && distance.is_normal() && found.len() < DISTANCES {
                found.push(distance);
            }
        }
    }
    found
}

impl Well {
    fn at(terms: &[Term], place: [f64; 2]) -> Self {
        let constant = |terms: &[Term]| {
            terms.iter().filter(|term| term.x + term.y == 0).map(|term| term.coefficient).sum()
        };
        if is_origin(place) {
            return Self { place, terms: terms.to_vec(), height: constant(terms) };
        }
        let mut about = moved(terms, place);
        let height = constant(&about);
        // A well is level: what is left of the slope is rounding.
        about.retain(|term| term.x + term.y != 1);
        Self { place, terms: about, height }
    }

    /// Distances at which its terms reach `height`: none for a constant.
    pub(super) fn lengths(&self, height: f64) -> impl Iterator<Item = f64> {
        self.terms.iter().filter(|term| term.x + term.y > 0 && term.coefficient != 0.0).map(
            move |term| (height / term.coefficient.abs()).powf(f64::from(term.x + term.y).recip()),
        )
    }

    /// Whether the gap may fall somewhere on the way outwards.
    pub(super) fn turns_down(&self) -> bool {
        !rises_everywhere(&self.terms)
    }
}

fn is_origin(place: [f64; 2]) -> bool {
    place.iter().all(|part| *part == 0.0)
}

/// Newton's method downhill from a place, by a curvature that is made positive, each step doubled or halved until the
/// gap falls no further.
fn descend(terms: &[Term], at: &impl Fn([f64; 2]) -> f64, from: [f64; 2]) -> Option<[f64; 2]> {
    const STEPS: usize = 200;
    const DOUBLINGS: usize = 80;
    /// Beyond this (m) no bodies reach.
    const FARTHEST: f64 = 1e3;
    let mut place = from;
    for _ in 0..STEPS {
        let here = at(place);
        let (slope, curvatures) = slopes(terms, place);
        let Some(direction) = downhill(slope, curvatures) else { return Some(place) };
        let to = |factor: f64| [0, 1].map(|k: usize| place[k] + factor * direction[k]);
        let mut factor = 1.0;
        if at(to(factor)) < here {
            let doubles = |factor: &f64| at(to(2.0 * factor)) < at(to(*factor));
            let mut left = DOUBLINGS;
            while left > 0
                && doubles(&factor)
                && direction[0].hypot(direction[1]) * factor < FARTHEST
            {
                factor *= 2.0;
                left -= 1;
            }
        } else {
            let fell = (0..DOUBLINGS).find(|_| {
                factor *= 0.5;
                at(to(factor)) < here
            });
            if fell.is_none() {
                // No step falls: rounding holds it in a well, or on a saddle.
                let off = off_saddle(curvatures).map(|[x, y]| [place[0] + x, place[1] + y]);
                let Some(off) = off.filter(|off| at(*off) < here) else { return Some(place) };
                place = off;
                continue;
            }
        }
        place = to(factor);
        let far = place[0].hypot(place[1]);
        if far.is_nan() || far >= FARTHEST {
            return None;
        }
    }
    Some(place)
}

/// How far (m) one goes where no curvature gives a length; it doubles while the gap falls.
const OFF: f64 = 1e-6;

/// The step of Newton's method where the gap bends upwards in all directions; else down the slope, or off a saddle.
/// Nothing where it is level and does not fall.
fn downhill([p, q]: [f64; 2], [xx, xy, yy]: [f64; 3]) -> Option<[f64; 2]> {
    if p == 0.0 && q == 0.0 {
        return off_saddle([xx, xy, yy]);
    }
    let [least, most] = principal([xx, xy, yy]);
    let size = least.abs().max(most.abs());
    if size == 0.0 {
        let unit = OFF / p.hypot(q);
        return Some([-p * unit, -q * unit]);
    }
    // A curvature below a millionth of the largest counts as zero: the step follows the slope.
    let shift = if least > 1e-6 * size { 0.0 } else { 1e-3 * size - least };
    let (a, b, c) = (xx + shift, xy, yy + shift);
    let determinant = a * c - b * b;
    Some([(b * q - c * p) / determinant, (b * p - a * q) / determinant])
}

/// A step in the direction in which the gap bends downwards most, if it does.
fn off_saddle([xx, xy, yy]: [f64; 3]) -> Option<[f64; 2]> {
    let [least, _] = principal([xx, xy, yy]);
    if least >= 0.0 {
        return None;
    }
    let [x, y] = match xy {
        0.0 if xx < yy => [1.0, 0.0],
        0.0 => [0.0, 1.0],
        _ => [xy, least - xx],
    };
    let unit = OFF / x.hypot(y);
    Some([x * unit, y * unit])
}

/// The least and the largest curvature of all directions.
fn principal([xx, xy, yy]: [f64; 3]) -> [f64; 2] {
    let (mean, half) = (f64::midpoint(xx, yy), (0.5 * (xx - yy)).hypot(xy));
    [mean - half, mean + half]
}

fn slopes(terms: &[Term], [x, y]: [f64; 2]) -> Slopes {
    let power = |base: f64, exponent: u32, order: u32| -> f64 {
        if exponent < order {
            return 0.0;
        }
        let falling: f64 = (0..order).map(|k| f64::from(exponent - k)).product();
        falling * base.powi((exponent - order).cast_signed())
    };
    let sum = |[i, j]: [u32; 2]| -> f64 {
        let of = |term: &Term| term.coefficient * power(x, term.x, i) * power(y, term.y, j);
        terms.iter().map(of).sum()
    };
    ([sum([1, 0]), sum([0, 1])], [sum([2, 0]), sum([1, 1]), sum([0, 2])])
}

/// The polynomial in powers of the distance from a place, by the binomial theorem.
fn moved(terms: &[Term], place: [f64; 2]) -> Vec<Term> {
    let highest = |power: fn(&Term) -> u32| terms.iter().map(power).max().unwrap_or(0);
    let powers = [highest(|term| term.x), highest(|term| term.y)];
    let part = |from: u32, to: u32, shift: f64| -> f64 {
        if to > from { 0.0 } else { choose(from, to) * shift.powi((from - to).cast_signed()) }
    };
    let all = (0..=powers[0]).flat_map(|x| (0..=powers[1]).map(move |y| (x, y)));
    all.map(|(x, y)| {
        let of =
            |term: &Term| term.coefficient * part(term.x, x, place[0]) * part(term.y, y, place[1]);
        Term { x, y, coefficient: terms.iter().map(of).sum() }
    })
    .filter(|term| term.coefficient != 0.0)
    .collect()
}

fn choose(from: u32, to: u32) -> f64 {
    (0..to).map(|k| f64::from(from - k) / f64::from(to - k)).product()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::polynomial::Polynomial;

    fn wells(terms: &[(u32, u32, f64)]) -> Vec<Well> {
        let terms: Vec<_> =
            terms.iter().map(|&(x, y, coefficient)| Term { x, y, coefficient }).collect();
        Polynomial::new(&terms).unwrap().wells().to_vec()
    }

    fn bottom(terms: &[(u32, u32, f64)]) -> Well {
        wells(terms)[0].clone()
    }

    #[test]
    fn even_gaps_touch_at_the_origin() {
        for terms in [&[(2, 0, 1.0), (0, 2, 1.6)][..], &[(4, 0, 3.0), (0, 4, 1e4)], &[(2, 0, 1.0)]]
        {
            assert!(is_origin(bottom(terms).place));
        }
        // A fit that turns down far away touches near the origin.
        assert!(is_origin(bottom(&[(2, 0, 1.0), (0, 2, 2.0), (0, 4, -1e3)]).place));
    }

    #[test]
    fn a_tilted_paraboloid_is_one_about_its_bottom() {
        let found = bottom(&[(2, 0, 1.0), (0, 2, 1.6), (0, 1, 0.2), (1, 1, 0.5), (0, 0, 1e-3)]);
        // The slope of both is zero: 2 x + y/2 = 0, x/2 + 3.2 y = -0.2.
        let y = -0.2 / (3.2 - 0.125);
        assert!((found.place[1] - y).abs() < 1e-15 && (found.place[0] + 0.25 * y).abs() < 1e-15);
        assert!((found.height - (1e-3 + 0.1 * y)).abs() < 1e-16, "{found:?}");
        let of = |x, y| found.terms.iter().find(|term| (term.x, term.y) == (x, y)).unwrap();
        for ((x, y), curvature) in [((2, 0), 1.0), ((0, 2), 1.6), ((1, 1), 0.5)] {
            assert!((of(x, y).coefficient - curvature).abs() < 1e-15);
        }
        assert!(found.terms.iter().all(|term| term.x + term.y != 1));
    }

    #[test]
    fn all_wells_are_found() {
        // y^2 = 3/200.
        let found = wells(&[(2, 0, 1.0), (0, 2, -3.0), (0, 4, 100.0)]);
        assert_eq!(found.len(), 2);
        for well in &found {
            assert!((well.place[1].abs() - 0.015_f64.sqrt()).abs() < 1e-9, "{well:?}");
            assert!(well.place[0].abs() < 1e-9 && (well.height + 0.0225).abs() < 1e-15);
        }
        assert!(found[0].place[1] * found[1].place[1] < 0.0);
        // Tilted, the lower one first.
        let found = wells(&[(2, 0, 1.0), (0, 2, -3.0), (0, 4, 100.0), (0, 1, 0.01)]);
        assert!(found.len() == 2 && found[0].place[1] < 0.0 && found[1].place[1] > 0.0);
        // Four, one in each quarter.
        let four = [(2, 0, -1.0), (0, 2, -1.0), (4, 0, 50.0), (0, 4, 50.0)];
        assert_eq!(wells(&four).len(), 4);
    }

    #[test]
    fn a_fall_without_end_has_no_bottom() {
        for terms in [&[(2, 0, 1.0), (0, 1, 0.2)][..], &[(0, 2, -1.0)], &[(0, 3, 1.0), (0, 1, 1.0)]]
        {
            assert!(is_origin(bottom(terms).place));
        }
    }
}
