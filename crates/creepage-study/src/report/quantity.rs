//! A quantity of a report, and the report: quantities and words in their order, as text and as JSON.

use creepage_plot::format::{fixed, quantity, significant};
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::part::ReportPart;
use crate::text::Lines;

/// The SI unit of a quantity, or a number without one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// A number without unit.
    One,
    /// A part of a whole, from 0 to 1; in percent in texts.
    Share,
    /// N.
    Newton,
    /// m.
    Metre,
    /// m².
    SquareMetre,
    /// Pa.
    Pascal,
    /// N m.
    NewtonMetre,
    /// N/m.
    NewtonPerMetre,
    /// m/N^(2/3).
    MetrePerNewtonTwoThirds,
    /// 1/m.
    PerMetre,
    /// rad.
    Radian,
    /// rad/m.
    RadianPerMetre,
    /// J/m.
    JoulePerMetre,
    /// m/s.
    MetrePerSecond,
    /// W.
    Watt,
}

impl Unit {
    /// How a key ends that has this unit, and the unit as it is written.
    const fn words(self) -> [&'static str; 2] {
        match self {
            Self::One | Self::Share => ["", ""],
            Self::Newton => ["_n", "N"],
            Self::Metre => ["_m", "m"],
            Self::SquareMetre => ["_m2", "m²"],
            Self::Pascal => ["_pa", "Pa"],
            Self::NewtonMetre => ["_n_m", "N m"],
            Self::NewtonPerMetre => ["_n_per_m", "N/m"],
            Self::MetrePerNewtonTwoThirds => ["_m_per_n_2_3", "m/N^(2/3)"],
            Self::PerMetre => ["_per_m", "1/m"],
            Self::Radian => ["_rad", "rad"],
            Self::RadianPerMetre => ["_rad_per_m", "rad/m"],
            Self::JoulePerMetre => ["_j_per_m", "J/m"],
            Self::MetrePerSecond => ["_m_per_s", "m/s"],
            Self::Watt => ["_w", "W"],
        }
    }

    /// The unit as it is written; nothing for numbers without one.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        self.words()[1]
    }

    /// How a key ends that has this unit.
    const fn suffix(self) -> &'static str {
        self.words()[0]
    }

    /// A number with its unit, for people.
    fn text(self, value: f64, digits: usize) -> String {
        match self {
            Self::Share => format!("{} %", fixed(100.0 * value, 2)),
            Self::SquareMetre => format!("{} mm²", significant(1e6 * value, digits)),
            Self::NewtonPerMetre => format!("{} N/µm", significant(1e-6 * value, digits)),
            Self::Radian => format!("{} deg", fixed(value.to_degrees(), 3)),
            Self::One => significant(value, digits),
            Self::PerMetre | Self::MetrePerNewtonTwoThirds | Self::RadianPerMetre => {
                format!("{} {}", significant(value, digits), self.symbol())
            }
            _ => quantity(value, self.symbol(), digits),
        }
    }
}

/// Where a text has a quantity as a row of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shown {
    /// Under the contact.
    Contact,
    /// The same, where nothing but the contact is reported.
    ContactAlone,
    /// Under friction.
    Friction,
    /// In columns with others, or not.
    Nowhere,
}

/// One number of a report.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// The part of the report that it belongs to, as `contact` or `contact.solid`; empty at the top.
    pub section: &'static str,
    /// Its name, without unit.
    pub name: &'static str,
    /// What it is, in words.
    pub label: &'static str,
    /// Its unit.
    pub unit: Unit,
    /// The number; `None` if it is unknown, as the frictional power without a rolling velocity.
    pub value: Option<f64>,
    /// Its error bar in the same unit: zero for what was given or has a closed form, `None` where nothing is known.
    pub error: Option<f64>,
    /// Whether reports have a key for its error bar.
    pub(crate) has_error: bool,
    pub(crate) shown: Shown,
}

impl Quantity {
    /// Its key in `report.json` without the section, with its unit.
    #[must_use]
    pub fn key(&self) -> String {
        format!("{}{}", self.name, self.unit.suffix())
    }

    /// Key of its error bar.
    #[must_use]
    pub fn error_key(&self) -> Option<String> {
        self.has_error.then(|| format!("{}_error{}", self.name, self.unit.suffix()))
    }

    /// Section and key, as `contact.normal_force_n`.
    #[must_use]
    pub fn path(&self) -> String {
        let dot = if self.section.is_empty() { "" } else { "." };
        format!("{}{dot}{}", self.section, self.key())
    }

    /// Its value with its unit, for people.
    #[must_use]
    pub fn text(&self) -> Option<String> {
        self.value.map(|value| self.unit.text(value, 5))
    }
}

/// One entry of a report.
#[derive(Debug, Clone, PartialEq)]
enum Entry {
    Number(Quantity),
    /// What is no single number: section, key, value.
    Part(&'static str, &'static str, Box<ReportPart>),
}

impl Entry {
    fn section(&self) -> &'static str {
        match self {
            Self::Number(quantity) => quantity.section,
            Self::Part(section, ..) => section,
        }
    }
}

/// What is known of a contact: quantities and words, in their order.
///
/// As `serde` sees it, `report.json`: keys carry their units, a number that does not exist or is not finite is `null`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    entries: Vec<Entry>,
}

