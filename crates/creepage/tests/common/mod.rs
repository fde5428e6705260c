//! What the tests share.
#![allow(dead_code, clippy::unwrap_used)] // each test uses a part

use creepage::{Contact, Creepage, Ellipse, InvalidValue};

/// Like bodies, by the ratio of the semi-axes and the combined Poisson's ratio.
pub(crate) fn contact(a_over_b: f64, poisson: f64) -> Contact {
    try_contact(a_over_b, poisson).unwrap()
}

pub(crate) fn try_contact(a_over_b: f64, poisson: f64) -> Result<Contact, InvalidValue> {
    Contact::new(Ellipse::from_ratio(a_over_b)?, poisson)
}

pub(crate) fn creepage(xi: f64, eta: f64, chi: f64) -> Creepage {
    Creepage::new(xi, eta, chi).unwrap()
}

pub(crate) fn at([xi, eta, chi]: [f64; 3]) -> Creepage {
    creepage(xi, eta, chi)
}

/// A case of the full theory whose forces are known, each with its uncertainty.
#[derive(Debug, serde::Deserialize)]
pub(crate) struct ReferenceCase {
    pub(crate) a_over_b: f64,
    pub(crate) poisson: f64,
    pub(crate) xi: f64,
    pub(crate) eta: f64,
    pub(crate) chi: f64,
    pub(crate) fx: f64,
    pub(crate) fy: f64,
    pub(crate) mz: f64,
    pub(crate) u_fx: f64,
    pub(crate) u_fy: f64,
    pub(crate) u_mz: f64,
}

impl ReferenceCase {
    pub(crate) fn contact(&self) -> Contact {
        contact(self.a_over_b, self.poisson)
    }

    pub(crate) fn creepage(&self) -> Creepage {
        creepage(self.xi, self.eta, self.chi)
    }
}

/// 132 cases, `a/b` from 0.2 to 5, spin to 10.
pub(crate) fn steady_rolling() -> Vec<ReferenceCase> {
    let table = include_str!("../../../creepage-study/data/steady_rolling.csv");
    let rows = csv::Reader::from_reader(table.as_bytes()).into_deserialize();
    rows.collect::<Result<_, _>>().unwrap()
}
