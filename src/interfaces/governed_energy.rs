//! Forces and tangent of an interface by a law of the host at some coordinates.
//!
//! With a, as for cohesive interfaces, the jump s_i = a·e_i (less the gap at first along the normal e_0), tractions t_i and K_ij = ∂t_i/∂s_j
//!
//! ```text
//! f = Σ t_i ds_i                   ds_i = e_i·da + a·de_i
//! df = Σ K_ij ds_i ds_j + Σ t_i d²s_i
//! ```
//!
//! Every s_i is the same after a rigid motion, so that forces and moments balance whatever the law is.

use super::axes::Axes;
use super::cohesion::CohesivePoint;
use super::cohesive_energy::Softened;
use super::frame::Matrix;
use super::governed::{Governed, LawFields};
use super::interface_law::{Answer, InterfaceLaw, LawPoints};
use super::place::Weights;
use super::square::{Square, mixed};
use crate::geometry::Vector;
use crate::overlap::{Block, BlockSum};
use crate::{Error, LawFault};
use nalgebra::Matrix3;

/// Such an interface at some coordinates.
pub(crate) struct GovernedAt<'a, const D: usize> {
    governed: &'a Governed<D>,
    axes: Vec<Axes<D>>,
    apart: Vec<Vector<D>>,
    pub(crate) jumps: Vec<f64>,
    pub(crate) positions: Vec<f64>,
    pub(crate) answer: Answer,
}

impl<const D: usize> Governed<D> {
    /// At these points of the mesh, with the history, how long the step takes, and fields of the host.
    ///
    /// # Errors
    /// [`Error::InterfaceLaw`] of the law, and where a facet of the second body has no area.
    pub(crate) fn at(
        &self,
        points: &[[f64; D]],
        law: &dyn InterfaceLaw,
        (history, time_step, fields): (&[f64], f64, &LawFields),
    ) -> Result<GovernedAt<'_, D>, Error> {
        let Self { points: held, .. } = self;
        let x: Vec<Vector<D>> = held.nodes.iter().map(|&node| Vector::from(points[node as usize])).collect();
        let sum = |weights: &Weights| {
            weights.iter().fold(Vector::<D>::zeros(), |sum, &(node, weight)| sum + x[node as usize] * weight)
        };
        let mut axes = Vec::with_capacity(held.frames.len());
        for (frame, (corners, shares)) in held.frames.iter().zip(&self.axes).enumerate() {
            axes.push(Axes::new(&corners.each_ref().map(sum), shares).ok_or_else(|| {
                let point = held.points.iter().position(|point| point.frame as usize == frame);
                let cause = "the facet of the second body has no area there, and no normal".to_owned();
                Error::InterfaceLaw(LawFault { bodies: held.bodies, point, cause })
            })?);
        }
        let count = held.points.len();
        let (mut apart, mut positions) = (Vec::<Vector<D>>::with_capacity(count), Vec::with_capacity(count * D));
        for point in &held.points {
            // The nodes of the first body come first: their sum is where the point is.
            let own = point.jump.partition_point(|(node, _)| !held.of_b[*node as usize]);
            let add = |x0: Vector<D>, weights: &[(u32, f64)]| {
                weights.iter().fold(x0, |sum, &(node, weight)| sum + x[node as usize] * weight)
            };
            let position = add(Vector::zeros(), &point.jump[..own]);
            positions.extend_from_slice(position.as_slice());
            apart.push(add(position, &point.jump[own..]));
        }
        let (mut jumps, mut in_space) = (Vec::with_capacity(count * D), Vec::with_capacity(count * D * D));
        for (point, apart) in held.points.iter().zip(&apart) {
            let units = &axes[point.frame as usize].units;
            jumps.extend(units.iter().map(|unit| apart.dot(unit)));
            jumps[in_space.len() / D] -= point.gap;
            units.iter().for_each(|unit| in_space.extend_from_slice(unit.as_slice()));
        }
        let answer = Answer::of(
            law,
            &LawPoints {
                bodies: held.bodies,
                dim: D,
                count,
                time_step,
                jumps: &jumps,
                axes: &in_space,
                positions: &positions,
                references: &self.references,
                areas: &self.areas,
                history,
                field_count: fields.count,
                fields: &self.fields(fields),
            },
        )?;
        Ok(GovernedAt { governed: self, axes, apart, jumps, positions, answer })
    }
}

