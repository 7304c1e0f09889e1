//! Scenes: what is read, every error's exact words, damaged scenes by the thousand, expressions against a
//! second evaluation.

use std::{fs, path::Path};

use grazing_scenes::{
    number::{Plain, parse_rational},
    scene::{Expression, Kind, Scene, reference},
};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use proptest::{prelude::*, strategy::ValueTree, test_runner::TestRunner};

use crate::{common, samples::samples};

const GOOD: &str = r#"format = "grazing-scene 1"
title = "t"
[parameters]
d = 0.6
w = "49/10"
[system]
damping = "2*d/w"
stiffness = "1/w^2"
forcing = [{ k = 2, cos = 1 }]
[[walls]]
side = "lower"
offset = -1
harmonics = [{ k = 1, cos = "d" }]
restitution = 1
[[walls]]
side = "upper"
offset = 1
restitution = 0.5
[accuracy]
tolerance = 1e-9
[[tasks]]
name = "m"
kind = "simulate"
start = { q = "w/10" }
set = { w = 5 }
"#;

fn rational(text: &str) -> BigRational {
    parse_rational(text).unwrap()
}

fn read(text: &str) -> Result<Scene, String> {
    Scene::from_toml(text, "s.toml").map_err(|error| {
        assert!(error.is_input() && error.to_string().lines().count() == 1, "{error}");
        // The parts that programs read are those of the line.
        if let Some(spot) = error.spot() {
            let line = spot.line.map_or(String::new(), |line| format!(":{line}"));
            let key = spot.key.as_ref().zip(spot.value.as_ref());
            let key = key.map_or(String::new(), |(key, value)| format!("{key} = {value}: "));
            let told = format!("{}{line}: {key}{}", spot.file, spot.problem);
            assert!(error.to_string().ends_with(&told), "{error} is not {told}");
        }
        error.to_string()
    })
}

#[test]
fn an_error_has_its_place_for_programs() {
    let text = GOOD.replace("\"1/w^2\"", "\"1/w^\"");
    let error = Scene::from_toml(&text, "s.toml").unwrap_err();
    let spot = error.spot().unwrap();
    let key = (spot.key.as_deref(), spot.value.as_deref());
    assert_eq!(
        (spot.file.as_str(), spot.line, key),
        ("s.toml", Some(8), (Some("system.stiffness"), Some("\"1/w^\"")))
    );
    assert_eq!(Scene::read("no/such.toml").unwrap_err().spot().unwrap().file, "no/such.toml");
}

#[test]
fn what_is_read_is_exact() {
    let scene = read(GOOD).unwrap();
    let system = scene.exact(&[]).unwrap();
    assert_eq!(system.damping, rational("12/49"));
    assert_eq!(system.stiffness, rational("100/2401"));
    assert_eq!((system.cubic, system.force), (rational("0"), rational("0")));
    assert_eq!(system.lower.unwrap().harmonics[0].cos, rational("0.6"));
    let changed = scene.exact(&[("w", rational("5"))]).unwrap();
    assert_eq!(changed.damping, rational("6/25"));
    assert_eq!(scene.with(&scene.tasks[0].set).unwrap().exact(&[]).unwrap(), changed);
    let plain = scene.plain(&[("w", 5.0)]).unwrap();
    assert_eq!(plain.damping, 2.0 * 0.6 / 5.0);
    let Kind::SimulateTask(task) = &scene.tasks[0].kind else { panic!("{:?}", scene.tasks) };
    assert_eq!(scene.state(&task.start).unwrap().q, 0.49);
}

