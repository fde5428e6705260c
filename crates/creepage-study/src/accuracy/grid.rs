//! A grid of cases that leaves no corner of creepage and spin out, for a full theory to answer.

use creepage::{Contact, Creepage, Ellipse, InvalidValue, Theory};
use rayon::prelude::*;

use super::ReferenceCase;

/// Steel, as in most of the literature.
const POISSON: f64 = 0.28;
const RATIOS: [f64; 5] = [0.2, 0.5, 1.0, 2.0, 5.0];
const SPINS: [f64; 4] = [0.0, 0.5, 1.0, 2.0];
/// From the rolling direction to the creepage (degrees). The other half of the circle, and
/// negative spin, are mirror images.
const ANGLES: [f64; 7] = [-90.0, -60.0, -30.0, 0.0, 30.0, 60.0, 90.0];

/// From linear theory's range to full sliding, ten to a decade: .05 to 7.9.
fn magnitudes() -> impl Iterator<Item = f64> {
    (0..23).map(|k| 0.05 * 10_f64.powf(0.1 * f64::from(k)))
}

/// 3220 cases as `full` answers them: `a/b` from 0.2 to 5, spin from 0 to 2, 7 directions and 23
/// magnitudes of the creepage.
///
/// A mean over such a set depends on how much of it slides fully, where good theories agree: with
/// magnitudes evenly spaced to 10, not by decades, FASTSIM's root mean square error is a quarter
/// less with blended flexibilities, and a sixth more with those of 1982.
///
/// `full` gives the theory for a contact.
///
/// # Errors
/// What `full` returns, should it not reach all of the grid.
pub fn grid<E: From<InvalidValue>>(
    full: impl Fn(&Contact) -> Result<Box<dyn Theory>, E>,
) -> Result<Vec<ReferenceCase>, E> {
    let mut cases = Vec::new();
    for a_over_b in RATIOS {
        let contact = Contact::new(Ellipse::from_ratio(a_over_b)?, POISSON)?;
        let theory = full(&contact)?;
        let creepages = creepages().collect::<Result<Vec<_>, _>>()?;
        cases.par_extend(creepages.into_par_iter().map(|creepage| ReferenceCase {
            contact: contact.clone(),
            creepage,
            force: theory.solve(creepage).force,
            uncertainty: None,
        }));
    }
    Ok(cases)
}

fn creepages() -> impl Iterator<Item = Result<Creepage, InvalidValue>> {
    let directions = SPINS.into_iter().flat_map(|chi| ANGLES.map(|angle| (chi, angle)));
    directions.flat_map(|(chi, angle)| {
        let (sin, cos) = angle.to_radians().sin_cos();
        magnitudes().map(move |size| Creepage::new(size * cos, size * sin, chi))
    })
}

#[cfg(test)]
mod tests {
    use creepage::approximate::fastsim::{Fastsim, Settings};
    use creepage::approximate::saturated::Saturated;

    use super::*;
    use crate::accuracy::measure;

    fn fastsim(contact: &Contact, cells: usize) -> Result<Box<dyn Theory>, InvalidValue> {
        let settings = Settings { grid: [cells; 2], ..Settings::default() };
        Ok(Box::new(Fastsim::new(contact, settings)?))
    }

    #[test]
    fn a_theory_is_as_far_from_another_as_they_are_alike() {
        let cases = grid(|contact| fastsim(contact, 20)).unwrap();
        assert_eq!(cases.len(), 3220);
        let itself = measure(&cases, |contact| fastsim(contact, 20)).unwrap();
        assert!(itself.force.worst < 1e-15 && itself.moment.worst < 1e-15);
        let finer = measure(&cases, |contact| fastsim(contact, 40)).unwrap();
        let saturated = measure(&cases, |contact| {
            Ok::<Box<dyn Theory>, InvalidValue>(Box::new(Saturated::new(contact)?))
        });
        // The 20 x 20 grid errs by half a per cent or so; without elasticity it is many.
        assert!(finer.force.rms < 0.01 && saturated.unwrap().force.rms > 0.1);
    }

    #[test]
    fn a_theory_that_does_not_reach_the_grid_says_so() {
        let short = |contact: &Contact| {
            let ellipse = Ellipse::from_ratio(1e4 * contact.ellipse().ratio())?;
            fastsim(&Contact::new(ellipse, contact.poisson())?, 10)
        };
        assert_eq!(grid(short).unwrap_err().quantity, "a_over_b");
    }
}
