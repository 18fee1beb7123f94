//! A law of the host between two surfaces: tractions by the jump, at all points of a pair at once.

use crate::{Error, LawFault};

/// How an interface of the host resists opening and sliding.
///
/// At every point it is asked with the jump of the step so far, in axes that turn with the facet of the second body, and answers with the
/// traction, its derivative and the history. The interface carries the tractions to the nodes, with what the turning of the facets adds, so
/// that forces and moments balance whatever the law is.
///
/// It is called on the thread that evaluates, one pair after the other, ascending, with the points of a pair in the order of
/// [`Contact::law_points`](crate::Contact::law_points), and where ranks share the work on every rank at all points. The same input must have the
/// same answer, bit by bit. Evaluations at the same time, from several threads of the caller, call it at the same time.
pub trait InterfaceLaw: Send + Sync {
    /// How many numbers a point carries from step to step; all are 0 at first.
    fn history_count(&self) -> usize {
        0
    }

    /// Writes the response at all points.
    ///
    /// # Errors
    /// The evaluation then ends with [`Error::InterfaceLaw`], which has the pair, and changes nothing.
    fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure>;
}

impl std::fmt::Debug for dyn InterfaceLaw {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a law of the host")
    }
}

/// Why a law has no answer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LawFailure {
    /// At which point, counted within the pair, where it is one.
    pub point: Option<usize>,
    /// In words.
    pub cause: String,
}

impl From<&str> for LawFailure {
    fn from(cause: &str) -> Self {
        Self { point: None, cause: cause.to_owned() }
    }
}

impl From<String> for LawFailure {
    fn from(cause: String) -> Self {
        Self { point: None, cause }
    }
}

/// The points of a pair. `dim` numbers of a point follow one another, and so do all numbers of a point.
#[derive(Clone, Copy, Debug)]
pub struct LawPoints<'a> {
    /// The pair, the body of lower index first.
    pub bodies: [usize; 2],
    /// 2 or 3.
    pub dim: usize,
    /// How many points there are.
    pub count: usize,
    /// How long the step takes ([`Contact::set_time_step`](crate::Contact::set_time_step)); 0: nothing was said.
    pub time_step: f64,
    /// Lengths, (count, dim): the opening beyond the gap at first, along the normal of the second body, negative where the bodies are pressed;
    /// then how far the first body has slid along the axes in the plane of the facet of the second.
    pub jumps: &'a [f64],
    /// (count, dim, dim): normal and axes in space, by rows, as unit vectors that are perpendicular to one another. In 2D the axis is the normal
    /// turned by +90°. In 3D the first is the x axis projected into the undeformed facet (the z axis, where the normal is within 0.1° of x),
    /// which goes along with the facet, and the second is normal × first.
    pub axes: &'a [f64],
    /// (count, dim): where the points are on the first body, now and without deformation.
    pub positions: &'a [f64],
    /// See `positions`.
    pub references: &'a [f64],
    /// (count): the area that a point stands for, without deformation.
    pub areas: &'a [f64],
    /// (count, history count), as it was accepted last.
    pub history: &'a [f64],
    /// How many fields there are ([`Contact::set_law_fields`](crate::Contact::set_law_fields)), such as a temperature.
    pub field_count: usize,
    /// (count, 2, field count): fields at the point of the first body, then at that of the second.
    pub fields: &'a [f64],
}

/// What a law answers, laid out as its points are.
#[derive(Debug)]
pub struct LawResponse<'a> {
    /// Force by area without deformation, (count, dim), along the axes: positive where it resists a positive jump. NaN at first: every entry
    /// has to be written.
    pub tractions: &'a mut [f64],
    /// Derivative of the tractions by the jump with history and time step held, (count, dim, dim): rows are tractions. It need not be
    /// symmetric. NaN at first.
    pub tangents: &'a mut [f64],
    /// (count, history count): as it would be after a step that ends here. At first what it was.
    pub history: &'a mut [f64],
    /// Energy by area that unloading would give back, and that has been dissipated since the beginning, (count); 0 at first. Nothing but what
    /// is told of energies depends on it.
    pub stored: &'a mut [f64],
    /// See `stored`.
    pub dissipated: &'a mut [f64],
}

/// The numbers of a response.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Answer {
    pub(crate) tractions: Vec<f64>,
    pub(crate) tangents: Vec<f64>,
    pub(crate) history: Vec<f64>,
    pub(crate) stored: Vec<f64>,
    pub(crate) dissipated: Vec<f64>,
}

impl Answer {
    /// All of them.
    pub(super) fn parts(&self) -> [&[f64]; 5] {
        let Self { tractions, tangents, history, stored, dissipated } = self;
        [tractions, tangents, history, stored, dissipated]
    }

    /// Asks a law.
    ///
    /// # Errors
    /// [`Error::InterfaceLaw`] where it fails, or leaves a number that is not finite.
    pub(crate) fn of(law: &dyn InterfaceLaw, points: &LawPoints<'_>) -> Result<Self, Error> {
        let LawPoints { bodies, dim, count, .. } = *points;
        let mut answer = Self {
            tractions: vec![f64::NAN; count * dim],
            tangents: vec![f64::NAN; count * dim * dim],
            history: points.history.to_vec(),
            stored: vec![0.0; count],
            dissipated: vec![0.0; count],
        };
        if count == 0 {
            return Ok(answer);
        }
        let mut response = LawResponse {
            tractions: &mut answer.tractions,
            tangents: &mut answer.tangents,
            history: &mut answer.history,
            stored: &mut answer.stored,
            dissipated: &mut answer.dissipated,
        };
        let failed = |LawFailure { point, cause }| Error::InterfaceLaw(LawFault { bodies, point, cause });
        law.respond(points, &mut response).map_err(failed)?;
        let arrays = [
            ("traction", &answer.tractions),
            ("tangent", &answer.tangents),
            ("history", &answer.history),
            ("stored energy", &answer.stored),
            ("dissipated energy", &answer.dissipated),
        ];
        for (name, array) in arrays {
            if let Some(place) = array.iter().position(|x| !x.is_finite()) {
                let per_point = array.len() / count;
                let (number, value) = (place % per_point, array[place]);
                let jump = &points.jumps[place / per_point * dim..][..dim];
                let cause = format!("number {number} of the {name} is {value}, at a jump of {jump:?}");
                return Err(failed(LawFailure { point: Some(place / per_point), cause }));
            }
        }
        Ok(answer)
    }
}
