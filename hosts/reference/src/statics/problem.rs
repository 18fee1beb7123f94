//! What a solution is sought for.

use super::linearised::Linearised;
use super::rigid::Rigid;
use crate::fem::{Constraints, Model};
use fmc_contact::contact::PairOptions;
use fmc_contact::{Obstacle, Options};

/// Bodies, what holds and drives them, and how they touch. Arrays are `[node_count, D]`.
pub struct Problem<const D: usize> {
    /// The bodies.
    pub model: Model<D>,
    /// Energy law and estimator of the contact.
    pub contact: Options,
    /// Pairs of parts that are left out, tied, or have a law or a friction of their own; twice the same part is its self-contact.
    pub pairs: Vec<([usize; 2], PairOptions)>,
    /// Parts of the surface that pairs may name, numbered from 1: faces of the model, each by its nodes in any order.
    pub surfaces: Vec<Vec<Vec<u32>>>,
    /// Rigid partners; they do not move.
    pub obstacles: Vec<Obstacle<D>>,
    /// Contact with the obstacles as small displacements see it, in the place of the other.
    pub linearised: Option<Linearised>,
    /// Degrees of freedom that are held, and their displacements at full load.
    pub supports: Constraints<D>,
    /// What moves rigidly.
    pub rigid: Rigid<D>,
    /// Dead forces on the nodes at full load; empty for none.
    pub load: Vec<[f64; D]>,
    /// Planes of symmetry, each by a point and a normal: faces in them are no surface.
    pub symmetry_planes: Vec<[[f64; D]; 2]>,
    /// Gaps up to the first length are closed and overlaps up to the second removed before all else, without strain.
    pub adjust: Option<[f64; 2]>,
}

impl<const D: usize> Problem<D> {
    /// Bodies that are free and without loads.
    pub fn new(model: Model<D>, contact: Options) -> Self {
        Self {
            model,
            contact,
            pairs: Vec::new(),
            surfaces: Vec::new(),
            obstacles: Vec::new(),
            linearised: None,
            supports: Constraints::default(),
            rigid: Rigid::default(),
            load: Vec::new(),
            symmetry_planes: Vec::new(),
            adjust: None,
        }
    }
}
