//! What the graph of letters alone decides: that different paths are different motions, but for finitely
//! many, and how fast they grow.
//!
//! M_{vw} = z^{n_w} for every edge v → w. If Mγ ≥ γ for a positive vector γ, the paths of N periods grow at
//! least like z⁻ᴺ; if Mγ ≤ γ, at most so. At a vertex whose successors have different periods a path is told
//! by its periods and where it starts; likewise backwards.

use super::{fixed::Interval, text::Certificate};

/// Proves the growth rate, and that paths are told by their periods.
pub(super) fn grows(certificate: &Certificate) -> Result<(), String> {
    let letters = &certificate.letters;
    let distinct = |mut periods: Vec<u64>| {
        let count = periods.len();
        periods.sort_unstable();
        periods.dedup();
        periods.len() == count
    };
    let of = |list: &mut dyn Iterator<Item = usize>| list.map(|v| letters[v].periods).collect::<Vec<_>>();
    let forward = letters.iter().all(|letter| distinct(of(&mut letter.next.iter().copied())));
    let backward = (0..letters.len())
        .all(|v| distinct(of(&mut (0..letters.len()).filter(|&m| letters[m].next.contains(&v)))));
    if !forward && !backward {
        return Err(
            "a letter has two successors of the same period, and one has two such predecessors".into()
        );
    }
    let [least, most] = certificate.growth.map(|growth| Interval::ONE.over(growth.enclosed()));
    for (v, letter) in letters.iter().enumerate() {
        let sum = |z: Interval| {
            letter.next.iter().fold(Interval::ZERO, |sum, &w| {
                sum + power(z, letters[w].periods) * letters[w].growth.enclosed()
            })
        };
        let own = letter.growth.enclosed();
        if !own.is_up_to(sum(least)) {
            return Err(format!("the growth vector does not prove the lower rate at letter {}", v + 1));
        }
        if !sum(most).is_up_to(own) {
            return Err(format!("the growth vector does not prove the upper rate at letter {}", v + 1));
        }
    }
    Ok(())
}

fn power(z: Interval, n: u64) -> Interval {
    (0..n).fold(Interval::ONE, |product, _| product * z)
}
