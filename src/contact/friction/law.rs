//! A law of the host for the traction at which facets slide: the limit of friction, at all facets of a pair at once.

use crate::Error;
use crate::error::FrictionFault;
use crate::interfaces::{LawFailure, LawFields};
use crate::overlap::Partner;
use std::sync::Arc;

/// At which traction facets slide, where that is not the coefficient times the pressure.
///
/// The normal part of the contact, the stick and the direction of the slip stay those of the library. The law gives the limit τ in place of
/// μ p + cohesion, by the pressure, the slip of the step, what it keeps itself, and fields of the host. So stick and slip stay one return
/// mapping, energies add up, and friction can be frozen, whatever the law is.
///
/// It is called on the thread that evaluates, one pair after the other, ascending, with the facets of a pair in the order of side and number, and
/// where ranks share the work on every rank for all facets. The same input must have the same answer, bit by bit. Evaluations at the same time,
/// from several threads of the caller, call it at the same time.
pub trait FrictionLaw: Send + Sync {
    /// How many numbers a facet carries from step to step for each of those that it faces; all are 0 at its first touch.
    fn history_count(&self) -> usize {
        0
    }

    /// Writes the response at all facets.
    ///
    /// # Errors
    /// The evaluation then ends with [`Error::FrictionLaw`], which has the pair, and changes nothing.
    fn respond(&self, facets: &FrictionFacets<'_>, response: &mut FrictionResponse<'_>) -> Result<(), LawFailure>;
}

impl std::fmt::Debug for dyn FrictionLaw {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a law of friction of the host")
    }
}

/// The facets of a pair that bear on each other, of both sides. All numbers of a facet follow one another.
#[derive(Clone, Copy, Debug)]
pub struct FrictionFacets<'a> {
    /// The pair, bodies before obstacles, each by index.
    pub partners: [Partner; 2],
    /// 2 or 3.
    pub dim: usize,
    /// How many facets there are.
    pub count: usize,
    /// How long the step takes ([`Contact::set_time_step`](crate::Contact::set_time_step)); 0: nothing was said.
    pub time_step: f64,
    /// Stiffness k_T of the stick, a pressure by length; 0: friction without memory.
    pub stiffness: f64,
    /// (count): their places in [`Contact::boundary_facets`](crate::Contact::boundary_facets).
    pub facets: &'a [usize],
    /// (count): mean pressures over the area in contact, positive.
    pub pressures: &'a [f64],
    /// Lengths, (count, dim − 1): how far the first of the pair has slipped against the second since the step began, along the axes, elastic or
    /// not; its mean over the facet.
    pub slips: &'a [f64],
    /// Lengths, (count, dim − 1): the elastic slip, if nothing slid in the step. Where k_T times its length is beyond the limit, the facet slides
    /// by the rest.
    pub trials: &'a [f64],
    /// (count, dim − 1, dim): the axes in space, by rows, as unit vectors. In 2D the normal, out of the first of the pair, turned by +90°. In 3D
    /// the first is the x axis projected into the facet (the z axis, where the normal is within 6° of x), and the second is normal × first.
    /// They do not turn along with the material.
    pub axes: &'a [f64],
    /// (count, dim): where the tractions act.
    pub positions: &'a [f64],
    /// (count): the areas for which the facets stand: where two bodies meet, each side has half of the area in contact.
    pub areas: &'a [f64],
    /// (count, history count), as it was accepted last.
    pub history: &'a [f64],
    /// How many fields there are ([`Contact::set_law_fields`](crate::Contact::set_law_fields)), such as a temperature.
    pub field_count: usize,
    /// (count, 2, field count): means of the fields over the facet, on the side of the first of the pair, then of the second; NaN on an obstacle.
    pub fields: &'a [f64],
}

