//! Certificates that must not pass, and keys at the ends of their ranges.

use grazing::{
    certificate,
    run::{ChaosFindings, Findings, Job, Status, Surroundings, run_task},
    scene::Scene,
};

use super::{EXAMPLE, FIGURE_10, proved};

/// What is true of µ ≤ 0.003 with boxes and weights as found is not true a little beyond it, of smaller
/// boxes, of other weights, on the other side of the grazing or of another frequency.
#[test]
fn controls_are_refused() {
    let text = proved(FIGURE_10).text.unwrap().1;
    let with = |name: &str, change: &dyn Fn(&mut Vec<String>)| -> String {
        let line = |line: &str| {
            let mut words: Vec<String> = line.split(' ').map(String::from).collect();
            if words[0] == name {
                change(&mut words);
            }
            words.join(" ") + "\n"
        };
        text.lines().map(line).collect()
    };
    let words = |new: &str| new.split(' ').map(String::from).collect::<Vec<_>>();
    let set = |name: &str, new: &str| with(name, &|old| *old = words(&format!("{name} {new}")));
    assert!(certificate::check(&mut set("side", "1").as_bytes()).is_ok());
    let slower = set("damping", "12/47 12/47").replace("100/2401 100/2401", "100/2209 100/2209");
    for (what, changed, condition) in [
        ("mu = 0.0035", set("depth", "0/1 7/2007"), "(H1)"),
        (
            "a box of letter 3 from 19",
            with("letter", &|words| {
                if words[1] == "3" {
                    words[2] = "19".into();
                }
            }),
            "(H1)",
        ),
        ("equal weights", with("letter", &|words| (words[6], words[7]) = ("1".into(), "1".into())), "(H2)"),
        ("mu < 0", set("side", "-1"), "(H1)"),
        ("w = 4.7", slower, "(H1)"),
    ] {
        // Without the claim that there are no others: the boxes themselves are at fault.
        let changed: String = changed
            .lines()
            .map(
                |line| {
                    if line.starts_with("complete") { "complete no\n".into() } else { format!("{line}\n") }
                },
            )
            .collect();
        assert_ne!(changed, text, "{what}");
        let refused = certificate::check(&mut changed.as_bytes()).expect_err(what);
        assert!(refused.to_string().contains(condition), "{what}: {refused}");
    }
}

/// What a task of the example with other keys comes to: its findings and status, or why it is refused.
fn outcome(task: &str) -> Result<(ChaosFindings, Status), String> {
    let head = EXAMPLE.split("\n[[tasks]]").next().unwrap();
    let text = format!("{head}\n[[tasks]]\nname = \"x\"\nkind = \"chaos\"\n{task}\n");
    let scene = Scene::from_toml(&text, "test").map_err(|error| error.to_string())?;
    let job =
        Job::new(&scene, &scene.tasks[0], Surroundings::default()).map_err(|error| error.to_string())?;
    let report = run_task(&job, &mut ());
    match report.findings {
        Some(Findings::Chaos(found)) => Ok((*found, report.status)),
        _ => Err(report.status.reason().unwrap_or_default().to_string()),
    }
}

#[test]
fn keys_that_make_no_sense_are_refused_by_name() {
    let thousand = (1..=1000).map(|n| n.to_string()).collect::<Vec<_>>().join(", ");
    for (task, reason) in [
        ("alphabet = []", "alphabet"),
        ("alphabet = [0, 1]", "from 1 to 100, increasing"),
        ("alphabet = [1, 1]", "increasing"),
        ("alphabet = [2, 1]", "increasing"),
        ("alphabet = [1, 101]", "from 1 to 100"),
        (&format!("alphabet = [{thousand}]"), "from 1 to 100"),
        ("alphabet = [1, -2]", "alphabet"),
        ("alphabet = [1, 2.5]", "alphabet"),
        ("alphabet = \"all\"", "auto"),
        ("alphabet = [1]", "one periodic word only, whose entropy is 0"),
        ("alphabet = [1, 2]\nfollow = [[2], [1]]", "one periodic word only"),
        ("alphabet = [1, 2]\nfollow = [[1], [2]]", "cannot be reached"),
        ("alphabet = [1, 2]\nfollow = [[1, 3], [2]]", "follow"),
        ("follow = [[1]]", "goes with an alphabet"),
        ("alphabet = [1, 2]\nhistory = [1]", "history"),
        ("alphabet = [1, 2]\nhistory = [2, 41]", "up to 40"),
        ("alphabet = [1, 2]\nset = { mu = 0 }", "grazes"),
        ("alphabet = [1, 2]\nset = { tau = 0 }", "restitution must be positive"),
        ("alphabet = [1, 2]\nset = { tau = -1 }", "restitution"),
        ("alphabet = [1, 2]\nparameter = \"mu\"\nfrom = 0.001\nto = 0.001", "above from"),
        ("alphabet = [1, 2]\nparameter = \"nu\"\nfrom = 0", "nu"),
        ("alphabet = [1, 2]\nfrom = 0", "goes with from"),
        ("alphabet = [1, 2]\nparameter = \"mu\"\nfrom = 0\ncell = { mu = [0.1, 0.2] }", "varies"),
    ] {
        let error = outcome(task).map(|(found, status)| (found.proved, status)).expect_err(task);
        assert!(error.contains(reason), "{task}: {error}");
    }
}

/// Values far out are undecided or proved, not errors and not false: a restitution of a thousand makes
/// speeds grow, a hundred letters are too many to close, and near µ = 0 there is no loss.
#[test]
fn values_far_out_are_decided_or_not() {
    let hundred = (1..=100).map(|n| n.to_string()).collect::<Vec<_>>().join(", ");
    for (task, proved) in [
        ("alphabet = [1, 2]\nset = { tau = 1000 }", None),
        ("alphabet = [1, 2]\nset = { tau = 1e-9 }", None),
        (&format!("alphabet = [{hundred}]\nset = {{ mu = 0.001 }}"), Some(false)),
        ("alphabet = [1, 2]\nset = { mu = 1e-12 }", Some(true)),
        ("alphabet = [1, 2]\nset = { mu = 1000000 }", Some(true)),
        ("alphabet = [1, 2]\nhistory = [5, 3]", Some(true)),
        ("alphabet = [1, 2]\nhistory = [2, 0]", Some(true)),
    ] {
        let (found, status) = outcome(task).unwrap_or_else(|error| panic!("{task}: {error}"));
        assert!(
            proved.is_none_or(|proved| proved == found.proved),
            "{task}: {:?} {status:?}",
            found.failures
        );
        assert_eq!(found.proved, status == Status::Done, "{task}");
        assert_eq!(found.proved, found.text.is_some(), "{task}");
        if let Some((_, text)) = found.text {
            assert!(certificate::check(&mut text.as_bytes()).is_ok(), "{task}");
        }
    }
}
