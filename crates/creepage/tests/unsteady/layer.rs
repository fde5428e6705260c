//! A layer between bodies that do not roll steadily: limits, and closed forms where the layer is so soft that
//! the bodies do not matter.

use creepage::approximate::carter::LineContact;
use creepage::coulomb::{Exact, Resolution};
use creepage::unsteady::{Motion, Rolling};
use creepage::{Contact, Creepage, Ellipse, Hertz, Layer, Plasticity, Scaling, Solid, SolidPair};
use creepage::{SiCreepage, Status, Theory};

fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

fn bare() -> Contact {
    let ellipse = Ellipse::new(6e-3, 4e-3).unwrap();
    Hertz::from_ellipse(steel(), ellipse, 60e3).unwrap().with_friction(0.3).unwrap()
}

/// A layer as in steady rolling's tests: 20e-6 m of 1e8 Pa, which yields at a part of the largest traction.
fn yielding(share: f64, slope: f64) -> Layer {
    let layer = Layer::elastic(20e-6, 100e6).unwrap();
    let yield_stress = share * bare().scaling().traction;
    layer.with_plasticity(Plasticity { yield_stress, slope }).unwrap()
}

fn rolling(contact: &Contact) -> Rolling {
    Rolling::new(contact, Resolution::FAST).unwrap()
}

fn moving([xi, eta, chi]: [f64; 3]) -> Motion {
    Motion::from(Creepage::new(xi, eta, chi).unwrap())
}

fn force(rolling: &mut Rolling, distance: f64, creepage: [f64; 3]) -> [f64; 3] {
    let solution = rolling.step(distance, &moving(creepage)).unwrap().solution;
    assert_eq!(solution.status, Status::Solved);
    solution.force.components()
}

fn apart(one: [f64; 3], two: [f64; 3]) -> f64 {
    (0..3).map(|k| (one[k] - two[k]).abs()).fold(0.0, f64::max)
}

/// No thickness: the same bits. A yield stress that is never reached: as the elastic layer, to where the solver
/// stops.
#[test]
fn what_vanishes_leaves_the_numbers_of_before() {
    let gone = bare().with_layer(Layer::elastic(0.0, 1e9).unwrap());
    let elastic = bare().with_layer(Layer::elastic(20e-6, 100e6).unwrap());
    let strong = bare().with_layer(yielding(1.01, 0.0));
    for creepage in [[0.6, 0.0, 0.0], [0.4, -0.7, 0.5]] {
        let [none, gone, elastic, strong] = [&bare(), &gone, &elastic, &strong].map(|contact| {
            let mut rolling = rolling(contact);
            rolling.shift(0.3, 0.1).unwrap();
            force(&mut rolling, 0.4, creepage)
        });
        assert_eq!(none.map(f64::to_bits), gone.map(f64::to_bits));
        assert!(apart(elastic, strong) < 1e-9, "{elastic:?} {strong:?}");
        assert!(apart(elastic, none) > 0.01);
    }
}

/// After three contact lengths the start is forgotten: steady rolling with the same layer, within both error
/// bars, whether it hardens, softens or does neither.
#[test]
fn it_ends_at_steady_rolling() {
    for slope in [0.0, 2e12, -1e12] {
        let contact = bare().with_layer(yielding(0.4, slope));
        for creepage in [[1.0, 0.0, 0.0], [2.0, -1.0, 0.5]] {
            let [xi, eta, chi] = creepage;
            let right = Exact::new(&contact, Resolution::FAST).unwrap();
            let right = right.solve(Creepage::new(xi, eta, chi).unwrap());
            let mut rolling = rolling(&contact);
            let end = rolling.step(8.0, &moving(creepage)).unwrap().solution;
            assert_eq!(end.status, Status::Solved);
            let bars = [end, right].map(|solution| solution.error.unwrap().components());
            let forces = [end, right].map(|solution| solution.force.components());
            for k in 0..3 {
                let apart = (forces[0][k] - forces[1][k]).abs();
                assert!(apart < bars[0][k] + bars[1][k], "{slope:e}: {forces:?} {bars:?}");
            }
            // And steady rolling goes on as it is.
            let mut steady = self::rolling(&contact);
            let start = steady.start_steady(&moving(creepage)).unwrap().solution.force;
            let on = force(&mut steady, 0.5, creepage);
            // The trailing edge of a shift's narrow strips.
            assert!(self::apart(start.components(), on) < 2e-3, "{slope:e}: {start:?} {on:?}");
        }
    }
}

