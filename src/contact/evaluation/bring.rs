//! The bodies and obstacles brought to coordinates.

use super::agreed::hash_in_common;
use super::gathered::check_gathered;
use super::parts::Contact;
use super::state::State;
use crate::Error;
use crate::configuration::Configuration;
use crate::contact::laws::FoundPatches;
use crate::geometry::primitives::aabb::Aabb;
use crate::ranks::caught;

/// Calls `work` with the bodies at `coords`.
///
/// The first call takes what was kept; concurrent calls find nothing kept and start afresh, with the same result.
pub(crate) fn with_state<const D: usize, T>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    work: impl FnOnce(&State<D>) -> Result<T, Error>,
) -> Result<T, Error> {
    let mut state = contact.state.take();
    let brought = bring(contact, &mut state, coords)
        .and_then(|()| check_radii(contact, &state.configuration))
        .and_then(|()| check_gathered(contact, &state.configuration, coords));
    let result = match contact.work.ranks() {
        None => brought.and_then(|()| caught(contact.work.interrupt(), || work(&state))),
        Some(ranks) => {
            let begun = ranks.agree(brought, hash_in_common(contact, coords, std::any::type_name::<T>()));
            begun.and_then(|()| ranks.agree(work(&state), 0))
        }
    };
    contact.state.put(state);
    result
}

fn bring<const D: usize>(contact: &Contact<D>, state: &mut State<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    let Contact { mesh, partners, method, work, .. } = contact;
    let pool = work.pool();
    let update = |state: &mut State<D>| {
        state.configuration.update(&mesh.surface, coords, method.options().check_cells, pool.is_some())
    };
    let moved = match pool {
        Some(pool) => pool.install(|| update(state)),
        None => update(state),
    }?;
    if moved {
        state.found = FoundPatches::default();
    }
    let prefers_facets = method.estimator.prefers_facets();
    state.placed.resize_with(partners.obstacles.count(), || None);
    for (rigid, placed) in partners.obstacles.iter().zip(&mut state.placed) {
        match rigid {
            Some(rigid) => rigid.place(prefers_facets, placed),
            None => *placed = None,
        }
    }
    Ok(())
}

/// Checks, with axisymmetry, that no body reaches beyond the axis by more than rounding.
fn check_radii<const D: usize>(contact: &Contact<D>, configuration: &Configuration<D>) -> Result<(), Error> {
    let surface = &contact.mesh.surface;
    let boxes = || (0..surface.body_count()).map(|body| configuration.body_box(body));
    if contact.method.weighting().is_plain() || boxes().all(|aabb| aabb.min[0] >= 0.0) {
        return Ok(());
    }
    let rounding = boxes().fold(Aabb::empty(), |all, aabb| all.union(&aabb)).rounding();
    let radius = |node: usize| configuration.coords()[node][0];
    let mut nodes = surface.nodes.iter().map(|&node| node as usize);
    match nodes.find(|&node| radius(node) < -rounding) {
        Some(node) => Err(Error::NegativeRadius { node, radius: radius(node) }),
        None => Ok(()),
    }
}
