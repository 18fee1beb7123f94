//! `fmc list`: the cases that the program brings along.

use anyhow::Result;
use comfy_table::{Table, presets::ASCII_MARKDOWN};
use fmc_benchmarks::case::{Case, Document, library};
use std::io::Write;
use std::path::Path;

/// List the cases that `fmc run` knows by name
#[derive(clap::Args, Clone, Debug)]
pub(crate) struct ListArgs {
    /// Print a list of JSON objects instead
    #[arg(long)]
    json: bool,
}

/// Prints the list.
pub(crate) fn run(args: &ListArgs) -> Result<()> {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header(["case", "dimension", "nodes", "cells", "steps", "title", "variants"]);
    let mut entries = Vec::new();
    for (name, _) in library::CASES {
        let case = Document::open(name)?.case()?;
        let (nodes, cells) = match case.dimension {
            2 => size::<2>(&case)?,
            _ => size::<3>(&case)?,
        };
        let steps = case.time.step.map(|step| case.time.steps(step));
        let variants: Vec<&String> = case.variants.keys().collect();
        entries.push(serde_json::json!({
            "case": name, "title": case.title, "dimension": case.dimension, "nodes": nodes, "cells": cells,
            "steps": steps, "variants": variants,
        }));
        let variants: Vec<&str> = variants.into_iter().map(String::as_str).collect();
        table.add_row([
            name.to_string(),
            case.dimension.to_string(),
            nodes.to_string(),
            cells.to_string(),
            steps.map_or("stable".into(), |steps| steps.to_string()),
            case.title.clone(),
            variants.join(", "),
        ]);
    }
    if args.json {
        writeln!(std::io::stdout(), "{}", serde_json::to_string_pretty(&entries)?)?;
    } else {
        writeln!(std::io::stdout(), "{table}\n\nfmc run CASE runs one; CASE may also be the path of a case file.")?;
    }
    Ok(())
}

/// Nodes and cells of all bodies.
fn size<const D: usize>(case: &Case) -> Result<(usize, usize)> {
    let parts = case.parts::<D>(Path::new(""))?;
    Ok(parts.iter().fold((0, 0), |(n, c), part| (n + part.mesh.coords.len(), c + part.mesh.cell_count())))
}
