//! Ties beside the options of pairs.

use crate::Error;
use crate::contact::evaluation::Contact;
use crate::contact::laws::EnergyLaw;
use crate::contact::partners::PairOptions;
use crate::overlap::Partner;

/// Adds one; returns its number.
pub(crate) fn add<const D: usize>(
    contact: &mut Contact<D>,
    mut surfaces: [usize; 2],
    period: [f64; D],
    reach: f64,
) -> Result<usize, Error> {
    check_vector(contact, "period", &period)?;
    if !(reach.is_finite() && reach >= 0.0) {
        return Err(Error::NotPositive { name: "reach", value: reach });
    }
    let mut bodies = contact.mesh.bodies_of_surfaces(surfaces)?;
    // Pairs have the lower body first.
    let sign = if bodies[0] > bodies[1] { -1.0 } else { 1.0 };
    if sign < 0.0 {
        bodies.swap(0, 1);
        surfaces.swap(0, 1);
    }
    let mut between = contact.mesh.between(bodies, Some(surfaces), reach)?;
    if contact.mesh.surface.cells.is_none() {
        return Err(Error::Unsupported { what: "bodies that are tied, without cells" });
    }
    (0..D).for_each(|axis| between.period[axis] = sign * period[axis]);
    let pair = bodies.map(Partner::Body);
    let is_on = period == [0.0; D];
    if is_on && contact.partners.has(&pair, contact.method.options()) {
        let what = "a tie between bodies in contact whose faces coincide: exclude their pair";
        return Err(Error::Unsupported { what });
    }
    if let Some([ours, theirs]) = &between.facets
        && ours.iter().any(|facet| theirs.binary_search(facet).is_ok())
    {
        return Err(Error::Unsupported { what: "a tie of two surfaces that have a facet in common" });
    }
    let own = contact.partners.table.options(&pair).and_then(|own| own.law);
    if matches!(own.unwrap_or(contact.method.options().law), EnergyLaw::Volume { .. }) {
        let what = "a tie by the law volume, which has no stiffness per area: give the pair the law depth";
        return Err(Error::Unsupported { what });
    }
    let Contact { mesh, method, ties, state, .. } = contact;
    let number = ties.add(between, mesh, method.weighting(), sign)?;
    state.forget_found();
    Ok(number)
}

/// What a new law of the contact, or new options of a pair, cannot have beside ties that were added.
pub(crate) fn check_law<const D: usize>(contact: &Contact<D>, law: &EnergyLaw) -> Result<(), Error> {
    match contact.ties.has_added() && matches!(law, EnergyLaw::Volume { .. }) {
        true => Err(Error::Unsupported {
            what: "the law volume, which has no stiffness per area, together with an added tie",
        }),
        false => Ok(()),
    }
}

/// The same of options of a pair, which may bring two bodies into contact.
pub(crate) fn check_pair<const D: usize>(
    contact: &Contact<D>,
    pair: [Partner; 2],
    options: Option<PairOptions>,
) -> Result<(), Error> {
    let [Partner::Body(a), Partner::Body(b)] = pair else { return Ok(()) };
    let of_contact = contact.method.options();
    let is_in_contact = options.map_or(a != b || of_contact.self_contact, |own| own.is_in_contact());
    if is_in_contact && contact.ties.has_added_on([a, b]) {
        return Err(Error::Unsupported { what: "contact of bodies with an added tie whose faces coincide" });
    }
    options.and_then(|own| own.law).map_or(Ok(()), |law| check_law(contact, &law))
}

/// Refuses a vector that is not finite, or that changes the radius around an axis.
pub(crate) fn check_vector<const D: usize>(
    contact: &Contact<D>,
    array: &'static str,
    vector: &[f64; D],
) -> Result<(), Error> {
    if let Some(entry) = vector.iter().position(|x| !x.is_finite()) {
        return Err(Error::NonFiniteStiffness { array, entry });
    }
    if contact.method.options().axisymmetric && vector[0] != 0.0 {
        return Err(Error::Unsupported { what: "a period or a jump of a tie along the radius, around an axis" });
    }
    Ok(())
}
