//! Nodes that follow a reference node whose rotations are free, where rotations are small.
//!
//! u = t + φ × r along each axis. As many displacements of nodes lead as components of t and φ are free: those by which these are known best, by
//! Gauss' elimination with complete pivoting. The others follow them.

use super::references::Reference;
use fmc_solid::statics::Follower;

/// Part of the largest pivot below which nodes do not tell a motion.
const SINGULAR: f64 = 1e-9;

/// A reference node in the eyes of its nodes.
pub(super) struct Lever<const D: usize> {
    /// Components that are free, of t from 0 and of φ from 3.
    free: Vec<usize>,
    /// Nodes and axes that lead, as many.
    leaders: Vec<(usize, usize)>,
    /// Free components by displacements of the leaders, less what is held.
    inverse: Vec<Vec<f64>>,
    /// What the held components move the leaders, at the end of the stage.
    by_held: Vec<f64>,
    /// Values of all six.
    held: [Option<f64>; 6],
    pub(super) followers: Vec<Follower>,
}

/// How far component `c` of the motion moves a node along an axis.
fn slope<const D: usize>(arm: &[f64; D], axis: usize, c: usize) -> f64 {
    let arm = |k: usize| arm.get(k).copied().unwrap_or(0.0);
    match c {
        0..3 => f64::from(u8::from(c == axis)),
        // e_a × r.
        _ if axis == (c + 1) % 3 => -arm((c + 2) % 3),
        _ if axis == (c + 2) % 3 => arm((c + 1) % 3),
        _ => 0.0,
    }
}

impl<const D: usize> Lever<D> {
    /// Of a reference node along some axes, with the values of its components that are held; the component that nodes do not tell, if any.
    pub(super) fn new(
        reference: &Reference<D>,
        (axes, free): ([bool; 3], Vec<usize>),
        held: [Option<f64>; 6],
    ) -> Result<Self, usize> {
        let size = reference.arms.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        let by = |c: usize| if c < 3 { 1.0 } else { 1.0 / size.max(f64::MIN_POSITIVE) };
        let places: Vec<(usize, usize)> = (0..reference.nodes.len())
            .flat_map(|k| (0..D).filter(|&axis| axes[axis]).map(move |axis| (k, axis)))
            .collect();
        let row = |&(k, axis): &(usize, usize)| -> Vec<f64> {
            free.iter().map(|&c| slope(&reference.arms[k], axis, c)).collect()
        };
        let moved = |&(k, axis): &(usize, usize)| -> f64 {
            (0..6).map(|c| held[c].map_or(0.0, |value| value * slope(&reference.arms[k], axis, c))).sum()
        };
        let scaled = |place| row(place).iter().zip(&free).map(|(x, &c)| x * by(c)).collect::<Vec<f64>>();
        let chosen = chosen(places.iter().map(scaled).collect()).map_err(|column| free[column])?;
        let matrix: Vec<Vec<f64>> = chosen.iter().map(|&k| row(&places[k])).collect();
        let inverse = inverse(matrix);
        let by_held: Vec<f64> = chosen.iter().map(|&k| moved(&places[k])).collect();
        let freedom = |&(k, axis): &(usize, usize)| reference.nodes[k] * D + axis;
        let followers = (0..places.len()).filter(|k| !chosen.contains(k)).map(|k| {
            let slopes = row(&places[k]);
            let weight = |leader: usize| -> f64 { slopes.iter().zip(&inverse).map(|(x, row)| x * row[leader]).sum() };
            let weights: Vec<f64> = (0..chosen.len()).map(weight).collect();
            let apart = moved(&places[k]) - weights.iter().zip(&by_held).map(|(w, held)| w * held).sum::<f64>();
            let of = chosen.iter().zip(&weights).filter(|(_, weight)| **weight != 0.0);
            let of = of.map(|(&leader, &weight)| (freedom(&places[leader]), weight)).collect();
            Follower { freedom: freedom(&places[k]), of, apart: Some(apart) }
        });
        let followers = followers.collect();
        let leaders = chosen.iter().map(|&k| (reference.nodes[places[k].0], places[k].1)).collect();
        Ok(Self { free, leaders, inverse, by_held, held, followers })
    }

    /// The motion of the reference node where its nodes are displaced.
    pub(super) fn motion(&self, displacement: &[[f64; D]]) -> [f64; 6] {
        let led: Vec<f64> = self
            .leaders
            .iter()
            .zip(&self.by_held)
            .map(|(&(node, axis), held)| displacement[node][axis] - held)
            .collect();
        let mut all = self.held.map(|value| value.unwrap_or(0.0));
        for (&c, row) in self.free.iter().zip(&self.inverse) {
            all[c] = row.iter().zip(&led).map(|(x, u)| x * u).sum();
        }
        all
    }

    /// Forces on nodes that do the work of a load on a component; none where it is held.
    pub(super) fn load(&self, component: usize, value: f64) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        let row = self.free.iter().position(|&c| c == component).map(|row| &self.inverse[row]);
        let forces = row.into_iter().flatten().zip(&self.leaders);
        forces.map(move |(x, &(node, axis))| (node, axis, x * value))
    }
}

/// Rows of a matrix that are most independent, as many as it has columns; the column that no row tells, if there is one.
fn chosen(mut rows: Vec<Vec<f64>>) -> Result<Vec<usize>, usize> {
    let count = rows.first().map_or(0, Vec::len);
    let (mut chosen, mut columns) = (Vec::new(), (0..count).collect::<Vec<usize>>());
    let mut most = 0.0;
    while !columns.is_empty() {
        let mut best = (0.0, 0, columns[0]);
        for (k, row) in rows.iter().enumerate().filter(|(k, _)| !chosen.contains(k)) {
            for &column in &columns {
                // Equal but for rounding counts as equal: the first is taken.
                if row[column].abs() > best.0 * (1.0 + 1e-9) {
                    best = (row[column].abs(), k, column);
                }
            }
        }
        let (size, pivot, column) = best;
        most = f64::max(most, size);
        if size <= SINGULAR * most || size == 0.0 {
            return Err(column);
        }
        let of_pivot = rows[pivot].clone();
        for row in &mut rows {
            let part = row[column] / of_pivot[column];
            row.iter_mut().zip(&of_pivot).for_each(|(x, y)| *x -= part * y);
        }
        chosen.push(pivot);
        columns.retain(|other| *other != column);
    }
    Ok(chosen)
}

/// Gauss and Jordan, with partial pivoting; the matrix is regular.
fn inverse(mut rows: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let count = rows.len();
    for (k, row) in rows.iter_mut().enumerate() {
        row.extend((0..count).map(|j| f64::from(u8::from(j == k))));
    }
    for column in 0..count {
        let pivot = (column..count).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()));
        rows.swap(column, pivot.unwrap_or(column));
        let by = rows[column][column];
        rows[column].iter_mut().for_each(|x| *x /= by);
        let of_pivot = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(k, _)| *k != column) {
            let part = row[column];
            row.iter_mut().zip(&of_pivot).for_each(|(x, y)| *x -= part * y);
        }
    }
    rows.into_iter().map(|row| row[count..].to_vec()).collect()
}
