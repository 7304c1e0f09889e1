//! Certificates of kinds word and word-by-theorem: the two worked by hand, and rules that random damage
//! hardly ever touches.

use crate::common::{WORD, WORD_BY_THEOREM, answer, rejected, with};

#[test]
fn what_is_written_passes_and_is_named() {
    let expected = "\
proved, word for n = 1..=3
  point: a1 = -1/4, a2 = 1/2
  e mu > 0: word DUU, periods 1, 2, 3; decided for 1 to 4; with one impact: 2, 3 (gamma > 0), 1 (gamma < 0)
  e mu < 0: word D, periods 1; decided for 1 to 3; with one impact: 1 (gamma > 0), none (gamma < 0)";
    assert_eq!(answer(WORD).unwrap().to_string(), expected);
    let expected = "\
proved, word-by-theorem for n = 1..=1
  point: r = 9/10, s = 37/100
  e mu > 0: word DUD, periods 1, 2, 3; no other period occurs; with one impact: 2 (gamma > 0), 1, 3 (gamma < 0)
  e mu < 0: word D, periods 1; no other period occurs; with one impact: 1 (gamma > 0), none (gamma < 0)";
    assert_eq!(answer(WORD_BY_THEOREM).unwrap().to_string(), expected);
}

/// The examples in the head of the module.
#[test]
fn damage_is_found_as_documented() {
    let theorem = with(WORD_BY_THEOREM, "at", "at plane -1/4 1/2");
    let theorem = with(&theorem, "step", "step 3 U\nend 4 D\nfollows 1 -++\nfollows 2 +++\nfollows 3 -++");
    let theorem = theorem.replace("end 5 U\nfollows 1 ---\nfollows 2 -+-\nfollows 3 -+-\n", "");
    assert!(answer(&theorem).is_ok(), "{}", rejected(&theorem));
    let cases = [
        (with(WORD, "absent 4", "absent 4 2"), "line 11: false: b_{4,2} is not certainly < 0"),
        (with(WORD, "follows 3", "follows 3 +++"), "line 14: false: p_1 - q_3 is not certainly > 0"),
        (with(WORD, "at", "at plane -1/2 1/2"), "line 10: false: b_{3,2} is not certainly > 0"),
        (
            with(&theorem, "follows 3", "follows 3 +++"),
            "line 13: false: by the theorem this line is \"follows 3 -++\"",
        ),
    ];
    for (text, expected) in cases {
        let why = rejected(&text);
        assert!(why.contains(expected), "{why}, expected {expected}");
    }
}

