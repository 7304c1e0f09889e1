//! What holds for the text of every kind: ends of lines, limits, the wish to end.

mod common;
#[path = "../../../tests/samples/mod.rs"]
mod samples;

use std::io::{self, BufRead, BufReader, Read};

use common::{COVER, ORBIT_4, ORBIT_6, THEOREM2, WORD, WORD_BY_THEOREM, answer, rejected};
use grazing_check::{Rejection, check, check_until};

const ALL: [&str; 6] = [THEOREM2, COVER, ORBIT_4, ORBIT_6, WORD, WORD_BY_THEOREM];

#[test]
fn lines_may_end_as_on_other_systems_and_the_last_may_end_with_the_file() {
    for text in ALL {
        let checked = answer(text).unwrap();
        for other in
            [text.replace('\n', "\r\n"), text.trim_end().to_string(), text.trim_end().replace('\n', "\r\n")]
        {
            assert_eq!(answer(&other).unwrap(), checked);
        }
        for wrong in [
            text.replace('\n', "\r"),
            text.replace('\n', "\r\r\n"),
            text.replace('\n', " \n"),
            format!("{text}\n"),
        ] {
            rejected(&wrong);
        }
    }
}

#[test]
fn the_longest_line_is_1000_bytes_however_it_ends() {
    for end in ["\n", "\r\n", ""] {
        assert!(rejected(&("x".repeat(1000) + end)).contains("not a certificate of this format"));
        assert!(
            rejected(&("x".repeat(1001) + end)).ends_with("malformed: the line is longer than 1000 bytes")
        );
        assert!(
            rejected(&("x".repeat(1 << 20) + end)).ends_with("malformed: the line is longer than 1000 bytes")
        );
    }
}

/// Asked anywhere, the check ends there, and a file cut short by the wish to end is not called malformed.
#[test]
fn the_wish_to_end_is_heard_everywhere() {
    for text in ALL {
        let mut asked = 0;
        assert!(
            check_until(&mut text.as_bytes(), &mut || {
                asked += 1;
                false
            })
            .is_ok()
        );
        assert!(asked > text.lines().count(), "{asked}");
        for after in (0..asked).step_by(asked / 100 + 1) {
            let mut left = after as i64;
            let stop = &mut || {
                left -= 1;
                left < 0
            };
            let left_off = check_until(&mut text.as_bytes(), stop).unwrap_err();
            assert!(matches!(left_off, Rejection::Interrupted { .. }), "{left_off}");
        }
    }
}

/// Fails after some bytes.
struct Failing<'a>(&'a [u8]);

impl Read for Failing<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.0.read(buffer)?;
        if count == 0 { Err(io::Error::other("gone")) } else { Ok(count) }
    }
}

#[test]
fn a_stream_that_fails_is_unreadable_and_one_that_was_ended_is_interrupted() {
    let mut input = BufReader::new(Failing(THEOREM2.as_bytes()));
    let answer = check(&mut input).unwrap_err();
    assert!(matches!(answer, Rejection::Unreadable { line: 345, .. }), "{answer}");
    let mut input = BufReader::new(Failing(&THEOREM2.as_bytes()[..100]));
    let mut asked = 0;
    let stop = &mut || {
        asked += 1;
        asked > 4
    };
    let answer = check_until(&mut input as &mut dyn BufRead, stop).unwrap_err();
    assert!(matches!(answer, Rejection::Interrupted { .. }), "{answer}");
}