#[test]
fn every_failure_names_file_line_key_value_and_fix() {
    let parameters = "(with d = 3/5, w = 49/10)";
    for (from, to, message) in [
        // keys
        (
            "[accuracy]\ntolerance",
            "[accuracy]\ntolerence",
            "s.toml:20: accuracy: unknown key \"tolerence\"; the nearest known key is \"tolerance\"",
        ),
        (
            "damping =",
            "dampng =",
            "s.toml:7: system: unknown key \"dampng\"; the nearest known key is \"damping\"",
        ),
        ("[system]", "[sistem]", "s.toml:6: unknown key \"sistem\"; the nearest known key is \"system\""),
        (
            "{ k = 2, cos",
            "{ k = 2, cosine",
            "s.toml:9: system.forcing[1]: unknown key \"cosine\"; the nearest known key is \"cos\"",
        ),
        (
            "side = \"upper\"",
            "sides = \"upper\"",
            "s.toml:16: walls[2]: unknown key \"sides\"; the nearest known key is \"side\"",
        ),
        ("set = { w", "set = { v", "s.toml:25: tasks[1].set: unknown key \"v\"; known here are d, w"),
        (
            "start =",
            "strat =",
            "s.toml:24: tasks[1]: unknown key \"strat\"; the nearest known key is \"start\"",
        ),
        ("title = \"t\"\n", "", "s.toml: a scene has no key title, which must be given: text"),
        (
            "restitution = 1\n",
            "",
            "s.toml:10: walls[1] has no key restitution, which must be given: expression",
        ),
        (
            "start = { q = \"w/10\" }\n",
            "",
            "s.toml:21: tasks[1] has no key start, which must be given: table of phase, q, u",
        ),
        ("q = \"w/10\"", "u = 1", "s.toml:24: tasks[1].start has no key q, which must be given: expression"),
        // shapes and words
        (
            "grazing-scene 1",
            "grazing-scene 4",
            "s.toml:1: format = \"grazing-scene 4\": this version reads \"grazing-scene 1\", \"grazing-scene 2\", \"grazing-scene 3\"",
        ),
        ("title = \"t\"", "title = 3", "s.toml:2: title = 3: is not text \"…\""),
        ("d = 0.6", "d = [1]", "s.toml:4: parameters.d = [1]: is not a number"),
        (
            "d = 0.6",
            "d = nan",
            "s.toml:4: parameters.d = nan: \"nan\" is not a number: expected a digit, found 'n' (write 3/8, 0.375, 1e-30, 2^-10 or a sum of such terms)",
        ),
        (
            "d = 0.6",
            "\"d!\" = 0.6",
            "s.toml:4: parameters.d! = 0.6: the name of a parameter is a letter, then letters, digits and _",
        ),
        ("[{ k = 2, cos = 1 }]", "2", "s.toml:9: system.forcing = 2: is not a list […]"),
        ("[{ k = 2, cos = 1 }]", "[2]", "s.toml:9: system.forcing[1] = 2: is not a table of keys"),
        (
            "k = 2",
            "k = 0",
            "s.toml:9: system.forcing[1] = { k = 0, cos = 1 }: k is 0; it goes from 1 to 1000",
        ),
        (
            "k = 2",
            "k = 1.5",
            "s.toml:9: system.forcing[1].k = 1.5: is not a whole number from 0 to 4294967295",
        ),
        (
            "{ k = 2, cos = 1 }",
            "{ cos = 1 }, { sin = 1 }",
            "s.toml:9: system.forcing[2] = { sin = 1 }: k = 1 stands here twice; add the two terms up",
        ),
        (
            "side = \"upper\"",
            "side = \"uper\"",
            "s.toml:16: walls[2].side = \"uper\": is none of \"lower\", \"upper\"; the nearest is \"upper\"",
        ),
        (
            "side = \"upper\"",
            "side = \"lower\"",
            "s.toml:16: walls[2].side = \"lower\": there is a wall on this side already",
        ),
        (
            "\"simulate\"",
            "\"simulation\"",
            "s.toml:23: tasks[1].kind = \"simulation\": is none of simulate, ",
        ),
        (
            "name = \"m\"",
            "name = \"../m\"",
            "s.toml:22: tasks[1].name = \"../m\": names files: write letters, digits, - and _",
        ),
        (
            "name = \"m\"",
            &format!("name = \"{}\"", "m".repeat(201)),
            &format!("s.toml:22: tasks[1].name = \"{}…: names files", "m".repeat(56)),
        ),
        (
            "tolerance = 1e-9",
            "tolerance = 0.1",
            "s.toml:20: accuracy.tolerance = 0.1: is outside 1e-15 to 1e-3",
        ),
        (
            "offset = 1\n",
            "offset = true\n",
            "s.toml:17: walls[2].offset = true: is not an expression: write a number, or \"…\"",
        ),
        (
            "offset = 1\n",
            "offset = \"1e400\"\n",
            "s.toml:17: walls[2].offset = \"1e400\": is beyond the range of floats (with d = 3/5, w = 49/10)",
        ),
        // expressions
        (
            "\"2*d/w\"",
            "\"2*d/v\"",
            "s.toml:7: system.damping = \"2*d/v\": unknown parameter \"v\" at character 5; there are d, w",
        ),
        (
            "\"2*d/w\"",
            "\"2 d\"",
            "s.toml:7: system.damping = \"2 d\": expected an operator or the end at character 3, found 'd'",
        ),
        (
            "\"2*d/w\"",
            "\"2*(d\"",
            "s.toml:7: system.damping = \"2*(d\": expected an operator or \")\" at character 5, found the end",
        ),
        (
            "\"2*d/w\"",
            "\"\"",
            "s.toml:7: system.damping = \"\": expected a number, a parameter or \"(\" at character 1, found the end",
        ),
        (
            "\"2*d/w\"",
            "\"d^w\"",
            "s.toml:7: system.damping = \"d^w\": expected a whole number as exponent at character 3, found 'w'",
        ),
        ("\"2*d/w\"", "\"d^999\"", "s.toml:7: system.damping = \"d^999\": the exponent 999 is above 256"),
        (
            "\"2*d/w\"",
            "\"(d^20)^20\"",
            "s.toml:7: system.damping = \"(d^20)^20\": has 400 factors and terms, powers written out; at most 256 are allowed",
        ),
        (
            "\"2*d/w\"",
            "\"1/(w-4.9)\"",
            &format!("s.toml:7: system.damping = \"1/(w-4.9)\": divides by zero {parameters}"),
        ),
        // what the scene means
        (
            "restitution = 1\n",
            "restitution = \"d-1\"\n",
            &format!(
                "s.toml:14: walls[1].restitution = \"d-1\": is -0.4; a restitution is at least 0 {parameters}"
            ),
        ),
        (
            "offset = 1\n",
            "offset = \"-2/5\"\n",
            "s.toml:17: walls[2].offset = \"-2/5\": the walls meet: at t = ",
        ),
        (
            "q = \"w/10\"",
            "q = \"-w/10\"",
            "s.toml:24: tasks[1].start = { q = \"-w/10\" }: starts at q = -0.5, behind the lower wall, which is at -0.4 (with d = 3/5, w = 5)",
        ),
        (
            "q = \"w/10\"",
            "q = 1.1",
            "s.toml:24: tasks[1].start = { q = 1.1 }: starts at q = 1.1, behind the upper wall, which is at 1 (with d = 3/5, w = 5)",
        ),
        (
            "set = { w = 5 }",
            "set = { w = 0 }",
            "s.toml:7: system.damping = \"2*d/w\": divides by zero (with d = 3/5, w = 0)",
        ),
        (
            "set = { w = 5 }",
            "[[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = { q = 0 }",
            "s.toml:26: tasks[2].name = \"m\": is the name of an earlier task too; its files would be overwritten",
        ),
        (
            "set = { w = 5 }",
            "[[tasks]]\nname = \"b\"\nkind = \"basins\"\nq = { from = 0, to = 1 }\nu = { from = 0, to = 1 }\nplane = [\"q\", \"q2\"]",
            "s.toml:30: tasks[2].plane = [\"q\", \"q2\"]: \"q2\" is neither \"q\" nor \"u\" nor \"phase\"",
        ),
        (
            "set = { w = 5 }",
            "[[tasks]]\nname = \"b\"\nkind = \"basins\"\nq = { from = 0, to = 1 }\nu = { from = 0, to = 1 }\nplane = [\"u\", \"u\"]",
            "s.toml:30: tasks[2].plane = [\"u\", \"u\"]: must name two different axes, as in [\"q\", \"phase\"]",
        ),
        (
            "set = { w = 5 }",
            "[[tasks]]\nname = \"b\"\nkind = \"basins\"\nq = { from = 0, to = 1 }\nu = { from = 0, to = 1 }\nstart = { q = 1 }",
            "s.toml:30: tasks[2].start = { q = 1 }: goes with a plane: here q and u say all, leave it out",
        ),
        (
            "set = { w = 5 }",
            "[[tasks]]\nname = \"b\"\nkind = \"basins\"\nq = { from = 0, to = 1 }\nu = { from = 0, to = 1 }\nplane = [\"q\", \"phase\"]\nstart = { q = 1, phase = \"1/2\" }",
            "s.toml:31: tasks[2].start.phase = \"1/2\": is given by the task's own phase, when all motions start",
        ),
        (
            "set = { w = 5 }",
            "set = { G = 5 }",
            "s.toml:25: tasks[1].set: unknown key \"G\"; known here are d, w",
        ),
        (
            "set = { w = 5 }",
            "[[tasks]]\nname = \"o\"\nkind = \"orbit\"\norbit = { pattern = [1], walls = [\"lower\"], speed = 0 }",
            "s.toml:28: tasks[2].orbit.speed = 0: must be above 0",
        ),
        // TOML itself
        (
            "restitution = 0.5",
            "restitution = 0.5\nrestitution = 0.4",
            "s.toml:19: restitution = 0.4: stands there twice: leave one out",
        ),
        ("[accuracy]", "[system]\n[accuracy]", "s.toml:19: [system]: stands there twice: leave one out"),
        (
            "offset = 1\n",
            "offset = 1e400\n",
            "s.toml:17: offset = 1e400: floating-point number overflowed (a number",
        ),
        ("offset = 1\n", "offset = 1__0\n", "s.toml:17: offset = 1__0: `_` may only go between digits"),
    ] {
        assert!(GOOD.contains(from), "{from}");
        let error = read(&GOOD.replacen(from, to, 1)).expect_err(to);
        assert!(error.starts_with(message), "{to}\n  found    {error}\n  expected {message}");
    }
}

