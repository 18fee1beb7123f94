//! Sums of element vectors at the nodes, the same bits for any number of threads.
//!
//! Every node adds the vectors of its elements in ascending order of the cells. One thread does so cell by cell; several
//! first write all element vectors, each its own, and then gather at the nodes.

use super::elements::Elements;
use rayon::ThreadPool;
use rayon::prelude::*;

/// Cells whose energies are summed by themselves; results depend on it in their last bits, threads do not.
const BLOCK: usize = 1024;

/// Adds `element(cell, vector)` of all cells to the nodes and returns the sum of the energies that it returns.
///
/// `element` writes the vector of one cell, `[node_count, D]`, which starts at zero.
pub(super) fn assemble<const D: usize, const N: usize>(
    elements: &Elements<D>,
    pool: Option<&ThreadPool>,
    nodes: &mut [[f64; D]],
    element: impl Fn(usize, &mut [[f64; D]; N]) -> f64 + Sync,
) -> f64 {
    let (conn, _) = elements.conn.as_chunks::<N>();
    let Some(pool) = pool else {
        let block_energy = |(block, cells): (usize, &[[u32; N]])| -> f64 {
            let mut energy = 0.0;
            for (k, cell_nodes) in cells.iter().enumerate() {
                let mut vector = [[0.0; D]; N];
                energy += element(block * BLOCK + k, &mut vector);
                for (&node, v) in cell_nodes.iter().zip(&vector) {
                    let sum = &mut nodes[node as usize];
                    (0..D).for_each(|axis| sum[axis] += v[axis]);
                }
            }
            energy
        };
        return conn.chunks(BLOCK).enumerate().map(block_energy).sum();
    };
    let mut vectors = vec![[[0.0; D]; N]; conn.len()];
    let fill = |(block, vectors): (usize, &mut [[[f64; D]; N]])| -> f64 {
        let mut energy = 0.0;
        vectors.iter_mut().enumerate().for_each(|(k, vector)| energy += element(block * BLOCK + k, vector));
        energy
    };
    let energies: Vec<f64> = pool.install(|| vectors.par_chunks_mut(BLOCK).enumerate().map(fill).collect());
    let vectors = vectors.as_flattened();
    let gather = |(sum, slots): (&mut [f64; D], &[u32])| {
        for &slot in slots {
            (0..D).for_each(|axis| sum[axis] += vectors[slot as usize][axis]);
        }
    };
    let own_nodes = &mut nodes[elements.first_node..][..elements.node_count()];
    pool.install(|| {
        own_nodes
            .par_iter_mut()
            .with_min_len(BLOCK)
            .enumerate()
            .for_each(|(k, sum)| gather((sum, elements.slots_of(k))))
    });
    energies.iter().sum()
}
