//! `fmc mesh`: a case as other hosts need it, with its nodes, cells, held nodes and loaded faces.

use anyhow::{Context, Result};
use fmc_benchmarks::case::{Case, Document, Load};
use fmc_mesh_io::write_whole;
use fmc_solid::fem::Model;
use serde_json::{Value, json};
use std::io::Write;
use std::path::PathBuf;

/// Write a case as JSON for another finite element program: the mesh node for node, supports and loads
///
/// Numbers are written so that they are read back bit for bit. Node numbers count from 0, the bodies' nodes follow one
/// another, and cells have VTK's node order.
#[derive(clap::Args, Clone, Debug)]
pub(crate) struct MeshArgs {
    /// Name of a case (see fmc list), or path of a case file
    case: String,

    /// A variant of the case: a named set of changes
    #[arg(long, value_name = "NAME")]
    variant: Option<String>,

    /// Change a value of the case, as in contact.exponent=2; may be repeated
    #[arg(long = "override", value_name = "KEY=VALUE")]
    overrides: Vec<String>,

    /// File to write [default: standard output]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Writes the file.
pub(crate) fn run(args: &MeshArgs) -> Result<()> {
    let mut document = Document::open(&args.case)?;
    if let Some(variant) = &args.variant {
        document.choose(variant)?;
    }
    for assignment in &args.overrides {
        document.override_with("--override", assignment)?;
    }
    let case = document.case()?;
    let value = match case.dimension {
        2 => described::<2>(&document, &case)?,
        _ => described::<3>(&document, &case)?,
    };
    let text = serde_json::to_string(&value)? + "\n";
    match &args.out {
        Some(path) => write_whole(path, text),
        None => Ok(write!(std::io::stdout(), "{text}")?),
    }
}

/// Contents of the file.
fn described<const D: usize>(document: &Document, case: &Case) -> Result<Value> {
    let problem = case.problem::<D>(&document.folder, 1)?;
    let model = &problem.model;
    let bodies: Vec<Value> = (case.bodies.iter().zip(model.parts()).enumerate())
        .map(|(number, (body, part))| {
            json!({
                "name": body.name, "material": body.material, "initial_velocity": body.initial_velocity,
                "cell_type": part.cell_type.name(),
                "conn": model.cells(number).map(|(_, nodes)| nodes).collect::<Vec<_>>(),
            })
        })
        .collect();
    let loads = case.loads.iter().map(|load| loaded(case, model, load)).collect::<Result<Vec<Value>>>()?;
    let stages = case.load_steps.as_ref().map_or(0, |steps| steps.then.len());
    let then = (1..=stages)
        .map(|stage| Ok(case.constraints(model, stage)?.iter().collect::<Vec<_>>()))
        .collect::<Result<Vec<_>>>()?;
    let effective = toml::Table::try_from(case)?;
    let expected: Vec<Value> = (case.expected.iter())
        .filter(|expected| expected.applies(&effective, document.variant.as_deref(), &document.changes))
        .map(|e| json!({ "figure": e.figure, "value": e.value, "tolerance": e.tolerance(), "source": e.source }))
        .collect();
    Ok(json!({
        "case": document.name, "variant": document.variant, "title": case.title, "dimension": D,
        "coords": model.coords().iter().map(|x| x.to_vec()).collect::<Vec<_>>(),
        "bodies": bodies,
        "supports": problem.supports.iter().collect::<Vec<_>>(), "supports_then": then,
        "loads": loads,
        "obstacles": case.obstacles, "contact": case.contact, "time": case.time, "load_steps": case.load_steps,
        "figures": case.figures, "expected": expected,
    }))
}

/// A load with the faces that carry it, each with its nodes as seen from outside, counter-clockwise.
fn loaded<const D: usize>(case: &Case, model: &Model<D>, load: &Load) -> Result<Value> {
    let part = case.body(&load.body).context("a load names no body")?;
    let mut faces = Vec::new();
    if let Some(place) = &load.place {
        let nodes = &model.coords()[model.nodes_of(part)];
        let end = |axis: usize, pick: fn(f64, f64) -> f64| nodes.iter().map(|x| x[axis]).reduce(pick).unwrap_or(0.0);
        let low: [f64; D] = std::array::from_fn(|axis| end(axis, f64::min));
        let high: [f64; D] = std::array::from_fn(|axis| end(axis, f64::max));
        faces = model.faces_where(part, |x| place.holds(x, &low, &high) == Some(true));
    }
    Ok(json!({
        "body": part, "pressure": load.pressure, "traction": load.traction, "body_force": load.body_force,
        "faces": faces.into_iter().map(|face| face.nodes).collect::<Vec<_>>(),
    }))
}
