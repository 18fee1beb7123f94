//! Whether a law of friction of the host is one: the same answer to the same question, and derivatives that are those of its limit.

use super::law::{FrictionFacets, FrictionLaw, Limits};
use crate::Error;
use crate::interfaces::{ROUNDED, alike};
use crate::overlap::Partner;

/// Facets at which a law is asked.
const COUNT: usize = 60;

/// A step of differences, by the scales: central ones then leave 1e-12 of curvature over a scale, and rounding 1e-10.
const STEP: f64 = 1e-6;

/// What derivatives times their scales may differ by, by the largest of them and of the limit: more than differences leave where a law curves over a
/// hundredth of a scale, and less than any mistake that matters.
const TOLERANCE: f64 = 1e-6;

/// The same for one-sided differences at a corner.
const TOLERANCE_AT_CORNER: f64 = 1e-3;

/// What a law of friction is checked with.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionLawCheck {
    /// 2 or 3.
    pub dim: usize,
    /// The largest pressure to ask at, such as one over which the limit changes.
    pub pressure: f64,
    /// The largest slip of a step to ask at, in every direction, a length.
    pub slip: f64,
    /// How long the step takes; 0: nothing is said.
    pub time_step: f64,
    /// Fields on either side, for all facets the same.
    pub fields: Vec<f64>,
}

impl FrictionLawCheck {
    /// Up to this pressure and this slip.
    pub fn new(dim: usize, pressure: f64, slip: f64) -> Self {
        Self { dim, pressure, slip, time_step: 0.0, fields: Vec::new() }
    }
}

/// What was found of a law of friction.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionLawReport {
    /// The largest difference between a derivative and central differences, times the scale and by the limit or the largest derivative at the
    /// facet, corners left out.
    pub largest_error: f64,
    /// Derivatives at corners of the law: differences to both sides are not the same, and the derivative is one of them.
    pub corners: usize,
    /// A sentence for everything that was looked at; what is wrong begins with a word and `WRONG`.
    pub sentences: Vec<String>,
}

impl FrictionLawReport {
    /// Whether nothing is wrong.
    pub fn is_right(&self) -> bool {
        self.faults().next().is_none()
    }

    /// The sentences on what is wrong.
    pub fn faults(&self) -> impl Iterator<Item = &str> {
        self.sentences.iter().map(String::as_str).filter(|text| text.contains(": WRONG: "))
    }
}

/// Checks a law of friction, with no contact, at 60 pressures and slips up to those given. The history is 0, and then what other facets leave.
///
/// # Errors
/// [`Error::Dimension`]; [`Error::NotPositive`] for a pressure, a slip or a time step; [`Error::BadEntry`] for a field that is not finite;
/// [`Error::FrictionLaw`] where the law fails, or answers with what is no limit.
pub fn check_friction_law(law: &dyn FrictionLaw, check: &FrictionLawCheck) -> Result<FrictionLawReport, Error> {
    let asked = Asked::new(law, check)?;
    let zeros = vec![0.0; COUNT * asked.per_facet];
    let first = asked.answer(&asked.at, &zeros)?;
    let mut report =
        FrictionLawReport { largest_error: 0.0, corners: 0, sentences: vec![asked.repeats(&first, &zeros)?] };
    let mut worst = asked.differences(&zeros, &first, &mut report)?;
    if asked.per_facet > 0 {
        // What the next facet has been through.
        let mut history = first.history;
        history.rotate_left(asked.per_facet);
        let after = asked.answer(&asked.at, &history)?;
        let other = asked.differences(&history, &after, &mut report)?;
        worst = if other.error > worst.error { other } else { worst };
    }
    report.largest_error = worst.error;
    report.sentences.push(match worst.error > TOLERANCE {
        true => worst.told(),
        false => format!("derivatives: they match the limit, to {:.1e} of it", worst.error),
    });
    if report.corners > 0 {
        report
            .sentences
            .push(format!("corners: {} derivatives are one-sided, and differ from the other side", report.corners));
    }
    Ok(report)
}

/// A derivative beside its difference; of the limit by the pressure, or by a part of the slip.
#[derive(Default)]
struct Fault {
    error: f64,
    pressure: f64,
    slip: Vec<f64>,
    by: usize,
    given: f64,
    found: f64,
}

impl Fault {
    fn told(&self) -> String {
        let Self { error, pressure, slip, by, given, found } = self;
        let name = if *by == 0 { "the pressure".to_owned() } else { format!("slip {}", by - 1) };
        let why = match () {
            () if *given == 0.0 => ": the entry is missing",
            () if (given + found).abs() <= 1e-3 * found.abs() => ": its sign is reversed",
            () => "",
        };
        format!(
            "derivatives: WRONG: at a pressure of {pressure:.6e} and a slip of {slip:?} the derivative of the limit by {name} is given as \
             {given:.6e}, and differences of the limit have {found:.6e}, off by {error:.1e} of the limit{why}"
        )
    }
}

/// A law with facets: `dim` numbers for each, the pressure and the slip.
struct Asked<'a> {
    law: &'a dyn FrictionLaw,
    dim: usize,
    at: Vec<f64>,
    scales: [f64; 2],
    per_facet: usize,
    time_step: f64,
    fields: &'a [f64],
}

