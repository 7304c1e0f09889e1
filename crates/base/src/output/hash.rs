//! Hashes that tell torn lines and other runs. They withstand accidents, not an adversary.

/// FNV-1a of 64 bits. Any change of a single byte changes it: each step is a bijection.
pub fn fnv64(bytes: &[u8]) -> u64 {
    fnv64_after(0xcbf2_9ce4_8422_2325, bytes)
}

/// The same, going on from a hash: of what was hashed before, followed by `bytes`.
pub(crate) fn fnv64_after(start: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(start, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}

/// FNV-1a of 128 bits, for texts that stand for what a run is.
pub(crate) fn fnv128(bytes: &[u8]) -> u128 {
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    bytes.iter().fold(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d, |hash, &byte| {
        (hash ^ u128::from(byte)).wrapping_mul(PRIME)
    })
}

/// A text in 32 hexadecimal digits.
pub fn fingerprint(text: &str) -> String {
    format!("{:032x}", fnv128(text.as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From the tables of the definition (Fowler, Noll, Vo).
    #[test]
    fn published_values() {
        assert_eq!(fnv64(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv64(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv64(b"foobar"), 0x8594_4171_f739_67e8);
        assert_eq!(fnv64_after(fnv64(b"foo"), b"bar"), fnv64(b"foobar"));
        assert_eq!(fnv128(b""), 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d);
        assert_eq!(fnv128(b"a"), 0xd228_cb69_6f1a_8caf_7891_2b70_4e4a_8964);
    }
}
