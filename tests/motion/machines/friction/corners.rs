//! Orbits whose motion has corners by formulas: kinks of forces, stops and friction with laws, and dry
//! friction beside forces that are formulas.

use grazing_scenes::scene::MachineSceneFamily;

use super::{orbits::Agreement, *};
use crate::samples::samples;

/// A machine with a parameter p, 0, on which every number that is drawn depends; and a start.
fn random_corners(trial: u64) -> (Scene, Vec<f64>, Vec<f64>) {
    let mut between = numbers(0xD1B5_4A32_D192_ED03 ^ (trial + 1).wrapping_mul(0xBF58_476D_1CE4_E5B9));
    for _ in 0..20 {
        between(0.0, 1.0);
    }
    let mut own = |low: f64, high: f64| {
        let (x, slope) = (between(low, high), between(-0.3, 0.3));
        format!("({x:?} + p*({slope:?}))")
    };
    let n = 1 + (trial + trial / 6) as usize % 2;
    let coordinate = if n == 1 { "q" } else { "q1" };
    let kinked = match trial % 6 {
        0 | 2 => format!(" - {}*{coordinate}^3", own(0.2, 1.0)),
        1 => String::new(),
        3 => format!(" - {}*max({coordinate} - {}, 0)", own(0.5, 4.0), own(-0.2, 0.3)),
        4 => format!(" + {}*sign(sin(t + {}))", own(0.1, 0.5), own(0.0, 1.0)),
        _ => format!(" - {}*abs({coordinate})*{coordinate}", own(0.2, 1.0)),
    };
    let mut rest = String::new();
    let row = |at: usize, sign: i32| {
        let all: Vec<String> = (0..n).map(|i| if i == at { sign.to_string() } else { "0".into() }).collect();
        format!("[{}]", all.join(", "))
    };
    if trial.is_multiple_of(6) {
        let (normal, mu) = (own(0.5, 1.0), own(0.2, 0.5));
        rest +=
            &format!("[[friction]]\nrow = {}\nnormal = \"{normal}\"\ncoefficient = \"{mu}\"\n", row(0, 1));
    }
    if matches!(trial % 6, 1 | 5) {
        let law = match (trial % 6 / 5 + trial / 6) % 2 {
            0 => format!("{} + {}*exp(-abs(v)/{})", own(0.2, 0.4), own(0.05, 0.2), own(0.3, 0.8)),
            _ => format!("max({}, {} - {}*abs(v))", own(0.1, 0.2), own(0.3, 0.5), own(0.1, 0.5)),
        };
        let (normal, speed) = (own(0.5, 1.0), own(-0.4, 0.4));
        let surface = if trial % 4 == 1 { String::new() } else { format!("speed = \"{speed}\"\n") };
        rest += &format!(
            "[[friction]]\nrow = {}\nnormal = \"{normal}\"\ncoefficient = \"{law}\"\n{surface}",
            row(0, 1)
        );
    }
    if matches!(trial % 6, 2 | 5) {
        let law = format!("{}*d^1.5*(1 + {}*v)", own(1.0, 4.0), own(0.05, 0.2));
        rest += &format!(
            "[[stops]]\nrow = {}\noffset = \"-{}\"\nlaw = \"{law}\"\n",
            row(n - 1, -1),
            own(0.1, 0.4)
        );
    }
    let each = |of: &mut dyn FnMut(usize) -> String| {
        let all: Vec<String> = (0..n).map(|i| format!("\"{}\"", of(i))).collect();
        format!("[{}]", all.join(", "))
    };
    let matrix = |on: [f64; 2], beside: f64, own: &mut dyn FnMut(f64, f64) -> String| {
        let (a, b) = (own(on[0], on[1]), own(on[0], on[1]));
        if n == 1 {
            format!("[[\"{a}\"]]")
        } else {
            format!("[[\"{a}\", {beside:?}], [{beside:?}, \"{b}\"]]")
        }
    };
    let force = each(&mut |i| {
        let constant = own(-0.2, 0.2);
        if i == 0 { format!("{constant}{kinked}") } else { constant }
    });
    let forcing = each(&mut |i| if i == 0 { own(1.0, 2.0) } else { "0.1".into() });
    let system = format!(
        "period = \"{}\"\nmass = {}\ndamping = {}\nstiffness = {}\nforce = {}\nforcing = [{{ cos = {forcing} }}]\n",
        own(5.0, 7.0),
        matrix([0.7, 1.5], 0.0, &mut own),
        matrix([0.1, 0.4], -0.03, &mut own),
        matrix([1.5, 5.0], -0.8, &mut own),
        force,
    );
    let text = format!(
        "format = \"grazing-scene 3\"\ntitle = \"corners\"\nengine = \"many\"\n[parameters]\np = 0\n[system]\n{system}{rest}"
    );
    let scene = Scene::from_toml(&text, "corners.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    (scene, vec![0.03; n], vec![0.2; n])
}

/// Their equations and multipliers are those of differences, in every coefficient at once.
#[test]
fn orbits_with_corners_and_their_derivatives_agree_with_differences() {
    let trials: u64 = samples(6);
    let mut all = Agreement::default();
    for trial in 0..trials {
        let (scene, q, u) = random_corners(trial);
        all.look(trial, &MachineSceneFamily::new(&scene, "p").unwrap(), &q, &u);
    }
    println!("{trials}: {all:?}");
    assert!(u64::from(all.orbits) > trials * 2 / 3, "{all:?}");
}
