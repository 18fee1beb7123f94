//! Contact points of all line families together, for the second derivative of the sampled volume.
//!
//! With consistent weights V = Σ ω L over the lines of K families, ω being 1/K of the volume per length of one alone.
//! As a sum over spans it has the Hessian of [`ContactPoints`] with ψ' = 1, ψ'' = 0. Parts with winding numbers above 1
//! count once here; valid contact has none.

use crate::Error;
use crate::overlap::lines::layout::FiberPair;
use crate::overlap::normal_lines::patches::partition::Patches;
use crate::overlap::normal_lines::points::contact_points::ContactPoints;

impl<const D: usize> FiberPair<'_, D> {
    /// The spans of the standard families, or `None` where the sides are apart.
    pub(crate) fn volume_points(&self) -> Result<Option<ContactPoints<D>>, Error> {
        let part = 1.0 / self.families.len() as f64;
        self.with_layout(1.0, |layout| {
            let found = self.for_each_bundle(layout, |bundle| {
                let mut spans = Vec::new();
                self.visit_spans(bundle, layout, bundle.family_index() as u32, |sampled| {
                    let mut span = sampled.point;
                    span.weight *= part * self.pair.weight_between(&span.ends);
                    spans.push(span);
                })?;
                Ok(spans)
            })?;
            let directions = self.families.iter().map(|family| *family.direction()).collect();
            Ok(ContactPoints {
                patches: Patches { directions, ..Patches::default() },
                points: found.into_iter().flatten().collect(),
                ..ContactPoints::default()
            })
        })
    }
}
