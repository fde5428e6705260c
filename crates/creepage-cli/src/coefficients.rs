//! `creepage coefficients`: what linear theory comes down to.

use std::fmt::Write;

use creepage::approximate::linear::CreepageCoefficients;
use creepage::unsteady::{Harmonic, HarmonicCoefficients, HarmonicCreepage};
use creepage::{Contact, Ellipse};
use serde::Serialize;

use crate::args::CoefficientsArgs;
use crate::failure::Failure;
use crate::output::{print, to_json};

/// The coefficients, and what they belong to.
#[derive(Serialize)]
struct Coefficients {
    a_over_b: f64,
    poisson: f64,
    /// Of the polynomials; `None` where converged.
    degree: Option<usize>,
    c11: f64,
    c22: f64,
    c23: f64,
    c32: f64,
    c33: f64,
}

pub(crate) fn run(args: &CoefficientsArgs) -> Result<(), Failure> {
    let CoefficientsArgs { a_over_b, poisson, degree, wavelength, json } = *args;
    let contact = Contact::new(Ellipse::from_ratio(a_over_b)?, poisson)?;
    if let Some(wavelength) = wavelength {
        let of = HarmonicCreepage::new(&contact)?.coefficients(wavelength)?;
        let found = Waves::new(a_over_b, poisson, wavelength, of);
        return print(&if json { to_json(&found)? } else { found.text() });
    }
    let CreepageCoefficients { c11, c22, c23, c32, c33 } = match degree {
        Some(degree) => CreepageCoefficients::of_degree(&contact, degree)?,
        None => CreepageCoefficients::new(&contact)?,
    };
    let found = Coefficients { a_over_b, poisson, degree, c11, c22, c23, c32, c33 };
    print(&if json { to_json(&found)? } else { found.text() })
}

/// Those of creepage that varies as a wave: real and imaginary parts.
#[derive(Serialize)]
struct Waves {
    a_over_b: f64,
    poisson: f64,
    wavelength: f64,
    c11: [f64; 2],
    c22: [f64; 2],
    c23: [f64; 2],
    c32: [f64; 2],
    c33: [f64; 2],
}

impl Waves {
    fn new(a_over_b: f64, poisson: f64, wavelength: f64, found: HarmonicCoefficients) -> Self {
        let HarmonicCoefficients { c11, c22, c23, c32, c33 } = found;
        let [c11, c22, c23, c32, c33] =
            [c11, c22, c23, c32, c33].map(|Harmonic { real, imaginary }| [real, imaginary]);
        Self { a_over_b, poisson, wavelength, c11, c22, c23, c32, c33 }
    }

    /// Four digits: errors are below one per cent.
    fn text(&self) -> String {
        let mut text = format!(
            "Creepage and spin coefficients for a/b = {}, Poisson's ratio {}, creepage that varies over \
             {} semi-axes: real, imaginary\n\n",
            self.a_over_b, self.poisson, self.wavelength
        );
        for (name, [real, imaginary]) in [
            ("C11", self.c11),
            ("C22", self.c22),
            ("C23", self.c23),
            ("C32", self.c32),
            ("C33", self.c33),
        ] {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{name}  {real:>9.4}  {imaginary:>9.4}");
        }
        text
    }
}

impl Coefficients {
    /// Seven digits: as many as are right.
    fn text(&self) -> String {
        let how = self.degree.map_or("converged".into(), |degree| format!("degree {degree}"));
        let mut text = format!(
            "Creepage and spin coefficients for a/b = {}, Poisson's ratio {}, {how}\n\n",
            self.a_over_b, self.poisson
        );
        for (name, value, meaning) in [
            ("C11", self.c11, "longitudinal force by longitudinal creepage"),
            ("C22", self.c22, "lateral force by lateral creepage"),
            ("C23", self.c23, "lateral force by spin"),
            ("C32", self.c32, "moment by lateral creepage"),
            ("C33", self.c33, "moment by spin"),
        ] {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{name}  {value:>13}  {meaning}", value = digits(value));
        }
        text
    }
}

/// Seven digits, in plain decimals where these are few.
fn digits(value: f64) -> String {
    match value.abs() {
        size if (1e-3..1e4).contains(&size) => {
            let before = 1 + (1..4).filter(|power| size >= 10_f64.powi(*power)).count();
            format!("{value:.*}", 7 - before)
        }
        _ => format!("{value:.6e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seven_digits_of_any_size() {
        for (value, text) in [
            (3.395_305_452, "3.395305"),
            (-1.333_333_333, "-1.333333"),
            (1_234.567_89, "1234.568"),
            (99.999_999, "100.00000"),
            (123_456.789, "1.234568e5"),
            (0.0, "0.000000e0"),
        ] {
            assert_eq!(digits(value), text);
        }
    }
}
