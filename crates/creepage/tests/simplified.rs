//! Simplified theories on contact areas of any shape: on an ellipse they are the ellipse's own.
// Tests may fail by unwrapping and by panicking.
#![allow(clippy::panic, clippy::unwrap_used)]

mod common;

use common::creepage;
use creepage::approximate::fastrip::{Fastrip, Variant};
use creepage::approximate::fastsim::{Fastsim, Flexibility, Settings, TractionBound};
use creepage::approximate::linear::Linear;
use creepage::approximate::non_hertzian::{NonHertzianSimplified, Simplified};
use creepage::approximate::saturated::Saturated;
use creepage::coulomb::{Constraints, NonHertzian, Resolution};
use creepage::gap::{Gap, Rectangle};
use creepage::normal::{self, NormalContact};
use creepage::theory::{Region, Solved};
use creepage::{Contact, Creepage, Force, Hertz, Radii, Solid, SolidPair, Theory};

const FRICTION: f64 = 0.3;

fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

/// Hertz's case and the same by its gap, off the origin by a part of its size.
fn both(lateral: f64, off: [f64; 2]) -> (Contact, NormalContact) {
    let flat = f64::INFINITY;
    let [upper, lower] = [Radii { rolling: 0.4, lateral: flat }, Radii { rolling: flat, lateral }];
    let hertz = Hertz::new(steel(), upper, lower, 0.0, 50e3).unwrap();
    let domain = Rectangle { x: [-0.03, 0.03], y: [-0.03, 0.03] };
    let gap = Gap::function(domain, move |x, y| {
        (x - off[0]).powi(2) / 0.8 + (y - off[1]).powi(2) / (2.0 * lateral)
    });
    let contact =
        NormalContact::under_load(&gap.unwrap(), steel(), 50e3, normal::Resolution::FINE).unwrap();
    (hertz.with_friction(FRICTION).unwrap(), contact)
}

fn kinds(contact: &Contact) -> [(Simplified, Box<dyn Theory>); 4] {
    let settings = Settings {
        flexibility: Flexibility::Three,
        bound: TractionBound::Elliptic,
        grid: [100, 100],
        ..Settings::default()
    };
    [
        (Simplified::Fastsim, Box::new(Fastsim::new(contact, settings).unwrap())),
        (
            Simplified::Fastrip,
            Box::new(Fastrip::new(contact, Variant::Consistent, [100, 100]).unwrap()),
        ),
        (Simplified::Linear, Box::new(Linear::new(contact).unwrap())),
        (Simplified::Saturated, Box::new(Saturated::new(contact).unwrap())),
    ]
}

/// One creepage at a time, where one flexibility and three are the same; the gap lies off the
/// origin, which spin and moment must not notice once they are taken to its centre.
#[test]
fn an_ellipse_has_the_ellipses_forces() {
    let off = [2e-3, -3e-3];
    for lateral in [0.1, 0.4, 1.5] {
        let (one, contact) = both(lateral, off);
        let wider = wider(&one, &contact);
        assert!(wider < 6e-3, "{lateral}: {wider}");
        for (kind, theory) in kinds(&one) {
            let simplified =
                NonHertzianSimplified::new(&contact, FRICTION, kind, [100, 100]).unwrap();
            let other = simplified.scaling();
            for [xi, eta, chi] in [[0.5, 0.0, 0.0], [0.0, -0.7, 0.0], [0.0, 0.0, 0.6]] {
                let mut si = one.scaling().si_creepage(creepage(xi, eta, chi));
                si.longitudinal += si.spin * off[1];
                si.lateral -= si.spin * off[0];
                let solved = simplified.solve(other.creepage(si).unwrap());
                let centre = off.map(|at| at / other.length);
                let Force { fx, fy, mz } = solved.force_about(centre);
                let found = [fx, fy, mz * other.length / one.scaling().length];
                let expected = theory.solve(creepage(xi, eta, chi)).force.components();
                for k in 0..3 {
                    // Rows of equal width against a pressure known to 3e-4; the linear theory's
                    // coefficients to 1e-4, and in proportion to the width.
                    let apart = (found[k] - expected[k]).abs();
                    let most = if kind == Simplified::Fastrip { 6e-3 } else { 3e-3 };
                    assert!(
                        apart < most + wider * expected[k].abs(),
                        "{kind:?} {lateral} {k}: {found:?} {expected:?}"
                    );
                }
            }
        }
    }
}

