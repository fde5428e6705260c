//! Conicity and radius difference as tables.

use std::fmt::Write as _;

use creepage_rail::{ConicityError, RadiusDifference};

use super::{WheelsetCase, WheelsetFileError};

/// Amplitudes of the table: tenths of a millimetre.
const AMPLITUDES: std::ops::RangeInclusive<u8> = 10..=75;
/// Contact is looked for as far as this to either side (m); it ends long before.
const REACH: f64 = 0.5;

/// The equivalent conicity over the amplitude.
#[derive(Debug, Clone, PartialEq)]
pub struct ConicityTable {
    /// CSV `amplitude_m,conicity`, with nothing after the comma where there is no conicity.
    pub csv: String,
    /// The first amplitude without a conicity (m), and why.
    pub lacking: Option<(f64, ConicityError)>,
}

impl WheelsetCase {
    /// The difference of rolling radii as far as contact exists: without roll, as EN 15302 has
    /// it, or with the wheelset rolled until both wheels touch.
    ///
    /// # Errors
    /// [`WheelsetFileError::Apart`] where the profiles do not meet in the middle of the track, or the
    /// wheelset cannot be placed beside it.
    pub fn radius_difference(&self, rolls: bool) -> Result<RadiusDifference, WheelsetFileError> {
        self.is_alike_along("the difference of rolling radii, and the conicity,")?;
        let roll = (!rolls).then_some(0.0);
        self.running.radius_differences(REACH, roll).map_err(WheelsetFileError::Apart)
    }
}

/// The conicity for amplitudes from 1.0 to 7.5 mm by tenths.
#[must_use]
pub fn conicity(difference: &RadiusDifference) -> ConicityTable {
    let mut table = ConicityTable { csv: "amplitude_m,conicity\n".into(), lacking: None };
    for tenths in AMPLITUDES {
        let amplitude = f64::from(tenths) * 1e-4;
        // Nothing fails in writing to a string.
        let _ = match difference.conicity(amplitude) {
            Ok(conicity) => writeln!(table.csv, "{amplitude:.4},{conicity:.9}"),
            Err(error) => {
                table.lacking = table.lacking.or(Some((amplitude, error)));
                writeln!(table.csv, "{amplitude:.4},")
            }
        };
    }
    table
}

/// CSV `y_m,radius_difference_m`, by tenths of a millimetre: the right wheel's less the left's.
#[must_use]
pub fn radius_difference_csv(difference: &RadiusDifference) -> String {
    let start = String::from("y_m,radius_difference_m\n");
    difference.rows().fold(start, |mut text, (y, value)| {
        // Rounded, and without the sign of a zero.
        let [y, value] = [(y, 1e4), (value, 1e12)].map(|(x, unit)| (x * unit).round() / unit + 0.0);
        let _ = writeln!(text, "{y:.4},{value:.12}");
        text
    })
}
