//! [`Output`]: standard output, which may be closed or full; [`warn`], on standard error.

use std::fmt::Display;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write};

/// A writer that never fails while a command works, so that no answer or file is lost because
/// nobody reads what is printed: the first error ends the printing, and
/// [`finish`](Output::finish) tells it.
pub(crate) struct Output<W> {
    out: W,
    failed: Option<io::Error>,
}

impl Output<Box<dyn Write>> {
    /// Standard output: line by line on a terminal, where a person wants to see each when it is
    /// written.
    pub(crate) fn stdout() -> Self {
        let stdout = io::stdout().lock();
        let is_terminal = stdout.is_terminal();
        Output::new(if is_terminal { Box::new(stdout) } else { Box::new(BufWriter::new(stdout)) })
    }
}

impl<W: Write> Output<W> {
    fn new(out: W) -> Self {
        Output { out, failed: None }
    }

    /// Writes what is buffered.
    ///
    /// # Errors
    /// The first that occurred, except that the reader has closed its end, as `head` does.
    pub(crate) fn finish(mut self) -> io::Result<()> {
        self.flush()?;
        match self.failed {
            Some(error) if error.kind() != ErrorKind::BrokenPipe => Err(error),
            _ => Ok(()),
        }
    }

    /// Does it unless something failed before.
    fn attempt(&mut self, what: impl FnOnce(&mut W) -> io::Result<()>) {
        if self.failed.is_none() {
            self.failed = what(&mut self.out).err();
        }
    }
}

impl<W: Write> Write for Output<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.attempt(|out| out.write_all(bytes));
        Ok(bytes.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        self.attempt(Write::flush);
        Ok(())
    }
}

/// Says on standard error what went wrong but costs no answer.
pub(crate) fn warn(what: impl Display) {
    // Nobody is left to tell if this fails too.
    let _ = writeln!(io::stderr(), "warning: {what}");
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes three bytes, then fails.
    struct Short(Vec<u8>, ErrorKind);

    impl Write for Short {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let room = bytes.len().min(3 - self.0.len());
            self.0.extend(&bytes[..room]);
            if room == 0 { Err(self.1.into()) } else { Ok(room) }
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_closed_reader_is_no_error_and_a_full_disk_is_told_at_the_end() {
        for (kind, told) in
            [(ErrorKind::BrokenPipe, None), (ErrorKind::StorageFull, Some(ErrorKind::StorageFull))]
        {
            let mut out = Output::new(Short(Vec::new(), kind));
            for _ in 0..3 {
                out.write_all(b"ab").unwrap();
            }
            assert_eq!(out.out.0, b"aba");
            assert_eq!(out.finish().err().map(|error| error.kind()), told);
        }
    }
}
