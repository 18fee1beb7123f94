//! Other options, and other obstacles.

use super::added_ties;
use crate::Error;
use crate::contact::evaluation::Contact;
use crate::contact::friction::OwnFriction;
use crate::contact::governed::OwnLaw;
use crate::contact::mesh::Mesh;
use crate::contact::method::{Method, Options};
use crate::contact::partners::{Interface, LayerStiffness, PairOptions};
use crate::contact::ties::TieKept;
use crate::geometry::Pose;
use crate::interfaces::Cohesive;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Replaces the options of all pairs that have none of their own. On an error the old ones stay.
pub(crate) fn set<const D: usize>(contact: &mut Contact<D>, options: Options) -> Result<(), Error> {
    added_ties::check_law(contact, &options.law)?;
    let Contact { mesh, partners, method, work, history, state, .. } = contact;
    Method::check(&options, &mesh.surface)?;
    partners.table.check(&options)?;
    history.multipliers.check(&options.law, options.self_contact)?;
    let (new, old) = (method.with(options), *method.options());
    if options.law != old.law {
        partners.take_law(&options.law)?;
    }
    if options.threads != old.threads {
        work.set_threads(options.threads)?;
    }
    *method = new;
    if options.estimator != old.estimator || options.axisymmetric != old.axisymmetric {
        history.release_patches();
    }
    if options.axisymmetric != old.axisymmetric {
        mesh.forget_depth();
    }
    if options.friction != old.friction || options.axisymmetric != old.axisymmetric {
        history.release_friction();
    }
    history.leave_out(|pair| !partners.has(pair, &options));
    state.forget_found();
    if options.axisymmetric != old.axisymmetric {
        find_interfaces_again(contact);
    }
    Ok(())
}

/// Sets the options of one pair, `None`: those of the contact, with the laws of its interface and of its friction where those are of the host. On an error the old
/// ones stay.
pub(crate) fn set_pair<const D: usize>(
    contact: &mut Contact<D>,
    partners: [Partner; 2],
    options: Option<PairOptions>,
    (own_law, friction_law): (Option<&OwnLaw>, Option<OwnFriction>),
) -> Result<(), Error> {
    let pair = contact.partners.checked_pair(partners, contact.mesh.surface.body_count())?;
    let options = if pair == partners { options } else { options.map(PairOptions::swapped) };
    added_ties::check_pair(contact, pair, options)?;
    let of_contact = *contact.method.options();
    let before = contact.partners.friction_of(&pair, &of_contact);
    if let Some(PairOptions { law, excluded, .. }) = options {
        let is_own = pair[0] == pair[1] && !excluded;
        contact.history.multipliers.check(&law.unwrap_or(of_contact.law), is_own)?;
    }
    if let Some(orthotropic) = options.and_then(|options| options.orthotropic) {
        check_carrier(&contact.mesh, pair[usize::from(orthotropic.of_second)])?;
    }
    if options.is_some_and(|options| options.wear_coefficients != [0.0; 2]) {
        contact.mesh.surface.refuse_submesh("a wear coefficient of a mesh in parts")?;
    }
    let law_before = contact.partners.friction_law(&pair).cloned();
    let friction_law = match options.is_some_and(|options| options.friction_law) {
        true => {
            contact.mesh.surface.refuse_submesh("your own law of friction of a mesh in parts")?;
            let without = Error::Unsupported { what: "friction by your own law without the law" };
            Some(friction_law.or_else(|| law_before.clone()).ok_or(without)?)
        }
        false => None,
    };
    let own_before = contact.partners.table.options(&pair);
    contact.partners.set_pair_options(pair, options, &of_contact)?;
    if let Err(error) = set_interface(contact, pair, options, own_law) {
        contact.partners.set_pair_options(pair, own_before, &of_contact)?;
        return Err(error);
    }
    let is_same_law = match (&law_before, &friction_law) {
        (Some(before), Some(now)) => before.is(now),
        (before, now) => before.is_none() && now.is_none(),
    };
    contact.partners.set_friction_law(pair, friction_law);
    if !is_same_law {
        contact.history.forget_friction_law(&pair);
    }
    let after = contact.partners.friction_of(&pair, &of_contact);
    let orthotropic = |options: Option<PairOptions>| options.and_then(|own| own.orthotropic);
    let held = |options: Option<PairOptions>| options.filter(|own| own.surfaces.is_some()).map(|own| own.interface);
    if !contact.partners.has(&pair, &of_contact) || held(own_before) != held(options) {
        contact.history.leave_out(|partners| *partners == pair);
    } else if !after.is_active() {
        contact.history.release_frozen(|partners| *partners == pair);
    } else if !is_same_law || after != before || orthotropic(own_before) != orthotropic(options) {
        contact.history.release_friction();
    }
    contact.state.forget_found();
    Ok(())
}

/// Refuses a direction of what has no shape without deformation.
fn check_carrier<const D: usize>(mesh: &Mesh<D>, carrier: Partner) -> Result<(), Error> {
    mesh.surface.refuse_submesh("a transverse_coefficient of a mesh in parts")?;
    match carrier {
        Partner::Body(_) if mesh.surface.cells.is_none() => Err(Error::Unsupported {
            what: "a direction of a body without cells, which has no coordinates without deformation",
        }),
        _ => Ok(()),
    }
}

