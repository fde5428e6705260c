//! Proposition V of the thesis: in an unlubricated, slow angular-contact bearing without cage the balls
//! roll in pure spin when the contacts with both rings are congruent.
//!
//! The contacts are at opposite ends of a diameter. In the frame of each (`x` the rolling direction, `z`
//! outwards), turned into one another about `y`, the ball's turning about the rolling direction gives
//! lateral creepages `v` and `-v`, its turning about the diameter the spins `s + d` and `s - d`, whose
//! sum the rings prescribe. About the ball's middle the lateral forces balance when they are equal, and
//! the spin moments when they are equal; the longitudinal forces must vanish. What both lateral forces
//! are together, the normal forces bear: they turn by a part of the friction angle.

use creepage::coulomb::{Exact, Resolution};
use creepage::{Contact, Ellipse, Theory};
use nalgebra::{DMatrix, DVector};

use crate::support::{at, components};

/// Spin halfway between the two contacts.
const SPIN: f64 = 1.2;

fn contact(ratio: f64) -> Exact {
    let contact = Contact::new(Ellipse::from_ratio(ratio).unwrap(), 0.3).unwrap();
    Exact::new(&contact, Resolution::FAST).unwrap()
}

/// `v`, the longitudinal creepages, `d`.
fn creepages(unknown: &DVector<f64>) -> [[f64; 3]; 2] {
    let [v, first, second, d] = [0, 1, 2, 3].map(|k| unknown[k]);
    [[first, v, SPIN + d], [second, -v, SPIN - d]]
}

/// Lateral forces, longitudinal ones, moments; the contacts carry the same load, `moment` is the
/// second's unit of moment over the first's.
fn equilibrium(contacts: [&Exact; 2], moment: f64, unknown: &DVector<f64>) -> DVector<f64> {
    let force = |k: usize| components(contacts[k].solve(at(creepages(unknown)[k])).force);
    let ([fx, fy, mz], [gx, gy, nz]) = (force(0), force(1));
    DVector::from_vec(vec![fy - gy, fx, gx, mz - moment * nz])
}

fn balanced(contacts: [&Exact; 2], moment: f64) -> DVector<f64> {
    let mut unknown = DVector::from_vec(vec![0.3, -0.2, 0.1, 0.25]);
    for _ in 0..12 {
        let now = equilibrium(contacts, moment, &unknown);
        let step = 1e-5;
        let column = |k: usize| {
            let mut moved = unknown.clone();
            moved[k] += step;
            (equilibrium(contacts, moment, &moved) - &now) / step
        };
        let columns: Vec<_> = (0..4).map(column).collect();
        unknown -= DMatrix::from_columns(&columns).lu().solve(&now).unwrap();
    }
    // Forces are solved to some 1e-8.
    assert!(equilibrium(contacts, moment, &unknown).amax() < 1e-7);
    unknown
}

#[test]
fn balls_roll_in_pure_spin_where_both_contacts_are_alike() {
    let inner = contact(0.2);
    let unknown = balanced([&inner, &inner], 1.0);
    assert!(unknown.amax() < 1e-6, "{unknown}");
    let lateral = inner.solve(at([0.0, 0.0, SPIN])).force.fy;
    assert!(lateral > 0.05, "{lateral}");
}

#[test]
fn but_not_where_one_is_longer() {
    let (inner, outer) = (contact(0.15), contact(0.3));
    let unknown = balanced([&inner, &outer], 1.3);
    assert!(unknown[0].abs() > 0.01, "{unknown}");
}
