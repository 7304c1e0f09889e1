//! Runs all tasks of a scene and prints what each found: `cargo run -p grazing-scenes --example run_scene --
//! SCENE.toml`.

use grazing_scenes::{Result, run, scene::Scene};

fn main() -> Result<()> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "examples/scenes/two-sided.toml".into());
    let scene = Scene::read(path)?;
    for report in run::run(&scene, run::Surroundings::default(), &mut ())? {
        println!("{report}");
    }
    Ok(())
}
