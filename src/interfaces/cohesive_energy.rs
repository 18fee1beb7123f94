//! The energy of a cohesive interface at some coordinates, stored and dissipated, and its derivatives.
//!
//! With the traction t_n along the normal, the stiffness k of sliding and d(a·n) = n·da + a·dn
//!
//! ```text
//! dE = t·da + c a·dn         t = t_n n + k δ_t,   c = t_n − k a·n
//! d²E = k (da·da − d(a·n)²) + t_n′ d(a·n)² + c d²(a·n) − dY dd
//! ```
//!
//! where the last is there while damage d grows. It is not symmetric where the energy of fracture depends on the mode, which then changes
//! as the interface opens on. Friction of the broken part adds its own (`broken_friction`).

use super::broken_friction::{ByNode, Edges, Rub};
use super::cohesion::{Cohesion, CohesivePoint};
use super::cohesive_law::CohesiveLaw;
use super::frame::{Frame, Matrix};
use super::place::Weights;
use super::point_state::{PointDamage, PointHistory, PointState, Response};
use super::square::{Square, mixed};
use crate::geometry::Vector;
use crate::overlap::{Block, BlockSum};

/// What is asked of the second derivative of a cohesive interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Softened {
    /// All of it.
    All,
    /// Its symmetric part.
    Symmetric,
    /// At the damage there is, without what the turning of facets adds.
    Secant,
}

/// A cohesive interface at some coordinates.
pub(crate) struct CohesionAt<'a, const D: usize> {
    cohesion: &'a Cohesion<D>,
    frames: Vec<Frame<D>>,
    /// None without friction, or without area.
    edges: Vec<Option<Edges<D>>>,
    states: Vec<PointAt<D>>,
    stiffness: [f64; 2],
}

/// A point of it.
pub(crate) struct PointAt<const D: usize> {
    /// a, and its part along the normal.
    apart: Vector<D>,
    along: f64,
    response: Response,
    /// Friction of the broken part, and its stiffness.
    rub: Option<Rub<D>>,
    rub_stiffness: f64,
    pub(crate) opening: f64,
    pub(crate) sliding: Vector<D>,
    /// Of the second body on the first, a force by area, with its sign turned: positive along the normal of the second in tension.
    pub(crate) traction: Vector<D>,
}

impl<const D: usize> PointAt<D> {
    pub(crate) fn now(&self) -> PointDamage {
        self.response.now.damage
    }

    pub(crate) fn history(&self) -> PointHistory {
        self.response.now.history
    }

    pub(crate) fn state(&self) -> PointState {
        self.response.now
    }

    /// What presses here, by area.
    pub(crate) fn pressure(&self) -> f64 {
        (-self.response.normal).max(0.0)
    }

    pub(crate) fn stored(&self) -> f64 {
        let of_stick = self.rub.map_or(0.0, |rub| 0.5 * self.rub_stiffness * rub.elastic.norm_squared());
        self.response.stored + of_stick
    }
}

/// What friction of the broken part has dissipated in the step, by area and by the stiffness: the part that slides is that of the middle of
/// the step, and what has broken since takes what its stick stores.
fn rubbed<const D: usize>(rub: &Rub<D>, [before, now]: [f64; 2]) -> f64 {
    0.5 * (before + now) * rub.elastic.norm() * rub.slid() - 0.5 * (now - before) * rub.elastic.norm_squared()
}

impl<const D: usize> Cohesion<D> {
    /// At these points of the mesh, after what its points have been through (`&[]`: nothing). A facet that has collapsed has no normal: its
    /// points then only slide.
    pub(crate) fn at(&self, points: &[[f64; D]], law: &CohesiveLaw, past: &[PointState]) -> CohesionAt<'_, D> {
        let x: Vec<Vector<D>> = self.nodes.iter().map(|&node| Vector::from(points[node as usize])).collect();
        let sum = |weights: &Weights| {
            weights.iter().fold(Vector::<D>::zeros(), |sum, &(node, weight)| sum + x[node as usize] * weight)
        };
        let frame = |corners: &[Weights; D]| Frame::new(&corners.each_ref().map(sum)).unwrap_or_else(Frame::none);
        let frames: Vec<_> = self.frames.iter().map(frame).collect();
        let edges: Vec<_> = match law.friction {
            Some(_) => self.frames.iter().map(|corners| Edges::new(&corners.each_ref().map(sum))).collect(),
            None => Vec::new(),
        };
        let at = |(number, point): (usize, &CohesivePoint)| {
            let (apart, normal) = (sum(&point.jump), frames[point.frame as usize].normal);
            let along = apart.dot(&normal);
            let (opening, sliding) = (along - point.gap, apart - normal * along);
            let past = past.get(number).copied().unwrap_or_default();
            let mut response = law.response(&past, opening, sliding.norm_squared());
            let mut traction = normal * response.normal + sliding * response.shear_stiffness;
            let edges = edges.get(point.frame as usize).and_then(Option::as_ref);
            let rub = edges.zip(law.pressed(opening));
            let rub = rub.map(|(edges, pressed)| Rub::new(edges, &sliding, past.history.slip, pressed));
            let PointState { damage, history } = &mut response.now;
            let rub_stiffness = if rub.is_some() { damage.damage * law.stiffness[1] } else { 0.0 };
            if let Some(rub) = &rub {
                history.slip = rub.slip;
                history.rubbed += law.stiffness[1] * rubbed(rub, [past.damage.damage, damage.damage]);
                traction += rub.elastic * rub_stiffness;
            }
            PointAt { apart, along, response, rub, rub_stiffness, opening, sliding, traction }
        };
        let states = self.points.iter().enumerate().map(at).collect();
        CohesionAt { cohesion: self, frames, edges, states, stiffness: law.stiffness }
    }
}

