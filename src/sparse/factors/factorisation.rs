//! Cholesky factors with the equations that will change last.

use super::Lower;
use super::condensed::{Condensed, eliminate, follow};
use super::near::supernodes_near;
use super::order::order;
use super::schur::Schur;
use super::triangle::column;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::linalg::cholesky::llt::factor::LltParams;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::{Par, Side, Spec};
use std::cell::Cell;

/// Cholesky factors L Lᵀ of a symmetric positive definite matrix.
///
/// A few equations may be kept for the end: what elimination of all others leaves of the matrix on them, the Schur
/// complement, is then at hand, and a system whose matrix differs on them alone is solved on them alone. What depends
/// on the pattern alone is kept for the next matrix of the same pattern, and so is the memory.
#[derive(Default)]
pub struct Factorisation {
    places: Vec<[f64; 3]>,
    analysed: Option<Analysed>,
    values: Vec<f64>,
    is_factorised: bool,
    /// Place in the order of elimination at which the last factorisation ended, if it failed.
    failed_at: usize,
    memory: Option<MemBuffer>,
    kept: Vec<usize>,
    schur: Schur,
    /// Times that a pattern was new.
    pub analyses: usize,
    /// Matrices factorised.
    pub count: usize,
    /// Forward and backward substitutions through all of the factors: two are a solution.
    pub passes: Cell<usize>,
}

struct Analysed {
    pattern: Lower,
    symbolic: SymbolicCholesky<usize>,
    /// Equations in the order of elimination.
    order: Vec<usize>,
    /// Supernodes by which the equations near those that are kept follow them.
    near: Vec<bool>,
}

impl Factorisation {
    /// Of matrices whose equations are at these places: by them the order of elimination is found.
    pub fn new(places: Vec<[f64; 3]>) -> Self {
        Self { places, ..Self::default() }
    }