/// Keys that would be left unread, or lead to no answer, in tasks of one walled oscillator.
#[test]
fn keys_of_tasks_that_cannot_matter_are_refused() {
    let scene = GOOD.replace("grazing-scene 1", "grazing-scene 3").replace("walls", "stops");
    let scene = scene.split("[[stops]]\nside = \"upper\"").next().unwrap().to_string();
    let branch = "branch\"\nparameter = \"d\"\nrange = [0.5, 0.7]\n";
    let crisis = "crisis\"\nparameter = \"d\"\nbracket = [0.5, 0.7]\nphase = 0\nstart = { q = 0 }\n\
                  orbit = { pattern = [1] }\n";
    for (task, said) in [
        (format!("{branch}starts = []"), "starts = []: is empty"),
        (
            format!("{branch}starts = [{{ at = 0.8, orbit = {{}} }}]"),
            "starts[1].at = 0.8: is not in the range from 0.5 to 0.7",
        ),
        (
            format!("{branch}starts = [{{ orbit = {{}} }}]\nsecond_range = [1, 2]"),
            "second_range = [1, 2]: is of a second parameter: give `second`",
        ),
        (format!("{crisis}margins = []"), "margins = []: is empty"),
        (format!("{crisis}margins = [-1e-5]"), "margins = [-1e-5]: must be positive"),
        (format!("{crisis}offsets = [0]"), "offsets = [0]: must be positive"),
        (format!("{crisis}quiet = 0"), "quiet = 0: must be at least 1"),
        ("grazing\"\nparameter = \"d\"\ndistance = -1".into(), "distance = -1: must be positive"),
        (
            "orbit\"\norbit = { pattern = [1], period = 2 }".into(),
            "orbit.period = 2: is of an orbit without impacts",
        ),
        ("orbit\"\norbit = { pattern = [1], starts = 0 }".into(), "orbit.starts = 0: must be at least 1"),
        (
            "validate\"\norbit = { pattern = [1] }\nreach = 1".into(),
            "reach = 1: is of the search for an `event`",
        ),
        // What is not written is told at the line of what is.
        ("validate\"\norbit = { period = 2 }".into(), "orbit.pattern: must have an impact"),
        (
            "chaos\"\nalphabet = [1, 2]\nhistory = [3, 1]".into(),
            "history = [3, 1]: 3 is no period of the alphabet",
        ),
    ] {
        let text = format!("{scene}[[tasks]]\nname = \"m\"\nkind = \"{task}\n");
        let error = read(&text).expect_err(&task);
        assert!(error.contains(&format!(": tasks[1].{said}")), "{task}\n  found    {error}");
        assert!(error.starts_with("s.toml:"), "no line: {error}");
    }
}

