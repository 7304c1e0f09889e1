//! Tables of a run as other programs read them.

use crate::{
    process::run,
    surface::{python, root},
};

use std::{collections::BTreeMap, fs, path::Path};

/// A motion and a branch, and a section with texts, in a folder.
fn tables() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let scene = root().join("tests/data/kinds.toml");
    let only = "--only motion --only branch --only section";
    // A start of the branch has no orbit: 3.
    let (code, _, err) = run(&format!("run {} {only} -o .", scene.display()), folder.path());
    assert_eq!(code, 3, "{err}");
    folder
}

fn export(table: &str, file: &str, folder: &Path) {
    let (code, out, err) = run(&format!("export {table} -o {file}"), folder);
    assert!(code == 0 && out.starts_with(&format!("wrote {file}: ")), "{out}{err}");
}

/// A column of a CSV file.
fn column(file: &Path, name: &str) -> Vec<String> {
    let mut reader = csv::Reader::from_path(file).unwrap();
    let at = reader.headers().unwrap().iter().position(|known| known == name).unwrap();
    reader.records().map(|row| row.unwrap()[at].to_string()).collect()
}

fn floats(cells: &[String]) -> Vec<f64> {
    cells.iter().map(|cell| cell.parse().unwrap()).collect()
}

/// A matrix of a MAT-file of level 4: type, rows, columns, real parts column by column.
type Matrix = (u32, usize, usize, Vec<f64>);

/// As the form of level 4 says, read from the first byte to the last.
fn matrices(bytes: &[u8]) -> BTreeMap<String, Matrix> {
    let int = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let float = |at: usize| f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
    let (mut all, mut at) = (BTreeMap::new(), 0);
    while at < bytes.len() {
        let [kind, rows, columns, complex, name] = [0, 4, 8, 12, 16].map(|by| int(at + by));
        let (rows, columns) = (rows as usize, columns as usize);
        at += 20;
        let text = String::from_utf8(bytes[at..at + name as usize - 1].to_vec()).unwrap();
        at += name as usize;
        let real = (0..rows * columns).map(|i| float(at + 8 * i)).collect();
        at += 8 * rows * columns * (1 + complex as usize);
        all.insert(text, (kind, rows, columns, real));
    }
    assert_eq!(at, bytes.len());
    all
}

#[test]
fn matlab_reads_the_numbers_of_a_table() {
    let folder = tables();
    let path = |name: &str| folder.path().join(name);
    export("motion.csv", "motion.mat", folder.path());
    let all = matrices(&fs::read(path("motion.mat")).unwrap());
    for name in ["time", "q", "u", "gap"] {
        let wanted = floats(&column(&path("motion.csv"), name));
        assert_eq!(all[name], (0, wanted.len(), 1, wanted), "{name}");
    }
    export("section.csv", "section.mat", folder.path());
    let all = matrices(&fs::read(path("section.mat")).unwrap());
    let (kind, rows, columns, letters) = &all["set"];
    let first = column(&path("section.csv"), "set")[0].clone();
    let shown: String = (0..*columns).map(|i| letters[i * rows] as u8 as char).collect();
    assert_eq!((*kind, shown.trim_end()), (1, first.as_str()));
}

/// What NumPy makes of an archive: with it the arrays themselves, without it the entries.
#[test]
fn numpy_reads_the_numbers_of_a_table() {
    let folder = tables();
    let path = |name: &str| folder.path().join(name);
    export("motion.csv", "motion.npz", folder.path());
    export("branch-points.csv", "branch.npz", folder.path());
    let bytes = fs::read(path("motion.npz")).unwrap();
    let text = String::from_utf8_lossy(&bytes);
    let names = ["time", "periods", "q", "u", "gap"].map(|name| format!("{name}.npy"));
    // Once before its data, once in the directory.
    assert!(names.iter().all(|name| text.matches(&format!("\0{name}")).count() == 2), "{names:?}");
    let rows = column(&path("motion.csv"), "q").len();
    let head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows},), }}");
    assert_eq!(text.matches(&head).count(), 5);
    if !python(folder.path(), &["-c", "import numpy"]).is_ok_and(|output| output.status.success()) {
        println!("no numpy: the archive was looked at, not loaded");
        return;
    }
    let script = "
import csv, numpy
d = numpy.load('motion.npz')
rows = list(csv.DictReader(open('motion.csv')))
assert set(d) == set(rows[0]), list(d)
for name in d:
    assert d[name].tolist() == [float(row[name]) for row in rows], name
d = numpy.load('branch.npz')
rows = list(csv.DictReader(open('branch-points.csv')))
assert d['parameters'].tolist() == [float(row['parameters']) for row in rows]
assert d['label'].tolist() == [row['label'] for row in rows]
assert d['multipliers'].shape == (len(rows), 2), d['multipliers'].shape
";
    let output = python(folder.path(), &["-c", script]).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Points, labels and stability of a branch stand where AUTO's reader takes them; a motion is its numbers.
#[test]
fn auto_reads_branches_and_motions() {
    let folder = tables();
    let path = |name: &str| folder.path().join(name);
    export("branch-points.csv", "b.branch", folder.path());
    let text = fs::read_to_string(path("b.branch")).unwrap();
    let points: Vec<&str> = text.lines().filter(|line| !line.starts_with("   0")).collect();
    let [parameters, labels, stable] =
        ["parameters", "label", "stable"].map(|name| column(&path("branch-points.csv"), name));
    assert_eq!(points.len(), parameters.len());
    let mut kinds = Vec::new();
    for (((point, parameter), label), stable) in points.iter().zip(&parameters).zip(&labels).zip(&stable) {
        let words: Vec<&str> = point.split_whitespace().collect();
        let number: f64 = words[4].parse().unwrap();
        assert_eq!(number, parameter.parse::<f64>().unwrap(), "{point}");
        assert_eq!(words[1].starts_with('-'), stable == "yes", "{point}");
        if !label.is_empty() {
            kinds.push((label.split(' ').next().unwrap(), words[2]));
        }
    }
    assert!(kinds.contains(&("saddle-node", "5")) && kinds.contains(&("grazing", "-4")), "{kinds:?}");
    export("motion.csv", "motion.dat", folder.path());
    let text = fs::read_to_string(path("motion.dat")).unwrap();
    let read: Vec<f64> = text.split_whitespace().map(|number| number.parse().unwrap()).collect();
    let columns = ["time", "q", "u"].map(|name| floats(&column(&path("motion.csv"), name)));
    let wanted: Vec<f64> =
        (0..columns[0].len()).flat_map(|row| columns.each_ref().map(|all| all[row])).collect();
    assert_eq!(read, wanted);
}

#[test]
fn what_cannot_be_exported_is_said() {
    let folder = tables();
    fs::write(folder.path().join("twice.csv"), "a,b,a\n1,2,3\n").unwrap();
    for (arguments, said) in [
        ("twice.csv -o twice.mat", "twice.csv:1: two columns are called \"a\", the second is column 3"),
        ("motion.csv -o motion.txt", "the name says who reads it"),
        ("motion.csv -o b.motion", "no points of branches"),
        ("section.csv -o section.dat", "no motion"),
        ("motion.csv -o motion.csv", "motion.csv"),
        ("branch.json -o branch.mat", "branch.json"),
    ] {
        let (code, out, err) = run(&format!("export {arguments}"), folder.path());
        assert!(code == 2 && out.is_empty() && err.contains(said), "{arguments}: {code} {err}");
    }
}
