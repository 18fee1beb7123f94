//! Where nothing of a body may be missing.

use super::layer::layer;
use super::parts::Contact;
use crate::Error;
use crate::configuration::BodyTree;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::shapes::{Faces, ImplicitShape};
use crate::overlap::{ImplicitSide, Partner, obstacle_region};

/// Where nothing of a body may be missing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Needed<const D: usize> {
    pub(crate) aabb: Aabb<D>,
    /// A point from which facets are seen: those are needed for which the two together reach into the box.
    pub(crate) apex: Option<Vector<D>>,
}

/// By body, where nothing of it may be missing if the bodies have these boxes.
///
/// # Errors
/// [`Error::SignedDistance`].
pub(crate) fn needed<const D: usize>(
    contact: &Contact<D>,
    boxes: &[Aabb<D>],
    reach: f64,
) -> Result<Vec<Vec<Needed<D>>>, Error> {
    let Contact { partners, method, .. } = contact;
    let table = &partners.table;
    let reach = reach.max(layer(contact));
    let mut needed: Vec<Vec<Needed<D>>> = vec![Vec::new(); boxes.len()];
    let whole = |aabb: Aabb<D>| Needed { aabb, apex: None };
    let mut bodies = BodyTree::default();
    bodies.update(boxes.iter().copied());
    for (i, j) in bodies.meeting(reach) {
        if table.has(&[Partner::Body(i), Partner::Body(j)], true) {
            needed[i].push(whole(boxes[i].intersection(&boxes[j].inflated(reach))));
            needed[j].push(whole(boxes[j].intersection(&boxes[i].inflated(reach))));
        }
    }
    for (body, aabb) in boxes.iter().enumerate() {
        if table.has(&[Partner::Body(body); 2], method.options().self_contact) {
            needed[body].push(whole(*aabb));
        }
        for obstacle in 0..partners.obstacles.count() {
            needed[body].extend(needed_below(contact, (body, aabb), obstacle, reach)?);
        }
    }
    Ok(needed)
}

/// The same for a body and an obstacle.
fn needed_below<const D: usize>(
    contact: &Contact<D>,
    (body, aabb): (usize, &Aabb<D>),
    obstacle: usize,
    reach: f64,
) -> Result<Option<Needed<D>>, Error> {
    let (partners, method) = (&contact.partners, &contact.method);
    let pair = [Partner::Body(body), Partner::Obstacle(obstacle)];
    let Some(rigid) = partners.obstacles.get(obstacle).filter(|_| partners.table.has(&pair, true)) else {
        return Ok(None);
    };
    let parallel = partners.table.parallel(&pair);
    let own = &rigid.obstacle.pose;
    let (shape, mut pose) = match parallel {
        Some(parallel) => (Some(&parallel.shape), parallel.pose(own)),
        None => (rigid.solid().implicit(), *own),
    };
    let has_depth =
        partners.law_of(&pair, method).needs_depth() || partners.friction_of(&pair, method.options()).is_active();
    let faces = if parallel.is_none() || has_depth { rigid.solid().faces() } else { None };
    let is_half_space = shape.is_some_and(ImplicitShape::is_half_space);
    let within = match (shape, faces) {
        // The depth below their faces is summed along lines that run through all of the body.
        (_, Some(_)) if has_depth => Some(*aabb),
        (_, Some(Faces { points, .. })) => {
            let placed: Vec<Vector<D>> = points.iter().map(|x| own.place(x)).collect();
            Some(Aabb::of(&placed).inflated(reach).intersection(aabb)).filter(|within| !within.is_empty())
        }
        (Some(shape), None) if is_half_space => {
            let Plane { normal, point } = Plane::of(&pose);
            pose.position = (point + normal * (reach + aabb.rounding())).into();
            obstacle_region(&ImplicitSide { obstacle, shape, pose: &pose, offset: None }, aabb)?
        }
        (Some(shape), None) if reach <= 0.0 => {
            obstacle_region(&ImplicitSide { obstacle, shape, pose: &pose, offset: None }, aabb)?
        }
        // How far it reaches is not known.
        (_, None) => Some(*aabb),
    };
    let apex = (!is_half_space).then(|| aabb.center());
    Ok(within.map(|aabb| Needed { aabb, apex }))
}
