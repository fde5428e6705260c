//! A quantity of a report, and the report: quantities and words in their order, as text and as JSON.

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::part::ReportPart;
use super::unit::{Unit, Written};
use crate::text::Lines;

/// Row of a text that shows a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shown {
    /// Under the contact, or what is reported first.
    Contact,
    /// The same, where nothing but the contact is reported.
    ContactAlone,
    /// Under the motion or the creepage.
    Motion,
    /// Under the force.
    Force,
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
    pub(crate) written: Written,
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
        self.value.map(|value| self.written.text(self.unit, value))
    }

    /// Its value in its SI unit, to so many significant digits.
    pub(crate) fn text_to(&self, digits: usize) -> Option<String> {
        self.value.map(|value| Written::Prefixed(digits).text(self.unit, value))
    }

    /// Its error bar with its unit, for people.
    fn error_text(&self) -> Option<String> {
        self.error.map(|error| self.written.error(self.unit, error))
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

/// Quantities and words of a contact, in their order.
///
/// As `serde` sees it, `report.json`: keys carry their units, a number that does not exist or is not finite is `null`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    entries: Vec<Entry>,
}

/// Section of the next quantities.
pub(crate) struct Section<'r> {
    report: &'r mut Report,
    name: &'static str,
    shown: Shown,
    written: Written,
}

impl Report {
    /// All its numbers by their paths, those of the parts that it lists included: `contact.normal_force_n`,
    /// `left.patches.0.normal_force_n`.
    #[must_use]
    pub fn quantities(&self) -> Vec<(String, &Quantity)> {
        let mut all = Vec::new();
        self.collect("", &mut all);
        all
    }

    fn collect<'r>(&'r self, before: &str, all: &mut Vec<(String, &'r Quantity)>) {
        for entry in &self.entries {
            match entry {
                Entry::Number(quantity) => {
                    all.push((format!("{before}{}", quantity.path()), quantity));
                }
                Entry::Part(section, key, part) => {
                    let dot = if section.is_empty() { "" } else { "." };
                    for (place, report) in part.reports() {
                        let place = place.map_or(String::new(), |k| format!(".{k}"));
                        report.collect(&format!("{before}{section}{dot}{key}{place}."), all);
                    }
                }
            }
        }
    }

    /// Its own numbers, without those of the parts that it lists.
    pub(crate) fn own(&self) -> impl Iterator<Item = &Quantity> {
        self.entries.iter().filter_map(|entry| match entry {
            Entry::Number(quantity) => Some(quantity),
            Entry::Part(..) => None,
        })
    }

    /// Its own numbers of one section.
    pub(crate) fn of_section(&self, section: &str) -> impl Iterator<Item = &Quantity> {
        self.own().filter(move |one| one.section == section)
    }

    /// The number with this path, as `contact.normal_force_n`.
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
        self.quantities().into_iter().find_map(|(own, quantity)| (own == path).then_some(quantity))
    }

    /// A section whose quantities a text shows in this place.
    pub(crate) fn section(&mut self, name: &'static str, shown: Shown) -> Section<'_> {
        Section { report: self, name, shown, written: Written::USUAL }
    }

    /// A section of a problem without rolling: numbers in SI units with prefixes.
    pub(crate) fn statics(&mut self, name: &'static str) -> Section<'_> {
        let written = Written::Prefixed(5);
        Section { report: self, name, shown: Shown::Nowhere, written }
    }

    /// Adds what another report lists.
    pub(crate) fn append(&mut self, other: &Self) {
        self.entries.extend(other.entries.iter().cloned());
    }

    /// Adds what is no single number.
    pub(crate) fn part(&mut self, section: &'static str, key: &'static str, words: ReportPart) {
        self.entries.push(Entry::Part(section, key, Box::new(words)));
    }

    /// Rows of a text: of known quantities.
    pub(crate) fn rows(&self, lines: &mut Lines, shown: Shown) {
        for quantity in self.own().filter(|quantity| quantity.shown == shown) {
            if let Some(text) = quantity.text() {
                lines.row(quantity.label, &text);
            }
        }
    }

    /// The same with error bars in a column beside.
    pub(crate) fn rows_with_errors(&self, lines: &mut Lines, shown: Shown) {
        for quantity in self.own().filter(|quantity| quantity.shown == shown) {
            let Some(value) = quantity.text() else { continue };
            match (quantity.error, quantity.error_text()) {
                (Some(0.0), _) => lines.columns(quantity.label, [&value, "given", ""]),
                (_, Some(error)) => lines.columns(quantity.label, [&value, &error, ""]),
                (_, None) => lines.row(quantity.label, &value),
            }
        }
    }

    /// Three of its own quantities side by side, by their paths; an empty path leaves a column empty.
    pub(crate) fn columns(&self, lines: &mut Lines, name: &str, paths: [&str; 3]) {
        let text = |path: &str| self.own().find(|one| one.path() == path)?.text();
        let [x, y, z] = paths.map(|path| text(path).unwrap_or_default());
        lines.columns(name, [&x, &y, &z]);
    }

    /// Their error bars, where the first has one.
    pub(crate) fn error_columns(&self, lines: &mut Lines, name: &str, paths: [&str; 3]) {
        let text = |path: &str| self.own().find(|one| one.path() == path)?.error_text();
        if let [Some(x), y, z] = paths.map(text) {
            lines.columns(name, [&x, &y.unwrap_or_default(), &z.unwrap_or_default()]);
        }
    }
}

impl Section<'_> {
    /// Where a text shows the quantities that follow.
    pub(crate) fn shown(&mut self, shown: Shown) -> &mut Self {
        self.shown = shown;
        self
    }

    /// How a text writes the quantities that follow.
    pub(crate) fn written(&mut self, written: Written) -> &mut Self {
        self.written = written;
        self
    }

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
        let (section, shown, written) = (self.name, self.shown, self.written);
        let quantity =
            Quantity { section, name, label, unit, value, error, has_error, shown, written };
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
