//! A scene's machine, drawn from its matrices as they are read, so that a wrong sign is seen: masses in a
//! row, what stands between them and to the ground, stops on the side on which their gap closes, friction,
//! forces. What is negative, or no spring, is red and said in words below. The data beside it have every
//! number, those that are not drawn too.

mod list;
mod plan;
mod sheet;
mod symbols;
mod table;

use num_rational::BigRational;

use super::{FigurePlace, canvas::Canvas};
use crate::{
    error::Result,
    many::elements::Elements,
    number::{Plain, Real},
    scene::{Scene, WrittenMachine},
};

/// What is drawn of a scene.
#[derive(Debug, Clone)]
pub struct MachinePicture {
    /// The scene's title.
    pub title: String,
    /// The machine at the parameters' values.
    pub written: WrittenMachine,
    /// The parameters and their values.
    pub parameters: Vec<(String, f64)>,
}

impl MachinePicture {
    /// Of a scene's machine.
    ///
    /// # Errors
    /// Those of [`Scene::written`].
    pub fn of(scene: &Scene) -> Result<MachinePicture> {
        let float = |x: &BigRational| Plain::ratio(x, &()).0;
        let parameters = scene.parameters.iter().map(|(name, value)| (name.clone(), float(value)));
        Ok(MachinePicture {
            title: scene.title.clone(),
            written: scene.written()?,
            parameters: parameters.collect(),
        })
    }
}

/// Writes the picture and the data beside it.
///
/// # Errors
/// An I/O error.
pub fn machine(picture: &MachinePicture, place: &FigurePlace) -> Result<()> {
    let (canvas, rows) = drawn(picture);
    place.save(&canvas, &table::COLUMNS, &rows)
}

fn drawn(picture: &MachinePicture) -> (Canvas, Vec<Vec<String>>) {
    let elements = Elements::of(&picture.written.machine);
    let names = plan::Names::of(&picture.written.machine);
    let remarks = elements.remarks(picture.written.machine.size, &|i| names.inner(i));
    let plan = plan::Plan::of(picture, &elements, &names);
    let lines = list::lines(picture, &names, &plan);
    let canvas = sheet::draw(&picture.title, &plan, &lines, &remarks);
    (canvas, table::rows(picture, &elements, &names, &plan, &remarks))
}

#[cfg(test)]
mod tests {
    use std::{fs, path::Path};

    use super::*;

    fn picture(text: &str) -> MachinePicture {
        let scene = Scene::from_toml(text, "scene.toml").unwrap();
        MachinePicture {
            title: scene.title.clone(),
            written: scene.written().unwrap(),
            parameters: Vec::new(),
        }
    }

    fn two_masses() -> String {
        fs::read_to_string("../../examples/machines/two-masses.toml").unwrap()
    }

    fn said(rows: &[Vec<String>]) -> String {
        let one = |row: &Vec<String>| row.iter().map(String::as_str).collect::<Vec<_>>().join(",");
        rows.iter().map(one).collect::<Vec<_>>().join("\n")
    }

    /// Every sign that can be wrong in a matrix is another list and another picture, with a remark in red.
    #[test]
    fn a_wrong_sign_is_seen() {
        let right = two_masses();
        let (canvas, rows) = drawn(&picture(&right));
        let red = |canvas: &Canvas| canvas.svg().matches("#d55e00").count();
        assert!(red(&canvas) == 0 && !said(&rows).contains("remark"), "{}", said(&rows));
        for (from, to, remark) in [
            ("[-200, 200]]", "[200, 200]]", "`stiffness` is not symmetric"),
            (
                "[[3200, -200], [-200, 200]]",
                "[[3200, 200], [200, 200]]",
                "negative spring -200 between q1 and q2",
            ),
            ("[[3200, -200], [-200, 200]]", "[[-3200, -200], [-200, 200]]", "negative spring -3400 from q1"),
            ("[[12, -2], [-2, 2]]", "[[12, 2], [2, 2]]", "negative damper -2 between q1 and q2"),
            ("[[12, -2], [-2, 2]]", "[[12, -2], [2, 2]]", "`damping` is not symmetric"),
            ("[[12, -2], [-2, 2]]", "[[12, -2], [-2, -2]]", "the damping feeds energy into motions along"),
            ("[[3200, -200], [-200, 200]]", "[[3200, -200], [-200, -200]]", "pushes away from rest along"),
        ] {
            let wrong = right.replace(from, to);
            assert_ne!(wrong, right, "{from}");
            let (canvas, other) = drawn(&picture(&wrong));
            assert!(said(&other).contains(remark), "{remark}:\n{}", said(&other));
            assert!(red(&canvas) >= 2 && said(&other) != said(&rows), "{remark}");
            let drawn = canvas.svg().contains("stroke=\"#d55e00\"");
            assert!(drawn, "{remark}: in words alone");
        }
    }

