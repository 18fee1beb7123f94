//! The parts of a contact.

use super::state::LastState;
use crate::Error;
use crate::contact::cohesive::Cohesions;
use crate::contact::glides::Glides;
use crate::contact::governed::GovernedInterfaces;
use crate::contact::held::Past;
use crate::contact::history::History;
use crate::contact::mesh::Mesh;
use crate::contact::method::{Method, Options};
use crate::contact::partners::Partners;
use crate::contact::ties::Ties;
use crate::contact::work::Work;
use crate::geometry::Surface;

/// Contact between the bodies of one mesh, and with rigid obstacles.
///
/// It holds topology, obstacles and options, and keeps search trees and what was found at the last coordinates for the
/// next evaluation. No result depends on what is kept: two evaluations at the same coordinates give the same bits, and
/// [`contact_force`](crate::contact_force) gives the same bits as a `Contact` that is kept.
pub struct Contact<const D: usize> {
    pub(crate) mesh: Mesh<D>,
    pub(crate) partners: Partners<D>,
    pub(crate) method: Method<D>,
    pub(crate) work: Work,
    pub(crate) history: History<D>,
    pub(crate) ties: Ties<D>,
    pub(crate) glides: Glides<D>,
    pub(crate) cohesions: Cohesions<D>,
    pub(crate) governed: GovernedInterfaces<D>,
    /// Nothing that any result depends on.
    pub(crate) state: LastState<D>,
}

impl<const D: usize> Contact<D> {
    /// What its interfaces with a history are asked with.
    pub(crate) fn past(&self) -> Past<'_, D> {
        let Self { partners, method, history, .. } = self;
        let (damage, of_laws, law_fields) = (&history.damage, &history.of_laws, &history.law_fields);
        Past { damage, of_laws, law_fields, time_step: history.time_step, partners, options: method.options() }
    }
}

/// See [`Contact::new`].
pub(crate) fn assemble<const D: usize>(surface: Surface<D>, options: Options) -> Result<Contact<D>, Error> {
    Method::check(&options, &surface)?;
    Ok(Contact {
        mesh: Mesh::new(surface),
        partners: Partners::new(),
        work: Work::new(options.threads)?,
        method: Method::new(options),
        history: History::new(),
        ties: Ties::default(),
        glides: Glides::default(),
        cohesions: Cohesions::default(),
        governed: GovernedInterfaces::default(),
        state: LastState::new(),
    })
}
