//! Runs all tasks of a scene and prints what each found: `cargo run --example run_scene -- SCENE.toml`.

use grazing::{Error, Result, run, scene::Scene};

fn main() -> Result<()> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "examples/scenes/two-sided.toml".into());
    let text = std::fs::read_to_string(&path).map_err(|error| Error::io("read", path.as_ref(), error))?;
    let scene = Scene::from_toml(&text, &path)?;
    for report in run::run(&scene, run::Surroundings::default(), &mut ())? {
        println!("{report}");
    }
    Ok(())
}