#[test]
fn every_rule_is_kept() {
    let cases = [
        (with(WORD, "at", "at plane -1/4 1/1"), "line 11: false: b_{4,1} is not certainly < 0"),
        (with(WORD, "at", "at plane -1/4 3/2"), "line 4: malformed: a2 must lie in 0 < a2 <= 1"),
        (with(WORD, "at", "at plane -1/4 0/1"), "line 4: malformed: a2 must lie in 0 < a2 <= 1"),
        (with(WORD, "at", "at plane -1/4 -1/2"), "line 4: malformed: a2 must lie in 0 < a2 <= 1"),
        (with(WORD, "at", "at plane -2/8 1/2"), "line 4: malformed: expected \"at plane"),
        (with(WORD, "at", "at plane -1/4"), "line 4: malformed: expected \"at plane"),
        (
            with(WORD, "at", "at polar 1/2 1/2"),
            "line 4: malformed: the point must have 0 < r <= 1 and 0 < s < 1/2",
        ),
        (with(WORD, "at", "at polar -1/2 1/4"), "line 4: malformed: the point must have"),
        (with(WORD, "at", "at polar 3/2 1/4"), "line 4: malformed: a2 must lie in"),
        (with(WORD, "at", "at box 1/4 0/1 1/2 1/2"), "line 4: malformed: the ends of an interval"),
        (with(WORD, "bits", "bits 65"), "line 5: malformed: the bits are a multiple of 32"),
        (with(WORD, "bits", "bits 32"), "line 5: malformed: the bits are a multiple of 32"),
        (with(WORD, "bits", "bits 8192"), "line 5: malformed: expected the number after bits"),
        (with(WORD, "word +", "word *"), "line 6: malformed: expected a line \"word +\""),
        (with(WORD, "word +", "word -"), "line 9: false: b_{2,1} is not certainly < 0"),
        (with(WORD, "word -", "word +"), "line 15: malformed: a word for each sign"),
        (with(WORD, "last 4", "last 0"), "line 7: malformed: the last period is at least 1"),
        (with(WORD, "last 4", "last 257"), "line 7: malformed: expected the number after last"),
        (with(WORD, "last 4", "last 3"), "line 11: malformed: expected a line \"follows 1 MARKS\""),
        (with(WORD, "occurs 2 U", "occurs 2 D"), "line 9: false: c_2 is not certainly < 0"),
        (with(WORD, "occurs 2 U", "absent 2 1"), "line 9: false: b_{2,1} is not certainly < 0"),
        (
            with(WORD, "occurs 2 U", "absent 2 2"),
            "line 9: malformed: expected a period, a number from 1 to 1",
        ),
        (with(WORD, "occurs 1 D", "absent 1 1"), "line 8: malformed: expected a period"),
        (with(WORD, "occurs 2 U", "singular 2"), "line 9: false: u_2 is not certainly 0"),
        (with(WORD, "occurs 2 U", "occurs 3 U"), "line 9: malformed: the periods come in order"),
        (with(WORD, "follows 1", "follows 1 -+"), "line 12: malformed: expected 3 marks"),
        (with(WORD, "follows 1", "follows 1 -+0"), "line 12: malformed: expected 3 marks"),
        (with(WORD, "follows 1", "follows 1 +++"), "line 12: false: p_1 - q_1 is not certainly > 0"),
        (with(WORD_BY_THEOREM, "region", "region 2"), "line 6: false: not all of the set lies in region 2"),
        (with(WORD_BY_THEOREM, "first", "first 3"), "line 8: false: u_2 is not certainly > 0"),
        (with(WORD_BY_THEOREM, "first", "first 1"), "line 8: malformed: the first period"),
        (with(WORD_BY_THEOREM, "step 3 D", "step 3 U"), "line 9: false: u_3 is not certainly < 0"),
        (
            with(WORD_BY_THEOREM, "step 3 D", "step 4 D"),
            "line 9: malformed: the mediant of 1 and 2 has the period 3",
        ),
        (with(WORD_BY_THEOREM, "step 3 D", "end 3 D"), "line 9: false: b_{3,1} is not certainly < 0"),
        (with(WORD_BY_THEOREM, "end 5 U", "step 5 U"), "line 10: false: b_{5,2} is not certainly > 0"),
        (with(WORD_BY_THEOREM, "end 5 U", "end 5 0"), "line 10: false: u_5 is not certainly 0"),
        (
            with(WORD_BY_THEOREM, "end 5 U", "open"),
            "line 12: false: by the theorem this line is \"follows 2 -+?\"",
        ),
        (with(WORD_BY_THEOREM, "below", "below 2"), "line 15: false: u_2 is not certainly > 0"),
        (with(WORD_BY_THEOREM, "below", "below 0"), "line 15: malformed: period 1 occurs"),
    ];
    for (text, expected) in cases {
        let why = rejected(&text);
        assert!(why.contains(expected), "{why}\n, expected {expected}");
    }
}

/// An unclaimed mark is no claim; a second word may be missing.
#[test]
fn less_may_be_claimed() {
    assert!(answer(&with(WORD, "follows 2", "follows 2 ???")).is_ok());
    let (first, _) = WORD.split_once("word -").unwrap();
    assert!(answer(first).is_ok());
    assert!(answer(&(first.to_string() + "word -\nlast 1\noccurs 1 D\nfollows 1 -\n")).is_ok());
}

/// What takes long is refused before it is done; what takes as long as it may ends.
#[test]
fn the_work_is_bounded() {
    let head: String = WORD.lines().take(3).map(|line| format!("{line}\n")).collect();
    let ones: String = (1..=256).map(|n| format!("occurs {n} U\n")).collect();
    let text = format!("{head}at plane {}/1 1/2\nbits 4096\nword +\nlast 256\n{ones}", "9".repeat(100));
    assert!(rejected(&text).contains("malformed: the check would take more than"), "{}", rejected(&text));
    let digits = format!("1/{}7", "9".repeat(99));
    let singular: String = (2..=256).map(|n| format!("singular {n}\n")).collect();
    let text = format!("{head}at plane {digits} 1/1\nbits 64\nword -\nlast 256\noccurs 1 D\n{singular}");
    assert!(rejected(&text).contains("u_2 is not certainly 0"), "{}", rejected(&text));
}