/// A layer ten thousand times softer than the bodies, on a line: each place follows its own law. The bodies give
/// way by the logarithm of the length besides, a five-hundredth of the layer at most.
const SOFT: f64 = 1e-4;

fn line(layer: Layer, scaling: Scaling) -> Rolling {
    Rolling::line_with_surface(1000.0, 0.28, (None, Some(layer)), scaling).unwrap()
}

/// Half-width 1 mm, largest traction 3e8 Pa, and slip such that bodies and layer are alike at `L = 1`.
fn units() -> Scaling {
    let (length, traction) = (1e-3, 3e8);
    // (1.2): slip mu a/rho, with the largest traction (G/(1 - sigma)) times it.
    let slip = traction * 0.72 / 82e9;
    Scaling { length, slip, traction, force: 0.5 * std::f64::consts::PI * length * traction }
}

/// Traction over the largest bound of a particle that has been displaced by `way`, in the units above: elastic
/// up to the yield stress, then harder by the slope, and friction at most.
fn own_law(way: f64, [flexibility, yields, slope]: [f64; 3], bound: f64) -> f64 {
    let elastic = way / flexibility;
    let plastic = (way - flexibility * yields).max(0.0) / (1.0 + slope * flexibility);
    elastic.min(yields + slope * plastic).min(bound)
}

/// A force that grows as the contact rolls off, at constant creepage: the particle at `x` has been displaced by
/// the creepage times the distance rolled, or that from the leading edge. Friction is met late.
#[test]
fn particles_on_a_soft_layer_follow_their_own_law() {
    let scaling = units();
    let unit = scaling.slip * scaling.length / scaling.traction;
    let flexibility = 1.0 / SOFT;
    for (yields, slope) in [(0.2, 0.0), (0.2, 0.5), (0.3, -0.3)] {
        // All in units: L = h/G, slope times L against 1.
        let law = [flexibility, yields, slope / flexibility];
        let layer = Layer::elastic(1e-3, 1e-3 / (flexibility * unit)).unwrap();
        let slope = law[2] / unit;
        let plasticity = Plasticity { yield_stress: yields * scaling.traction, slope };
        let mut rolling = line(layer.with_plasticity(plasticity).unwrap(), scaling);
        let creepage = 0.5 * flexibility;
        let mut before = 0.0;
        for distance in [0.25, 0.5, 1.0, 2.0, 3.0] {
            let [found, _, _] = force(&mut rolling, distance - before, [creepage, 0.0, 0.0]);
            before = distance;
            // Trapezia: 20000 of them are exact here to 1e-6.
            let count = 20_000;
            let sum: f64 = (0..count)
                .map(|k| {
                    let x = 1.0 - 2.0 * (f64::from(k) + 0.5) / f64::from(count);
                    let way = creepage * distance.min(1.0 - x);
                    own_law(way, law, (1.0 - x * x).sqrt()) * 2.0 / f64::from(count)
                })
                .sum();
            let right = sum / (0.5 * std::f64::consts::PI);
            // The bodies, and elements at the edges.
            assert!(
                (found / right - 1.0).abs() < 0.012,
                "{yields} {slope} {distance}: {found} {right}"
            );
        }
    }
}