/// Walls whose least gap is known: that of a + b cos kt is a − |b|.
#[test]
fn walls_that_meet_are_found_however_briefly() {
    for k in [1, 2, 7, 100, 1000] {
        for (gap, meets) in [("1e-3", false), ("1e-8", false), ("0", true), ("-1e-8", true), ("-1", true)] {
            for (lower, upper) in [("1/2", "-1/2"), ("1", "0"), ("-1/3", "2/3")] {
                let walls = format!(
                    "[[walls]]\nside = \"lower\"\noffset = 0\nrestitution = 1\nharmonics = [{{ k = {k}, sin = \"{lower}\" }}]\n\
                     [[walls]]\nside = \"upper\"\noffset = \"abs + ({gap})\"\nrestitution = 1\nharmonics = [{{ k = {k}, sin = \"{upper}\" }}]\n"
                );
                let amplitude = rational(lower) - rational(upper);
                let amplitude = if amplitude < BigRational::zero() { -amplitude } else { amplitude };
                let text = format!(
                    "format = \"grazing-scene 1\"\ntitle = \"\"\n[parameters]\nabs = \"{amplitude}\"\n[system]\n{walls}"
                );
                let result = read(&text);
                assert_eq!(
                    result.as_ref().is_err_and(|e| e.contains("the walls meet")),
                    meets,
                    "{k} {gap}: {result:?}"
                );
            }
        }
    }
}