impl<const D: usize> CohesionAt<'_, D> {
    /// The points with their states.
    pub(crate) fn points(&self) -> impl Iterator<Item = (&CohesivePoint, &PointAt<D>)> {
        self.cohesion.points.iter().zip(&self.states)
    }

    /// Energy that unloading would give back, and that has been dissipated: as it broke, by friction and by viscosity.
    pub(crate) fn energies(&self) -> [f64; 4] {
        self.points().fold([0.0; 4], |sums, (point, at)| {
            let PointHistory { rubbed, viscous, .. } = at.history();
            let of_point = [at.stored(), at.now().dissipated, rubbed, viscous];
            std::array::from_fn(|k| sums[k] + point.measure * of_point[k])
        })
    }

    /// Derivative of the energy by the nodes of the interface.
    pub(crate) fn gradient(&self) -> Vec<Vector<D>> {
        let mut gradient = vec![Vector::zeros(); self.cohesion.nodes.len()];
        let mut loads = vec![Vector::<D>::zeros(); self.frames.len()];
        let mut at_corners = vec![[Vector::<D>::zeros(); D]; if self.edges.is_empty() { 0 } else { self.frames.len() }];
        for (point, at) in self.points() {
            let traction = at.traction * point.measure;
            point.jump.iter().for_each(|&(node, weight)| gradient[node as usize] += traction * weight);
            loads[point.frame as usize] += at.apart * (point.measure * at.turning());
            if let Some(rub) = at.rub.filter(|_| at.rub_stiffness > 0.0) {
                let rubbing = rub.elastic * (point.measure * at.rub_stiffness);
                loads[point.frame as usize] -= rubbing * at.along;
                for corner in 1..D {
                    let force = rubbing * rub.slip[corner - 1];
                    at_corners[point.frame as usize][corner] -= force;
                    at_corners[point.frame as usize][0] += force;
                }
            }
        }
        for (corners, forces) in self.cohesion.frames.iter().zip(&at_corners) {
            for (corner, force) in corners.iter().zip(forces) {
                corner.iter().for_each(|&(node, weight)| gradient[node as usize] += force * weight);
            }
        }
        for (number, load) in loads.iter().enumerate() {
            for (corner, slope) in self.cohesion.frames[number].iter().zip(&self.frames[number].slopes) {
                let force = Vector::<D>::from_fn(|j, _| (0..D).map(|i| load[i] * slope[i][j]).sum());
                corner.iter().for_each(|&(node, weight)| gradient[node as usize] += force * weight);
            }
        }
        gradient
    }

    /// The second derivative, by points of the mesh.
    pub(crate) fn curvature(&self, which: Softened) -> Vec<Block<D>> {
        let (mut sum, mut square) = (BlockSum::default(), Square::default());
        for (point, at) in self.points() {
            // The points of a piece move the same nodes.
            if !square.is_of(point) {
                square.hand_over(&self.cohesion.nodes, &mut sum);
                square = Square::of(point, &self.cohesion.frames[point.frame as usize]);
            }
            let edges = self.edges.get(point.frame as usize).and_then(Option::as_ref);
            square.add(point, at, (&self.frames[point.frame as usize], edges, self.stiffness), which);
        }
        square.hand_over(&self.cohesion.nodes, &mut sum);
        sum.into_blocks()
    }
}

impl<const D: usize> PointAt<D> {
    /// c, by which a turning facet works.
    fn turning(&self) -> f64 {
        self.response.normal - self.response.shear_stiffness * self.along
    }
}

