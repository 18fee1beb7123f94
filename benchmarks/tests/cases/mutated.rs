//! Case files with values changed at random: a run, or an error that says why not, never a panic.

use super::folder::Folder;
use fmc_benchmarks::case::{Case, Document, library};
use fmc_benchmarks::run::{RunOptions, run, run_at_rest};
use fmc_benchmarks::study::{Convergence, Refined};
use fmc_shapes::Splitmix;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use toml::{Table, Value};

/// Meshes above this are not made here, though they may be: the test is to end soon.
const MOST_NODES: f64 = 1500.0;

/// Steps or iterations of a run, after which it is stopped.
const MOST_STEPS: u64 = 3;

/// Values that a file may have in the place of any other.
fn strange(random: &mut Splitmix, before: &Value) -> Value {
    let huge = i64::MAX;
    match random.bits() % 24 {
        0 => Value::Integer(0),
        1 => Value::Integer(-1),
        2 => Value::Integer(huge),
        3 => Value::Integer(1 << (random.bits() % 62)),
        4 => Value::Float(f64::NAN),
        5 => Value::Float(f64::INFINITY),
        6 => Value::Float(-0.0),
        7 => Value::Float(1e300),
        8 => Value::Float(-1e300),
        9 => Value::Float(1e-300),
        10 => Value::String(String::new()),
        11 => Value::Array(Vec::new()),
        12 => Value::Table(Table::new()),
        13 => Value::Boolean(random.bits().is_multiple_of(2)),
        _ => match before {
            Value::Integer(n) => Value::Integer(n.wrapping_mul(1 << (random.bits() % 63)).wrapping_sub(1)),
            Value::Float(x) => Value::Float(x * 10f64.powi((random.bits() % 41) as i32 - 20)),
            Value::Array(list) => {
                let mut list = list.clone();
                match (random.bits() % 3, list.first().cloned()) {
                    (0, Some(first)) => list.push(first),
                    (1, Some(_)) => list.truncate(1),
                    (_, Some(first)) => list[0] = strange(random, &first),
                    (_, None) => list.push(Value::Integer(1)),
                }
                Value::Array(list)
            }
            Value::Boolean(yes) => Value::Boolean(!yes),
            other => other.clone(),
        },
    }
}

/// Changes, removes or doubles one value somewhere below.
fn mutate(random: &mut Splitmix, value: &mut Value) {
    match value {
        Value::Table(table) if !table.is_empty() => {
            let at = random.bits() as usize % table.len();
            let (name, inner) = table.iter_mut().nth(at).expect("there are so many");
            if random.bits().is_multiple_of(12) {
                let name = name.to_owned();
                table.remove(&name);
            } else {
                mutate(random, inner);
            }
        }
        Value::Array(list) if list.iter().any(Value::is_table) => {
            let at = random.bits() as usize % list.len();
            match random.bits() % 12 {
                0 => drop(list.remove(at)),
                1 => list.push(list[at].clone()),
                _ => mutate(random, &mut list[at]),
            }
        }
        Value::Array(list) if !list.is_empty() && random.bits().is_multiple_of(2) => {
            let at = random.bits() as usize % list.len();
            mutate(random, &mut list[at]);
        }
        _ => *value = strange(random, value),
    }
}

/// Carries out the first steps, or a study of one mesh, whatever comes of them.
fn begin(document: &Document, case: &Case, out: &Path) {
    let options = RunOptions { out: out.to_owned(), threads: 1, resume: false };
    let mut steps = 0;
    let mut count = || {
        steps += 1;
        if steps < MOST_STEPS { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    if case.load_steps.is_some() && steps_of_study(case) {
        let (case, folder) = (case.clone(), document.folder.clone());
        let study = Convergence { case, folder, meshes: vec![2.0], fibers: Vec::new(), threads: 1 };
        let _ = study.run(&mut |_| ()).and_then(|rows| Refined::write(out, "a case", &rows));
        return;
    }
    let _ = match case.load_steps {
        Some(_) => run_at_rest(document, case, &options, &mut |_| count()),
        None => run(document, case, &options, &mut |_| count()),
    };
}

/// Whether a study, which cannot be stopped, ends soon enough to be made.
fn steps_of_study(case: &Case) -> bool {
    let steps = case.load_steps.as_ref().map_or(0, |steps| steps.count + steps.then.iter().sum::<usize>());
    case.node_estimate() < 200.0 && steps == 1
}

/// The same changes of the same files, one, two or three to a file.
#[test]
fn changed_files_run_or_are_refused() {
    let folder = Folder::new("mutated");
    let mut random = Splitmix::new(7);
    let (mut refused, mut begun, mut panicked) = (0, 0, Vec::new());
    for round in 0..40 {
        for (name, text) in library::CASES {
            let mut table: Table = text.parse().unwrap();
            // What costs most and is of no interest here.
            table.insert("output".into(), Value::Table(toml::toml! { frames = 1 }));
            let mut value = Value::Table(table);
            for _ in 0..=round % 3 {
                mutate(&mut random, &mut value);
            }
            let Value::Table(table) = &value else { continue };
            let text = toml::to_string(table).unwrap();
            let carried_out = catch_unwind(AssertUnwindSafe(|| {
                let case = Document::parse(name, name, &folder.0, &text).and_then(|file| Ok((file.case()?, file)));
                let Ok((case, document)) = case else { return false };
                if case.node_estimate() < MOST_NODES && case.contact.fibers.is_none_or(|n| n < 1000) {
                    begin(&document, &case, &folder.0);
                }
                true
            }));
            match carried_out {
                Ok(true) => begun += 1,
                Ok(false) => refused += 1,
                Err(_) => panicked.push(format!("{name}, round {round}:\n{text}")),
            }
        }
    }
    assert!(panicked.is_empty(), "{} panics, the first of {}", panicked.len(), panicked[0]);
    assert!(refused > 100 && begun > 100, "{refused} refused, {begun} begun");
}