impl<const D: usize> GovernedAt<'_, D> {
    fn points(&self) -> &[CohesivePoint] {
        &self.governed.points.points
    }

    /// By axis, of a point.
    pub(crate) fn traction(&self, point: usize) -> [f64; D] {
        std::array::from_fn(|axis| self.answer.tractions[point * D + axis])
    }

    pub(crate) fn jump(&self, point: usize) -> [f64; D] {
        std::array::from_fn(|axis| self.jumps[point * D + axis])
    }

    /// Normal and axes at a point.
    pub(crate) fn axes(&self, point: usize) -> [[f64; D]; D] {
        self.axes[self.points()[point].frame as usize].units.map(Into::into)
    }

    /// Energies that unloading would give back, and that have been dissipated.
    pub(crate) fn energies(&self) -> [f64; 2] {
        let Answer { stored, dissipated, .. } = &self.answer;
        [stored, dissipated].map(|list| self.points().iter().zip(list).map(|(point, x)| point.measure * x).sum())
    }

    /// Tractions without their directions, summed over the area.
    pub(crate) fn pulled(&self) -> f64 {
        let size = |point: usize| self.traction(point).iter().map(|x| x * x).sum::<f64>().sqrt();
        self.points().iter().enumerate().map(|(number, point)| point.measure * size(number)).sum()
    }

    /// The largest entry of a tangent.
    pub(crate) fn largest_stiffness(&self) -> f64 {
        self.answer.tangents.iter().fold(0.0, |most, x| most.max(x.abs()))
    }

    /// Σ t_i ds_i by the nodes of the interface.
    pub(crate) fn gradient(&self) -> Vec<Vector<D>> {
        let held = &self.governed.points;
        let mut gradient = vec![Vector::zeros(); held.nodes.len()];
        let mut loads = vec![[Vector::<D>::zeros(); D]; self.axes.len()];
        for (number, (point, apart)) in held.points.iter().zip(&self.apart).enumerate() {
            let (axes, loads) = (&self.axes[point.frame as usize], &mut loads[point.frame as usize]);
            let mut force = Vector::zeros();
            for (axis, traction) in self.traction(number).into_iter().enumerate() {
                force += axes.units[axis] * (traction * point.measure);
                loads[axis] += apart * (traction * point.measure);
            }
            point.jump.iter().for_each(|&(node, weight)| gradient[node as usize] += force * weight);
        }
        for ((corners, axes), loads) in held.frames.iter().zip(&self.axes).zip(&loads) {
            for (corner, weights) in corners.iter().enumerate() {
                let along = |j: usize| -> f64 {
                    (0..D * D).map(|k| loads[k / D][k % D] * axes.slopes[k / D][corner][k % D][j]).sum()
                };
                let force = Vector::<D>::from_fn(|j, _| along(j));
                weights.iter().for_each(|&(node, weight)| gradient[node as usize] += force * weight);
            }
        }
        gradient
    }

    /// The derivative of that, by points of the mesh.
    pub(crate) fn curvature(&self, which: Softened) -> Vec<Block<D>> {
        let held = &self.governed.points;
        let (mut sum, mut square) = (BlockSum::default(), Square::default());
        for (number, point) in held.points.iter().enumerate() {
            if !square.is_of(point) {
                square.hand_over(&held.nodes, &mut sum);
                square = Square::of(point, &held.frames[point.frame as usize]);
            }
            let own = &self.answer.tangents[number * D * D..];
            let own = std::array::from_fn(|i| std::array::from_fn(|j| own[i * D + j]));
            let tractions = (which != Softened::Secant).then(|| self.traction(number));
            let axes = &self.axes[point.frame as usize];
            square.add_governed(point, (&self.apart[number], axes), &part_of(&own, which), tractions);
        }
        square.hand_over(&held.nodes, &mut sum);
        sum.into_blocks()
    }
}

impl<const D: usize> Square<D> {
    /// Adds what a point does by its K, and with its tractions what the turning of the facet does.
    fn add_governed(
        &mut self,
        point: &CohesivePoint,
        (apart, axes): (&Vector<D>, &Axes<D>),
        stiffness: &Matrix<D>,
        tractions: Option<[f64; D]>,
    ) {
        let (count, weights) = (self.nodes.len(), self.weights(point));
        let zero = [[0.0; D]; D];
        // By node ds_i, as rows, and Σ t_i de_i.
        let (mut by_axis, mut turned) = (vec![zero; count], vec![zero; count]);
        for node in 0..count {
            for axis in 0..D {
                let slope = mixed(&self.corners[node], &axes.slopes[axis]);
                let traction = tractions.map_or(0.0, |tractions| tractions[axis]);
                for j in 0..D {
                    let along: f64 = (0..D).map(|i| apart[i] * slope[i][j]).sum();
                    by_axis[node][axis][j] = weights[node] * axes.units[axis][j] + along;
                    (0..D).for_each(|i| turned[node][i][j] += traction * slope[i][j]);
                }
            }
        }
        let stiffened: Vec<Matrix<D>> = by_axis.iter().map(|rows| product(stiffness, rows)).collect();
        for r in 0..count {
            for c in 0..count {
                let value = &mut self.values[r * count + c];
                for i in 0..D {
                    for j in 0..D {
                        let own: f64 = (0..D).map(|axis| by_axis[r][axis][i] * stiffened[c][axis][j]).sum();
                        let crossed = weights[r] * turned[c][i][j] + weights[c] * turned[r][j][i];
                        value[i][j] += point.measure * (own + crossed);
                    }
                }
            }
        }
        let Some(tractions) = tractions else { return };
        for corners in (0..D * D).map(|k| [k / D, k % D]) {
            let second = axes.second(apart, &tractions, corners);
            for r in 0..count {
                for c in 0..count {
                    let share = point.measure * self.corners[r][corners[0]] * self.corners[c][corners[1]];
                    if share != 0.0 {
                        let value = &mut self.values[r * count + c];
                        (0..D).for_each(|i| (0..D).for_each(|j| value[i][j] += share * second[i][j]));
                    }
                }
            }
        }
    }
}

fn product<const D: usize>(a: &Matrix<D>, b: &Matrix<D>) -> Matrix<D> {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..D).map(|k| a[i][k] * b[k][j]).sum()))
}

/// K, its symmetric part, or that with the sign of its negative eigenvalues turned: what softens then resists as much, and what is broken does
/// not.
fn part_of<const D: usize>(own: &Matrix<D>, which: Softened) -> Matrix<D> {
    if which == Softened::All {
        return *own;
    }
    let symmetric: Matrix<D> = std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * own[i][j] + 0.5 * own[j][i]));
    if which == Softened::Symmetric {
        return symmetric;
    }
    let in_space = Matrix3::from_fn(|i, j| if i < D && j < D { symmetric[i][j] } else { 0.0 });
    let mut eigen = in_space.symmetric_eigen();
    eigen.eigenvalues.apply(|value| *value = value.abs());
    let turned = eigen.recompose();
    std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (turned[(i, j)] + turned[(j, i)])))
}
