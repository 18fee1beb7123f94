//! Sizes of bodies, compared: lengths in different units are the commonest mistake that no single mesh shows.

use super::assembly::Assembly;
use super::division::Division;

/// Bodies whose sizes differ by more are told: what is in millimetres beside what is in metres.
const MOST: f64 = 100.0;

/// A sentence where the largest body is more than [`MOST`] times as large as the smallest one.
pub(super) fn unlike<const D: usize>(assembly: &Assembly<D>, division: &Division) -> Option<String> {
    let mut boxes = vec![[[f64::INFINITY; D], [f64::NEG_INFINITY; D]]; division.names.len()];
    for ((_, nodes), &body) in assembly.cells().zip(&division.cell_bodies) {
        let [low, high] = &mut boxes[body as usize];
        for &node in nodes {
            for (axis, x) in assembly.coords[node as usize].into_iter().enumerate() {
                (low[axis], high[axis]) = (low[axis].min(x), high[axis].max(x));
            }
        }
    }
    let size = |[low, high]: &[[f64; D]; 2]| (0..D).map(|axis| (high[axis] - low[axis]).powi(2)).sum::<f64>().sqrt();
    let sizes: Vec<f64> = boxes.iter().map(size).collect();
    let by_size = |a: &usize, b: &usize| sizes[*a].total_cmp(&sizes[*b]);
    let (small, large) = ((0..sizes.len()).min_by(by_size)?, (0..sizes.len()).max_by(by_size)?);
    (sizes[large] > MOST * sizes[small]).then(|| {
        format!(
            "{} is {:.3e} across and {} is {:.3e}, {:.0} times as much: check that both have the same unit of length",
            division.names[small],
            sizes[small],
            division.names[large],
            sizes[large],
            sizes[large] / sizes[small]
        )
    })
}
