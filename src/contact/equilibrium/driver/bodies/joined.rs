//! The bodies' matrix without the springs by which a host joins nodes that are one.
//!
//! Such springs are as stiff as a host likes, and tell nothing of the bodies: what moves with all nodes of one place stretches none of them.

use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::evaluation::Contact;

/// Products with the matrix from which the diagonal is known well enough to tell sizes apart.
const PRODUCTS: u64 = 4;

/// Nodes that are one and move by themselves; none where a basis moves them.
pub(crate) fn joined<const D: usize>(contact: &Contact<D>) -> Vec<Vec<u32>> {
    let division = contact.surface().division().filter(|division| !division.has_basis());
    division.map_or_else(Vec::new, |division| division.welds().to_vec())
}

/// The diagonal of the bodies' matrix, but for nodes that are one, which have an equal part each of that of their place: nearly, by
/// products with vectors that have a sign for each place, of which the other places' parts cancel in the mean.
pub(crate) async fn own_diagonal<const D: usize>(host: &Host<D>, diagonal: &[f64]) -> Result<Vec<f64>, Trouble> {
    let welds = host.contact(|contact| joined(contact)).await;
    let mut own = diagonal.to_vec();
    if welds.is_empty() {
        return Ok(own);
    }
    let unknowns_of = |nodes: &[u32], axis: usize| -> Vec<usize> {
        nodes.iter().filter_map(|&node| host.unknowns.of_coordinate[node as usize * D + axis]).collect()
    };
    let places: Vec<Vec<usize>> =
        welds.iter().flat_map(|nodes| (0..D).map(|axis| unknowns_of(nodes, axis)).collect::<Vec<_>>()).collect();
    let mut sums = vec![0.0; places.len()];
    for round in 0..PRODUCTS {
        let mut vector = vec![0.0; own.len()];
        for (place, unknowns) in (0..).zip(&places) {
            unknowns.iter().for_each(|&unknown| vector[unknown] = sign(place, round));
        }
        let product = host.product(vector.clone(), false).await?;
        for (sum, unknowns) in sums.iter_mut().zip(&places) {
            *sum += unknowns.iter().map(|&unknown| vector[unknown] * product[unknown]).sum::<f64>().abs();
        }
    }
    for (sum, unknowns) in sums.iter().zip(&places) {
        let part = sum / (PRODUCTS as f64 * unknowns.len().max(1) as f64);
        unknowns.iter().for_each(|&unknown| own[unknown] = part.min(diagonal[unknown].abs()));
    }
    Ok(own)
}

/// One of both signs, the same in every run.
fn sign(place: u64, round: u64) -> f64 {
    // The mixer of SplitMix64.
    let mut bits = (place * PRODUCTS + round + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    if (bits ^ (bits >> 31)) & 1 == 0 { 1.0 } else { -1.0 }
}
