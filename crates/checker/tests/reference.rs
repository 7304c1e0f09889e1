//! The checker and `reference/theorem2.py`, which was written from the format text alone, give the same
//! verdict on damaged files of all shapes.

use crate::common::{Random, THEOREM2, answer, second_reader};
use crate::samples::samples;
use grazing_check::theorem2::header;

/// A certificate of the periods from `first` to `last`, out of the sample.
fn part(first: usize, last: usize) -> Vec<String> {
    let mut n = 0;
    let mut body = Vec::new();
    for line in THEOREM2.lines().skip(5) {
        n += usize::from(line.starts_with("n "));
        if (first..=last).contains(&n) {
            body.push(line.to_string());
        }
    }
    let head = header(&(first as u64..=last as u64), body.len() as u64);
    head.lines().map(String::from).chain(body).collect()
}

/// Sets the numbers of lines right, of the block that holds line `at` and of all.
fn recount(lines: &mut [String], at: usize) {
    let Some(head) = (5..=at.min(lines.len() - 1)).rev().find(|&i| lines[i].starts_with("n ")) else {
        return;
    };
    let count = lines[head + 1..].iter().take_while(|line| !line.starts_with("n ")).count();
    let period = lines[head].split(' ').nth(1).unwrap_or_default();
    lines[head] = format!("n {period} {count}");
    lines[3] = format!("lines {}", lines.len() - 5);
}

fn word(random: &mut Random, lines: &[String]) -> String {
    let line = &lines[5 + random.below(lines.len() - 5)];
    random.pick(&line.split(' ').collect::<Vec<_>>()).to_string()
}

/// One damage, of lines or of bytes.
fn damage(random: &mut Random, mut lines: Vec<String>) -> Vec<u8> {
    let at = if random.below(6) == 0 { random.below(lines.len()) } else { 5 + random.below(lines.len() - 5) };
    let mut end = "\n";
    match random.below(14) {
        0 => drop(lines.remove(at)),
        1 => lines.insert(at, lines[at].clone()),
        2 => {
            let other = random.below(lines.len());
            lines.swap(at, other);
        }
        // A line, or two, or three, less, and the counts set right.
        3 => {
            for _ in 0..=random.below(3) {
                if at < lines.len() && at > 5 {
                    lines.remove(at);
                }
            }
            recount(&mut lines, at.saturating_sub(1));
        }
        // A line more, and the counts set right.
        4 => {
            let n = 1 + random.below(14);
            let half = ["0/1", "1/2", "1/4", "1/3", "1/6", "3/8"];
            let (left, right) = (random.pick(&half), random.pick(&half));
            let new = match random.below(4) {
                0 => format!("point {left} singular"),
                1 => {
                    format!("orbit {left} {right} {} {}", random.pick(&["+", "-"]), random.pick(&["+", "-"]))
                }
                2 => format!("point {left} boundary {n}"),
                _ => lines[at].clone(),
            };
            lines.insert((at + random.below(2)).max(6), new);
            recount(&mut lines, at);
        }
        // Two intervals made one, or one cut in two.
        5 => {
            let words: Vec<String> = lines[at].split(' ').map(String::from).collect();
            if words.len() == 5 {
                let cut = word(random, &lines);
                let reason = ["singular", "boundary 1", "excluded 1 2", "excluded 2 1"];
                let (kind, ends) = (&words[0], &words[3..].join(" "));
                let three = [
                    format!("{kind} {} {cut} {ends}", words[1]),
                    format!("point {cut} {}", random.pick(&reason)),
                    format!("{kind} {cut} {} {ends}", words[2]),
                ];
                lines.splice(at..=at, three);
                recount(&mut lines, at);
            }
        }
        6..=9 => {
            let new = word(random, &lines);
            let mut words: Vec<String> = lines[at].split(' ').map(String::from).collect();
            let j = random.below(words.len());
            words[j] = match random.below(5) {
                0 => words[j].parse().map_or(new, |k: u64| (k + 1).to_string()),
                1 => words[j].parse().map_or(new, |k: u64| k.saturating_sub(1).to_string()),
                2 => "9".repeat(1 + random.below(40)),
                _ => new,
            };
            lines[at] = words.join(" ");
        }
        10 => end = random.pick(&["\r\n", "\n", "\r", "\r\r\n", " \n", "\n\n"]),
        11 => lines[at] = format!("{}{}", lines[at], random.pick(&[" ", "\r", "\t", "é", "  x", "\u{661}"])),
        12 => lines[at] = "x".repeat(990 + random.below(20)),
        _ => {
            let mut bytes = (lines.join("\n") + "\n").into_bytes();
            let alphabet = b"0123456789+-/ \n\rnopst.\xff";
            let byte = alphabet[random.below(alphabet.len())];
            let at = random.below(bytes.len());
            match random.below(4) {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                2 => drop(bytes.remove(at)),
                _ => bytes.truncate(if random.below(2) == 0 { bytes.len() - 1 } else { at }),
            }
            return bytes;
        }
    }
    (lines.join(end) + end).into_bytes()
}

#[test]
fn two_readers_of_the_format_agree() {
    let parts =
        [(1, 1), (1, 3), (2, 2), (3, 5), (4, 4), (6, 6), (8, 8), (9, 9), (14, 14)].map(|(a, b)| part(a, b));
    let mut random = Random(crate::samples::seed(1));
    let (rounds, mut accepted, mut rejected) = (samples(2), 0, 0);
    for round in 0..rounds {
        let mut texts = Vec::new();
        for i in 0..1000 {
            let lines = parts[random.below(parts.len())].clone();
            let text =
                if i == 0 { (lines.join("\n") + "\n").into_bytes() } else { damage(&mut random, lines) };
            texts.push(text);
        }
        let Some(verdicts) = second_reader("theorem2.py", &texts) else { return };
        for (text, line) in texts.iter().zip(&verdicts) {
            let theirs = line.ends_with(": proved");
            let ours = grazing_check::check(&mut &text[..]);
            let shown = String::from_utf8_lossy(text);
            assert_eq!(ours.is_ok(), theirs, "{ours:?}, but {line} in round {round} of\n{shown}");
            *(if theirs { &mut accepted } else { &mut rejected }) += 1;
        }
    }
    println!("{accepted} accepted by both, {rejected} rejected by both");
    assert!(accepted > samples(100) && rejected > samples(1600), "{accepted} accepted, {rejected} rejected");
    assert!(answer(THEOREM2).is_ok());
}
