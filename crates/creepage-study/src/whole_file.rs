//! Files that appear under their names when they are whole.
//!
//! A file is written beside its target and renamed when it is on the disk, so that an earlier
//! result stays until the new one is complete. A run that is killed leaves a hidden
//! `.NAME.*.partial`. Devices, pipes and sockets are written to in place.

use std::fs::{self, File, FileType};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile, TempPath};

use crate::error::ReportError;

/// A file that appears under its name when it is whole; dropped before [`WholeFile::finish`], it
/// leaves nothing.
///
/// ```
/// use std::io::Write;
/// # let place = tempfile::tempdir()?;
/// let path = place.path().join("forces.csv");
/// let mut file = creepage_study::WholeFile::create(&path)?;
/// writeln!(file, "fx,fy")?;
/// assert!(!path.exists());
/// file.finish()?;
/// assert_eq!(std::fs::read_to_string(path)?, "fx,fy\n");
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct WholeFile(Place);

#[derive(Debug)]
enum Place {
    /// Beside the target, which it replaces.
    Beside { file: NamedTempFile, target: PathBuf },
    /// A device, a pipe or a socket.
    Special(File),
}

impl WholeFile {
    /// Opens the file that is to replace `path`. A symbolic link stays: what it points to is
    /// replaced.
    ///
    /// # Errors
    /// Those of the system, such as a missing directory or a directory in the way.
    pub fn create(path: &Path) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(data) if data.is_dir() => Err(ErrorKind::IsADirectory.into()),
            Ok(data) if !data.is_file() => special(path, data.file_type()).map(Place::Special),
            _ => {
                let target = fs::canonicalize(path).unwrap_or_else(|_| path.into());
                let file = temporary(&target)?;
                Ok(Place::Beside { file, target })
            }
        }
        .map(Self)
    }

    /// Fills the file by its path, for libraries that seek. A device gets a copy of what was
    /// written elsewhere.
    ///
    /// # Errors
    /// Those of `write`, and of the system.
    pub fn fill<E: From<io::Error>>(
        &mut self,
        write: impl FnOnce(&Path) -> Result<(), E>,
    ) -> Result<(), E> {
        if let Place::Beside { file, .. } = &self.0 {
            return write(file.path());
        }
        let elsewhere = NamedTempFile::new()?;
        write(elsewhere.path())?;
        io::copy(&mut elsewhere.reopen()?, self)?;
        Ok(())
    }

    /// Puts the file on the disk and gives it its name.
    ///
    /// # Errors
    /// Those of the system; the target is then as it was.
    pub fn finish(mut self) -> io::Result<()> {
        self.sync()?;
        if let Place::Beside { file, target } = self.0 {
            file.persist(&target).map_err(|failed| failed.error)?;
            sync_directory_of(&target)?;
        }
        Ok(())
    }

    /// Puts on the disk what was written.
    fn sync(&mut self) -> io::Result<()> {
        match &mut self.0 {
            Place::Beside { file, .. } => file.as_file().sync_all(),
            Place::Special(file) => file.flush(),
        }
    }
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.0 {
            Place::Beside { file, .. } => file.as_file_mut().write(bytes),
            Place::Special(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Opens what is neither a file nor a directory.
fn special(path: &Path, kind: FileType) -> io::Result<File> {
    #[cfg(unix)]
    if std::os::unix::fs::FileTypeExt::is_socket(&kind) {
        let socket = std::os::unix::net::UnixStream::connect(path)?;
        return Ok(std::os::fd::OwnedFd::from(socket).into());
    }
    let _ = kind;
    File::options().write(true).open(path)
}

/// A hidden file beside `target`, with the permissions of any new file.
fn temporary(target: &Path) -> io::Result<NamedTempFile> {
    let name = target.file_name().ok_or(ErrorKind::InvalidFilename)?.to_string_lossy();
    let prefix = format!(".{name}.");
    let mut builder = Builder::new();
    builder.prefix(&prefix).suffix(".partial");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let directory = directory_of(target);
    // Its own error names only the directory, not a file that nobody asked for.
    fs::metadata(directory)?;
    builder.tempfile_in(directory)
}

fn directory_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Puts the name of a file on the disk.
///
/// # Errors
/// Those of the system.
pub(crate) fn sync_directory_of(path: &Path) -> io::Result<()> {
    // Elsewhere a directory cannot be opened, and a name needs no such care.
    if cfg!(not(unix)) {
        return Ok(());
    }
    File::open(directory_of(path))?.sync_all()
}

/// Writes files, by name and contents, into `directory`, which is made when missing: all of them
/// or none. Files of those names are replaced. Gives the paths written.
///
/// # Errors
/// [`ReportError::Write`]; what was there before is there again, as far as the file system has
/// hard links.
pub fn write_all(directory: &Path, files: &[(&str, &[u8])]) -> Result<Vec<PathBuf>, ReportError> {
    let mut made = Made::default();
    made.directory(directory).map_err(failure(directory))?;
    let mut whole = Vec::new();
    for (name, contents) in files {
        let path = directory.join(name);
        whole.push((written(&path, contents).map_err(failure(&path))?, path));
    }
    let mut paths = Vec::new();
    for (file, path) in whole {
        made.file(file, &path).map_err(failure(&path))?;
        paths.push(path);
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
    File(TempPath),
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

    fn file(&mut self, file: WholeFile, path: &Path) -> io::Result<()> {
        let earlier = Earlier::at(&file);
        file.finish()?;
        self.files.push((path.into(), earlier));
        Ok(())
    }

    fn keep(mut self) {
        self.files.clear();
        self.directories.clear();
    }
}

impl Earlier {
    fn at(file: &WholeFile) -> Self {
        match &file.0 {
            Place::Beside { target, .. } if target.exists() => Builder::new()
                .prefix(".earlier.")
                .make_in(directory_of(target), |link| fs::hard_link(target, link))
                .map_or(Self::Lost, |link| Self::File(link.into_temp_path())),
            Place::Beside { .. } => Self::Nothing,
            Place::Special(_) => Self::Lost,
        }
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        // Best effort: what cannot be undone is in use by others.
        for (path, earlier) in self.files.drain(..) {
            let _ = match earlier {
                Earlier::File(link) => link.persist(path).map_err(|failed| failed.error),
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
    use std::io::Read;

    use super::*;

    fn names(directory: &Path) -> Vec<String> {
        let entries = fs::read_dir(directory).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn an_earlier_file_stays_until_the_new_one_is_whole() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("out");
        fs::write(&path, "earlier").unwrap();
        let mut file = WholeFile::create(&path).unwrap();
        file.write_all(b"half").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "earlier");
        drop(file);
        assert_eq!(names(place.path()), ["out"]);
        // Two at a time: each is whole, and the last one stays.
        let [mut one, mut two] = [0, 1].map(|_| WholeFile::create(&path).unwrap());
        one.write_all(b"one").unwrap();
        two.write_all(b"two").unwrap();
        one.finish().unwrap();
        two.finish().unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
        assert_eq!(names(place.path()), ["out"]);
    }

    #[test]
    fn several_files_are_all_replaced_or_none() {
        let place = tempfile::tempdir().unwrap();
        let files: [(&str, &[u8]); 2] = [("one", b"1"), ("two", b"2")];
        write_all(place.path(), &files).unwrap();
        fs::create_dir(place.path().join("way")).unwrap();
        let failing: [(&str, &[u8]); 3] = [("one", b"new"), ("three", b"3"), ("way", b"")];
        assert!(write_all(place.path(), &failing).is_err());
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
        let error = write_all(&new, &bad).unwrap_err();
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
        write_all(place.path(), &[("link", b"new")]).unwrap();
        assert!(fs::symlink_metadata(path("link")).unwrap().is_symlink());
        assert_eq!(fs::read(path("target")).unwrap(), b"new");
        let [plain, ours] =
            ["plain", "target"].map(|name| fs::metadata(path(name)).unwrap().permissions().mode());
        assert_eq!(plain, ours);
    }

    #[cfg(unix)]
    #[test]
    fn a_pipe_and_a_socket_are_written_to_in_place() {
        use std::os::unix::fs::FileTypeExt;
        let place = tempfile::tempdir().unwrap();
        let [pipe, socket] = ["pipe", "socket"].map(|name| place.path().join(name));
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let listener = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        let read = |mut from: Box<dyn Read>| {
            let mut text = String::new();
            from.read_to_string(&mut text).unwrap();
            text
        };
        let fill = |path: &Path| -> io::Result<()> { fs::write(path, " by its path") };
        std::thread::scope(|scope| {
            let from_pipe = scope.spawn(|| read(Box::new(File::open(&pipe).unwrap())));
            let from_socket = scope.spawn(|| read(Box::new(listener.accept().unwrap().0)));
            for path in [&pipe, &socket] {
                let mut file = WholeFile::create(path).unwrap();
                file.write_all(b"written").unwrap();
                file.fill(fill).unwrap();
                file.finish().unwrap();
            }
            assert_eq!(from_pipe.join().unwrap(), "written by its path");
            assert_eq!(from_socket.join().unwrap(), "written by its path");
        });
        let kind = |path| fs::symlink_metadata(path).unwrap().file_type();
        assert!(kind(&pipe).is_fifo() && kind(&socket).is_socket());
        assert_eq!(names(place.path()), ["pipe", "socket"]);
    }
}
