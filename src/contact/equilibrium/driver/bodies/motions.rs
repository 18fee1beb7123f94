//! Rigid motions of bodies that the host's matrix does not hold, or hardly.

use super::compatible::compatible;
use super::joined::own_diagonal;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{Unknowns, combined, dot, largest};
use crate::geometry::Vector;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Energy of a motion, by that of the same motion of every node alone, below which a body is hardly held: by weak springs, by a large
/// body's one node, or by nothing.
const HARDLY: f64 = 1e-4;

/// The same, below which nothing holds it.
const FREE: f64 = 1e-11;

/// Part of the terms of a sum that is more than rounding.
const ROUNDED: f64 = 1e-9;

/// Directions that only rounding tells apart.
const DEPENDENT: f64 = 1e-12;

/// Motions that are not held, each scaled to a largest entry of 1.
pub(crate) struct Motions {
    pub(crate) fields: Vec<Vec<f64>>,
    /// Their sizes, by row of coordinates.
    sizes: Vec<Vec<f64>>,
    /// Φᵀ K Φ.
    pub(crate) stiffness: DMatrix<f64>,
    /// The diagonal of K.
    pub(crate) weights: Vec<f64>,
    /// The diagonal of Φᵀ diag(K) Φ.
    pub(crate) diagonal: Vec<f64>,
    /// Whether nothing at all holds some of them.
    pub(crate) are_free: bool,
}

impl Motions {
    pub(crate) fn count(&self) -> usize {
        self.fields.len()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.fields.is_empty()
    }

    /// Σ q Φ.
    pub(crate) fn combined(&self, q: &DVector<f64>) -> Vec<f64> {
        combined(&self.fields, q)
    }

    /// Φᵀ v.
    pub(crate) fn along(&self, v: &[f64]) -> DVector<f64> {
        DVector::from_iterator(self.count(), self.fields.iter().map(|field| dot(field, v)))
    }

    /// diag(K) v.
    pub(crate) fn weighted(&self, v: &[f64]) -> Vec<f64> {
        v.iter().zip(&self.weights).map(|(entry, weight)| entry * weight).collect()
    }

    /// |Φ|ᵀ |v|.
    pub(crate) fn magnitudes(&self, v: &[f64]) -> DVector<f64> {
        let of = |field: &Vec<f64>| field.iter().zip(v).map(|(a, b)| (a * b).abs()).sum::<f64>();
        DVector::from_iterator(self.count(), self.fields.iter().map(of))
    }

    /// Σ |Φ| |v| over the rows of coordinates, whichever way they look.
    pub(crate) fn whole_magnitudes<const D: usize>(&self, unknowns: &Unknowns<D>, v: &[f64]) -> DVector<f64> {
        let v = row_sizes(unknowns, v);
        DVector::from_iterator(self.count(), self.sizes.iter().map(|sizes| dot(sizes, &v)))
    }

    /// Those of all bodies, at a state whose matrix the host has.
    pub(crate) async fn loose<const D: usize>(
        host: &Host<D>,
        assembly: &Assembly<D>,
        coords: &[[f64; D]],
    ) -> Result<Self, Trouble> {
        let diagonal = host.diagonal().await?;
        let own = own_diagonal(host, &diagonal).await?;
        let sum = |a: &[f64], b: &[f64], of: &[f64]| a.iter().zip(b).zip(of).map(|((a, b), k)| a * b * k).sum::<f64>();
        let weighted = |a: &[f64], b: &[f64]| sum(a, b, &diagonal);
        let is_shared = host.unknowns.are_shared();
        let mut fields = Vec::new();
        for body in 0..assembly.rows.len() {
            let found = of_body(host, assembly, body).into_iter().filter(|field| weighted(field, field) > 0.0);
            // Bodies that share unknowns may have the same motion.
            found.for_each(|field| {
                if !(is_shared && fields.contains(&field)) {
                    fields.push(field)
                }
            });
        }
        let count = fields.len();
        let mut products = Vec::with_capacity(count);
        for field in &fields {
            products.push(host.product(field.clone(), false).await?);
        }
        add_interfaces(host, coords, &fields, &mut products).await?;
        let gram = |of: &dyn Fn(usize, usize) -> f64| {
            let full = DMatrix::from_fn(count, count, of);
            0.5 * (&full + full.transpose())
        };
        let alone = gram(&|row, col| sum(&fields[row], &fields[col], &own));
        let mut stiffness = gram(&|row, col| dot(&fields[row], &products[col]));
        let constrained = constraints(host, &fields, &products).await?;
        let size: f64 = constrained.iter().map(|row| dot(row, row)).sum();
        if size > 0.0 {
            // Multipliers of the host hold a motion as springs as stiff as the bodies do.
            stiffness += (alone.trace() / size) * gram(&|row, col| dot(&constrained[row], &constrained[col]));
        }
        let (picked, are_free) = picked(&stiffness, &alone);
        let (mut found, mut combinations) = (Vec::new(), DMatrix::zeros(count, picked.len()));
        for (place, combination) in picked.into_iter().enumerate() {
            let field = combined(&fields, &combination);
            let scale = 1.0 / largest(&field).max(f64::MIN_POSITIVE);
            combinations.set_column(place, &(combination * scale));
            found.push(field.into_iter().map(|entry| entry * scale).collect::<Vec<f64>>());
        }
        let stiffness = combinations.transpose() * &stiffness * &combinations;
        let alone = found.iter().map(|field| weighted(field, field)).collect();
        let sizes = found.iter().map(|field| row_sizes(&host.unknowns, field)).collect();
        Ok(Self { fields: found, sizes, stiffness, weights: diagonal, diagonal: alone, are_free })
    }

