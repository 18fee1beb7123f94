//! Data arrays of VTU files: text, base64 or raw bytes, plain or compressed.

use anyhow::{Context, Result, bail, ensure};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use roxmltree::Node;
use std::io::Read;

/// What the root element and the appended data say about all arrays.
pub(super) struct Encoding<'a> {
    pub(super) little_endian: bool,
    /// Bytes of a count in front of binary data, 4 or 8.
    pub(super) header_size: usize,
    pub(super) compressor: Option<&'a str>,
    /// What follows the underscore of `AppendedData`, and whether it is base64.
    pub(super) appended: Option<(&'a [u8], bool)>,
    /// Where appended arrays begin, ascending.
    pub(super) offsets: Vec<usize>,
    /// Bytes of the file.
    pub(super) file_size: usize,
}

/// Bytes of an array by those of the file, at most. Arrays that say the same of every cell shrink to a thousandth, but the nodes of
/// cells and their places do not: compressors leave a tenth of them or more.
const MOST_INFLATION: usize = 100;

/// Bytes that an array may have in any file, however small.
const ALWAYS_ALLOWED: usize = 1 << 20;

impl Encoding<'_> {
    /// Whether a number of things of which each has this many bytes may be meant by a file of this size.
    pub(super) fn check_size(&self, count: usize, bytes: usize) -> Result<()> {
        let most = self.file_size.saturating_mul(MOST_INFLATION).max(ALWAYS_ALLOWED);
        match count.checked_mul(bytes).filter(|size| *size <= most) {
            Some(_) => Ok(()),
            None => bail!(
                "{count} numbers of {bytes} bytes are more than {MOST_INFLATION} times the {} bytes of the file: it is damaged",
                self.file_size
            ),
        }
    }

    /// Floating point numbers of an array.
    pub(super) fn floats(&self, array: Node) -> Result<Vec<f64>> {
        match array.attribute("type").unwrap_or_default() {
            "Float32" => self.numbers(array, |b| f32::from_le_bytes(b).into()),
            "Float64" => self.numbers(array, f64::from_le_bytes),
            other => bail!("it has type '{other}', not Float32 or Float64"),
        }
        .with_context(|| in_array(array))
    }

    /// Whole numbers of an array.
    pub(super) fn integers(&self, array: Node) -> Result<Vec<i64>> {
        match array.attribute("type").unwrap_or_default() {
            "Int8" => self.numbers(array, |b| i8::from_le_bytes(b).into()),
            "UInt8" => self.numbers(array, |b| u8::from_le_bytes(b).into()),
            "Int16" => self.numbers(array, |b| i16::from_le_bytes(b).into()),
            "UInt16" => self.numbers(array, |b| u16::from_le_bytes(b).into()),
            "Int32" => self.numbers(array, |b| i32::from_le_bytes(b).into()),
            "UInt32" => self.numbers(array, |b| u32::from_le_bytes(b).into()),
            // Larger numbers than i64 holds wrap to negative ones, which every use refuses.
            "Int64" | "UInt64" => self.numbers(array, i64::from_le_bytes),
            other => bail!("it has type '{other}', not one of whole numbers"),
        }
        .with_context(|| in_array(array))
    }

    fn numbers<T: std::str::FromStr, const N: usize>(&self, array: Node, decode: fn([u8; N]) -> T) -> Result<Vec<T>> {
        let text = array.text().unwrap_or_default();
        let bytes = match array.attribute("format").unwrap_or("ascii") {
            "ascii" => {
                let parse =
                    |word: &str| word.parse().ok().with_context(|| format!("'{word}' is not one of its numbers"));
                return text.split_ascii_whitespace().map(parse).collect();
            }
            "binary" => self.unpacked(&base64_decoded(text.as_bytes())?)?,
            "appended" => {
                let (data, is_base64) = self.appended.context("the file has no AppendedData")?;
                let offset = offset(array).context("it has no offset")?;
                let end = self.offsets.iter().copied().find(|&o| o > offset).unwrap_or(data.len());
                let block = data.get(offset..end.min(data.len())).context("it begins after the end of the file")?;
                if is_base64 { self.unpacked(&base64_decoded(block)?)? } else { self.unpacked(block)? }
            }
            other => bail!("its format '{other}' is not known"),
        };
        ensure!(bytes.len() % N == 0, "its {} bytes are no multiple of {N}", bytes.len());
        let native = |chunk: &[u8]| {
            let mut number: [u8; N] = chunk.try_into().expect("chunks have N bytes");
            if !self.little_endian {
                number.reverse();
            }
            decode(number)
        };
        Ok(bytes.chunks_exact(N).map(native).collect())
    }

    /// Contents of a block: counts, then data. Plain: the number of bytes. Compressed: the number of pieces, the size
    /// of a piece, the size of the last one if it is smaller, else 0, and the compressed size of each.
    fn unpacked(&self, block: &[u8]) -> Result<Vec<u8>> {
        const SHORT: &str = "the file ends too early";
        let count = |position: usize| -> Result<usize> {
            let mut bytes = [0; 8];
            let start = position.checked_mul(self.header_size).context(SHORT)?;
            let found = block.get(start..).and_then(|rest| rest.get(..self.header_size)).context(SHORT)?;
            bytes[..self.header_size].copy_from_slice(found);
            if !self.little_endian {
                bytes[..self.header_size].reverse();
            }
            usize::try_from(u64::from_le_bytes(bytes)).context(SHORT)
        };
        let Some(compressor) = self.compressor else {
            let data = &block[self.header_size.min(block.len())..];
            return Ok(data.get(..count(0)?).context(SHORT)?.to_vec());
        };
        let (pieces, size, last) = if count(0)? == 0 { (0, 0, 0) } else { (count(0)?, count(1)?, count(2)?) };
        ensure!(pieces <= block.len(), SHORT);
        // All that is asked for below, before any of it is.
        self.check_size(
            (pieces.saturating_sub(1)).saturating_mul(size).saturating_add(if last > 0 { last } else { size }),
            1,
        )?;
        let mut rest = if pieces == 0 { &[] } else { block.get((3 + pieces) * self.header_size..).context(SHORT)? };
        let mut data = Vec::new();
        for piece in 0..pieces {
            let wanted = if piece + 1 == pieces && last > 0 { last } else { size };
            let compressed;
            (compressed, rest) = rest.split_at_checked(count(3 + piece)?).context(SHORT)?;
            let start = data.len();
            match compressor {
                "vtkZLibDataCompressor" => {
                    let limited = flate2::read::ZlibDecoder::new(compressed).take(wanted as u64);
                    { limited }.read_to_end(&mut data).context("its zlib data is damaged")?;
                }
                "vtkLZ4DataCompressor" => {
                    // LZ4 cannot grow its input more than 255 times: a larger size is damage.
                    ensure!(wanted / 255 <= compressed.len(), "its LZ4 data is damaged");
                    let piece = lz4_flex::block::decompress(compressed, wanted).context("its LZ4 data is damaged")?;
                    data.extend(piece);
                }
                other => bail!("compressor {other} is not supported; save it with zlib or without compression"),
            }
            ensure!(data.len() - start == wanted, "a compressed piece has another size than it should");
        }
        Ok(data)
    }
}

/// Position of an appended array.
pub(super) fn offset(array: Node) -> Option<usize> {
    array.attribute("offset")?.trim().parse().ok()
}

fn in_array(array: Node) -> String {
    format!("data array '{}'", array.attribute("Name").unwrap_or("without a name"))
}

/// Bytes of base64 text. Counts and data may each be padded on their own, so `=` may also stand inside.
fn base64_decoded(text: &[u8]) -> Result<Vec<u8>> {
    let text: Vec<u8> = text.iter().copied().filter(|b| !b.is_ascii_whitespace()).collect();
    let (mut bytes, mut rest) = (Vec::with_capacity(text.len() / 4 * 3), text.as_slice());
    while !rest.is_empty() {
        let padding = rest.iter().position(|&b| b == b'=').map_or(rest.len(), |at| (at + 1).next_multiple_of(4));
        let (section, after) = rest.split_at(padding.min(rest.len()));
        BASE64_STANDARD.decode_vec(section, &mut bytes).context("its base64 text is damaged")?;
        rest = after;
    }
    Ok(bytes)
}