fn examples() -> Vec<(String, String)> {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("examples/scenes");
    let mut all: Vec<(String, String)> = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into(), fs::read_to_string(&path).unwrap()))
        .collect();
    all.sort();
    assert!(all.len() >= 6);
    all
}

#[derive(Debug, Clone)]
enum Damage {
    Remove(prop::sample::Index),
    Duplicate(prop::sample::Index),
    Swap(prop::sample::Index, prop::sample::Index),
    Truncate(prop::sample::Index),
    /// A word in place of another.
    Transplant(prop::sample::Index, prop::sample::Index),
    Byte(prop::sample::Index, char),
    Word(prop::sample::Index, &'static str),
}

/// What stands between words.
const BREAKS: [char; 11] = [' ', '\n', '"', '=', '{', '}', '[', ']', ',', '(', ')'];
const WORDS: [&str; 24] = [
    "1e999999999",
    "-1",
    "0",
    "nan",
    "1e-4000",
    "99999999999999999999",
    "(((((((((((((((((((((((((((((((((((1",
    "1/0",
    "mu^256",
    "[]",
    "{}",
    "\"\"",
    "true",
    "µ",
    "1979-05-27",
    "0x10",
    "--1",
    "2^-2^2",
    "\"a.b\"",
    "q",
    "cos",
    "walls",
    "[[walls]]",
    "\u{feff}",
];

fn damage() -> impl Strategy<Value = Damage> {
    let index = any::<prop::sample::Index>;
    prop_oneof![
        1 => index().prop_map(Damage::Remove),
        1 => index().prop_map(Damage::Duplicate),
        1 => (index(), index()).prop_map(|(a, b)| Damage::Swap(a, b)),
        1 => index().prop_map(Damage::Truncate),
        4 => (index(), index()).prop_map(|(a, b)| Damage::Transplant(a, b)),
        4 => (index(), prop::sample::select("0123456789+-*/^. =\"'[]{}#\n\\eµ".chars().collect::<Vec<_>>()))
            .prop_map(|(at, c)| Damage::Byte(at, c)),
        3 => (index(), prop::sample::select(WORDS.to_vec())).prop_map(|(at, word)| Damage::Word(at, word)),
    ]
}

/// The text with one thing wrong.
fn damaged(text: &str, damage: &Damage) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    let words: Vec<&str> = text.split(BREAKS).filter(|word| !word.is_empty()).collect();
    let replace = |old: &str, new: &str| {
        let at = old.as_ptr() as usize - text.as_ptr() as usize;
        format!("{}{new}{}", &text[..at], &text[at + old.len()..])
    };
    match damage {
        Damage::Remove(at) => drop(lines.remove(at.index(lines.len()))),
        Damage::Duplicate(at) => {
            let at = at.index(lines.len());
            lines.insert(at, lines[at]);
        }
        Damage::Swap(a, b) => {
            let (a, b) = (a.index(lines.len()), b.index(lines.len()));
            lines.swap(a, b);
        }
        Damage::Truncate(at) => {
            let (at, _) = *at.get(&text.char_indices().collect::<Vec<_>>());
            return text[..at].to_string();
        }
        Damage::Transplant(a, b) => return replace(words[a.index(words.len())], words[b.index(words.len())]),
        Damage::Word(at, word) => return replace(words[at.index(words.len())], word),
        Damage::Byte(at, c) => {
            let (at, old) = *at.get(&text.char_indices().collect::<Vec<_>>());
            return format!("{}{c}{}", &text[..at], &text[at + old.len_utf8()..]);
        }
    }
    lines.join("\n")
}

