//! Nodes that move as parts of rigid bodies.

use super::error::StaticsError;
use crate::fem::Constraints;
use std::collections::BTreeSet;

/// What moves rigidly, beside what supports hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Rigid<const D: usize> {
    /// Degrees of freedom, `node * D + axis`, that move by the same way, whatever it is: each list ascending. No list shares one with another or with a support.
    pub joined: Vec<Vec<usize>>,
    /// Degrees of freedom that follow others, each of its own; none is joined or held.
    pub followers: Vec<Follower>,
    /// Nodes that turn about a centre.
    pub carried: Vec<Carried<D>>,
}

/// A degree of freedom that others move: u = Σ w u_j + c. What it bears these bear, each by its weight.
#[derive(Clone, Debug, PartialEq)]
pub struct Follower {
    /// The degree of freedom, `node * D + axis`.
    pub freedom: usize,
    /// What it follows, each with its weight; none of these follows others.
    pub of: Vec<(usize, f64)>,
    /// c at the end of a stage; `None` where it stays as it was when the stage began.
    pub apart: Option<f64>,
}

impl Follower {
    /// Σ w u_j.
    pub(super) fn followed<const D: usize>(&self, displacement: &[[f64; D]]) -> f64 {
        let all = displacement.as_flattened();
        self.of.iter().map(|&(freedom, weight)| weight * all[freedom]).sum()
    }

    /// c at a displacement.
    pub(super) fn apart_at<const D: usize>(&self, displacement: &[[f64; D]]) -> f64 {
        displacement.as_flattened()[self.freedom] - self.followed(displacement)
    }
}

impl<const D: usize> Default for Rigid<D> {
    fn default() -> Self {
        Self { joined: Vec::new(), followers: Vec::new(), carried: Vec::new() }
    }
}

/// Nodes that a rigid motion carries: supports hold all of their degrees of freedom at its end. On the way each is on its arc, and not on its chord.
#[derive(Clone, Debug, PartialEq)]
pub struct Carried<const D: usize> {
    /// The nodes.
    pub nodes: Vec<usize>,
    /// About what they turn, undeformed.
    pub centre: [f64; D],
    /// Where the stage begins, and where it ends.
    pub ends: [RigidMotion<D>; 2],
}

/// A translation and a rotation vector: an axis times an angle in radians. In 2D only its third component is not 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion<const D: usize> {
    /// How the centre moves.
    pub translation: [f64; D],
    /// φ.
    pub rotation: [f64; 3],
}

impl<const D: usize> RigidMotion<D> {
    /// Displacement at an arm from the centre: t + (exp φ̂ − 1) a, by Rodrigues' formula.
    pub fn finite(&self, arm: [f64; D]) -> [f64; D] {
        let angle = self.rotation.iter().map(|x| x * x).sum::<f64>().sqrt();
        if angle == 0.0 {
            return self.translation;
        }
        let half = (0.5 * angle).sin() / angle;
        let once = cross(self.rotation, in_space(arm));
        let twice = cross(self.rotation, once);
        std::array::from_fn(|k| self.translation[k] + angle.sin() / angle * once[k] + 2.0 * half * half * twice[k])
    }

    /// The same for small rotations: t + φ × a.
    pub fn small(&self, arm: [f64; D]) -> [f64; D] {
        let turned = cross(self.rotation, in_space(arm));
        std::array::from_fn(|k| self.translation[k] + turned[k])
    }

    /// A part of the way to another.
    fn towards(&self, other: &Self, part: f64) -> Self {
        let between = |p: f64, q: f64| p + part * (q - p);
        Self {
            translation: std::array::from_fn(|k| between(self.translation[k], other.translation[k])),
            rotation: std::array::from_fn(|k| between(self.rotation[k], other.rotation[k])),
        }
    }
}

