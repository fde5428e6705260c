//! Set of files that appear together: each is written beside its target, then all are renamed, or none.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, TempPath};

use crate::atomic_file::{WholeFile, directory_of, sync_directory_of};
use crate::error::ReportError;
use crate::sources::Sources;
use crate::stale_temp;

/// Writes files, by name and contents, into `directory`, which is made when missing: all of them
/// or none. Files of those names are replaced, but none of `sources`. Gives the paths written.
///
/// # Errors
/// [`ReportError::OverSource`]; [`ReportError::Write`]: what was there before is there again, as far
/// as the file system has hard links.
pub fn write_all(
    directory: &Path,
    files: &[(&str, &[u8])],
    sources: &Sources,
) -> Result<Vec<PathBuf>, ReportError> {
    for (name, _) in files {
        sources.ensure_not_overwritten(&directory.join(name))?;
    }
    let mut made = Made::default();
    made.directory(directory).map_err(failure(directory))?;
    let mut whole = Vec::new();
    for (name, contents) in files {
        let path = directory.join(name);
        whole.push((written(&path, contents).map_err(failure(&path))?, path));
    }
    let (mut paths, mut targets) = (Vec::new(), Vec::new());
    for (file, path) in whole {
        targets.extend(made.file(file, &path).map_err(failure(&path))?);
        paths.push(path);
    }
    // After the last name, so that there is little time in which some are new and some are not.
    for target in targets {
        sync_directory_of(&target).map_err(failure(&target))?;
    }
    made.keep();
    Ok(paths)
}

fn failure(path: &Path) -> impl FnOnce(io::Error) -> ReportError {
    move |source| ReportError::Write { path: path.into(), source }
}

/// A file with these contents, on the disk but for its name.
fn written(path: &Path, contents: &[u8]) -> io::Result<WholeFile> {
    let mut file = WholeFile::create(path)?;
    file.write_all(contents)?;
    file.sync()?;
    Ok(file)
}

/// What [`write_all`] has made so far; dropped before [`Made::keep`], it is undone.
#[derive(Default)]
struct Made {
    directories: Vec<PathBuf>,
    /// Each new file, and a second name of the one that it replaced.
    files: Vec<(PathBuf, Earlier)>,
}

/// What stood where a new file stands now.
enum Earlier {
    Nothing,
    File {
        link: TempPath,
        /// Open, so that other runs leave the link alone.
        _held: File,
    },
    /// A file on a system without hard links, or a device.
    Lost,
}

impl Made {
    fn directory(&mut self, directory: &Path) -> io::Result<()> {
        let missing =
            directory.ancestors().take_while(|d| !d.as_os_str().is_empty() && !d.exists());
        self.directories = missing.map(Path::to_path_buf).collect();
        fs::create_dir_all(directory)
    }

    /// Gives a file its name, which it returns.
    fn file(&mut self, file: WholeFile, path: &Path) -> io::Result<Option<PathBuf>> {
        let earlier = Earlier::at(&file);
        let target = file.name()?;
        self.files.push((path.into(), earlier));
        Ok(target)
    }

    fn keep(mut self) {
        self.files.clear();
        self.directories.clear();
    }
}

impl Earlier {
    fn at(file: &WholeFile) -> Self {
        match file.earlier() {
            Some(target) => Self::keep(target).unwrap_or(Self::Lost),
            None if file.is_in_place() => Self::Lost,
            None => Self::Nothing,
        }
    }

