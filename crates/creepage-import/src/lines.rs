//! Tokenizer of input files: lines of numbers and words, of which what stands behind the first word is a comment.

use crate::ImportError;

/// A value on a line.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Token {
    Number(f64),
    Name(String),
}

/// A line that has values.
#[derive(Debug, Clone, PartialEq)]
struct Line {
    /// Its number in the file, from 1.
    number: usize,
    tokens: Vec<Token>,
    /// Whether the word that ends its values is a number that is not finite.
    has_odd_number: bool,
    /// What it says, without comments behind `%`.
    text: String,
}

/// The lines that are left.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lines {
    lines: Vec<Line>,
    next: usize,
}

impl Lines {
    pub(crate) fn new(text: &str) -> Self {
        let lines = text.lines().enumerate().filter_map(|(index, line)| {
            let text = without_comment(line).trim();
            let (tokens, has_odd_number) = tokens(text);
            let line = Line { number: index + 1, tokens, has_odd_number, text: text.into() };
            (!text.is_empty()).then_some(line)
        });
        Self { lines: lines.collect(), next: 0 }
    }

    /// The number of the next line.
    pub(crate) fn number(&self) -> usize {
        self.lines.get(self.next).or(self.lines.last()).map_or(1, |line| line.number)
    }

    pub(crate) fn is_at_end(&self) -> bool {
        self.next >= self.lines.len()
    }

    /// How many numbers the next line begins with.
    pub(crate) fn numbers_ahead(&self) -> usize {
        let is_number = |token: &&Token| matches!(token, Token::Number(_));
        self.lines.get(self.next).map_or(0, |line| line.tokens.iter().take_while(is_number).count())
    }

    /// An error at the next line.
    pub(crate) fn expected(&self, expected: &str) -> ImportError {
        match self.lines.get(self.next) {
            Some(line) => ImportError::Line {
                line: line.number,
                expected: expected.into(),
                found: line.text.chars().take(60).collect(),
            },
            None => ImportError::End { expected: expected.into() },
        }
    }

    /// `count` numbers, from one line or several; further ones on the last line come with them.
    pub(crate) fn numbers(&mut self, count: usize, what: &str) -> Result<Vec<f64>, ImportError> {
        let mut values = Vec::new();
        while values.len() < count {
            let expected = || format!("{count} numbers: {what}");
            let Some(line) = self.lines.get(self.next) else {
                return Err(self.expected(&expected()));
            };
            let before = values.len();
            values.extend(line.tokens.iter().map_while(|token| match token {
                Token::Number(number) => Some(*number),
                Token::Name(_) => None,
            }));
            // Words behind numbers are a comment, but for one that is to be a number.
            let is_number = values.len() >= count || !line.has_odd_number;
            if values.len() == before || !is_number {
                return Err(self.expected(&expected()));
            }
            self.next += 1;
        }
        Ok(values)
    }

    /// Exactly these numbers.
    pub(crate) fn array<const N: usize>(&mut self, what: &str) -> Result<[f64; N], ImportError> {
        let values = self.numbers(N, what)?;
        Ok(std::array::from_fn(|index| values.get(index).copied().unwrap_or_default()))
    }

    /// A whole number that is not negative.
    pub(crate) fn count(&mut self, what: &str) -> Result<usize, ImportError> {
        let error = self.expected(&format!("a whole number: {what}"));
        let [value] = self.array(what)?;
        // Grids and lists have some thousands of members.
        if value.fract() == 0.0 && (0.0..1e6).contains(&value) {
            Ok(value as usize)
        } else {
            Err(error)
        }
    }

    /// A word of control digits, the rightmost first.
    pub(crate) fn digits(&mut self, what: &str) -> Result<Digits, ImportError> {
        let error = self.expected(&format!("control digits {what}"));
        let [value] = self.array(what)?;
        if value.fract() == 0.0 && (0.0..1e9).contains(&value) {
            Ok(Digits(value as u64))
        } else {
            Err(error)
        }
    }

    /// The name of a file in quotes, with the numbers behind it.
    pub(crate) fn file(&mut self, what: &str) -> Result<(String, Vec<f64>), ImportError> {
        let expected = format!("the name of a file in quotes: {what}");
        let Some(line) = self.lines.get(self.next) else { return Err(self.expected(&expected)) };
        let Some(Token::Name(name)) = line.tokens.first() else {
            return Err(self.expected(&expected));
        };
        let numbers = line.tokens[1..].iter().map_while(|token| match token {
            Token::Number(number) => Some(*number),
            Token::Name(_) => None,
        });
        let found = (name.clone(), numbers.collect());
        self.next += 1;
        Ok(found)
    }
}

