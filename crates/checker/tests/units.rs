//! Units of oscillators' certificates: they are named, sealed by the digest, and change no verdict.

use crate::common::{BRANCH, FLIP, FREE, ORBIT_4, answer, first_cells, rejected, resealed, second_reader};

/// With this line before the first coefficient.
fn in_units(text: &str, line: &str) -> String {
    text.replacen("\ndamping", &format!("\n{line}\ndamping"), 1)
}

#[test]
fn units_are_said_and_change_no_verdict() {
    let branch = first_cells(BRANCH, 1);
    for (text, line) in [
        (ORBIT_4, "units -9 0"),
        (FREE, "units 99 0"),
        (FLIP, "units 3 -99"),
        (FLIP, "units 0 2"),
        (&branch, "units -6 -6"),
    ] {
        let other = in_units(text, line);
        assert!(rejected(&other).contains("the digest is not that of the system"), "{line}");
        let (own, said) = (answer(text).unwrap(), answer(&resealed(&other)).unwrap());
        let said = said.detail.iter().map(|(name, value)| format!("{name}: {value}")).collect::<Vec<_>>();
        let words: Vec<&str> = line.split(' ').collect();
        let lengths = format!("lengths, speeds, forces and walls are listed in units of 10^{}", words[1]);
        assert_eq!(said.contains(&format!("units: {lengths}")), words[1] != "0", "{said:?}");
        let parameter = said.iter().find(|row| row.starts_with("parameter: "));
        let ends = format!(", in units of 10^{}", words[2]);
        assert_eq!(parameter.is_some_and(|row| row.contains(&ends)), words[2] != "0", "{said:?}");
        assert!(own.detail.iter().all(|(_, value)| !value.contains("in units of")));
    }
}

#[test]
fn units_have_one_form() {
    for (text, line, expected) in [
        (ORBIT_4, "units 0 0", "units are listed where they are not 1"),
        (ORBIT_4, "units 1 1", "there is no parameter that could have a unit"),
        (FREE, "units 0 -3", "there is no parameter that could have a unit"),
        (FLIP, "units 100 0", "expected a whole number from -99 to 99"),
        (FLIP, "units -0 1", "expected a whole number from -99 to 99"),
        (BRANCH, "units +1 1", "expected a whole number from -99 to 99"),
        (BRANCH, "units 1", "expected a power of ten"),
        (BRANCH, "units 1 1 1", "unexpected words at the end"),
        (BRANCH, "units 1 1\nunits 1 1", "expected a line \"damping"),
    ] {
        let why = rejected(&resealed(&in_units(text, line)));
        assert!(why.contains(expected), "{line}: {why}");
    }
    let late = resealed(&ORBIT_4.replacen("\nstiffness", "\nunits 1 0\nstiffness", 1));
    assert!(rejected(&late).contains("expected a line \"stiffness"));
}

/// The second readers, which were written from the form alone.
#[test]
fn second_readers_agree_about_units() {
    let branch = first_cells(BRANCH, 1);
    for (script, text) in [("branch.py", branch.as_str()), ("free.py", FREE)] {
        let lines =
            ["units -9 0", "units -9 7", "units 0 0", "units 0 3", "units -0 1", "units 100 0", "units 1"];
        let all: Vec<String> = lines.iter().map(|line| resealed(&in_units(text, line))).collect();
        let Some(verdicts) = second_reader(script, &all) else { return };
        for (text, line) in all.iter().zip(&verdicts) {
            assert_eq!(answer(text).is_ok(), line.contains(": proved"), "{line}\n{text}");
        }
        assert!(verdicts[0].contains(": proved") && !verdicts[2].contains(": proved"), "{verdicts:?}");
    }
}
