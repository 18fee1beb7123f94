//! Surfaces that are moved out, against the constrained problem: gaps as constraints, with pressures at nodes in place of a law.

use crate::equilibrium::{K, Scene, scene};
use crate::moved_out::{Series, balances, series};
use fmc_contact::EnergyLaw;
use fmc_contact::contact::GapConstraints;
use fmc_contact::overlap::Partner;
use nalgebra::{DMatrix, DVector};

/// Gaps of the membrane, and which of its rows are of nodes in a list.
fn gaps(scene: &Scene, at: &DVector<f64>, nodes: &[u32]) -> (GapConstraints<2>, Vec<usize>) {
    let gaps = scene.contact.gap_constraints(&scene.at(at), 0.1).unwrap();
    let is_listed = |row: &usize| gaps.partners[*row][0] == Partner::Body(0) && nodes.contains(&gaps.nodes[*row]);
    let listed = (0..gaps.gaps.len()).filter(is_listed).collect();
    (gaps, listed)
}

/// Where the bodies are when the gaps of some nodes are closed and pressures there hold them: Newton's method for both at once, also
/// the pressures.
fn closed_at(scene: &Scene, nodes: &[u32], mut at: DVector<f64>) -> (DVector<f64>, DVector<f64>) {
    let length = at.len();
    for _ in 0..100 {
        let (gaps, rows) = gaps(scene, &at, nodes);
        let mut matrix = DMatrix::zeros(length + rows.len(), length + rows.len());
        matrix.view_mut((0, 0), (length, length)).copy_from(scene.stiffness());
        let mut right = DVector::zeros(length + rows.len());
        right.rows_mut(0, length).copy_from(&-scene.pressed(&at));
        for (place, &row) in rows.iter().enumerate() {
            right[length + place] = -gaps.gaps[row];
            for entry in gaps.row_starts[row]..gaps.row_starts[row + 1] {
                for axis in 0..2 {
                    let column = 2 * gaps.columns[entry] as usize + axis;
                    // An obstacle has no unknowns.
                    if column < length {
                        matrix[(column, length + place)] -= gaps.slopes[entry][axis];
                        matrix[(length + place, column)] += gaps.slopes[entry][axis];
                    }
                }
            }
        }
        let found = matrix.lu().solve(&right).unwrap();
        let step = found.rows(0, length).clone_owned();
        at += &step;
        if step.amax() < 1e-13 {
            return (at, found.rows(length, rows.len()).clone_owned());
        }
    }
    panic!("the constrained problem does not converge");
}

/// The solution of the constrained problem: of the nodes, those stay closed that press, and those are added that would penetrate.
fn constrained(scene: &Scene, mut nodes: Vec<u32>, mut at: DVector<f64>) -> (DVector<f64>, DVector<f64>) {
    let all: Vec<u32> = (0..scene.length() as u32 / 2).collect();
    for _ in 0..20 {
        let (there, pressures) = closed_at(scene, &nodes, at);
        let (of_all, rows) = gaps(scene, &there, &all);
        let (of_closed, closed) = gaps(scene, &there, &nodes);
        let presses = |row: &usize| {
            closed.iter().zip(pressures.iter()).any(|(one, p)| of_closed.nodes[*one] == of_all.nodes[*row] && *p > 0.0)
        };
        let is_closed = |row: &usize| presses(row) || of_all.gaps[*row] < -1e-12;
        let next: Vec<u32> = rows.into_iter().filter(is_closed).map(|row| of_all.nodes[row]).collect();
        if next == nodes {
            return (there, pressures);
        }
        (nodes, at) = (next, there);
    }
    panic!("no set of nodes is that of the constrained problem");
}

/// A membrane over a fan of edges: nearly the solution of the constrained problem, by a law that is soft or hard. No gap is negative, and
/// what is pressed is closed. The law bears on the nodes in somewhat other parts than pressures at nodes do: the fan's tip presses
/// less than two facets.
#[test]
fn the_constraints_are_met_whatever_the_stiffness_of_the_law() {
    for k in [3.0 * K, 10.0 * K] {
        let mut scene = scene(EnergyLaw::depth(k), 0.0);
        let (start, by_law) = scene.newton(DVector::zeros(scene.length()));
        let Series { at, iterations, updates, count } = series(&mut scene, start, false);
        println!("k {k:e}: {updates} updates, {iterations} iterations, {by_law} by the law");
        assert!(count > 0 && updates <= 14, "{count} multipliers, {updates} updates");
        balances(&scene, &at);
        let pressed: Vec<u32> = scene.contact.multipliers().iter().map(|one| one.node).collect();
        let all: Vec<u32> = (0..scene.length() as u32 / 2).collect();
        let (found, mine) = gaps(&scene, &at, &all);
        for row in mine {
            let (mean, node) = (found.gaps[row] / found.areas[row], found.nodes[row]);
            assert!(mean >= -1e-9 && (!pressed.contains(&node) || mean <= 1e-9), "node {node}: {mean:e}");
        }
        let (wanted, pressures) = constrained(&scene, pressed, at.clone());
        assert!(pressures.len() > 1 && pressures.min() > 0.0, "{pressures:?}");
        let apart = (&at - &wanted).amax() / wanted.amax();
        println!("apart {apart:e}");
        assert!(apart < 0.02, "{k:e}: {apart:e}");
    }
}
