//! Where output goes: standard output, or a file that appears only when it is complete; and what is said on
//! standard error.

use std::{
    fmt,
    fs::File,
    io::{self, BufWriter, ErrorKind, Write},
    path::{Path, PathBuf},
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
};

use super::file::{probe, write_proved};
use crate::{
    error::{Error, Result},
    printable::Printable,
};

/// A file to be written whole. It was named in a [`FileRegistry`](super::FileRegistry) and tried when this
/// was made, and is not touched before [`write`](Self::write).
#[derive(Debug, Clone)]
pub struct OutputFile {
    path: PathBuf,
    /// A pipe or a device, which is opened once.
    stream: Arc<Mutex<Option<File>>>,
    /// Whether the command writes nothing, as when some file was named twice.
    refused: Arc<AtomicBool>,
}

impl OutputFile {
    /// Tries a file.
    ///
    /// # Errors
    /// An input or I/O error if it cannot be written.
    pub(super) fn new(path: &Path, refused: Arc<AtomicBool>) -> Result<Self> {
        let stream = probe(path)?;
        Ok(OutputFile { path: path.to_path_buf(), stream: Arc::new(Mutex::new(stream)), refused })
    }

    /// Writes it, as [`write_file`](super::write_file) does.
    ///
    /// # Errors
    /// Those of [`write_file`](super::write_file).
    pub fn write(&self, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
        self.write_proved(write, |_| Ok(Some(()))).map(drop)
    }

    /// Writes it if it is worth that: `judge` is given the file that holds what was written. Where it gives
    /// nothing, what stood there stays. A pipe or a device is given what was judged in a file of its own.
    ///
    /// # Errors
    /// Those of [`write`](Self::write); whatever `judge` returns.
    pub fn write_proved<T>(
        &self,
        write: impl FnOnce(&mut dyn Write) -> Result<()>,
        judge: impl FnOnce(&Path) -> Result<Option<T>>,
    ) -> Result<Option<T>> {
        if self.refused.load(Ordering::Relaxed) {
            return Err(Error::input(format!(
                "{} is not written: this command writes nothing",
                self.path.display()
            )));
        }
        let stream = self.stream.lock().unwrap_or_else(PoisonError::into_inner).take();
        write_proved(&self.path, stream, write, judge)
    }

    /// Whether it is a pipe or a device.
    pub fn is_stream(&self) -> bool {
        self.stream.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }
}

/// Standard output, or a file.
#[derive(Debug, Clone)]
pub enum Destination {
    /// Standard output.
    Stdout,
    /// A file.
    File(OutputFile),
}

impl Destination {
    /// Whether it is standard output.
    pub fn is_stdout(&self) -> bool {
        matches!(self, Destination::Stdout)
    }

    /// The columns of the terminal that this is; none if it is none, or does not tell its size.
    pub fn columns(&self) -> Option<usize> {
        #[cfg(unix)]
        if self.is_stdout() {
            // Fails where it is no terminal; a terminal that does not tell says 0.
            let size = rustix::termios::tcgetwinsize(io::stdout()).ok()?;
            return Some(usize::from(size.ws_col)).filter(|&columns| columns > 0);
        }
        None
    }

    /// Runs `write` on the destination, buffered. Once the reader of standard output has gone, nothing more
    /// is written and `write` goes on as before, so that what it finds does not depend on who reads.
    ///
    /// # Errors
    /// Whatever `write` returns; an I/O error that names the destination.
    pub fn write(&self, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
        match self {
            Destination::File(file) => file.write(write),
            Destination::Stdout => on_stdout(true, write),
        }
    }

    /// The same for a list whose end brings nothing new: `write` ends early, without error, once the reader
    /// of standard output has gone.
    ///
    /// # Errors
    /// Those of [`write`](Self::write).
    pub fn list(&self, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
        match self {
            Destination::File(file) => file.write(write),
            Destination::Stdout => match on_stdout(false, write) {
                Err(error) if error.is_broken_pipe() => Ok(()),
                result => result,
            },
        }
    }
}

/// Whether anything was written to standard output, of which a process has one.
static WRITTEN: AtomicBool = AtomicBool::new(false);

/// Whether nothing has been written to standard output.
pub fn stdout_is_untouched() -> bool {
    !WRITTEN.load(Ordering::Relaxed)
}

fn on_stdout(go_on: bool, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let mut out =
        BufWriter::with_capacity(1 << 16, Stdout { inner: io::stdout().lock(), go_on, gone: false });
    let result = write(&mut out).and_then(|()| Ok(out.flush()?));
    // What could not be written is not tried again when the buffer is dropped. What came before an
    // interruption is whole and is wanted.
    match &result {
        Err(error) if error.is_interrupted() => drop(out.flush()),
        _ => {}
    }
    let _ = out.into_parts();
    result.map_err(|error| if error.is_io() { error.context("standard output") } else { error })
}

/// Standard output, silent once its reader has gone if work is to go on.
struct Stdout<'a> {
    inner: io::StdoutLock<'a>,
    go_on: bool,
    gone: bool,
}

impl Stdout<'_> {
    fn unless_gone<T>(
        &mut self,
        gone: T,
        act: impl FnOnce(&mut io::StdoutLock) -> io::Result<T>,
    ) -> io::Result<T> {
        if self.gone {
            return Ok(gone);
        }
        match act(&mut self.inner) {
            Err(error) if self.go_on && error.kind() == ErrorKind::BrokenPipe => {
                self.gone = true;
                Ok(gone)
            }
            result => result,
        }
    }
}

impl Write for Stdout<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        WRITTEN.store(true, Ordering::Relaxed);
        self.unless_gone(bytes.len(), |out| out.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.unless_gone((), |out| out.flush())
    }
}

/// Writes a line of a report, its text printable.
///
/// # Errors
/// An I/O error.
pub fn say_to(out: &mut dyn Write, line: impl fmt::Display) -> Result<()> {
    Ok(writeln!(out, "{}", Printable(&line.to_string()))?)
}

/// Says a line on standard error, its text printable. Who does not listen there misses it; nothing else
/// changes.
pub fn say(line: impl fmt::Display) {
    let _ = io::stderr().write_all(format!("{}\n", Printable(&line.to_string())).as_bytes());
}
