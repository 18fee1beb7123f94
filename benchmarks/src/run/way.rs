//! The way to an equilibrium: its stages, and what was passed.

use crate::case::Case;
use anyhow::Result;
use fmc_contact::{EnergyLaw, EnergyProfile, PenetrationLaw};
use fmc_solid::statics::{Equilibrium, Iteration, NewtonSettings, Path, StaticsError};
use std::fmt::Write;
use std::ops::ControlFlow;
use std::path::Path as Folder;

/// ε of the linear law at first, by the size of the bodies.
const FIRST_SMOOTHING: f64 = 1e-3;

/// One equilibrium on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadStep {
    /// Stage of the load steps, from 0.
    pub stage: usize,
    /// Part of the stage's load.
    pub load: f64,
    /// Linear systems solved so far.
    pub iterations: usize,
    /// Contact force on the body that the figures are about, with all copies.
    pub force: Vec<f64>,
    /// Area of contact (2D: length), with all copies.
    pub contact_area: f64,
    /// Largest penetration; where one is wanted, the largest mean of a node.
    pub penetration: f64,
    /// Energy that friction took out in this step, with all copies.
    pub dissipated: f64,
    /// Areas that stick and that slide, with all copies.
    pub stick: [f64; 2],
}

/// A case's last equilibrium, and those before.
pub(super) struct Way<const D: usize> {
    pub(super) equilibrium: Equilibrium<D>,
    pub(super) steps: Vec<LoadStep>,
    /// Why it ended early, if it did.
    pub(super) end: Result<(), StaticsError>,
}

impl<const D: usize> Way<D> {
    /// Goes it; `watch` is called after every iteration, `reached` after every equilibrium.
    ///
    /// # Errors
    /// If the case makes no problem.
    pub(super) fn go(
        folder: &Folder,
        case: &Case,
        threads: usize,
        watch: &mut dyn FnMut(&Iteration) -> ControlFlow<()>,
        reached: &mut dyn FnMut(&Equilibrium<D>),
    ) -> Result<Self> {
        let plan = case.load_steps.clone().unwrap_or_default();
        let mut equilibrium = Equilibrium::new(case.problem::<D>(folder, threads)?)?;
        let (tolerance, most_iterations) = (plan.tolerance, plan.most_iterations);
        let penetration = plan.penetration.unwrap_or(0.0);
        equilibrium.settings = NewtonSettings { tolerance, most_iterations, penetration, ..Default::default() };
        let mut steps = Vec::new();
        let body = case.figured();
        let mut end = Ok(());
        for (stage, count) in std::iter::once(plan.count).chain(plan.then.iter().copied()).enumerate() {
            if stage > 0 {
                let supports = case.constraints(equilibrium.model(), stage)?;
                equilibrium.next_stage(supports)?;
            }
            let path = Path { steps: count, ..Default::default() };
            let mut told = |at: &Equilibrium<D>| {
                let contact = &at.balance().contact;
                let copies = case.figures.copies as f64;
                steps.push(LoadStep {
                    stage,
                    load: at.load(),
                    iterations: at.iterations,
                    force: contact.bodies[body].force.iter().map(|f| copies * f).collect(),
                    contact_area: copies * contact.contact_area,
                    penetration: match plan.penetration {
                        Some(_) => at.nodal_penetration().unwrap_or(f64::NAN),
                        None => contact.penetration,
                    },
                    dissipated: copies * contact.friction.dissipated,
                    stick: [contact.friction.stick_area, contact.friction.slip_area].map(|area| copies * area),
                });
                reached(at);
            };
            end = lead(&mut equilibrium, path, watch, &mut told);
            if end.is_err() {
                break;
            }
        }
        Ok(Self { equilibrium, steps, end })
    }

    /// All equilibria, a line for each.
    pub(super) fn table(&self) -> String {
        let axes = ["force_x", "force_y", "force_z"];
        let mut text = format!(
            "stage,load,iterations,{},contact_area,penetration,dissipated,stick_area,slip_area\n",
            axes[..D].join(",")
        );
        for LoadStep { stage, load, iterations, force, contact_area, penetration, dissipated, stick } in &self.steps {
            write!(text, "{stage},{load:?},{iterations}").expect("writing into a string");
            force.iter().for_each(|f| write!(text, ",{f:?}").expect("writing into a string"));
            writeln!(text, ",{contact_area:?},{penetration:?},{dissipated:?},{:?},{:?}", stick[0], stick[1])
                .expect("writing into a string");
        }
        text
    }
}

/// One stage, by the means that the law calls for.
fn lead<const D: usize>(
    equilibrium: &mut Equilibrium<D>,
    path: Path,
    watch: &mut dyn FnMut(&Iteration) -> ControlFlow<()>,
    reached: &mut dyn FnMut(&Equilibrium<D>),
) -> Result<(), StaticsError> {
    match equilibrium.problem().contact.law {
        EnergyLaw::Fiber(PenetrationLaw { stiffness: k, profile: EnergyProfile::Linear { smoothing_length } }) => {
            let first = smoothing_length.max(FIRST_SMOOTHING * equilibrium.size());
            equilibrium.set_law(EnergyLaw::Fiber(PenetrationLaw {
                stiffness: k,
                profile: EnergyProfile::Linear { smoothing_length: first },
            }))?;
            equilibrium.follow_telling(path, watch, reached)?;
            equilibrium.continue_smoothing(smoothing_length, watch)
        }
        _ => equilibrium.follow_telling(path, watch, reached),
    }
}