/// By how much strips put the tips of the area too far out, in parts of its width.
fn wider(hertz: &Contact, contact: &NormalContact) -> f64 {
    let [low, high] = contact.patches()[0].extent().y;
    ((high - low) / (2.0 * hertz.scaling().length * hertz.ellipse().b()) - 1.0).abs()
}

fn bumps() -> NormalContact {
    let domain = Rectangle { x: [-0.01, 0.01], y: [-0.012, 0.012] };
    let gap = Gap::function(domain, |x, y| {
        let bump = |y0: f64, h: f64| (x * x + (y - y0).powi(2)) / 0.8 + h;
        bump(-4e-3, 0.0).min(bump(4e-3, 5e-6))
    });
    let resolution = normal::Resolution::STANDARD;
    NormalContact::at_approach(&gap.unwrap(), steel(), 2e-5, resolution).unwrap()
}

const CASES: [[f64; 3]; 3] = [[0.5, 0.3, 0.4], [-0.2, 0.5, -1.0], [1.5, -0.4, 0.8]];

/// Central differences of step 1e-6, of forces that have kinks where a cell begins to slide.
#[test]
fn derivatives_are_those_of_the_force() {
    let contact = bumps();
    for kind in
        [Simplified::Fastsim, Simplified::Fastrip, Simplified::Linear, Simplified::Saturated]
    {
        let theory = NonHertzianSimplified::new(&contact, FRICTION, kind, [20, 20]).unwrap();
        let force = |at: [f64; 3]| {
            let curved = theory.solve_curved(creepage(at[0], at[1], at[2]), |y| [0.1 * y, 0.02]);
            curved.solution().force.components()
        };
        for case in CASES {
            let [xi, eta, chi] = case;
            let mut solved = theory.solve_curved(creepage(xi, eta, chi), |y| [0.1 * y, 0.02]);
            let jacobian = solved.jacobian().unwrap();
            for column in 0..3 {
                let at = |h: f64| {
                    let mut moved = case;
                    moved[column] += h;
                    force(moved)
                };
                let (ahead, behind) = (at(1e-6), at(-1e-6));
                for row in 0..3 {
                    let slope = (ahead[row] - behind[row]) / 2e-6;
                    let found = jacobian[row][column];
                    assert!((slope - found).abs() < 1e-4, "{kind:?} {case:?}: {slope} {found}");
                }
            }
        }
    }
}

/// Against the full theory on two patches: on ellipses they are off by a tenth at worst.
#[test]
fn two_patches_against_the_full_theory() {
    let contact = bumps();
    let exact = NonHertzian::new(&contact, FRICTION, Resolution::STANDARD).unwrap();
    for kind in [Simplified::Fastsim, Simplified::Fastrip] {
        let theory = NonHertzianSimplified::new(&contact, FRICTION, kind, [50, 50]).unwrap();
        for [xi, eta, chi] in CASES {
            let at = creepage(xi, eta, chi);
            let [found, expected] =
                [theory.solve(at).solution().force, exact.solve(at).solution().force];
            let apart = (found.fx - expected.fx).hypot(found.fy - expected.fy);
            assert!(apart < 0.1, "{kind:?} {at:?}: {found:?} {expected:?}");
        }
    }
}

/// Below the bound, at it in slip, the whole load and area in the elements, force as their sum.
#[test]
fn elements_add_up() {
    let contact = bumps();
    for kind in [Simplified::Fastsim, Simplified::Fastrip, Simplified::Saturated] {
        let theory = NonHertzianSimplified::new(&contact, FRICTION, kind, [30, 30]).unwrap();
        let solved = theory.solve(creepage(0.4, 0.2, 0.5));
        let (mut share, mut fx, mut positions) = (0.0, 0.0, Vec::new());
        let elements = solved.elements();
        for element in &elements {
            let size = element.point.traction[0].hypot(element.point.traction[1]);
            assert!(size <= element.bound * (1.0 + 1e-12));
            share += element.share;
            fx += element.share / element.bound * element.point.traction[0];
            positions.push(element.point.position);
        }
        assert!((share - 1.0).abs() < 1e-12);
        assert!((fx - solved.solution().force.fx).abs() < 1e-12);
        for (element, point) in elements.iter().zip(solved.field(&positions)) {
            // The same number, not one near it.
            assert_eq!(point.traction.map(f64::to_bits), element.point.traction.map(f64::to_bits));
        }
        let far = solved.field(&[[10.0, 0.0]]);
        assert_eq!(far[0].region, Region::Outside);
    }
}

