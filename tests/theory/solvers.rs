//! The sentences put to z3, cvc5 and QEPCAD, whichever are installed.
//!
//! What each proves in what time is in `docs/conjecture1.md`. With `GRAZING_REQUIRE_SOLVER=1` it is a failure
//! if none of them is installed.

use std::{
    io::{ErrorKind, Write},
    process::{Command, Stdio},
};

use grazing::symbol::{Area, Format, HalfCellSide, Sentence, period_formulas, write_formulas};

struct Solver {
    command: &'static [&'static str],
    format: Format,
    /// What it prints last, or after the last empty line, for a true sentence.
    proved: &'static str,
    /// The last period put to it here, in region 4 and on half-cells.
    region4: usize,
    half_cells: usize,
}

const SOLVERS: [Solver; 3] = [
    Solver { command: &["qepcad"], format: Format::Qepcad, proved: "TRUE", region4: 9, half_cells: 9 },
    Solver {
        command: &["z3", "-in", "-T:60"],
        format: Format::Smtlib,
        proved: "unsat",
        region4: 6,
        half_cells: 5,
    },
    Solver {
        command: &["cvc5", "--lang=smt2", "--tlimit=10000"],
        format: Format::Smtlib,
        proved: "unsat",
        region4: 4,
        half_cells: 3,
    },
];

impl Solver {
    /// Its whole output for `script`; `None` where it is not installed.
    fn run(&self, script: &str) -> Option<String> {
        let (program, arguments) = self.command.split_first().expect("a program");
        let started =
            Command::new(program).args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut child = match started {
            Err(error) if error.kind() == ErrorKind::NotFound => return None,
            started => started.expect(program),
        };
        child.stdin.take().expect("piped").write_all(script.as_bytes()).expect(program);
        let output = child.wait_with_output().expect(program);
        Some(String::from_utf8_lossy(&output.stdout).into_owned())
    }

    fn proves(&self, script: &str) -> bool {
        let output = self.run(script).expect("it was there a moment ago");
        output.lines().any(|line| line.trim() == self.proved)
    }
}

fn half_cells(n: usize) -> impl Iterator<Item = Area> {
    let coprime = (1..n.div_ceil(2)).filter(move |m| num_integer::gcd(*m, n) == 1);
    coprime.flat_map(|m| [HalfCellSide::Plus, HalfCellSide::Minus].map(|side| Area::HalfCell { m, side }))
}

#[test]
fn installed_solvers_prove_our_sentences() {
    if !crate::samples::asked("GRAZING_REQUIRE_SOLVER", "sentences put to a solver") {
        return;
    }
    let trivial = |solver: &&Solver| {
        solver.run(if solver.format == Format::Smtlib { "(check-sat)\n" } else { "finish\n" }).is_some()
    };
    let installed: Vec<_> = SOLVERS.iter().filter(trivial).collect();
    assert!(!installed.is_empty(), "none of qepcad, z3, cvc5 was found");
    for solver in installed {
        let name = solver.command[0];
        for n in 3..=solver.region4.max(solver.half_cells) {
            for k in 1..n {
                let script = write_formulas(&period_formulas(n, k).unwrap(), solver.format);
                assert!(solver.proves(&script), "{name}: the factors of n = {n}, k = {k}\n{script}");
            }
            let areas = [Area::Region4].into_iter().filter(|_| n <= solver.region4);
            for area in areas.chain(half_cells(n).filter(|_| n <= solver.half_cells)) {
                let script = Sentence::new(n, area).unwrap().write(solver.format);
                assert!(solver.proves(&script), "{name}: {area} of n = {n}\n{script}");
            }
        }
        let script = Sentence::new(3, Area::Region4).unwrap().write(solver.format);
        // The first claim, u_3 > 0, turned round.
        let falsified = match solver.format {
            Format::Smtlib => script.replacen("(assert (not (and (>", "(assert (not (and (<", 1),
            _ => script.replacen("[ a1^2 - a2 > 0", "[ a1^2 - a2 < 0", 1),
        };
        assert_ne!(script, falsified);
        assert!(!solver.proves(&falsified), "{name} proves a false sentence\n{falsified}");
    }
}
