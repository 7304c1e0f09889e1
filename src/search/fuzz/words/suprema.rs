//! Whether the word of any point has an entropy above the supremum, for eµ > 0 in region 3. Random words on
//! r = 1 are asked. Certificates of kind `entropy` prove that none has.

use num_integer::Integer;
use num_traits::ToPrimitive;

use super::WordTally;
use crate::{
    random::Random,
    word::{Entropy, Letter, Word},
};

/// The suprema of the entropy for eµ > 0 in region 3: in (+,−), as s → 1/2 on r = 1, the
/// logarithm of the tribonacci constant, rounded up; in (+,+), as s → 1/4 from above, 0.450385…, rounded up.
pub const SUPREMA: [f64; 2] = [0.450_386, 0.609_377_863_437];

/// The largest denominator of a random word.
const LONGEST_WORD: u64 = 400;

/// A random fraction m/n in lowest terms, 0 < m/n < ½, often near where the suprema are.
fn fraction(random: &mut Random) -> (u64, u64) {
    let n = random.within(3, LONGEST_WORD);
    let m = match random.within(0, 3) {
        0 => (n - 1) / 2,
        1 => n / 4 + random.within(0, 2),
        _ => random.within(1, (n - 1) / 2),
    }
    .clamp(1, (n - 1) / 2);
    let g = m.gcd(&n);
    (m / g, n / g)
}

/// A random word on r = 1, down the tree to a random fraction, and its entropies.
pub(super) fn entropies(random: &mut Random, tally: &mut WordTally) {
    let (m, n) = fraction(random);
    let letter = if random.coin() { Letter::U } else { Letter::D };
    // s lies next to m/n, below it for U; K is the least with 2Ks > 1.
    let first = if letter == Letter::U { n / (2 * m) + 1 } else { n.div_ceil(2 * m) };
    let Some(word) = Word::of_area(n, m, letter, first.max(2)) else { return };
    tally.words += 1;
    for (index, gamma) in [true, false].into_iter().enumerate() {
        let Ok((entropy, _)) = Entropy::of(&word, gamma, 40) else { continue };
        let Some((low, _)) = entropy.bounds() else { continue };
        let rate = low.to_f64().unwrap_or(0.0);
        let side = if letter == Letter::U { "below" } else { "above" };
        if rate > tally.largest[index] {
            tally.largest[index] = rate;
            tally.largest_at[index] = format!("s just {side} {m}/{n}");
        }
        // The lower bound, rounded by 2⁻⁵³ at most, is above a number rounded up by more.
        if rate > SUPREMA[index] {
            let case = if gamma { "(+,+)" } else { "(+,-)" };
            tally.beyond.push(format!("{case}: entropy {rate:?} for s just {side} {m}/{n}, r = 1"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ends of the range too: n = 3 has one such fraction, and n/4 is 0 there.
    #[test]
    fn random_fractions_lie_between_0_and_a_half() {
        let mut least = u64::MAX;
        for unit in 0..200_000 {
            let (m, n) = fraction(&mut Random::of_unit(1, unit));
            assert!(0 < m && 2 * m < n && m.gcd(&n) == 1, "{m}/{n}");
            least = least.min(n);
        }
        assert_eq!(least, 3);
    }
}