/// Ties a pair, or holds it together by an interface that breaks or follows a law of the host, or releases it.
fn set_interface<const D: usize>(
    contact: &mut Contact<D>,
    pair: [Partner; 2],
    options: Option<PairOptions>,
    own_law: Option<&OwnLaw>,
) -> Result<(), Error> {
    let [Partner::Body(a), Partner::Body(b)] = pair else { return Ok(()) };
    let Contact { mesh, method, ties, glides, cohesions, governed, history, .. } = contact;
    let (interface, surfaces) = options.map_or((Interface::Contact, None), |own| (own.held(), own.surfaces));
    let between = |reach, [in_parts, without_cells]: [&'static str; 2]| {
        let between = mesh.between([a, b], surfaces, reach)?;
        mesh.surface.refuse_submesh(in_parts)?;
        mesh.surface.cells.as_ref().map(|_| between).ok_or(Error::Unsupported { what: without_cells })
    };
    let on = (&*mesh, method.weighting());
    let (mut is_new, mut is_new_law) = (false, false);
    match interface {
        Interface::Tied { reach } => {
            let names = ["bodies that are tied, of a mesh in parts", "bodies that are tied, without cells"];
            ties.set(between(reach, names)?, (TieKept::default(), |_| true), on)?;
        }
        Interface::NoSeparation { reach } => {
            let names =
                ["bodies that do not separate, of a mesh in parts", "bodies that do not separate, without cells"];
            glides.set(between(reach, names)?, (BTreeMap::new(), |_| true), on)?;
        }
        Interface::Cohesive(own) => {
            let names = ["a cohesive interface of a mesh in parts", "a cohesive interface of bodies without cells"];
            let kept = ((own, None), |kept: &(Cohesive, _)| kept.0 == own);
            is_new = cohesions.set(between(own.reach, names)?, kept, on)?;
        }
        Interface::Law { reach } => {
            let names =
                ["an interface by your own law, of a mesh in parts", "an interface by your own law, without cells"];
            let without = Error::Unsupported { what: "an interface by your own law without the law" };
            let law = own_law.cloned().or_else(|| governed.law([a, b])).ok_or(without)?;
            let kept = ((law.clone(), None), |kept: &(OwnLaw, _)| kept.0.is(&law));
            is_new_law = governed.set(between(reach, names)?, kept, on)?;
        }
        Interface::Contact | Interface::Rough => {}
    }
    // What held the pair before goes once nothing can fail any more.
    if !matches!(interface, Interface::Tied { .. }) {
        ties.release([a, b]);
    }
    if !matches!(interface, Interface::NoSeparation { .. }) {
        glides.release([a, b]);
    }
    if is_new || !matches!(interface, Interface::Cohesive(_)) && cohesions.release([a, b]) {
        history.damage.remove(&[a, b]);
    }
    if is_new_law || !matches!(interface, Interface::Law { .. }) && governed.release([a, b]) {
        history.of_laws.remove(&[a, b]);
    }
    take_out_of_contact(contact);
    Ok(())
}

/// Finds what holds bodies together on another mesh without deformation; what is broken stays so.
pub(crate) fn find_interfaces_again<const D: usize>(contact: &mut Contact<D>) {
    let Contact { mesh, method, ties, glides, cohesions, governed, history, .. } = contact;
    glides.find_again(mesh, method.weighting());
    ties.find_again(mesh, method.weighting());
    cohesions.find_again(mesh, method.weighting(), &mut history.damage);
    governed.find_again(mesh, method.weighting(), &mut history.of_laws);
    take_out_of_contact(contact);
}

/// Where parts of surfaces are held together, all else of the same bodies is in contact.
fn take_out_of_contact<const D: usize>(contact: &mut Contact<D>) {
    let facets = contact.held_facets().map(|(bodies, facets)| (bodies, facets.clone())).collect();
    contact.mesh.set_tied(facets);
}

/// Sets the coordinates without deformation, on which ties are found.
pub(crate) fn set_reference<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.mesh.set_reference(coords)?;
    find_interfaces_again(contact);
    Ok(())
}

/// Sets the stiffness of layers, or forgets it. On an error the old one stays.
pub(crate) fn set_layer_stiffness<const D: usize>(
    contact: &mut Contact<D>,
    stiffness: Option<LayerStiffness>,
) -> Result<(), Error> {
    let (body_count, law) = (contact.mesh.surface.body_count(), contact.method.options().law);
    contact.partners.set_layer_stiffness(stiffness, body_count, &law)?;
    contact.state.forget_found();
    Ok(())
}

/// Takes an obstacle out, and what was said and found of it.
pub(crate) fn remove_obstacle<const D: usize>(contact: &mut Contact<D>, obstacle: usize) -> Result<(), Error> {
    contact.partners.remove_obstacle(obstacle)?;
    contact.history.forget(Partner::Obstacle(obstacle));
    contact.state.forget_found();
    Ok(())
}

/// Moves an obstacle.
pub(crate) fn set_pose<const D: usize>(contact: &mut Contact<D>, obstacle: usize, pose: Pose<D>) -> Result<(), Error> {
    contact.partners.set_pose(obstacle, pose)?;
    contact.state.forget_found();
    Ok(())
}
