//! Creep-force curves: several theories over a range of one component of the creepage.

use std::f64::consts::PI;
use std::path::{Path, PathBuf};

use creepage::friction_law::RollingFriction;
use creepage::{Contact, Creepage, Force, InvalidValue, Solution, Theory, TheorySpec};
use creepage_plot::Label;

use crate::contact_picture::{setting, setting_of_areas};
use crate::error::ReportError;
use crate::file_set::write_all;
use crate::measured::Overlaid;
use crate::sources::Sources;
use crate::{Case, CaseError, GapCase};

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
    /// All of them, in the order of forces and creepages.
    pub const ALL: [Self; 3] = [Self::Longitudinal, Self::Lateral, Self::Spin];

    /// This component of `creepage`.
    #[must_use]
    pub fn of(self, creepage: Creepage) -> f64 {
        match self {
            Self::Longitudinal => creepage.xi(),
            Self::Lateral => creepage.eta(),
            Self::Spin => creepage.chi(),
        }
    }

    /// `creepage` with this component replaced.
    ///
    /// # Errors
    /// [`InvalidValue`] for a value that is no creepage.
    pub fn replaced(self, creepage: Creepage, value: f64) -> Result<Creepage, InvalidValue> {
        let [xi, eta, chi] = creepage.components();
        match self {
            Self::Longitudinal => Creepage::new(value, eta, chi),
            Self::Lateral => Creepage::new(xi, value, chi),
            Self::Spin => Creepage::new(xi, eta, value),
        }
    }
}

/// What one theory says along the range.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    pub(crate) theory: String,
    pub(crate) solutions: Vec<Solution>,
    pub(crate) largest: Option<LargestForce>,
}

impl Curve {
    /// Whether the theory has a moment about the normal; what is none of the theories, as a table, has.
    pub(crate) fn has_moment(&self) -> bool {
        TheorySpec::named(&self.theory).map_or(true, |spec| spec.facts().moment)
    }
}

/// The largest tangential force along a curve, where friction falls and with it the force beyond.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LargestForce {
    /// Value of the component that varies.
    pub at: f64,
    /// Force and moment there.
    pub force: Force,
}

/// Forces by several theories while one component of the creepage varies.
///
/// ```
/// use creepage::TheorySpec;
/// use creepage_study::{CaseFile, Component, Curves};
/// # let text = "
/// # upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
/// # lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
/// # contact = { normal_force = 80e3, friction = 0.3 }
/// # creepage = { longitudinal = 1e-3 }
/// # ";
/// let case = CaseFile::read(text)?.case()?;
/// let mut curves = Curves::new(&case, Component::Longitudinal, vec![0.0, 0.5, 1.0])?;
/// for name in ["linear", "saturated"] {
///     curves.add(name, &*TheorySpec::named(name)?.prepare(&case.contact)?);
/// }
/// assert_eq!(curves.csv()?.iter().filter(|byte| **byte == b'\n').count(), 7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Curves {
    pub(crate) contact: Contact,
    /// Load, friction and pressure, below the title.
    pub(crate) note: Label,
    /// What no moment of tractions exceeds, in units of `mu N c`.
    pub(crate) largest_moment: f64,
    /// That of the case: its varied component is marked, the others hold on all curves.
    pub(crate) creepage: Creepage,
    pub(crate) vary: Component,
    /// Dimensionless, ascending.
    pub(crate) values: Vec<f64>,
    creepages: Vec<Creepage>,
    pub(crate) lines: Vec<Curve>,
    pub(crate) measured: Vec<Overlaid>,
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

impl Curves {
    /// The question: creepage as in `case` but for the component `vary`, which takes the
    /// dimensionless `values`, in ascending order.
    ///
    /// # Errors
    /// [`CaseError`] unless the case has a creepage, and every value makes one.
    pub fn new(case: &Case, vary: Component, values: Vec<f64>) -> Result<Self, CaseError> {
        let ellipse = case.hertz.ellipse();
        // No traction has a larger moment than that of pure spin, which this bounds.
        let largest_moment = 3.0 * PI / 16.0 * ellipse.major() / ellipse.c();
        let note = setting(&case.hertz, case.friction);
        let (contact, creepage) = (case.contact.clone(), case.creepage()?);
        Self { largest_moment, ..Self::of(contact, note, creepage, vary) }.over(values)
    }

