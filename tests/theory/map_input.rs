//! Maps as TOML: exact entries, and errors that name file, line, key, value and condition.

use grazing::{number::parse_rational, pattern::Map};

const GOOD: &str = r#"format = "grazing-map 1"
A = [[0.9, 1], ["-3/5", 0]]
B = [0, 1]
C = [1, 0]
e = 1
"#;

fn read(text: &str) -> Result<Map, String> {
    Map::from_toml(text, "m.toml").map_err(|error| {
        assert!(error.is_input() && error.to_string().lines().count() == 1);
        error.to_string()
    })
}

fn with(from: &str, to: &str) -> Result<Map, String> {
    assert!(GOOD.contains(from));
    read(&GOOD.replace(from, to))
}

#[test]
fn numbers_are_exact() {
    for (text, value) in [
        ("0.1", "1/10"),
        ("1e-30", "1e-30"),
        ("1_000.5", "2001/2"),
        ("-7", "-7"),
        ("+0.25", "1/4"),
        ("0.1234567890123456789012345678901234567890", "0.1234567890123456789012345678901234567890"),
        ("1e-400", "1e-400"),
        ("\"1/3\"", "1/3"),
        ("\"1-2^-200\"", "1-2^-200"),
        ("{ lo = 0.1, hi = \"1/10\" }", "0.1"),
    ] {
        let map = with("0.9", text).unwrap();
        assert_eq!(map.a()[(0, 0)].exact(), Some(&parse_rational(value).unwrap()), "{text}");
        assert!(map.is_exact());
    }
    let map = with("0.9", "{ lo = \"1/3\", hi = \"0.4\" }").unwrap();
    assert_eq!((map.is_exact(), map.a()[(0, 0)].to_string()), (false, "[1/3, 2/5]".into()));
    let map = read(&format!("{GOOD}P = [[1, 2], [0, 1]]\n")).unwrap();
    assert_eq!(map.section().unwrap()[(0, 1)].to_string(), "2");
}

#[test]
fn every_failure_names_entry_value_and_condition() {
    let cases = [
        (
            "0.9",
            "[0.8, 1.0]",
            "m.toml:2: A[1][1] = [0.8, 1.0]: is an array, not a number; an interval is { lo = \"…\", hi = \"…\" }",
        ),
        ("0.9", "nan", "m.toml:2: A[1][1] = nan: \"nan\" is not a number: expected a digit, found 'n'"),
        ("0.9", "0x10", "m.toml:2: A[1][1] = 0x10: \"0x10\" is not a number"),
        ("0.9", "true", "m.toml:2: A[1][1] = true: is not a number"),
        ("0.9", "\"x\"", "m.toml:2: A[1][1] = \"x\": \"x\" is not a number"),
        ("0.9", "{ lo = 1 }", "A[1][1] = { lo = 1 }: an interval needs both lo and hi; hi is missing"),
        ("0.9", "{ lo = 1, hi = 0 }", "A[1][1] = { lo = 1, hi = 0 }: lo = 1 is above hi = 0"),
        ("0.9", "{ lo = 1, hi = 2, high = 3 }", "unknown key \"high\"; known here are lo, hi"),
        ("0.9", "123456789012345678901234567890", "can be written as a string"),
        (
            "0.9, 1",
            "0.9, 1, 2",
            "m.toml:2: A = [[0.9, 1, 2], [\"-3/5\", 0]]: row 1 has 3 entries, but there are 2 rows; it must be square",
        ),
        ("[[0.9, 1], [\"-3/5\", 0]]", "[]", "m.toml:2: A = []: has no rows"),
        (
            "[[0.9, 1], [\"-3/5\", 0]]",
            "[[0.5]]",
            "N = 1 is too small: C B = 0 with B and C not 0 needs N ≥ 2",
        ),
        ("[[0.9, 1], [\"-3/5\", 0]]", "7", "m.toml:2: A = 7: is not an array of rows"),
        ("[[0.9, 1], [\"-3/5\", 0]]", "[[1, 1], [0, 0.5]]", "det(I − A) = 0; det(I − A) ≠ 0 is needed (23)"),
        ("0.9", "{ lo = 1.5, hi = 1.7 }", "the enclosure of det(I − A) contains 0"),
        ("B = [0, 1]", "B = [0, 1, 2]", "m.toml:3: B = [0, 1, 2]: 3 entries, but A is 2 × 2"),
        ("B = [0, 1]", "B = [0, 0]", "m.toml:3: B = [0, 0]: [0, 0] is zero; B ≠ 0 is needed (5)"),
        ("B = [0, 1]", "B = [0.5, 1]", "m.toml:3: B = [0.5, 1]: C B = 1/2; C B = 0 is needed (5)"),
        ("B = [0, 1]", "B = [{ lo = 1, hi = 2 }, 1]", "C B lies in [1, 2], which does not contain 0"),
        ("B = [0, 1]", "B = 1", "m.toml:3: B = 1: is not an array of numbers"),
        (
            "C = [1, 0]",
            "C = [{ lo = -1, hi = 1 }, 0]",
            "m.toml:4: C = [{ lo = -1, hi = 1 }, 0]: [[-1, 1], 0] may be zero; C ≠ 0 is needed (5)",
        ),
        ("C = [1, 0]", "C = [1, 0]\nc = 2", "m.toml:5: unknown key \"c\"; the nearest known key is \"C\""),
        ("e = 1", "E = 1", "m.toml:5: unknown key \"E\"; the nearest known key is \"e\""),
        ("e = 1", "", "m.toml: there is no key e; a map has format, A, B, C, e"),
        ("e = 1", "e = []", "m.toml:5: e = []: is an array, not a number"),
        ("e = 1", "e = 1\nfromat = 2", "unknown key \"fromat\"; the nearest known key is \"format\""),
        (
            "e = 1",
            "e = 1\nP = [[1, 1], [1, 1]]",
            "m.toml:6: P = [[1, 1], [1, 1]]: det P = 0; P must be invertible (12)",
        ),
        ("e = 1", "e = 1\nP = [[1]]", "m.toml:6: P = [[1]]: 1 rows, but A has 2"),
        (
            "grazing-map 1",
            "grazing-map 2",
            "m.toml:1: format = \"grazing-map 2\": this version reads \"grazing-map 1\"",
        ),
        ("C = [1, 0]", "C = [1, 0", "m.toml:"),
    ];
    for (from, to, message) in cases {
        let error = with(from, to).unwrap_err();
        assert!(error.contains(message), "{to}\n  {error}\n  {message}");
    }
}

#[test]
fn what_is_doubtful_is_said() {
    let note = |map: Map| map.notes().join("|");
    assert_eq!(note(read(GOOD).unwrap()), "");
    assert!(note(with("e = 1", "e = 0").unwrap()).contains("nothing is claimed for either sign"));
    assert!(note(with("e = 1", "e = { lo = -1, hi = 1 }").unwrap()).contains("contains 0"));
    let map = with("B = [0, 1]", "B = [{ lo = -0.1, hi = 0.1 }, 1]").unwrap();
    assert_eq!(note(map), "C B lies in [-1/10, 1/10]; taken to be 0");
}

#[test]
fn the_example_maps_are_read() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/maps");
    let mut count = 0;
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        Map::from_toml(&std::fs::read_to_string(&path).unwrap(), "map").unwrap();
        count += 1;
    }
    assert!(count >= 3);
}
