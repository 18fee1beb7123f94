//! Whether a law of the host is one: the same answer to the same question, and tangents that are derivatives of its tractions.

use super::interface_law::{Answer, InterfaceLaw, LawPoints};
use crate::Error;

/// Jumps at which a law is asked where none are given.
const COUNT: usize = 60;

/// A step of differences, by the scale of the jumps: central ones then leave 1e-12 of curvature over that scale, and rounding 1e-10.
const STEP: f64 = 1e-6;

/// What derivatives may differ by, by the largest entry at their point: more than what differences leave where a law curves over a hundredth of the
/// scale, and less than any mistake.
const TOLERANCE: f64 = 1e-6;

/// The same for one-sided differences at a corner.
const TOLERANCE_AT_CORNER: f64 = 1e-3;

/// What answers of one point alone and beside others may differ by, by the largest of them: products of matrices are summed in another order.
const ALIKE: f64 = 1e-12;

/// What is said then.
pub(crate) const ROUNDED: &str = ", except for rounding: other numbers of ranks may change results by as much";

/// Whether answers, array by array, are the same but for rounding.
pub(crate) fn alike(ones: &[&[f64]], others: &[&[f64]]) -> bool {
    ones.iter().zip(others).all(|(one, other)| {
        let largest = one.iter().chain(*other).fold(0.0, |most: f64, x| most.max(x.abs()));
        one.iter().zip(*other).all(|(x, y)| (x - y).abs() <= ALIKE * largest)
    })
}

/// What a law is checked with.
#[derive(Clone, Debug, PartialEq)]
pub struct LawCheck {
    /// 2 or 3.
    pub dim: usize,
    /// A jump over which the tractions change, such as the opening at which damage begins, a length.
    pub scale: f64,
    /// Jumps, as in [`LawPoints::jumps`]; none: 60 that are spread over −scale/4 … scale along the normal and −scale … scale across it.
    pub jumps: Vec<f64>,
    /// The history at each; none: zeros, and then what other jumps leave.
    pub history: Vec<f64>,
    /// How long the step takes; 0: nothing is said.
    pub time_step: f64,
    /// Values of fields, the same on both sides of every point, for a law that looks at them.
    pub fields: Vec<f64>,
}

impl LawCheck {
    /// At jumps of this scale.
    pub fn new(dim: usize, scale: f64) -> Self {
        Self { dim, scale, jumps: Vec::new(), history: Vec::new(), time_step: 0.0, fields: Vec::new() }
    }
}

/// What was found of a law.
#[derive(Clone, Debug, PartialEq)]
pub struct LawReport {
    /// The largest difference between an entry of a tangent and central differences, by the largest entry at its point, corners left out.
    pub largest_error: f64,
    /// Columns of tangents at which the law has a corner: differences to both sides are not the same, and the tangent is one of them.
    pub corners: usize,
    /// The largest |K − Kᵀ| by the largest entry at its point.
    pub asymmetry: f64,
    /// A sentence for everything that was looked at; what is wrong begins with a word and `WRONG`.
    pub sentences: Vec<String>,
}

impl LawReport {
    /// Whether nothing is wrong.
    pub fn is_right(&self) -> bool {
        self.faults().next().is_none()
    }

    /// The sentences on what is wrong.
    pub fn faults(&self) -> impl Iterator<Item = &str> {
        self.sentences.iter().map(String::as_str).filter(|text| text.contains(": WRONG: "))
    }
}

/// Checks a law, with no contact.
///
/// # Errors
/// [`Error::Dimension`]; [`Error::NotPositive`] for a scale or a time step; [`Error::Length`] and [`Error::BadEntry`] for jumps and history;
/// [`Error::InterfaceLaw`] where the law fails or answers what is not finite.
pub fn check_law(law: &dyn InterfaceLaw, check: &LawCheck) -> Result<LawReport, Error> {
    let asked = Asked::new(law, check)?;
    let first = asked.answer(&asked.jumps, &asked.history)?;
    let mut report = LawReport { largest_error: 0.0, corners: 0, asymmetry: 0.0, sentences: Vec::new() };
    report.sentences.push(asked.repeats(&first)?);
    let mut worst = asked.differences(&asked.history, &first, &mut report)?;
    if check.history.is_empty() && asked.per_point > 0 {
        // What the next point has been through: some then load further, and others unload.
        let mut history = first.history;
        history.rotate_left(asked.per_point);
        let after = asked.answer(&asked.jumps, &history)?;
        let other = asked.differences(&history, &after, &mut report)?;
        worst = if other.as_ref().map(Fault::size) > worst.as_ref().map(Fault::size) { other } else { worst };
    }
    report.largest_error = worst.as_ref().map_or(0.0, |fault| fault.error);
    report.sentences.push(worst.as_ref().filter(|fault| fault.error > TOLERANCE).map_or_else(
        || {
            format!(
                "tangent: it is the derivative of the tractions, to {:.1e} of its largest entry",
                report.largest_error
            )
        },
        Fault::told,
    ));
    if report.corners > 0 {
        report.sentences.push(format!(
            "corners: at {} jumps the tangent is a one-sided derivative, and differs from the other side",
            report.corners
        ));
    }
    report.sentences.push(match report.asymmetry > TOLERANCE {
        true => format!("symmetry: the tangent is not symmetric, by {:.1e} of its largest entry", report.asymmetry),
        false => "symmetry: the tangent is symmetric".to_owned(),
    });
    Ok(report)
}

