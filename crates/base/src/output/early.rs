//! Bringing a long file to the disk while the rest of it is written.
//!
//! A system keeps what is written in memory until it is asked to bring it to the disk. Asked at the end only,
//! for a file of a gigabyte, it takes about as long again as making it.

use std::{
    fs::File,
    io::{self, Write},
    thread::{self, Scope, ScopedJoinHandle},
};

/// After so many bytes another part is brought to the disk.
const PART: u64 = 32 << 20;

/// A file to write to. Another thread brings to the disk what was written so far, each time a part is
/// complete and the one before is there.
pub(super) struct Early<'scope, 'env, S> {
    scope: &'scope Scope<'scope, 'env>,
    file: &'scope File,
    sync: S,
    part: u64,
    /// Written since the last time.
    written: u64,
    under_way: Option<ScopedJoinHandle<'scope, io::Result<()>>>,
}

impl<'scope, 'env> Early<'scope, 'env, fn(&File) -> io::Result<()>> {
    pub fn new(scope: &'scope Scope<'scope, 'env>, file: &'scope File) -> Self {
        Early { scope, file, sync: File::sync_data, part: PART, written: 0, under_way: None }
    }
}

impl<S: Fn(&File) -> io::Result<()> + Copy + Send + 'static> Early<'_, '_, S> {
    /// Waits for the part that is under way, if there is one. What was written last is not brought to the
    /// disk yet.
    ///
    /// # Errors
    /// Its I/O error, which the system tells once: asked again it would say that all is well.
    pub(crate) fn wait(&mut self) -> io::Result<()> {
        let Some(under_way) = self.under_way.take() else { return Ok(()) };
        under_way.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    }

    fn begin(&mut self) -> io::Result<()> {
        if self.under_way.as_ref().is_some_and(|thread| !thread.is_finished()) {
            return Ok(());
        }
        self.wait()?;
        self.written = 0;
        let (file, sync) = (self.file, self.sync);
        // Without another thread everything is brought there at the end.
        self.under_way = thread::Builder::new().spawn_scoped(self.scope, move || sync(file)).ok();
        Ok(())
    }
}

impl<S: Fn(&File) -> io::Result<()> + Copy + Send + 'static> Write for Early<'_, '_, S> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut file = self.file;
        let length = file.write(bytes)?;
        self.written += length as u64;
        if self.written >= self.part {
            self.begin()?;
        }
        Ok(length)
    }

    fn flush(&mut self) -> io::Result<()> {
        let mut file = self.file;
        file.flush()
    }
}

#[cfg(test)]
mod tests {
    use std::{
        fs,
        sync::atomic::{AtomicUsize, Ordering},
    };

    use super::*;

    fn in_parts<S: Fn(&File) -> io::Result<()> + Copy + Send + 'static>(
        sync: S,
    ) -> (Vec<u8>, io::Result<()>) {
        let file = tempfile::NamedTempFile::new().unwrap();
        let result = thread::scope(|scope| {
            let mut out = Early { scope, file: file.as_file(), sync, part: 10, written: 0, under_way: None };
            (0..100).try_for_each(|_| out.write_all(b"seven\n\n")).and_then(|()| out.wait())
        });
        (fs::read(file.path()).unwrap(), result)
    }

    #[test]
    fn parts_are_brought_to_the_disk_and_all_is_written() {
        static TIMES: AtomicUsize = AtomicUsize::new(0);
        let (bytes, result) = in_parts(|file| {
            TIMES.fetch_add(1, Ordering::Relaxed);
            file.sync_data()
        });
        result.unwrap();
        assert_eq!(bytes, b"seven\n\n".repeat(100));
        assert!((1..=50).contains(&TIMES.load(Ordering::Relaxed)));
    }

    /// Also one that comes to light with the last part only.
    #[test]
    fn an_error_of_the_disk_is_told() {
        let (_, result) = in_parts(|_| Err(io::Error::other("the disk is broken")));
        assert_eq!(result.unwrap_err().to_string(), "the disk is broken");
        let file = tempfile::tempfile().unwrap();
        let sync = |_: &File| Err(io::Error::other("the disk is broken"));
        let result = thread::scope(|scope| {
            let mut out = Early { scope, file: &file, sync, part: 10, written: 0, under_way: None };
            out.write_all(&[0; 10]).unwrap();
            out.wait()
        });
        assert!(result.is_err());
    }
}
