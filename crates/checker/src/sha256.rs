//! SHA-256 (FIPS 180-4), for the digest that names a system and for the one that names a file.

use std::io::{self, Read};

/// SHA-256 of bytes that come in portions. Memory: a few hundred bytes; time: linear in the bytes.
///
/// ```
/// use grazing_check::Sha256;
/// let mut hash = Sha256::default();
/// hash.update(b"a");
/// hash.update(b"bc");
/// assert_eq!(hash.finish(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
/// ```
#[derive(Debug, Clone)]
pub struct Sha256 {
    constants: [u32; 64],
    state: [u32; 8],
    /// What does not fill a block yet: fewer than 64 bytes.
    rest: Vec<u8>,
    length: u64,
}

impl Default for Sha256 {
    /// Of no bytes yet.
    fn default() -> Sha256 {
        let (constants, state) = constants();
        Sha256 { constants, state, rest: Vec::with_capacity(64), length: 0 }
    }
}

impl Sha256 {
    /// Appends bytes; in all, fewer than 2⁶¹.
    pub fn update(&mut self, mut bytes: &[u8]) {
        self.length += bytes.len() as u64;
        if !self.rest.is_empty() {
            let (head, tail) = bytes.split_at(bytes.len().min(64 - self.rest.len()));
            self.rest.extend(head);
            bytes = tail;
            if self.rest.len() < 64 {
                return;
            }
            let block = std::mem::take(&mut self.rest);
            self.block(&block);
        }
        let blocks = bytes.chunks_exact(64);
        self.rest.extend(blocks.remainder());
        blocks.for_each(|block| self.block(block));
    }

    /// The digest of all bytes, in hexadecimal, lower case.
    pub fn finish(mut self) -> String {
        let bits = self.length * 8;
        let mut end = std::mem::take(&mut self.rest);
        end.push(0x80);
        end.resize((end.len() + 8).next_multiple_of(64) - 8, 0);
        end.extend(bits.to_be_bytes());
        end.chunks_exact(64).for_each(|block| self.block(block));
        self.state.iter().map(|word| format!("{word:08x}")).collect()
    }

    /// Takes in 64 bytes.
    fn block(&mut self, block: &[u8]) {
        let mut w = [0u32; 64];
        for (word, bytes) in w.iter_mut().zip(block.chunks_exact(4)) {
            *word = bytes.iter().fold(0, |word, &byte| word << 8 | u32::from(byte));
        }
        for i in 16..64 {
            let s0 = w[i - 15].rotate_right(7) ^ w[i - 15].rotate_right(18) ^ (w[i - 15] >> 3);
            let s1 = w[i - 2].rotate_right(17) ^ w[i - 2].rotate_right(19) ^ (w[i - 2] >> 10);
            w[i] = w[i - 16].wrapping_add(s0).wrapping_add(w[i - 7]).wrapping_add(s1);
        }
        let [mut a, mut b, mut c, mut d, mut e, mut f, mut g, mut h] = self.state;
        for (k, w) in self.constants.iter().zip(w) {
            let s1 = e.rotate_right(6) ^ e.rotate_right(11) ^ e.rotate_right(25);
            let t1 = h.wrapping_add(s1).wrapping_add((e & f) ^ (!e & g)).wrapping_add(*k).wrapping_add(w);
            let s0 = a.rotate_right(2) ^ a.rotate_right(13) ^ a.rotate_right(22);
            let t2 = s0.wrapping_add((a & b) ^ (a & c) ^ (b & c));
            (h, g, f, e, d, c, b, a) = (g, f, e, d.wrapping_add(t1), c, b, a, t1.wrapping_add(t2));
        }
        for (total, value) in self.state.iter_mut().zip([a, b, c, d, e, f, g, h]) {
            *total = total.wrapping_add(value);
        }
    }
}

/// A stream, and the digest of what was read from it. Behind a reader of a whole certificate it is the digest
/// of the bytes that were checked, even if the file changes meanwhile.
pub struct Hashed<'a> {
    stream: &'a mut dyn Read,
    hash: Sha256,
}

impl<'a> Hashed<'a> {
    /// Of which nothing is read yet.
    pub fn new(stream: &'a mut dyn Read) -> Hashed<'a> {
        Hashed { stream, hash: Sha256::default() }
    }

    /// The digest of the bytes that were read, in hexadecimal, lower case.
    pub fn finish(self) -> String {
        self.hash.finish()
    }
}

impl Read for Hashed<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.stream.read(buffer)?;
        self.hash.update(&buffer[..count]);
        Ok(count)
    }
}

/// The digest of a message in hexadecimal.
pub(crate) fn sha256(message: &[u8]) -> String {
    let mut hash = Sha256::default();
    hash.update(message);
    hash.finish()
}

/// The first 32 bits of the fractions of the cube roots of the first 64 primes, and of the square roots of
/// the first 8.
fn constants() -> ([u32; 64], [u32; 8]) {
    let primes: Vec<u128> = (2..).filter(|n| (2..*n).all(|d| n % d != 0)).take(64).collect();
    // ⌊p^(1/power)·2³²⌋, whose power is at most p·2^(32 power): the greatest, by bits.
    let root = |p: u128, power: u32| {
        let fits = |x: u128| x.pow(power) <= p << (32 * power);
        (0..36).rev().fold(0u128, |x, bit| if fits(x | 1 << bit) { x | 1 << bit } else { x }) as u32
    };
    (std::array::from_fn(|i| root(primes[i], 3)), std::array::from_fn(|i| root(primes[i], 2)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digests_are_those_of_the_standard() {
        assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        assert_eq!(sha256(b""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        let two_blocks = b"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
        assert_eq!(sha256(two_blocks), "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    }

    /// However a message is cut, it has one digest.
    #[test]
    fn portions_do_not_matter() {
        let message: Vec<u8> = (0..300u32).map(|i| (i * 7) as u8).collect();
        for length in [0, 1, 55, 56, 63, 64, 65, 119, 120, 128, 300] {
            for portion in [1, 3, 63, 64, 65, 200] {
                let mut hash = Sha256::default();
                message[..length].chunks(portion).for_each(|part| hash.update(part));
                assert_eq!(hash.finish(), sha256(&message[..length]), "{length} bytes by {portion}");
            }
        }
        // As a stream, too, of which half is read.
        let mut stream = &message[..];
        let mut hashed = Hashed::new(&mut stream);
        hashed.read_exact(&mut [0; 150]).unwrap();
        assert_eq!(hashed.finish(), sha256(&message[..150]));
        // From Python's hashlib.
        assert_eq!(sha256(&message), "9a76b8af8f16f19d60de2b3999c22f9d10be4395c90ea3bfc5eb6cd6254243af");
    }
}
