//! Files that someone or something has damaged.

use creepage_rail::file::{read, write};
use creepage_rail::{Profile, Standard};
use proptest::prelude::*;

use super::{FORMATS, wanted};

/// One change of a file's text.
#[derive(Debug, Clone)]
enum Change {
    Byte(usize, u8),
    Delete(usize, usize),
    Repeat(usize, usize),
    Swap(usize, usize),
    Scale(usize, f64),
    Cut(usize),
}

fn change() -> impl Strategy<Value = Change> {
    let at = 0usize..20_000;
    let length = 1usize..60;
    prop_oneof![
        (at.clone(), any::<u8>()).prop_map(|(i, b)| Change::Byte(i, b)),
        (at.clone(), length.clone()).prop_map(|(i, n)| Change::Delete(i, n)),
        (at.clone(), length).prop_map(|(i, n)| Change::Repeat(i, n)),
        (0usize..300, 0usize..300).prop_map(|(i, j)| Change::Swap(i, j)),
        (0usize..300, prop_oneof![Just(25.4), Just(-1.0), Just(1e-3), Just(1e3), Just(f64::NAN)])
            .prop_map(|(i, f)| Change::Scale(i, f)),
        at.prop_map(Change::Cut),
    ]
}

fn changed(text: &[u8], change: &Change) -> Vec<u8> {
    let mut lines: Vec<Vec<u8>> = text.split(|b| *b == b'\n').map(<[u8]>::to_vec).collect();
    let (count, size) = (lines.len(), text.len().max(1));
    let mut bytes = text.to_vec();
    match *change {
        Change::Byte(i, byte) => bytes.splice(i % size..i % size, [byte]).for_each(drop),
        Change::Delete(i, n) => {
            bytes.drain(i % size..(i % size + n).min(bytes.len())).for_each(drop);
        }
        Change::Repeat(i, n) => {
            let part = bytes[i % size..(i % size + n).min(bytes.len())].to_vec();
            bytes.splice(i % size..i % size, part).for_each(drop);
        }
        Change::Cut(i) => bytes.truncate(i % size),
        Change::Swap(i, j) => {
            lines.swap(i % count, j % count);
            bytes = lines.join(&b'\n');
        }
        Change::Scale(i, factor) => {
            let line = String::from_utf8_lossy(&lines[i % count]).into_owned();
            let scaled = line.split_whitespace().map(|word| {
                word.parse::<f64>().map_or(word.to_owned(), |value| (value * factor).to_string())
            });
            lines[i % count] = scaled.collect::<Vec<_>>().join(" ").into_bytes();
            bytes = lines.join(&b'\n');
        }
    }
    bytes
}

/// A profile that came out of a broken file: finite, of sane length, the right way round.
fn sane(profile: &Profile) -> bool {
    let curve = profile.curve();
    let finite = curve
        .stations(1e-3)
        .into_iter()
        .map(|s| curve.at(s))
        .all(|point| point.y.is_finite() && point.z.is_finite() && point.curvature.is_finite());
    // A spline is longer than its points by no more than its swing.
    finite && (0.0049..1.0).contains(&curve.length())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2500, ..ProptestConfig::default() })]

    /// Mutated files: an error with its line, or a sane profile; 30,000 of them.
    #[test]
    fn mutated_files_never_panic(changes in prop::collection::vec(change(), 1..5)) {
        for (index, (format, names)) in FORMATS.into_iter().enumerate() {
            for (role, standard) in [(0, Standard::Uic60), (1, Standard::S1002)] {
                let text = write(&standard.profile(), format, 1.5e-3 + 1e-4 * index as f64);
                let text = changes.iter().fold(text.into_bytes(), |t, c| changed(&t, c));
                match read(names[role], &text, &wanted(standard.role())) {
                    Ok(found) => prop_assert!(sane(&found.profile), "{changes:?}"),
                    Err(error) => prop_assert!(error.to_string().contains("line "), "{error}"),
                }
            }
        }
    }
}