    /// Factorises a matrix, its equations `kept` last, in their order. `false` if it is not positive definite.
    pub fn factorise(&mut self, matrix: &Lower, kept: &[usize]) -> bool {
        (self.count, self.is_factorised) = (self.count + 1, false);
        let known = self.analysed.as_ref().is_some_and(|known| known.pattern.has_pattern_of(matrix));
        if !known || self.kept != kept {
            self.analyses += 1;
            self.kept = kept.to_vec();
            self.analysed = analyse(matrix, kept, &self.places);
        }
        let Some(Analysed { symbolic, .. }) = &self.analysed else { return false };
        self.values.resize(symbolic.len_val(), 0.0);
        let params = Spec::<LltParams, f64>::default();
        let needed = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, params);
        if self.memory.as_ref().is_none_or(|memory| memory.len() < needed.unaligned_bytes_required()) {
            self.memory = Some(MemBuffer::new(needed));
        }
        let Some(memory) = &mut self.memory else { return false };
        let (values, stack, no) = (&mut self.values, MemStack::new(memory), Default::default());
        let ended = symbolic.factorize_numeric_llt(values, matrix.view(), Side::Lower, no, Par::Seq, stack, params);
        self.is_factorised = ended.is_ok();
        self.failed_at = ended.err().map_or(0, |LltError::NonPositivePivot { index }| index);
        if self.is_factorised {
            self.load_schur();
        }
        self.is_factorised
    }

    /// Whether the last matrix has factors.
    pub fn is_factorised(&self) -> bool {
        self.is_factorised
    }

    /// Equation at which the last factorisation failed: what those before it leave there is not positive.
    pub fn failed_at(&self) -> Option<usize> {
        let order = &self.analysed.as_ref().filter(|_| !self.is_factorised)?.order;
        order.get(self.failed_at.min(order.len().saturating_sub(1))).copied()
    }

    /// Every equation with what those before it left there, in the order of elimination.
    pub(super) fn pivots(&self) -> impl Iterator<Item = (usize, f64)> {
        let order = self.analysed.as_ref().map_or(&[][..], |analysed| &analysed.order);
        let factors = self.factors();
        let supernodes = factors.map_or(0, |factors| factors.symbolic().n_supernodes());
        (0..supernodes).flat_map(move |number| {
            let supernode = factors.map(|factors| factors.supernode(number));
            let (start, columns) = supernode.map_or((0, 0), |node| (node.start(), node.val().ncols()));
            (0..columns).filter_map(move |k| Some((order[start + k], supernode?.val()[(k, k)].powi(2))))
        })
    }

    /// Solution of the system with the last matrix; `None` if it had no factors.
    pub fn solve(&self, right: &[f64]) -> Option<Vec<f64>> {
        let (mut y, order) = self.eliminated(right, right.len())?;
        follow(&self.factors()?, right.len(), &mut y, |_| true);
        self.passes.set(self.passes.get() + 1);
        Some(in_place_of(order, &y))
    }

    /// Schur complement of the last matrix on the kept equations.
    pub fn schur(&mut self) -> &mut Schur {
        &mut self.schur
    }

    /// The same, to look at.
    pub(super) fn complement(&self) -> &Schur {
        &self.schur
    }

    /// Right side of a system with the last matrix, condensed on the kept equations; `None` if it had no factors.
    pub fn condense(&self, right: &[f64]) -> Option<Condensed> {
        let (mut inner, _) = self.eliminated(right, right.len() - self.kept.len())?;
        let kept = inner.split_off(right.len() - self.kept.len());
        Some(Condensed { inner, kept })
    }

    /// Solution on all equations, of the right side whose condensation on the others this is, and the kept ones' solution.
    pub fn follow(&self, inner: impl Iterator<Item = f64>, kept: &[f64]) -> Option<Vec<f64>> {
        let mut y: Vec<f64> = inner.chain(kept.iter().copied()).collect();
        follow(&self.factors()?, y.len() - kept.len(), &mut y, |_| true);
        self.passes.set(self.passes.get() + 1);
        Some(in_place_of(&self.analysed.as_ref()?.order, &y))
    }

    /// The same near the kept equations alone, at a part of the cost; elsewhere `solution` stays what it is.
    pub fn follow_near(&self, inner: impl Iterator<Item = f64>, kept: &[f64], solution: &mut [f64]) -> Option<()> {
        let mut y: Vec<f64> = inner.chain(kept.iter().copied()).collect();
        let (factors, Analysed { order, near, .. }) = (self.factors()?, self.analysed.as_ref()?);
        follow(&factors, y.len() - kept.len(), &mut y, |number| near[number]);
        let (starts, ends) = (factors.symbolic().supernode_begin(), factors.symbolic().supernode_end());
        for number in (0..near.len()).filter(|number| near[*number]) {
            (starts[number]..ends[number]).for_each(|place| solution[order[place]] = y[place]);
        }
        Some(())
    }

    fn eliminated(&self, right: &[f64], count: usize) -> Option<(Vec<f64>, &[usize])> {
        let order = &self.analysed.as_ref()?.order;
        let mut y: Vec<f64> = order.iter().map(|&equation| right[equation]).collect();
        eliminate(&self.factors()?, count, &mut y);
        self.passes.set(self.passes.get() + 1);
        Some((y, order))
    }

    fn factors(&self) -> Option<SupernodalLltRef<'_, usize, f64>> {
        let Analysed { symbolic, .. } = self.analysed.as_ref().filter(|_| self.is_factorised)?;
        let SymbolicCholeskyRaw::Supernodal(supernodal) = symbolic.raw() else { return None };
        Some(SupernodalLltRef::new(supernodal, &self.values))
    }

    /// The last columns of the factor are the Schur complement's.
    fn load_schur(&mut self) {
        let size = self.kept.len();
        let mut schur = std::mem::take(&mut self.schur);
        let lower = schur.renewed(size);
        if let Some(factors) = self.factors().filter(|_| size > 0) {
            let first = self.places_eliminated();
            for number in 0..factors.symbolic().n_supernodes() {
                let supernode = factors.supernode(number);
                let (block, start, below) = (supernode.val(), supernode.start(), supernode.pattern());
                for j in first.saturating_sub(start)..block.ncols() {
                    let (own, others) = column(block, j).split_at(block.ncols());
                    let to = lower.col_as_slice_mut(start + j - first);
                    to[start + j - first..start + own.len() - first].copy_from_slice(&own[j..]);
                    below.iter().zip(others).for_each(|(&row, value)| to[row - first] = *value);
                }
            }
        }
        self.schur = schur;
    }

    /// Equations that are not kept.
    fn places_eliminated(&self) -> usize {
        self.analysed.as_ref().map_or(0, |analysed| analysed.order.len() - self.kept.len())
    }
}

/// Values in the order of elimination, on the equations.
fn in_place_of(order: &[usize], values: &[f64]) -> Vec<f64> {
    let mut placed = vec![0.0; values.len()];
    order.iter().zip(values).for_each(|(&equation, value)| placed[equation] = *value);
    placed
}

fn analyse(matrix: &Lower, kept: &[usize], places: &[[f64; 3]]) -> Option<Analysed> {
    let order = order(matrix, kept, places);
    let mut inverse = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, &equation)| inverse[equation] = place);
    let supernodal_flop_ratio_threshold = SupernodalThreshold::FORCE_SUPERNODAL;
    let params = CholeskySymbolicParams { supernodal_flop_ratio_threshold, ..Default::default() };
    let custom = SymmetricOrdering::Custom(PermRef::new_checked(&order, &inverse, order.len()));
    let symbolic = factorize_symbolic_cholesky(matrix.pattern(), Side::Lower, custom, params).ok()?;
    let near = match symbolic.raw() {
        SymbolicCholeskyRaw::Supernodal(factors) => supernodes_near(matrix, kept, &order, factors),
        SymbolicCholeskyRaw::Simplicial(_) => return None,
    };
    Some(Analysed { pattern: matrix.clone(), symbolic, order, near })
}

#[cfg(test)]
mod tests;
