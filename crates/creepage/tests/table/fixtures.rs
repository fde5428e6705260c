//! Theories and small tables of theirs.

use std::sync::LazyLock;

use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::approximate::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::table::{Axis, Intervals, Provenance, Spec, Table, build};
use creepage::theory::Stateless;
use creepage::{
    Contact, Creepage, FieldPoint, Force, InvalidValue, Jacobian, Solution, Solved, Statistics,
    Status, Theory,
};

pub(crate) type Prepared = Result<Box<dyn Theory>, InvalidValue>;

/// A force that saturates as `tanh` does, with a pole of spin that weakens it: analytic, so that
/// the order of convergence shows, and with the symmetries of the contact.
struct Smooth(Contact);

impl Theory for Smooth {
    fn contact(&self) -> &Contact {
        &self.0
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        let [xi, eta, chi] = creepage.components();
        let per_size = (1.0 + xi * xi + eta * eta + 0.5 * chi * chi).sqrt().recip();
        let force = Force {
            fx: xi * per_size,
            fy: (eta + 0.4 * chi) * per_size * (1.0 + xi * xi * per_size * per_size) * 0.5,
            mz: (chi - 0.4 * eta) * per_size,
        };
        let statistics = Statistics::default();
        Solution { force, error: None, status: Status::Solved, statistics }
    }

    fn jacobian(&self, _: Creepage) -> Option<Jacobian> {
        None
    }

    fn field(&self, _: Creepage, _: &[[f64; 2]]) -> Vec<FieldPoint> {
        Vec::new()
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}

pub(crate) fn smooth(contact: &Contact) -> Prepared {
    Ok(Box::new(Smooth(contact.clone())))
}

pub(crate) fn fastsim(contact: &Contact) -> Prepared {
    let settings = Settings { grid: [30; 2], ..Settings::default() };
    Ok(Box::new(Fastsim::new(contact, settings)?))
}

pub(crate) fn cubic(contact: &Contact) -> Prepared {
    Ok(Box::new(ShenHedrickElkins::new(contact)?))
}

pub(crate) fn spec(intervals: [usize; 3], places: usize) -> Spec {
    let [theta, phi, t] = intervals;
    let provenance = Provenance {
        theory: "fastsim".into(),
        options: "grid = [30, 30]".into(),
        program: "test".into(),
    };
    Spec {
        a_over_b: Axis::fixed(1.0),
        poisson: Axis::fixed(0.28),
        intervals: Intervals { theta, phi, t },
        places,
        provenance,
    }
}

pub(crate) fn quiet() {}

pub(crate) static FASTSIM: LazyLock<Table> =
    LazyLock::new(|| build(&spec([8, 12, 20], 500), fastsim, &quiet).unwrap());

/// A range of both: some hundredths of a second.
pub(crate) static RANGES: LazyLock<Table> = LazyLock::new(|| {
    let ranges = Spec {
        a_over_b: Axis { low: 0.5, high: 2.0, nodes: 5 },
        poisson: Axis { low: 0.0, high: 0.5, nodes: 3 },
        ..spec([6, 8, 12], 240)
    };
    build(&ranges, cubic, &quiet).unwrap()
});
