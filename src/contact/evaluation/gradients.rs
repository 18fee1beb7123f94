//! Derivatives of energy and forces.

use super::measured::measured_pairs;
use super::parts::Contact;
use super::points::Points;
use super::sliding::check_ready;
use super::slip_facets::slip_facets_in;
use super::walk::for_each_pair;
use crate::Error;
use crate::contact::derivatives::{GradientRequest, Gradients, Seeds, SlipSeeds, State, add_answers, add_sliders};
use crate::contact::laws::{Asked, Measured};
use crate::contact::tangents::TangentPart;
use crate::overlap::{DepthSeeds, Partner, depth_slopes};

/// The derivatives at points of the straight mesh; `adjoint` has those of the forces by unknown, or is empty, `slip` those of the elastic slip
/// at the end of the step.
pub(super) fn gradients_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    energy: f64,
    adjoint: &[f64],
    slip: &SlipSeeds,
    request: &GradientRequest,
) -> Result<Gradients<D>, Error> {
    check_ready(contact)?;
    check_known(contact, request, !slip.is_empty())?;
    if !slip.is_empty() && (request.needs_tangent() || request.reference) {
        let what = "the derivative of the slip at the end of a step by coordinates, poses and gap offsets";
        return Err(Error::Unsupported { what });
    }
    let Contact { mesh, partners, method, history, .. } = contact;
    let rows: Vec<[f64; D]> = adjoint.chunks_exact(D).map(|row| std::array::from_fn(|i| row[i])).collect();
    let expected = mesh.surface.unknown_count();
    if !adjoint.is_empty() && (rows.len() != expected || adjoint.len() != expected * D) {
        return Err(Error::Length { array: "adjoint", expected: expected * D, found: adjoint.len() });
    }
    if let Some(entry) = adjoint.iter().position(|entry| !entry.is_finite()) {
        return Err(Error::NonFiniteStiffness { array: "adjoint", entry });
    }
    let points = if adjoint.is_empty() { None } else { Some(mesh.surface.mesh_points(&rows)?) };
    let seeds = Seeds { energy, forces: points.as_deref(), slip };
    let obstacles = partners.obstacles.count();
    let mut found = Gradients { coords: vec![[0.0; D]; coords.len()], ..Gradients::default() };
    if request.positions {
        found.positions = vec![[0.0; D]; obstacles];
    }
    if request.rotations {
        found.rotations = vec![[0.0; 3]; obstacles];
    }
    if request.needs_answers() {
        let tangent = (request.needs_tangent() && seeds.forces.is_some()).then_some(TangentPart::Full);
        let rotations = request.rotations && obstacles > 0 && tangent.is_some();
        let asked = Asked { energy: true, tangent, rotations, limited: request.friction, ..Asked::default() };
        let (answers, tractions) = measured_pairs(contact, coords, &asked)?;
        let is_kept = |pair: &[Partner; 2]| history.patches.of(pair).is_some();
        let state = state_of(contact, &is_kept);
        add_answers((partners, method), (&answers, &tractions), (&seeds, request, &state), &mut found)?;
    }
    if request.slip || seeds.reaches_friction() && (request.stiffness || request.friction && !slip.is_empty()) {
        add_sliders((partners, method), &slip_facets_in(contact, coords)?, (&seeds, request), &mut found)?;
    }
    if !request.coords {
        found.coords = Vec::new();
    }
    if request.reference {
        found.reference = by_reference(contact, coords, &seeds)?;
    }
    found.checked()
}

/// Refuses what the whole contact has no derivatives of.
pub(super) fn check_known<const D: usize>(
    contact: &Contact<D>,
    request: &GradientRequest,
    of_slip: bool,
) -> Result<(), Error> {
    let of_slip = request.slip || of_slip;
    let by_others = request.reference || request.stiffness || request.gap_offsets || request.friction || of_slip;
    let refused = |what| Err(Error::Unsupported { what });
    if contact.has_ties() && by_others {
        return refused("a derivative with bodies that are tied or do not separate, but by coordinates and poses");
    }
    if !contact.cohesions.is_empty() {
        return refused("derivatives with a cohesive interface");
    }
    if !contact.governed.is_empty() {
        return refused("derivatives with an interface by your own law");
    }
    if request.rotations && contact.method.options().axisymmetric && contact.partners.obstacles.count() > 0 {
        return refused("the derivative by rotations of obstacles with axisymmetry");
    }
    if of_slip && contact.history.frozen.is_some() {
        return refused("derivatives by and of the slip between steps while friction is frozen");
    }
    Ok(())
}

/// What decides whether its tangent is a derivative.
pub(super) fn state_of<'a, const D: usize>(
    contact: &Contact<D>,
    is_kept: &'a dyn Fn(&[Partner; 2]) -> bool,
) -> State<'a> {
    let (is_frozen, may_be_curved) = (contact.history.frozen.is_some(), contact.mesh.may_be_curved());
    State { is_kept, is_frozen, may_be_curved }
}

/// The derivative by the reference coordinates: of pairs of bodies by the law `depth`, since no other has anything of them.
fn by_reference<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    seeds: &Seeds<D>,
) -> Result<Vec<[f64; D]>, Error> {
    let Contact { mesh, work, .. } = contact;
    let cells = for_each_pair(contact, coords, |measured| {
        if !depends_on_reference(contact, measured)? {
            return Ok(None);
        }
        let sharing = work.within_pair(false);
        let Some(slopes) = mesh.reference_slopes(&|| sharing.check()) else { return Ok(None) };
        let k = measured.law.initial_stiffness().unwrap_or(0.0);
        let of_pair = depth_slopes(measured.pair, slopes, &DepthSeeds { energy: seeds.energy, motion: seeds.forces })?;
        Ok(Some((of_pair, k)))
    })?;
    let mut all = Vec::new();
    for (of_pair, k) in cells {
        all.extend(of_pair.into_iter().map(|cell| cell.times(k)));
    }
    let sharing = work.within_pair(false);
    Ok(match mesh.reference_slopes(&|| sharing.check()).filter(|_| !all.is_empty()) {
        Some(slopes) => slopes.by_reference(&mesh.surface, &all),
        None => vec![[0.0; D]; coords.len()],
    })
}

/// Whether a pair depends on the reference coordinates, in a way that can be differentiated.
fn depends_on_reference<const D: usize>(contact: &Contact<D>, measured: &Measured<D>) -> Result<bool, Error> {
    let Contact { mesh, partners, method, work, .. } = contact;
    let rubs = partners.friction_of(&measured.pair.partners, method.options()).is_active();
    if matches!(measured.pair.partners[1], Partner::Obstacle(_)) || !measured.law.needs_depth() && !rubs {
        return Ok(false);
    }
    let refused = |what| Err(Error::Unsupported { what });
    match measured.law.needs_depth() {
        _ if rubs && !measured.law.is_local() => refused("the derivative of friction by reference coordinates"),
        false => Ok(false),
        true if !method.weighting().is_plain() => refused("the derivative by reference coordinates with axisymmetry"),
        true if mesh.may_be_curved() => refused("the derivative by reference coordinates of curved faces"),
        true if mesh.surface.submesh.is_some() || work.ranks().is_some() => {
            refused("the derivative by reference coordinates on several ranks")
        }
        true if mesh.surface.cells.as_ref().is_some_and(|cells| !cells.hanging().is_empty()) => {
            refused("the derivative by reference coordinates of a mesh with hanging nodes")
        }
        true => Ok(true),
    }
}
