//! `grazing verify --entropy`.

use std::fs;

use grazing::search::entropy_certificate;

use crate::process::run;

#[test]
fn the_command_writes_the_certificate() {
    let folder = tempfile::tempdir().unwrap();
    let (code, out, err) = run("verify --entropy --certificate e.txt", folder.path());
    assert!(code == 0 && out.starts_with("proved, entropy\n  case + -: "), "{out}{err}");
    let (code, out, _) = run("check e.txt", folder.path());
    assert!(code == 0 && out.starts_with("e.txt: proved, entropy"), "{out}");
    let text = fs::read_to_string(folder.path().join("e.txt")).unwrap();
    assert_eq!(text, entropy_certificate(&()).unwrap());
    let (code, _, err) = run("verify --entropy --format json", folder.path());
    assert!(code == 2 && err.contains("check --format json"), "{err}");
    assert_eq!(run("verify 3 --entropy", folder.path()).0, 2);
}