    /// A stop's sign moves it to the other side, or makes a bumper a strap; no remark can be made of that.
    #[test]
    fn a_stop_stands_where_its_gap_closes() {
        let right = two_masses();
        let ends = |text: &str, name: &str| {
            let picture = picture(text);
            let names = plan::Names::of(&picture.written.machine);
            let plan = plan::Plan::of(&picture, &Elements::of(&picture.written.machine), &names);
            let item = plan.items.iter().find(|item| item.label.starts_with(name)).unwrap().clone();
            (item.ends, item.mark)
        };
        let soft = false;
        let stop = plan::Mark::Stop { soft, damped: soft, moving: false };
        assert_eq!(ends(&right, "ground"), (plan::Ends::Ground { at: 0, left: true }, stop));
        let other = right.replace("row = [1, 0]", "row = [-1, 0]");
        assert_eq!(ends(&other, "ground"), (plan::Ends::Ground { at: 0, left: false }, stop));
        assert_eq!(ends(&right, "between"), (plan::Ends::Pair(0, 1), stop));
        let strap = right.replace("row = [-1, 1]", "row = [1, -1]");
        let mark = plan::Mark::Strap { soft, damped: soft };
        assert_eq!(ends(&strap, "between"), (plan::Ends::Pair(0, 1), mark));
        let lever = right.replace("row = [-1, 1]", "row = [-1, 0.5]");
        let mark = plan::Mark::Lever { soft };
        assert_eq!(ends(&lever, "between"), (plan::Ends::Many(vec![0, 1]), mark));
    }

    /// The picture on the page is that of the example.
    #[test]
    fn the_checked_in_picture_is_that_of_the_example() {
        let (canvas, _) = drawn(&picture(&two_masses()));
        let place = FigurePlace::svg(Path::new("../../docs"), "machine");
        if std::env::var_os("GRAZING_REDRAW").is_some() {
            machine(&picture(&two_masses()), &place).unwrap();
        }
        assert!(fs::read_to_string(place.picture()).unwrap() == canvas.svg());
    }

    /// The gallery's drawings are those of the scenes of their names.
    #[test]
    fn the_checked_in_gallery_is_that_of_the_examples() {
        let gallery = Path::new("../../docs/gallery");
        let mut seen = 0;
        for drawing in fs::read_dir(gallery).unwrap() {
            let name = drawing.unwrap().path().file_stem().unwrap().to_string_lossy().into_owned();
            let file = ["machines", "scenes"]
                .map(|folder| format!("../../examples/{folder}/{name}.toml"))
                .into_iter()
                .find(|file| Path::new(file).exists())
                .unwrap_or_else(|| panic!("no scene {name}"));
            let scene = Scene::from_toml(&fs::read_to_string(&file).unwrap(), &file).unwrap();
            let (canvas, _) = drawn(&MachinePicture::of(&scene).unwrap());
            let place = FigurePlace::svg(gallery, &name);
            if std::env::var_os("GRAZING_REDRAW").is_some() {
                place.draw(&canvas).unwrap();
            }
            assert!(fs::read_to_string(place.picture()).unwrap() == canvas.svg(), "{name}");
            seen += 1;
        }
        assert!(seen >= 20, "{seen}");
    }
}