    /// The same on areas of any shape, pressed as `contact`.
    ///
    /// # Errors
    /// As [`Curves::new`].
    pub fn on_areas(
        case: &GapCase,
        contact: Contact,
        vary: Component,
        values: Vec<f64>,
    ) -> Result<Self, CaseError> {
        if !case.given.is_creepage() {
            return Err(CaseError::Wanted);
        }
        let creepage = case.given.creepage(contact.scaling())?;
        let note = contact
            .areas()
            .map_or_else(Label::default, |areas| setting_of_areas(areas, case.friction));
        Self::of(contact, note, creepage, vary).over(values)
    }

    fn of(contact: Contact, note: Label, creepage: Creepage, vary: Component) -> Self {
        let (values, creepages, lines, measured) = Default::default();
        let largest_moment = f64::INFINITY;
        Self { contact, note, largest_moment, creepage, vary, values, creepages, lines, measured }
    }

    fn over(self, mut values: Vec<f64>) -> Result<Self, CaseError> {
        let (vary, creepage) = (self.vary, self.creepage);
        values.sort_unstable_by(f64::total_cmp);
        let creepages = values.iter().map(|value| vary.replaced(creepage, *value));
        let creepages =
            creepages.collect::<Result<_, _>>().map_err(CaseError::invalid("creepage"))?;
        Ok(Self { values, creepages, ..self })
    }

    /// Adds the answers of a theory, prepared for the contact of the case.
    pub fn add(&mut self, name: &str, theory: &dyn Theory) {
        let solutions: Vec<_> =
            self.creepages.iter().map(|creepage| theory.solve(*creepage)).collect();
        let largest = self.largest_of(theory, &solutions);
        self.lines.push(Curve { theory: name.into(), solutions, largest });
    }

    /// The largest tangential force of all theories over `mu N`.
    #[must_use]
    pub fn largest_share(&self) -> f64 {
        let solutions = self.lines.iter().flat_map(|line| &line.solutions);
        solutions.map(|solution| solution.force.fx.hypot(solution.force.fy)).fold(0.0, f64::max)
    }

    /// The largest tangential force of each theory that has one inside the range, in the order in which
    /// they were added: only where friction falls with the speed of slip.
    pub fn largest(&self) -> impl Iterator<Item = (&str, LargestForce)> {
        self.lines.iter().filter_map(|line| Some((&line.theory[..], line.largest?)))
    }

    /// Between the neighbours of the largest of the solutions, by the golden section.
    fn largest_of(&self, theory: &dyn Theory, solutions: &[Solution]) -> Option<LargestForce> {
        const SECTIONS: u8 = 30;
        const GOLDEN: f64 = 0.618_033_988_749_895;
        self.contact.rolling_friction().filter(RollingFriction::falls)?;
        let size = |k: &usize| solutions[*k].force.magnitude();
        let top = (0..solutions.len()).max_by(|one, two| size(one).total_cmp(&size(two)))?;
        let (mut low, mut high) =
            (*self.values.get(top.checked_sub(1)?)?, *self.values.get(top + 1)?);
        let at = |value: f64| {
            let creepage = self.vary.replaced(self.creepage, value).ok()?;
            Some(LargestForce { at: value, force: theory.solve(creepage).force })
        };
        let inner = |low: f64, high: f64| high - GOLDEN * (high - low);
        let (mut left, mut right) = (at(inner(low, high))?, at(inner(high, low))?);
        for _ in 0..SECTIONS {
            if left.force.magnitude() > right.force.magnitude() {
                (high, right) = (right.at, left);
                left = at(inner(low, high))?;
            } else {
                (low, left) = (left.at, right);
                right = at(inner(high, low))?;
            }
        }
        Some(left)
    }

    /// Does the range reach `value`?
    pub(crate) fn reach(&self, value: f64) -> bool {
        self.values.first().is_some_and(|first| *first <= value)
            && self.values.last().is_some_and(|last| value <= *last)
    }

