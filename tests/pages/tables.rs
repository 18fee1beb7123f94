//! A table of figures names the command that repeats it: a target of make, a program, a benchmark, or the test that holds it.

use super::{in_docs, root};
use std::fs;
use std::path::Path;

/// Tables of numbers that nobody has measured: typical values, numbers of nodes, closed forms, an estimate by hand.
const NOT_MEASURED: [(&str, &str); 9] = [
    ("choosing.md", "| softer body |"),
    ("options-contact-step.md", "| N, mm, MPa;"),
    ("options-friction.md", "| quantity |"),
    ("options-law.md", "| quantity |"),
    ("ranks.md", "| data received by each rank |"),
    ("second-order.md", "| cell | nodes |"),
    ("second-order.md", "| face | corner |"),
    ("second-order.md", "| facet | in |"),
    ("second-order.md", "| cell | number of points |"),
];

fn cells(row: &str) -> Vec<String> {
    row.replace("\\|", "").trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
}

/// Whether a third of the cells, but for the first of each row, are numbers.
fn has_figures(rows: &[&str]) -> bool {
    let all = rows.iter().flat_map(|row| cells(row).into_iter().skip(1)).filter(|cell| !cell.is_empty());
    let is_number =
        |cell: &str| cell.trim_start_matches(['−', '-', '+', '*', ' ']).starts_with(|c: char| c.is_ascii_digit());
    let (mut numbers, mut count) = (0, 0);
    all.for_each(|cell| (numbers, count) = (numbers + usize::from(is_number(&cell)), count + 1));
    numbers >= 3 && 3 * numbers > count
}

/// Pieces of code in a text, and where its links lead.
fn pieces(text: &str) -> Vec<&str> {
    let code = text.split('`').skip(1).step_by(2);
    let links = text.match_indices("](").filter_map(|(place, _)| text[place + 2..].split(')').next());
    code.chain(links).collect()
}

fn is_command(piece: &str, makefile: &str) -> bool {
    let words: Vec<&str> = piece.split_whitespace().collect();
    match words.as_slice() {
        ["make", target, ..] => makefile
            .lines()
            .any(|line| line.split(':').next().is_some_and(|names| names.split(' ').any(|t| t == *target))),
        ["fmc", "run" | "study" | "verify" | "report", ..] => true,
        ["cargo", "bench", rest @ ..] => {
            let bench = rest.iter().position(|word| *word == "--bench").map(|at| rest[at + 1]);
            bench.is_some_and(|name| root().join(format!("benchmarks/benches/{name}.rs")).exists())
        }
        ["python", "-m", ..] => true,
        ["python", path, ..] | [path] => is_program(path.trim_start_matches("../")),
        _ => false,
    }
}

/// A file or folder of tests or benchmarks.
fn is_program(path: &str) -> bool {
    let path = path.split('#').next().unwrap_or(path);
    let is_code = [".py", ".rs"].iter().any(|end| path.ends_with(end)) || path.contains("tests");
    is_code && path.contains('/') && root().join(Path::new(path)).exists()
}

/// Each table with its rows, and the prose next to it: up to the table before and behind, or to the heading.
fn tables(text: &str) -> Vec<(Vec<&str>, String)> {
    let mut found: Vec<(Vec<&str>, String)> = Vec::new();
    let (mut before, mut is_code, mut open) = (String::new(), false, false);
    for line in text.lines() {
        let is_row = line.starts_with('|') && !is_code;
        is_code ^= line.starts_with("```");
        if is_row {
            if !open {
                found.push((Vec::new(), std::mem::take(&mut before)));
            }
            found.last_mut().expect("a table").0.push(line);
        } else if line.starts_with('#') && !is_code {
            before.clear();
            found.push((Vec::new(), String::new()));
        } else {
            before = before + line + "\n";
            if let Some((_, prose)) = found.last_mut() {
                *prose = std::mem::take(prose) + line + "\n";
            }
        }
        open = is_row;
    }
    found.retain(|(rows, _)| rows.len() > 2);
    found
}

#[test]
fn every_table_of_figures_names_its_command() {
    let parts = fs::read_dir(root().join("make")).expect("make").map(|part| part.expect("an entry").path());
    let makefile: String = parts.map(|part| fs::read_to_string(part).expect("a part of the makefile")).collect();
    let (mut seen, mut without, mut left_out) = (0, Vec::new(), 0);
    for page in in_docs() {
        let name = page.file_name().expect("a name").to_string_lossy().into_owned();
        let text = fs::read_to_string(&page).expect("a page");
        // The tables of a tutorial have what its program prints.
        if name == "c-reference.md" || name == "support.md" || text.contains("examples/notebooks/tutorial") {
            continue;
        }
        for (rows, prose) in tables(&text) {
            if NOT_MEASURED.iter().any(|(of, head)| *of == name && rows[0].starts_with(head)) {
                left_out += 1;
            } else if has_figures(&rows[2..]) {
                seen += 1;
                let with_rows = prose + &rows.concat();
                if !pieces(&with_rows).into_iter().any(|piece| is_command(piece, &makefile)) {
                    without.push(format!("{name}: {}", rows[0]));
                }
            }
        }
    }
    assert!(seen > 60 && left_out == NOT_MEASURED.len(), "{seen} tables of figures, {left_out} left out");
    assert!(without.is_empty(), "{without:#?}");
}
