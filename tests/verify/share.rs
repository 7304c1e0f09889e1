//! `grazing word --shares --certificate`.

use std::{fs, path::PathBuf, process::Command};

use grazing::certificate;

fn command(arguments: &[&str]) -> (i32, String, String) {
    let output = Command::new(crate::PROGRAM).args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn the_command_writes_and_says_what_was_proved() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("share");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("chaos.txt");
    let file = file.to_str().unwrap();
    let machine =
        ["word", "--frequency", "12.3Hz±1%", "--damping-ratio", "0.02±20%", "--drive", "10Hz", "--shares"];
    let asked = |more: &[&str]| command(&[&machine, more].concat());
    let (code, out, error) =
        asked(&["--cells", "400", "--max-period", "3", "--certificate", file, "--holds", "chaos +"]);
    assert_eq!(code, 0, "{error}");
    let checked = certificate::check(&mut fs::read(file).unwrap().as_slice()).unwrap();
    let proved: Vec<String> =
        checked.detail.iter().map(|(name, value)| format!("  {name}: {value}\n")).collect();
    assert!(out.ends_with(&format!("Certificate: {file}\n{}", proved.concat())), "{out}");
    assert!(proved[0].starts_with("  share: 53."), "{proved:?}");
    let (code, out, _) = command(&["check", file]);
    assert_eq!((code, out), (0, format!("{file}: {checked}\n")));
    let (_, out, _) =
        asked(&["--cells", "40", "--certificate", file, "--holds", "period + 2", "--format", "json"]);
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(report["certificate"], file);

    // Nothing that cannot be proved is written, and nothing is left out in silence.
    let none = folder.join("none.txt");
    let name = none.to_str().unwrap();
    // Of an earlier run.
    let _ = fs::remove_file(&none);
    let (code, _, error) = asked(&["--cells", "1", "--certificate", name, "--holds", "period + 4"]);
    assert_eq!(code, 3, "{error}");
    assert!(error.contains("no certificate: on none of 1 cells is it certain; --cells 4 may do"), "{error}");
    assert!(!none.exists());
    let wrong: [(&[&str], &str); 7] = [
        (&["--certificate", name], "add --holds"),
        (&["--holds", "chaos +"], "--certificate"),
        (&["--certificate", name, "--holds", "chaos"], "expected \"period + 3\""),
        (&["--certificate", name, "--holds", "period + 65"], "periods are at most 64"),
        (&["--certificate", name, "--holds", "chaos + -"], "leave out the second sign"),
        (&["--certificate", name, "--holds", "chaos +", "--normal"], "cannot be used with"),
        (&["--certificate", name, "--holds", "chaos +", "--by-theorem"], "cannot be used with"),
    ];
    for (more, expected) in wrong {
        let (code, _, error) = asked(more);
        assert_eq!(code, 2, "{more:?}: {error}");
        assert!(error.contains(expected), "{more:?}: {error}");
    }
    let polar = ["word", "--r", "0.9", "--s", "0.3±1%", "--shares", "--certificate", name, "--holds"];
    let (code, _, error) = command(&[polar.as_slice(), &["chaos +"]].concat());
    assert!(code == 2 && error.contains("the sign of gamma is free here"), "{error}");
    let long = ["word", "--r", "0.9", "--s", "0.1234567890123456±1%", "--shares", "--certificate", name];
    let (code, _, error) = command(&[long.as_slice(), &["--holds", "period + 3"]].concat());
    assert!(code == 2 && error.contains("at most 15 digits"), "{error}");
    assert!(!none.exists());
}
