//! Branches: continuation, events, switching, two parameters.

use grazing::oscillator::{
    Scene, Side,
    branch::{Branch, Direction, Event, Options, Orbits},
    orbit::{Family, Itinerary, SceneFamily, SingleImpact},
};

fn nordmark(w: &str) -> Scene {
    let text = std::fs::read_to_string("examples/scenes/nordmark-2001.toml").unwrap();
    Scene::from_toml(&text.replace("w = 4.9", &format!("w = {w}")), "test").unwrap()
}

#[test]
fn p() {
    let scene = nordmark("4.9");
    let family = SceneFamily::new(&scene, "mu").unwrap();
    for n in 1..=4 {
        let orbits = Orbits {
            family: &family,
            itinerary: Itinerary::at(Side::Lower, &[n]).unwrap(),
            range: (-0.1, 0.01),
        };
        let mu = if n == 4 { -0.05 } else { 0.003 };
        let osc = family.at(mu).unwrap();
        let exact = SingleImpact::new(osc.system(), Side::Lower, n).unwrap();
        let v = exact.speeds()[0];
        let options = Options::default();
        let start = orbits.start(vec![exact.phase(v), v], mu, &options).unwrap();
        let branch = Branch::follow(&orbits, &start, Direction::Both, &options).unwrap();
        println!("{n}: {} {:?}", branch.points.len(), branch.ends);
        for p in &branch.points {
            println!(
                "   {:.6} {:?} {:.2e} {} {}",
                p.parameters[0],
                p.orbit.multipliers.values()[0],
                p.orbit.residual,
                p.orbit.steps,
                p.orbit.admissibility.is_admissible()
            );
        }
        for (label, p) in branch.labels() {
            println!(
                " {label} {:?} {:?} {:.1e} {:?}",
                p.parameters,
                p.orbit.z,
                p.orbit.residual,
                p.orbit.multipliers.values()
            );
            if p.event == Some(Event::Flip) {
                let (born, foot) = orbits.switch(Event::Flip, &p.foot).unwrap();
                let b = Branch::follow(&born, &foot, Direction::Both, &Options { ..options }).unwrap();
                println!("  born {:?} {:?}", b.ends, foot);
                for p in &b.points {
                    println!(
                        "   {:?} {:.6} {:?} {:?} {:.2e} {} {}",
                        p.event,
                        p.parameters[0],
                        p.orbit.z,
                        p.orbit.multipliers.values()[0],
                        p.orbit.residual,
                        p.orbit.steps,
                        p.orbit.admissibility.is_admissible()
                    );
                }
            }
        }
    }
}
