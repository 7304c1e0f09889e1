//! Certificates of kind entropy: rules that random damage hardly ever touches.

use crate::common::{ENTROPY, answer, rejected, with};

#[test]
fn what_is_written_passes_and_is_named() {
    let expected = "\
proved, entropy
  case + -: 1699/3125 < z < 54369/100000; 7 bounds of words, the last of every K >= 3
  case + +: 31869/50000 < z < 63739/100000; 8 bounds of words, the last of every K >= 4";
    assert_eq!(answer(ENTROPY).unwrap().to_string(), expected);
}

/// The example in the head of the module, and the other rules.
#[test]
fn every_rule_is_kept() {
    // The line of K = 3 in the first case.
    let line = ENTROPY.lines().find(|line| line.starts_with("bound - ")).unwrap();
    let replaced = |lines: &str| with(ENTROPY, line, lines);
    assert!(answer(&replaced("bound - 8 7 8")).is_ok());
    let second = |start: &str, lines: &str| {
        let (head, tail) = ENTROPY.split_at(ENTROPY.find("\ncase + +").unwrap() + 1);
        head.to_string() + &with(tail, start, lines)
    };
    for (text, says) in [
        (replaced("bound - 8 5 8"), "false: the entry 2 of M v is not below that of v"),
        // 43.5 + 80 t < 55 for t = z⁴/(1 − z³), not for z⁴/(1 − z): periods grow by the lesser neighbour.
        (replaced("bound - 80 55 80"), "false: the entry 2 of M v is not below that of v"),
        (replaced("bound - 0 0 0"), "false: the entry 1"),
        (replaced("bound - 8 7"), "malformed: expected an entry of v"),
        (replaced("bound - 8 7 8 8"), "malformed: unexpected words"),
        (replaced("bound - 8 7 1000001"), "malformed: expected an entry of v, a number from 0 to 1000000"),
        (replaced("ends - 8 7"), "malformed: expected a line \"bound U …\" or \"ends U …\""),
        (replaced(""), "malformed: expected a line \"bound - …\" or \"ends - …\""),
        (with(ENTROPY, "first 3", ""), "malformed: expected a line \"first 3\""),
        (with(ENTROPY, "bound U ", ""), "malformed: expected a line \"bound U …\""),
        (with(ENTROPY, "bound DDDDDU", ""), "malformed: expected a line \"bound DDDDDU …\""),
        (with(ENTROPY, "bound DU", "ends DU 9 9 9 9"), "false: the entry"),
        // Bounds that do not hold the root, or are too far from it for a vector.
        (with(ENTROPY, "root", "root 1699/3125 6796/12500"), "malformed"),
        (with(ENTROPY, "root", "root 53/100 1699/3125"), "false: the second bound is not certainly above"),
        (with(ENTROPY, "root", "root 54369/100000 11/20"), "false: the first bound is not certainly below"),
        (with(ENTROPY, "root", "root 1/3 54369/100000"), "false: the bounds do not ascend between"),
        (with(ENTROPY, "root", "root 34/100 7/10"), "malformed"),
        (with(ENTROPY, "root", "root 17/50 7/10"), "false: the entry"),
        (with(ENTROPY, "root", "root 1699/3125 11/20"), "false: the entry"),
        (second("root", "root 31869/50000 16/25"), "false: the entry"),
        (second("ends U ", ""), "malformed: expected a line \"bound U …\" or \"ends U …\""),
        (second("ends U ", "ends U 5 5 5"), "false: the entry"),
        (second("bound UDUUUD", ""), "malformed: expected a line \"bound UDUUUD …\""),
        (second("first 4", "first 5"), "malformed: expected a line \"first 4\""),
        (ENTROPY.to_string() + "first 5\n", "malformed: the file goes on"),
        (ENTROPY[..ENTROPY.find("\ncase + +").unwrap() + 1].to_string(), "malformed: the file ends where"),
        (with(ENTROPY, "case", "case + +"), "malformed: expected a line \"case + -\""),
    ] {
        let why = rejected(&text);
        assert!(why.contains(says), "{why}, expected {says}");
    }
}

/// Each entry of each vector, set to 1 or doubled alone: most are refused, none is a panic.
#[test]
fn vectors_bound_what_they_say() {
    let (mut refused, mut all) = (0, 0);
    for (at, line) in ENTROPY.lines().enumerate() {
        if !line.starts_with("bound") && !line.starts_with("ends") {
            continue;
        }
        let words: Vec<&str> = line.split(' ').collect();
        for place in 2..words.len() {
            let twice = (2 * words[place].parse::<u64>().unwrap()).to_string();
            for other in ["1", twice.as_str()] {
                let mut changed = words.clone();
                changed[place] = other;
                let changed = changed.join(" ");
                let lines = ENTROPY.lines().enumerate();
                let text: String =
                    lines.map(|(i, line)| format!("{}\n", if i == at { &changed } else { line })).collect();
                all += 1;
                refused += usize::from(answer(&text).is_err());
            }
        }
    }
    assert!(all > 100 && refused * 10 > all * 8, "{refused} of {all}");
}
