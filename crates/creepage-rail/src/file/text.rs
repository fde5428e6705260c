//! Decoding of a file's text: its encoding, its ends of lines, its decimal commas.

use super::Action;
use super::rows::{lines, uncommented};

/// The text of a file by its byte order mark, or by its zeros: UTF-8, or UTF-16. Bytes that are neither become the
/// replacement character.
///
/// ```
/// assert_eq!(creepage_rail::file::unicode(b"\xEF\xBB\xBF1 2\n"), "1 2\n");
/// ```
#[must_use]
pub fn unicode(content: &[u8]) -> String {
    match utf16_order(content) {
        Some(unit) => {
            let units: Vec<u16> = content.as_chunks().0.iter().map(|pair| unit(*pair)).collect();
            String::from_utf16_lossy(&units).trim_start_matches('\u{feff}').to_owned()
        }
        None => String::from_utf8_lossy(content).trim_start_matches('\u{feff}').to_owned(),
    }
}

/// The text of a file, and what had to be done to read it.
pub(super) fn decoded(content: &[u8], actions: &mut Vec<Action>) -> String {
    let text = unicode(content);
    actions.extend(utf16_order(content).map(|_| Action::Utf16));
    let text = if text.contains('\n') { text } else { text.replace('\r', "\n") };
    if !has_decimal_commas(&text) {
        return text;
    }
    actions.push(Action::DecimalCommas);
    with_points(&text)
}

/// How two bytes of UTF-16 make a unit.
fn utf16_order(content: &[u8]) -> Option<fn([u8; 2]) -> u16> {
    match content {
        [0xFF, 0xFE, ..] => Some(u16::from_le_bytes),
        [0xFE, 0xFF, ..] => Some(u16::from_be_bytes),
        _ => match zeros(content) {
            [few, many] if many > 4 * few => Some(u16::from_le_bytes),
            [many, few] if many > 4 * few => Some(u16::from_be_bytes),
            _ => None,
        },
    }
}

/// How many bytes are zero at even and at odd places, of a quarter of all at least: of Latin
/// letters in UTF-16 every second byte is.
fn zeros(content: &[u8]) -> [usize; 2] {
    let count = |start: usize| content.iter().skip(start).step_by(2).filter(|b| **b == 0).count();
    let both = [count(0), count(1)];
    if both[0] + both[1] > content.len() / 4 { both } else { [0, 0] }
}

/// Whether commas stand for decimal points: rows of numbers have no point, and commas only
/// between digits, with something else between the numbers.
fn has_decimal_commas(text: &str) -> bool {
    let rows = lines(text).map(|(_, row)| uncommented(row, &['#', '%', '!'])).filter(|row| {
        row.contains(|c: char| c.is_ascii_digit())
            && row.chars().all(|c| "0123456789+-.,;eE \t".contains(c))
    });
    let (mut all, mut decimal) = (0, 0);
    for row in rows {
        if row.contains('.') {
            return false;
        }
        let fields: Vec<&str> = fields(row).collect();
        if fields.len() > 1 && fields.iter().any(|field| is_decimal(field)) {
            decimal += 1;
        }
        // "1,-2" and "1, 2" are two numbers.
        if fields.iter().any(|field| field.contains(',') && !is_decimal(field)) {
            return false;
        }
        all += 1;
    }
    decimal > all / 2
}

fn fields(row: &str) -> impl Iterator<Item = &str> {
    row.split(|c: char| c.is_whitespace() || c == ';').filter(|field| !field.is_empty())
}

/// One comma between digits.
fn is_decimal(field: &str) -> bool {
    field.split_once(',').is_some_and(|(whole, rest)| {
        whole.ends_with(|c: char| c.is_ascii_digit())
            && rest.starts_with(|c: char| c.is_ascii_digit())
            && !rest.contains(',')
    })
}

/// The text with points for its decimal commas.
fn with_points(text: &str) -> String {
    let next = text.chars().skip(1).map(Some).chain([None]);
    let mut before = ' ';
    text.chars()
        .zip(next)
        .map(|(here, after)| {
            let is_inside = before.is_ascii_digit() && after.is_some_and(|c| c.is_ascii_digit());
            before = here;
            if here == ',' && is_inside { '.' } else { here }
        })
        .collect()
}
