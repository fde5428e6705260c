//! Reader of lists of slices of the program CONTACT (`.slcs` of rails, `.slcw` of wheels), by its public user guide:
//! offset and scale of the places, counts, then places with names of profiles, then arc lengths of features.

use crate::Role;

/// A list of slices in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct SliceList {
    /// Place along the track (m) or angle around the wheel (rad), name of the profile's file beside the list, and
    /// arc lengths of the features (m), negative where absent.
    pub slices: Vec<(f64, String, Vec<f64>)>,
    /// Features, from 1, along which the surface has an edge.
    pub kinks: Vec<usize>,
    /// Whether the surface is to go near the slices only, and not through them.
    pub approximates: bool,
    /// How many parts are to have a jump of curvature along the track.
    pub accelerations: usize,
}

/// Error of a list that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SliceListError {
    /// A line that is not what should stand there.
    #[error("line {line}: expected {expected}, found `{found}`")]
    Line {
        /// Its number, from 1.
        line: usize,
        /// What should stand there.
        expected: &'static str,
        /// What stands there.
        found: String,
    },
    /// The file ends early.
    #[error("the file ends where {expected} should stand")]
    End {
        /// What should stand there.
        expected: &'static str,
    },
    /// A feature's line for another place than its slice.
    #[error("line {line}: features at {found}, but the slice there is at {expected}")]
    Place {
        /// Its number, from 1.
        line: usize,
        /// The slice's place, as the file has it.
        expected: String,
        /// What stands there.
        found: String,
    },
}

/// Lines with values, comments behind `%` left out.
struct ListLines<'t> {
    lines: Vec<(usize, &'t str)>,
    next: usize,
}

impl<'t> ListLines<'t> {
    fn next(&mut self, expected: &'static str) -> Result<(usize, &'t str), SliceListError> {
        let line = self.lines.get(self.next).copied();
        self.next += 1;
        line.ok_or(SliceListError::End { expected })
    }

    /// The numbers with which the next line begins, `count` at least.
    fn numbers(
        &mut self,
        count: usize,
        expected: &'static str,
    ) -> Result<(usize, Vec<f64>), SliceListError> {
        let (line, text) = self.next(expected)?;
        let words = text.split(|c: char| c.is_whitespace() || c == ',').filter(|w| !w.is_empty());
        let numbers: Vec<f64> =
            words.map_while(|word| word.parse().ok()).filter(|n: &f64| n.is_finite()).collect();
        if numbers.len() < count {
            return Err(wrong(line, expected, text));
        }
        Ok((line, numbers))
    }

    fn count(&mut self, expected: &'static str) -> Result<usize, SliceListError> {
        let (line, numbers) = self.numbers(1, expected)?;
        let value = numbers.first().copied().unwrap_or(0.0);
        if value.fract() == 0.0 && (0.0..=1e5).contains(&value) {
            return Ok(crate::curve::whole(value));
        }
        Err(wrong(line, expected, &value.to_string()))
    }
}

fn wrong(line: usize, expected: &'static str, found: &str) -> SliceListError {
    SliceListError::Line { line, expected, found: found.chars().take(60).collect() }
}

impl SliceList {
    /// Reads a list of a rail's or a wheel's slices.
    ///
    /// ```
    /// use creepage_rail::{Role, file::SliceList};
    /// let text = "0 1 offset, scale\n 2 slices\n 0 0 0\n 1\n 100 'a.prr'\n 200 'b.prr'\n";
    /// let list = SliceList::read(text, Role::Rail)?;
    /// assert_eq!(list.slices[1], (0.2, "b.prr".to_owned(), vec![]));
    /// # Ok::<(), creepage_rail::file::SliceListError>(())
    /// ```
    ///
    /// # Errors
    /// [`SliceListError`] with the line and what was expected there.
    pub fn read(text: &str, role: Role) -> Result<Self, SliceListError> {
        // A rail's places are given in mm, a wheel's angles in rad.
        let unit = if role == Role::Rail { 1e-3 } else { 1.0 };
        let lines = text.lines().enumerate().filter_map(|(index, line)| {
            let line = line.split('%').next().unwrap_or_default().trim();
            (!line.is_empty()).then_some((index + 1, line))
        });
        let mut lines = ListLines { lines: lines.collect(), next: 0 };
        let (_, first) = lines.numbers(2, "offset and scale of the places")?;
        let [offset, scale] = [0, 1].map(|k: usize| first.get(k).copied().unwrap_or(0.0));
        let count = lines.count("the number of slices")?;
        let counts = "the numbers of features, kinks and accelerations";
        let (line, numbers) = lines.numbers(3, counts)?;
        if numbers.iter().take(3).any(|n| n.fract() != 0.0 || !(0.0..=1e3).contains(n)) {
            return Err(wrong(line, counts, &format!("{numbers:?}")));
        }
        let [features, kinks, accelerations] =
            [0, 1, 2].map(|k: usize| crate::curve::whole(numbers.get(k).copied().unwrap_or(0.0)));
        let (_, kind) = lines.numbers(1, "the kind of interpolation, 1 or 2")?;
        let approximates = kind.first().is_some_and(|kind| *kind >= 2.0);
        let mut slices = Vec::new();
        let mut places = Vec::new();
        for _ in 0..count {
            let expected = "a slice's place and the name of its profile in quotes";
            let (line, text) = lines.next(expected)?;
            let (place, name) = text.split_once(['\'', '"']).ok_or(wrong(line, expected, text))?;
            let name = name.split(['\'', '"']).next().unwrap_or_default().replace('\\', "/");
            let place: f64 = place.trim().parse().map_err(|_| wrong(line, expected, text))?;
            places.push(place);
            slices.push(((offset + place) * scale * unit, name, Vec::new()));
        }
        let mut edges = Vec::new();
        if kinks > 0 {
            let (_, parts) = lines.numbers(kinks, "parts with a kink to the next")?;
            let part = |part: &f64| crate::curve::whole(part.abs()) + 1;
            edges = parts.iter().take(kinks).map(part).collect();
        }
        if accelerations > 0 {
            lines.numbers(accelerations, "parts with an acceleration to the next")?;
        }
        if features >= 2 {
            for (slice, place) in slices.iter_mut().zip(&places) {
                let (line, numbers) =
                    lines.numbers(features + 1, "a slice's place and its features")?;
                let at = numbers.first().copied().unwrap_or(f64::NAN);
                if (at - place).abs() > 1e-4 * (1.0 + place.abs()) {
                    let [expected, found] = [*place, at].map(|value| value.to_string());
                    return Err(SliceListError::Place { line, expected, found });
                }
                slice.2 = numbers.iter().skip(1).take(features).map(|s| s * 1e-3).collect();
            }
        }
        Ok(Self { slices, kinks: edges, approximates, accelerations })
    }
}
