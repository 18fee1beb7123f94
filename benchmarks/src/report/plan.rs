//! What the report says of the examples, from `benchmarks/cases/report.toml`.

use anyhow::{Context, Result};
use serde::Deserialize;
use std::collections::BTreeMap;

/// The order of the page, its words, and the figures of others.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plan {
    /// Chapters in order.
    pub sections: Vec<Section>,
    /// Examples in order; those about a case that the program does not have are left out.
    pub examples: Vec<Entry>,
    /// Words for the keys of figures.
    pub figures: BTreeMap<String, FigureWords>,
}

/// `[[sections]]`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// What examples call it.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// Where it is in the paper.
    #[serde(default)]
    pub paper: Option<String>,
    /// What it is about.
    pub text: String,
}

/// `[[examples]]`: a case of the program, or a kernel check of `fmc verify`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// The section it stands in.
    pub section: String,
    /// Name of the case.
    #[serde(default)]
    pub case: Option<String>,
    /// Name of the kernel check.
    #[serde(default)]
    pub kernel: Option<String>,
    /// Heading [default: the title of the case].
    #[serde(default)]
    pub title: Option<String>,
    /// Where it is in the paper.
    #[serde(default)]
    pub paper: Option<String>,
    /// What happens, and what to look at.
    #[serde(default)]
    pub text: Option<String>,
    /// Key of the figure that stands for it in the summary [default: that of the first check].
    #[serde(default)]
    pub headline: Option<String>,
    /// Variants that run in both sizes; the full size also runs all that have checks.
    #[serde(default)]
    pub quick: Vec<String>,
    /// Variant that runs in the quick size in the place of the case itself.
    #[serde(default)]
    pub quick_instead: Option<String>,
    /// Where bodies in space are looked at from.
    #[serde(default)]
    pub camera: Option<[f64; 3]>,
    /// What others got.
    #[serde(default)]
    pub others: Vec<Other>,
}

/// `[[examples.others]]`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Other {
    /// Who.
    pub who: String,
    /// What they got: a number in the unit of the figure, or words.
    #[serde(default)]
    pub figures: BTreeMap<String, Said>,
    /// How.
    #[serde(default)]
    pub note: Option<String>,
}

/// A figure of somebody else.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Said {
    /// To be shown like our own.
    Number(f64),
    /// As it stands.
    Words(String),
}

/// `[figures]`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FigureWords {
    /// What the figure is, in words.
    pub name: String,
    /// Whether it is a ratio that reads best in per cent.
    #[serde(default)]
    pub percent: bool,
}

/// Section of examples that the plan does not know.
pub(super) const OTHER_SECTION: &str = "more";

impl Plan {
    /// The plan that the program brings along.
    ///
    /// # Errors
    /// If it is damaged.
    pub fn built_in() -> Result<Self> {
        toml::from_str(include_str!("../../cases/report.toml")).context("cases/report.toml")
    }

    /// What a figure is called.
    pub fn figure_name(&self, key: &str) -> String {
        self.figures.get(key).map_or_else(|| key.replace('_', " "), |words| words.name.clone())
    }

    /// Whether a figure reads best in per cent.
    pub fn is_percent(&self, key: &str) -> bool {
        self.figures.get(key).is_some_and(|words| words.percent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{Document, library};

    #[test]
    fn the_plan_fits_the_cases() {
        let plan = Plan::built_in().unwrap();
        for entry in &plan.examples {
            assert!(plan.sections.iter().any(|section| section.id == entry.section), "{}", entry.section);
            assert!(entry.case.is_some() != entry.kernel.is_some(), "a case or a kernel check: {entry:?}");
            assert!(entry.kernel.is_none() || entry.title.is_some(), "a kernel check has no title of its own");
        }
        assert!(plan.sections.iter().any(|section| section.id == OTHER_SECTION));
        for (name, _) in library::CASES {
            let entry = plan.examples.iter().find(|entry| entry.case.as_deref() == Some(name));
            let case = Document::open(name).unwrap().case().unwrap();
            for key in case.figures.kind.keys() {
                assert!(plan.figures.contains_key(*key), "{key} has no name in words");
            }
            for variant in entry.into_iter().flat_map(|entry| entry.quick.iter().chain(&entry.quick_instead)) {
                assert!(case.variants.contains_key(variant), "{name} has no variant {variant}");
            }
        }
    }
}
