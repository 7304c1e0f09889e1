//! Orbits of the true system: exact formulas, Newton's method, saltation matrices, admissibility.

use grazing::impact::{Analysis, Numbers};
use grazing::oscillator::{
    Scene, Side,
    critical::{self, Bifurcation},
    grazing as graze,
    orbit::*,
};

fn scene(text: &str) -> Scene {
    Scene::from_toml(text, "test").unwrap()
}

fn nordmark(w: &str) -> Scene {
    let text = std::fs::read_to_string("examples/scenes/nordmark-2001.toml").unwrap();
    scene(&text.replace("w = 4.9", &format!("w = {w}")))
}

#[test]
fn p() {
    let scene = nordmark("4.9");
    let family = SceneFamily::new(&scene, "mu").unwrap();
    let at = |mu| family.at(mu).unwrap();
    let free = find(&at(-0.05), &Itinerary::free(1).unwrap(), vec![0.1, 0.2]).unwrap();
    println!("{free:?}");
    let g = graze::locate(&family, &free, -0.05).unwrap();
    println!("{g:?} {:?}", g.map.region());
    let map = g.map.to_map().unwrap();
    let analysis = Analysis::new(&map, 8, Numbers::Enclosed);
    for pattern in [&[1u64][..], &[2], &[3], &[4], &[5], &[1, 2], &[1, 1, 2]] {
        let report = analysis.judge(pattern);
        println!(
            "{pattern:?} {:?} {:?}",
            report.side(),
            report.orbit.as_ref().and_then(|o| o.leading.clone()).map(|x| x.to_string())
        );
        let Some(side) = report.side() else { continue };
        let mu = if side { 1e-5 } else { -1e-5 } / g.map.e();
        let (it, z) = g.start(&family, pattern, &report, mu).unwrap();
        let o = find(&at(mu), &it, z.clone()).unwrap();
        println!("   {z:?} {o:?}");
    }
    for (n, mu, kind) in [(3, 0.005, Bifurcation::Flip), (4, -0.08, Bifurcation::SaddleNode)] {
        let found = search(&at(mu), &Itinerary::at(Side::Lower, &[n]).unwrap(), 200, 1.0);
        for o in &found {
            println!("search {:?} {:?}", o.z, o.multipliers);
            let c = critical::locate(&family, kind, o, mu, 0.3);
            match c {
                Ok(c) => println!("{c:?}"),
                Err(e) => println!("{e}"),
            }
        }
    }
    let found = search(&at(-0.03), &Itinerary::at(Side::Lower, &[4]).unwrap(), 200, 1.0);
    for o in found {
        if let Ok(g) = graze::locate(&family, &o, -0.03) {
            println!("{g:?} {:?} {:?}", g.map.multipliers.values(), g.map.region());
        }
    }
    let found = search(&at(0.0058), &Itinerary::at(Side::Lower, &[3, 3]).unwrap(), 2000, 0.3);
    for o in found {
        println!("{o:?}");
        if let Ok(g) = graze::locate(&family, &o, 0.0058) {
            println!("{g:?} {:?} {:?} e {}", g.map.multipliers.values(), g.map.region(), g.map.e());
        }
    }
}
