//! That chaos attracts beyond a touch, in the report of a task `grazing`: how far, against numbers of the
//! page, and in which of three cases; and every reason for which it is not proved.

use grazing_scenes::{
    certificate,
    run::{CertificateFile, GrazingReport},
};

use super::grazing_found;

/// The paper's oscillator with some d and w, and keys of the task.
fn paper(d: &str, w: &str, keys: &str) -> (GrazingReport, String, u8) {
    paper_at("0.05", d, w, keys)
}

/// The same at a value of mu.
fn paper_at(mu: &str, d: &str, w: &str, keys: &str) -> (GrazingReport, String, u8) {
    let text = format!(
        "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nmu = {mu}\nd = \"{d}\"\nw = \"{w}\"\n[system]\n\
         damping = \"2*d/w\"\nstiffness = \"1/w^2\"\n[[stops]]\nside = \"lower\"\noffset = -1\n\
         harmonics = [{{ cos = \"1 + mu\" }}]\nrestitution = 0.8\n{}",
        task("mu", keys)
    );
    grazing_found(&text)
}

fn task(parameter: &str, keys: &str) -> String {
    format!(
        "[[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \"{parameter}\"\nmax_period = 1\nseen = false\n\
         attractor = true\n{keys}\n"
    )
}

/// What the certificate of the one row says of the parameter.
fn said(found: &GrazingReport) -> String {
    let [CertificateFile { file, accepted }] = &found.certificates[..] else { panic!("one certificate") };
    let text = accepted.text();
    assert_eq!(file, "g-beyond-attractor.certificate");
    let checked = certificate::check(&mut text.as_bytes()).unwrap_or_else(|why| panic!("{why}"));
    assert_eq!((checked.kind, checked.title), ("parameter", "chaos that attracts"));
    checked.detail[0].1.clone()
}

#[test]
fn chaos_is_proved_from_the_touch_on() {
    let (found, shown, code) = paper("3/2", "8", "");
    let [row] = &found.range.clone().unwrap()[..] else { panic!("one row") };
    assert_eq!((code, row.of, row.verdict, row.case), (0, "attractor", "proved", Some("chaos")));
    // The formulas give µ = 0.1 at a growth of 1.005.
    let end: f64 = row.end.as_ref().unwrap().parse().unwrap();
    assert!((0.1..0.103).contains(&end) && row.growth.unwrap() > 1.0, "{row:?}");
    let [least, greatest] = row.eigenvalue.unwrap();
    assert!((least - 0.740_821_625_7).abs() < 1e-9 && (0.0..1e-8).contains(&(greatest - least)), "{row:?}");
    let end = row.end.as_ref().unwrap();
    assert!(said(&found).starts_with(&format!("for mu* < mu <= {end}, the touch mu* being the only one")));
    for part in [
        "chaos attracts: motions are trapped where none that is periodic is stable",
        "that there is one attractor is not said",
        "lambda_1 = 0.740821…, above 2/3: chaos attracts at every small depth",
    ] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
}

#[test]
fn all_machines_within_tolerances_are_proved_at_once() {
    let (found, shown, code) = paper("3/2", "8", "tolerance = { d = \"0.1%\", w = \"0.1%\" }");
    let [row] = &found.range.clone().unwrap()[..] else { panic!("one row") };
    let end: f64 = row.end.as_ref().unwrap().parse().unwrap();
    assert!(code == 0 && (0.09..0.1021).contains(&end), "{row:?}");
    assert!(said(&found).starts_with("for mu* < mu <= 0.09"), "{}", said(&found));
    let proved = shown.lines().find(|line| line.trim_start().starts_with("proved ")).unwrap();
    assert!(proved.contains("for every machine within the tolerances, from its own touch"), "{shown}");
}

