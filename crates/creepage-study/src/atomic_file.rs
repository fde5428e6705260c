//! Atomic files, which appear under their names when they are whole.
//!
//! A file is written beside its target and renamed when it is on the disk, so that an earlier
//! result stays until the new one is complete. A run that is killed leaves a hidden
//! `.NAME.*.partial`, which the next one removes. Devices, pipes and sockets are written to in place.

use std::fs::{self, File, FileType};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use crate::stale_temp;

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
        self.name()?.map_or(Ok(()), |target| sync_directory_of(&target))
    }

    /// Gives the file its name, which is not yet on the disk; that name, where it has one of its own.
    pub(crate) fn name(self) -> io::Result<Option<PathBuf>> {
        let Place::Beside { file, target } = self.0 else { return Ok(None) };
        file.persist(&target).map_err(|failed| failed.error)?;
        Ok(Some(target))
    }

    /// The file that it replaces, where there is one.
    pub(crate) fn earlier(&self) -> Option<&Path> {
        match &self.0 {
            Place::Beside { target, .. } if target.exists() => Some(target),
            _ => None,
        }
    }

    /// Whether it is written in place, so that nothing of it can be undone.
    pub(crate) fn is_in_place(&self) -> bool {
        matches!(self.0, Place::Special(_))
    }

    /// Puts on the disk what was written.
    pub(crate) fn sync(&mut self) -> io::Result<()> {
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
    builder.prefix(&prefix).suffix(stale_temp::PARTIAL);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let directory = directory_of(target);
    // Its own error names only the directory, not a file that nobody asked for.
    fs::metadata(directory)?;
    stale_temp::remove(directory, &prefix);
    loop {
        let file = builder.tempfile_in(directory)?;
        if stale_temp::hold(file.as_file(), file.path()) {
            return Ok(file);
        }
    }
}

pub(crate) fn directory_of(path: &Path) -> &Path {
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
