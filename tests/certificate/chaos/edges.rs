//! Keys of the task at the ends of their ranges, and beyond.

use grazing_scenes::{
    certificate,
    run::{ChaosFindings, Findings, Job, Status, Surroundings, run_task},
    scene::Scene,
};

use super::EXAMPLE;

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
        ("alphabet = [1, 2]\nhistory = [5, 3]", "no period of the alphabet"),
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
        ("alphabet = [1, 2]\nhistory = [2, 0]", Some(true)),
    ] {
        let (found, status) = outcome(task).unwrap_or_else(|error| panic!("{task}: {error}"));
        assert!(
            proved.is_none_or(|proved| proved == found.proved),
            "{task}: {:?} {status:?}",
            found.failures
        );
        assert_eq!(found.proved, status == Status::Done, "{task}");
        assert_eq!(found.proved, found.proof.is_some(), "{task}");
        if let Some(proof) = &found.proof {
            let text = proof.accepted.text();
            assert!(certificate::check(&mut text.as_bytes()).is_ok(), "{task}");
        }
    }
}
