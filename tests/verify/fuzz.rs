//! `grazing fuzz -o`.

/// What `-o` names is written, with `--words` as without.
#[test]
fn a_report_goes_where_it_is_sent() {
    let folder = tempfile::tempdir().unwrap();
    for words in ["", "--words"] {
        let file = folder.path().join("report.json");
        let mut command = std::process::Command::new(crate::PROGRAM);
        command
            .current_dir(folder.path())
            .args(["fuzz", "--cases", "1000", "--n", "1..=12", "--format", "json", "-o"]);
        let output = command.arg(&file).args(words.split_whitespace()).output().unwrap();
        assert!(output.status.success() && output.stdout.is_empty(), "{words}: {output:?}");
        let report: serde_json::Value = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
        assert_eq!(report["verdict"], "no disagreement", "{words}");
        assert_eq!(report["of"] == "words", words == "--words");
        std::fs::remove_file(file).unwrap();
    }
}
