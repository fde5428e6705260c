//! Journal of a map's build: records that are appended to a file, each with its checksum. Whatever ends the process,
//! only what is in hand is lost.

use std::collections::HashMap;
use std::fs::{File, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use creepage_map::{Ellipse, Patch, Sloped};
use creepage_rail::Side;

use super::MapBuildError;
use super::heights::PressedPlace;
use crate::sources::keep_foreign;

const MAGIC: &[u8; 16] = b"creepage map 3\r\n";
/// What records mean: another word for any change, after which a build begins from nothing.
const RECORDS: &str = "heights at rolls and yaws";
/// Numbers of a patch without slopes.
const PATCH: usize = 4 + 6 + 2 * 8;

/// A kind of record, with its side and its place: 0 for heights, 1 for rolling nodes, 2 for their slopes.
type Key = (u8, i64);

/// The journal of one build; in memory alone where there is no file.
#[derive(Debug)]
pub(super) struct Journal {
    path: PathBuf,
    file: Option<Mutex<File>>,
    known: HashMap<Key, Vec<f64>>,
}

impl Journal {
    /// Opens the journal of an earlier run of the same build, `words`, or begins a new one. A file that is no
    /// journal stays as it is.
    pub(super) fn open(path: Option<&Path>, words: &str) -> Result<Self, MapBuildError> {
        let Some(path) = path else {
            return Ok(Self { path: PathBuf::new(), file: None, known: HashMap::new() });
        };
        let failed = |source| MapBuildError::Journal { path: path.into(), source };
        keep_foreign(path, MAGIC).map_err(failed)?;
        let options = File::options().read(true).write(true).create(true).truncate(false).clone();
        let mut file = options.open(path).map_err(failed)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(MapBuildError::Busy { path: path.into() }),
            Err(TryLockError::Error(error)) => return Err(failed(error)),
        }
        let words = format!("{} {RECORDS} {words}", env!("CARGO_PKG_VERSION"));
        let head = [&MAGIC[..], &crc32fast::hash(words.as_bytes()).to_le_bytes()].concat();
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(failed)?;
        let (known, end) = match bytes.strip_prefix(&head[..]) {
            Some(rest) => read(rest),
            None => (HashMap::new(), 0),
        };
        let end = if bytes.starts_with(&head) { head.len() + end } else { 0 };
        let mut start = || -> io::Result<()> {
            file.set_len(end as u64)?;
            file.seek(SeekFrom::Start(end as u64))?;
            if end == 0 { file.write_all(&head) } else { Ok(()) }
        };
        start().map_err(failed)?;
        Ok(Self { path: path.into(), file: Some(Mutex::new(file)), known })
    }

    fn write(&self, key: Key, numbers: &[f64]) -> Result<(), MapBuildError> {
        let Some(file) = &self.file else { return Ok(()) };
        let mut record = vec![key.0];
        record.extend(key.1.to_le_bytes());
        record.extend(u32::try_from(numbers.len()).unwrap_or(0).to_le_bytes());
        record.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
        record.extend(crc32fast::hash(&record).to_le_bytes());
        let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
        let failed = |source| MapBuildError::Journal { path: self.path.clone(), source };
        file.write_all(&record).map_err(failed)
    }

    /// Heights at a place, or that there are none; built where they are not known.
    pub(super) fn heights(
        &self,
        (side, place): (Side, i32),
        build: impl FnOnce() -> Result<Option<PressedPlace>, MapBuildError>,
    ) -> Result<Option<PressedPlace>, MapBuildError> {
        let key = (u8::from(side == Side::Right), i64::from(place));
        if let Some(numbers) = self.known.get(&key) {
            return Ok(PressedPlace::of_numbers(numbers));
        }
        let built = build()?;
        let numbers = built.as_ref().map_or_else(Vec::new, PressedPlace::numbers);
        self.write(key, &numbers)?;
        Ok(built)
    }

    /// The patches of a node under each load; built where they are not known.
    pub(super) fn node(
        &self,
        (side, place): (Side, i64),
        build: impl FnOnce() -> Result<Vec<Vec<Patch>>, MapBuildError>,
    ) -> Result<Vec<Vec<Patch>>, MapBuildError> {
        let key = (2 + u8::from(side == Side::Right), place);
        if let Some(loads) = self.known.get(&key).and_then(|numbers| node(numbers)) {
            return Ok(loads);
        }
        let built = build()?;
        let mut numbers = Vec::new();
        for patches in &built {
            numbers.push(patches.len() as f64);
            numbers.extend(patches.iter().flat_map(patch_numbers));
        }
        self.write(key, &numbers)?;
        Ok(built)
    }

    /// Slopes by place of the geometry of a node's contacts (share, angle, y, z), one after the other, or none;
    /// built where they are not known.
    pub(super) fn slopes(
        &self,
        (side, place): (Side, i64),
        build: impl FnOnce() -> Result<Vec<f64>, MapBuildError>,
    ) -> Result<Vec<f64>, MapBuildError> {
        let key = (4 + u8::from(side == Side::Right), place);
        if let Some(numbers) = self.known.get(&key) {
            return Ok(numbers.clone());
        }
        let built = build()?;
        self.write(key, &built)?;
        Ok(built)
    }
}

