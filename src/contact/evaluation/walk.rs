//! The pairs that may overlap.

use super::bring::with_state;
use super::layer::layer;
use super::parts::Contact;
use super::state::State;
use crate::Error;
use crate::contact::laws::Measured;
use crate::contact::partners::Partners;
use crate::overlap::{Counterpart, ImplicitSide, Offset, Pair, Partner};
use crate::ranks::on_threads_of;
use rayon::prelude::*;
use std::sync::OnceLock;

/// Calls `work` for all pairs whose boxes meet, on the threads of the options, and returns its results in the order
/// of the pairs.
pub(crate) fn for_each_pair<const D: usize, T: Send>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    work: impl Fn(&Measured<D>) -> Result<Option<T>, Error> + Sync,
) -> Result<Vec<T>, Error> {
    for_each_pair_within(contact, coords, 0.0, work)
}

/// The same for all pairs whose boxes are no farther apart than `reach` along every axis.
pub(crate) fn for_each_pair_within<const D: usize, T: Send>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    reach: f64,
    work: impl Fn(&Measured<D>) -> Result<Option<T>, Error> + Sync,
) -> Result<Vec<T>, Error> {
    with_state(contact, coords, |state| {
        let pairs = pairs(contact, state, reach, layer(contact));
        let work = |partners: &[Partner; 2]| with_pair(contact, state, *partners, &work);
        // Ranks meet in every pair, one pair after the other.
        let Some(pool) = contact.work.pool().filter(|_| contact.work.ranks().is_none()) else {
            return pairs.iter().filter_map(|partners| work(partners).transpose()).collect();
        };
        // A signed distance function, or a law of friction, belongs to the host and is called on the calling thread.
        let is_marched = |partners: &[Partner; 2]| {
            contact.partners.is_marched(partners) || contact.partners.friction_law(partners).is_some()
        };
        let mut found: Vec<Option<Result<Option<T>, Error>>> = on_threads_of(pool, contact.work.interrupt(), || {
            pairs.par_iter().map(|partners| (!is_marched(partners)).then(|| work(partners))).collect()
        });
        for (partners, found) in pairs.iter().zip(&mut found).filter(|(_, found)| found.is_none()) {
            *found = Some(work(partners));
        }
        found.into_iter().flatten().filter_map(Result::transpose).collect()
    })
}

/// Partners that are not left out and whose boxes meet, or nearly do, ascending: for every body itself (if asked for),
/// later bodies, obstacles.
fn pairs<const D: usize>(contact: &Contact<D>, state: &State<D>, reach: f64, layer: f64) -> Vec<[Partner; 2]> {
    let Contact { mesh, partners, method, history, .. } = contact;
    let table = &partners.table;
    let mut pairs = Vec::new();
    let meeting = state.configuration.meeting_bodies(reach.max(layer));
    let mut next = meeting.iter().peekable();
    for i in 0..mesh.surface.body_count() {
        let itself = [Partner::Body(i); 2];
        if table.has(&itself, method.options().self_contact) {
            pairs.push(itself);
        }
        while let Some((_, j)) = next.next_if(|(first, _)| *first == i) {
            let pair = [Partner::Body(i), Partner::Body(*j)];
            if table.has(&pair, true) {
                pairs.push(pair);
            }
        }
        let aabb = state.configuration.body_box(i).inflated(reach);
        for (o, (rigid, placed)) in partners.obstacles.iter().zip(&state.placed).enumerate() {
            let pair = [Partner::Body(i), Partner::Obstacle(o)];
            let Some(rigid) = rigid else { continue };
            let out = table.gap_offset(&pair).max(0.0);
            if table.has(&pair, true) && rigid.may_meet(placed.as_ref(), &aabb.inflated(out)) {
                pairs.push(pair);
            }
        }
    }
    pairs.retain(|pair| !history.let_apart.contains(pair));
    pairs
}

fn with_pair<const D: usize, T>(
    contact: &Contact<D>,
    state: &State<D>,
    partners: [Partner; 2],
    work: impl Fn(&Measured<D>) -> Result<Option<T>, Error>,
) -> Result<Option<T>, Error> {
    let Contact { mesh, partners: Partners { obstacles, table, .. }, method, history, .. } = contact;
    let State { configuration, placed, found } = state;
    let Partner::Body(first) = partners[0] else { return Ok(None) };
    let a = configuration.body(&mesh.surface, first);
    let rigid = match partners[1] {
        Partner::Obstacle(o) => obstacles.get(o),
        Partner::Body(_) => None,
    };
    let pose = rigid.map(|rigid| &rigid.obstacle.pose);
    let parallel = table.parallel(&partners).zip(pose);
    let parallel = parallel.map(|(parallel, pose)| (&parallel.shape, parallel.pose(pose)));
    let counterpart = match (partners[1], rigid) {
        (Partner::Body(second), _) if second == first => {
            if !a.may_cross_itself() && mesh.surface.is_one_sheet(first) {
                return Ok(None);
            }
            Counterpart::Itself
        }
        (Partner::Body(second), _) => Counterpart::Facets(configuration.body(&mesh.surface, second)),
        (Partner::Obstacle(obstacle), Some(rigid)) => match (&parallel, &placed[obstacle], rigid.solid().implicit()) {
            (Some((shape, pose)), placed, _) => {
                let by = table.gap_offset(&partners);
                let offset = placed.as_ref().map(|placed| Offset { of: rigid.side(placed), by });
                Counterpart::Implicit(ImplicitSide { obstacle, shape, pose, offset })
            }
            (None, Some(placed), _) => Counterpart::Facets(rigid.side(placed)),
            (None, None, Some(shape)) => {
                Counterpart::Implicit(ImplicitSide { obstacle, shape, pose: &rigid.obstacle.pose, offset: None })
            }
            // What has facets alone is placed before pairs are.
            (None, None, None) => return Ok(None),
        },
        (Partner::Obstacle(_), None) => return Ok(None),
    };
    let sharing = contact.work.within_pair(counterpart.is_marched());
    sharing.check();
    let law = contact.partners.law_of(&partners, method);
    // Friction asks for depths with a law that has no points of its own.
    let is_rubbed = !law.is_local() && contact.partners.friction_of(&partners, method.options()).is_active();
    let weighting = method.weighting();
    let depth = if law.needs_depth() || is_rubbed { mesh.depth_field(weighting, &|| sharing.check()) } else { None };
    let clearance = if parallel.is_some() { 0.0 } else { -table.gap_offset(&partners) };
    let tied = match (depth, partners[1]) {
        (Some(field), Partner::Body(second)) => {
            let is_curved = |body| field.curves().is_some_and(|curves| curves.height(body) > 0.0);
            let tied = mesh.tied(field, [first, second]);
            if tied.is_some() && (is_curved(first) || is_curved(second)) {
                let what = "curved faces of bodies that named parts of their surfaces hold together";
                return Err(Error::Unsupported { what });
            }
            tied
        }
        _ => None,
    };
    let (surface, coords, region) = (&mesh.surface, configuration.coords(), OnceLock::new());
    let pair =
        Pair { partners, a, counterpart, pose, surface, coords, depth, clearance, tied, weighting, sharing, region };
    let kept = history.patches.of(&partners);
    work(&Measured { pair: &pair, law, estimator: &method.estimator, kept, found })
}