/// A drive of three harmonics, which the parameter scales; an upper stop.
#[test]
fn several_harmonics_of_a_drive_are_proved() {
    let text = format!(
        "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 1\n[system]\ndamping = 0.4\nstiffness = 0.012\n\
         forcing = [{{ cos = \"F\" }}, {{ k = 2, cos = \"F/5\", sin = \"F/7\" }}, {{ k = 3, sin = \"F/10\" }}]\n\
         [[stops]]\nside = \"upper\"\noffset = 1\nrestitution = \"7/10\"\n{}",
        task("F", "")
    );
    let (found, _, code) = grazing_found(&text);
    let [row] = &found.range.clone().unwrap()[..] else { panic!("one row") };
    assert!(code == 0 && row.share.unwrap() > 0.01, "{row:?}");
    assert!(said(&found).starts_with("for F* < F <= "), "{}", said(&found));
    assert!(found.certificates[0].accepted.text().contains("\nconcave "));
}

#[test]
fn windows_are_told_where_they_are() {
    // In one of them, where no weights are found.
    let (found, shown, code) = paper_at("0.013", "3/2", "5", "");
    let [row] = &found.range.clone().unwrap()[..] else { panic!("one row") };
    assert_eq!((code, row.verdict, row.case), (3, "undecided", Some("windows")));
    let windows = &row.windows;
    assert_eq!(windows.iter().map(|one| one.periods).collect::<Vec<_>>(), [8, 9, 10]);
    // The closed form of the plane map: ν = (CAB/((λ₁ − λ₂)β))².
    assert_eq!((windows[0].from.as_str(), windows[0].to.as_str()), ("0.01119", "0.01581"));
    for part in ["each 0.3829 times the one before", "period 8 from 0.01119 to 0.01581", "to leading order"] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    assert!(found.certificates.is_empty());
    let reason = windows_reason(&found);
    assert!(
        reason.contains("lambda_1 may be below 2/3") && reason.contains("own mu neither: no weights"),
        "{reason}"
    );
    // That orbits are proved there does not answer what attracts.
    let (found, shown, code) = paper_at("0.013", "3/2", "5", "range = true\n");
    let rows = found.range.unwrap();
    assert!(rows.iter().any(|row| row.side == "beyond" && row.verdict == "proved"), "{shown}");
    assert_eq!(code, 3, "{shown}");
}

fn windows_reason(found: &GrazingReport) -> String {
    found.range.clone().unwrap()[0].reason.clone().unwrap()
}

/// Between two windows, and beyond what the formulas reach: there cells with weights prove the scene's value.
#[test]
fn the_value_of_the_scene_is_proved_by_cells() {
    for (mu, w, first) in [("0.008", "5", "undecided"), ("0.05", "5", "undecided"), ("0.12", "8", "proved")] {
        let (found, shown, code) = paper_at(mu, "3/2", w, "");
        let rows = found.range.clone().unwrap();
        let [range, value] = &rows[..] else { panic!("two rows: {shown}") };
        assert_eq!((code, range.verdict, value.verdict), (0, first, "proved"), "{shown}");
        assert_eq!((value.of, value.own_value.as_deref(), &value.end), ("attractor", Some(mu), &None));
        assert!(value.growth.unwrap() > 1.0 && value.rate.unwrap() > 0.0, "{value:?}");
        let [from, to] = value.near.clone().unwrap().map(|end| end.parse::<f64>().unwrap());
        let at: f64 = mu.parse().unwrap();
        assert!(from < at && at < to && to - from < 1e-5 * at, "{from} {to}");
        let CertificateFile { file, accepted } = found.certificates.last().unwrap();
        let text = accepted.text();
        assert_eq!(file, "g-beyond-attractor-at.certificate");
        let checked = certificate::check(&mut text.as_bytes()).unwrap_or_else(|why| panic!("{why}"));
        assert_eq!((checked.kind, checked.title), ("parameter", "chaos that attracts"));
        let said = format!("for {from} <= mu <= {to}");
        assert!(checked.detail[0].1.starts_with(&said), "{said}: {}", checked.detail[0].1);
        let said = format!("beyond the touch, at mu = {mu}: chaos attracts: motions are trapped where none");
        assert!(shown.contains(&said) && shown.contains("by weights, grow"), "{shown}");
    }
}