#[test]
fn damaged_scenes_are_errors_and_never_panic() {
    let mut runner = TestRunner::deterministic();
    let strategy = (0..examples().len(), prop::collection::vec(damage(), 1..4));
    // Comments only soak up damage.
    let uncommented = |text: &str| -> String {
        text.lines().filter(|line| !line.starts_with('#')).map(|line| format!("{line}\n")).collect()
    };
    let scenes: Vec<String> = examples().iter().map(|(_, text)| uncommented(text)).collect();
    let (mut refused, mut read_all) = (0, 0);
    let all: u32 = samples(1_500);
    for _ in 0..all {
        let (which, all) = strategy.new_tree(&mut runner).unwrap().current();
        let mut text = scenes[which].clone();
        for damage in &all {
            if text.split(BREAKS).any(|word| !word.is_empty()) {
                text = damaged(&text, damage);
            }
        }
        match read(&text) {
            Ok(_) => read_all += 1,
            Err(error) => {
                assert!(error.starts_with("s.toml:"), "{error}");
                refused += 1;
            }
        }
    }
    assert!(refused > all / 5 * 2 && read_all > all / 10, "{refused} refused, {read_all} read");
}

/// The guide's scene can be read, and its errors are what a reader would see.
#[test]
fn the_guide_is_true() {
    let page =
        fs::read_to_string(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("docs/scenes.md"))
            .unwrap();
    let scene = page.split_once("```toml\n").unwrap().1.split_once("```").unwrap().0;
    read(scene).unwrap();
    for (from, to) in
        [("damping =", "dampng ="), ("1/w^2", "1/v^2"), ("restitution = 0.8", "restitution = -0.5")]
    {
        let error = read(&scene.replace(from, to)).unwrap_err().replacen("s.toml", "scene.toml", 1);
        assert!(page.contains(&format!("    {error}\n")), "{error}");
    }
}

#[test]
fn the_reference_is_current() {
    let page =
        fs::read_to_string(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("docs/scenes.md"))
            .unwrap();
    assert!(page.contains(&reference()), "run `cargo run -p grazing-scenes --example scene_reference`");
}

/// A random expression: text, exact value and float, none where it divides by zero.
#[derive(Debug, Clone)]
struct Sample {
    text: String,
    exact: Option<BigRational>,
    float: f64,
}