/// Where the next quantities go.
pub(crate) struct Section<'r> {
    report: &'r mut Report,
    name: &'static str,
    shown: Shown,
}

impl Report {
    /// All its numbers.
    pub fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        self.entries.iter().filter_map(|entry| match entry {
            Entry::Number(quantity) => Some(quantity),
            Entry::Part(..) => None,
        })
    }

    /// The one with this section and key, as `contact.normal_force_n`.
    ///
    /// ```
    /// use creepage_study::AnyCaseFile;
    ///
    /// let text = include_str!("../../../../examples/wheel-on-rail.toml");
    /// let solved = AnyCaseFile::read(text)?.case(".".as_ref())?.solve(None)?;
    /// let report = solved.report();
    /// let peak = report.find("contact.peak_pressure_pa").and_then(|peak| peak.value);
    /// assert!(peak.is_some_and(|peak| (peak / 1.1389e9 - 1.0).abs() < 1e-4));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn find(&self, path: &str) -> Option<&Quantity> {
        self.quantities().find(|quantity| quantity.path() == path)
    }

    /// A section whose quantities a text shows in this place.
    pub(crate) fn section(&mut self, name: &'static str, shown: Shown) -> Section<'_> {
        Section { report: self, name, shown }
    }

    /// Adds what is no single number.
    pub(crate) fn part(&mut self, section: &'static str, key: &'static str, words: ReportPart) {
        self.entries.push(Entry::Part(section, key, Box::new(words)));
    }

    /// Rows of a text.
    pub(crate) fn rows(&self, lines: &mut Lines, shown: &[Shown]) {
        for quantity in self.quantities().filter(|quantity| shown.contains(&quantity.shown)) {
            // Only known quantities have a row, and angles other than zero.
            let is_zero = quantity.unit == Unit::Radian && quantity.value == Some(0.0);
            if let (Some(text), false) = (quantity.text(), is_zero) {
                lines.row(quantity.label, &text);
            }
        }
    }

    /// The same with error bars in a column beside.
    pub(crate) fn rows_with_errors(&self, lines: &mut Lines, shown: &[Shown]) {
        for quantity in self.quantities().filter(|quantity| shown.contains(&quantity.shown)) {
            let Some(value) = quantity.text() else { continue };
            match quantity.error {
                Some(0.0) => lines.columns(quantity.label, [&value, "given", ""]),
                Some(error) => {
                    lines.columns(quantity.label, [&value, &quantity.unit.text(error, 2), ""]);
                }
                None => lines.row(quantity.label, &value),
            }
        }
    }
}

impl Section<'_> {
    /// Adds a number.
    pub(crate) fn number(
        &mut self,
        name: &'static str,
        label: &'static str,
        unit: Unit,
        value: impl Into<Option<f64>>,
    ) -> &mut Self {
        self.push(name, label, unit, (value.into(), None), false)
    }

    /// Adds a number with its error bar.
    pub(crate) fn estimate(
        &mut self,
        name: &'static str,
        label: &'static str,
        unit: Unit,
        (value, error): (f64, Option<f64>),
    ) -> &mut Self {
        self.push(name, label, unit, (Some(value), error), true)
    }

    fn push(
        &mut self,
        name: &'static str,
        label: &'static str,
        unit: Unit,
        (value, error): (Option<f64>, Option<f64>),
        has_error: bool,
    ) -> &mut Self {
        let (section, shown) = (self.name, self.shown);
        let quantity = Quantity { section, name, label, unit, value, error, has_error, shown };
        self.report.entries.push(Entry::Number(quantity));
        self
    }
}

impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        SectionView { entries: &self.entries, section: "" }.serialize(serializer)
    }
}

/// A section of a report with those inside it.
struct SectionView<'r> {
    entries: &'r [Entry],
    section: &'r str,
}

impl SectionView<'_> {
    /// The name of the section inside this one that an entry lies in; empty where it lies in this one itself, `None`
    /// where it lies elsewhere.
    fn inner(&self, entry: &Entry) -> Option<&'static str> {
        let rest = entry.section().strip_prefix(self.section)?;
        if self.section.is_empty() || rest.is_empty() {
            return Some(rest.split('.').next().unwrap_or(""));
        }
        rest.strip_prefix('.').map(|rest| rest.split('.').next().unwrap_or(""))
    }
}

impl Serialize for SectionView<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        let mut written: Vec<&str> = Vec::new();
        for entry in self.entries {
            let Some(inner) = self.inner(entry) else { continue };
            match entry {
                _ if !inner.is_empty() => {
                    // A section is written where its first entry stands.
                    if !written.contains(&inner) {
                        written.push(inner);
                        let dot = if self.section.is_empty() { "" } else { "." };
                        let section = format!("{}{dot}{inner}", self.section);
                        map.serialize_entry(
                            inner,
                            &SectionView { entries: self.entries, section: &section },
                        )?;
                    }
                }
                Entry::Number(quantity) => {
                    map.serialize_entry(&quantity.key(), &quantity.value)?;
                    if let Some(key) = quantity.error_key() {
                        map.serialize_entry(&key, &quantity.error)?;
                    }
                }
                Entry::Part(_, key, words) => map.serialize_entry(key, words)?,
            }
        }
        map.end()
    }
}
