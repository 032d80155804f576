//! [`Input`]: numbers and letters of a file, in its text form or in one of its binary forms.
//!
//! In text, white space separates, and `#` starts a comment to the end of the line. In binary,
//! letters are bytes, integers have four bytes, short integers two and numbers eight. Nothing is
//! allocated for what a file only announces: callers append what has been read.

use super::error::{NlError, Place, Segment};

/// How numbers are written after the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Text,
    /// IEEE 754, least significant byte first.
    LittleEndian,
    /// IEEE 754, most significant byte first.
    BigEndian,
}

/// A place in the bytes of a file.
#[derive(Debug)]
pub(super) struct Input<'a> {
    bytes: &'a [u8],
    at: usize,
    pub(super) form: Form,
    pub(super) segment: Segment,
}

impl<'a> Input<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Input { bytes, at: 0, form: Form::Text, segment: Segment::Header(1) }
    }

    /// Where the next letter or number stands.
    pub(super) fn at(&mut self) -> usize {
        if self.form == Form::Text {
            self.skip_blanks();
        }
        self.at
    }

    /// Line or byte of a position.
    pub(super) fn place(&self, at: usize) -> Place {
        match self.form {
            Form::Text => Place::Line(self.bytes[..at].split(|&byte| byte == b'\n').count()),
            Form::LittleEndian | Form::BigEndian => Place::Byte(at),
        }
    }

    /// An error at a position: `expected` is not what stands there.
    #[cold]
    pub(super) fn error(&self, at: usize, expected: impl Into<String>) -> NlError {
        NlError::Syntax {
            place: self.place(at),
            segment: self.segment,
            expected: expected.into(),
            found: self.found(at),
        }
    }

    /// An error at a position: what stands there has no meaning for a complementarity problem.
    #[cold]
    pub(super) fn unsupported(&self, at: usize, what: impl Into<String>) -> NlError {
        NlError::Unsupported { place: self.place(at), segment: self.segment, what: what.into() }
    }

    /// What stands at a position, shortened.
    fn found(&self, at: usize) -> String {
        let rest = &self.bytes[at..];
        match (rest.first(), self.form) {
            (None, _) => "the end of the file".to_owned(),
            (Some(_), Form::Text) => {
                let length = rest.iter().take(24).position(|&byte| is_delimiter(byte));
                let length = length.unwrap_or(24.min(rest.len())).max(1);
                format!("`{}`", String::from_utf8_lossy(&rest[..length]).escape_debug())
            }
            (Some(_), _) => {
                let bytes = rest.iter().take(8).map(|byte| format!("{byte:02x}"));
                format!("the bytes {}", bytes.collect::<Vec<_>>().join(" "))
            }
        }
    }

    /// The next line of the header without its comment; `None` at the end of the file.
    pub(super) fn header_line(&mut self) -> Option<&'a str> {
        let rest = &self.bytes[self.at..];
        if rest.is_empty() {
            return None;
        }
        let end = rest.iter().position(|&byte| byte == b'\n');
        self.at += end.map_or(rest.len(), |end| end + 1);
        let line = &rest[..end.unwrap_or(rest.len())];
        let content = line.split(|&byte| byte == b'#').next().unwrap_or_default();
        // What is not a number fails as one.
        Some(std::str::from_utf8(content).unwrap_or("\u{fffd}"))
    }

    /// Position of the next byte, whatever it is.
    pub(super) fn position(&self) -> usize {
        self.at
    }

    /// White space and comments.
    fn skip_blanks(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            if byte == b'#' {
                let rest = &self.bytes[self.at..];
                self.at += rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
            } else if byte.is_ascii_whitespace() || byte == 0x0b {
                self.at += 1;
            } else {
                return;
            }
        }
    }

    /// The characters up to white space or a comment; at least one.
    fn word(&mut self, expected: &'static str) -> Result<&'a [u8], NlError> {
        let start = self.at();
        let rest = &self.bytes[start..];
        let length = rest.iter().position(|&byte| is_delimiter(byte)).unwrap_or(rest.len());
        if length == 0 {
            return Err(self.error(start, expected));
        }
        self.at += length;
        Ok(&rest[..length])
    }

    /// The next `N` bytes.
    fn take<const N: usize>(&mut self, expected: &'static str) -> Result<[u8; N], NlError> {
        let Some(&bytes) = self.bytes[self.at..].first_chunk::<N>() else {
            return Err(self.error(self.bytes.len(), expected));
        };
        self.at += N;
        Ok(bytes)
    }

    /// The letter of a segment; `None` at the end of the file.
    pub(super) fn segment_letter(&mut self) -> Option<u8> {
        self.segment = Segment::Between;
        let at = self.at();
        self.at = (at + 1).min(self.bytes.len());
        self.bytes.get(at).copied()
    }

    /// One letter of an expression, or the digit of a kind of bounds.
    pub(super) fn letter(&mut self, expected: &'static str) -> Result<u8, NlError> {
        let at = self.at();
        let &letter = self.bytes.get(at).ok_or_else(|| self.error(at, expected))?;
        self.at = at + 1;
        Ok(letter)
    }

    /// An integer.
    pub(super) fn integer(&mut self, expected: &'static str) -> Result<i64, NlError> {
        match self.form {
            Form::Text => {
                let at = self.at();
                let word = self.word(expected)?;
                let number = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
                number.ok_or_else(|| self.error(at, expected))
            }
            Form::LittleEndian => Ok(i32::from_le_bytes(self.take(expected)?).into()),
            Form::BigEndian => Ok(i32::from_be_bytes(self.take(expected)?).into()),
        }
    }

    /// An integer of two bytes in binary files.
    fn short(&mut self, expected: &'static str) -> Result<i64, NlError> {
        match self.form {
            Form::Text => self.integer(expected),
            Form::LittleEndian => Ok(i16::from_le_bytes(self.take(expected)?).into()),
            Form::BigEndian => Ok(i16::from_be_bytes(self.take(expected)?).into()),
        }
    }

    /// An integer from 0 to `below − 1`.
    pub(super) fn index(&mut self, expected: &'static str, below: usize) -> Result<usize, NlError> {
        let at = self.at();
        let index = self.integer(expected)?;
        let index = usize::try_from(index).ok().filter(|&index| index < below);
        index.ok_or_else(|| self.error(at, format!("{expected} from 0 to {}", below as i128 - 1)))
    }

    /// How many of something follow.
    pub(super) fn count(&mut self, expected: &'static str) -> Result<usize, NlError> {
        let at = self.at();
        usize::try_from(self.integer(expected)?).map_err(|_| self.error(at, expected))
    }

    /// A number that may be infinite, not NaN.
    pub(super) fn number(&mut self, expected: &'static str) -> Result<f64, NlError> {
        let at = self.at();
        let number = match self.form {
            Form::Text => {
                let word = std::str::from_utf8(self.word(expected)?);
                word.ok().and_then(|word| word.parse().ok()).unwrap_or(f64::NAN)
            }
            Form::LittleEndian => f64::from_le_bytes(self.take(expected)?),
            Form::BigEndian => f64::from_be_bytes(self.take(expected)?),
        };
        if number.is_nan() { Err(self.error(at, expected)) } else { Ok(number) }
    }

    /// A finite number.
    pub(super) fn finite(&mut self, expected: &'static str) -> Result<f64, NlError> {
        let at = self.at();
        let number = self.number(expected)?;
        if number.is_finite() { Ok(number) } else { Err(self.error(at, expected)) }
    }

    /// The number behind the letter `n`, `s` or `l` of a constant.
    pub(super) fn constant(&mut self, letter: u8) -> Result<f64, NlError> {
        const EXPECTED: &str = "a finite number";
        match letter {
            b'n' => self.finite(EXPECTED),
            b's' => Ok(self.short(EXPECTED)? as f64),
            _ => Ok(self.integer(EXPECTED)? as f64),
        }
    }

    /// A name: a word, in binary files with its length in front.
    pub(super) fn name(&mut self) -> Result<String, NlError> {
        const EXPECTED: &str = "a name";
        let name = if self.form == Form::Text {
            self.word(EXPECTED)?
        } else {
            let length = self.count(EXPECTED)?;
            let rest = &self.bytes[self.at..];
            let name = rest.get(..length).ok_or_else(|| self.error(self.at, EXPECTED))?;
            self.at += length;
            name
        };
        Ok(String::from_utf8_lossy(name).into_owned())
    }
}

fn is_delimiter(byte: u8) -> bool {
    byte.is_ascii_whitespace() || byte == 0x0b || byte == b'#'
}
