//! Numbers of an MSH file, one after the other, whether written as text or in binary.

use crate::excerpt::shortened;
use anyhow::{Result, bail, ensure};
use std::str::FromStr;

/// How the numbers between `$Nodes` and `$EndNodes` are written. Section names are always text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// A position in a file.
pub(super) struct Stream<'a> {
    bytes: &'a [u8],
    at: usize,
    pub(super) encoding: Encoding,
}

impl<'a> Stream<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, encoding: Encoding::Text }
    }

    /// A signed integer of 4 bytes.
    pub(super) fn int(&mut self) -> Result<i64> {
        match self.encoding {
            Encoding::Text => self.number("a whole number"),
            Encoding::LittleEndian => Ok(i32::from_le_bytes(self.take()?).into()),
            Encoding::BigEndian => Ok(i32::from_be_bytes(self.take()?).into()),
        }
    }

    /// An unsigned integer of 8 bytes.
    pub(super) fn size(&mut self) -> Result<u64> {
        match self.encoding {
            Encoding::Text => self.number("a whole number of at least 0"),
            Encoding::LittleEndian => Ok(u64::from_le_bytes(self.take()?)),
            Encoding::BigEndian => Ok(u64::from_be_bytes(self.take()?)),
        }
    }

    /// An integer of 4 bytes that is not negative.
    pub(super) fn whole(&mut self) -> Result<u64> {
        if self.encoding == Encoding::Text {
            return self.number("a whole number of at least 0");
        }
        let at = self.at;
        let number = self.int()?;
        match u64::try_from(number) {
            Ok(number) => Ok(number),
            Err(_) => bail!("byte {at}: expected a whole number of at least 0, found {number}"),
        }
    }

    /// A number of things still to come, on a line of its own: text in binary files too. Checked as [`Self::count`] is.
    pub(super) fn count_line(&mut self) -> Result<usize> {
        let place = self.place();
        let line = self.line().unwrap_or_default();
        let Ok(count) = line.parse::<usize>() else {
            bail!("{place}: expected a count, found '{}'", shortened(&line));
        };
        self.announce(count as u64, &place)
    }

    /// A number of things still to come, each of which takes at least two bytes. Checked, so that a damaged count ends
    /// here and not in an allocation.
    pub(super) fn count(&mut self) -> Result<usize> {
        let place = self.place();
        let count = self.size()?;
        self.announce(count, &place)
    }

    fn announce(&self, count: u64, place: &str) -> Result<usize> {
        let most = (self.bytes.len() - self.at) / 2 + 1;
        ensure!(count <= most as u64, "{place}: the file ends before the {count} entries announced here");
        Ok(count as usize)
    }

    /// A floating point number.
    pub(super) fn double(&mut self) -> Result<f64> {
        match self.encoding {
            Encoding::Text => self.number("a number"),
            Encoding::LittleEndian => Ok(f64::from_le_bytes(self.take()?)),
            Encoding::BigEndian => Ok(f64::from_be_bytes(self.take()?)),
        }
    }

    /// The next `N` bytes.
    pub(super) fn take<const N: usize>(&mut self) -> Result<[u8; N]> {
        match self.bytes[self.at..].first_chunk() {
            Some(&chunk) => {
                self.at += N;
                Ok(chunk)
            }
            None => bail!("the file ends too early"),
        }
    }

    /// The next word, without moving past it.
    fn word(&self) -> (usize, &'a [u8]) {
        let rest = &self.bytes[self.at..];
        let start = rest.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(rest.len());
        let length = rest[start..].iter().position(|b| b.is_ascii_whitespace()).unwrap_or(rest.len() - start);
        (self.at + start, &rest[start..start + length])
    }

    fn number<T: FromStr>(&mut self, expected: &str) -> Result<T> {
        let (start, word) = self.word();
        ensure!(!word.is_empty(), "the file ends too early");
        let text = String::from_utf8_lossy(word);
        let Ok(value) = text.parse() else {
            self.at = start;
            bail!("{}: expected {expected}, found '{}'", self.place(), shortened(&text));
        };
        self.at = start + word.len();
        Ok(value)
    }

    /// The next line that is not blank, without blanks around it; `None` at the end of the file.
    pub(super) fn line(&mut self) -> Option<String> {
        self.at = self.word().0;
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|&b| b == b'\n').map_or(rest.len(), |end| end + 1);
        self.at += length;
        (length > 0).then(|| String::from_utf8_lossy(rest[..length].trim_ascii()).into_owned())
    }

    /// Moves past the end of a section, which must come next.
    pub(super) fn end_section(&mut self, name: &str) -> Result<()> {
        let place = self.place();
        match self.line() {
            Some(line) if line.strip_prefix("$End") == Some(name) => Ok(()),
            Some(line) => bail!("{place}: expected $End{name}, found '{}'", shortened(&line)),
            None => bail!("the file ends before $End{name}"),
        }
    }

    /// Moves past a section of no interest.
    pub(super) fn skip_section(&mut self, name: &str) -> Result<()> {
        let end = format!("$End{name}");
        match self.bytes[self.at..].windows(end.len()).position(|window| window == end.as_bytes()) {
            Some(position) => {
                self.at += position + end.len();
                Ok(())
            }
            None => bail!("the file ends before {end}"),
        }
    }

    /// Where we are, for messages.
    pub(super) fn place(&self) -> String {
        match self.encoding {
            Encoding::Text => {
                let at = self.word().0;
                format!("line {}", 1 + self.bytes[..at].iter().filter(|&&b| b == b'\n').count())
            }
            _ => format!("byte {}", self.at),
        }
    }
}
