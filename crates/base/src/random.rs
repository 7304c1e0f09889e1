//! Repeatable random choices: SplitMix64 of Steele, Lea and Flood, the same numbers on every machine.

/// The generator, from any state.
#[derive(Debug, Clone)]
pub struct Random(pub u64);

impl Random {
    /// The stream of one unit of work: it depends on the seed and the unit alone, whatever thread runs it.
    pub fn of_unit(seed: u64, unit: u64) -> Self {
        let mut random = Random(seed);
        let mixed = random.bits() ^ unit.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        Random(mixed)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `bound`; the bias of the remainder does not matter where this is used.
    pub fn below(&mut self, bound: u64) -> u64 {
        self.bits() % bound
    }

    /// A whole number in `low..=high`.
    pub fn within(&mut self, low: u64, high: u64) -> u64 {
        low + self.below(high - low + 1)
    }

    /// True with probability 1/2.
    pub fn coin(&mut self) -> bool {
        self.bits() >> 63 == 1
    }
}
