//! What a run came to: figures, checks, costs.

use super::Figure;
use crate::case::{Case, Document, LawName, Origin};
use crate::number::significant;
use comfy_table::{CellAlignment, Table, presets::ASCII_MARKDOWN};
use serde::{Serialize, Serializer};

/// A finished run, as `summary.json` holds it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Name of the case.
    pub case: String,
    /// `reference`: which program computed it.
    pub host: &'static str,
    /// `exact`, `lines` or `isotropic`.
    pub estimator: &'static str,
    /// `volume`, `fiber`, `fiber-linear` or `depth`.
    pub law: LawName,
    /// Exponent of the volume law.
    pub exponent: f64,
    /// Stiffness k.
    pub stiffness: f64,
    /// Coefficient of friction.
    #[serde(skip_serializing_if = "is_zero")]
    pub friction: f64,
    /// Variant of the case.
    pub variant: Option<String>,
    /// What the user changed.
    pub changes: Vec<String>,
    /// Time step, s; 0 for an equilibrium.
    #[serde(skip_serializing_if = "is_zero")]
    pub step: f64,
    /// Largest stable step at the start, s.
    #[serde(skip_serializing_if = "is_zero")]
    pub step_limit: f64,
    /// Residual by the forces before every iteration, of an equilibrium.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub residuals: Vec<f64>,
    /// Evaluations of the contact in a step.
    pub contact_substeps: u32,
    /// Figures by key.
    #[serde(serialize_with = "by_name")]
    pub figures: Vec<Figure>,
    /// Figures with a tolerance.
    pub checks: Vec<Check>,
    /// Numbers to be read beside a figure.
    pub references: Vec<Reference>,
    /// Steps made; for an equilibrium iterations, with each of which the bodies are linearised anew.
    pub iterations: u64,
    /// Iterations of the contact alone within these, of an equilibrium.
    pub contact_iterations: u64,
    /// Updates of multipliers within these, where a penetration is wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub updates: Option<usize>,
    /// Sparse matrices factorised, of an equilibrium.
    pub factorisations: usize,
    /// Largest mean penetration of a node at the end, of an equilibrium, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nodal_penetration: Option<f64>,
    /// Seconds that they took.
    pub seconds: f64,
    /// Seconds of these in contact.
    pub contact_seconds: f64,
    /// Most crossings of one evaluation.
    pub crossings: usize,
    /// What the contact had to say, each sentence once.
    pub warnings: Vec<String>,
}

/// A figure that must come out right.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// Key of the figure.
    pub name: String,
    /// What came out.
    pub value: Option<f64>,
    /// What should have.
    pub reference: f64,
    /// How far off it may be, in the unit of the figure.
    pub tolerance: f64,
    /// Whether it is not farther off.
    pub ok: bool,
    /// Who says so.
    pub source: String,
}

/// What somebody else got.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reference {
    /// Key of the figure.
    pub name: String,
    /// What came out here.
    pub value: Option<f64>,
    /// What they got.
    pub reference: f64,
    /// Who, and of what.
    pub source: String,
}

/// What a run cost and had to say.
#[derive(Clone, Debug, Default, PartialEq, Serialize, serde::Deserialize)]
pub(super) struct Costs {
    pub(super) seconds: f64,
    pub(super) contact_seconds: f64,
    pub(super) warnings: Vec<String>,
    /// Steps from the start to the end of the run; absent in files of versions that did not write it.
    #[serde(default, alias = "iterations", skip_serializing_if = "Option::is_none")]
    pub(super) step_count: Option<u64>,
}

fn is_zero(x: &f64) -> bool {
    *x == 0.0
}

fn by_name<S: Serializer>(figures: &[Figure], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(figures.iter().map(|figure| (figure.name, figure.value)))
}

impl Summary {
    /// Judges figures by what the case expects; `step` and `step_limit` in s.
    pub(super) fn new(document: &Document, case: &Case, figures: Vec<Figure>, [step, step_limit]: [f64; 2]) -> Self {
        let effective = toml::Table::try_from(case).unwrap_or_default();
        let value = |name: &str| figures.iter().find(|figure| figure.name == name).and_then(|figure| figure.value);
        let (mut checks, mut references) = (Vec::new(), Vec::new());
        let applies = |expected: &&crate::case::Expected| {
            expected.applies(&effective, document.variant.as_deref(), &document.changes)
        };
        for expected in case.expected.iter().filter(applies) {
            let (name, source, reference) = (expected.figure.clone(), expected.source.clone(), expected.value);
            let value = value(&name);
            match expected.tolerance() {
                Some(tolerance) => {
                    let ok = value.is_some_and(|value| (value - reference).abs() <= tolerance);
                    checks.push(Check { name, value, reference, tolerance, ok, source });
                }
                None => references.push(Reference { name, value, reference, source }),
            }
        }
        let changes = document.changes.iter().filter_map(|change| match &change.origin {
            Origin::User(words) => Some(words.clone()),
            Origin::Variant(_) => None,
        });
        Self {
            case: document.name.clone(),
            host: "reference",
            estimator: case.contact.estimator_word(),
            law: case.contact.law,
            exponent: case.contact.exponent,
            stiffness: case.contact.stiffness,
            friction: case.contact.friction_coefficient,
            variant: document.variant.clone(),
            changes: changes.collect(),
            step,
            step_limit,
            residuals: Vec::new(),
            contact_substeps: case.time.contact_substeps,
            figures,
            checks,
            references,
            iterations: 0,
            contact_iterations: 0,
            updates: None,
            factorisations: 0,
            nodal_penetration: None,
            seconds: 0.0,
            contact_seconds: 0.0,
            crossings: 0,
            warnings: Vec::new(),
        }
    }