impl<'a> Asked<'a> {
    fn new(law: &'a dyn FrictionLaw, check: &'a FrictionLawCheck) -> Result<Self, Error> {
        let FrictionLawCheck { dim, pressure, slip, time_step, ref fields } = *check;
        if dim != 2 && dim != 3 {
            return Err(Error::Dimension { block: 0, expected: 3, found: dim });
        }
        for (name, value) in [("pressure", pressure), ("slip", slip)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::NotPositive { name, value });
            }
        }
        Error::check_not_negative("time_step", time_step)?;
        if let Some(entry) = fields.iter().position(|x| !x.is_finite()) {
            return Err(Error::BadEntry { array: "fields", entry, value: fields[entry] });
        }
        let at = spread(dim, [pressure, slip]);
        Ok(Self { law, dim, at, scales: [pressure, slip], per_facet: law.history_count(), time_step, fields })
    }

    fn answer(&self, at: &[f64], history: &[f64]) -> Result<Limits, Error> {
        let (dim, count) = (self.dim, at.len() / self.dim);
        let axes: &[f64] = if dim == 2 { &[-1.0, 0.0] } else { &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0] };
        let slips: Vec<f64> = at.chunks(dim).flat_map(|one| one[1..].iter().copied()).collect();
        Limits::of(
            self.law,
            &FrictionFacets {
                partners: [Partner::Body(0), Partner::Body(1)],
                dim,
                count,
                time_step: self.time_step,
                stiffness: self.scales[0] / self.scales[1],
                facets: &(0..count).collect::<Vec<_>>(),
                pressures: &at.iter().copied().step_by(dim).collect::<Vec<_>>(),
                slips: &slips,
                trials: &slips,
                axes: &axes.repeat(count),
                positions: &vec![0.0; count * dim],
                areas: &vec![1.0; count],
                history,
                field_count: self.fields.len(),
                fields: &self.fields.repeat(2 * count),
            },
        )
    }

    /// Whether the same question has the same answer, also at one facet alone.
    fn repeats(&self, first: &Limits, history: &[f64]) -> Result<String, Error> {
        if self.answer(&self.at, history)? != *first {
            return Ok(
                "answers: WRONG: the same facets have another answer the second time: the law must not keep a state"
                    .into(),
            );
        }
        let mut is_rounded = false;
        for facet in 0..COUNT {
            let one = |list: &[f64], per_facet: usize| list[facet * per_facet..][..per_facet].to_vec();
            let alone = self.answer(&one(&self.at, self.dim), &one(history, self.per_facet))?;
            let beside = Limits {
                limits: one(&first.limits, 1),
                by_pressure: one(&first.by_pressure, 1),
                by_slip: one(&first.by_slip, self.dim - 1),
                history: one(&first.history, self.per_facet),
            };
            is_rounded |= alone != beside;
            if !alike(&alone.parts(), &beside.parts()) {
                return Ok(format!(
                    "answers: WRONG: facet {facet} has different answers alone and among other facets: facets must \
                     not depend on one another"
                ));
            }
        }
        Ok(format!(
            "answers: the same input has the same answer, facet by facet{}",
            if is_rounded { ROUNDED } else { "" }
        ))
    }

    /// The derivative that differs most from central differences, where the law has no corner.
    fn differences(&self, history: &[f64], here: &Limits, report: &mut FrictionLawReport) -> Result<Fault, Error> {
        let dim = self.dim;
        let scale = |by: usize| self.scales[by.min(1)];
        let moved = |by: usize, step: f64| {
            let along = |(place, x): (usize, &f64)| if place % dim == by { x + step } else { *x };
            Ok(self.answer(&self.at.iter().enumerate().map(along).collect::<Vec<_>>(), history)?.limits)
        };
        let mut sides = Vec::new();
        for by in 0..dim {
            let h = STEP * scale(by);
            sides.push([moved(by, h)?, moved(by, -h)?]);
        }
        let mut worst = Fault::default();
        for facet in 0..COUNT {
            let given = |by: usize| match by {
                0 => here.by_pressure[facet],
                _ => here.by_slip[facet * (dim - 1) + by - 1],
            };
            let all = |by: usize| {
                let ([more, less], at) = ([0, 1].map(|side| sides[by][side][facet]), here.limits[facet]);
                let h = STEP * scale(by);
                [(more - less) / (2.0 * h), (more - at) / h, (at - less) / h]
            };
            let sizes = (0..dim).flat_map(|by| [given(by), all(by)[0]].map(|x| x.abs() * scale(by)));
            let largest = sizes.fold(here.limits[facet], f64::max);
            if largest == 0.0 {
                continue;
            }
            for by in 0..dim {
                let [error, above, below] = all(by).map(|found| (given(by) - found).abs() * scale(by) / largest);
                if error > TOLERANCE && above.min(below) < TOLERANCE_AT_CORNER.min(0.1 * error) {
                    report.corners += 1;
                } else if error > worst.error {
                    let (pressure, slip) = (self.at[facet * dim], self.at[facet * dim + 1..][..dim - 1].to_vec());
                    worst = Fault { error, pressure, slip, by, given: given(by), found: all(by)[0] };
                }
            }
        }
        Ok(worst)
    }
}

/// Pressures and slips all over what a law is asked for, in a sequence that fills it evenly.
fn spread(dim: usize, scales: [f64; 2]) -> Vec<f64> {
    // Multiples of powers of the plastic numbers of the dimension, as Roberts has them.
    let ratio: f64 = if dim == 2 { 1.324_717_957_244_746 } else { 1.220_744_084_605_76 };
    let part = |number: usize, axis: usize| (0.5 + (number + 1) as f64 / ratio.powi(axis as i32 + 1)).fract();
    let one = |number: usize, axis: usize| match axis {
        // Steps of differences stay above a pressure of 0.
        0 => scales[0] * (0.01 + 0.99 * part(number, axis)),
        _ => scales[1] * (2.0 * part(number, axis) - 1.0),
    };
    (0..COUNT)
        .flat_map(|number| (0..dim).map(move |axis| (number, axis)))
        .map(|(number, axis)| one(number, axis))
        .collect()
}
