//! Attempts side by side, beside what others got.

use super::Attempt;
use comfy_table::{CellAlignment, Table, presets::ASCII_MARKDOWN};

/// Rows of others, for the star: energy drift, impulse, largest and median imbalance, rebound, and what they are.
const OTHERS: [([&str; 5], &str); 4] = [
    (["−0.8 %", "", "", "", ""], "the paper, isotropic m=1 (as printed)"),
    (["+6.8 %", "", "", "19 %", ""], "the paper's code, its step made stable"),
    (["+5.3 %", "668.5", "", "", "28.05"], "another code, exact m=1, 3.889 µs"),
    (["+0.28 %", "668.9", "", "", "28.05"], "another code, exact m=1, 0.972 µs"),
];

/// The table, in Markdown. With `references`, rows that hold for the star only.
pub fn table(attempts: &[Attempt], references: bool) -> Table {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header([
        "method",
        "k",
        "energy drift",
        "impulse (N s/m)",
        "|ΣF| max",
        "|ΣF| median",
        "rebound (m/s)",
        "sideways / v0",
        "crossings",
        "ms/step",
        "contact",
        "ended",
    ]);
    for attempt in attempts {
        let outcome = &attempt.outcome;
        table.add_row([
            attempt.name(),
            format!("{:.1e}", attempt.stiffness),
            format!("{:+.2} %", 100.0 * outcome.energy_drift).replace('-', "−"),
            format!("{:.1}", outcome.impulse),
            part(outcome.balance_max),
            part(outcome.balance_median),
            format!("{:.2}", outcome.rebound),
            format!("{:.1e}", outcome.sideways),
            outcome.crossings.to_string(),
            format!("{:.2}", 1e3 * outcome.seconds_per_step),
            format!("{:.0} %", 100.0 * outcome.contact_share),
            match &attempt.failure {
                None => "as planned".into(),
                Some(_) => format!("failed at {:.2} ms", 1e3 * outcome.end),
            },
        ]);
    }
    if references {
        for ([drift, impulse, most, median, rebound], source) in OTHERS {
            table.add_row([source, "", drift, impulse, most, median, rebound, "", "", "", "", ""]);
        }
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

/// A part of the whole: in per cent, or as a power of ten where that would be nothing.
fn part(x: f64) -> String {
    if x >= 1e-3 { format!("{:.1} %", 100.0 * x) } else { format!("{x:.0e}") }
}