/// Records up to the first that is not whole, and where they end.
fn read(bytes: &[u8]) -> (HashMap<Key, Vec<f64>>, usize) {
    let (mut known, mut at) = (HashMap::new(), 0);
    while let Some((key, numbers, length)) = bytes.get(at..).and_then(record) {
        known.insert(key, numbers);
        at += length;
    }
    (known, at)
}

fn record(bytes: &[u8]) -> Option<(Key, Vec<f64>, usize)> {
    let (kind, rest) = bytes.split_first()?;
    let (place, rest) = rest.split_first_chunk::<8>()?;
    let (count, rest) = rest.split_first_chunk::<4>()?;
    let size = 8 * usize::try_from(u32::from_le_bytes(*count)).ok()?;
    let sum = rest.get(size..size + 4)?;
    let length = 13 + size;
    if crc32fast::hash(bytes.get(..length)?).to_le_bytes() != sum {
        return None;
    }
    let numbers = rest[..size].as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes));
    Some(((*kind, i64::from_le_bytes(*place)), numbers.collect(), length + 4))
}

fn node(numbers: &[f64]) -> Option<Vec<Vec<Patch>>> {
    let mut loads = Vec::new();
    let mut rest = numbers;
    while let Some((count, after)) = rest.split_first() {
        rest = after;
        let mut patches = Vec::new();
        let mut left = *count;
        while left >= 1.0 {
            let (numbers, after) = rest.split_first_chunk::<PATCH>()?;
            patches.push(patch(numbers));
            rest = after;
            left -= 1.0;
        }
        loads.push(patches);
    }
    Some(loads)
}

fn patch_numbers(patch: &Patch) -> Vec<f64> {
    let [x, s] = patch.centroid;
    let mut all = vec![patch.share.value, patch.angle.value, patch.y.value, patch.z.value];
    all.extend([patch.approach, x, s, patch.peak_pressure, patch.area, patch.residual]);
    for Ellipse { ratio, by_creepage, by_spin, offset, weight, moment, .. } in patch.ellipses {
        all.extend([ratio, by_creepage, by_spin, offset, weight].into_iter().chain(moment));
    }
    all
}

fn patch(all: &[f64; PATCH]) -> Patch {
    let ellipse = |k: usize| Ellipse {
        ratio: all[k],
        by_creepage: all[k + 1],
        by_spin: all[k + 2],
        offset: all[k + 3],
        weight: all[k + 4],
        moment: [all[k + 5], all[k + 6], all[k + 7]],
        ..Ellipse::default()
    };
    Patch {
        share: Sloped::level(all[0]),
        angle: Sloped::level(all[1]),
        y: Sloped::level(all[2]),
        z: Sloped::level(all[3]),
        approach: all[4],
        centroid: [all[5], all[6]],
        peak_pressure: all[7],
        area: all[8],
        residual: all[9],
        ellipses: [ellipse(10), ellipse(18)],
    }
}
