//! What is to be run.

use super::plan::{Entry, OTHER_SECTION, Plan};
use crate::case::{Case, Document, library};
use crate::verify;
use anyhow::{Result, ensure};

/// How much is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Size {
    /// Every example once, and the variants that the plan names.
    Quick,
    /// All variants that have checks, and those that the plan names.
    Full,
}

/// An example and its runs.
pub struct Example {
    /// What the plan says of it.
    pub entry: Entry,
    /// Anchor on the page.
    pub id: String,
    /// Heading.
    pub title: String,
    /// Where it comes from.
    pub source: String,
    /// Its runs, at least one; variants after the case itself.
    pub jobs: Vec<Job>,
}

/// One run.
pub struct Job {
    /// Name of its folder.
    pub id: String,
    /// Variant of the case.
    pub variant: Option<String>,
    /// What the variant is, in a line.
    pub about: String,
    /// What is done.
    pub work: Work,
}

/// What a job does.
pub enum Work {
    /// A kernel check by its name.
    Kernel(&'static str),
    /// A case as it is to be run.
    Case(Box<(Document, Case)>),
}

/// The examples of the plan in its order, then the cases that it does not know. `only` are names of cases, of kernel checks
/// or of sections, or paths of case files; all that the program has if empty.
///
/// # Errors
/// If a case is wrong, or one of `only` is nothing that there is.
pub fn examples(plan: &Plan, size: Size, only: &[String]) -> Result<Vec<Example>> {
    let known = |name: &str| library::CASES.iter().any(|(case, _)| *case == name);
    let mut entries: Vec<Entry> = (plan.examples.iter())
        .filter(|entry| entry.kernel.is_some() || entry.case.as_deref().is_some_and(known))
        .cloned()
        .collect();
    let listed = |entries: &[Entry], name: &str| entries.iter().any(|entry| entry.case.as_deref() == Some(name));
    for (name, _) in library::CASES {
        if !listed(&entries, name) {
            entries.push(unplanned(name));
        }
    }
    if !only.is_empty() {
        let mut chosen: Vec<Entry> = Vec::new();
        for word in only {
            let is_meant = |entry: &&Entry| {
                [&entry.case, &entry.kernel].into_iter().flatten().any(|name| name == word) || entry.section == *word
            };
            let meant: Vec<Entry> = entries.iter().filter(is_meant).cloned().collect();
            // What is no name of an example is the path of a case file, or a mistake that opening it tells.
            chosen.extend(if meant.is_empty() { vec![unplanned(word)] } else { meant });
        }
        entries = chosen;
    }
    let examples: Vec<Example> = entries.into_iter().map(|entry| example(entry, size)).collect::<Result<_>>()?;
    for (index, example) in examples.iter().enumerate() {
        let twice = examples[..index].iter().any(|other| other.id == example.id);
        ensure!(!twice, "two examples are called '{}'", example.id);
    }
    Ok(examples)
}

/// A case that the plan does not know.
fn unplanned(case: &str) -> Entry {
    Entry {
        section: OTHER_SECTION.into(),
        case: Some(case.into()),
        kernel: None,
        title: None,
        paper: None,
        text: None,
        headline: None,
        quick: Vec::new(),
        quick_instead: None,
        camera: None,
        others: Vec::new(),
    }
}

fn example(entry: Entry, size: Size) -> Result<Example> {
    if let Some(kernel) = &entry.kernel {
        let name = verify::NAMES.into_iter().find(|name| name == kernel);
        let name = name.ok_or_else(|| anyhow::anyhow!("fmc verify has no check '{kernel}'"))?;
        // A case may have the same name.
        let id = format!("kernel-{name}");
        let job = Job { id: id.clone(), variant: None, about: String::new(), work: Work::Kernel(name) };
        let title = entry.title.clone().unwrap_or_else(|| name.into());
        return Ok(Example { id, title, source: "closed form".into(), jobs: vec![job], entry });
    }
    let file = entry.case.clone().unwrap_or_default();
    let document = Document::open(&file)?;
    let case = document.case()?;
    let mut runs: Vec<Option<String>> = vec![None];
    match size {
        Size::Quick => {
            if let Some(instead) = &entry.quick_instead {
                runs = vec![Some(instead.clone())];
            }
            runs.extend(entry.quick.iter().cloned().map(Some));
        }
        Size::Full => {
            for variant in case.variants.keys() {
                if entry.quick.contains(variant) || has_checks(&document, variant)? {
                    runs.push(Some(variant.clone()));
                }
            }
        }
    }
    let jobs = runs.into_iter().map(|variant| job(&document, variant)).collect::<Result<_>>()?;
    let title = entry.title.clone().unwrap_or(case.title);
    Ok(Example { id: document.name.clone(), title, source: case.source, jobs, entry })
}

fn job(document: &Document, variant: Option<String>) -> Result<Job> {
    let mut document = document.clone();
    if let Some(variant) = &variant {
        document.choose(variant)?;
    }
    let case = document.case()?;
    let id = variant.as_ref().map_or(document.name.clone(), |variant| format!("{}-{variant}", document.name));
    let about = variant.as_ref().and_then(|variant| case.variants.get(variant)).map_or("", |variant| &variant.about);
    Ok(Job { id, about: about.to_owned(), variant, work: Work::Case(Box::new((document, case))) })
}

/// Whether the case expects anything of a variant.
fn has_checks(document: &Document, variant: &str) -> Result<bool> {
    let mut document = document.clone();
    document.choose(variant)?;
    let case = document.case()?;
    let effective = toml::Table::try_from(&case)?;
    let applies = |expected: &crate::case::Expected| {
        expected.tolerance().is_some() && expected.applies(&effective, Some(variant), &document.changes)
    };
    Ok(case.expected.iter().any(applies))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_and_every_kernel_check_is_an_example() {
        let plan = Plan::built_in().unwrap();
        let all = examples(&plan, Size::Full, &[]).unwrap();
        let cases = library::CASES.iter().map(|(name, _)| name.to_string());
        for name in cases.chain(verify::NAMES.map(|name| format!("kernel-{name}"))) {
            assert!(all.iter().any(|example| example.id == name), "{name} is missing");
        }
        let star = all.iter().find(|example| example.id == "star").unwrap();
        assert!(star.jobs.len() > 1 && star.jobs[0].variant.is_none());
        // What the plan does not know is shown all the same.
        let empty = Plan { examples: Vec::new(), ..plan };
        assert_eq!(examples(&empty, Size::Quick, &[]).unwrap().len(), library::CASES.len());
        assert!(examples(&empty, Size::Quick, &["nothing".into()]).is_err());
    }
}
