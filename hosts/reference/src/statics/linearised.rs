//! Contact as the theory of small displacements has it.

use crate::fem::{Model, Part};
use fmc_contact::{ContactForces, EnergyLaw, Obstacle, Shape};

/// Contact in the plane whose gap is taken where the surface was, and whose force acts along y: u_y at x against the height of an
/// obstacle at x. Closed forms of indentation assume this; bodies in truth move sideways and turn.
///
/// ```text
/// w = Σ ω ψ(L)      L = u_y − gap(x)      over Gauss points of the faces that look up
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Linearised {
    points: Vec<Point>,
}

/// A place on the surface.
#[derive(Clone, Debug, PartialEq)]
struct Point {
    part: usize,
    nodes: [usize; 2],
    weights: [f64; 2],
    /// Length of surface for which it stands.
    measure: f64,
    /// Way along y to the obstacle.
    gap: f64,
}

/// Gauss points and weights of order 4 on [0, 1]: exact for the energy of faces that touch wholly.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

impl Linearised {
    /// Faces of all bodies that look along +y, under the polygons among the obstacles. `None` in 3D, if an obstacle is no
    /// polygon, or for cells of second order.
    pub fn new<const D: usize>(model: &Model<D>, obstacles: &[Obstacle<D>]) -> Option<Self> {
        let is_straight = |part: &Part<D>| part.cell_type == part.cell_type.straight();
        if D != 2 || !model.parts().iter().all(is_straight) {
            return None;
        }
        let mut edges = Vec::new();
        for obstacle in obstacles {
            let Shape::Polytope { points, facets } = &obstacle.shape else { return None };
            let at = |corner: u32| {
                let x = points[corner as usize];
                let turned = obstacle.pose.rotation.map(|row| (0..D).map(|i| row[i] * x[i]).sum::<f64>());
                [turned[0] + obstacle.pose.position[0], turned[1] + obstacle.pose.position[1]]
            };
            edges.extend(facets.iter().map(|facet| [at(facet[0]), at(facet[1])]));
        }
        let mut points = Vec::new();
        for part in 0..model.parts().len() {
            for face in model.faces_where(part, |_| true) {
                let nodes = [face.nodes[0] as usize, face.nodes[1] as usize];
                let [p, q] = nodes.map(|node| model.coords()[node]);
                // The body is on the left of its faces: those that look up run against x.
                let run = p[0] - q[0];
                if run <= 0.5 * (p[0] - q[0]).hypot(p[1] - q[1]) {
                    continue;
                }
                for (s, part_of) in GAUSS {
                    let weights = [1.0 - s, s];
                    let [x, y] = [0, 1].map(|i| weights[0] * p[i] + weights[1] * q[i]);
                    if let Some(gap) = lowest(&edges, x).map(|height| height - y) {
                        points.push(Point { part, nodes, weights, measure: part_of * run, gap });
                    }
                }
            }
        }
        Some(Self { points })
    }

    fn length<const D: usize>(point: &Point, u: &[[f64; D]]) -> f64 {
        point.weights[0] * u[point.nodes[0]][1] + point.weights[1] * u[point.nodes[1]][1] - point.gap
    }

    /// The points that press at a displacement, and how deep each is.
    fn pressed<const D: usize>(&self, u: &[[f64; D]]) -> impl Iterator<Item = (&Point, f64)> {
        self.points.iter().map(|point| (point, Self::length(point, u))).filter(|(_, length)| *length > 0.0)
    }

    /// Adds energy and forces at a displacement.
    pub(super) fn add_to<const D: usize>(&self, touch: &mut ContactForces<D>, law: &EnergyLaw, u: &[[f64; D]]) {
        let mut touched = None;
        for (point, length) in self.pressed(u) {
            touch.energy += point.measure * law.energy(length);
            touch.penetration = touch.penetration.max(length);
            touch.contact_area += point.measure;
            touch.facet_count += usize::from(touched.replace(point.nodes) != Some(point.nodes));
            let force = point.measure * law.energy_gradient(length);
            for (node, weight) in point.nodes.iter().zip(point.weights) {
                touch.forces[*node][1] -= weight * force;
                touch.bodies[point.part].force[1] -= weight * force;
            }
        }
    }

    /// Adds the forces against which bodies press to theirs, at a displacement; the energy.
    pub(super) fn add_forces<const D: usize>(&self, forces: &mut [[f64; D]], law: &EnergyLaw, u: &[[f64; D]]) -> f64 {
        let mut energy = 0.0;
        for (point, length) in self.pressed(u) {
            energy += point.measure * law.energy(length);
            let force = point.measure * law.energy_gradient(length);
            point.nodes.iter().zip(point.weights).for_each(|(node, weight)| forces[*node][1] += weight * force);
        }
        energy
    }

    /// Second derivative of the energy at a displacement: row, column and value.
    pub(super) fn tangent<'a, const D: usize>(
        &'a self,
        law: &'a EnergyLaw,
        u: &'a [[f64; D]],
    ) -> impl Iterator<Item = (usize, usize, f64)> + 'a {
        self.pressed(u).flat_map(move |(point, length)| {
            let stiffness = point.measure * law.energy_hessian(length);
            (0..4).map(move |k| {
                let (a, b) = (k / 2, k % 2);
                let value = stiffness * point.weights[a] * point.weights[b];
                (point.nodes[a] * D + 1, point.nodes[b] * D + 1, value)
            })
        })
    }
}

/// Height at which a line along y first meets polygons from below.
fn lowest(edges: &[[[f64; 2]; 2]], x: f64) -> Option<f64> {
    let crossed = edges.iter().filter(|[p, q]| (p[0] - x) * (q[0] - x) <= 0.0 && p[0] != q[0]);
    crossed.map(|[p, q]| p[1] + (q[1] - p[1]) * (x - p[0]) / (q[0] - p[0])).reduce(f64::min)
}
