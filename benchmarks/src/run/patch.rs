//! Figures of blocks under uniform pressure.

use super::Figure;
use crate::case::Case;
use anyhow::{Context, Result};
use fmc_solid::statics::Equilibrium;

/// Largest |σ_nn + p|/p at the Gauss points of all cells, n along the last axis and p the pressure of the first load, and the penetration.
pub(super) fn figures<const D: usize>(case: &Case, at: &Equilibrium<D>, penetration: f64) -> Result<Vec<Figure>> {
    let pressure = case.loads.iter().find_map(|load| load.pressure).context("no load is a pressure")?;
    let stresses = at.model().point_stresses(at.displacement());
    let error = stresses.iter().map(|stress| (stress.0[D - 1] + pressure).abs() / pressure).fold(0.0, f64::max);
    Ok(vec![
        Figure { name: "stress_error_max", value: Some(error), unit: "" },
        Figure { name: "penetration_max", value: Some(penetration), unit: "m" },
        Figure { name: "nodes", value: Some(at.model().node_count() as f64), unit: "" },
    ])
}
