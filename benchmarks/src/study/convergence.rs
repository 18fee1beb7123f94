//! Errors over mesh size and over fibers.

use crate::case::{Case, EstimatorName, MeshSource};
use crate::chart::{self, Axis, Mark, Panel, Series};
use crate::run::{Figure, solve};
use anyhow::{Context, Result, ensure};
use comfy_table::{CellAlignment, Table, presets::ASCII_MARKDOWN};
use fmc_mesh_io::write_whole;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Settings of the study.
#[derive(Clone, Debug)]
pub struct Convergence {
    /// A case of statics that names the distance of its fibers.
    pub case: Case,
    /// Folder that its mesh files are looked for in.
    pub folder: PathBuf,
    /// Factors of the mesh size, exact overlap.
    pub meshes: Vec<f64>,
    /// Factors of the distance between fibers.
    pub fibers: Vec<f64>,
    /// Threads; nothing but the seconds depends on them.
    pub threads: usize,
}

/// One solution.
#[derive(Clone, Debug)]
pub struct Refined {
    /// Whether the fibers were refined; else the mesh, with exact overlap.
    pub is_of_fibers: bool,
    /// Factor of mesh size or distance.
    pub factor: f64,
    /// Cells.
    pub cells: usize,
    /// Crossings of the last evaluation.
    pub crossings: usize,
    /// Figures with an error: of the mesh against what the case expects, of the fibers against exact overlap. By the
    /// value that it should have, unless that is 0.
    pub errors: Vec<(&'static str, f64)>,
    /// Iterations.
    pub iterations: usize,
    /// Seconds.
    pub seconds: f64,
}

impl Convergence {
    /// Solves them all; `watch` is called with what runs.
    ///
    /// # Errors
    /// If the case is none of statics, names no distance of fibers, or has no equilibrium.
    pub fn run(&self, watch: &mut dyn FnMut(&str)) -> Result<Vec<Refined>> {
        ensure!(self.case.load_steps.is_some(), "the study is made for statics");
        match self.case.dimension {
            2 => self.run_in::<2>(watch),
            _ => self.run_in::<3>(watch),
        }
    }

    fn run_in<const D: usize>(&self, watch: &mut dyn FnMut(&str)) -> Result<Vec<Refined>> {
        let spacing = self.case.contact.spacing.context("the case must name contact.spacing")?;
        let mut rows = Vec::new();
        let expected = |name: &str| self.case.expected.iter().find(|e| e.figure == name).map(|e| e.value);
        for &factor in &self.meshes {
            watch(&format!("mesh × {factor}"));
            let mut case = self.with(EstimatorName::Exact, spacing);
            refine_bodies(&mut case, factor)?;
            rows.push(self.solve::<D>(&case, false, factor, &expected)?.0);
        }
        watch("exact");
        let (_, exact) = self.solve::<D>(&self.with(EstimatorName::Exact, spacing), false, 1.0, &expected)?;
        let exact = |name: &str| exact.iter().find(|figure| figure.name == name)?.value;
        for &factor in &self.fibers {
            watch(&format!("distance of fibers × {factor}"));
            let case = self.with(EstimatorName::Fibers, factor * spacing);
            rows.push(self.solve::<D>(&case, true, factor, &exact)?.0);
        }
        Ok(rows)
    }

    fn with(&self, estimator: EstimatorName, spacing: f64) -> Case {
        let mut case = self.case.clone();
        (case.contact.estimator, case.contact.spacing) = (estimator, Some(spacing));
        case
    }

