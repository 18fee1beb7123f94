//! Newton's method beside the loop of Wang, Xu and Xue.

use crate::case::{Case, EstimatorName, LawName};
use crate::chart::{self, Axis, Panel, Series};
use anyhow::{Context, Result, ensure};
use comfy_table::{CellAlignment, Table, presets::ASCII_MARKDOWN};
use fmc_contact::EnergyLaw;
use fmc_mesh_io::write_whole;
use fmc_solid::statics::{Equilibrium, FixedPoint, Iteration, Problem, StaticsError};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Settings of the study.
#[derive(Clone, Debug)]
pub struct SolverStudy {
    /// A case of statics in 2D with the law `fiber`.
    pub case: Case,
    /// Folder that its mesh files are looked for in.
    pub folder: PathBuf,
    /// Iterations of the loop, at most.
    pub most_iterations: usize,
    /// Relaxations of the loop; 1 is the paper's algorithm as printed.
    pub relaxations: Vec<f64>,
    /// Threads; nothing but the seconds depends on them.
    pub threads: usize,
}

/// One way to the equilibrium.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Solver and law, as in `loop × 0.1, w = k V, exact`.
    pub name: String,
    /// Residual by the forces before every iteration.
    pub residuals: Vec<f64>,
    /// Linear systems solved.
    pub iterations: usize,
    /// Seconds.
    pub seconds: f64,
    /// Least and largest contact force over the last half of the iterations.
    pub forces: [f64; 2],
    /// Whether the tolerance was reached.
    pub converged: bool,
    /// Why it ended, if it failed.
    pub failure: Option<String>,
}

/// Residual at which a state counts as balanced.
const TOLERANCE: f64 = 1e-10;

/// Without and with the loaded nodes held.
const BY_NEWTON: usize = 2;
/// Laws of the loop.
const LOOPED: usize = 3;
const ESTIMATORS: [EstimatorName; 2] = [EstimatorName::Exact, EstimatorName::Fibers];

impl SolverStudy {
    /// How many solutions there will be.
    pub fn solution_count(&self) -> usize {
        ESTIMATORS.len() * (BY_NEWTON + LOOPED * self.relaxations.len())
    }

    /// Solves the case by Newton's method under its own loads; then with its loaded nodes held where that has led them,
    /// by Newton's method and by the loop, which cannot hold a body by contact alone. `watch` is called with what runs.
    ///
    /// # Errors
    /// If the case is none of statics in 2D with the law `fiber`, or Newton's method fails.
    pub fn run(&self, watch: &mut dyn FnMut(&str)) -> Result<Vec<Solution>> {
        ensure!(self.case.dimension == 2 && self.case.load_steps.is_some(), "the study is made for statics in 2D");
        ensure!(self.case.contact.law == LawName::Fiber, "the case must have the law fiber");
        let mut solutions = Vec::new();
        for estimator in ESTIMATORS {
            watch("newton");
            let (solution, _) = self.newton(self.problem(estimator, None)?, estimator, "under the load")?;
            solutions.push(solution);
        }
        let (_, reference) = self.newton(self.problem(EstimatorName::Exact, None)?, EstimatorName::Exact, "")?;
        let held = Some(&reference);
        for estimator in ESTIMATORS {
            watch("newton");
            let (solution, _) = self.newton(self.problem(estimator, held)?, estimator, "held where it led")?;
            solutions.push(solution);
        }
        let contact = &reference.balance().contact;
        let peak = 1.5 * contact.pairs.iter().map(|pair| pair.pressure).fold(0.0, f64::max);
        // For V² the same penetration as that of the case's own law.
        let laws: [_; LOOPED] = [
            ("w = k V", EnergyLaw::volume(1.2 * peak)),
            ("w = k V²", EnergyLaw::Volume { stiffness: 0.5 * peak / contact.volume, exponent: 2.0 }),
            ("fiber", EnergyLaw::fiber(self.case.contact.stiffness)),
        ];
        for (name, law) in laws {
            for estimator in ESTIMATORS {
                for &relaxation in &self.relaxations {
                    let mut problem = self.problem(estimator, held)?;
                    problem.contact.law = law;
                    let name = format!("loop × {relaxation}, {name}, {}", word(estimator));
                    watch(&name);
                    solutions.push(self.looped(name, problem, relaxation)?);
                }
            }
        }
        Ok(solutions)
    }

    /// The case; with the loaded nodes of an equilibrium held where they are, or with its loads.
    fn problem(&self, estimator: EstimatorName, held: Option<&Equilibrium<2>>) -> Result<Problem<2>> {
        let contact = crate::case::Contact { estimator, ..self.case.contact.clone() };
        let mut problem = Case { contact, ..self.case.clone() }.problem::<2>(&self.folder, self.threads)?;
        if let Some(at) = held {
            for node in 0..problem.load.len() {
                if problem.load[node] != [0.0; 2] {
                    (0..2).for_each(|axis| problem.supports.prescribe([node], axis, at.displacement()[node][axis]));
                }
            }
            problem.load.clear();
        }
        Ok(problem)
    }

