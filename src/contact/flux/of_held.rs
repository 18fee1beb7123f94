//! What flows through surfaces that are tied, slide on one another or are glued.

use super::conductance::Conductance;
use super::shares::Shares;
use crate::geometry::{Surface, Vector, Weighting};
use crate::interfaces::{Cohesion, CohesionAt, FacingSurfaces, Glide, GlideAt, Governed, GovernedAt, Tie, normal_of};
use crate::overlap::Block;
use std::collections::BTreeMap;

/// Where surfaces are held.
pub(crate) struct HeldSurfaces<'a, const D: usize> {
    pub(crate) surface: &'a Surface<D>,
    /// On the mesh without deformation.
    pub(crate) reference: &'a [Vector<D>],
    pub(crate) now: &'a [Vector<D>],
    pub(crate) weighting: Weighting,
}

/// The derivative of the flux out of the nodes by the field, by the area without deformation. The pressure is that part of the tie's tractions
/// which presses; a gap that the tie keeps is none.
pub(crate) fn of_tie<const D: usize>(
    tie: &Tie<D>,
    tractions: &[Vector<D>],
    of: &HeldSurfaces<D>,
    conductance: &Conductance,
) -> Vec<Block<1>> {
    let [a, b] = tie.facets.clone();
    let facets = if tie.is_second { [b, a] } else { [a, b] };
    let surfaces = FacingSurfaces::new(of.surface, of.reference, of.weighting, facets, [-tie.reach, tie.reach]);
    let of_point: BTreeMap<u32, &Vector<D>> = tie.rows.iter().map(|row| row.point).zip(tractions).collect();
    // Tractions are those on the other side, which is pressed along the normal of this one.
    over_pieces(of, &surfaces, conductance, |node, normal| Some(of_point.get(&node)?.dot(normal)))
}

/// The same of bodies that slide and do not separate, where they face one another now, by the area there.
pub(crate) fn of_glide<const D: usize>(
    glide: &Glide<D>,
    at: &GlideAt<D>,
    of: &HeldSurfaces<D>,
    conductance: &Conductance,
) -> Vec<Block<1>> {
    let between = &glide.first.between;
    let [a, b] = match &between.facets {
        Some(facets) => facets.each_ref().map(|facets| facets.to_vec()),
        None => between.bodies.map(|body| of.surface.ranges[body].clone().collect()),
    };
    let (facets, reach) = (if glide.first.is_second { [b, a] } else { [a, b] }, glide.first.reach);
    let surfaces = FacingSurfaces::new(of.surface, of.now, of.weighting, facets, [-reach, reach]);
    let of_point: BTreeMap<u32, f64> =
        glide.rows.iter().map(|row| row.point).zip(at.tractions.iter().copied()).collect();
    over_pieces(of, &surfaces, conductance, |node, _| of_point.get(&node).map(|traction| -traction))
}

/// Over the common pieces of surfaces that touch, with the pressure by point of the first side, where there is one, given the facet's normal.
fn over_pieces<const D: usize>(
    of: &HeldSurfaces<D>,
    surfaces: &FacingSurfaces<D>,
    conductance: &Conductance,
    pressure: impl Fn(u32, &Vector<D>) -> Option<f64>,
) -> Vec<Block<1>> {
    let mut shares = Shares::default();
    for facets in surfaces.candidates(false) {
        let normal = normal_of(of.surface, of.now, facets[0]);
        surfaces.for_each_point(facets, 0.0, |point| {
            let hats = surfaces.straight(facets[0], &point.places[0]);
            let pressed: f64 = hats.iter().filter_map(|(node, hat)| Some(hat * pressure(*node, &normal)?)).sum();
            let [near, far] = [0, 1].map(|side| surfaces.shape(facets[side], &point.places[side]));
            shares.add(conductance.pressed(pressed.max(0.0)) * point.measure, &near, &far);
        });
        shares.end_part();
    }
    shares.into_sum().into_blocks()
}

/// The same of a cohesive interface, by the area without deformation: what is whole conducts as a tie does, what is broken as surfaces that
/// touch or are as far apart as they have opened, and the damage says how much is which.
pub(crate) fn of_cohesion<const D: usize>(
    cohesion: &Cohesion<D>,
    at: &CohesionAt<D>,
    conductance: &Conductance,
) -> Vec<Block<1>> {
    over_points(
        cohesion,
        conductance,
        at.points().map(|(_, state)| [state.now().damage, state.pressure(), state.opening]),
    )
}

/// The same of an interface by a law of the host: as surfaces that touch or are as far apart as it has opened.
pub(crate) fn of_governed<const D: usize>(
    held: &Governed<D>,
    at: &GovernedAt<D>,
    conductance: &Conductance,
) -> Vec<Block<1>> {
    let count = held.points.points.len();
    let state = |number: usize| [1.0, (-at.traction(number)[0]).max(0.0), at.jump(number)[0]];
    over_points(&held.points, conductance, (0..count).map(state))
}

/// By damage, pressure and opening of every point.
fn over_points<const D: usize>(
    interface: &Cohesion<D>,
    conductance: &Conductance,
    states: impl Iterator<Item = [f64; 3]>,
) -> Vec<Block<1>> {
    let mut shares = Shares::default();
    let mut moved: Vec<u32> = Vec::new();
    for (point, [damage, pressure, opening]) in interface.points.iter().zip(states) {
        let [own, other] = interface.sides(point);
        let nodes = || own.iter().chain(&other).map(|(node, _)| *node);
        if !nodes().eq(moved.iter().copied()) {
            shares.end_part();
            moved = nodes().collect();
        }
        let whole = conductance.pressed(pressure);
        let broken = if opening > 0.0 { conductance.apart(opening) } else { whole };
        shares.add(((1.0 - damage) * whole + damage * broken) * point.measure, &own, &other);
    }
    shares.into_sum().into_blocks()
}
