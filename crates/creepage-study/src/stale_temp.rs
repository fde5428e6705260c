//! Removal of hidden temporary files that a killed run has left.
//!
//! A run locks its hidden file as soon as it has made it, and then looks whether the file still has its
//! name; another run removes a file only while it has its lock for itself.

use std::fs::File;
#[cfg(unix)]
use std::fs::TryLockError;
use std::path::Path;

/// How the name of a file ends that is being written.
pub(crate) const PARTIAL: &str = ".partial";
/// How the second name of a file ends that is being replaced.
pub(crate) const EARLIER: &str = ".earlier";

/// Holds a hidden file as long as it is open, so that other runs leave it alone; false where another
/// run has removed it before it was held.
#[cfg(unix)]
pub(crate) fn hold(file: &File, path: &Path) -> bool {
    // Where files cannot be locked, `remove` finds none that nobody holds.
    !matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)) && path.exists()
}

/// On Windows a locked file could not be written by its path.
#[cfg(not(unix))]
pub(crate) fn hold(_: &File, _: &Path) -> bool {
    true
}

/// Removes hidden files of `directory` with this prefix that nobody holds.
#[cfg(unix)]
pub(crate) fn remove(directory: &Path, prefix: &str) {
    let Ok(entries) = std::fs::read_dir(directory) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        if name.to_str().is_some_and(|name| is_ours(name, prefix)) {
            remove_abandoned(&entry.path());
        }
    }
}

#[cfg(not(unix))]
pub(crate) fn remove(_: &Path, _: &str) {}

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
fn remove_abandoned(path: &Path) {
    let Ok(file) = File::open(path) else { return };
    // Locked until it has lost its name.
    if file.try_lock().is_ok() {
        let _ = std::fs::remove_file(path);
    }
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
        assert!(hold(&held, &path(".out.held00.partial")));
        remove(place.path(), ".out.");
        assert!(left.iter().all(|name| !path(name).exists()));
        assert!(others.iter().all(|name| path(name).exists()));
        assert!(path(".out.held00.partial").exists());
        drop(held);
        remove(place.path(), ".out.");
        assert!(!path(".out.held00.partial").exists());
    }

    #[test]
    fn a_file_that_another_run_removes_before_it_is_held_is_not_held() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join(".out.AbC123.partial");
        let file = File::create(&path).unwrap();
        // Another run has it for itself, and is about to remove it; then it has.
        let other = File::open(&path).unwrap();
        other.try_lock().unwrap();
        assert!(!hold(&file, &path));
        fs::remove_file(&path).unwrap();
        drop(other);
        assert!(!hold(&file, &path));
    }

    /// Eight at once that write one name and remove what nobody holds: each file is whole.
    #[test]
    fn runs_at_once_do_not_remove_each_others_files() {
        use std::io::Write;
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("out");
        std::thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    for _ in 0..40 {
                        let mut file = crate::WholeFile::create(&path).unwrap();
                        file.write_all(b"whole").unwrap();
                        file.finish().unwrap();
                    }
                });
            }
        });
        assert_eq!(fs::read_to_string(&path).unwrap(), "whole");
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1);
    }
}
