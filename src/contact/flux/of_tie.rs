//! What flows through a tie.

use super::conductance::Conductance;
use super::shares::Shares;
use crate::geometry::{Surface, Vector, Weighting};
use crate::interfaces::{FacingSurfaces, Tie, normal_of};
use crate::overlap::Block;
use std::collections::BTreeMap;

/// Where both surfaces were tied: the mesh without deformation.
pub(crate) struct TiedSurfaces<'a, const D: usize> {
    pub(crate) surface: &'a Surface<D>,
    pub(crate) reference: &'a [Vector<D>],
    pub(crate) now: &'a [Vector<D>],
    pub(crate) weighting: Weighting,
}

/// The derivative of the flux out of the nodes by the field, by the area without deformation. The pressure is that part of the tie's tractions
/// which presses; a gap that the tie keeps is none.
pub(crate) fn of_tie<const D: usize>(
    tie: &Tie<D>,
    tractions: &[Vector<D>],
    of: &TiedSurfaces<D>,
    conductance: &Conductance,
) -> Vec<Block<1>> {
    let [a, b] = tie.facets.clone();
    let facets = if tie.is_second { [b, a] } else { [a, b] };
    let surfaces = FacingSurfaces::new(of.surface, of.reference, of.weighting, facets, [-tie.reach, tie.reach]);
    let of_point: BTreeMap<u32, &Vector<D>> = tie.rows.iter().map(|row| row.point).zip(tractions).collect();
    let mut shares = Shares::default();
    for facets in surfaces.candidates(false) {
        // Tractions are those on the other side, which is pressed along the normal of this one.
        let normal = normal_of(of.surface, of.now, facets[0]);
        surfaces.for_each_point(facets, 0.0, |point| {
            let hats = surfaces.straight(facets[0], &point.places[0]);
            let pressed = hats.iter().filter_map(|(node, hat)| Some(hat * of_point.get(node)?.dot(&normal)));
            let pressure: f64 = pressed.sum();
            let [near, far] = [0, 1].map(|side| surfaces.shape(facets[side], &point.places[side]));
            shares.add(conductance.pressed(pressure.max(0.0)) * point.measure, &near, &far);
        });
        shares.end_part();
    }
    shares.into_sum().into_blocks()
}
