//! Files give tables back, or are refused.

use creepage::table::{FileError, Table, build};

use super::common::creepage;
use super::fixtures::{FASTSIM, RANGES, fastsim, quiet, spec};

#[test]
fn a_file_gives_the_table_back() {
    for table in [&*FASTSIM, &*RANGES] {
        let again = Table::from_bytes(table.to_bytes().unwrap()).unwrap();
        assert_eq!(again.provenance(), table.provenance());
        assert_eq!(again.accuracy(), table.accuracy());
        assert_eq!(again.intervals(), table.intervals());
        for k in 0..50 {
            let at = creepage(0.1 * f64::from(k), 0.3, -0.7);
            let [one, two] =
                [table, &again].map(|table| table.at(1.0, 0.28).unwrap().force_and_derivative(at));
            assert_eq!(one, two);
        }
    }
}

/// A file of an earlier format, which said nothing of it, or of a later one is refused with the
/// reason.
#[test]
fn a_file_of_another_format_is_refused() {
    let bytes = build(&spec([4, 4, 4], 10), fastsim, &quiet).unwrap().to_bytes().unwrap();
    // Name, padded to four bytes; kind 4, one number, and the number.
    let name = bytes.windows(8).position(|eight| eight == b"format\0\0").unwrap();
    for (at, byte, right) in [(name, b'F', 1), (name + 19, 7, 7)] {
        let mut other = bytes.clone();
        other[at] = byte;
        let body = other.len() - 4;
        let sum = crc32fast::hash(&other[..body]);
        other[body..].copy_from_slice(&sum.to_be_bytes());
        let error = Table::from_bytes(other).unwrap_err();
        assert!(matches!(error, FileError::Format { found } if found == right), "{error}");
        assert!(error.to_string().contains("build the table again"));
    }
}

/// Cut anywhere or with any one bit changed, a file is refused.
#[test]
fn a_damaged_file_is_refused() {
    let small = build(&spec([4, 4, 4], 10), fastsim, &quiet).unwrap();
    let bytes = small.to_bytes().unwrap();
    assert!(Table::from_bytes(bytes.clone()).is_ok());
    for length in (0..bytes.len()).step_by(97) {
        let error = Table::from_bytes(bytes[..length].to_vec()).unwrap_err();
        assert!(matches!(error, FileError::Damaged), "{error}");
    }
    for place in (0..bytes.len()).step_by(53) {
        let mut changed = bytes.clone();
        changed[place] ^= 1 << (place % 8);
        assert!(matches!(Table::from_bytes(changed), Err(FileError::Damaged)));
    }
}
