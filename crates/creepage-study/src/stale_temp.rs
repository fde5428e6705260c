//! Hidden files that a killed run has left: nobody holds them any more.

use std::fs::File;
use std::path::Path;
use std::time::Duration;

/// How the name of a file ends that is being written.
pub(crate) const PARTIAL: &str = ".partial";
/// How the second name of a file ends that is being replaced.
pub(crate) const EARLIER: &str = ".earlier";
/// A file younger than this may be one that is about to be held.
pub(crate) const AGE: Duration = Duration::from_secs(10);

/// Holds a hidden file as long as it is open, so that other runs leave it alone.
pub(crate) fn hold(file: &File) {
    // Where files cannot be locked, `remove` finds none that nobody holds. On Windows a locked file
    // could not be written by its path.
    #[cfg(unix)]
    let _ = file.try_lock_shared();
    #[cfg(not(unix))]
    let _ = file;
}

/// Removes hidden files of `directory` with this prefix that nobody holds and that have not changed
/// for so long.
#[cfg(unix)]
pub(crate) fn remove(directory: &Path, prefix: &str, age: Duration) {
    let Ok(entries) = std::fs::read_dir(directory) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        if name.to_str().is_some_and(|name| is_ours(name, prefix))
            && is_abandoned(&entry.path(), age)
        {
            // Another run may have been quicker.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

#[cfg(not(unix))]
pub(crate) fn remove(_: &Path, _: &str, _: Duration) {}

/// Whether a name is the prefix, six letters or digits, and one of the two ends.
#[cfg(unix)]
fn is_ours(name: &str, prefix: &str) -> bool {
    let rest = name.strip_prefix(prefix);
    let random =
        rest.and_then(|rest| rest.strip_suffix(PARTIAL).or_else(|| rest.strip_suffix(EARLIER)));
    random.is_some_and(|random| {
        random.len() == 6 && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

#[cfg(unix)]
fn is_abandoned(path: &Path, age: Duration) -> bool {
    use std::os::unix::fs::MetadataExt;
    use std::time::UNIX_EPOCH;
    let Ok(file) = File::open(path) else { return false };
    let Ok(data) = file.metadata() else { return false };
    // A new name counts as a change; the time of the contents may be older.
    let changed = u64::try_from(data.ctime()).unwrap_or(0);
    let is_old =
        (UNIX_EPOCH + Duration::from_secs(changed)).elapsed().is_ok_and(|since| since >= age);
    is_old && file.try_lock().is_ok()
}

#[cfg(all(test, unix))]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn what_nobody_holds_is_removed() {
        let place = tempfile::tempdir().unwrap();
        let path = |name: &str| place.path().join(name);
        let left = [".out.AbC123.partial", ".out.xyz789.earlier"];
        let others = [".out.csv.AbC123.partial", ".out.long-name.partial", ".out.AbC123", "out"];
        for name in left.iter().chain(&others) {
            fs::write(path(name), "").unwrap();
        }
        let held = File::create(path(".out.held00.partial")).unwrap();
        hold(&held);
        remove(place.path(), ".out.", AGE);
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 7, "all are young");
        remove(place.path(), ".out.", Duration::ZERO);
        assert!(left.iter().all(|name| !path(name).exists()));
        assert!(others.iter().all(|name| path(name).exists()));
        assert!(path(".out.held00.partial").exists());
        drop(held);
        remove(place.path(), ".out.", Duration::ZERO);
        assert!(!path(".out.held00.partial").exists());
    }
}