/// An entry of a tangent beside its difference.
struct Fault {
    error: f64,
    jump: Vec<f64>,
    place: [usize; 2],
    given: f64,
    mirrored: f64,
    found: f64,
}

impl Fault {
    fn size(&self) -> f64 {
        self.error
    }

    fn told(&self) -> String {
        let Self { jump, place: [row, column], given, mirrored, found, error } = self;
        let close = |x: f64| (x - found).abs() <= 1e-3 * found.abs();
        let why = match () {
            () if *given == 0.0 => ": the entry is missing",
            () if close(-given) => ": its sign is reversed",
            () if row != column && close(*mirrored) => ": rows and columns are exchanged, and rows are tractions",
            () => "",
        };
        format!(
            "tangent: WRONG: at a jump of {jump:?} the derivative of traction {row} by jump {column} is given as {given:.6e}, and differences \
             of the tractions have {found:.6e}, off by {error:.1e} of the largest entry{why}"
        )
    }
}

/// A law with jumps.
struct Asked<'a> {
    law: &'a dyn InterfaceLaw,
    dim: usize,
    jumps: Vec<f64>,
    history: Vec<f64>,
    per_point: usize,
    step: f64,
    time_step: f64,
    fields: &'a [f64],
}

impl<'a> Asked<'a> {
    fn new(law: &'a dyn InterfaceLaw, check: &'a LawCheck) -> Result<Self, Error> {
        let LawCheck { dim, scale, time_step, .. } = *check;
        if dim != 2 && dim != 3 {
            return Err(Error::Dimension { block: 0, expected: 3, found: dim });
        }
        if !(scale.is_finite() && scale > 0.0) {
            return Err(Error::NotPositive { name: "scale", value: scale });
        }
        Error::check_not_negative("time_step", time_step)?;
        let jumps = if check.jumps.is_empty() { spread(dim, scale) } else { check.jumps.clone() };
        let per_point = law.history_count();
        let count = jumps.len() / dim;
        let history = if check.history.is_empty() { vec![0.0; count * per_point] } else { check.history.clone() };
        let lengths = [("jumps", jumps.len(), (count * dim).max(dim)), ("history", history.len(), count * per_point)];
        for (array, found, expected) in lengths {
            if found != expected {
                return Err(Error::Length { array, expected, found });
            }
        }
        for (array, list) in [("jumps", &jumps), ("history", &history), ("fields", &check.fields)] {
            if let Some(entry) = list.iter().position(|x| !x.is_finite()) {
                return Err(Error::BadEntry { array, entry, value: list[entry] });
            }
        }
        Ok(Self { law, dim, jumps, history, per_point, step: STEP * scale, time_step, fields: &check.fields })
    }