    /// A second name of a file.
    fn keep(target: &Path) -> io::Result<Self> {
        let name = target.file_name().unwrap_or_default().to_string_lossy();
        let prefix = format!(".{name}.");
        let mut builder = Builder::new();
        builder.prefix(&prefix).suffix(stale_temp::EARLIER);
        let mut attempts = 0;
        loop {
            let link = builder
                .make_in(directory_of(target), |link| fs::hard_link(target, link))?
                .into_temp_path();
            // Another run may have removed it before it is held.
            let file = match File::open(&link) {
                Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
                opened => opened?,
            };
            // A lock that does not go is one of a stranger, on the file itself.
            attempts += 1;
            if stale_temp::hold(&file, &link) || attempts == 100 {
                return Ok(Self::File { link, _held: file });
            }
        }
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        // Best effort: what cannot be undone is in use by others.
        for (path, earlier) in self.files.drain(..) {
            let _ = match earlier {
                Earlier::File { link, .. } => link.persist(path).map_err(|failed| failed.error),
                Earlier::Nothing => fs::remove_file(path),
                Earlier::Lost => Ok(()),
            };
        }
        for directory in &self.directories {
            let _ = fs::remove_dir(directory);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(directory: &Path) -> Vec<String> {
        let entries = fs::read_dir(directory).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn several_files_are_all_replaced_or_none() {
        let place = tempfile::tempdir().unwrap();
        let files: [(&str, &[u8]); 2] = [("one", b"1"), ("two", b"2")];
        write_all(place.path(), &files, &Sources::default()).unwrap();
        fs::create_dir(place.path().join("way")).unwrap();
        let failing: [(&str, &[u8]); 3] = [("one", b"new"), ("three", b"3"), ("way", b"")];
        assert!(write_all(place.path(), &failing, &Sources::default()).is_err());
        // The directory comes in the way after the files were written, before they are named.
        let mut made = Made::default();
        let late = place.path().join("late");
        let path = |name: &str| place.path().join(name);
        for (name, contents) in &failing[..2] {
            made.file(written(&path(name), contents).unwrap(), &path(name)).unwrap();
        }
        assert_eq!(fs::read(path("one")).unwrap(), b"new");
        let file = written(&late, b"late").unwrap();
        fs::create_dir(&late).unwrap();
        assert!(made.file(file, &late).is_err());
        drop(made);
        assert_eq!(names(place.path()), ["late", "one", "two", "way"]);
        assert_eq!(fs::read(path("one")).unwrap(), b"1");
    }

    #[test]
    fn new_directories_go_again_after_a_failure() {
        let place = tempfile::tempdir().unwrap();
        let new = place.path().join("new/deep");
        let bad: [(&str, &[u8]); 2] = [("good", b"1"), ("no/such", b"2")];
        let error = write_all(&new, &bad, &Sources::default()).unwrap_err();
        assert!(matches!(error, ReportError::Write { path, .. } if path.ends_with("no/such")));
        assert!(names(place.path()).is_empty());
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_links_are_those_of_any_file() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let place = tempfile::tempdir().unwrap();
        let path = |name: &str| place.path().join(name);
        fs::write(path("plain"), "").unwrap();
        symlink("target", path("link")).unwrap();
        fs::write(path("target"), "earlier").unwrap();
        write_all(place.path(), &[("link", b"new")], &Sources::default()).unwrap();
        assert!(fs::symlink_metadata(path("link")).unwrap().is_symlink());
        assert_eq!(fs::read(path("target")).unwrap(), b"new");
        let [plain, ours] =
            ["plain", "target"].map(|name| fs::metadata(path(name)).unwrap().permissions().mode());
        assert_eq!(plain, ours);
    }

    /// A kill runs no destructor: what was begun stays as it is.
    #[test]
    fn a_kill_between_two_names_leaves_whole_files() {
        let place = tempfile::tempdir().unwrap();
        let path = |name: &str| place.path().join(name);
        let earlier: [(&str, &[u8]); 3] = [("one", b"1"), ("two", b"2"), ("three", b"3")];
        let new: [(&str, &[u8]); 3] = [("one", b"new 1"), ("two", b"new 2"), ("three", b"new 3")];
        for named in 0..=3 {
            write_all(place.path(), &earlier, &Sources::default()).unwrap();
            let mut made = Made::default();
            let mut whole: Vec<_> = new
                .iter()
                .map(|(name, text)| (written(&path(name), text).unwrap(), name))
                .collect();
            let rest = whole.split_off(named);
            for (file, name) in whole {
                made.file(file, &path(name)).unwrap();
            }
            std::mem::forget((made, rest));
            for (k, (name, _)) in new.iter().enumerate() {
                let right = if k < named { new[k].1 } else { earlier[k].1 };
                assert_eq!(fs::read(path(name)).unwrap(), right);
            }
            assert_eq!(names(place.path()).len(), 6);
            write_all(place.path(), &new, &Sources::default()).unwrap();
            assert!(new.iter().all(|(name, text)| fs::read(path(name)).unwrap() == *text));
            for name in names(place.path()).iter().filter(|name| name.starts_with('.')) {
                fs::remove_file(path(name)).unwrap();
            }
        }
    }
}
