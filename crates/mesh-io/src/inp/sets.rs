//! Element sets, as far as they tell which elements belong together.

use super::lines::{Keyword, Lines, fields, label};
use crate::excerpt::shortened;
use anyhow::{Result, ensure};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;

/// What a set was given.
enum Member {
    Label(u64),
    /// First, last, step.
    Labels(u64, u64, u64),
    /// Elements by their place in the part.
    Places(Range<usize>),
    Set(usize),
}

struct Set {
    name: String,
    members: Vec<Member>,
}

/// The sets of a part, in the order in which they are first named.
#[derive(Default)]
pub(super) struct Sets {
    sets: Vec<Set>,
    by_name: HashMap<String, usize>,
    /// Sets of sections: each element has one section, whereas other sets may overlap.
    sections: Vec<String>,
}

impl Sets {
    fn named(&mut self, name: &str) -> usize {
        *self.by_name.entry(name.to_uppercase()).or_insert_with(|| {
            self.sets.push(Set { name: name.to_owned(), members: Vec::new() });
            self.sets.len() - 1
        })
    }

    /// Adds the elements of a block that names its set.
    pub(super) fn add_places(&mut self, name: &str, places: Range<usize>) {
        let set = self.named(name);
        self.sets[set].members.push(Member::Places(places));
    }

    /// Notes that the elements of a set have a section of their own.
    pub(super) fn add_section(&mut self, name: &str) {
        self.sections.push(name.to_uppercase());
    }

    /// Reads `*ELSET`.
    pub(super) fn read(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<()> {
        let set = self.named(keyword.required("ELSET")?);
        let generate = keyword.value("GENERATE").is_some();
        while let Some((line, text)) = lines.data() {
            if generate {
                let numbers = fields(text).map(|field| label(line, field)).collect::<Result<Vec<u64>>>()?;
                let member = match numbers[..] {
                    [first, last] => Member::Labels(first, last, 1),
                    [first, last, step] => Member::Labels(first, last, step),
                    _ => anyhow::bail!("line {line}: expected first, last and step of a set, found '{text}'"),
                };
                self.sets[set].members.push(member);
                continue;
            }
            for field in fields(text) {
                let member = if field.starts_with(|c: char| c.is_ascii_digit() || c == '-') {
                    Member::Label(label(line, field)?)
                } else {
                    let found = self.by_name.get(&field.trim_matches('"').to_uppercase());
                    ensure!(found.is_some(), "line {line}: no element set has been named '{}'", shortened(field));
                    Member::Set(found.copied().unwrap_or(set))
                };
                self.sets[set].members.push(member);
            }
        }
        Ok(())
    }

    /// The set that each element goes by, of elements with these labels in their order: that of its section, else the first that has it.
    pub(super) fn of_elements(&self, labels: &[u64]) -> Vec<Option<usize>> {
        let mut found = vec![None; labels.len()];
        let mut left: BTreeMap<u64, usize> = labels.iter().enumerate().map(|(place, &label)| (label, place)).collect();
        let of_sections = self.sections.iter().filter_map(|name| self.by_name.get(name).copied());
        for set in of_sections.chain(0..self.sets.len()) {
            self.claim(set, labels, &mut left, &mut found);
        }
        found
    }

    /// Gives what is left of the elements of a set, and of those within it, to that set.
    fn claim(&self, owner: usize, labels: &[u64], left: &mut BTreeMap<u64, usize>, found: &mut [Option<usize>]) {
        let (mut open, mut seen) = (vec![owner], BTreeSet::new());
        while let Some(set) = open.pop() {
            if !seen.insert(set) {
                continue;
            }
            for member in &self.sets[set].members {
                let taken: Vec<u64> = match member {
                    Member::Set(inner) => {
                        open.push(*inner);
                        continue;
                    }
                    Member::Label(label) => vec![*label],
                    Member::Labels(first, last, _) if first > last => continue,
                    Member::Labels(first, last, step) => {
                        let within = left.range(first..=last).map(|(&label, _)| label);
                        within.filter(|label| (label - first) % step == 0).collect()
                    }
                    Member::Places(places) => labels[places.clone()].to_vec(),
                };
                for label in taken {
                    if let Some(place) = left.remove(&label) {
                        found[place] = Some(owner);
                    }
                }
            }
        }
    }

    /// The name of a set, as the file writes it first.
    pub(super) fn name(&self, set: usize) -> &str {
        &self.sets[set].name
    }
}