    fn newton(&self, problem: Problem<2>, estimator: EstimatorName, how: &str) -> Result<(Solution, Equilibrium<2>)> {
        let mut equilibrium = Equilibrium::new(problem)?;
        let mut residuals = Vec::new();
        let clock = Instant::now();
        equilibrium
            .follow(Default::default(), &mut |iteration: &Iteration| {
                residuals.push(iteration.residual);
                ControlFlow::Continue(())
            })
            .context("Newton's method")?;
        let solution = Solution {
            name: format!("Newton, fiber, {}, {how}", word(estimator)),
            residuals,
            iterations: equilibrium.iterations,
            seconds: clock.elapsed().as_secs_f64(),
            forces: [force(&equilibrium); 2],
            converged: true,
            failure: None,
        };
        Ok((solution, equilibrium))
    }

    fn looped(&self, name: String, problem: Problem<2>, relaxation: f64) -> Result<Solution> {
        let mut equilibrium = Equilibrium::new(problem)?;
        let settings = FixedPoint { relaxation, most_iterations: self.most_iterations, tolerance: TOLERANCE };
        let mut residuals = Vec::new();
        let clock = Instant::now();
        let end = equilibrium.fixed_point(settings, &mut |iteration: &Iteration| {
            residuals.push(iteration.residual);
            // Beyond this it only diverges.
            if iteration.residual.is_finite() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        let seconds = clock.elapsed().as_secs_f64();
        let iterations = equilibrium.iterations;
        Ok(match end {
            Ok(end) => {
                let last = &end.forces[end.forces.len() / 2..];
                let range = last.iter().fold([f64::INFINITY, 0.0], |r: [f64; 2], f| [r[0].min(*f), r[1].max(*f)]);
                let forces = if end.converged { [force(&equilibrium); 2] } else { range };
                Solution { name, residuals, iterations, seconds, forces, converged: end.converged, failure: None }
            }
            Err(error @ (StaticsError::Contact(_) | StaticsError::Inverted { .. } | StaticsError::Interrupted)) => {
                let failure = Some(error.to_string());
                Solution { name, residuals, iterations, seconds, forces: [f64::NAN; 2], converged: false, failure }
            }
            Err(error) => return Err(error.into()),
        })
    }
}

fn word(estimator: EstimatorName) -> &'static str {
    if estimator == EstimatorName::Exact { "exact" } else { "lines" }
}

/// Largest contact force on a body.
fn force(at: &Equilibrium<2>) -> f64 {
    at.balance().contact.bodies.iter().map(|body| body.force[0].hypot(body.force[1])).fold(0.0, f64::max)
}

impl Solution {
    /// The solutions side by side, in Markdown.
    pub fn table(solutions: &[Self]) -> Table {
        let mut table = Table::new();
        table.load_style(ASCII_MARKDOWN).set_header([
            "solver, law, overlap",
            "iterations",
            "seconds",
            "residual least",
            "residual last",
            "force",
            "ended",
        ]);
        for solution in solutions {
            let Solution { name, residuals, iterations, seconds, forces: [low, high], converged, failure } = solution;
            let force = match (converged, failure) {
                (true, _) => format!("{low:.4}"),
                (false, Some(_)) => String::new(),
                (false, None) => format!("{low:.3} to {high:.3}"),
            };
            let ended = match (converged, failure) {
                (true, _) => "converged".to_owned(),
                (false, Some(failure)) => failure.clone(),
                (false, None) => "does not converge".to_owned(),
            };
            table.add_row([
                name.clone(),
                iterations.to_string(),
                format!("{seconds:.2}"),
                format!("{:.1e}", residuals.iter().copied().fold(f64::INFINITY, f64::min)),
                format!("{:.1e}", residuals.last().copied().unwrap_or(f64::NAN)),
                force,
                ended,
            ]);
        }
        for column in table.column_iter_mut().skip(1).take(5) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        table
    }

    /// Writes `solvers.csv` and residuals over iterations as `solvers.png` and `.svg` into a folder.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(folder: &Path, title: &str, solutions: &[Self]) -> Result<()> {
        const COLORS: [(u8, u8, u8); 5] = [(0, 114, 178), (213, 94, 0), (0, 158, 115), (204, 121, 167), (230, 159, 0)];
        std::fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        let mut text = "solver,iteration,residual\n".to_owned();
        for solution in solutions {
            for (iteration, residual) in solution.residuals.iter().enumerate() {
                text += &format!("\"{}\",{iteration},{residual:?}\n", solution.name);
            }
        }
        let path = folder.join("solvers.csv");
        write_whole(&path, text)?;
        // Exact overlap shows what is the solver's.
        let shown = solutions.iter().filter(|solution| solution.name.contains("exact") && solution.residuals.len() > 1);
        let series = shown.enumerate().map(|(index, solution)| {
            let points = solution.residuals.iter().enumerate();
            let points = points.filter(|(_, r)| **r > 0.0 && r.is_finite()).map(|(k, r)| (k as f64, r.min(1e3)));
            Series::line(solution.name.replace(", exact", ""), COLORS[index % COLORS.len()], points.collect())
        });
        let panel =
            Panel { x: Axis::linear("iteration"), y: Axis::log("residual by the forces"), series: series.collect() };
        chart::draw(folder, "solvers", title, &[panel])
    }
}
