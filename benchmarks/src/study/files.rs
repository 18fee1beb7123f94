//! A study as files.

use super::Attempt;
use crate::chart::{self, Axis, Mark, Panel, Series};
use anyhow::{Context, Result};
use fmc_mesh_io::write_whole;
use std::fmt::Write;
use std::path::Path;

/// Colours of the methods that colour-blind readers tell apart too (Okabe and Ito), in the order of their declaration.
const COLORS: [(u8, u8, u8); 3] = [(213, 94, 0), (0, 114, 178), (30, 30, 30)];

/// Change of energy, in per cent, beyond which a curve leaves the picture: it would press the others flat.
const MOST_SHOWN: f64 = 12.0;

/// Points of one curve. Sampled forces make the energy jump at every step; lines as thick as these, drawn from step to
/// step, would show their own corners and nothing else. Each point is the mean of some steps.
const MOST_POINTS: usize = 250;

/// Writes `impact.csv` (a line per attempt), `energy.csv` (a line per step) and `energy.png` and `.svg` into a folder.
///
/// # Errors
/// If a file cannot be written.
pub fn write(folder: &Path, title: &str, attempts: &[Attempt]) -> Result<()> {
    std::fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
    for (name, text) in [("impact.csv", outcomes(attempts)), ("energy.csv", energies(attempts))] {
        let path = folder.join(name);
        write_whole(&path, text)?;
    }
    chart::draw(folder, "energy", &format!("{title}: total energy"), &panels(attempts))
}

fn outcomes(attempts: &[Attempt]) -> String {
    let mut text = "method,exponent,stiffness,energy_drift,impulse,balance_max,balance_median,rebound,sideways,\
                    crossings,seconds_per_step,contact_share,end,failure\n"
        .to_owned();
    for Attempt { method, exponent, stiffness, outcome, failure, .. } in attempts {
        let numbers = [
            outcome.energy_drift,
            outcome.impulse,
            outcome.balance_max,
            outcome.balance_median,
            outcome.rebound,
            outcome.sideways,
            outcome.crossings as f64,
            outcome.seconds_per_step,
            outcome.contact_share,
            outcome.end,
        ];
        let numbers: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
        // Commas and quotes of a message stay inside its quotes.
        let failure = failure.as_ref().map_or(String::new(), |failure| format!("\"{}\"", failure.replace('"', "'")));
        let line = format!("{},{exponent},{stiffness:?},{},{failure}", method.name(), numbers.join(","));
        text += &line;
        text.push('\n');
    }
    text
}

/// A column for each attempt; empty where it had ended.
fn energies(attempts: &[Attempt]) -> String {
    let names: Vec<String> = attempts.iter().map(|attempt| attempt.name().replace(' ', "_")).collect();
    let mut text = format!("time,{}\n", names.join(","));
    let longest = attempts.iter().max_by_key(|attempt| attempt.energy.len());
    for (step, (time, _)) in longest.into_iter().flat_map(|attempt| &attempt.energy).enumerate() {
        write!(text, "{time:?}").expect("writing into a string");
        for attempt in attempts {
            let value = attempt.energy.get(step).map_or(String::new(), |(_, energy)| format!("{energy:?}"));
            write!(text, ",{value}").expect("writing into a string");
        }
        text.push('\n');
    }
    text
}

/// A panel for each law.
fn panels(attempts: &[Attempt]) -> Vec<Panel> {
    let longest = attempts.iter().map(|attempt| attempt.energy.len()).max().unwrap_or(0);
    let steps = longest.div_ceil(MOST_POINTS).max(1);
    let panel = |exponent: f64| {
        let of_law = attempts.iter().filter(|attempt| attempt.exponent == exponent);
        let label = if exponent == 1.0 { "w = k V" } else { "w = k V²" };
        let means = if steps == 1 { String::new() } else { format!(" (means of {steps} steps)") };
        Panel {
            x: Axis::linear(format!("time, ms{means}")),
            y: Axis::linear(format!("change of total energy, % ({label})")),
            series: of_law.map(|attempt| curve(attempt, steps)).collect(),
        }
    };
    let laws = [1.0, 2.0].into_iter().filter(|&m| attempts.iter().any(|attempt| attempt.exponent == m));
    laws.map(panel).collect()
}

fn curve(attempt: &Attempt, steps: usize) -> Series {
    let mean = |chunk: &[(f64, f64)]| {
        let (time, change) = chunk.iter().fold((0.0, 0.0), |(t, e), (time, energy)| (t + time, e + energy - 1.0));
        (1e3 * time / chunk.len() as f64, 100.0 * change / chunk.len() as f64)
    };
    let points = attempt.energy.chunks(steps).map(mean).take_while(|(_, change)| change.abs() < MOST_SHOWN).collect();
    let series = Series::line(attempt.method.name(), COLORS[attempt.method as usize], points);
    // What lies on the exact curve must still be seen.
    if attempt.method == super::Method::Lines { Series { mark: Mark::Dashes, ..series } } else { series }
}