    fn answer(&self, jumps: &[f64], history: &[f64]) -> Result<Answer, Error> {
        let (dim, count) = (self.dim, jumps.len() / self.dim);
        let axes: &[f64] = match dim {
            2 => &[0.0, 1.0, -1.0, 0.0],
            _ => &[0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        };
        let (zeros, ones) = (vec![0.0; count * dim], vec![1.0; count]);
        Answer::of(
            self.law,
            &LawPoints {
                bodies: [0, 1],
                dim,
                count,
                time_step: self.time_step,
                jumps,
                axes: &axes.repeat(count),
                positions: &zeros,
                references: &zeros,
                areas: &ones,
                history,
                field_count: self.fields.len(),
                fields: &self.fields.repeat(2 * count),
            },
        )
    }

    /// Whether the same question has the same answer, also at one point alone.
    fn repeats(&self, first: &Answer) -> Result<String, Error> {
        let again = self.answer(&self.jumps, &self.history)?;
        if again != *first {
            return Ok("answers: WRONG: the same jumps and history have another answer the second time: the law must \
                not keep a state"
                .into());
        }
        let (dim, per_point, mut is_rounded) = (self.dim, self.per_point, false);
        for point in 0..self.jumps.len() / dim {
            let one = |list: &[f64], per_point: usize| list[point * per_point..][..per_point].to_vec();
            let alone = self.answer(&one(&self.jumps, dim), &one(&self.history, per_point))?;
            let beside = Answer {
                tractions: one(&first.tractions, dim),
                tangents: one(&first.tangents, dim * dim),
                history: one(&first.history, per_point),
                stored: one(&first.stored, 1),
                dissipated: one(&first.dissipated, 1),
            };
            is_rounded |= alone != beside;
            if !alike(&alone.parts(), &beside.parts()) {
                return Ok(format!(
                    "answers: WRONG: point {point} has different answers alone and among other points: points must \
                     not depend on one another"
                ));
            }
        }
        Ok(format!(
            "answers: the same input has the same answer, point by point{}",
            if is_rounded { ROUNDED } else { "" }
        ))
    }

    /// The entry of the tangents that differs most from central differences, where the law has no corner.
    fn differences(&self, history: &[f64], at: &Answer, report: &mut LawReport) -> Result<Option<Fault>, Error> {
        let (dim, count, h) = (self.dim, self.jumps.len() / self.dim, self.step);
        let moved = |axis: usize, by: f64| {
            let along = |(place, x): (usize, &f64)| if place % dim == axis { x + by } else { *x };
            self.answer(&self.jumps.iter().enumerate().map(along).collect::<Vec<_>>(), history)
        };
        let mut sides = Vec::new();
        for axis in 0..dim {
            sides.push([moved(axis, h)?.tractions, moved(axis, -h)?.tractions]);
        }
        let mut worst: Option<Fault> = None;
        for point in 0..count {
            let given = |row: usize, column: usize| at.tangents[(point * dim + row) * dim + column];
            let all = |row: usize, column: usize| {
                let [more, less] = [0, 1].map(|side| sides[column][side][point * dim + row]);
                let here = at.tractions[point * dim + row];
                [(more - less) / (2.0 * h), (more - here) / h, (here - less) / h]
            };
            let places = || (0..dim * dim).map(|k| (k / dim, k % dim));
            let largest =
                places().flat_map(|(i, j)| [given(i, j), all(i, j)[0]]).fold(0.0, |most: f64, x| most.max(x.abs()));
            if largest == 0.0 {
                continue;
            }
            let skewed = places().map(|(i, j)| (given(i, j) - given(j, i)).abs()).fold(0.0, f64::max);
            report.asymmetry = report.asymmetry.max(skewed / largest);
            for column in 0..dim {
                let off = |way: usize| {
                    (0..dim).map(|row| (given(row, column) - all(row, column)[way]).abs() / largest).fold(0.0, f64::max)
                };
                let central = off(0);
                if central > TOLERANCE && off(1).min(off(2)) < TOLERANCE_AT_CORNER.min(0.1 * central) {
                    report.corners += 1;
                    continue;
                }
                for row in 0..dim {
                    let error = (given(row, column) - all(row, column)[0]).abs() / largest;
                    if worst.as_ref().is_none_or(|worst| error > worst.error) {
                        worst = Some(Fault {
                            error,
                            jump: self.jumps[point * dim..][..dim].to_vec(),
                            place: [row, column],
                            given: given(row, column),
                            mirrored: given(column, row),
                            found: all(row, column)[0],
                        });
                    }
                }
            }
        }
        Ok(worst)
    }
}

/// Jumps all over what a law is asked for, in a sequence that fills it evenly.
fn spread(dim: usize, scale: f64) -> Vec<f64> {
    // Multiples of powers of the plastic numbers of the dimension, as Roberts has them.
    let ratio: f64 = if dim == 2 { 1.324_717_957_244_746 } else { 1.220_744_084_605_76 };
    let part = |number: usize, axis: usize| (0.5 + (number + 1) as f64 / ratio.powi(axis as i32 + 1)).fract();
    let one = |(number, axis): (usize, usize)| match axis {
        0 => scale * (1.25 * part(number, axis) - 0.25),
        _ => scale * (2.0 * part(number, axis) - 1.0),
    };
    (0..COUNT).flat_map(|number| (0..dim).map(move |axis| (number, axis))).map(one).collect()
}
