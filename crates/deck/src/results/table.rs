//! A step as text.

use super::frd::real;
use crate::analysis::{PairResult, ReferenceResult, StepResult, TieResult};
use fmc_contact::contact::Adjustment;
use std::fmt::Write;

/// What a step has led to, for reading.
pub fn step_table(step: &StepResult) -> String {
    let vector = |v: &[f64; 3]| v.map(|x| format!("{:>13}", real(x))).join(" ");
    let StepResult {
        number,
        time,
        iterations,
        reaction,
        sets,
        references,
        load,
        displacement,
        pairs,
        ties,
        bodies,
        warnings,
        ..
    } = step;
    let mut text = format!(
        "step {number}, time {time}: {iterations} linear solves so far, {}, largest displacement {displacement:.6e}\n",
        residual(step)
    );
    if let Some(Adjustment { closed, removed, left, count }) = step.adjustment {
        writeln!(
            text,
            "  ADJUST moved the surface at {count} nodes: gaps up to {closed:.6e} closed, overlaps up to {removed:.6e} removed, \
             {left:.1e} left"
        )
        .expect("writing into a string");
    }
    let width = bodies.iter().map(|(name, _)| name.len()).max().unwrap_or(0).max(9);
    let width = sets.iter().map(|(name, _)| name.len()).max().unwrap_or(0).max(width);
    let name_of = |pair: &PairResult| format!("{} on {}", pair.names[0], pair.names[1]);
    let width = pairs.iter().map(|pair| name_of(pair).len()).max().unwrap_or(0).max(width);
    let width = ties.iter().map(|tie| tie.names[0].len() + tie.names[1].len() + 4).max().unwrap_or(0).max(width);
    let mut line = |name: &str, rest: String| writeln!(text, "  {name:width$} {rest}").expect("writing into a string");
    line("", format!("{:>13} {:>13} {:>13}", "force x", "y", "z"));
    line("loads", vector(load));
    line("reactions", vector(reaction));
    for (name, sum) in sets {
        line(name, format!("{}  reactions of this set", vector(sum)));
    }
    for ReferenceResult { label, force, moment, .. } in references {
        line(&format!("node {label}"), format!("{}  reaction of this reference node", vector(force)));
        line("", format!("{}  and its moment", vector(moment)));
    }
    for pair in pairs {
        let size = pair.force.iter().map(|f| f * f).sum::<f64>().sqrt();
        // Ties pull, too.
        let (kind, by_area) = match pair.is_tied {
            true => ("tied", format!("force by area {:.6e}", if pair.area > 0.0 { size / pair.area } else { 0.0 })),
            false => ("contact", format!("mean pressure {:.6e}", pair.pressure)),
        };
        let rest = format!("{}  {kind}, area {:.6e}, {by_area}", vector(&pair.force), pair.area);
        line(&name_of(pair), rest);
    }
    for TieResult { names: [a, b], reach, area, gap, nodes, facets } in ties {
        let rest = format!(
            "tied within a reach of {reach:.6e}: {facets} facets, {nodes} nodes, area {area:.6e}, largest gap {gap:.1e}"
        );
        line(&format!("{a} to {b}"), rest);
    }
    for (number, (name, force)) in bodies.iter().enumerate() {
        line(name, format!("{}  contact and ties on body {number}", vector(force)));
    }
    warnings.iter().for_each(|warning| writeln!(text, "  warning: {warning}").expect("writing into a string"));
    text
}

/// The residual against the largest forces until then: those of a step that unloads vanish with its loads.
fn residual(step: &StepResult) -> String {
    match step.largest_force > 0.0 {
        true => format!("residual {:.1e} of the largest forces so far", step.residual / step.largest_force),
        false => "no forces so far".to_owned(),
    }
}
