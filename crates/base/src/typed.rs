//! What hands and other programs type where a number or a line of TOML is wanted, and what to write instead.

use crate::quantity::Unit;

/// What is wrong with a text that is no number, or with an expression, if it is known.
///
/// ```
/// use grazing_base::typed::in_number;
/// assert_eq!(in_number("0,5").as_deref(), Some("0,5 has a decimal comma: write 0.5"));
/// assert_eq!(in_number("1.000,5").as_deref(), Some("1.000,5 has a decimal comma: write 1000.5"));
/// let meant = in_number("1,000,000").unwrap();
/// assert_eq!(meant, "1,000,000 has a comma between thousands: write 1000000");
/// assert_eq!(in_number("4·10^2").as_deref(), Some("· is no product of numbers here: write *"));
/// assert_eq!(in_number("0.5"), None);
/// ```
pub fn in_number(text: &str) -> Option<String> {
    if let Some(meant) = in_numbers(text) {
        return Some(meant);
    }
    if let Some((found, meant)) = spaced(text) {
        return Some(format!("{found} has spaces between its digits: write {meant}"));
    }
    text.contains("+/-").then(|| "+/- is written ± or +-".to_string())
}

/// The same of a list of numbers, between which there may be spaces.
fn in_numbers(text: &str) -> Option<String> {
    if let Some(sign) = text.chars().find(|c| matches!(c, '\u{2212}' | '\u{2013}' | '\u{2010}' | '\u{2011}'))
    {
        return Some(format!("{sign} (U+{:04X}) is not the minus of a keyboard: write -", u32::from(sign)));
    }
    if let Some((found, meant)) = decimal_comma(text) {
        let is_decimal = found.rfind(',') > found.rfind('.') && found.matches(',').count() == 1;
        let comma = if is_decimal { "a decimal comma" } else { "a comma between thousands" };
        return Some(format!("{found} has {comma}: write {meant}"));
    }
    if let Some((sign, _)) = text.char_indices().find(|&(i, c)| {
        let next = text[i + c.len_utf8()..].trim_start();
        matches!(c, '·' | '⋅' | '×') && next.starts_with(|c: char| c.is_ascii_digit())
    }) {
        let sign = &text[sign..].chars().next().unwrap_or('·');
        return Some(format!("{sign} is no product of numbers here: write *"));
    }
    if let Some(half) = text.chars().find(|c| matches!(c, '½' | '¼' | '¾')) {
        let meant = match half {
            '½' => "1/2",
            '¼' => "1/4",
            _ => "3/4",
        };
        return Some(format!("{half} is one character: write {meant}"));
    }
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
    let special = words.map(str::to_lowercase).find(|word| matches!(&word[..], "nan" | "inf" | "infinity"));
    special.map(|word| format!("{word} is no number here: every number is finite"))
}

/// A number with a comma, decimal or between thousands, and without.
fn decimal_comma(text: &str) -> Option<(String, String)> {
    let mut all = text.split(|c: char| !(c.is_ascii_digit() || matches!(c, ',' | '.')));
    let found = all.find_map(|part| {
        let part = part.trim_matches([',', '.']);
        part.contains(',').then_some(part)
    })?;
    // The last sign is the decimal one, unless there are several of it.
    let (whole, part) = found.rsplit_once([',', '.'])?;
    let last = &found[whole.len()..found.len() - part.len()];
    let point = if whole.contains(last) { "" } else { "." };
    Some((found.to_string(), format!("{}{point}{part}", whole.replace([',', '.'], ""))))
}

/// A number with spaces between its thousands, and without.
fn spaced(text: &str) -> Option<(String, String)> {
    let all: Vec<&str> = text.split_whitespace().collect();
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|c| c.is_ascii_digit());
    let is_thousand = |part: &&str| part.len() == 3 && digits(part);
    let first =
        (1..all.len()).find(|&i| digits(all[i - 1]) && all[i - 1].len() <= 3 && is_thousand(&all[i]))? - 1;
    let count = 1 + all[first + 1..].iter().take_while(|part| is_thousand(part)).count();
    let found = &all[first..first + count];
    Some((found.join(" "), found.concat()))
}

/// What is wrong with a line that is no TOML, if it is known.
///
/// ```
/// use grazing_base::typed::in_line;
/// let meant = in_line("zeta = 4 %").unwrap();
/// assert_eq!(meant, "a number with a unit is a text: write zeta = \"4 %\"");
/// assert!(in_line("title = “a”").unwrap().contains("quotes"));
/// assert!(in_line("title\u{a0}= a").unwrap().contains("U+00A0"));
/// assert_eq!(in_line("a = 1 # 0,5"), None);
/// ```
pub fn in_line(line: &str) -> Option<String> {
    let line = line.split('#').next().unwrap_or(line);
    if let Some(quote) = line.chars().find(|c| matches!(c, '“' | '”' | '„' | '‘' | '’' | '«' | '»'))
    {
        return Some(format!("{quote} is not one of the quotes of a keyboard: write \"…\""));
    }
    if let Some(space) = line.chars().find(|c| c.is_whitespace() && !c.is_ascii()) {
        return Some(format!(
            "a space in it is U+{:04X}, not that of a keyboard: type it anew",
            u32::from(space)
        ));
    }
    let (key, value) = line.split_once('=')?;
    let (key, value) = (key.trim(), value.trim());
    if !key.is_ascii() && !key.starts_with('"') {
        return Some("a name is a letter from a to z, then letters, digits and _".to_string());
    }
    if value.starts_with('"') && value.matches('"').count() == 1 {
        return Some(format!("the closing quote is missing: write {key} = {value}\""));
    }
    if value.starts_with(['"', '\'']) {
        return None;
    }
    if value.starts_with(['[', '{']) {
        return in_numbers(&value.replace(", ", " ")).or_else(|| bare_word(value));
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

/// A word without quotes in a list or a table of one line.
fn bare_word(value: &str) -> Option<String> {
    let mut parts = value.split('=').map(str::trim);
    let mut key = parts.next()?;
    parts.find_map(|part| {
        let word = part.split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap_or_default();
        let name = key.rsplit(['{', ',', ' ']).find(|name| !name.is_empty()).unwrap_or_default();
        key = part;
        let is_name = word.starts_with(|c: char| c.is_alphabetic()) && !matches!(word, "true" | "false");
        is_name.then(|| format!("a formula is a text: write {name} = \"{word}\""))
    })
}
