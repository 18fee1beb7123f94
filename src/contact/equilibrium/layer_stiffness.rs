//! Stiffness of the contact from that of the bodies.

use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::Contact;
use crate::contact::partners::LayerStiffness;
use crate::interfaces::CohesiveLaw;
use crate::overlap::Partner;

/// Stiffness of a tie by that of contact, where the layers of cells give both. A tie neither opens nor locks; where several meet, nodes that
/// stand for little of their area are the softer by that, and multipliers take the longer.
const TIED: f64 = 16.0;

impl<const D: usize> Contact<D> {
    /// Sets how stiff the layers of cells below the surfaces are, `None`: forgets it. Where the law of the options has a stiffness of 0,
    /// each pair without a law of its own has then the one that suits the softer of its two layers.
    ///
    /// # Errors
    /// [`Error::Length`] for another number of bodies, [`Error::NotPositive`], [`Error::BodyOutOfRange`],
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`]. What was set before then stays.
    #[inline(never)]
    pub fn set_layer_stiffness(&mut self, stiffness: Option<LayerStiffness>) -> Result<(), Error> {
        changes::options::set_layer_stiffness(self, stiffness)
    }

    /// The same for bodies that have become others. How far surfaces are moved out, and elastic slip, stay lengths: with the bodies' own
    /// forces, those of contact become others. What a load bore before says nothing of the next one.
    pub(crate) fn take_layer_stiffness(&mut self, stiffness: LayerStiffness) -> Result<(), Error> {
        self.set_layer_stiffness(Some(stiffness))?;
        self.history.last = None;
        Ok(())
    }

    /// Stiffness k of the law that a pair follows, pressure by penetration; 0 where there is none yet.
    pub(crate) fn stiffness_of_pair(&self, mut pair: [Partner; 2]) -> f64 {
        pair.sort_unstable();
        self.partners.law_of(&pair, &self.method).initial_stiffness().unwrap_or(0.0)
    }

    /// Stiffness of a tie, or of bodies that do not separate: that of the pair where it was given, else several times as much.
    pub(crate) fn stiffness_of_tie(&self, pair: [Partner; 2]) -> f64 {
        self.stiffness_of_pair(pair) * if self.is_tie_stiffness_given(pair) { 1.0 } else { TIED }
    }

    /// Whether that was given: a host may want a tie to give way.
    pub(super) fn is_tie_stiffness_given(&self, mut pair: [Partner; 2]) -> bool {
        pair.sort_unstable();
        self.partners.table.law(&pair).is_some() || !self.method.options().law.is_without_stiffness()
    }

    /// By row of coordinates the largest stiffness by area of what may press or pull there: of the laws of its body's pairs, which ties and
    /// bodies that do not separate have too, and of a cohesive interface that the row moves. Damage makes an interface no stiffer;
    /// a law of the host is asked without a jump. `body`: of every row, where it has one.
    pub(crate) fn stiffness_by_row(&self, body: &[Option<usize>]) -> Vec<f64> {
        let has_stiffer = self.has_ties() && self.method.options().law.is_without_stiffness();
        let factor = if has_stiffer { TIED } else { 1.0 };
        let of_body = |body| {
            let laws = self.partners.laws_of(body, &self.method);
            factor * laws.filter_map(|law| law.initial_stiffness()).fold(0.0, f64::max)
        };
        let of_bodies: Vec<f64> = (0..self.surface().body_count()).map(of_body).collect();
        let mut by_row: Vec<f64> = body.iter().map(|body| body.map_or(0.0, |body| of_bodies[body])).collect();
        if !self.has_history() {
            return by_row;
        }
        let weights = self.mesh.surface.point_weights();
        // One that is not on this mesh is an error of every evaluation.
        let cohesive = self
            .cohesions
            .all()
            .flatten()
            .map(|(cohesion, (options, _))| (&cohesion.nodes, CohesiveLaw::new(options).largest_stiffness()));
        let undeformed = self.mesh.placed(self.mesh.surface.reference().into());
        let governed = self.at_points(&undeformed, |at| self.governed.there(at)).unwrap_or_default();
        let governed = governed.iter().map(|(held, at, _)| (&held.points.nodes, at.largest_stiffness()));
        for (nodes, most) in cohesive.chain(governed) {
            for &node in nodes {
                for (row, weight) in weights.row(node as usize) {
                    let stiffness = &mut by_row[row as usize];
                    *stiffness = if weight == 0.0 { *stiffness } else { stiffness.max(most) };
                }
            }
        }
        by_row
    }

    /// Whether an obstacle has edges.
    pub(crate) fn has_edges(&self, obstacle: usize) -> bool {
        self.partners.obstacles.get(obstacle).is_some_and(|rigid| rigid.obstacle.shape.has_edges())
    }

    /// Whether any pair has friction.
    pub fn has_friction(&self) -> bool {
        self.partners.has_friction(self.method.options())
    }

    /// What was set.
    pub fn layer_stiffness(&self) -> Option<&LayerStiffness> {
        self.partners.layer_stiffness()
    }
}
