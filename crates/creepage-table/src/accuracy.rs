//! The error of a table against its theory, measured at random places.

use creepage::rolling::Theory;
use rayon::prelude::*;

use crate::coordinates::Coordinates;
use crate::table::Table;

/// Distribution of an error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Spread {
    /// Half of the places err by less.
    pub median: f64,
    /// 95 of 100 places err by less.
    pub p95: f64,
    /// 99 of 100 places err by less.
    pub p99: f64,
    /// Largest.
    pub worst: f64,
}

/// The error of a table against its theory, at places spread at random and evenly over the table's
/// coordinates, none of them a node.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Accuracy {
    /// Number of places.
    pub places: usize,
    /// Length of the difference of `(f_x, f_y)`, in parts of `mu N`.
    pub force: Spread,
    /// Size of the difference of `m_z`, in parts of `mu N c`.
    pub moment: Spread,
}

/// How many places share a theory, where each must be prepared for its shape and Poisson's ratio.
const SHARED: usize = 24;

impl Accuracy {
    /// Measures at `places` places; `prepare` takes `a/b` and Poisson's ratio.
    pub(crate) fn measure<E>(
        table: &Table,
        places: usize,
        prepare: impl Fn(f64, f64) -> Result<Box<dyn Theory>, E>,
        done: &(dyn Fn() + Sync),
    ) -> Result<Self, E> {
        let mut random = Random(1967);
        let fixed = table.blocks.len() == 1;
        let group = if fixed { places } else { SHARED };
        let mut errors = Vec::with_capacity(places);
        while errors.len() < places {
            let a_over_b = table.a_over_b.geometric(random.next());
            let poisson = table.poisson.even(random.next());
            let theory = prepare(a_over_b, poisson)?;
            let count = group.min(places - errors.len());
            let at: Vec<_> = (0..count).map(|_| [0; 3].map(|_| random.next())).collect();
            let Ok(slice) = table.at(a_over_b, poisson) else { break };
            let coordinates = Coordinates::new(a_over_b);
            errors.par_extend(at.into_par_iter().map(|[theta, phi, t]| {
                use std::f64::consts::{FRAC_PI_2, PI};
                let creepage = coordinates.creepage([theta * FRAC_PI_2, (phi - 0.5) * PI, t]);
                let (found, right) = (slice.force(creepage), theory.solve(creepage).force);
                done();
                let force = (found.fx - right.fx).hypot(found.fy - right.fy);
                [force, (found.mz - right.mz).abs()]
            }));
        }
        let spread = |which: usize| Spread::new(errors.iter().map(|error| error[which]).collect());
        Ok(Self { places: errors.len(), force: spread(0), moment: spread(1) })
    }
}

impl Spread {
    fn new(mut errors: Vec<f64>) -> Self {
        errors.sort_unstable_by(f64::total_cmp);
        let at = |hundredths: usize| {
            errors.get(errors.len() * hundredths / 100).copied().unwrap_or_default()
        };
        Self {
            median: at(50),
            p95: at(95),
            p99: at(99),
            worst: errors.last().copied().unwrap_or_default(),
        }
    }
}

/// `SplitMix64` (Steele, Lea, Flood 2014): the same places in every build.
struct Random(u64);

impl Random {
    /// Between 0 and 1, never quite 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((bits ^ (bits >> 31)) >> 11) as f64) / (1_u64 << 53) as f64
    }
}