    /// How far bodies go by these motions, by mean, and how much they turn, as quadratic forms.
    pub(crate) fn ways<const D: usize>(&self, host: &Host<D>, assembly: &Assembly<D>) -> (DMatrix<f64>, DMatrix<f64>) {
        let count = self.count();
        let (mut mean, mut rest) = (DMatrix::zeros(count, count), DMatrix::zeros(count, count));
        let motions: Vec<_> = self.fields.iter().map(|field| host.unknowns.spread(field)).collect();
        for rows in assembly.rows.iter().filter(|rows| !rows.is_empty()) {
            let by = 1.0 / rows.len() as f64;
            let mean_of = |motion: &Vec<[f64; D]>| {
                rows.iter().fold(Vector::<D>::zeros(), |sum, &row| sum + Vector::from(motion[row])) * by
            };
            let means: Vec<Vector<D>> = motions.iter().map(mean_of).collect();
            let moves: Vec<usize> =
                (0..count).filter(|&k| rows.iter().any(|&row| motions[k][row] != [0.0; D])).collect();
            for &i in &moves {
                for &j in &moves {
                    mean[(i, j)] += means[i].dot(&means[j]);
                    let apart = |k: usize, row: usize| Vector::<D>::from(motions[k][row]) - means[k];
                    let turn: f64 = rows.iter().map(|&row| apart(i, row).dot(&apart(j, row))).sum();
                    rest[(i, j)] += D as f64 * by * turn;
                }
            }
        }
        (mean, rest)
    }
}

/// Length of every row of coordinates.
fn row_sizes<const D: usize>(unknowns: &Unknowns<D>, v: &[f64]) -> Vec<f64> {
    unknowns.spread(v).into_iter().map(|row| Vector::from(row).norm()).collect()
}

/// Combinations of motions that are not held, or hardly, and whether nothing at all holds some of them. A translation or rotation that nothing
/// holds by itself stays what it is: mixed with others it would move bodies along what drives none of them.
fn picked(stiffness: &DMatrix<f64>, alone: &DMatrix<f64>) -> (Vec<DVector<f64>>, bool) {
    let count = stiffness.nrows();
    let (free, held): (Vec<usize>, Vec<usize>) = (0..count).partition(|&k| stiffness[(k, k)] <= FREE * alone[(k, k)]);
    let unit = |k: usize| DVector::from_fn(count, |row, _| if row == k { 1.0 } else { 0.0 });
    let mut found: Vec<DVector<f64>> = free.iter().map(|&k| unit(k)).collect();
    let of_held = |matrix: &DMatrix<f64>| matrix.select_rows(&held).select_columns(&held);
    let (values, vectors) = pencil(&of_held(stiffness), &of_held(alone));
    for k in (0..values.len()).filter(|&k| values[k] <= HARDLY) {
        let mut combination = DVector::zeros(count);
        held.iter().enumerate().for_each(|(place, &row)| combination[row] = vectors[(place, k)]);
        found.push(combination);
    }
    (found, !free.is_empty() || values.iter().any(|value| *value <= FREE))
}

/// Adds what ties and cohesive interfaces hold motions with.
async fn add_interfaces<const D: usize>(
    host: &Host<D>,
    coords: &[[f64; D]],
    fields: &[Vec<f64>],
    products: &mut [Vec<f64>],
) -> Result<(), Trouble> {
    let motions: Vec<_> = fields.iter().map(|field| host.unknowns.spread(field)).collect();
    let coords = coords.to_vec();
    let held = host.contact(move |contact| contact.held_by_interfaces(&coords, &motions)).await?;
    for (product, rows) in products.iter_mut().zip(held) {
        product.iter_mut().zip(host.unknowns.gather(&rows)).for_each(|(sum, held)| *sum += held);
    }
    Ok(())
}