/// Control digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Digits(u64);

impl Digits {
    /// The digit at this place from the right, from 0.
    pub(crate) fn at(self, place: u32) -> u8 {
        (self.0 / 10_u64.pow(place) % 10) as u8
    }
}

fn without_comment(line: &str) -> &str {
    let mut quoted = false;
    for (index, character) in line.char_indices() {
        match character {
            '\'' => quoted = !quoted,
            '%' if !quoted => return &line[..index],
            _ => {}
        }
    }
    line
}

/// No line of a case has as many values.
const MOST_VALUES: usize = 1_000_000;

/// The values of a line, and whether the word that ends them is a number that is not finite.
fn tokens(text: &str) -> (Vec<Token>, bool) {
    let (mut found, mut rest) = (Vec::new(), text);
    loop {
        rest = rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
        if let Some(quoted) = rest.strip_prefix('\'') {
            let Some(end) = quoted.find('\'') else { return (found, false) };
            found.push(Token::Name(quoted[..end].trim().into()));
            rest = &quoted[end + 1..];
            continue;
        }
        let end = rest.find(|c: char| c.is_whitespace() || c == ',').unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        let Some((times, value)) = repeated(word) else {
            return (found, word.parse::<f64>().is_ok_and(|value| !value.is_finite()));
        };
        if found.len() + times > MOST_VALUES {
            return (found, false);
        }
        found.extend(std::iter::repeat_n(Token::Number(value), times));
        rest = after;
    }
}

/// A number, or `3*0.5` for three of them.
fn repeated(word: &str) -> Option<(usize, f64)> {
    match word.split_once('*') {
        Some((times, value)) => {
            let times: usize = times.parse().ok()?;
            (1..=100_000).contains(&times).then_some((times, number(value)?))
        }
        None => Some((1, number(word)?)),
    }
}

/// A number as Fortran writes it; `d` behind an angle means degrees, `r` radians.
fn number(word: &str) -> Option<f64> {
    let word = word.to_ascii_lowercase();
    if !word.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
        return None;
    }
    let value = if let Some(degrees) = word.strip_suffix('d') {
        plain(degrees)?.to_radians()
    } else {
        plain(word.strip_suffix('r').unwrap_or(&word))?
    };
    value.is_finite().then_some(value)
}

fn plain(word: &str) -> Option<f64> {
    let word = word.replace('d', "e");
    if let Ok(value) = word.parse() {
        return Some(value);
    }
    // An exponent without its letter: .1-07.
    let sign = word.rfind(['+', '-']).filter(|place| *place > 0)?;
    let (mantissa, exponent) = word.split_at(sign);
    format!("{mantissa}e{exponent}").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_fortrans() {
        let close = |word: &str, value: f64| {
            let found = number(word).unwrap();
            assert!((found - value).abs() <= 1e-15 * value.abs(), "{word}: {found}");
        };
        close(".25-07", 0.25e-7);
        close("1.5d3", 1500.0);
        close("180.d", std::f64::consts::PI);
        close("-0.1r", -0.1);
        close("2.", 2.0);
        for word in ["MX", "inf", "nan", "1.2.3", "", "-", "d"] {
            assert_eq!(number(word), None, "{word}");
        }
    }

    #[test]
    fn a_comment_ends_the_values_and_lines_go_on() {
        let mut lines = Lines::new("% nothing\n 1 2  A, B 7\n\n3, 4 5 % 6\n 'a%b.prr' 0 1.0 x\n");
        assert_eq!(lines.numbers(4, "four").unwrap(), [1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(lines.file("profile").unwrap(), ("a%b.prr".into(), vec![0.0, 1.0]));
        assert!(matches!(lines.numbers(1, "more"), Err(ImportError::End { .. })));
    }

    /// A number that is not finite is no comment, behind which the next line's numbers would be taken.
    #[test]
    fn a_number_that_is_not_finite_is_an_error() {
        for word in ["nan", "-inf", "Infinity", "1e400"] {
            let mut lines = Lines::new(&format!("1.0 {word} 3.0\n0 MODULE\n"));
            assert!(matches!(lines.numbers(3, "three"), Err(ImportError::Line { line: 1, .. })));
        }
        assert_eq!(Lines::new("1 2 nan\n").numbers(2, "two").unwrap(), [1.0, 2.0]);
    }

    #[test]
    fn digits_count_from_the_right() {
        let mut lines = Lines::new("0203100 C-P-B-T-N-F-S");
        let digits = lines.digits("CPBTNFS").unwrap();
        assert_eq!([6, 5, 4, 3, 2, 1, 0].map(|place| digits.at(place)), [0, 2, 0, 3, 1, 0, 0]);
    }
}
