//! Second derivative of the energy of one pair.

use super::energy_law::EnergyLaw;
use super::penetration_law::PenetrationLaw;
use crate::contact::tangents::{RankOne, Tangent, TangentPart};
use crate::overlap::{Block, ContactPoints, Overlap, Pair};

impl<const D: usize> Tangent<D> {
    /// Tangent of w(V): w' ∇²V + w'' ∇V ∇Vᵀ, given the blocks of ∇²V (none for the semidefinite part).
    pub(crate) fn of_volume(
        overlap: &Overlap<D>,
        mut blocks: Vec<Block<D>>,
        law: &EnergyLaw,
        obstacle_node: u32,
    ) -> Self {
        let slope = law.energy_gradient(overlap.volume);
        blocks.iter_mut().flat_map(|block| block.value.iter_mut().flatten()).for_each(|value| *value *= slope);
        let factor = law.energy_hessian(overlap.volume);
        let mut nodes = overlap.nodes.clone();
        let mut vector: Vec<[f64; D]> = overlap.gradient.iter().map(|g| (*g).into()).collect();
        if let Some(pose) = &overlap.pose_gradient {
            nodes.push(obstacle_node);
            vector.push(pose.position.into());
        }
        let rank_one = if factor != 0.0 { vec![RankOne { factor, nodes, vector }] } else { Vec::new() };
        Self { blocks, rank_one }
    }

    /// Tangent of the fiber law on the spans of one pair; empty where its forces are, around a swallowed obstacle.
    pub(crate) fn of_points(
        points: &ContactPoints<D>,
        pair: &Pair<D>,
        law: &PenetrationLaw,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Self {
        if points.are_of_obstacle_alone() {
            return Self { blocks: Vec::new(), rank_one: Vec::new() };
        }
        let value = |length: f64| law.energy(length);
        let slope = |length: f64| law.energy_gradient(length);
        let curvature = |length: f64| law.energy_hessian(length);
        let blocks =
            points.hessian(pair, [&value, &slope, &curvature], part == TangentPart::Semidefinite, obstacle_node);
        Self { blocks, rank_one: Vec::new() }
    }
}
