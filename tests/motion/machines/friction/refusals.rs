//! What is said of friction that is not covered, or wrongly written.

use super::*;

const ROUGH: &str = "[parameters]\nF = 1\nG = 1\n[system]\nforcing = [{ cos = \"F\" }]\nstiffness = 2\n[[stops]]\noffset = -1\n\
                     restitution = 0.5\n[[friction]]\nname = \"table\"\nnormal = 1\ncoefficient = 0.3\n";

pub fn refusal(format: u32, body: &str) -> String {
    let text = format!("format = \"grazing-scene {format}\"\ntitle = \"t\"\n{body}");
    match Scene::from_toml(&text, "t.toml") {
        Ok(_) => panic!("{body}"),
        Err(error) => error.to_string(),
    }
}

/// Tasks that need motions smooth between impacts say so, with the place; the others are taken.
#[test]
fn tasks_that_do_not_take_friction_say_so() {
    let orbit = "orbit = { pattern = [1], speed = 1 }";
    for (kind, keys, at) in [
        ("event", format!("{orbit}\nparameter = \"F\"\nevent = \"grazing\""), "kind"),
        ("grazing", "parameter = \"F\"".into(), "kind"),
        (
            "branch",
            "starts = [{ restart = { file = \"a.json\", label = \"flip 1\" } }]\nparameter = \"F\"\nrange = [1, 2]\n\
             second = \"G\"\nsecond_range = [1, 2]"
                .into(),
            "second",
        ),
        ("validate", orbit.into(), "kind"),
        ("section", "starts = [{ q = 0 }]\norbits = [{ pattern = [1], speed = 1 }]".into(), "orbits"),
    ] {
        let error = refusal(3, &format!("{ROUGH}[[tasks]]\nname = \"x\"\nkind = \"{kind}\"\n{keys}\n"));
        assert!(
            error.contains("dry friction (table)") && error.contains(&format!("tasks[1].{at}")),
            "{error}"
        );
        assert!(error.contains("t.toml:"), "{error}");
    }
    let over = "parameter = \"F\"\nrange = [1, 2]";
    let kinked = ROUGH.replace("stiffness = 2", "stiffness = 2\nforce = \"-q^2*abs(q)\"");
    for (kind, keys) in [
        ("simulate", "start = { q = 0 }".to_string()),
        ("orbit", orbit.into()),
        ("branch", format!("starts = [{{ {orbit} }}]\n{over}")),
        ("section", "starts = [{ q = 0 }]".into()),
        ("diagram", format!("starts = [{{ q = 0 }}]\n{over}")),
        ("diagram", format!("starts = [{{ q = 0 }}]\n{over}\nbranches = [{{ {orbit} }}]")),
        ("basins", "q = { from = -0.5, to = 1 }\nu = { from = -1, to = 1 }".into()),
    ] {
        for machine in [ROUGH, &kinked] {
            let body = format!("{machine}[[tasks]]\nname = \"x\"\nkind = \"{kind}\"\n{keys}\n");
            let text = format!("format = \"grazing-scene 3\"\ntitle = \"t\"\n{body}");
            Scene::from_toml(&text, "t.toml").unwrap_or_else(|error| panic!("{error}"));
        }
    }
}

/// Orbits are not followed under a stop's force: the scene says so, and the library.
#[test]
fn orbits_with_friction_on_a_stop_are_refused() {
    let body = "[parameters]\nF = 1\n[system]\nmass = [[1, 0], [0, 1]]\nforcing = [{ cos = [\"F\", 1] }]\nstiffness = [[2, 0], [0, 3]]\n\
                [[stops]]\nname = \"floor\"\nrow = [0, 1]\noffset = -1\nrestitution = 0.5\n[[friction]]\nname = \"foot\"\n\
                row = [1, 0]\nstop = \"floor\"\ncoefficient = 0.3\n";
    let orbit = "orbit = { pattern = [1], speed = 1 }";
    let over = "parameter = \"F\"\nrange = [1, 2]";
    for (kind, keys, at) in [
        ("orbit", orbit.to_string(), "kind"),
        ("branch", format!("starts = [{{ {orbit} }}]\n{over}"), "kind"),
        ("diagram", format!("starts = [{{ q = 0 }}]\n{over}\nbranches = [{{ {orbit} }}]"), "branches"),
        ("grazing", "parameter = \"F\"".into(), "kind"),
        ("validate", orbit.into(), "kind"),
    ] {
        let error = refusal(3, &format!("{body}[[tasks]]\nname = \"x\"\nkind = \"{kind}\"\n{keys}\n"));
        assert!(error.contains("foot") && error.contains(&format!("tasks[1].{at}")), "{kind}: {error}");
    }
    let text = format!("format = \"grazing-scene 3\"\ntitle = \"t\"\n{body}");
    let machine = Scene::from_toml(&text, "t.toml").unwrap().machine(&[]).unwrap();
    let simulator = Simulator::new(&machine, &Settings::default()).unwrap();
    let free = grazing_scenes::many::orbit::Itinerary::free(1).unwrap();
    let error = grazing_scenes::many::orbit::find(&simulator, &free, &[]).unwrap_err().to_string();
    assert!(error.contains("foot") && error.contains("given normal forces"), "{error}");
}

#[test]
fn what_is_wrong_with_friction_is_said_with_its_place() {
    let with = |old: &str, new: &str| ROUGH.replace(old, new);
    let older = |head: &str, wall: &str| {
        with("[system]", &format!("[system]\n{head}")).replace("[[stops]]", &format!("[[walls]]\n{wall}"))
    };
    let row = |keys: &str| format!("{ROUGH}{keys}\n");
    for (format, body, answers) in [
        (3, with("normal = 1", "normal = \"-F\""), ["friction[1].normal", "at least 0"]),
        (3, with("coefficient = 0.3", "coefficient = -0.3"), ["friction[1].coefficient", "at least 0"]),
        (3, row("static_coefficient = 0.2"), ["friction[1].static_coefficient", "below coefficient = 0.3"]),
        (3, row("row = [0]"), ["friction[1].row", "is zero"]),
        (3, row("row = [1, 2]"), ["friction[1].row", "2 entries"]),
        (3, row("speed = \"1/0\""), ["friction[1].speed", "divides by zero"]),
        (3, row("mu = 0.2"), ["friction[1]", "unknown key \"mu\""]),
        (3, with("coefficient = 0.3", ""), ["friction[1]", "coefficient"]),
        (
            3,
            with("\"table\"", "\"1\"").replace("[[stops]]", "[[stops]]\nname = \"1\""),
            ["friction[1].name", "stop"],
        ),
        (3, with("[parameters]", "engine = \"one\"\n[parameters]"), ["engine", "has dry friction"]),
        (2, older("period = 1\nmass = 1", "row = [1]"), ["friction", "grazing-scene 3"]),
        (1, older("", "side = \"lower\""), ["friction", "grazing-scene 3"]),
    ] {
        let error = refusal(format, &body);
        assert!(answers.iter().all(|answer| error.contains(answer)), "{answers:?}: {error}");
        assert!(error.contains("t.toml:"), "{error}");
    }
}
