//! Cholesky factors with the equations that will change last.

use super::Lower;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltParams;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::perm::PermRef;
use faer::prelude::*;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::amd;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::{Accum, Conj, Mat, Par, Side, Spec};

/// Cholesky factors L Lᵀ of a symmetric positive definite matrix.
///
/// A few equations may be kept for the end: what elimination of all others leaves of the matrix on them, the Schur
/// complement, is then at hand, and a system whose matrix differs on them alone is solved without new factors. What depends
/// on the pattern alone is kept for the next matrix of the same pattern.
#[derive(Default)]
pub struct Factorisation {
    analysed: Option<Analysed>,
    values: Vec<f64>,
    kept: Vec<usize>,
    /// Schur complement on the kept equations, in their order.
    schur: Option<Mat<f64>>,
    /// Times that a pattern was new.
    pub analyses: usize,
    /// Matrices factorised.
    pub count: usize,
}

struct Analysed {
    pattern: Lower,
    symbolic: SymbolicCholesky<usize>,
}

impl Factorisation {
    /// Factorises a matrix, its equations `kept` (ascending) last. `false` if it is not positive definite.
    pub fn factorise(&mut self, matrix: &Lower, kept: &[usize]) -> bool {
        self.count += 1;
        let known = self.analysed.as_ref().is_some_and(|known| known.pattern.has_pattern_of(matrix));
        if !known || self.kept != kept {
            self.analyses += 1;
            self.kept = kept.to_vec();
            self.analysed = analyse(matrix, kept).map(|symbolic| Analysed { pattern: matrix.clone(), symbolic });
        }
        let Some(Analysed { symbolic, .. }) = &self.analysed else { return false };
        self.values.clear();
        self.values.resize(symbolic.len_val(), 0.0);
        let params = Spec::<LltParams, f64>::default();
        let mut memory = MemBuffer::new(symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, params));
        let stack = MemStack::new(&mut memory);
        let regularisation = Default::default();
        let done = symbolic
            .factorize_numeric_llt(
                &mut self.values,
                matrix.view(),
                Side::Lower,
                regularisation,
                Par::Seq,
                stack,
                params,
            )
            .is_ok();
        if !done {
            self.values.clear();
            return false;
        }
        self.schur = self.schur_complement();
        true
    }

    /// Solution of the system with the last matrix; `None` if it had no factors.
    pub fn solve(&self, right: &[f64]) -> Option<Vec<f64>> {
        let Analysed { symbolic, .. } = self.analysed.as_ref().filter(|_| !self.values.is_empty())?;
        let mut solution = Mat::from_fn(right.len(), 1, |row, _| right[row]);
        let mut memory = MemBuffer::new(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        let factors = LltRef::new(symbolic, &self.values);
        factors.solve_in_place_with_conj(Conj::No, solution.as_mut(), Par::Seq, MemStack::new(&mut memory));
        Some((0..right.len()).map(|row| solution[(row, 0)]).collect())
    }

    /// Solution of the system with the last matrix M changed on the kept equations, by entries (row, column, value) of
    /// the lower triangle numbered among these; `None` if it is not positive definite.
    ///
    /// With x̂ = M⁻¹ b, S the Schur complement and Δ the change: (S + Δ) x_kept = S x̂_kept, x = M⁻¹ (b − Δ x).
    pub fn solve_changed(&self, change: &[(usize, usize, f64)], right: &[f64]) -> Option<Vec<f64>> {
        let mirrored = change.iter().filter(|(row, column, _)| row != column).map(|(r, c, v)| (*c, *r, *v));
        let change: Vec<_> = change.iter().copied().chain(mirrored).collect();
        self.solve_with(&change, right, |changed, right| Some(changed.llt(Side::Lower).ok()?.solve(right)))
    }

    /// The same for a change that is not symmetric, by all its entries; `None` if the changed matrix is singular.
    pub fn solve_changed_unsymmetric(&self, change: &[(usize, usize, f64)], right: &[f64]) -> Option<Vec<f64>> {
        let found = self.solve_with(change, right, |changed, right| Some(changed.partial_piv_lu().solve(right)))?;
        found.iter().all(|x| x.is_finite()).then_some(found)
    }

    fn solve_with(
        &self,
        change: &[(usize, usize, f64)],
        right: &[f64],
        solve: impl Fn(&Mat<f64>, Mat<f64>) -> Option<Mat<f64>>,
    ) -> Option<Vec<f64>> {
        let first = self.solve(right)?;
        let schur = self.schur.as_ref()?;
        let mut changed = schur.clone();
        change.iter().for_each(|&(row, column, value)| changed[(row, column)] += value);
        let at_first = Mat::from_fn(self.kept.len(), 1, |k, _| first[self.kept[k]]);
        let kept = solve(&changed, schur * at_first)?;
        let mut right = right.to_vec();
        change.iter().for_each(|&(row, column, value)| right[self.kept[row]] -= value * kept[(column, 0)]);
        self.solve(&right)
    }

    /// S = L_kept L_keptᵀ, L_kept being the last columns of the factor.
    fn schur_complement(&self) -> Option<Mat<f64>> {
        let Analysed { symbolic, .. } = self.analysed.as_ref()?;
        let SymbolicCholeskyRaw::Supernodal(supernodal) = symbolic.raw() else { return None };
        let first = symbolic.nrows() - self.kept.len();
        let mut last = Mat::<f64>::zeros(self.kept.len(), self.kept.len());
        let factors = SupernodalLltRef::new(supernodal, &self.values);
        for number in 0..supernodal.n_supernodes() {
            let supernode = factors.supernode(number);
            let (block, start) = (supernode.val(), supernode.start());
            for column in first.saturating_sub(start)..block.ncols() {
                for row in column..block.nrows() {
                    let at = if row < block.ncols() { start + row } else { supernode.pattern()[row - block.ncols()] };
                    last[(at - first, start + column - first)] = block[(row, column)];
                }
            }
        }
        Some(times_its_transpose(&last))
    }
}