/// What a law answers, laid out as its facets are.
#[derive(Debug)]
pub struct FrictionResponse<'a> {
    /// Tractions at which the facets slide, force by area, (count), at least 0. NaN at first: every entry has to be written.
    pub limits: &'a mut [f64],
    /// Their derivatives by the pressure, (count), with slip, history and time step held. NaN at first.
    pub by_pressure: &'a mut [f64],
    /// Their derivatives by the slip, (count, dim − 1), the trial going along with it. 0 at first.
    pub by_slip: &'a mut [f64],
    /// (count, history count): as it would be after a step that ends here. At first what it was.
    pub history: &'a mut [f64],
}

/// A law of the host of a pair.
#[derive(Clone)]
pub(crate) struct OwnFriction {
    pub(super) law: Arc<dyn FrictionLaw>,
    /// How many numbers every facet has by it.
    pub(crate) count: usize,
}

impl OwnFriction {
    pub(crate) fn new(law: Arc<dyn FrictionLaw>) -> Self {
        let count = law.history_count();
        Self { law, count }
    }

    pub(crate) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.law, &other.law)
    }
}

/// What such a law is asked with in a step, beside what its facets are.
#[derive(Clone, Copy)]
pub(crate) struct OwnLimit<'a> {
    pub(crate) own: &'a OwnFriction,
    /// 0: none was said.
    pub(crate) time_step: f64,
    pub(crate) fields: &'a LawFields,
}

/// The numbers of a response.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Limits {
    pub(super) limits: Vec<f64>,
    pub(super) by_pressure: Vec<f64>,
    pub(super) by_slip: Vec<f64>,
    pub(super) history: Vec<f64>,
}

impl Limits {
    /// All of them.
    pub(super) fn parts(&self) -> [&[f64]; 4] {
        let Self { limits, by_pressure, by_slip, history } = self;
        [limits, by_pressure, by_slip, history]
    }

    /// Asks a law.
    ///
    /// # Errors
    /// [`Error::FrictionLaw`] where it fails, or leaves a number that is not finite, or a limit below 0.
    pub(super) fn of(law: &dyn FrictionLaw, facets: &FrictionFacets<'_>) -> Result<Self, Error> {
        let count = facets.count;
        let mut answer = Self {
            limits: vec![f64::NAN; count],
            by_pressure: vec![f64::NAN; count],
            by_slip: vec![0.0; count * (facets.dim - 1)],
            history: facets.history.to_vec(),
        };
        if count == 0 {
            return Ok(answer);
        }
        let mut response = FrictionResponse {
            limits: &mut answer.limits,
            by_pressure: &mut answer.by_pressure,
            by_slip: &mut answer.by_slip,
            history: &mut answer.history,
        };
        let failed = |LawFailure { point, cause }| {
            let sides = facets.partners.map(|partner| match partner {
                Partner::Body(body) => ("body", body),
                Partner::Obstacle(obstacle) => ("obstacle", obstacle),
            });
            let facet = point.and_then(|point| facets.facets.get(point).copied());
            Error::FrictionLaw(FrictionFault { sides, facet, cause })
        };
        law.respond(facets, &mut response).map_err(failed)?;
        let arrays = [
            ("limit", &answer.limits),
            ("derivative by the pressure", &answer.by_pressure),
            ("derivative by the slip", &answer.by_slip),
            ("history", &answer.history),
        ];
        for (name, array) in arrays {
            let is_limit = name == "limit";
            if let Some(place) = array.iter().position(|x| !x.is_finite() || is_limit && *x < 0.0) {
                let per_facet = array.len() / count;
                let (point, value) = (place / per_facet, array[place]);
                let slip = &facets.slips[point * (facets.dim - 1)..][..facets.dim - 1];
                let cause = format!(
                    "number {} of the {name} is {value}, at a pressure of {:e} and a slip of {slip:?}",
                    place % per_facet,
                    facets.pressures[point]
                );
                return Err(failed(LawFailure { point: Some(point), cause }));
            }
        }
        Ok(answer)
    }
}
