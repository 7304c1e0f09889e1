//! `grazing figure machine`: the drawing of every example, and the matrices made again from the data beside
//! it.

use std::{
    collections::{BTreeMap, HashMap},
    fs,
    path::Path,
};

use grazing_scenes::{
    internals::random::Random, many::elements::Evaluated, number::parse_rational, scene::Scene,
};
use num_rational::BigRational;
use num_traits::Zero;

use super::{
    figures::{assert_no_overlap, draw, labels},
    process::run,
};

type Matrix = BTreeMap<(usize, usize), BigRational>;

/// The matrices M, C and K from the rows of the data, by what springs and dampers are.
fn rebuilt(rows: &[HashMap<String, String>]) -> [Matrix; 3] {
    let mut all: [Matrix; 3] = Default::default();
    for row in rows {
        let place = |name: &str| {
            let number: String = row[name].chars().filter(char::is_ascii_digit).collect();
            number.parse::<usize>().map_or(0, |number| number - 1)
        };
        let value = || parse_rational(&row["value"]).unwrap();
        let (i, j) = (place("from"), place("to"));
        let mut add = |matrix: usize, i: usize, j: usize, value: BigRational| {
            *all[matrix].entry((i, j)).or_insert_with(BigRational::zero) += value;
        };
        match row["kind"].as_str() {
            "mass" => add(0, i, i, value()),
            "shared inertia" => {
                add(0, i, j, value());
                add(0, j, i, value());
            }
            kind @ ("spring" | "damper") => {
                let matrix = if kind == "damper" { 1 } else { 2 };
                add(matrix, i, i, value());
                if row["to"] != "ground" {
                    add(matrix, j, j, value());
                    add(matrix, i, j, -value());
                    add(matrix, j, i, -value());
                }
            }
            kind @ ("gyroscopic" | "circulatory") => {
                let matrix = if kind == "gyroscopic" { 1 } else { 2 };
                add(matrix, i, j, value());
                add(matrix, j, i, -value());
            }
            _ => {}
        }
    }
    all.map(|mut matrix| {
        matrix.retain(|_, value| !value.is_zero());
        matrix
    })
}

fn entries(all: &[(usize, usize, Evaluated)]) -> Matrix {
    let mut matrix = Matrix::new();
    for (i, j, x) in all {
        *matrix.entry((*i, *j)).or_insert_with(BigRational::zero) += &x.value;
    }
    matrix.retain(|_, value| !value.is_zero());
    matrix
}

/// The drawing of a scene, its matrices from its data those of the scene: exactly where `exact`, else to the
/// rounding of what is written.
fn drawn(path: &Path, exact: bool) -> (Vec<HashMap<String, String>>, String) {
    let (rows, svg) = draw(&format!("machine {}", path.display()), "machine");
    assert_no_overlap(&svg);
    let machine = Scene::read(path).unwrap().written().unwrap().machine;
    let matrices = [&machine.mass, &machine.damping, &machine.stiffness].map(|all| entries(all));
    for (own, other) in matrices.into_iter().zip(rebuilt(&rows)) {
        if exact {
            assert_eq!(own, other, "{}", path.display());
            continue;
        }
        assert!(own.keys().eq(other.keys()), "{}", path.display());
        let float = |x: &BigRational| Evaluated { value: x.clone(), exact: true }.float();
        let largest = own.values().map(|x| float(x).abs()).fold(0.0, f64::max);
        for (place, x) in &own {
            let off = float(&(x - &other[place])).abs();
            assert!(off <= 1e-15 * largest, "{}: {place:?}", path.display());
        }
    }
    (rows, svg)
}

/// No text covers another, no number is lost, and of the examples nothing but Duffing's spring and a rotor's
/// gyroscopic coupling is red.
#[test]
fn every_example_is_drawn_and_its_matrices_come_back() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut seen = 0;
    for folder in ["machines", "scenes"] {
        for entry in fs::read_dir(examples.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|ending| ending != "toml") {
                continue;
            }
            let (rows, svg) = drawn(&path, false);
            let remarks = rows.iter().filter(|row| row["kind"] == "remark").count();
            let expected = match path.file_name().and_then(|name| name.to_str()) {
                Some("duffing-wall.toml") => (2, true),
                Some("overhung-rotor.toml") => (1, true),
                _ => (0, false),
            };
            assert_eq!((remarks, svg.contains("#d55e00")), expected, "{}", path.display());
            assert!(rows.iter().all(|row| row["drawn"] != "no: too many"), "{}", path.display());
            // A stop that pushes by a law of its own has that in place of a restitution.
            if path.ends_with("hertz.toml") {
                let law = rows.iter().find(|row| row["quantity"] == "law").map(|row| row["value"].as_str());
                assert_eq!(law, Some("k*d^1.5*(1+c*v)"));
                assert!(rows.iter().all(|row| row["quantity"] != "restitution"));
                assert!(svg.contains("pushes by k*d^1.5*(1+c*v)"), "{svg}");
            }
            // Every stop and every friction is in the picture by its name.
            let texts: Vec<String> = labels(&svg).into_iter().map(|(text, _)| text).collect();
            for row in rows.iter().filter(|row| ["stop", "friction"].contains(&row["kind"].as_str())) {
                let named = texts.iter().filter(|text| text.starts_with(&row["name"])).count();
                assert!(named >= 2, "{} in {}: {texts:?}", row["name"], path.display());
            }
            seen += 1;
        }
    }
    assert!(seen >= 24, "{seen}");
}

