//! Steps of a contact with friction: what is carried from one to the next.

use crate::Error;
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::friction::{Bearings, FrozenFriction, SlipFacets, Step};
use crate::geometry::Vector;

/// Begins a step at these coordinates. On an error nothing has changed.
pub(crate) fn begin<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.mesh.check_brought(coords)?;
    let surface = &contact.mesh.surface;
    surface.check_coords(&surface.mesh_points(coords)?, true)?;
    let before = contact.history.step.take();
    let none = || vec![[0.0; D]; surface.facets.len()];
    let slip = before.as_ref().map_or_else(none, |step| step.slip.clone());
    let mut begun = step_at(contact, coords, slip)?;
    // Without a stiffness nothing bears yet.
    let bears = contact.partners.check_stiffness(contact.method.options()).is_ok();
    if has_friction(contact) && bears {
        contact.history.step = Some(begun.clone());
        match kernels::slip_facets(contact, coords) {
            Ok(pairs) => begun.bearings = Some(bearings(&pairs)),
            Err(error) => {
                contact.history.step = before;
                return Err(error);
            }
        }
    }
    contact.history.begin(begun);
    Ok(())
}

/// Accepts the step that ends here, and begins the next. On an error nothing has changed.
pub(crate) fn commit<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.history.step()?;
    contact.mesh.check_brought(coords)?;
    let mut sums = vec![(0.0, Vector::<D>::zeros()); contact.mesh.surface.facets.len()];
    let pairs = kernels::slip_facets(contact, coords)?;
    for pair in &pairs {
        pair.for_each_elastic_slip(|facet, area, slip| {
            sums[facet].0 += area;
            sums[facet].1 += slip * area;
        });
    }
    // A facet that faces several partners carries the mean.
    let slip = sums.iter().map(|(area, sum)| if *area > 0.0 { (sum / *area).into() } else { [0.0; D] });
    let mut next = step_at(contact, coords, slip.collect())?;
    next.bearings = has_friction(contact).then(|| bearings(&pairs));
    contact.history.begin(next);
    Ok(())
}

/// Freezes the facets on which friction acts and their pressure. On an error what was frozen before stays.
pub(crate) fn freeze<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.history.step()?;
    let pairs = kernels::slip_facets(contact, coords)?;
    contact.mesh.check_brought(coords)?;
    let (points, poses) = (contact.mesh.surface.mesh_points(coords)?, contact.partners.obstacles.poses());
    contact.history.frozen = Some(FrozenFriction::new(pairs, &points, poses, contact.mesh.epoch()));
    Ok(())
}

/// A step that begins here.
fn step_at<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], slip: Vec<[f64; D]>) -> Result<Step<D>, Error> {
    let Contact { mesh, partners, .. } = contact;
    Ok(Step::new(&mesh.surface, &mesh.surface.mesh_points(coords)?, partners.obstacles.poses(), slip, mesh.epoch()))
}

fn has_friction<const D: usize>(contact: &Contact<D>) -> bool {
    contact.partners.has_friction(contact.method.options())
}

/// How all facets bear.
fn bearings<const D: usize>(pairs: &[SlipFacets<D>]) -> Bearings {
    let mut found = Bearings::new();
    pairs.iter().for_each(|pair| pair.add_bearings(&mut found));
    found
}