    /// A row for each point of each curve: dimensionless, then in SI units; forces and moment are
    /// those on the lower body, the moment empty where the theory has none. Measured points follow, as of
    /// a theory `measured`, with the status `apart` where their other creepages or load are not the curves'.
    ///
    /// # Errors
    /// [`ReportError::Points`], should memory not suffice.
    pub fn csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        for curve in &self.lines {
            for (creepage, solution) in self.creepages.iter().zip(&curve.solutions) {
                writer.write_field(&curve.theory)?;
                writer.write_field(solution.status.name())?;
                let mut numbers = self.numbers(*creepage, solution.force);
                if !curve.has_moment() {
                    [numbers[5], numbers[11]] = Default::default();
                }
                writer.write_record(numbers)?;
            }
        }
        for point in &self.measured {
            writer.write_record(
                ["measured", if point.is_apart { "apart" } else { "" }]
                    .into_iter()
                    .map(String::from)
                    .chain(self.of_measured(point)),
            )?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    /// In the shortest form that reads back as the same number.
    fn numbers(&self, creepage: Creepage, force: Force) -> [String; 12] {
        let scaling = self.contact.scaling();
        let (si, si_force) = (scaling.si_creepage(creepage), scaling.si_force(force));
        let ([xi, eta, chi], [fx, fy, mz]) = (creepage.components(), force.components());
        [
            xi,
            eta,
            chi,
            fx,
            fy,
            mz,
            si.longitudinal,
            si.lateral,
            si.spin,
            si_force.longitudinal,
            si_force.lateral,
            si_force.moment,
        ]
        .map(|number| format!("{number:e}"))
    }

    /// As [`Curves::numbers`] of a point that was measured: empty where it was not.
    fn of_measured(&self, point: &Overlaid) -> [String; 12] {
        let [fx, fy] = point.force;
        let force = Force { fx: fx.unwrap_or(0.0), fy: fy.unwrap_or(0.0), mz: 0.0 };
        let mut numbers = self.numbers(point.creepage, force);
        for (place, is_measured) in [(3, fx.is_some()), (4, fy.is_some()), (5, false)] {
            if !is_measured {
                [numbers[place], numbers[place + 6]] = Default::default();
            }
        }
        numbers
    }

    /// Writes `curve.csv`, `curve.svg` and `curve.png` into `directory`, which is made when
    /// missing: all of them or none. Files of those names are replaced, but none of `sources`. Gives the paths written.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path, sources: &Sources) -> Result<Vec<PathBuf>, ReportError> {
        let svg = self.svg();
        let png = creepage_plot::png(&svg)?;
        let files: [(&str, &[u8]); 3] =
            [("curve.csv", &self.csv()?), ("curve.svg", svg.as_bytes()), ("curve.png", &png)];
        write_all(directory, &files, sources)
    }
}

#[cfg(test)]
mod tests {
    use creepage::approximate::saturated::Saturated;

    use super::*;
    use crate::testing::{CURVE, case, creepage};

    fn curves(case: &Case) -> Curves {
        let values = vec![1.0, -2.0, 0.5];
        let mut curves = Curves::new(case, Component::Lateral, values).unwrap();
        curves.add("one, two", &Saturated::new(&case.contact).unwrap());
        curves
    }

    #[test]
    fn rows_are_ascending_and_in_both_units() {
        let case = case(1.0, CURVE);
        let curves = curves(&case);
        let csv = curves.csv().unwrap();
        let mut reader = csv::Reader::from_reader(&csv[..]);
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 3);
        let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
        let theory = Saturated::new(&case.contact).unwrap();
        for (row, eta) in [-2.0, 0.5, 1.0].into_iter().enumerate() {
            assert_eq!((&rows[row][0], &rows[row][1]), ("one, two", "solved"));
            let [xi, _, chi] = CURVE;
            let force = theory.solve(creepage([xi, eta, chi])).force;
            let printed = [2, 3, 4, 5, 6, 7].map(|column| number(row, column).to_bits());
            assert_eq!(printed, [xi, eta, chi, force.fx, force.fy, force.mz].map(f64::to_bits));
            let si = case.contact.scaling().si_force(force);
            assert_eq!(number(row, 12).to_bits(), si.lateral.to_bits());
        }
    }

    #[test]
    fn a_value_that_is_no_creepage_is_refused() {
        let case = case(1.0, CURVE);
        let error = Curves::new(&case, Component::Spin, vec![0.0, f64::NAN]).unwrap_err();
        assert!(error.to_string().starts_with("[creepage] chi"), "{error}");
    }

    #[test]
    fn three_files_the_same_each_time() {
        let root = tempfile::tempdir().unwrap();
        let case = case(1.0, CURVE);
        let [one, two] = ["one", "two"].map(|name| {
            let paths = curves(&case).write(&root.path().join(name), &Sources::default()).unwrap();
            assert_eq!(paths.len(), 3);
            paths.iter().map(|path| std::fs::read(path).unwrap()).collect::<Vec<_>>()
        });
        assert!(one == two && one.iter().all(|contents| contents.len() > 100));
    }
}
