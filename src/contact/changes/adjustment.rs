//! Gaps closed and overlaps removed without strain, where bodies stand.

use crate::Error;
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::mesh::Offsets;
use crate::geometry::Vector;
use crate::overlap::Partner;
use std::collections::BTreeSet;

/// Passes over all points: both sides of a pair go half of the way, which leaves half of a mean of means each time.
const PASSES: usize = 12;

/// Gap of bodies that are held together, by the lengths to be closed and removed, that is none: what meshes that do not match leave.
const CLOSED: f64 = 1e-3;

/// What is as large as was said may be larger by rounding.
const ROUNDED: f64 = 1.0 + 1e-6;

/// What was closed and removed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Adjustment {
    /// Largest mean gap of a point that was closed, a length.
    pub closed: f64,
    /// Largest mean overlap of a point that was removed, a length.
    pub removed: f64,
    /// Largest mean gap or overlap that these points have now, a length: what a mean at points leaves between meshes that do not match.
    pub left: f64,
    /// Number of points that were moved.
    pub count: usize,
}

/// See [`Contact::adjust`].
pub(crate) fn adjust<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    close: f64,
    remove: f64,
) -> Result<Adjustment, Error> {
    Error::check_not_negative("close", close)?;
    Error::check_not_negative("remove", remove)?;
    contact.mesh.surface.refuse_submesh("offsets of a part of a mesh")?;
    refuse_held(contact, CLOSED * close.max(remove))?;
    let before = contact.mesh.offsets().clone();
    let found = adjusted(contact, coords, close, remove);
    let after = contact.mesh.replace_offsets(before);
    let found = found?;
    replace(contact, after);
    Ok(found)
}

/// Refuses bodies that are held together across a larger gap, which they keep: nothing would be closed.
fn refuse_held<const D: usize>(contact: &Contact<D>, gap: f64) -> Result<(), Error> {
    let Contact { ties, glides, cohesions, governed, .. } = contact;
    let ties = ties.all().flatten().filter(|(tie, _)| tie.period == Vector::<D>::zeros());
    let ties = ties.map(|(tie, _)| (tie.bodies, tie.largest_gap));
    let glides = glides.all().flatten().map(|(glide, _)| &glide.first);
    let glides = glides.map(|first| (first.between.bodies, first.largest_gap));
    let governed = governed.all().flatten().map(|(governed, _)| &governed.points);
    let points = cohesions.all().flatten().map(|(cohesion, _)| cohesion).chain(governed);
    let points = points.map(|cohesion| (cohesion.bodies, cohesion.largest_gap));
    match ties.chain(glides).chain(points).find(|(_, kept)| *kept > gap) {
        Some((bodies, _)) if gap > 0.0 => Err(Error::OfPair {
            sides: bodies.map(|body| ("body", body)),
            cause: Box::new(Error::Unsupported {
                what: "an adjustment of bodies that are held together already, and keep their gap: adjust first, then tie or glue them",
            }),
        }),
        _ => Ok(()),
    }
}

/// The same on the contact itself, which the caller puts back where this fails.
fn adjusted<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    close: f64,
    remove: f64,
) -> Result<Adjustment, Error> {
    let mut found = Adjustment::default();
    let reach = close.max(remove);
    if reach == 0.0 {
        return Ok(found);
    }
    let count = contact.mesh.points(coords)?.len();
    let mut chosen = BTreeSet::new();
    for pass in 0..=PASSES {
        let gaps = kernels::gap_constraints(contact, coords, 1.001 * reach)?;
        let mut moves = vec![(0.0, Vector::<D>::zeros()); count];
        found.left = 0.0;
        for row in 0..gaps.gaps.len() {
            let (node, partners, area) = (gaps.nodes[row], gaps.partners[row], gaps.areas[row]);
            let away = Vector::from(gaps.away[row]);
            if !(area > 0.0 && away.norm() > 0.0) {
                continue;
            }
            let mean = gaps.gaps[row] / area;
            let most = if mean > 0.0 { close } else { remove };
            if pass == 0 && mean != 0.0 && mean.abs() <= ROUNDED * most {
                chosen.insert((node, partners));
                (found.closed, found.removed) = (found.closed.max(mean), found.removed.max(-mean));
            }
            if chosen.contains(&(node, partners)) {
                let share = if matches!(partners[1], Partner::Body(_)) { 0.5 } else { 1.0 };
                moves[node as usize].0 += area;
                moves[node as usize].1 -= away.normalize() * (share * mean * area);
                found.left = found.left.max(mean.abs());
            }
        }
        if pass < PASSES {
            let mut vectors = contact.mesh.offsets().list(count);
            for (vector, (area, sum)) in vectors.iter_mut().zip(&moves).filter(|(_, (area, _))| *area > 0.0) {
                (0..D).for_each(|axis| vector[axis] += sum[axis] / area);
            }
            contact.mesh.replace_offsets(Offsets::new(vectors, count)?);
        }
    }
    found.count = chosen.iter().map(|(node, _)| node).collect::<BTreeSet<_>>().len();
    Ok(found)
}

/// See [`Contact::set_offsets`].
pub(crate) fn set<const D: usize>(contact: &mut Contact<D>, offsets: &[[f64; D]]) -> Result<(), Error> {
    if !offsets.is_empty() {
        contact.mesh.surface.refuse_submesh("offsets of a part of a mesh")?;
    }
    let offsets = Offsets::new(offsets.to_vec(), contact.mesh.surface.point_weights().point_count())?;
    replace(contact, offsets);
    Ok(())
}

/// Has the surface lie elsewhere. No body slides by that: the step that has begun, and frozen friction, begin where it lies now.
fn replace<const D: usize>(contact: &mut Contact<D>, offsets: Offsets<D>) {
    contact.mesh.replace_offsets(offsets);
    super::options::find_interfaces_again(contact);
    let Contact { mesh, history, state, .. } = contact;
    for step in history.step.iter_mut().chain(history.first_touches.steps_mut()) {
        step.place(&mesh.surface, |points| mesh.placed(points.into()));
    }
    if let Some(frozen) = &mut history.frozen {
        frozen.coords.place(|points| mesh.placed(points.into()));
    }
    state.forget_found();
}
