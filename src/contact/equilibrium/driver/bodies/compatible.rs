//! Rigid motions that unknowns make of which coordinates follow several.
//!
//! A body that turns about a point far away turns about its centre and is moved, both at once: neither alone need be possible.

use crate::contact::equilibrium::driver::asking::unknowns::{Unknowns, combined};
use nalgebra::{DMatrix, SymmetricEigen};

/// Part of the squares of what motions miss that is rounding.
const ROUNDED: f64 = 1e-12;

/// Combinations of the motions of a body, each of all rows of coordinates, that its free unknowns make at some rows; as unknowns. A motion that they make by itself
/// stays what it is.
pub(crate) fn compatible<const D: usize>(
    unknowns: &Unknowns<D>,
    rows: &[usize],
    motions: &[Vec<[f64; D]>],
) -> Vec<Vec<f64>> {
    let field = |motion: &Vec<[f64; D]>| {
        let mut field = vec![0.0; unknowns.count];
        for place in rows.iter().flat_map(|&row| row * D..(row + 1) * D) {
            if let Some(unknown) = unknowns.of_coordinate[place].filter(|&unknown| unknowns.free[unknown]) {
                field[unknown] = motion[place / D][place % D];
            }
        }
        field
    };
    let fields: Vec<Vec<f64>> = motions.iter().map(field).collect();
    // Coordinates of their own that are held are the bodies' matter: it resists what they do not make.
    let is_bound = |place: &usize| {
        let is_free = unknowns.of_coordinate[*place].is_some_and(|unknown| unknowns.free[unknown]);
        is_free || unknowns.weighted.contains_key(place)
    };
    let bound: Vec<usize> = rows.iter().flat_map(|&row| row * D..(row + 1) * D).filter(is_bound).collect();
    let missed = |(field, motion): (&Vec<f64>, &Vec<[f64; D]>)| -> Vec<f64> {
        let made = |place: usize| unknowns.of(place).map(|(unknown, weight)| weight * field[unknown]).sum::<f64>();
        bound.iter().map(|&place| made(place) - motion[place / D][place % D]).collect()
    };
    let missed: Vec<Vec<f64>> = fields.iter().zip(motions).map(missed).collect();
    let product = |a: usize, b: usize| missed[a].iter().zip(&missed[b]).map(|(a, b)| a * b).sum::<f64>();
    let enough = ROUNDED * bound.len() as f64;
    let (own, rest): (Vec<usize>, Vec<usize>) = (0..fields.len()).partition(|&k| product(k, k) <= enough);
    let mut found: Vec<Vec<f64>> = own.iter().map(|&k| fields[k].clone()).collect();
    if rest.is_empty() {
        return found;
    }
    let parts = SymmetricEigen::new(DMatrix::from_fn(rest.len(), rest.len(), |a, b| product(rest[a], rest[b])));
    let rest: Vec<Vec<f64>> = rest.iter().map(|&k| fields[k].clone()).collect();
    for k in (0..rest.len()).filter(|&k| parts.eigenvalues[k] <= enough) {
        found.push(combined(&rest, &parts.eigenvectors.column(k).into_owned()));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    /// A rigid bar of three nodes on a hinge at (−2, 0): it turns about the hinge, and neither about its centre nor along anything.
    #[test]
    fn a_bar_turns_about_its_hinge() {
        let x = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.5]];
        // u = φ (−y, x + 2): the second coordinate of the first node leads.
        let arm = |k: usize| [-x[k][1], x[k][0] + 2.0];
        let followers = [(0, 0), (1, 0), (1, 1), (2, 0), (2, 1)];
        let weighted: BTreeMap<usize, Vec<(usize, f64)>> =
            followers.iter().map(|&(k, axis)| (2 * k + axis, vec![(1, arm(k)[axis] / 2.0)])).collect();
        let free = (0..6).map(|unknown| unknown == 1).collect();
        let unknowns =
            Unknowns::<2> { count: 6, of_coordinate: (0..6).map(Some).collect(), weighted, base: x.to_vec(), free };
        let centre = [1.0, 0.5 / 3.0];
        let motions: [Vec<[f64; 2]>; 3] = [
            vec![[1.0, 0.0]; 3],
            vec![[0.0, 1.0]; 3],
            x.iter().map(|x| [centre[1] - x[1], x[0] - centre[0]]).collect(),
        ];
        let found = compatible(&unknowns, &[0, 1, 2], &motions);
        assert_eq!(found.len(), 1);
        let made = unknowns.spread(&found[0]);
        for k in 0..3 {
            // To rounding.
            (0..2)
                .for_each(|axis| assert!((made[k][axis] - 0.5 * made[0][1] * arm(k)[axis]).abs() < 1e-14, "{made:?}"));
        }
        assert!(made[0][1].abs() > 0.1);
    }
}