    fn solve<const D: usize>(
        &self,
        case: &Case,
        is_of_fibers: bool,
        factor: f64,
        reference: &dyn Fn(&str) -> Option<f64>,
    ) -> Result<(Refined, Vec<Figure>)> {
        let clock = Instant::now();
        let solved = solve::<D>(&self.folder, case, self.threads, &mut |_| ControlFlow::Continue(()))?;
        let error = |figure: &Figure| {
            let (value, reference) = (figure.value?, reference(figure.name)?);
            let by = if reference.abs() < 1e-9 { 1.0 } else { reference.abs() };
            Some((figure.name, (value - reference).abs() / by))
        };
        let at = &solved.equilibrium;
        let row = Refined {
            is_of_fibers,
            factor,
            cells: at.model().cell_count(),
            crossings: at.balance().contact.crossing_count,
            errors: solved.figures.iter().filter(|figure| figure.name != "force").filter_map(error).collect(),
            iterations: at.iterations,
            seconds: clock.elapsed().as_secs_f64(),
        };
        Ok((row, solved.figures))
    }
}

/// Makes the cells of all bodies larger by a factor.
fn refine_bodies(case: &mut Case, factor: f64) -> Result<()> {
    ensure!(factor.is_finite() && factor > 0.0, "a factor of the mesh size must be positive, not {factor}");
    if factor == 1.0 {
        return Ok(());
    }
    for body in &mut case.bodies {
        // Figures of the mesh as it is, put down as those of another one, would be wrong.
        ensure!(
            refine(&mut body.mesh, factor),
            "the mesh of body '{}' {}, whose cells cannot be made {factor} times as large; leave it with factor 1 (--meshes 1)",
            body.name,
            if matches!(body.mesh, MeshSource::File { .. }) { "is that of a file" } else { "is of a shape" }
        );
    }
    case.check().with_context(|| format!("meshes {factor} times as coarse"))
}

/// Makes cells larger by a factor, if that can be done with such a mesh.
fn refine(mesh: &mut MeshSource, factor: f64) -> bool {
    let fewer = |count: &mut usize| *count = ((*count as f64 / factor).round() as usize).max(1);
    match mesh {
        MeshSource::Rectangle { cells, .. } | MeshSource::Quadrilateral { cells, .. } => {
            cells.iter_mut().for_each(fewer)
        }
        MeshSource::Quadrilaterals { parts, .. } => parts.iter_mut().flat_map(|part| &mut part.cells).for_each(fewer),
        MeshSource::Cuboid { cells, .. } => cells.iter_mut().for_each(fewer),
        MeshSource::Tetrahedron { edges, .. } => fewer(edges),
        MeshSource::GradedHalfDisc { finest, growth, .. } => {
            *finest *= factor;
            // As many cells fewer everywhere.
            *growth *= factor.sqrt();
        }
        _ => return false,
    }
    true
}

impl Refined {
    /// All of them, in Markdown.
    pub fn table(rows: &[Self]) -> Table {
        let names: Vec<&str> =
            rows.first().map_or(Vec::new(), |row| row.errors.iter().map(|(name, _)| *name).collect());
        let mut table = Table::new();
        let header = ["refined", "factor", "cells", "crossings"].into_iter().map(String::from);
        let header = header.chain(names.iter().map(|name| format!("error of {name}")));
        table.load_style(ASCII_MARKDOWN).set_header(header.chain(["iterations".into(), "seconds".into()]));
        for row in rows {
            let error = |name: &&str| row.errors.iter().find(|(known, _)| known == name).map(|(_, error)| *error);
            let errors = names.iter().map(|name| error(name).map_or(String::new(), |error| format!("{error:.1e}")));
            let first = [
                if row.is_of_fibers { "fibers" } else { "mesh" }.to_owned(),
                row.factor.to_string(),
                row.cells.to_string(),
                row.crossings.to_string(),
            ];
            let last = [row.iterations.to_string(), format!("{:.2}", row.seconds)];
            table.add_row(first.into_iter().chain(errors).chain(last));
        }
        for column in table.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        table
    }

    /// Writes `convergence.csv`, `.png` and `.svg` into a folder.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(folder: &Path, title: &str, rows: &[Self]) -> Result<()> {
        const COLORS: [(u8, u8, u8); 5] = [(0, 114, 178), (213, 94, 0), (0, 158, 115), (204, 121, 167), (230, 159, 0)];
        std::fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        let mut text = "refined,factor,cells,crossings,figure,error,iterations,seconds\n".to_owned();
        for Refined { is_of_fibers, factor, cells, crossings, errors, iterations, seconds } in rows {
            let what = if *is_of_fibers { "fibers" } else { "mesh" };
            for (name, error) in errors {
                text += &format!("{what},{factor},{cells},{crossings},{name},{error:?},{iterations},{seconds:.3}\n");
            }
        }
        let path = folder.join("convergence.csv");
        write_whole(&path, text)?;
        let panel = |of_fibers: bool, label: &str| {
            let of_kind = || rows.iter().filter(move |row| row.is_of_fibers == of_fibers);
            let names = of_kind().next().map_or(Vec::new(), |row| row.errors.iter().map(|(name, _)| *name).collect());
            let series = names.into_iter().enumerate().map(|(index, name)| {
                let error =
                    |row: &Refined| row.errors.iter().find(|(known, _)| *known == name).map(|(_, error)| *error);
                let points = of_kind().filter_map(|row| Some((row.factor, error(row)?)));
                let points = points.filter(|(_, error)| *error > 0.0).collect();
                Series { mark: Mark::LineAndPoints, ..Series::line(name, COLORS[index % COLORS.len()], points) }
            });
            Panel { x: Axis::log(label), y: Axis::log("error"), series: series.collect() }
        };
        let panels =
            [panel(false, "mesh size, by that of the case"), panel(true, "distance of fibers, by that of the case")];
        chart::draw(folder, "convergence", title, &panels)
    }
}
