//! What decides how facets bear, beside where the sides are.

use super::pair_options::PairOptions;
use crate::contact::method::Options;
use crate::overlap::{Estimator, Partner};
use std::collections::BTreeMap;

/// Hashes of what a mesh has to do with it: another hash, another way to bear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MeshHashes {
    /// Of that from which depths are found: the coordinates without deformation, the nodes in planes of symmetry, and the angle up to
    /// which faces are smooth.
    pub(crate) depths: [u64; 3],
    /// Of how far the surface lies beside its nodes.
    pub(crate) offsets: u64,
}

/// By what the facets of a pair bear. While it is the same, they bear the same at the same places.
#[derive(Debug, PartialEq)]
pub(crate) struct BearingRule {
    /// The estimator of a local law; all others have depths, which need none.
    lines: Option<Estimator>,
    /// Which depths these are, of two bodies.
    depths: Option<[u64; 3]>,
    /// How far the surface lies beside its nodes.
    offsets: u64,
    gap_offset: f64,
    axisymmetric: bool,
}

impl BearingRule {
    /// That of a pair with these options of its own; `None` where there is no friction.
    pub(super) fn new(
        pair: &[Partner; 2],
        own: Option<PairOptions>,
        options: &Options,
        mesh: MeshHashes,
    ) -> Option<Self> {
        let is_evaluated = match own {
            Some(own) => own.is_in_contact(),
            None => pair[0] != pair[1] || options.self_contact,
        };
        let own = own.unwrap_or_default();
        let friction = own.friction(options.friction);
        let is_local = own.law.unwrap_or(options.law).is_fiber();
        let is_of_bodies = matches!(pair[1], Partner::Body(_));
        (is_evaluated && friction.is_active()).then_some(Self {
            lines: is_local.then_some(options.estimator),
            depths: (is_of_bodies && !is_local).then_some(mesh.depths),
            offsets: mesh.offsets,
            gap_offset: own.gap_offset,
            axisymmetric: options.axisymmetric,
        })
    }
}

/// Those of all pairs at one time.
#[derive(Clone)]
pub(crate) struct BearingRules {
    pub(super) of_pairs: BTreeMap<[Partner; 2], PairOptions>,
    pub(super) options: Options,
    pub(super) mesh: MeshHashes,
}

impl BearingRules {
    pub(crate) fn of(&self, pair: &[Partner; 2]) -> Option<BearingRule> {
        BearingRule::new(pair, self.of_pairs.get(pair).copied(), &self.options, self.mesh)
    }
}
