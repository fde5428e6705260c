//! Record of one solved case, as bytes of a fixed length.

use creepage::{Force, Status};

use super::SeriesRow;
use crate::SweepCase;

/// The statuses by their number in a record.
const STATUSES: [Status; 4] =
    [Status::Solved, Status::NotConverged, Status::CreepageTooSmall, Status::SpinTooLarge];

/// Record of a solved case: its results, and the unknowns from which the next one starts.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Record {
    results: [f64; Record::RESULTS],
    /// The unknowns.
    pub(super) tau: Vec<f64>,
}

impl Record {
    const RESULTS: usize = 11;

    pub(super) fn new(row: &SeriesRow, tau: Vec<f64>) -> Self {
        let status = STATUSES.iter().position(|status| *status == row.status);
        let results = [
            row.force.fx,
            row.force.fy,
            row.force.mz,
            status.unwrap_or(STATUSES.len()) as f64,
            row.iterations as f64,
            row.steps_from_previous as f64,
            row.mean_integrand,
            row.residual,
            row.aberrations as f64,
            row.adhesion_share,
            row.second_start_difference,
        ];
        Self { results, tau }
    }

    pub(super) fn status(&self) -> Status {
        STATUSES.get(whole(self.results[3])).copied().unwrap_or(Status::NotConverged)
    }

    pub(super) fn row(&self, case: &SweepCase) -> SeriesRow {
        let [fx, fy, mz, _, iterations, steps, mean, residual, aberrations, adhesion, second] =
            self.results;
        SeriesRow {
            alpha: case.alpha,
            upsilon: case.upsilon,
            creepage: case.creepage,
            force: Force { fx, fy, mz },
            status: self.status(),
            iterations: whole(iterations),
            steps_from_previous: whole(steps),
            mean_integrand: mean,
            residual,
            aberrations: whole(aberrations),
            adhesion_share: adhesion,
            second_start_difference: second,
        }
    }

    /// Bytes of a record with that number of unknowns, the checksum included.
    pub(super) fn length(unknowns: usize) -> usize {
        8 * (Self::RESULTS + unknowns) + 4
    }

    /// The bytes of the case of that number, ending with their checksum.
    pub(super) fn bytes(&self, index: usize) -> Vec<u8> {
        let numbers = self.results.iter().chain(&self.tau);
        let mut bytes: Vec<u8> = numbers.flat_map(|number| number.to_le_bytes()).collect();
        bytes.extend(checksum(index, &bytes).to_le_bytes());
        bytes
    }

    /// The record of the case of that number, unless the bytes are those of another case, or were
    /// never wholly written.
    pub(super) fn read(index: usize, bytes: &[u8]) -> Option<Self> {
        let (numbers, sum) = bytes.split_last_chunk::<4>()?;
        if checksum(index, numbers).to_le_bytes() != *sum {
            return None;
        }
        let (numbers, _) = numbers.as_chunks::<8>();
        let numbers: Vec<f64> = numbers.iter().copied().map(f64::from_le_bytes).collect();
        let (results, tau) = numbers.split_first_chunk()?;
        Some(Self { results: *results, tau: tau.to_vec() })
    }
}

// The checksum of zeros is not zero: a hole in the file is no record.
fn checksum(index: usize, bytes: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&(index as u64).to_le_bytes());
    hasher.update(bytes);
    hasher.finalize()
}

/// A count that was stored as a number.
// Counts far below 2^53; a checksum guards against anything else.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn whole(number: f64) -> usize {
    number as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_read_back_and_damage_shows() {
        let record = Record { results: [0.1; Record::RESULTS], tau: vec![1.0, -2.5, 1e-300] };
        let bytes = record.bytes(7);
        assert_eq!(bytes.len(), Record::length(3));
        assert_eq!(Record::read(7, &bytes), Some(record));
        assert_eq!(Record::read(8, &bytes), None);
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1;
            assert_eq!(Record::read(7, &damaged), None);
        }
        assert_eq!(Record::read(0, &vec![0; bytes.len()]), None);
        assert_eq!(Record::read(7, &bytes[..3]), None);
    }
}
