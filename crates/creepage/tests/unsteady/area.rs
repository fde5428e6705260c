//! Contact areas of any shape.

use creepage::coulomb::{NonHertzian, Resolution};
use creepage::gap::{Gap, Term};
use creepage::normal::{self, NormalContact};
use creepage::theory::Solved;
use creepage::unsteady::{Motion, Rolled, Rolling};
use creepage::{Creepage, Hertz, Radii, Scaling, SiCreepage, Solid, SolidPair, Status};

use super::support::creeping;

const FRICTION: f64 = 0.3;
const LOAD: f64 = 40e3;
/// `A` and `B` of `h = A x^2 + B y^2` (1/m).
const OPENING: [f64; 2] = [1.1, 2.3];

fn pair() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

fn pressed(terms: &[(u32, u32, f64)]) -> NormalContact {
    let terms: Vec<_> =
        terms.iter().map(|&(x, y, coefficient)| Term { x, y, coefficient }).collect();
    let gap = Gap::polynomial(&terms).unwrap();
    NormalContact::under_load(&gap, pair(), LOAD, normal::Resolution::STANDARD).unwrap()
}

fn rolling(contact: &NormalContact) -> Rolling {
    Rolling::on_areas(contact, FRICTION, None, Resolution::FAST).unwrap()
}

/// Forces (N, N, N m) and their error bars in the units of a contact.
fn si(rolled: &Rolled, units: Scaling) -> [[f64; 3]; 2] {
    let error = rolled.solution.error.unwrap();
    [rolled.solution.force, error].map(|force| {
        let force = units.si_force(force);
        [force.longitudinal, force.lateral, force.moment]
    })
}

/// An ellipse as a gap, `h = A x^2 + B y^2`, rolls as Hertz's.
#[test]
fn an_ellipse_by_its_gap_rolls_as_hertz() {
    let [a, b] = OPENING;
    let upper = Radii { rolling: 0.5 / a, lateral: f64::INFINITY };
    let lower = Radii { rolling: f64::INFINITY, lateral: 0.5 / b };
    let hertz = Hertz::new(pair(), upper, lower, 0.0, LOAD).unwrap();
    let contact = hertz.with_friction(FRICTION).unwrap();
    let area = pressed(&[(2, 0, a), (0, 2, b)]);
    let mut roads = [Rolling::new(&contact, Resolution::FAST).unwrap(), rolling(&area)];
    let units = [contact.scaling(), area.scaling(FRICTION).unwrap()];
    for (step, creepage, lateral, spin) in
        [(0.5, 1e-3, 0.0, 0.1), (1.0, 1e-3, -5e-4, 0.2), (0.7, -1e-3, 0.0, 0.2)]
    {
        let given = SiCreepage { longitudinal: creepage, lateral, spin };
        let distance = step * units[0].length;
        let [[one, bar], [other, more]] = [0, 1].map(|k| {
            let motion = Motion::from(units[k].creepage(given).unwrap());
            let rolled = roads[k].step(distance / units[k].length, &motion).unwrap();
            assert_eq!(rolled.solution.status, Status::Solved);
            si(&rolled, units[k])
        });
        for k in 0..3 {
            let off = (one[k] - other[k]).abs();
            // Two meshes of one contact: within the error bars of both.
            assert!(off < bar[k] + more[k], "{k}: {one:?} {bar:?} {other:?} {more:?}");
        }
    }
}

/// Two areas at once, and one whose sides are straight: rolled for long, they roll steadily.
#[test]
fn it_ends_at_the_steady_forces() {
    let shapes: [&[(u32, u32, f64)]; 2] =
        [&[(2, 0, 1.087), (0, 4, 5e4)], &[(2, 0, 1.087), (0, 2, -6.0), (0, 4, 1e5), (0, 1, 2e-3)]];
    for (terms, patches) in shapes.into_iter().zip([1, 2]) {
        let area = pressed(terms);
        assert_eq!(area.patches().len(), patches);
        let creepage = Creepage::new(0.6, 0.2, 0.3).unwrap();
        let steady =
            NonHertzian::new(&area, FRICTION, Resolution::FAST).unwrap().solve(creepage).solution();
        let end = rolling(&area).step(12.0, &Motion::from(creepage)).unwrap();
        let (found, bar) =
            (end.solution.force.components(), end.solution.error.unwrap().components());
        let (known, other) = (steady.force.components(), steady.error.unwrap().components());
        for k in 0..3 {
            let off = (found[k] - known[k]).abs();
            assert!(off < bar[k] + other[k], "{k}: {found:?} {bar:?} {known:?} {other:?}");
        }
    }
}

/// The origin may lie anywhere: the same area beside it has the creepage of its own middle.
#[test]
fn the_origin_may_lie_elsewhere() {
    let (a, place, spin) = (1.2, 4e-3, 0.3);
    let middle = pressed(&[(2, 0, a), (0, 2, a)]);
    let beside =
        pressed(&[(2, 0, a), (0, 2, a), (0, 1, -2.0 * a * place), (0, 0, a * place * place)]);
    let units = middle.scaling(FRICTION).unwrap();
    let at = |longitudinal: f64| {
        Motion::from(units.creepage(SiCreepage { longitudinal, lateral: 0.0, spin }).unwrap())
    };
    let one = rolling(&middle).step(1.0, &at(1e-3)).unwrap().solution.force;
    let other = rolling(&beside).step(1.0, &at(1e-3 + spin * place)).unwrap().solution.force;
    // The two are pressed to the normal solver's tolerance.
    assert!((one.fx - other.fx).abs() < 1e-3, "{one:?} {other:?}");
    assert!((one.fy - other.fy).abs() < 1e-3, "{one:?} {other:?}");
}

#[test]
fn its_load_stays() {
    let mut rolling = rolling(&pressed(&[(2, 0, 1.0), (0, 2, 1.0)]));
    let error = rolling.press(2.0).unwrap_err();
    assert!(error.to_string().contains("area of any shape"), "{error}");
    assert!(rolling.step(0.1, &creeping(0.1, 0.0, 0.0)).is_ok());
}
