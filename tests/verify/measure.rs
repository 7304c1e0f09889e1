//! `grazing intervals --measure`.

use std::path::Path;

use crate::process::run;

#[test]
fn the_command_lists_measures() {
    let folder = tempfile::tempdir().unwrap();
    let (code, out, _) = run("intervals --measure 3..=6 --decimals 4 --format csv", folder.path());
    let rows = "n,length_decimal,mean,length\n3,0.5000,1.0000,1/2\n4,0.3333,1.6667,1/3\n\
                5,0.4167,2.5000,5/12\n6,0.2000,2.9000,1/5\n";
    assert_eq!((code, out.as_str()), (0, rows));
    let (_, out, _) = run("intervals --measure 10001..=10002 --format csv", folder.path());
    assert!(out.lines().skip(1).all(|line| line.ends_with(',')), "{out}");
    let (_, out, _) = run("intervals --measure 10001 --format csv", folder.path());
    assert!(out.len() > 5000, "{out}");
    for (arguments, says) in [
        ("intervals --measure 2..=5", "1/4"),
        ("intervals --measure 5 --decimals 25", "from 1 to 24"),
        ("intervals --measure 5 --format bfile", "grazing sequence"),
        ("intervals 5 --measure 5", "cannot be used with"),
        ("intervals --measure 10000001", "10000000"),
    ] {
        let (code, out, err) = run(arguments, Path::new("."));
        assert!(code == 2 && out.is_empty() && err.contains(says), "{arguments}: {err}");
    }
}