/// Shifted at rest, every place of a soft layer has the shift, less that of the bodies under the same force, which is
/// nearly alike everywhere: the force is that of one place.
#[test]
fn a_shift_of_a_soft_layer_is_its_own_law() {
    let scaling = units();
    let unit = scaling.slip * scaling.length / scaling.traction;
    let (flexibility, yields, hardening) = (0.01 / SOFT, 0.2, 0.5);
    let bodies = |force| Rolling::line(1000.0, 0.28).unwrap().shift(force, 0.0).unwrap();
    let law = [flexibility, yields, hardening / flexibility];
    let layer = Layer::elastic(1e-3, 1e-3 / (flexibility * unit)).unwrap();
    let plasticity = Plasticity { yield_stress: yields * scaling.traction, slope: law[2] / unit };
    let mut rolling = line(layer.with_plasticity(plasticity).unwrap(), scaling);
    let mut before = 0.0;
    for way in [0.1, 0.3, 0.5].map(|part| part * flexibility) {
        let count = 20_000;
        let sum: f64 = (0..count)
            .map(|k| {
                let x = 1.0 - 2.0 * (f64::from(k) + 0.5) / f64::from(count);
                own_law(way, law, (1.0 - x * x).sqrt()) * 2.0 / f64::from(count)
            })
            .sum();
        let wanted = sum / (0.5 * std::f64::consts::PI);
        let shift = rolling.shift(wanted, 0.0).unwrap();
        assert_eq!(shift.solution.status, Status::Solved);
        // Counted from where the bodies were before. The bodies give way by a fifth of the layer, the same to a
        // tenth of it under another traction of the same force.
        let all = way + bodies(wanted).creepage.xi().abs();
        let (found, right) = (shift.creepage.xi().abs(), all - before);
        before = all;
        assert!((found / right - 1.0).abs() < 0.02, "{way}: {found} {right}");
    }
}

/// Cattaneo's shift by .6 of `mu N`, then rolling at a given creepage in steps of .08 mm, with a layer that yields
/// without thickness: the example `catt2d_plast` of CONTACT 25.2 (Apache-2.0). Squares of .04 and .02 mm over the
/// width of 2 mm, solved apart from this program, extrapolated to none: forces over `mu N` after so many steps.
#[test]
fn a_shift_and_rolling_after_it_as_squares_have_them() {
    let (radius, load, friction) = (0.5, 178_900.0, 0.5);
    let line = LineContact::new(steel(), [radius, f64::INFINITY], load).unwrap();
    let length = line.half_width();
    let scaling = Scaling {
        length,
        slip: friction * length / line.rho(),
        force: friction * load,
        traction: friction * line.peak_pressure(),
    };
    let plasticity = Plasticity { yield_stress: 35e6, slope: 123e12 };
    let layer = Layer::elastic(0.0, 82e9).unwrap().with_plasticity(plasticity).unwrap();
    let surface = (None, Some(layer));
    let mut rolling = Rolling::line_with_surface(0.2 / length, 0.28, surface, scaling).unwrap();
    rolling.shift(-0.6, 0.0).unwrap();
    let longitudinal = SiCreepage { longitudinal: -4e-4, ..SiCreepage::default() };
    let motion = Motion::from(scaling.creepage(longitudinal).unwrap());
    let forces: Vec<f64> = (0..49)
        .map(|_| -rolling.step(0.08e-3 / length, &motion).unwrap().solution.force.fx)
        .collect();
    let squares = [
        (1, 0.6050),
        (4, 0.6183),
        (7, 0.6273),
        (10, 0.6312),
        (15, 0.6307),
        (20, 0.6291),
        (30, 0.6288),
        (40, 0.6282),
        (49, 0.6279),
    ];
    for (steps, right) in squares {
        let found = forces[steps - 1];
        // Four digits of both squares, and as much for the extrapolation and for our elements.
        assert!((found - right).abs() < 5e-4, "{steps}: {found} {right}");
    }
    // That program's own squares of .08 mm: alike as rolling begins; after two contact lengths 1 % of `mu N` more,
    // for its squares make Carter's force that much too large.
    let stored = [(1, 0.6051, 4e-4), (4, 0.6189, 1e-3), (14, 0.6347, 4e-3), (49, 0.6379, 1.1e-2)];
    for (steps, right, apart) in stored {
        assert!((forces[steps - 1] - right).abs() < apart, "{steps}: {}", forces[steps - 1]);
    }
}