    /// Whether every check holds.
    pub fn is_ok(&self) -> bool {
        self.checks.iter().all(|check| check.ok)
    }

    /// A figure by its key.
    pub fn figure(&self, name: &str) -> Option<f64> {
        self.figures.iter().find(|figure| figure.name == name)?.value
    }

    /// Figures, each with its checks and references, as a table in Markdown.
    pub fn table(&self) -> Table {
        let mut table = Table::new();
        table.load_style(ASCII_MARKDOWN).set_header([
            "figure",
            "value",
            "unit",
            "reference",
            "tolerance",
            "",
            "source",
        ]);
        for figure in &self.figures {
            let mut first =
                [figure.name.to_owned(), figure.value.map_or("none".into(), number), figure.unit.to_owned()];
            let checks = self.checks.iter().filter(|check| check.name == figure.name);
            let checks = checks.map(|check| {
                let verdict = if check.ok { "ok" } else { "FAILS" };
                [
                    number(check.reference),
                    format!("± {}", number(check.tolerance)),
                    verdict.into(),
                    check.source.clone(),
                ]
            });
            let references = self.references.iter().filter(|reference| reference.name == figure.name);
            let references = references
                .map(|reference| [number(reference.reference), String::new(), String::new(), reference.source.clone()]);
            let mut rows: Vec<[String; 4]> = checks.chain(references).collect();
            if rows.is_empty() {
                rows.push(Default::default());
            }
            for row in rows {
                table.add_row(first.iter().chain(&row));
                first = Default::default();
            }
        }
        for column in [1, 3, 4] {
            if let Some(column) = table.column_mut(column) {
                column.set_cell_alignment(CellAlignment::Right);
            }
        }
        table
    }

    /// The figures of several runs of one case as a table, a column for each.
    pub fn side_by_side(summaries: &[Self]) -> Table {
        let mut table = Table::new();
        let name = |summary: &Self| summary.variant.clone().unwrap_or_else(|| summary.case.clone());
        table.load_style(ASCII_MARKDOWN).set_header(std::iter::once("figure".into()).chain(summaries.iter().map(name)));
        for figure in summaries.first().map_or(&[][..], |summary| &summary.figures) {
            let values = summaries.iter().map(|summary| summary.figure(figure.name).map_or("none".into(), number));
            let unit = if figure.unit.is_empty() { String::new() } else { format!(", {}", figure.unit) };
            table.add_row(std::iter::once(format!("{}{unit}", figure.name)).chain(values));
        }
        for column in table.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        table
    }

    /// Law and estimator in a sentence.
    pub fn setting(&self) -> String {
        let Self { estimator, law, exponent, stiffness, friction, variant, contact_substeps, .. } = self;
        let law = match law {
            LawName::Volume if *exponent == 1.0 => "w = k V".to_owned(),
            LawName::Volume => format!("w = k V^{exponent}"),
            LawName::Fiber => "pressure = k × penetration".to_owned(),
            LawName::Depth => "pressure = k × penetration, by the depth below both surfaces".to_owned(),
            LawName::FiberLinear => "w = Σ ω k (√(L² + ε²) − ε)".to_owned(),
        };
        let variant = variant.as_ref().map_or(String::new(), |name| format!("; variant {name}"));
        let times = if *contact_substeps == 1 { String::new() } else { format!(", {contact_substeps} times a step") };
        let friction = if *friction > 0.0 { format!(", μ = {friction}") } else { String::new() };
        format!("{law}, k = {stiffness:e}{friction}; overlap measured by {estimator}{times}{variant}")
    }

    /// Steps, seconds and crossings in a sentence.
    pub fn costs(&self) -> String {
        let Self { iterations, contact_iterations, seconds, contact_seconds, crossings, step, step_limit, .. } = self;
        let (rate, part) = (*iterations as f64 / seconds, 100.0 * contact_seconds / seconds);
        if let Some(residual) = self.residuals.last() {
            return format!(
                "{iterations} iterations, {contact_iterations} of the contact within them, in {seconds:.2} s, contact \
                 {part:.0} %; residual {residual:.1e}; {crossings} crossings"
            );
        }
        format!(
            "{iterations} steps of {step:.4e} s (stable: {step_limit:.4e} s) in {seconds:.2} s: {rate:.0} steps/s, contact \
             {part:.0} %; at most {crossings} crossings a step"
        )
    }
}

/// Six significant digits.
fn number(x: f64) -> String {
    if x == 0.0 || (1e-3..1e7).contains(&x.abs()) { significant(x, 6) } else { format!("{x:.3e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_six_digits() {
        let found = [0.0, 668.91234, 1e-3, 4.1e-5, 360_123.4, -0.02].map(number);
        assert_eq!(found, ["0", "668.912", "0.001", "4.100e-5", "360123", "-0.02"]);
    }
}
