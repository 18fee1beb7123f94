//! What a case looks like.

use super::case::Case;
use super::verification::{AnyCase, by_name};
use anyhow::{Context, Result};
use fmc_contact::{CellType, Estimator, FiberOptions, Resolution};

/// Fibers shown: enough to tell the overlap's shape, few enough to tell them apart.
const SHOWN: [usize; 2] = [30, 250];

/// The bodies of a case as meshes, and stretches of fibers inside both, in space; in the plane z is 0.
pub struct Sketch {
    /// 2 or 3.
    pub dimension: usize,
    /// Nodes.
    pub points: Vec<[f64; 3]>,
    /// Cells: type, nodes and number of the body.
    pub cells: Vec<(CellType, Vec<u32>, usize)>,
    /// Ends of the stretches.
    pub spans: Vec<[[f64; 3]; 2]>,
}

/// The sketch of a case in its meshed form, at a θ in the middle.
pub fn sketch(name: &str) -> Result<Sketch> {
    match by_name(name)? {
        AnyCase::Plane(case) => of(&case),
        AnyCase::Space(case) => of(&case),
    }
}

fn of<const D: usize>(case: &Case<D>) -> Result<Sketch> {
    let form = case.forms.first().with_context(|| format!("case {} has no form", case.name))?;
    let scene = (form.scene)(case.thetas[case.thetas.len() / 3]);
    let resolution = Resolution::Count(SHOWN[D - 2]);
    let estimator = Estimator::Fibers(FiberOptions { resolution, ..FiberOptions::default() });
    let in_space = |x: &[f64; D]| std::array::from_fn(|axis| x.get(axis).copied().unwrap_or(0.0));
    let spans = scene.spans(estimator)?;
    Ok(Sketch {
        dimension: D,
        points: scene.coords().iter().map(in_space).collect(),
        cells: scene.cells(),
        spans: spans.iter().map(|ends| [in_space(&ends[0]), in_space(&ends[1])]).collect(),
    })
}
