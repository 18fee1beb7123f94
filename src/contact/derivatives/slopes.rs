//! Rates of energy and forces, from what the laws and friction answer for every pair: `answers`, along a direction.

use super::answers::{State, check_coefficient, check_smooth, check_stiffness, normal_of_half_space};
use super::directions::Along;
use crate::Error;
use crate::contact::friction::Tractions;
use crate::contact::laws::{Answer, PairEnergy};
use crate::contact::method::Method;
use crate::contact::partners::Partners;
use crate::contact::results::OntoNodes;
use crate::contact::tangents::Tangent;
use crate::geometry::second_order::Division;
use crate::geometry::{Vector, moment};
use crate::overlap::Partner;

/// Rates of energy and forces: see [`Contact::jvp`](crate::Contact::jvp).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Slopes<const D: usize> {
    /// Of the contact energy, in which friction has no part.
    pub energy: f64,
    /// Of the force on every node, `[node_count, D]`.
    pub forces: Vec<[f64; D]>,
}

impl<const D: usize> Slopes<D> {
    /// These, if all are finite.
    pub(crate) fn checked(self) -> Result<Self, Error> {
        let forces = self.forces.as_flattened().iter().copied();
        let bad = forces.chain([self.energy]).find(|x| !x.is_finite());
        match bad {
            Some(value) => Err(Error::Overflow { quantity: "derivative", value }),
            None => Ok(self),
        }
    }
}

impl<const D: usize> OntoNodes for Slopes<D> {
    fn onto_nodes(mut self, division: &Division) -> Self {
        self.forces = division.map().onto_nodes(&self.forces);
        self
    }
}

/// Adds what all pairs have. `moved` is the motion of nodes, of positions and of rotations.
///
/// # Errors
/// [`Error::Unsupported`] for what is no derivative, or is not known.
pub(crate) fn add_slopes<const D: usize>(
    (partners, method): (&Partners<D>, &Method<D>),
    (answers, tractions): (&[Answer<D>], &[Tractions<D>]),
    (along, moved, state): (&Along, &[[f64; D]], &State),
    slopes: &mut Slopes<D>,
) -> Result<(), Error> {
    let node_count = slopes.forces.len();
    let request = along.request();
    let moves = request.coords || request.positions || request.rotations;
    for answer in answers {
        let Some(energy) = &answer.energy else { continue };
        let pair = [energy.overlap.a, energy.overlap.b];
        let rubs = partners.friction_of(&pair, method.options()).is_active();
        let [stiffness, gap_offset, friction] = along.of_pair(&pair);
        if moves || gap_offset != 0.0 {
            check_smooth(pair, energy.overlap.fiber_count > 0, (partners, method), state, true)?;
        }
        let mut shifted = None;
        if gap_offset != 0.0 {
            let (Partner::Obstacle(o), Some(_)) = (pair[1], &energy.pose_gradient) else {
                return Err(Error::Unsupported { what: "the derivative by the gap offset between bodies" });
            };
            let normal = normal_of_half_space(partners, o, rubs)?;
            let of_pair = shifted.insert(moved.to_vec());
            (0..D).for_each(|i| of_pair[node_count + o][i] += gap_offset * normal[i]);
        }
        let moved = shifted.as_deref().unwrap_or(moved);
        slopes.energy += energy_along(energy, partners, moved, along.rotations.unwrap_or(&[]), node_count)?;
        if let Some(tangent) = &answer.tangent {
            add_product(tangent, moved, -1.0, &mut slopes.forces);
        }
        if stiffness != 0.0 {
            check_stiffness(rubs, state)?;
            let part = stiffness / partners.stiffness_of(&pair, method.options());
            slopes.energy += part * energy.energy;
            add_forces(energy.nodes.iter().copied().zip(&energy.gradient), -part, &mut slopes.forces);
        }
        if friction != 0.0 {
            let part = friction / check_coefficient(&pair, (partners, method))?;
            for traction in tractions.iter().filter(|traction| traction.partners == pair) {
                add_forces(traction.limited.iter().map(|(node, force)| (*node, force)), part, &mut slopes.forces);
            }
        }
    }
    for traction in tractions {
        add_product(&traction.tangent, moved, -1.0, &mut slopes.forces);
    }
    Ok(())
}

/// What the motion does to the energy of a pair.
fn energy_along<const D: usize>(
    energy: &PairEnergy<D>,
    partners: &Partners<D>,
    moved: &[[f64; D]],
    rotations: &[[f64; 3]],
    node_count: usize,
) -> Result<f64, Error> {
    let nodes = energy.nodes.iter().zip(&energy.gradient);
    let mut sum: f64 = nodes.map(|(&node, g)| g.dot(&Vector::from(moved[node as usize]))).sum();
    if let (Partner::Obstacle(o), Some(motion)) = (energy.overlap.b, &energy.pose_gradient) {
        sum += motion.position.dot(&Vector::from(moved[node_count + o]));
        if let Some(turn) = rotations.get(o) {
            let position = Vector::from(partners.obstacles.rigid(o)?.obstacle.pose.position);
            let about = moment(&position, &motion.position);
            sum += (0..3).map(|i| turn[i] * (motion.rotation[i] - about[i])).sum::<f64>();
        }
    }
    Ok(sum)
}

/// Adds vectors at nodes.
fn add_forces<'a, const D: usize>(
    rows: impl Iterator<Item = (u32, &'a Vector<D>)>,
    factor: f64,
    forces: &mut [[f64; D]],
) {
    for (node, row) in rows {
        (0..D).for_each(|i| forces[node as usize][i] += factor * row[i]);
    }
}

/// K d at the nodes; d also has what stands for obstacles.
fn add_product<const D: usize>(tangent: &Tangent<D>, d: &[[f64; D]], factor: f64, sums: &mut [[f64; D]]) {
    for block in &tangent.blocks {
        let (Some(along), Some(sum)) = (d.get(block.col as usize), sums.get_mut(block.row as usize)) else { continue };
        for (i, sum) in sum.iter_mut().enumerate() {
            *sum += factor * (0..D).map(|j| block.value[i][j] * along[j]).sum::<f64>();
        }
    }
    for part in &tangent.rank_one {
        let of_nodes = || part.nodes.iter().zip(&part.vector);
        let known = of_nodes().filter_map(|(&node, g)| Some((d.get(node as usize)?, g)));
        let along = factor * part.factor * known.map(|(d, g)| (0..D).map(|i| d[i] * g[i]).sum::<f64>()).sum::<f64>();
        for (&node, g) in of_nodes() {
            if let Some(sum) = sums.get_mut(node as usize) {
                (0..D).for_each(|i| sum[i] += along * g[i]);
            }
        }
    }
}
