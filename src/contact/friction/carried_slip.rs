//! The elastic slip that a step leaves to the next.
//!
//! It lives at the nodes and is changed by increments: what sticks adds what its traction gained, what slides sets it. What
//! was carried is moved with the facets, whose deformation turns it, so that nothing diffuses.

use super::side_motion::FacetFrame;
use super::slip_points::SlipPoints;
use super::step::Step;
use crate::geometry::facet::area_vector;
use crate::geometry::{Surface, Vector};

/// Sums towards the slip at the nodes.
pub(crate) struct CarriedSlip<const D: usize> {
    /// What was carried, moved with the facets.
    pushed: Vec<[f64; D]>,
    /// Σ c N Δ and Σ c N.
    increments: Vec<Vector<D>>,
    areas: Vec<f64>,
}

impl<const D: usize> CarriedSlip<D> {
    /// Moves what was carried to where the facets are now.
    pub(crate) fn new(surface: &Surface<D>, step: &Step<D>, coords: &[[f64; D]]) -> Self {
        let count = coords.len();
        let points = surface.points(coords);
        let (mut sums, mut weights) = (vec![Vector::<D>::zeros(); count], vec![0.0; count]);
        for vertices in &surface.facets {
            let carries = |v: u32| surface.nodes_of_vertex(v).any(|(node, _)| step.slip[node as usize] != [0.0; D]);
            if !vertices.iter().any(|&v| carries(v)) {
                continue;
            }
            let corners = vertices.map(|v| points[v as usize]);
            let starts = vertices.map(|v| step.points[v as usize]);
            let Some(frame) = FacetFrame::new(&corners, &starts) else { continue };
            let measure = area_vector(&corners).norm();
            for &vertex in vertices {
                for (node, part) in surface.nodes_of_vertex(vertex) {
                    let n = node as usize;
                    sums[n] += frame.deformation * Vector::from(step.slip[n]) * (measure * part);
                    weights[n] += measure * part;
                }
            }
        }
        let pushed: Vec<[f64; D]> = (sums.iter().zip(&weights))
            .map(|(sum, &weight)| if weight > 0.0 { (sum / weight).into() } else { [0.0; D] })
            .collect();
        Self { pushed, increments: vec![Vector::zeros(); count], areas: vec![0.0; count] }
    }

    /// Adds the points of a pair.
    pub(crate) fn add(&mut self, points: &SlipPoints<D>, node_count: usize) {
        for (point, rows, traction) in points.tractions() {
            for of_b in [false, true] {
                if !point.carries[usize::from(of_b)] {
                    continue;
                }
                let sign = if of_b { -1.0 } else { 1.0 };
                let own = || {
                    let of_side = rows.iter().filter(|row| row.of_b == of_b);
                    let sum = of_side.fold(Vector::zeros(), |sum, row| {
                        sum + Vector::from(self.pushed[row.node as usize]) * row.shape
                    });
                    (sum - point.normal * point.normal.dot(&sum)) * sign
                };
                let before = if traction.sliding.is_some() { own() } else { point.carried };
                let increment = (traction.elastic - before) * sign;
                for row in rows.iter().filter(|row| row.of_b == of_b && (row.node as usize) < node_count) {
                    let weight = point.area * row.shape;
                    self.increments[row.node as usize] += increment * weight;
                    self.areas[row.node as usize] += weight;
                }
            }
        }
    }

    /// The slip at the nodes; none where nothing is in contact.
    pub(crate) fn at_nodes(self) -> Vec<[f64; D]> {
        let sums = self.pushed.iter().zip(&self.increments).zip(&self.areas);
        sums.map(|((&pushed, increment), &area)| {
            if area > 0.0 { (Vector::from(pushed) + increment / area).into() } else { [0.0; D] }
        })
        .collect()
    }
}