impl<const D: usize> Square<D> {
    fn add(
        &mut self,
        point: &CohesivePoint,
        at: &PointAt<D>,
        (frame, edges, full): (&Frame<D>, Option<&Edges<D>>, [f64; 2]),
        which: Softened,
    ) {
        let (count, weights) = (self.nodes.len(), self.weights(point));
        let slopes: Vec<Matrix<D>> = self.corners.iter().map(|shares| mixed(shares, &frame.slopes)).collect();
        let (normal, apart, response) = (&frame.normal, &at.apart, &at.response);
        // d(a·n), and half the derivative of the squared sliding.
        let turned = |slope: &Matrix<D>| Vector::<D>::from_fn(|j, _| (0..D).map(|i| apart[i] * slope[i][j]).sum());
        let along: Vec<Vector<D>> = (0..count).map(|k| normal * weights[k] + turned(&slopes[k])).collect();
        let sliding: Vec<Vector<D>> = (0..count).map(|k| apart * weights[k] - along[k] * at.along).collect();
        let of_all = |k: usize| along[k] * (full[0] * at.opening.max(0.0)) + sliding[k] * full[1];
        let growth = response.growth.filter(|_| which != Softened::Secant);
        let coupled = response.coupled.filter(|_| which != Softened::Secant);
        let (energy, damage): (Vec<Vector<D>>, Vec<Vector<D>>) = match growth {
            Some([by_all, by_sliding]) => {
                (0..count).map(|k| (of_all(k), of_all(k) * by_all + sliding[k] * (full[1] * by_sliding))).unzip()
            }
            None => (Vec::new(), Vec::new()),
        };
        if let Some((rub, edges)) = at.rub.as_ref().zip(edges).filter(|_| at.now().damage > 0.0) {
            let by = ByNode { jump: &weights, corners: &self.corners, slopes: &slopes, along: &along, damage: &damage };
            let broken = [at.now().damage, full[1]];
            let found = match which {
                Softened::Secant => rub.secant(&by, normal, broken),
                _ => rub.curvature(&by, (frame, edges), at.along, broken),
            };
            self.add_all(&found, point.measure, which == Softened::Symmetric);
        }
        let (shear, turning) = (response.shear_stiffness, at.turning());
        let bent: Vec<Matrix<D>> = match which {
            Softened::Secant => Vec::new(),
            _ => (0..D * D).map(|k| frame.second(apart, [k / D, k % D])).collect(),
        };
        for r in 0..count {
            for c in 0..count {
                let value = &mut self.values[r * count + c];
                for i in 0..D {
                    for j in 0..D {
                        let plain = if i == j { weights[r] * weights[c] } else { 0.0 };
                        let normals = along[r][i] * along[c][j];
                        let mut entry = shear * plain + response.normal_stiffness * normals;
                        if which == Softened::Secant {
                            entry -= shear * weights[r] * weights[c] * normal[i] * normal[j];
                        } else {
                            let crossed = weights[r] * slopes[c][i][j] + weights[c] * slopes[r][j][i];
                            entry += turning * crossed - shear * normals;
                        }
                        if let Some([nn, nt, tn, tt]) = coupled {
                            let of = |r: usize, c: usize, i: usize, j: usize| {
                                along[r][i] * (nn * along[c][j] + nt * sliding[c][j])
                                    + sliding[r][i] * (tn * along[c][j] + tt * sliding[c][j])
                            };
                            entry += match which {
                                Softened::All => of(r, c, i, j),
                                _ => 0.5 * (of(r, c, i, j) + of(c, r, j, i)),
                            };
                        }
                        if growth.is_some() {
                            entry -= match which {
                                Softened::All => energy[r][i] * damage[c][j],
                                _ => 0.5 * (energy[r][i] * damage[c][j] + damage[r][i] * energy[c][j]),
                            };
                        }
                        value[i][j] += point.measure * entry;
                    }
                }
                for (k, second) in bent.iter().enumerate() {
                    let share = point.measure * turning * self.corners[r][k / D] * self.corners[c][k % D];
                    if share != 0.0 {
                        (0..D).for_each(|i| (0..D).for_each(|j| value[i][j] += share * second[i][j]));
                    }
                }
            }
        }
    }
}

impl<const D: usize> Square<D> {
    /// Adds what friction does, or its symmetric part.
    fn add_all(&mut self, found: &[Matrix<D>], measure: f64, is_symmetric: bool) {
        let count = self.nodes.len();
        for (place, value) in self.values.iter_mut().enumerate() {
            let other = &found[place % count * count + place / count];
            for i in 0..D {
                for j in 0..D {
                    let own = found[place][i][j];
                    value[i][j] += measure * if is_symmetric { 0.5 * (own + other[j][i]) } else { own };
                }
            }
        }
    }
}
