//! Reading that hears Ctrl-C: a pipe that says nothing, or a file on a disk that sleeps, keeps nobody
//! waiting.

use std::{
    fs::File,
    io::{self, BufRead, Read},
    path::Path,
    sync::mpsc::{Receiver, RecvTimeoutError, sync_channel},
    thread,
    time::Duration,
};

use super::progress::Interrupt;

/// How much is read at once, and how many such blocks wait to be used at most.
const BLOCK: usize = 1 << 16;
const AHEAD: usize = 4;

/// How often the wish to end is looked for.
const PATIENCE: Duration = Duration::from_millis(50);

/// A file, or standard input if the path is `-`. Opening it may block.
pub(super) fn open(path: &Path) -> io::Result<Box<dyn Read>> {
    Ok(if path == Path::new("-") { Box::new(io::stdin()) } else { Box::new(File::open(path)?) })
}

/// A stream that a thread of its own opens and reads. Once the user wants an end, reading from here fails;
/// the thread is left behind, which in a command that is about to end does no harm.
pub(super) struct Reader<'a> {
    blocks: Receiver<io::Result<Vec<u8>>>,
    /// The latest block, and how much of it is used.
    block: Vec<u8>,
    used: usize,
    interrupt: &'a Interrupt,
}

impl<'a> Reader<'a> {
    /// Opens a stream.
    ///
    /// # Errors
    /// The system's, from opening; an interruption.
    pub fn open(path: &Path, interrupt: &'a Interrupt) -> io::Result<Reader<'a>> {
        let (sender, blocks) = sync_channel(AHEAD);
        let path = path.to_path_buf();
        thread::spawn(move || {
            let opened = open(&path);
            let mut stream = match opened {
                Ok(stream) => stream,
                Err(error) => return drop(sender.send(Err(error))),
            };
            // The first block, empty, says that the stream is open.
            let mut block = Ok(Vec::new());
            while sender.send(block).is_ok() {
                let mut bytes = vec![0; BLOCK];
                block = match stream.read(&mut bytes) {
                    Ok(0) => return,
                    Ok(count) => {
                        bytes.truncate(count);
                        Ok(bytes)
                    }
                    Err(error) if error.kind() == io::ErrorKind::Interrupted => Ok(Vec::new()),
                    Err(error) => Err(error),
                };
            }
        });
        let mut reader = Reader { blocks, block: Vec::new(), used: 0, interrupt };
        reader.fill()?;
        Ok(reader)
    }

    /// Waits for the next block; whether there is one.
    fn fill(&mut self) -> io::Result<bool> {
        loop {
            match self.blocks.recv_timeout(PATIENCE) {
                Ok(block) => {
                    (self.block, self.used) = (block?, 0);
                    return Ok(true);
                }
                Err(RecvTimeoutError::Disconnected) => return Ok(false),
                Err(RecvTimeoutError::Timeout) if self.interrupt.check().is_err() => {
                    return Err(io::Error::other("interrupted"));
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }
}

impl Read for Reader<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

impl BufRead for Reader<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        while self.used == self.block.len() && self.fill()? {}
        Ok(&self.block[self.used..])
    }

    fn consume(&mut self, count: usize) {
        self.used += count;
    }
}
