//! Creep-force curves: several theories over a range of one component of the creepage.

use std::path::{Path, PathBuf};

use creepage::rolling::{Creepage, Force, Scaling, Solution, Theory};
use creepage::{Hertz, InvalidValue};

use crate::error::ReportError;
use crate::write;

/// A component of creepage and spin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Component {
    /// `xi`, along the rolling direction.
    Longitudinal,
    /// `eta`, across it.
    Lateral,
    /// `chi`, about the normal.
    Spin,
}

impl Component {
    /// This component of `creepage`.
    #[must_use]
    pub fn of(self, creepage: Creepage) -> f64 {
        match self {
            Self::Longitudinal => creepage.xi,
            Self::Lateral => creepage.eta,
            Self::Spin => creepage.chi,
        }
    }

    /// `creepage` with this component replaced.
    #[must_use]
    pub fn replaced(self, creepage: Creepage, value: f64) -> Creepage {
        match self {
            Self::Longitudinal => Creepage { xi: value, ..creepage },
            Self::Lateral => Creepage { eta: value, ..creepage },
            Self::Spin => Creepage { chi: value, ..creepage },
        }
    }
}

/// What one theory says along the range.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    pub(crate) theory: String,
    pub(crate) solutions: Vec<Solution>,
}

/// Forces by several theories while one component of the creepage varies.
///
/// ```
/// use creepage::rolling::{Creepage, linear::Linear, saturated::Saturated};
/// use creepage::{Ellipse, Hertz, Solid, SolidPair};
/// use creepage_report::{Component, Curves};
/// let steel = Solid::new(82e9, 0.28)?;
/// let circle = Ellipse::new(5e-3, 5e-3)?;
/// let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), circle, 80e3)?;
/// let values = vec![0.0, 0.5, 1.0];
/// let mut curves =
///     Curves::new(&contact, 0.3, Creepage::default(), Component::Longitudinal, values)?;
/// curves.add("linear", &Linear::new(1.0, 0.28)?);
/// curves.add("saturated", &Saturated::new(1.0)?);
/// assert_eq!(curves.csv()?.iter().filter(|byte| **byte == b'\n').count(), 7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Curves<'a> {
    pub(crate) contact: &'a Hertz,
    pub(crate) friction: f64,
    pub(crate) scaling: Scaling,
    /// The case: its varied component is marked, the others hold on all curves.
    pub(crate) case: Creepage,
    pub(crate) vary: Component,
    /// Dimensionless, ascending.
    pub(crate) values: Vec<f64>,
    pub(crate) lines: Vec<Curve>,
}

const HEADER: [&str; 14] = [
    "theory",
    "status",
    "xi",
    "eta",
    "chi",
    "fx",
    "fy",
    "mz",
    "longitudinal",
    "lateral",
    "spin_rad_per_m",
    "longitudinal_n",
    "lateral_n",
    "moment_n_m",
];

impl<'a> Curves<'a> {
    /// The question: `contact` with coefficient of friction `friction`, creepage as in `case` but
    /// for the component `vary`, which takes the dimensionless `values`, in ascending order.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive and every value a creepage.
    pub fn new(
        contact: &'a Hertz,
        friction: f64,
        case: Creepage,
        vary: Component,
        mut values: Vec<f64>,
    ) -> Result<Self, InvalidValue> {
        let scaling = Scaling::new(contact, friction)?;
        for &value in &values {
            let Creepage { xi, eta, chi } = vary.replaced(case, value);
            Creepage::new(xi, eta, chi)?;
        }
        values.sort_unstable_by(f64::total_cmp);
        Ok(Self { contact, friction, scaling, case, vary, values, lines: Vec::new() })
    }

    /// Adds the answers of a theory, prepared for the contact's ellipse and Poisson's ratio.
    pub fn add(&mut self, name: &str, theory: &dyn Theory) {
        let solutions = self.creepages().map(|creepage| theory.solve(creepage)).collect();
        self.lines.push(Curve { theory: name.into(), solutions });
    }

    /// Does the range reach `value`?
    pub(crate) fn reach(&self, value: f64) -> bool {
        self.values.first().is_some_and(|first| *first <= value)
            && self.values.last().is_some_and(|last| value <= *last)
    }