#[test]
fn creepage_is_found_to_a_force() {
    let theory = NonHertzianSimplified::new(&bumps(), FRICTION, Simplified::Fastsim, [30, 30]);
    let theory = theory.unwrap();
    let wanted =
        Constraints { fx: Some(0.3), eta: Some(0.1), chi: Some(0.2), ..Constraints::default() };
    let found = theory.find(wanted).unwrap();
    assert!((found.solution().force.fx - 0.3).abs() < 1e-7);
    let none = theory.solve(Creepage::default()).solution().force;
    assert_eq!(none, Force::default());
}

/// The powers of FASTSIM's cells are what the force takes from the motion of the bodies, with the springs that are
/// unloaded behind the last cell: also where no cell slides.
#[test]
fn the_cells_of_fastsim_have_the_power_of_the_motion() {
    let (_, contact) = both(0.3, [1e-3, 2e-3]);
    let theory =
        NonHertzianSimplified::new(&contact, FRICTION, Simplified::Fastsim, [30, 40]).unwrap();
    for (creepage, slides) in [
        (creepage(1e-3, 0.0, 0.0), false),
        (creepage(0.3, -0.2, 0.0), true),
        (creepage(-3.0, 1.0, 0.0), true),
        (creepage(0.2, 0.0, 0.5), true),
    ] {
        let solved = theory.solve(creepage);
        let elements = solved.elements();
        let power: f64 = elements.iter().map(|element| element.power).sum();
        let force = solved.solution().force.components();
        let taken: f64 = force.iter().zip(creepage.components()).map(|(f, v)| f * v).sum();
        // The same sum in another order. With spin, whose spring is another one, rows may have more than that.
        assert!(power > taken * (1.0 - 1e-9), "{power} {taken}");
        if creepage.components()[2].abs() < 1e-300 {
            assert!(power < taken * (1.0 + 1e-9), "{power} {taken}");
        }
        let any = elements.iter().any(|element| element.point.region == Region::Slip);
        assert_eq!(any, slides);
    }
}

/// Under strong spin, whose springs are others, the slip of FASTSIM's cells is still that of the motion: its power is what
/// the moment takes, which by the springs along and across it exceeded by 27 % and 29 % here.
#[test]
fn the_slip_of_fastsim_is_that_of_the_motion_under_spin() {
    for lateral in [0.4, 2.0] {
        let (_, contact) = both(lateral, [0.0; 2]);
        let theory =
            NonHertzianSimplified::new(&contact, FRICTION, Simplified::Fastsim, [60, 60]).unwrap();
        let creepage = creepage(0.0, 0.0, 20.0);
        let solved = theory.solve(creepage);
        let power: f64 = solved.elements().iter().map(|element| element.power).sum();
        let force = solved.solution().force.components();
        let taken: f64 = force.iter().zip(creepage.components()).map(|(f, v)| f * v).sum();
        // Where all slides, but for what the springs give, it is that of bodies as if rigid.
        let (mut slips, mut rigids) = (0.0, 0.0);
        for element in solved.elements() {
            let ([x, y], [sx, sy]) = (element.point.position, element.point.slip);
            slips += element.bound * sx.hypot(sy);
            rigids += element.bound * (20.0 * x).hypot(20.0 * y);
        }
        assert!((slips / rigids - 1.0).abs() < 0.05, "{lateral}: {slips} {rigids}");
        // Slip everywhere but near the pole, and what springs keep there and cells leave out.
        assert!((power / taken - 1.0).abs() < 0.03, "{lateral}: {power} {taken}");
    }
}
