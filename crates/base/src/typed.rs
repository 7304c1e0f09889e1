//! What hands and other programs type where a number or a line of TOML is wanted, and what to write instead.

use crate::quantity::Unit;

/// What is wrong with a text that is no number, or with an expression, if it is known.
///
/// ```
/// use grazing_base::typed::in_number;
/// assert_eq!(in_number("0,5").as_deref(), Some("0,5 has a decimal comma: write 0.5"));
/// assert_eq!(in_number("0.5"), None);
/// ```
pub fn in_number(text: &str) -> Option<String> {
    if let Some(sign) = text.chars().find(|c| matches!(c, '\u{2212}' | '\u{2013}' | '\u{2010}' | '\u{2011}'))
    {
        return Some(format!("{sign} (U+{:04X}) is not the minus of a keyboard: write -", u32::from(sign)));
    }
    if let Some((found, meant)) = decimal_comma(text) {
        return Some(format!("{found} has a decimal comma: write {meant}"));
    }
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
    let special = words.map(str::to_lowercase).find(|word| matches!(&word[..], "nan" | "inf" | "infinity"));
    special.map(|word| format!("{word} is no number here: every number is finite"))
}

/// A number with a decimal comma, and with a point.
fn decimal_comma(text: &str) -> Option<(String, String)> {
    let all: Vec<char> = text.chars().collect();
    let digit = |i: Option<usize>| i.and_then(|i| all.get(i)).is_some_and(char::is_ascii_digit);
    let comma = (0..all.len()).find(|&i| all[i] == ',' && digit(i.checked_sub(1)) && digit(Some(i + 1)))?;
    let first = (0..comma).rev().take_while(|&i| digit(Some(i))).last()?;
    let last = (comma + 1..all.len()).take_while(|&i| digit(Some(i))).last()?;
    let found: String = all[first..=last].iter().collect();
    let meant = found.replacen(',', ".", 1);
    Some((found, meant))
}

/// What is wrong with a line that is no TOML, if it is known.
///
/// ```
/// use grazing_base::typed::in_line;
/// let meant = in_line("zeta = 4 %").unwrap();
/// assert_eq!(meant, "a number with a unit is a text: write zeta = \"4 %\"");
/// assert!(in_line("title = “a”").unwrap().contains("quotes"));
/// assert_eq!(in_line("a = 1 # 0,5"), None);
/// ```
pub fn in_line(line: &str) -> Option<String> {
    let line = line.split('#').next().unwrap_or(line);
    if let Some(quote) = line.chars().find(|c| matches!(c, '“' | '”' | '„' | '‘' | '’' | '«' | '»'))
    {
        return Some(format!("{quote} is not one of the quotes of a keyboard: write \"…\""));
    }
    let (key, value) = line.split_once('=')?;
    let (key, value) = (key.trim(), value.trim());
    if value.starts_with(['"', '\'', '[', '{']) {
        return value.starts_with(['[', '{']).then(|| in_number(&value.replace(", ", " "))).flatten();
    }
    let start = value.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | '_')))?;
    if start > 0 && Unit::begin(value[start..].trim_start(), &|_, _| false).is_some() {
        return Some(format!("a number with a unit is a text: write {key} = \"{value}\""));
    }
    in_number(value).or_else(|| {
        let formula = value.contains(['*', '/', '^', '(']) || value.starts_with(|c: char| c.is_alphabetic());
        let is_word = matches!(value, "true" | "false");
        (formula && !is_word).then(|| format!("a formula is a text: write {key} = \"{value}\""))
    })
}