/// What motions ask of unknowns that move no coordinate, such as multipliers by which a host holds bodies; zero where it is rounding.
async fn constraints<const D: usize>(
    host: &Host<D>,
    fields: &[Vec<f64>],
    products: &[Vec<f64>],
) -> Result<Vec<Vec<f64>>, Trouble> {
    let mut others = vec![true; host.unknowns.count];
    host.unknowns.of_coordinate.iter().flatten().for_each(|&unknown| others[unknown] = false);
    if fields.is_empty() || !others.contains(&true) {
        return Ok(Vec::new());
    }
    let mut all = vec![0.0; host.unknowns.count];
    fields.iter().for_each(|field| all.iter_mut().zip(field).for_each(|(sum, entry)| *sum += entry.abs()));
    let terms = host.product(all, true).await?;
    let asked = |product: &Vec<f64>| -> Vec<f64> {
        let of = |k: usize| if others[k] && product[k].abs() > ROUNDED * terms[k] { product[k] } else { 0.0 };
        (0..product.len()).map(of).collect()
    };
    Ok(products.iter().map(asked).collect())
}

/// Translations and rotations of a body, as far as its unknowns are free.
fn of_body<const D: usize>(host: &Host<D>, assembly: &Assembly<D>, body: usize) -> Vec<Vec<f64>> {
    let rows = &assembly.rows[body];
    let sum = rows.iter().fold(Vector::<D>::zeros(), |sum, &row| sum + assembly.position[row]);
    let centre = sum / rows.len().max(1) as f64;
    let arm = |row: usize| assembly.position[row] - centre;
    let reach = rows.iter().map(|&row| arm(row).amax()).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let is_shared = host.unknowns.are_shared();
    let field = |motion: &dyn Fn(usize) -> Vector<D>| {
        let mut field = vec![0.0; host.unknowns.count];
        for &row in rows {
            let here = motion(row);
            for axis in 0..D {
                if let Some(unknown) = host.unknowns.of_coordinate[row * D + axis] {
                    field[unknown] = here[axis];
                }
            }
        }
        // Coordinates that share an unknown cannot move apart: such a motion is none.
        let agrees = |row: usize, axis: usize| match host.unknowns.of_coordinate[row * D + axis] {
            Some(unknown) => !host.unknowns.free[unknown] || field[unknown] == motion(row)[axis],
            None => true,
        };
        let is_made = !is_shared || rows.iter().all(|&row| (0..D).all(|axis| agrees(row, axis)));
        if is_made { host.unknowns.freed(field) } else { vec![0.0; host.unknowns.count] }
    };
    let unit = |axis: usize| Vector::from_fn(|row, _| if row == axis { 1.0 } else { 0.0 });
    let planes: &[[usize; 2]] = if D == 2 { &[[0, 1]] } else { &[[1, 2], [2, 0], [0, 1]] };
    let turned = |&[i, j]: &[usize; 2], row: usize| {
        let mut turned = Vector::zeros();
        (turned[i], turned[j]) = (-arm(row)[j] / reach, arm(row)[i] / reach);
        turned
    };
    if !host.unknowns.weighted.is_empty() {
        let all = |motion: &dyn Fn(usize) -> Vector<D>| -> Vec<[f64; D]> {
            let mut all = vec![[0.0; D]; host.unknowns.base.len()];
            rows.iter().for_each(|&row| all[row] = motion(row).into());
            all
        };
        let translations = (0..D).map(|axis| all(&|_| unit(axis)));
        let motions: Vec<_> = translations.chain(planes.iter().map(|plane| all(&|row| turned(plane, row)))).collect();
        return compatible(&host.unknowns, rows, &motions);
    }
    let mut fields: Vec<_> = (0..D).map(|axis| field(&|_| unit(axis))).collect();
    fields.extend(planes.iter().map(|plane| field(&|row| turned(plane, row))));
    fields
}

/// Eigenvalues, ascending, and vectors of A v = λ B v, on what B does not take for nothing.
pub(crate) fn pencil(a: &DMatrix<f64>, b: &DMatrix<f64>) -> (Vec<f64>, DMatrix<f64>) {
    let count = a.nrows();
    if count == 0 {
        return (Vec::new(), DMatrix::zeros(0, 0));
    }
    let of_b = SymmetricEigen::new(b.clone());
    let most = of_b.eigenvalues.iter().copied().fold(0.0, f64::max);
    let kept: Vec<usize> = (0..count).filter(|&k| of_b.eigenvalues[k] > DEPENDENT * most).collect();
    let basis = DMatrix::from_fn(count, kept.len(), |row, col| {
        of_b.eigenvectors[(row, kept[col])] / of_b.eigenvalues[kept[col]].sqrt()
    });
    let small = basis.transpose() * a * &basis;
    let of_small = SymmetricEigen::new(0.5 * (&small + small.transpose()));
    let mut order: Vec<usize> = (0..kept.len()).collect();
    order.sort_by(|i, j| of_small.eigenvalues[*i].total_cmp(&of_small.eigenvalues[*j]));
    let vectors = basis * of_small.eigenvectors;
    let sorted = DMatrix::from_fn(count, order.len(), |row, col| vectors[(row, order[col])]);
    (order.iter().map(|&k| of_small.eigenvalues[k]).collect(), sorted)
}
