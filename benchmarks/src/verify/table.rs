//! The rows to read: of every case, form, estimator and quantity the θ with the largest scaled error.

use super::row::Row;
use comfy_table::{CellAlignment, Table, presets::ASCII_MARKDOWN};

/// The table, in Markdown.
pub fn table(rows: &[Row]) -> Table {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header([
        "case",
        "form",
        "cells",
        "estimator",
        "quantity",
        "worst at θ",
        "computed",
        "reference",
        "relative error",
        "scaled error",
        "bound",
        "fibers",
        "crossings",
        "seconds",
    ]);
    for row in worst(rows) {
        table.add_row([
            row.case.to_string(),
            row.form.to_string(),
            row.cells.to_string(),
            row.estimator.to_string(),
            row.quantity.to_string(),
            format!("{:.3}", row.theta),
            number(row.computed),
            number(row.reference),
            format!("{:.1e}", row.relative_error),
            format!("{:.1e}", row.scaled_error),
            row.bound.map_or(String::new(), |bound| format!("{bound:.1e}")),
            row.fibers.to_string(),
            row.crossings.to_string(),
            format!("{:.4}", row.seconds),
        ]);
    }
    for column in table.column_iter_mut().skip(5) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

/// Eight decimals; what rounds to zero has no sign.
fn number(x: f64) -> String {
    format!("{:.8}", if x.abs() < 5e-9 { 0.0 } else { x })
}

/// Of every group the row with the largest error, groups in the order of their first row.
fn worst(rows: &[Row]) -> Vec<&Row> {
    let group = |row: &Row| (row.case, row.form, row.estimator, row.quantity);
    let mut worst: Vec<&Row> = Vec::new();
    for row in rows {
        match worst.iter_mut().find(|other| group(other) == group(row)) {
            Some(other) if other.scaled_error < row.scaled_error => *other = row,
            Some(_) => {}
            None => worst.push(row),
        }
    }
    worst
}