/// A scene with matrices of two decimals, of which some are not symmetric; the mass is positive.
fn random_scene(random: &mut Random, size: usize) -> String {
    let mut number = |most: f64| (random.bits() as f64 / (1u64 << 63) as f64 - 1.0) * most;
    let mut matrix = |diagonal: f64, others: f64, symmetric: bool| {
        let mut all: Vec<Vec<f64>> = Vec::new();
        for i in 0..size {
            let entry = |j: usize| {
                let x = if i == j { diagonal + number(diagonal / 2.0) } else { number(others) };
                let kept = if symmetric && j < i { all[j][i] } else { x };
                if kept.abs() < others / 3.0 { 0.0 } else { kept }
            };
            let row = (0..size).map(entry).collect();
            all.push(row);
        }
        let row = |row: &Vec<f64>| row.iter().map(|x| format!("{x:.2}")).collect::<Vec<_>>().join(", ");
        format!("[{}]", all.iter().map(|one| format!("[{}]", row(one))).collect::<Vec<_>>().join(", "))
    };
    let mass = matrix(8.0, 4.0 / size as f64, true);
    let [damping, stiffness] = [(3.0, size.is_multiple_of(2)), (500.0, !size.is_multiple_of(3))]
        .map(|(scale, symmetric)| matrix(scale, scale / 2.0, symmetric));
    let row: Vec<String> = (0..size).map(|_| format!("{:.1}", number(3.0))).collect();
    let row = row.join(", ");
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"Random\"\nengine = \"many\"\n[system]\nperiod = 1\nmass = {mass}\n\
         damping = {damping}\nstiffness = {stiffness}\nforcing = [{{ k = 2, cos = [{row}], sin = [{row}] }}]\n\
         [[stops]]\nname = \"lever\"\nrow = [{row}]\noffset = -1\nrestitution = 0.5\n"
    )
}

#[test]
fn matrices_come_back_from_the_data_of_random_machines() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("random.toml");
    let mut random = Random(7);
    let (mut negative, mut skew, mut shared) = (0, 0, 0);
    for size in (1..=6).cycle().take(24) {
        fs::write(&path, random_scene(&mut random, size)).unwrap();
        let (rows, svg) = drawn(&path, true);
        let is = |kind: &str| rows.iter().filter(|row| row["kind"] == kind).count();
        negative +=
            rows.iter().filter(|row| row["kind"] == "spring" && row["value"].starts_with('-')).count();
        skew += is("gyroscopic") + is("circulatory");
        shared += is("shared inertia");
        assert_eq!(is("remark") > 0, svg.contains("#d55e00"));
    }
    assert!(negative > 20 && skew > 20 && shared > 20, "{negative} {skew} {shared}");
}

/// A chain that is too long, and matrices that are full: what there is no room for is said, and in the data.
#[test]
fn what_is_not_drawn_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("chain.toml");
    let n = 40;
    let row = |i: usize| {
        let at = |j: usize| if i == j { 2 } else { -i32::from(i.abs_diff(j) == 1) };
        format!("[{}]", (0..n).map(|j| at(j).to_string()).collect::<Vec<_>>().join(", "))
    };
    let rows = (0..n).map(row).collect::<Vec<_>>().join(", ");
    let ones = vec!["1"; n].join(", ");
    let head = "format = \"grazing-scene 3\"\ntitle = \"Chain\"\n[system]\n";
    let text = format!("{head}mass = {{ diagonal = [{ones}] }}\nstiffness = [{rows}]\n");
    fs::write(&path, &text).unwrap();
    let (rows, svg) = drawn(&path, true);
    assert_eq!(rows.iter().filter(|row| row["kind"] == "spring").count(), n - 1 + 2);
    assert!(rows.iter().any(|row| row["drawn"] == "no: too many"));
    assert!(svg.contains("not drawn, but in the data: coordinates q13 to q40"), "{svg}");
    let full: Vec<String> =
        (0..9).map(|i| format!("[{}]", vec![format!("{}", i + 1); 9].join(", "))).collect();
    let ones = ["1"; 9].join(", ");
    let full = full.join(", ");
    fs::write(&path, format!("{head}mass = {{ diagonal = [{ones}] }}\nstiffness = [{full}]\n")).unwrap();
    let (_, svg) = drawn(&path, true);
    assert!(svg.contains("#d55e00"));
}

fn stdout(arguments: &str) -> String {
    let (code, out, err) = run(arguments, Path::new("."));
    assert_eq!((code, err.as_str()), (0, ""), "{arguments}");
    out
}

fn error(arguments: &str) -> String {
    let (code, _, err) = run(arguments, Path::new("."));
    assert_eq!(code, 2, "{arguments}: {err}");
    err
}

#[test]
fn a_scene_is_asked_for_and_its_parameters_can_be_set() {
    let folder = tempfile::tempdir().unwrap();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/machines/two-masses.toml");
    let out = folder.path().join("a.svg");
    let all = stdout(&format!("figure machine {} --set F0=-7 -o {}", path.display(), out.display()));
    assert!(all.starts_with("wrote ") && fs::read_to_string(&out).unwrap().contains("-7 cos"), "{all}");
    assert!(error("figure machine").contains("give its file"));
    assert!(error("figure intervals scene.toml").contains("N: "));
    assert!(error("figure intervals --set a=1").contains("--set belongs to"));
    let wrong = error(&format!("figure machine {} --set F=1", path.display()));
    assert!(wrong.contains("the scene has no parameter \"F\""), "{wrong}");
    let same = error(&format!("figure machine {0} -o {0}", path.display()));
    assert!(same.contains("pictures are .svg"), "{same}");
}