/// L Lᵀ: the lower triangle, a sixth of the work of any two matrices, and its mirror image.
fn times_its_transpose(lower: &Mat<f64>) -> Mat<f64> {
    let mut product = Mat::<f64>::zeros(lower.nrows(), lower.nrows());
    let [low, up] = [BlockStructure::TriangularLower, BlockStructure::TriangularUpper];
    let (left, right) = (lower.as_ref(), lower.transpose());
    triangular::matmul(product.as_mut(), low, Accum::Replace, left, low, right, up, 1.0, Par::Seq);
    for column in 0..lower.nrows() {
        for row in 0..column {
            product[(row, column)] = product[(column, row)];
        }
    }
    product
}

/// Order of elimination: minimum degree, but for what is kept.
fn analyse(matrix: &Lower, kept: &[usize]) -> Option<SymbolicCholesky<usize>> {
    let size = matrix.size();
    let mut number = vec![usize::MAX; size];
    let others: Vec<usize> = (0..size).filter(|equation| kept.binary_search(equation).is_err()).collect();
    others.iter().enumerate().for_each(|(k, &equation)| number[equation] = k);
    let inner = matrix.entries().map(|(row, column, value)| (number[row], number[column], value));
    let inner = Lower::new(others.len(), inner.filter(|(row, column, _)| *row < size && *column < size));
    let (mut order, mut inverse) = (vec![0; others.len()], vec![0; others.len()]);
    let mut memory = MemBuffer::new(amd::order_scratch::<usize>(others.len(), inner.entries().count()));
    let stack = MemStack::new(&mut memory);
    amd::order(&mut order, &mut inverse, inner.pattern(), amd::Control::default(), stack).ok()?;
    let order: Vec<usize> = order.into_iter().map(|k| others[k]).chain(kept.iter().copied()).collect();
    let mut inverse = vec![0; size];
    order.iter().enumerate().for_each(|(place, &equation)| inverse[equation] = place);
    let params = CholeskySymbolicParams {
        supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
        ..Default::default()
    };
    let order = SymmetricOrdering::Custom(PermRef::new_checked(&order, &inverse, size));
    factorize_symbolic_cholesky(matrix.pattern(), Side::Lower, order, params).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of springs, held at one end, with entries in pieces and out of order.
    fn chain(size: usize, stiffness: f64) -> Vec<(usize, usize, f64)> {
        let springs = (1..size).flat_map(|k| {
            [(k, k, stiffness), (k - 1, k, -stiffness), (k, k - 1, -stiffness), (k - 1, k - 1, stiffness)]
        });
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
        (0..4).for_each(|k| {
            assert!((system.schur.as_ref().unwrap()[(k / 2, k % 2)] - expected[k / 2][k % 2]).abs() < 1e-13)
        });
    }

    #[test]
    fn a_change_on_kept_equations_gives_the_solution_of_the_changed_matrix() {
        let change = [(2, 2, 3.0), (5, 2, -3.0), (5, 5, 3.0)];
        let mut system = Factorisation::default();
        assert!(system.factorise(&Lower::new(8, chain(8, 2.0).into_iter()), &[2, 5]));
        let right: Vec<f64> = (0..8).map(|k| (k as f64).sin()).collect();
        let local = change.map(|(row, column, value): (usize, usize, f64)| (row / 5, column / 5, value));
        let changed = system.solve_changed(&local, &right).unwrap();
        let whole = Lower::new(8, chain(8, 2.0).into_iter().chain(change));
        let left = whole.product(&changed);
        left.iter().zip(&right).for_each(|(l, r)| assert!((l - r).abs() < 1e-13, "{l} is not {r}"));
        assert!(system.solve_changed(&[(0, 0, -1e3)], &right).is_none());
        // Pushed at 2 by what moves at 5, and not the other way round.
        let pushed = system.solve_changed_unsymmetric(&[(0, 1, -0.5)], &right).unwrap();
        let mut left = Lower::new(8, chain(8, 2.0).into_iter()).product(&pushed);
        left[2] -= 0.5 * pushed[5];
        left.iter().zip(&right).for_each(|(l, r)| assert!((l - r).abs() < 1e-13, "{l} is not {r}"));
    }
}