impl<const D: usize> Carried<D> {
    /// Puts the nodes where they are at a part of the stage; `coords` are those of the undeformed bodies.
    pub(super) fn place(&self, coords: &[[f64; D]], part: f64, displacement: &mut [[f64; D]]) {
        let motion = self.ends[0].towards(&self.ends[1], part);
        for &node in &self.nodes {
            displacement[node] = motion.finite(std::array::from_fn(|k| coords[node][k] - self.centre[k]));
        }
    }
}

impl<const D: usize> Rigid<D> {
    /// Whether the same degrees of freedom are joined and follow, by the same weights.
    pub(super) fn joins_as(&self, other: &Self) -> bool {
        let follows = |(a, b): (&Follower, &Follower)| a.freedom == b.freedom && a.of == b.of;
        self.joined == other.joined
            && self.followers.len() == other.followers.len()
            && self.followers.iter().zip(&other.followers).all(follows)
    }

    /// # Errors
    /// [`StaticsError::Joined`].
    pub(super) fn check(&self, node_count: usize, supports: &Constraints<D>) -> Result<(), StaticsError> {
        let mut is_taken = vec![false; node_count * D];
        supports.iter().for_each(|(node, axis, _)| is_taken[node * D + axis] = true);
        for list in &self.joined {
            let mut last = None;
            for &freedom in list {
                let is_new = is_taken.get_mut(freedom).is_some_and(|taken| !std::mem::replace(taken, true));
                if !is_new || last.replace(freedom).is_some_and(|last| last >= freedom) {
                    return Err(StaticsError::Joined { node: freedom / D, axis: freedom % D });
                }
            }
        }
        for follower in &self.followers {
            let freedom = follower.freedom;
            if is_taken.get_mut(freedom).is_none_or(|taken| std::mem::replace(taken, true)) {
                return Err(StaticsError::Joined { node: freedom / D, axis: freedom % D });
            }
        }
        let follows: BTreeSet<usize> = self.followers.iter().map(|follower| follower.freedom).collect();
        for &(freedom, weight) in self.followers.iter().flat_map(|follower| &follower.of) {
            if follows.contains(&freedom) || freedom >= is_taken.len() || !weight.is_finite() {
                return Err(StaticsError::Joined { node: freedom / D, axis: freedom % D });
            }
        }
        for carried in &self.carried {
            let free = carried.nodes.iter().flat_map(|&node| (0..D).map(move |axis| (node, axis)));
            if let Some((node, axis)) = { free }.find(|&(node, axis)| !supports.contains(node, axis)) {
                return Err(StaticsError::Joined { node, axis });
            }
        }
        Ok(())
    }
}

/// A vector of the plane as one of space.
fn in_space<const D: usize>(v: [f64; D]) -> [f64; 3] {
    std::array::from_fn(|k| v.get(k).copied().unwrap_or(0.0))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A third of a turn about the diagonal takes x to y; in the plane, a quarter takes x to y. Rounding.
    #[test]
    fn rotations_are_those_of_closed_forms() {
        let third = 2.0 / 3.0 * std::f64::consts::PI / 3f64.sqrt();
        let motion = RigidMotion { translation: [1.0, 0.0, 0.0], rotation: [third; 3] };
        let moved = motion.finite([2.0, 0.0, 0.0]);
        assert!([-1.0, 2.0, 0.0].iter().zip(moved).all(|(e, u)| (e - u).abs() < 1e-15), "{moved:?}");
        let motion = RigidMotion { translation: [0.0; 2], rotation: [0.0, 0.0, 0.5 * std::f64::consts::PI] };
        let moved = motion.finite([3.0, 0.0]);
        assert!([-3.0, 3.0].iter().zip(moved).all(|(e, u)| (e - u).abs() < 1e-15), "{moved:?}");
        let small = RigidMotion { translation: [0.0; 2], rotation: [0.0, 0.0, 1e-9] };
        assert!(small.finite([3.0, 0.0]).iter().zip(small.small([3.0, 0.0])).all(|(p, q)| (p - q).abs() < 1e-17));
    }
}
