//! What the program with every command has, and this one has not, is named with the line that installs it.

use std::path::Path;

use crate::process::run;

#[test]
fn what_is_elsewhere_is_named_with_the_line_that_installs_it() {
    let folder = tempfile::tempdir().unwrap();
    let map = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/maps/focus.toml");
    let orbit = format!("existence {map} --pattern 1,3 --orbit orbit");
    for arguments in ["run scene.toml", "figure 2", "accuracy", "export x", "completions bash", "man", &orbit]
    {
        let (code, out, err) = run(arguments, folder.path());
        assert_eq!((code, out.as_str(), err.lines().count()), (2, "", 1), "{arguments}: {err}");
        assert!(err.contains("cargo install --path crates/shell"), "{arguments}: {err}");
    }
    assert!(folder.path().read_dir().unwrap().next().is_none(), "nothing is written");
    let (code, _, err) = run("verfy", Path::new("."));
    assert!(code == 2 && err.contains("'verify'"), "{err}");
}
