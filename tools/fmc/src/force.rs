//! `fmc force`: contact forces between the bodies of mesh files.
//!
//! Files are read and moved, put together into one mesh, divided into bodies, evaluated once, and the result is printed
//! and written. The arithmetic of contact is all in `fmc-contact`; here are files, names and numbers only.

use crate::estimator_args::{EstimatorArgs, positive};
use crate::folder;
use anyhow::{Context, Result, ensure};
use assembly::Assembly;
use clap::Args;
use division::{DivideBy, Division};
use fmc_contact::Contact;
use fmc_mesh_io::{Kind, Mesh, fiber_grid, write_whole};
use obstacle::ObstacleSpec;
use placement::{Rotation, Translation};
use report::Report;
use stages::Stages;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;
use unit::Unit;

mod assembly;
mod components;
mod division;
mod explain;
mod obstacle;
mod picture;
mod pictures;
mod placement;
mod report;
mod sizes;
mod stages;
mod unit;

/// Calls of [`Stages::begin`].
const STAGES: u64 = 6;

const EXAMPLES: &str = "\
Units: lengths are in the unit of the mesh, which --unit names. With metres, forces
are in N in 3D, in N per m of thickness in 2D. K is a pressure by penetration, in
Pa/m (with millimetres in MPa/mm): 10 E / h with
Young's modulus E and facets of size h. With --law volume and exponent 1 it is a
pressure in Pa, which must exceed the peak contact pressure, or the bodies pass
through one another; with another exponent M in Pa / (length^D)^(M-1), D = 2 or 3.

Examples:
  A star, 0.01 m deep in a block, both 2D:
    fmc force examples/star.msh examples/block.msh --stiffness 1e6
  The same, the star turned by 5 degrees and lowered by 0.02 m, as JSON:
    fmc force examples/star.msh examples/block.msh --stiffness 1e6 \\
      --rotate 1=5 --translate 1=0,-0.02 --json -
  The connected parts of one 3D mesh against one another, exactly:
    fmc force examples/two_blocks.msh --stiffness 1e6 --estimator exact
  A ball on a rigid floor:
    fmc force examples/ball.vtu --stiffness 1e6 \\
      --obstacle \"half-space position=0,0,0 axis=0,0,1\"";

/// Contact forces between overlapping meshes
#[derive(Args, Debug)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct ForceArgs {
    /// Meshes: Gmsh 4.1 or 2.2 (.msh, text or binary), VTK unstructured grids (.vtu) or Abaqus input files (.inp) with
    /// Tri3, Quad4, Tet4, Hex8, Wedge6, Pyramid5 cells, or of second order Tri6, Quad8, Quad9, Tet10, Hex20, Hex27,
    /// Wedge15, Pyramid13. 2D: triangles and
    /// quadrilaterals at constant z; 3D: tetrahedra, hexahedra, wedges and pyramids, or a closed surface of triangles and
    /// quadrilaterals, also of second order
    #[arg(value_name = "MESH", required = true)]
    meshes: Vec<PathBuf>,

    /// Stiffness K: pressure by penetration [Pa/length]; for --law volume, w = K V^m, a pressure for m = 1 [Pa]
    #[arg(long, value_name = "K", value_parser = positive)]
    stiffness: f64,

    /// Unit of length of the meshes, for printed units: no number changes, K is then a force per this length cubed
    #[arg(long, value_enum, value_name = "UNIT", default_value_t)]
    unit: Unit,

    /// Moves a mesh, given by its place on the command line from 1: --translate 2=0,-0.1 or 2=0,0,-0.1 [length]
    #[arg(long, value_name = "MESH=X,Y[,Z]")]
    translate: Vec<Translation>,

    /// Turns a mesh about the origin, before it is moved: --rotate 1=30 in 2D (counter-clockwise), in 3D with the axis
    /// in front, --rotate 1=0,0,1,30 [degrees]
    #[arg(long, value_name = "MESH=[X,Y,Z,]ANGLE")]
    rotate: Vec<Rotation>,

    /// Definition of a body: each file, each connected part of the meshes, each instance of a part (Abaqus), or each
    /// physical group (VTU: each value of the cell array body, gmsh:physical, medit:ref or CellEntityIds; Abaqus without
    /// parts: the element set of a section, else the first) [default: instance if there are any; else file, or component
    /// if there is one file only]
    #[arg(long, value_enum, value_name = "WHAT")]
    bodies: Option<DivideBy>,

    /// Adds a rigid partner [length]:
    ///   half-space (the normal of its face is its axis)
    ///   ball radius=R
    ///   cuboid half-extents=X,Y[,Z]
    ///   cylinder radius=R half-height=H
    ///   cone radius=R half-height=H
    ///   capsule radius=R half-height=H
    /// in quotes, each followed by the position of its centre (half-space: of
    /// a point of its face), position=X,Y[,Z], if it is not the origin, and
    /// by the direction of its axis, axis=X,Y[,Z], if it is not y in 2D or
    /// z in 3D
    #[arg(long, value_name = "SHAPE", verbatim_doc_comment)]
    obstacle: Vec<ObstacleSpec>,

    /// Folder for picture.svg (bodies and forces, for a browser), forces.vtu (meshes with nodal forces, pressures and gaps) and
    /// fibers.vtu (fibers and crossings), for ParaView
    #[arg(long, value_name = "DIR", default_value = "out/force")]
    out: PathBuf,

    /// Most fibers written to fibers.vtu; of more, an even selection is written
    #[arg(long, value_name = "N", default_value_t = 20_000)]
    fibers_shown: usize,

    /// Also writes the result as JSON; - is standard output, to which nothing else goes then
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    #[command(flatten)]
    estimator: EstimatorArgs,
}

