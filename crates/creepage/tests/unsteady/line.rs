//! Line contacts, and proposition IV of the thesis.

use creepage::Region;
use creepage::approximate::carter::Carter;
use creepage::unsteady::{Motion, Rolling};

use super::cases::{LINE_C_04_L1000, LINE_F_04_L100, LINE_S_04_L100, Row, STATIONS};
use super::support::creeping;

const POISSON: f64 = 0.28;

fn line(length: f64, shift: f64) -> Rolling {
    let mut rolling = Rolling::line(length, POISSON).unwrap();
    if shift != 0.0 {
        rolling.shift(shift, 0.0).unwrap();
    }
    rolling
}

/// Its creepage is in units of `mu a / R` with `R = rho / 4`.
fn against(row: &Row, mut rolling: Rolling, motion: &Motion, tolerance: f64) {
    let mut last = 0.0;
    for (k, q) in STATIONS.iter().enumerate() {
        let rolled = rolling.step(q - last, motion).unwrap();
        let found =
            if row.name == "fx" { rolled.solution.force.fx } else { rolled.creepage.xi() / 4.0 };
        let off = (found - row.values[k]).abs();
        assert!(off < tolerance + 2.0 * row.uncertainty[k], "{q}: {found} {}", row.values[k]);
        last = *q;
    }
}

#[test]
fn forces_at_constant_creepage() {
    let motion = creeping(1.6, 0.0, 0.0);
    against(&LINE_C_04_L1000, line(1000.0, 0.0), &motion, 5e-4);
    against(&LINE_S_04_L100, line(100.0, 0.64), &motion, 2e-3);
}

/// The peak at one half-width is as sharp as the steps are short.
#[test]
fn creepage_at_constant_force() {
    against(&LINE_F_04_L100, line(100.0, 0.64), &Motion::forces(0.64, 0.0), 0.01);
}

#[test]
fn it_ends_in_carters_solution() {
    for force in [0.2, 0.64, 0.9] {
        let mut rolling = line(1000.0, force);
        let end = rolling.step(12.0, &Motion::forces(force, 0.0)).unwrap();
        let carter = Carter::new(end.creepage.xi()).unwrap();
        // The steady scheme of 100 elements is that far from Carter; a line of 1000 half-widths adds
        // 1e-6.
        assert!((carter.force() - force).abs() < 5e-4, "{force}: {}", carter.force());
        let share = carter.adhesion_half_width();
        assert!((end.adhesion_share - share).abs() < 0.03, "{force}: {share}");
    }
}

/// Borders of adhesion from the trailing edge, where the region changes.
fn borders(rolling: &Rolling) -> Vec<f64> {
    let elements = rolling.elements();
    let changes = elements.windows(2).filter(|pair| pair[0].point.region != pair[1].point.region);
    let mut borders: Vec<f64> = changes.map(|pair| pair[0].corners[2][0]).collect();
    borders.reverse();
    borders
}

/// 1. The border between adhesion and slip can jump.
#[test]
fn the_border_of_adhesion_jumps() {
    let mut rolling = line(1000.0, 0.64);
    let (mut last, mut largest) = (borders(&rolling)[0], 0.0_f64);
    for _ in 0..120 {
        rolling.advance(0.0125, &Motion::forces(0.64, 0.0)).unwrap();
        let border = borders(&rolling).first().copied().unwrap_or(-1.0);
        largest = largest.max((border - last).abs());
        last = border;
    }
    // A step of .0125 half-widths, elements of .03 at most.
    assert!(largest > 0.2, "{largest}");
}

/// 2. The adhesion area can split in two: what comes in adheres, and so does the middle still.
#[test]
fn the_adhesion_area_splits() {
    let areas = |creepage: f64| {
        let mut rolling = line(1000.0, 0.64);
        let mut most = 0;
        for _ in 0..40 {
            rolling.advance(0.025, &creeping(creepage, 0.0, 0.0)).unwrap();
            let adheres: Vec<bool> =
                rolling.elements().iter().map(|e| e.point.region == Region::Adhesion).collect();
            let begins = adheres.windows(2).filter(|pair| !pair[0] && pair[1]).count();
            most = most.max(begins + usize::from(adheres[0]));
        }
        most
    };
    let found = [-6.0, -3.2, -1.6, 1.6, 2.4, 3.2, 6.0, 20.0].map(areas);
    assert!(found.into_iter().max() >= Some(2), "{found:?}");
}

/// 3. At constant force transients have died out within one to two contact widths.
#[test]
fn transients_die_out_within_two_contact_widths() {
    let mut rolling = line(1000.0, 0.64);
    let motion = Motion::forces(0.64, 0.0);
    let largest = |rolling: &mut Rolling, steps: usize| {
        let off = |rolled: creepage::unsteady::Rolled| (rolled.creepage.xi() / 1.6 - 1.0).abs();
        let steps = (0..steps).map(|_| off(rolling.advance(0.05, &motion).unwrap()));
        steps.fold(0.0, f64::max)
    };
    let widths = [largest(&mut rolling, 40), largest(&mut rolling, 40), largest(&mut rolling, 40)];
    assert!(widths[0] > 0.15 && widths[1] < 0.02 && widths[2] < 0.004, "{widths:?}");
}
