//! NPZ: an uncompressed ZIP archive of a file NAME.npy for each column, as `numpy.savez` writes it. Forms:
//! NPY version 1.0 ("numpy.lib.format"), APPNOTE of ZIP.

use super::table::{Column, Table, Values};
use crate::error::{Error, Result};

/// The archive.
///
/// # Errors
/// An input error if it is too long for the form.
pub(super) fn write(table: &Table) -> Result<Vec<u8>> {
    let long = || Error::input("too long for an NPZ file: it ends at 4 GB");
    let size = |x: usize| u32::try_from(x).map_err(|_| long());
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for column in &table.columns {
        let (name, data) = (format!("{}.npy", column.name.replace('/', "_")), array(column, table.rows));
        let begin = size(bytes.len())?;
        // Version 2.0, names in UTF-8, stored; 1 January 1980; the sums; the lengths of name and extra.
        let mut about = Vec::new();
        for half in [20u16, 0x800, 0, 0, 0x21] {
            about.extend(half.to_le_bytes());
        }
        for number in [crc32(&data), size(data.len())?, size(data.len())?] {
            about.extend(number.to_le_bytes());
        }
        about.extend((name.len() as u16).to_le_bytes());
        about.extend([0, 0]);
        bytes.extend(b"PK\x03\x04");
        bytes.extend(&about);
        bytes.extend(name.as_bytes());
        bytes.extend(&data);
        directory.extend(b"PK\x01\x02\x14\x00");
        directory.extend(&about);
        // No comment, first disk, no attributes.
        directory.extend([0; 10]);
        directory.extend(begin.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let (at, count) = (size(bytes.len())?, u16::try_from(table.columns.len()).map_err(|_| long())?);
    let length = size(directory.len())?;
    bytes.extend(directory);
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    bytes.extend([count.to_le_bytes(), count.to_le_bytes()].concat());
    bytes.extend([length.to_le_bytes(), at.to_le_bytes()].concat());
    bytes.extend([0, 0]);
    Ok(bytes)
}

/// A column as an array: one number in a row is an array of one dimension.
fn array(column: &Column, rows: usize) -> Vec<u8> {
    let mut data = Vec::new();
    let (kind, shape) = match &column.values {
        Values::Texts(all) => {
            let width = all.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
            for text in all {
                let letters = text.chars().chain(std::iter::repeat('\0')).take(width);
                letters.for_each(|letter| data.extend(u32::from(letter).to_le_bytes()));
            }
            (format!("<U{width}"), format!("({rows},)"))
        }
        Values::Numbers { width, rows: all } => {
            let complex = column.is_complex();
            for &(re, im) in all.iter().flatten() {
                data.extend(re.to_le_bytes());
                if complex {
                    data.extend(im.to_le_bytes());
                }
            }
            let shape = if *width == 1 { format!("({rows},)") } else { format!("({rows}, {width})") };
            ((if complex { "<c16" } else { "<f8" }).into(), shape)
        }
    };
    let head = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    // Numbers begin at a multiple of 64.
    let length = (head.len() + 1 + 10).next_multiple_of(64) - 10;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(format!("{head:<width$}\n", width = length - 1).bytes());
    bytes.extend(data);
    bytes
}

/// The CRC-32 of ZIP.
fn crc32(bytes: &[u8]) -> u32 {
    let mut table = [0u32; 256];
    for (byte, entry) in (0..).zip(&mut table) {
        *entry = (0..8).fold(byte, |x: u32, _| if x & 1 == 1 { (x >> 1) ^ 0xEDB8_8320 } else { x >> 1 });
    }
    !bytes.iter().fold(!0, |sum: u32, &byte| table[((sum ^ u32::from(byte)) & 0xFF) as usize] ^ (sum >> 8))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_is_that_of_zip() {
        // The check value of CRC-32.
        assert_eq!(crc32(b"123456789"), 0xCBF4_3926);
        assert_eq!(crc32(b""), 0);
    }

    #[test]
    fn arrays_say_their_kind_and_shape() {
        let table = Table::read("q,m,s\n1.5,\"1.0, 2.0 + 1.0i\",ab\n2.5,3.0,c\n", "x.csv").unwrap();
        for (column, head, data) in [
            (0, "{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }", 16),
            (1, "{'descr': '<c16', 'fortran_order': False, 'shape': (2, 2), }", 64),
            (2, "{'descr': '<U2', 'fortran_order': False, 'shape': (2,), }", 16),
        ] {
            let bytes = array(&table.columns[column], table.rows);
            assert!(bytes.len() % 64 == data % 64 && bytes[10..].starts_with(head.as_bytes()), "{head}");
            assert_eq!(usize::from(bytes[8]) + 256 * usize::from(bytes[9]) + 10 + data, bytes.len());
        }
    }
}