/// Runs the command.
pub(crate) fn run(args: &ForceArgs) -> Result<()> {
    args.estimator.check()?;
    let stages = Stages::new(STAGES)?;
    stages.begin("reading");
    let mut meshes = args.meshes.iter().map(|path| Mesh::read(path)).collect::<Result<Vec<_>>>()?;
    let kind = meshes[0].kind();
    for mesh in &meshes[1..] {
        let other = mesh.kind();
        ensure!(other == kind, "{} {}, but {} {}", meshes[0].file, nature(kind), mesh.file, nature(other));
    }
    args.rotate.iter().try_for_each(|rotation| rotation.apply(&mut meshes, kind))?;
    args.translate.iter().try_for_each(|translation| translation.apply(&mut meshes, kind))?;
    match kind {
        Kind::Flat => evaluate::<2>(args, meshes, kind, stages),
        Kind::Surface | Kind::Solid => evaluate::<3>(args, meshes, kind, stages),
    }
}

fn nature(kind: Kind) -> &'static str {
    match kind {
        Kind::Flat => "is a 2D mesh (triangles and quadrilaterals at constant z)",
        Kind::Surface => "is a surface in 3D (triangles and quadrilaterals)",
        Kind::Solid => "has volume cells",
    }
}

fn evaluate<const D: usize>(args: &ForceArgs, meshes: Vec<Mesh>, kind: Kind, stages: Stages) -> Result<()> {
    stages.begin("finding the bodies");
    let assembly = Assembly::<D>::new(meshes, kind)?;
    let by = args.bodies.unwrap_or_else(|| DivideBy::default_of(&assembly.meshes));
    let (surface, division) = Division::new(&assembly, by)?;
    let facet_count = surface.facet_count();
    let explained = |error| explain::explain(&error, &assembly, &division.names);
    let mut contact = Contact::new(surface, args.estimator.options(args.stiffness)).map_err(explained)?;
    for obstacle in &args.obstacle {
        contact.add_obstacle(obstacle.build()?).map_err(explained)?;
    }
    stages.begin("evaluating the contact");
    let start = Instant::now();
    let mut forces = contact.evaluate(&assembly.coords).map_err(explained)?;
    let seconds = start.elapsed().as_secs_f64();
    explain::in_numbers_of_files(&mut forces.warnings, &assembly);
    stages.begin("tracing the overlap");
    let traces = contact.trace(&assembly.coords).map_err(explained)?;
    stages.begin("pressures and gaps at the nodes");
    let at_nodes = contact.nodal_contact(&assembly.coords).map_err(explained)?;

    stages.begin("writing");
    let _lock = folder::taken(&args.out)?;
    let pictures = [args.out.join("forces.vtu"), args.out.join("fibers.vtu")];
    pictures::forces(&assembly, &division, &forces.forces, &at_nodes).write(&pictures[0])?;
    fiber_grid(&traces, args.fibers_shown).write(&pictures[1])?;
    let drawn = match picture::picture(&assembly, &division, &forces.forces) {
        Ok(svg) => {
            let path = args.out.join("picture.svg");
            write_whole(&path, svg)?;
            format!("{} (open it in a browser)", path.display())
        }
        Err(why) => why.to_owned(),
    };
    drop(stages);

    let obstacles: Vec<&str> = args.obstacle.iter().map(|obstacle| obstacle.text.as_str()).collect();
    let mut report = Report::new(&forces, &division.names, &obstacles, seconds);
    if let Some(sentence) = sizes::unlike(&assembly, &division) {
        report.warn(&sentence);
    }
    if division.names.len() == 1 && obstacles.is_empty() && !args.estimator.self_contact {
        report.warn("there is one body only, which nothing can touch: see --bodies, --obstacle and --self-contact");
    }
    if args.json.as_deref() != Some(Path::new("-")) {
        let [nodes, cells] = [assembly.coords.len(), assembly.cell_count()];
        let shown = match (traces.len(), args.fibers_shown) {
            (0, _) => "empty: the overlap, if any, was measured without lines; --estimator fibers lays them".to_owned(),
            (all, most) if all > most => format!("{most} of the {all} fibers in the overlap; see --fibers-shown"),
            (all, _) => format!("{all} fibers in the overlap"),
        };
        print(&format!(
            "{D}D, nodes: {nodes}, cells: {cells}, facets: {facet_count}, bodies: {}\n\n{}\n\
             written: {drawn}\n         {} (for ParaView)\n         {} ({shown})\n",
            division.names.len(),
            report.text(&args.unit.units(D)),
            pictures[0].display(),
            pictures[1].display(),
        ))?;
    }
    match &args.json {
        Some(path) => write_json(path, &report),
        None => Ok(()),
    }
}

fn write_json(path: &Path, report: &Report) -> Result<()> {
    let json = serde_json::to_string_pretty(report)? + "\n";
    if path == Path::new("-") {
        return print(&json);
    }
    write_whole(path, json)
}

/// Prints, and takes a reader that has seen enough (`| head`) for success.
fn print(text: &str) -> Result<()> {
    match io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error).context("standard output"),
        _ => Ok(()),
    }
}
