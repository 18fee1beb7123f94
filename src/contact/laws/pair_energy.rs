//! Energy of one pair and its gradient, whichever law it follows.

use super::energy_law::EnergyLaw;
use super::momentum_correction::correct;
use super::penetration_law::PenetrationLaw;
use crate::geometry::Vector;
use crate::overlap::{ContactPoints, Imbalance, MotionGradient, Overlap, Pair, Partner, PointGradient, Warning};

/// Energy of one pair, its gradient on nodes and pose, and the overlap from which it comes.
pub(crate) struct PairEnergy<const D: usize> {
    pub(crate) overlap: Overlap<D>,
    pub(crate) energy: f64,
    /// Traction; for the fiber law its mean over the patch.
    pub(crate) pressure: f64,
    pub(crate) nodes: Vec<u32>,
    pub(crate) gradient: Vec<Vector<D>>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) pose_gradient: Option<MotionGradient<D>>,
}

impl<const D: usize> PairEnergy<D> {
    /// Of two bodies that something holds together, and that are in no contact: there is no overlap, only an area that is held, and the mean
    /// traction on it.
    pub(crate) fn of_interface(
        bodies: [usize; 2],
        (energy, gradient): (f64, Vec<Vector<D>>),
        (nodes, of_b): (&[u32], &[bool]),
        (area, pressure): (f64, f64),
        warnings: Vec<Warning>,
    ) -> Self {
        let [a, b] = bodies.map(Partner::Body);
        let overlap = Overlap {
            a,
            b,
            volume: 0.0,
            standard_error: 0.0,
            nodes: nodes.to_vec(),
            gradient: gradient.clone(),
            of_b: of_b.to_vec(),
            pose_gradient: None,
            contact_area: area,
            penetration: 0.0,
            fiber_count: 0,
            crossing_count: 0,
            facet_count: 0,
            spacing: 0.0,
            warnings,
        };
        Self { overlap, energy, pressure, nodes: nodes.to_vec(), gradient, of_b: of_b.to_vec(), pose_gradient: None }
    }

    /// w(V).
    pub(crate) fn of_volume(overlap: Overlap<D>, law: &EnergyLaw) -> Self {
        let pressure = law.energy_gradient(overlap.volume);
        Self {
            energy: law.energy(overlap.volume),
            pressure,
            nodes: overlap.nodes.clone(),
            gradient: overlap.gradient.iter().map(|g| g * pressure).collect(),
            of_b: overlap.of_b.clone(),
            pose_gradient: overlap.pose_gradient.map(|pose| MotionGradient::from(pose).scaled(pressure)),
            overlap,
        }
    }

    /// Σ ω ψ(L); an imbalance of the forces beyond rounding is put right where something is `expected` of it.
    pub(crate) fn of_points(
        points: &ContactPoints<D>,
        pair: &Pair<D>,
        law: &PenetrationLaw,
        expected: Option<Imbalance>,
    ) -> Self {
        let slope = |length: f64| law.energy_gradient(length);
        let (mut gradient, mut overlap) = points.gradient_and_overlap(pair, &|length| law.energy(length), &slope);
        if let Some(expected) = expected {
            let PointGradient { nodes, of_b, values, pose } = &mut gradient;
            overlap.warnings.extend(correct(nodes, of_b, values, pose, pair, expected));
        }
        let across = points.sum(|_| 1.0);
        Self {
            energy: points.sum(|length| law.energy(length)),
            pressure: if across > 0.0 { points.sum(slope) / across } else { 0.0 },
            nodes: gradient.nodes,
            gradient: gradient.values,
            of_b: gradient.of_b,
            pose_gradient: gradient.pose.map(MotionGradient::from),
            overlap,
        }
    }
}
