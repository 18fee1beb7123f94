use super::*;
use crate::sparse::Entries;

/// A chain of springs, held at one end, with entries in pieces and out of order.
fn chain(size: usize, stiffness: f64) -> Vec<(usize, usize, f64)> {
    let springs = (1..size)
        .flat_map(|k| [(k, k, stiffness), (k - 1, k, -stiffness), (k, k - 1, -stiffness), (k - 1, k - 1, stiffness)]);
    springs.chain([(0, 0, stiffness)]).collect()
}

#[test]
fn a_chain_of_springs_is_as_long_as_its_springs() {
    let mut system = Factorisation::default();
    assert!(system.factorise(&Lower::new(5, chain(5, 2.0).into_iter().rev()), &[]));
    // A force of 1 at the end stretches each spring by ½.
    let u = system.solve(&[0.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
    u.iter().enumerate().for_each(|(k, u)| assert!((u - 0.5 * (k + 1) as f64).abs() < 1e-14));
    assert!(system.factorise(&Lower::new(5, chain(5, 1.0).into_iter()), &[]));
    assert_eq!((system.analyses, system.count), (1, 2));
    // Not held: no factors, or none that are of any use.
    let loose = chain(5, 1.0).into_iter().take(16);
    let found = system.factorise(&Lower::new(5, loose), &[]).then(|| system.solve(&[1.0; 5]).unwrap()[0].abs());
    assert!(found.is_none_or(|u| u > 1e10));
}

#[test]
fn what_elimination_leaves_of_a_chain_is_springs_in_series() {
    let mut system = Factorisation::default();
    assert!(system.factorise(&Lower::new(6, chain(6, 12.0).into_iter()), &[2, 5]));
    // Three springs of 12 in a row are one of 4: from the wall to equation 2, and from there to 5.
    let expected = [[8.0, -4.0], [-4.0, 4.0]];
    for (unit, expected) in [[1.0, 0.0], [0.0, 1.0]].iter().zip(expected) {
        let found = system.schur().times(unit);
        found.iter().zip(expected).for_each(|(f, e)| assert!((f - e).abs() < 1e-13, "{f} is not {e}"));
    }
}

/// The system with a change on what is kept, solved on that alone.
fn solved(
    system: &mut Factorisation,
    right: &[f64],
    solve: impl FnOnce(&mut Schur, &[f64]) -> Option<Vec<f64>>,
) -> Option<Vec<f64>> {
    let condensed = system.condense(right)?;
    let kept = solve(system.schur(), &condensed.kept)?;
    system.follow(condensed.inner.iter().copied(), &kept)
}

#[test]
fn a_change_on_kept_equations_gives_the_solution_of_the_changed_matrix() {
    let right: Vec<f64> = (0..8).map(|k| (k as f64).sin()).collect();
    let is_right =
        |left: &[f64]| left.iter().zip(&right).for_each(|(l, r)| assert!((l - r).abs() < 1e-13, "{l} is not {r}"));
    // In either order: what changes is eliminated first or last, or both are.
    for kept in [[2, 5], [5, 2]] {
        let at = |equation: usize| usize::from(equation == kept[1]);
        let mut system = Factorisation::default();
        assert!(system.factorise(&Lower::new(8, chain(8, 2.0).into_iter()), &kept));
        for change in [vec![(2, 2, 3.0), (5, 2, -3.0), (5, 5, 3.0)], vec![(5, 5, 7.0)], vec![(2, 2, 1.0)], vec![]] {
            let local: Entries = change.iter().map(|(row, column, value)| (at(*row), at(*column), *value)).collect();
            let changed = solved(&mut system, &right, |schur, right| schur.solve_changed(&local, right)).unwrap();
            is_right(&Lower::new(8, chain(8, 2.0).into_iter().chain(change)).product(&changed));
        }
        assert!(system.schur().solve_changed(&vec![(at(2), at(2), -1e3)], &[1.0, 1.0]).is_none());
        // Pushed at 2 by what moves at 5, and not the other way round.
        let push = vec![(at(2), at(5), -0.5)];
        let pushed = solved(&mut system, &right, |schur, right| schur.solve_changed_unsymmetric(&push, right)).unwrap();
        let mut left = Lower::new(8, chain(8, 2.0).into_iter()).product(&pushed);
        left[2] -= 0.5 * pushed[5];
        is_right(&left);
    }
}

/// A block of springs from every place of a grid to the next along every axis, held softly.
fn block(side: usize) -> (Lower, Vec<[f64; 3]>) {
    let size = side.pow(3);
    let place = |k: usize| [k % side, k / side % side, k / side / side];
    let mut entries: Entries = (0..size).map(|k| (k, k, 0.1)).collect();
    for k in 0..size {
        for (axis, step) in [1, side, side * side].into_iter().enumerate() {
            if place(k)[axis] + 1 < side {
                entries.extend([(k, k, 1.0), (k + step, k + step, 1.0), (k + step, k, -1.0)]);
            }
        }
    }
    (Lower::new(size, entries.into_iter()), (0..size).map(|k| place(k).map(|x| x as f64)).collect())
}

#[test]
fn a_block_that_is_cut_in_two_again_and_again_is_solved() {
    let (matrix, places) = block(12);
    // A face of it, from its end to its beginning.
    let kept: Vec<usize> = (0..144).rev().collect();
    let right: Vec<f64> = (0..matrix.size()).map(|k| (k as f64).sin()).collect();
    for places in [places, Vec::new()] {
        let mut system = Factorisation::new(places);
        assert!(system.factorise(&matrix, &kept));
        let order = &system.analysed.as_ref().unwrap().order;
        assert_eq!(order[order.len() - 144..], kept);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..matrix.size()));
        let found = system.solve(&right).unwrap();
        let parts = solved(&mut system, &right, |schur, right| schur.solve_changed(&Vec::new(), right)).unwrap();
        // Near a face of the block that is what follows it.
        let (condensed, mut near) = (system.condense(&right).unwrap(), vec![f64::NAN; matrix.size()]);
        let at: Vec<f64> = kept.iter().map(|equation| found[*equation]).collect();
        system.follow_near(condensed.inner.iter().copied(), &at, &mut near).unwrap();
        for k in 0..matrix.size() {
            assert!(
                (near[k] - found[k]).abs() < 1e-12 || near[k].is_nan() && k >= 3 * 144,
                "{k}: {} is not {}",
                near[k],
                found[k]
            );
        }
        for x in [found, parts] {
            matrix.product(&x).iter().zip(&right).for_each(|(l, r)| assert!((l - r).abs() < 1e-12, "{l} is not {r}"));
        }
        // Two for the solution, one to condense, one to follow, and one to condense again.
        assert_eq!(system.passes.get(), 5);
        // Springs between two of the kept: from fewer and fewer on, so that what was made for more serves, or does not.
        for from in [20, 0, 10, 100, 102, 143] {
            let change = vec![(143, 143, 2.0), (143, from, -0.5), (from, from, 2.0)];
            let x = solved(&mut system, &right, |schur, right| schur.solve_changed(&change, right)).unwrap();
            let whole = change.iter().map(|(row, column, value)| (kept[*row], kept[*column], *value));
            let whole = whole.map(|(row, column, value)| (row.max(column), row.min(column), value));
            let whole = Lower::new(matrix.size(), matrix.entries().chain(whole));
            whole.product(&x).iter().zip(&right).for_each(|(l, r)| assert!((l - r).abs() < 1e-12, "{l} is not {r}"));
            assert!(
                system.schur().changed >= 144 - from
                    && system.schur().changed <= 1 + (1.3 * (144.0 - from as f64)) as usize
            );
        }
    }
}
