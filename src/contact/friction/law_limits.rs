//! Limits of the facets of a pair by a law of the host.
//!
//! The facets come with the mean pressure p as their limit, and rows with what A p changes by. With the limit τ(p, g), g the slip of the step,
//! at a fixed area A:
//!
//! ```text
//! d(A τ) = ∂τ/∂p d(A p) + A ∂τ/∂g · dg
//! ```
//!
//! What a facet bore when the step began is taken along the tangent of the law at the end: exact for limits that grow in proportion to
//! the pressure, or not at all.

use super::bore::Bore;
use super::law::{FrictionFacets, Limits, OwnLimit};
use super::slip_facets::{SlipFacet, SlipFacets};
use super::step::Sliding;
use super::touch::Bearing;
use super::traction::Stick;
use crate::Error;
use crate::geometry::Vector;

/// Sine of the angle between normal and x axis below which the z axis is projected: 6°.
const ALONG_X: f64 = 0.1;

impl<const D: usize> SlipFacets<D> {
    /// Gives all facets the limits of the law, in place of their pressures, and says at which force they slide together. `fields` are sums over
    /// the facets, weighted by area.
    ///
    /// # Errors
    /// [`Error::FrictionLaw`].
    pub(super) fn take_limits(
        &mut self,
        (sliding, asked): (&Sliding<D>, OwnLimit),
        fields: &[f64],
        bore: Bore,
    ) -> Result<Bore, Error> {
        let Self { partners, facets, rows, .. } = self;
        let (count, per_facet) = (facets.len(), asked.own.count);
        let axes: Vec<Vector<D>> = facets.iter().flat_map(|facet| axes_of(&facet.normal)).collect();
        let along = |of: &dyn Fn(&SlipFacet<D>) -> Vector<D>| -> Vec<f64> {
            let by_facet = facets.iter().zip(axes.chunks(D - 1));
            by_facet
                .flat_map(|(facet, axes)| axes.iter().map(|axis| axis.dot(&of(facet))).collect::<Vec<_>>())
                .collect()
        };
        let mut history = Vec::with_capacity(count * per_facet);
        for facet in facets.iter() {
            let known = sliding.step.slip.get(&(*partners, facet.of_b, facet.facet)).map(|carried| &*carried.history);
            match known.filter(|known| known.len() == per_facet) {
                Some(known) => history.extend_from_slice(known),
                None => history.resize(history.len() + per_facet, 0.0),
            }
        }
        let answer = Limits::of(
            &*asked.own.law,
            &FrictionFacets {
                partners: *partners,
                dim: D,
                count,
                time_step: asked.time_step,
                stiffness: match sliding.stick {
                    Stick::Spring(stiffness) => stiffness,
                    Stick::Memoryless(_) => 0.0,
                },
                facets: &facets.iter().map(|facet| facet.facet).collect::<Vec<_>>(),
                pressures: &facets.iter().map(|facet| facet.slider.limit).collect::<Vec<_>>(),
                slips: &along(&|facet| facet.slip),
                trials: &along(&|facet| facet.trial),
                axes: &axes.iter().flat_map(|axis| axis.iter().copied()).collect::<Vec<_>>(),
                positions: &facets.iter().flat_map(|facet| facet.position.iter().copied()).collect::<Vec<_>>(),
                areas: &facets.iter().map(|facet| facet.area).collect::<Vec<_>>(),
                history: &history,
                field_count: asked.fields.count,
                fields,
            },
        )?;
        let mut all = Bore { pressed: 0.0, cohesion: 0.0, ..bore };
        for (at, (facet, axes)) in facets.iter_mut().zip(axes.chunks(D - 1)).enumerate() {
            let (limit, by_pressure, pressure) = (answer.limits[at], answer.by_pressure[at], facet.slider.limit);
            let parts = axes.iter().zip(&answer.by_slip[at * (D - 1)..]);
            let by_slip = parts.fold(Vector::zeros(), |sum, (axis, part)| sum + axis * *part);
            let (area, Bearing { depth, whole, .. }) = (facet.area, facet.bearing);
            let pressed = area * by_pressure * pressure;
            let now = Bore { area, depth: depth * whole, pressed, cohesion: area * limit - pressed };
            for row in &mut rows[facet.rows.clone()] {
                row.limit = row.limit * by_pressure + row.slip.transpose() * by_slip * area;
            }
            facet.slider.limit = limit;
            let before =
                sliding.bearing(&(*partners, facet.of_b, facet.facet)).filter(|_| facet.before.limit.is_some());
            facet.before.limit = before.map(|(before, _)| (now.limit_before(&before) / area).max(0.0));
            facet.history = answer.history[at * per_facet..][..per_facet].to_vec();
            all.pressed += now.pressed;
            all.cohesion += now.cohesion;
        }
        Ok(all)
    }
}

/// Axes in the plane of a normal.
fn axes_of<const D: usize>(normal: &Vector<D>) -> Vec<Vector<D>> {
    if D == 2 {
        return vec![Vector::from_fn(|i, _| if i == 0 { -normal[1] } else { normal[0] })];
    }
    let unit = |axis: usize| Vector::<D>::from_fn(|i, _| f64::from(u8::from(i == axis)));
    let within = |axis: usize| unit(axis) - normal * normal[axis];
    let first = if within(0).norm() < ALONG_X { within(2) } else { within(0) }.normalize();
    let second = Vector::from_fn(|i, _| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        normal[j] * first[k] - normal[k] * first[j]
    });
    vec![first, second]
}
