//! Order of elimination.

use super::Lower;
use super::dissection::dissect;
use super::graph::Graph;

/// Equations in the order of elimination, those kept last, in their order. Without places, what lies beside what is found out by
/// the matrix alone.
pub(super) fn order(matrix: &Lower, kept: &[usize], places: &[[f64; 3]]) -> Vec<usize> {
    let mut is_kept = vec![false; matrix.size()];
    kept.iter().for_each(|&equation| is_kept[equation] = true);
    let others: Vec<usize> = (0..matrix.size()).filter(|equation| !is_kept[*equation]).collect();
    let graph = Graph::new(matrix, &others, places);
    let places: Vec<[f64; 3]> = (0..graph.count())
        .map(|group| places.get(others[graph.equations(group as u32).start]).copied().unwrap_or_default())
        .collect();
    let order = dissect(&graph, &places).into_iter().flat_map(|group| graph.equations(group));
    order.map(|k| others[k]).chain(kept.iter().copied()).collect()
}