/// So it is of all machines within tolerances, also where each has a depth of its own.
#[test]
fn the_value_of_all_machines_within_tolerances_is_proved() {
    let driven = |keys: &str| {
        grazing_found(&format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 0.0404\nc = 0.6\n[system]\ndamping = \"c\"\n\
             stiffness = 0.04\nforcing = [{{ cos = \"F\" }}]\n[[stops]]\nside = \"upper\"\noffset = 0.0354\nrestitution = 0.8\n{}",
            task("F", keys)
        ))
    };
    let displaced = |keys: &str| paper_at("0.008", "3/2", "5", keys);
    for (found, shown, code) in
        [displaced("tolerance = { d = \"0.02%\", w = \"0.02%\" }"), driven("tolerance = { c = \"0.02%\" }")]
    {
        let rows = found.range.clone().unwrap();
        let [_, value] = &rows[..] else { panic!("two rows: {shown}") };
        assert_eq!(
            (code, value.verdict, value.touches.is_some(), &value.end),
            (0, "proved", true, &None),
            "{shown}"
        );
        let text = found.certificates.last().unwrap().accepted.text();
        assert!(
            text.contains("\nkind attractor 2\n")
                && text.starts_with("grazing-certificate 1\nkind parameter 2\n")
        );
        let part =
            ", for every machine within the tolerances: chaos attracts: motions are trapped where none";
        assert!(shown.contains(part) && shown.contains("by weights, grow"), "{shown}");
    }
    let (found, shown, code) = displaced("tolerance = { w = \"5%\" }");
    assert!(code == 3 && windows_reason(&found).contains("own mu neither: no weights"), "{shown}");
}

/// Ranges that are asked for beside it leave it its work, and say of themselves that theirs was too little.
#[test]
fn what_attracts_over_a_frequency_does_not_wait_for_ranges() {
    let found = |keys: &str| {
        grazing_found(&format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nw = 8\n[system]\ndamping = \"3/w\"\nstiffness = \"1/w^2\"\n\
             forcing = [{{ cos = \"130/w^2\" }}]\n[[stops]]\nside = \"upper\"\noffset = 1.1\nrestitution = 0.8\n{}",
            task("w", keys)
        ))
    };
    let (alone, _, code) = found("");
    let [row] = &alone.range.unwrap()[..] else { panic!("one row") };
    assert_eq!((code, row.verdict, row.of), (0, "proved", "attractor"));
    let (both, shown, code) = found("range = { effort = 100 }");
    let rows = both.range.unwrap();
    assert_eq!(rows.last(), Some(row), "{shown}");
    let open = rows.iter().find(|row| row.of == "all" && row.side == "beyond").unwrap();
    assert!(
        open.verdict == "undecided" && open.reason.as_ref().unwrap().contains("raise `effort`"),
        "{shown}"
    );
    assert_eq!(code, 3, "{shown}");
}

#[test]
fn what_is_not_covered_says_so() {
    for (d, w, keys, reason, case) in [
        ("2/5", "8", "", "the oscillator may not be overdamped", None),
        ("2", "1/2", "", "lambda_1 may be below 2/3", Some("overlap")),
        ("3/2", "8", "tolerance = { w = \"60%\" }", "", None),
    ] {
        let (found, shown, code) = paper(d, w, keys);
        let rows = found.range.clone().unwrap_or_default();
        assert_eq!(code, 3, "{d} {w} {keys} {shown}");
        if let [row] = &rows[..] {
            assert!(row.reason.as_ref().unwrap().contains(reason), "{row:?}");
            assert_eq!(row.case, case);
        }
    }
}
