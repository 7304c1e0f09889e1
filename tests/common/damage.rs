//! Damaged certificates of oscillators.

use proptest::prelude::*;

/// What happens to a text.
#[derive(Debug, Clone)]
pub enum Damage {
    Remove(prop::sample::Index),
    Swap(prop::sample::Index, prop::sample::Index),
    Truncate(prop::sample::Index),
    /// Replace a word by one from elsewhere in the file.
    Transplant(prop::sample::Index, prop::sample::Index),
    Byte(prop::sample::Index, u8),
    Insert(prop::sample::Index, u8),
}

/// Any damage.
pub fn damage() -> impl Strategy<Value = Damage> {
    let index = any::<prop::sample::Index>;
    prop_oneof![
        1 => index().prop_map(Damage::Remove),
        1 => (index(), index()).prop_map(|(a, b)| Damage::Swap(a, b)),
        1 => index().prop_map(Damage::Truncate),
        3 => (index(), index()).prop_map(|(a, b)| Damage::Transplant(a, b)),
        4 => (index(), prop::sample::select(b"0123456789-/. ".to_vec())).prop_map(|(at, byte)| Damage::Byte(at, byte)),
        2 => (index(), prop::sample::select(b"0123456789-/. \r\n".to_vec())).prop_map(|(at, byte)| Damage::Insert(at, byte)),
    ]
}

/// The text after the damage, which falls on the lines from `first` on.
pub fn damaged(text: &str, first: usize, damage: &Damage) -> String {
    let mut lines: Vec<String> = text.lines().map(String::from).collect();
    let head: usize = lines[..first].iter().map(|line| line.len() + 1).sum();
    let count = lines.len() - first;
    let words: Vec<(usize, usize)> =
        (first..lines.len()).flat_map(|i| (0..lines[i].split(' ').count()).map(move |j| (i, j))).collect();
    match damage {
        Damage::Remove(at) => drop(lines.remove(first + at.index(count))),
        Damage::Swap(a, b) => lines.swap(first + a.index(count), first + b.index(count)),
        Damage::Truncate(at) => return text[..head + at.index(text.len() - head)].to_string(),
        Damage::Transplant(from, to) => {
            let ((i, j), (k, l)) = (words[from.index(words.len())], words[to.index(words.len())]);
            let word = lines[i].split(' ').nth(j).unwrap().to_string();
            let mut parts: Vec<&str> = lines[k].split(' ').collect();
            parts[l] = &word;
            lines[k] = parts.join(" ");
        }
        Damage::Insert(at, byte) => {
            let mut bytes = text.as_bytes().to_vec();
            bytes.insert(head + at.index(text.len() - head), *byte);
            return String::from_utf8(bytes).unwrap();
        }
        Damage::Byte(at, byte) => {
            let mut bytes = text.as_bytes().to_vec();
            bytes[head + at.index(text.len() - head)] = *byte;
            return String::from_utf8(bytes).unwrap();
        }
    }
    lines.join("\n") + "\n"
}
