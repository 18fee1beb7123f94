//! From the cases to rows and pictures.

use super::case::Case;
use super::method::Method;
use super::row::{self, Row, Setting};
use super::{cone, convergence, cube, cubes, disc, half_disc, over_theta, sphere, squares};
use crate::chart::{self, Panel};
use anyhow::{Context, Result, bail};
use fmc_contact::Resolution;
use indicatif::ProgressBar;
use std::path::PathBuf;

/// A run through the cases.
pub struct Verification {
    /// Ways of measuring.
    pub methods: Vec<Method>,
    /// How densely fibers are laid.
    pub resolution: Resolution,
    /// Of the fibers' random shift.
    pub seed: u64,
    /// Threads; nothing depends on them.
    pub threads: usize,
    /// Folder of the pictures, if there shall be some.
    pub pictures: Option<PathBuf>,
    /// Seeds over which errors are averaged where they are drawn over the number of fibers.
    pub seeds: u64,
    /// What was measured so far.
    pub rows: Vec<Row>,
    /// Told of every measurement.
    pub progress: ProgressBar,
}

/// Names of the cases, in the order of the paper.
pub const NAMES: [&str; 7] = ["disc", "half-disc", "squares", "sphere", "cone", "cube", "cubes"];

/// A case in the plane or in space.
pub(super) enum AnyCase {
    Plane(Case<2>),
    Space(Case<3>),
}

/// The case of a name.
pub(super) fn by_name(name: &str) -> Result<AnyCase> {
    Ok(match name {
        "disc" => AnyCase::Plane(disc::disc()),
        "half-disc" => AnyCase::Plane(half_disc::half_disc()),
        "squares" => AnyCase::Plane(squares::squares()),
        "sphere" => AnyCase::Space(sphere::sphere()),
        "cone" => AnyCase::Space(cone::cone()),
        "cube" => AnyCase::Space(cube::cube()),
        "cubes" => AnyCase::Space(cubes::cubes()),
        _ => bail!("there is no case '{name}'; there are {}", NAMES.join(", ")),
    })
}

impl Verification {
    /// Measures and draws them all, in the order of the paper.
    pub fn all_cases(&mut self) -> Result<()> {
        for name in NAMES {
            self.case(name)?;
        }
        self.progress.finish_and_clear();
        Ok(())
    }

    /// Measures and draws one.
    pub fn case(&mut self, name: &str) -> Result<()> {
        match by_name(name)? {
            AnyCase::Plane(case) => self.measure_and_draw(case),
            AnyCase::Space(case) => self.measure_and_draw(case),
        }
    }

    /// Over θ; where there is one θ alone, over the number of fibers.
    fn measure_and_draw<const D: usize>(&mut self, case: Case<D>) -> Result<()> {
        if case.thetas.len() == 1 { self.converge(case) } else { self.sweep(case) }
    }

    /// A case over θ, and its picture.
    fn sweep<const D: usize>(&mut self, case: Case<D>) -> Result<()> {
        self.measure(&case)?;
        let panels = over_theta::over_theta(&case, &self.methods, &self.rows);
        self.draw(case.name, case.title, &panels)
    }

    /// A case at one θ, and its error over the number of fibers.
    fn converge<const D: usize>(&mut self, case: Case<D>) -> Result<()> {
        self.measure(&case)?;
        let sampled: Vec<Method> = self.methods.iter().copied().filter(|&method| method != Method::Exact).collect();
        if self.pictures.is_none() || sampled.is_empty() {
            return Ok(());
        }
        self.progress.inc_length(convergence::EVALUATIONS * self.seeds * sampled.len() as u64);
        self.progress.set_message(format!("{}: convergence", case.name));
        let panels = convergence::convergence(&case, &sampled, self.seeds, self.threads, || self.progress.inc(1))
            .with_context(|| format!("case {}", case.name))?;
        self.draw(case.name, &format!("{} = 1", case.title), &panels)
    }

    /// Every form at every θ by every method that can do it.
    fn measure<const D: usize>(&mut self, case: &Case<D>) -> Result<()> {
        self.progress.inc_length((case.forms.len() * case.thetas.len()) as u64);
        self.progress.set_message(case.name);
        for form in &case.forms {
            for &theta in &case.thetas {
                let context = || format!("case {}, {} at θ = {theta}", case.name, form.name);
                let scene = (form.scene)(theta);
                let mut contact = scene.contact(self.threads).with_context(context)?;
                for &method in self.methods.iter().filter(|&&method| form.straight || method != Method::Exact) {
                    let setting = Setting { method, resolution: self.resolution, seed: self.seed };
                    let rows = row::rows(case, form, theta, &scene, &mut contact, setting);
                    self.rows.extend(rows.with_context(context)?);
                }
                self.progress.inc(1);
            }
        }
        Ok(())
    }

    fn draw(&self, name: &str, title: &str, panels: &[Panel]) -> Result<()> {
        match &self.pictures {
            Some(directory) => chart::draw(directory, name, title, panels),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::closed_form::ClosedForm;

    fn check_closed_forms<const D: usize>(case: Case<D>) {
        let forms = case.forms.iter().filter_map(|form| form.of_the_mesh).chain([case.closed_form]);
        for closed_form in forms {
            for &theta in &case.thetas {
                let step = 1e-5;
                let difference = (closed_form(theta + step).value - closed_form(theta - step).value) / (2.0 * step);
                let ClosedForm { derivative, flux, .. } = closed_form(theta);
                // Rounding of a value near 1 over the step; the third derivative adds less.
                assert!((derivative - difference).abs() < 1e-9 * (1.0 + flux), "{} at {theta}", case.name);
                assert!(flux >= derivative.abs() * (1.0 - 1e-12), "{} at {theta}", case.name);
            }
        }
    }

    #[test]
    fn derivatives_of_closed_forms_are_differences() {
        check_closed_forms(disc::disc());
        check_closed_forms(half_disc::half_disc());
        check_closed_forms(squares::squares());
        check_closed_forms(sphere::sphere());
        check_closed_forms(cone::cone());
        check_closed_forms(cube::cube());
        check_closed_forms(cubes::cubes());
    }

    #[test]
    fn lines_and_exact_keep_their_bounds() {
        let mut verification = Verification {
            methods: vec![Method::Lines, Method::Exact],
            resolution: Resolution::Count(27_000),
            seed: 7,
            threads: 1,
            pictures: None,
            seeds: 1,
            rows: Vec::new(),
            progress: ProgressBar::hidden(),
        };
        verification.all_cases().unwrap();
        assert_eq!(verification.rows.iter().filter(|row| !row.ok).count(), 0);
        // A tenth of the paper's 300 000.
        assert!(verification.rows.iter().all(|row| row.fibers <= 30_000));
    }
}
