//! Reports in LaTeX: orbits, events, chaos, ranges and attractors that are proved, as blocks of two columns,
//! name and value, which fit any page. A certificate is cited by its SHA-256.

use std::{io::Write, path::Path};

use crate::{
    cli::cite,
    error::Result,
    output::{latex, latex_numbers},
    run::{Findings, GrazingFindings, Tabular, TaskReport},
};

/// Names of columns that print has other words for.
const NAMES: [(&str, &str); 15] = [
    ("trace", "$\\lambda_1 + \\lambda_2$"),
    ("det", "$\\lambda_1 \\lambda_2$"),
    ("gamma", "$\\gamma$"),
    ("e", "$e$"),
    ("width", "width of its enclosure"),
    ("lower", "at least"),
    ("upper", "at most"),
    ("only_within", "the only one within"),
    ("least_gap", "least gap"),
    ("parameter", "value of the parameter"),
    ("periods", "letter, periods"),
    ("next", "letters that may follow"),
    ("after", "speed after impact"),
    ("before", "speed before impact"),
    ("solution", "solution, about"),
];

/// The tables of all reports, one per task.
pub(super) fn reports(scene: &str, all: &[TaskReport], out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "% grazing-run 4: \\input this file after \\usepackage{{amsmath,array,booktabs,longtable}}"
    )?;
    for report in all {
        let blocks = match &report.findings {
            Some(Findings::Grazing(found)) if let Some(beside) = proved_beside(found) => beside,
            Some(Findings::Validate(found)) => blocks(&found.proofs),
            Some(Findings::Branch(found)) if found.proofs.is_some() => {
                found.proofs.iter().flat_map(|x| blocks(&x.rows)).collect()
            }
            Some(Findings::Orbit(found)) => blocks(&found.orbits),
            Some(Findings::Event(found)) => blocks(&found.found),
            Some(Findings::Chaos(found)) => {
                let yes = |yes: bool| if yes { "yes" } else { "no" }.to_string();
                let numbers = |x: Option<f64>| x.map_or(String::new(), |x| format!("{x:?}"));
                let head = [
                    ("proved", yes(found.proved)),
                    ("oscillator", found.oscillator.clone()),
                    ("range", found.range.clone()),
                    ("every one may follow", yes(found.full)),
                    ("no others, speeds to", numbers(found.complete)),
                    ("contraction", numbers(found.contraction)),
                    ("entropy", found.entropy.clone().unwrap_or_default()),
                    ("growth rate", found.growth.clone().unwrap_or_default()),
                    ("certificate", found.certificate.clone().unwrap_or_default()),
                ];
                let head = head.map(|(name, value)| (name.to_string(), value)).to_vec();
                std::iter::once(head).chain(blocks(&found.letters)).collect()
            }
            Some(Findings::Diagram(found)) if found.proofs.is_some() => {
                found.proofs.iter().flat_map(|x| blocks(&x.rows)).collect()
            }
            _ => {
                writeln!(out, "% task {} of kind {}: no table in LaTeX", report.task, report.kind)?;
                continue;
            }
        };
        table(scene, report, &blocks, out)?;
    }
    Ok(())
}

/// What is proved beside a touch, how far what is born goes on and what attracts; none if neither was asked
/// for.
fn proved_beside(found: &GrazingFindings) -> Option<Blocks> {
    let GrazingFindings::Found(found) = found else { return None };
    let (ranges, attractors) = (found.range.iter(), found.proofs.iter());
    let asked = found.range.is_some() || found.proofs.is_some();
    asked.then(|| ranges.flat_map(blocks).chain(attractors.flat_map(|x| blocks(&x.rows))).collect())
}

/// Name and value of each column that is not empty, row by row.
type Blocks = Vec<Vec<(String, String)>>;

fn blocks<T: Tabular>(rows: &T) -> Blocks {
    let names: Vec<String> = rows.columns().iter().map(ToString::to_string).collect();
    rows.cells(None).into_iter().map(|cells| names.iter().cloned().zip(cells).collect()).collect()
}

fn table(scene: &str, report: &TaskReport, blocks: &Blocks, out: &mut dyn Write) -> Result<()> {
    let parameters: Vec<String> =
        report.parameters.iter().map(|(name, value)| format!("{} = {}", latex(name), latex(value))).collect();
    let with = if parameters.is_empty() { String::new() } else { format!(", {}", parameters.join(", ")) };
    let status = report.status.to_string();
    writeln!(out, "{{\\setlength{{\\LTcapwidth}}{{\\linewidth}}")?;
    writeln!(out, "\\begin{{longtable}}{{l>{{\\raggedright\\arraybackslash}}p{{0.6\\linewidth}}}}")?;
    writeln!(
        out,
        "\\caption{{{}: task {} ({}), {}{with}.}}\\label{{tab:{}}} \\\\",
        latex(scene),
        latex(&report.task),
        report.kind,
        latex(&status),
        label(&report.task)
    )?;
    writeln!(out, "\\toprule\n\\endfirsthead\n\\toprule\n\\endhead\n\\bottomrule\n\\endfoot")?;
    for (index, block) in blocks.iter().enumerate() {
        if index > 0 {
            writeln!(out, "\\midrule")?;
        }
        for (name, value) in block.iter().filter(|(_, value)| !value.is_empty()) {
            let heading = NAMES.iter().find(|known| known.0 == name);
            let heading = heading.map_or_else(|| latex(&name.replace('_', " ")), |known| known.1.to_string());
            let unit = report.units.iter().find(|unit| unit.column == name && !unit.own.is_empty());
            let unit = unit.map_or(String::new(), |unit| format!(" ({})", latex(&unit.own)));
            let value = match name.as_str() {
                "pattern" if value.starts_with("free") => "no impact".to_string(),
                "pattern" => format!("$({})$", value.replace(' ', "")),
                "certificate" => cited(value, report),
                _ => latex_numbers(value),
            };
            writeln!(out, "{heading}{unit} & {value} \\\\")?;
        }
    }
    writeln!(out, "\\end{{longtable}}}}")?;
    Ok(())
}

/// What `\ref` finds a task's table by: a name has letters, digits, hyphens and underscores.
fn label(task: &str) -> String {
    task.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect()
}

/// The certificate's file and the SHA-256 of its text, which a line may break.
fn cited(file: &str, report: &TaskReport) -> String {
    let all = report.findings.iter().flat_map(Findings::certificates);
    match all.into_iter().find(|one| one.file == file) {
        Some(found) => cite::written(Path::new(file), found.accepted.text()),
        None => format!("\\texttt{{{}}}", latex(file)),
    }
}