    pub(crate) fn creepages(&self) -> impl Iterator<Item = Creepage> {
        self.values.iter().map(|&value| self.vary.replaced(self.case, value))
    }

    /// A row for each point of each curve: dimensionless, then in SI units; forces and moment are
    /// those on the lower body.
    ///
    /// # Errors
    /// [`ReportError::Points`], should memory not suffice.
    pub fn csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        for curve in &self.lines {
            for (creepage, solution) in self.creepages().zip(&curve.solutions) {
                writer.write_field(&curve.theory)?;
                writer.write_field(solution.status.name())?;
                writer.write_record(self.numbers(creepage, solution.force))?;
            }
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    /// In the shortest form that reads back as the same number.
    fn numbers(&self, creepage: Creepage, force: Force) -> [String; 12] {
        let si = self.scaling.si_creepage(creepage);
        let si_force = self.scaling.si_force(force);
        [
            creepage.xi,
            creepage.eta,
            creepage.chi,
            force.fx,
            force.fy,
            force.mz,
            si.longitudinal,
            si.lateral,
            si.spin,
            si_force.longitudinal,
            si_force.lateral,
            si_force.moment,
        ]
        .map(|number| format!("{number:e}"))
    }

    /// Writes `curve.csv`, `curve.svg` and `curve.png` into `directory`, which is made when
    /// missing: all of them or none. Files of those names are replaced. Gives the paths written.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let svg = self.svg();
        let png = creepage_plot::png(&svg)?;
        let files: [(&str, &[u8]); 3] =
            [("curve.csv", &self.csv()?), ("curve.svg", svg.as_bytes()), ("curve.png", &png)];
        write::write_all(directory, &files)
    }
}

#[cfg(test)]
mod tests {
    use creepage::rolling::saturated::Saturated;

    use super::*;
    use crate::testing::{CURVE, contact};

    fn curves(contact: &Hertz) -> Curves<'_> {
        let values = vec![1.0, -2.0, 0.5];
        let mut curves = Curves::new(contact, 0.3, CURVE, Component::Lateral, values).unwrap();
        curves.add("one, two", &Saturated::new(1.0).unwrap());
        curves
    }

    #[test]
    fn rows_are_ascending_and_in_both_units() {
        let contact = contact(1.0);
        let curves = curves(&contact);
        let csv = curves.csv().unwrap();
        let mut reader = csv::Reader::from_reader(&csv[..]);
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 3);
        let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
        let theory = Saturated::new(1.0).unwrap();
        for (row, eta) in [-2.0, 0.5, 1.0].into_iter().enumerate() {
            assert_eq!((&rows[row][0], &rows[row][1]), ("one, two", "solved"));
            let creepage = Creepage { eta, ..CURVE };
            let force = theory.solve(creepage).force;
            let printed = [2, 3, 4, 5, 6, 7].map(|column| number(row, column).to_bits());
            let Creepage { xi, eta, chi } = creepage;
            assert_eq!(printed, [xi, eta, chi, force.fx, force.fy, force.mz].map(f64::to_bits));
            let si = curves.scaling.si_force(force);
            assert_eq!(number(row, 12).to_bits(), si.lateral.to_bits());
        }
    }

    #[test]
    fn a_value_that_is_no_creepage_is_refused() {
        let contact = contact(1.0);
        let curves = |friction, value| {
            Curves::new(&contact, friction, CURVE, Component::Spin, vec![0.0, value])
        };
        assert_eq!(curves(0.3, f64::NAN).unwrap_err().quantity, "chi");
        assert_eq!(curves(0.0, 1.0).unwrap_err().quantity, "friction");
    }

    #[test]
    fn three_files_the_same_each_time() {
        let root = tempfile::tempdir().unwrap();
        let contact = contact(1.0);
        let [one, two] = ["one", "two"].map(|name| {
            let paths = curves(&contact).write(&root.path().join(name)).unwrap();
            assert_eq!(paths.len(), 3);
            paths.iter().map(|path| std::fs::read(path).unwrap()).collect::<Vec<_>>()
        });
        assert!(one == two && one.iter().all(|contents| contents.len() > 100));
    }
}