fn sample() -> impl Strategy<Value = Sample> {
    let leaf = prop_oneof![
        (0u32..1000, 0usize..4).prop_map(|(n, digits)| {
            let text = format!("{}", BigRational::new(n.into(), 1.into()).to_integer());
            let text = if digits == 0 { text } else { format!("{text}.{n:0digits$}") };
            Sample { exact: Some(rational(&text)), float: text.parse().unwrap(), text }
        }),
        prop::sample::select(vec![0usize, 1, 2]).prop_map(|i| {
            let text = ["a", "b2", "e"][i];
            Sample {
                text: text.into(),
                exact: Some(values()[i].clone()),
                float: values()[i].to_f64().unwrap(),
            }
        }),
    ];
    leaf.prop_recursive(4, 20, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone(), 0..4usize, "[ ]{0,2}").prop_map(|(x, y, operation, space)| {
                let sign = ["+", "-", "*", "/"][operation];
                let (exact, float) = match operation {
                    0 => (x.exact.zip(y.exact).map(|(x, y)| x + y), x.float + y.float),
                    1 => (x.exact.zip(y.exact).map(|(x, y)| x - y), x.float - y.float),
                    2 => (x.exact.zip(y.exact).map(|(x, y)| x * y), x.float * y.float),
                    _ => {
                        let pair = x.exact.zip(y.exact).filter(|(_, y)| !y.is_zero());
                        (pair.map(|(x, y)| x / y), x.float / y.float)
                    }
                };
                Sample { text: format!("({}){space}{sign}{space}({})", x.text, y.text), exact, float }
            }),
            (inner, -4i32..5).prop_map(|(x, power)| {
                let exact = x.exact.filter(|x| power >= 0 || !x.is_zero()).map(|x| x.pow(power));
                Sample {
                    text: format!("-({})^{power}", x.text),
                    exact: exact.map(|x| -x),
                    float: -x.float.powi(power),
                }
            }),
        ]
    })
}

fn values() -> [BigRational; 3] {
    [rational("3/7"), rational("-2.5"), rational("1e-3")]
}

proptest! {
    #![proptest_config(common::config())]

    #[test]
    fn expressions_have_the_value_of_a_second_evaluation(sample in sample()) {
        let names = ["a", "b2", "e"].map(String::from);
        let Ok(expression) = Expression::parse(&sample.text, &names) else {
            // Powers of powers can be too long.
            prop_assume!(sample.text.matches('^').count() > 1);
            return Ok(());
        };
        let exact = expression.evaluate(&values(), &());
        prop_assert_eq!(exact.is_ok(), sample.exact.is_some());
        if let Some(value) = sample.exact {
            prop_assert_eq!(exact.unwrap(), value);
            let plain = expression.evaluate(&values().map(|x| Plain(x.to_f64().unwrap())), &());
            let same = plain.is_ok_and(|Plain(x)| x == sample.float || (x - sample.float).abs() <= 1e-13 * x.abs());
            prop_assert!(same || !sample.float.is_finite() || sample.text.contains('^'));
        }
    }
}

#[test]
fn signs_powers_and_chains_associate_as_on_paper() {
    let names = ["w".to_string()];
    for (text, value) in [
        ("-w^2", "-9"),
        ("(-w)^2", "9"),
        ("2-1-1", "0"),
        ("8/2/2", "2"),
        ("2*-w", "-6"),
        ("1/w^2", "1/9"),
        ("w^-1", "1/3"),
        ("6/2*w", "9"),
        ("1e2*w", "300"),
        (" + w ", "3"),
        ("w^0", "1"),
        ("2.5e-1 - .5", "-1/4"),
    ] {
        let found = Expression::parse(text, &names).unwrap().evaluate(&[rational("3")], &()).unwrap();
        assert_eq!(found, rational(value), "{text}");
    }
    for text in ["2w", "w w", "2^3^2", "1e", "1..2", "--1", "w^", "w^1/", ")", "()", "w^(2)", "3 % 2"] {
        assert!(Expression::parse(text, &names).is_err(), "{text}");
    }
}
