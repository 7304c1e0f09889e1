//! The page of answer: the same sentences from a line, from the scene that it stands for, in JSON and in any
//! units; and what is wrong with a line.

use std::{fs, path::Path};

use grazing_base::random::Random;
use serde_json::Value;

use crate::{
    process::{ended, grazing},
    samples::samples,
};

/// How a command ends with these words, each of them one.
fn said(words: &[&str], folder: &Path) -> (i32, String, String) {
    ended(grazing("", folder).args(words).output().unwrap())
}

/// The lines of the page that have a mark, without it.
fn sentences(page: &str) -> Vec<&str> {
    let marks = ["  proved ", "  located ", "  seen "];
    let told = page.lines().filter(|line| marks.iter().any(|mark| line.starts_with(mark)));
    told.map(|line| line[19..].trim()).collect()
}

const MACHINE: &str = "m = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 10 mm, e = 0.6";

#[test]
fn a_line_and_its_scene_have_one_answer() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let (code, page, err) = said(&[MACHINE, "--save", "it.toml"], folder);
    assert_eq!(code, 0, "{err}");
    // Touch, chaos or what is born without, jump with how hard and how long, bands, proofs, what moves it.
    let told = sentences(&page);
    assert_eq!(told.len(), 6, "{page}");
    // By formulas: the response of the free oscillator is the gap, at 2 kg (2π 4/s)² and so on.
    let w = 2.0 * std::f64::consts::PI * 4.0;
    let touch = 0.01 * (800.0 - 2.0 * w * w).hypot(3.0 * w);
    assert!(
        told[0].starts_with(&format!("At F = {touch:.5} N the motion without impacts touches")),
        "{page}"
    );
    let born =
        format!("Born there: for F < {touch:.5} N orbits, and no chaos; for F > {touch:.5} N nothing.");
    assert_eq!(told[1], born, "{page}");
    for words in [&["answer", MACHINE][..], &["it.toml"], &["answer", "it.toml"], &["-q", "it.toml"]] {
        assert_eq!(said(words, folder), (0, page.clone(), String::new()), "{words:?}");
    }
    let (_, json, _) = said(&["it.toml", "--format", "json"], folder);
    let json: Value = serde_json::from_str(&json).unwrap();
    let all = json["tasks"][0]["sentences"].as_array().unwrap();
    let short = all.iter().filter(|one| one["detail"] == false).map(|one| one["text"].as_str().unwrap());
    assert_eq!(short.collect::<Vec<_>>(), told);
    assert!(all.iter().any(|one| one["detail"] == true), "{json}");
    let (_, full, _) = said(&[MACHINE, "--full"], folder);
    for line in told {
        assert!(full.contains(line), "{line}: {full}");
    }
    assert!(full.contains("multipliers") && !page.contains("multipliers"), "{full}");
    // What it calls proved has a certificate, where files are asked for, and only there.
    assert_eq!(crate::process::names(folder), ["it.toml"]);
    let (code, same, err) = said(&[MACHINE, "-o", "out"], folder);
    assert_eq!((code, same), (0, page), "{err}");
    let proved = said(&["check", "out/first-touch-before.certificate"], folder);
    assert!(proved.0 == 0 && proved.1.contains("proved, range"), "{proved:?}");
    for file in
        ["first-touch-swing.svg", "first-touch-swing.csv", "first-touch-machine.svg", "first-touch-seen.csv"]
    {
        assert!(fs::metadata(folder.join("out").join(file)).unwrap().len() > 0, "{file}");
    }
}

/// Machines in three systems of units that say the same exactly: the sentences are the same to the letter.
#[test]
fn units_change_no_sentence() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(crate::samples::seed(67));
    for _ in 0..samples::<usize>(4) {
        let mut from = |least: u64, count: u64| least + random.below(count);
        let [m, free, drive, gap, e] = [from(5, 50), from(20, 60), from(20, 60), from(10, 90), from(3, 6)]
            .map(|tenths| tenths as f64 / 10.0);
        let ratio = from(2, 60);
        let k = (m * (std::f64::consts::TAU * free).powi(2)).round();
        let same = [
            format!("m = {m} kg, k = {k} N/m, ζ = {ratio}e-3, f = {drive} Hz, gap = {gap} mm, e = {e}"),
            format!("m={m}e3 g k={k}e-3 N/mm, ζ={ratio}e-1 %, f={drive}*60 rpm; gap={gap}e-3, e={e}e2 %"),
            format!(
                "mass: {m}e-3 t; stiffness: {k}e-3 kN/m; zeta: {ratio}e-3; drive: {drive}e-3 kHz; stop: {gap}e3 µm; e: {e}"
            ),
        ];
        let pages = same.each_ref().map(|machine| said(&[machine, "-q"], folder.path()));
        let [first, others @ ..] = pages.each_ref().map(|(code, page, err)| {
            assert!([0, 3].contains(code) && !sentences(page).is_empty(), "{same:?}: {code} {page} {err}");
            (code, sentences(page))
        });
        for other in others {
            assert_eq!(first, other, "{same:?}");
        }
    }
}

#[test]
fn what_is_wrong_with_a_line_is_told() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("no-touch.toml"),
        "format = \"grazing-scene 3\"\ntitle = \"t\"\n[system]\nstiffness = 1\n",
    )
    .unwrap();
    for (words, told) in [
        (&["m = 2 kg, k = 800 N/m"][..], "c, f, gap: missing"),
        (&["m = 2 kg"], "k, c, f, gap: missing"),
        (&["no-touch.toml", "--save", "saved.toml", "--set", "F=1"], "cannot be used with"),
        (&["no-touch.toml", "--save", "saved.toml", "-o", "out"], "has no task of kind grazing"),
        (&["m = 2 lb, k = 800 N/m, c = 3, f = 4, gap = 1 mm"], "there is no unit \"lb\""),
        (&["m = -2 kg, k = 800 N/m, c = 3, f = 4, gap = 1 mm"], "mass"),
        (&["m = 2 kg, k = 800 N/m, c = 3, f = 4, gap = 1 mm", "--set", "G=3"], "G"),
        (&["nowhere.toml"], "nowhere.toml: there is no such file"),
        (&["answer", "nonsense"], "as a machine it is not understood"),
        (&["no-touch.toml"], "has no task of kind grazing"),
    ] {
        let (code, out, err) = said(words, folder.path());
        assert!(code == 2 && out.is_empty() && err.contains(told), "{words:?}: {code} {out} {err}");
    }
    // Nothing is left of what failed.
    assert_eq!(crate::process::names(folder.path()), ["no-touch.toml"]);
}
