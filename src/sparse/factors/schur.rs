//! What elimination leaves of a matrix on the equations that were kept.

use super::Entries;
use super::triangle::{backward, column, forward, times};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::solvers::Solve;
use faer::{Accum, Mat, Par};

/// Part by which a product is made larger than it needs to be, so that it serves when a few more equations change.
const SPARE: f64 = 0.05;

/// Part of the equations in a product below which a smaller one pays.
const TOO_MANY: f64 = 0.8;

/// Schur complement S = L Lᵀ by its factor, in the order in which its equations were kept.
///
/// Where a change of S begins at some equation, the factor of those before stays. So equations that are likely to change come
/// last, and a system with a change costs what those cost from the first that changes.
pub struct Schur {
    factor: Mat<f64>,
    /// S of the last equations without those before: the product of the last block of L; its lower triangle counts.
    product: Mat<f64>,
    work: Mat<f64>,
    memory: Option<MemBuffer>,
    /// Equations by which a system was solved, of the last one.
    pub changed: usize,
}

impl Default for Schur {
    fn default() -> Self {
        Self { factor: Mat::new(), product: Mat::new(), work: Mat::new(), memory: None, changed: 0 }
    }
}

impl Schur {
    /// Of a dense symmetric matrix, by its lower triangle; `None` if it is not positive definite.
    pub fn of(size: usize, entry: impl Fn(usize, usize) -> f64) -> Option<Self> {
        let mut factor = Mat::from_fn(size, size, |row, column| if row >= column { entry(row, column) } else { 0.0 });
        let needed = llt::factor::cholesky_in_place_scratch::<f64>(size, Par::Seq, Default::default());
        let (mut memory, no) = (MemBuffer::new(needed), Default::default());
        let stack = MemStack::new(&mut memory);
        llt::factor::cholesky_in_place(factor.as_mut(), no, Par::Seq, stack, Default::default()).ok()?;
        Some(Self { factor, ..Self::default() })
    }

    /// Number of equations.
    pub fn size(&self) -> usize {
        self.factor.nrows()
    }

    /// The factor of a new matrix, to be filled; zero for now.
    pub(super) fn renewed(&mut self, size: usize) -> &mut Mat<f64> {
        renew(&mut self.factor, size);
        self.factor.fill(0.0);
        self.product = Mat::new();
        &mut self.factor
    }

    /// S, row by row.
    pub fn matrix(&self) -> Vec<f64> {
        let size = self.size();
        let (mut whole, factor) = (Mat::<f64>::zeros(size, size), self.factor.as_ref());
        let [low, up] = [BlockStructure::TriangularLower, BlockStructure::TriangularUpper];
        triangular::matmul(whole.as_mut(), low, Accum::Replace, factor, low, factor.transpose(), up, 1.0, Par::Seq);
        (0..size * size).map(|k| whole[((k / size).max(k % size), (k / size).min(k % size))]).collect()
    }

    /// S x.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        times(self.factor.as_ref(), x)
    }

    /// Solution of the system with S changed by entries (row, column, value), each of a pair that mirror each other once;
    /// `None` if it is not positive definite.
    pub fn solve_changed(&mut self, change: &Entries, right: &[f64]) -> Option<Vec<f64>> {
        self.solve_with(change, right, |schur, x| {
            renew(&mut schur.work, x.len());
            for j in 0..x.len() {
                schur.work.col_as_slice_mut(j)[j..].copy_from_slice(&column(schur.product.as_ref(), j)[j..]);
            }
            let first = schur.size() - x.len();
            for &(row, column, value) in change {
                schur.work[(row.max(column) - first, row.min(column) - first)] += value;
            }
            let needed = llt::factor::cholesky_in_place_scratch::<f64>(x.len(), Par::Seq, Default::default());
            if schur.memory.as_ref().is_none_or(|memory| memory.len() < needed.unaligned_bytes_required()) {
                schur.memory = Some(MemBuffer::new(needed));
            }
            let stack = MemStack::new(schur.memory.as_mut()?);
            let (work, no) = (schur.work.as_mut(), Default::default());
            llt::factor::cholesky_in_place(work, no, Par::Seq, stack, Default::default()).ok()?;
            forward(schur.work.as_ref(), x.len(), x);
            backward(schur.work.as_ref(), x.len(), x);
            Some(())
        })
    }

    /// The same for a change that is not symmetric, by all its entries; `None` if the changed matrix is singular.
    pub fn solve_changed_unsymmetric(&mut self, change: &Entries, right: &[f64]) -> Option<Vec<f64>> {
        let found = self.solve_with(change, right, |schur, x| {
            let first = schur.size() - x.len();
            let at = |row: usize, column: usize| schur.product[(row.max(column), row.min(column))];
            let mut whole = Mat::from_fn(x.len(), x.len(), at);
            change.iter().for_each(|&(row, column, value)| whole[(row - first, column - first)] += value);
            let solved = whole.partial_piv_lu().solve(Mat::from_fn(x.len(), 1, |row, _| x[row]));
            x.iter_mut().enumerate().for_each(|(row, x)| *x = solved[(row, 0)]);
            Some(())
        })?;
        found.iter().all(|x| x.is_finite()).then_some(found)
    }

    /// Eliminates what does not change, solves for the others by `solve`, and follows them.
    fn solve_with(
        &mut self,
        change: &Entries,
        right: &[f64],
        solve: impl FnOnce(&mut Self, &mut [f64]) -> Option<()>,
    ) -> Option<Vec<f64>> {
        let first = change.iter().map(|(row, column, _)| *row.min(column)).min();
        self.changed = first.map_or(0, |first| self.multiply_last(self.size() - first));
        let (mut x, first) = (right.to_vec(), self.size() - self.changed);
        forward(self.factor.as_ref(), first, &mut x);
        if self.changed > 0 {
            solve(self, &mut x[first..])?;
        }
        backward(self.factor.as_ref(), first, &mut x);
        Some(x)
    }

    /// Makes the product of the last block of L, of this size at least, if it is not there; its size.
    fn multiply_last(&mut self, size: usize) -> usize {
        let has = self.product.nrows();
        if size <= has && size as f64 >= TOO_MANY * has as f64 {
            return has;
        }
        let size = self.size().min((size as f64 * (1.0 + SPARE)) as usize);
        let first = self.size() - size;
        renew(&mut self.product, size);
        let last = self.factor.as_ref().get(first.., first..);
        let [low, up] = [BlockStructure::TriangularLower, BlockStructure::TriangularUpper];
        triangular::matmul(self.product.as_mut(), low, Accum::Replace, last, low, last.transpose(), up, 1.0, Par::Seq);
        size
    }
}

/// A square of this size, in the memory that there is if it is enough; what it holds does not matter.
fn renew(matrix: &mut Mat<f64>, size: usize) {
    matrix.truncate(size.min(matrix.nrows()), size.min(matrix.ncols()));
    matrix.resize_with(size, size, |_, _| 0.0);
}
