//! Abaqus input files, `.inp`: nodes, elements, element sets, parts and their instances.
//!
//! Source: Abaqus Analysis User's Guide, "Input syntax rules", and Keywords Reference Guide. Keywords that have to do with neither nodes
//! nor elements (materials, sections, steps) are passed over; those that would make or move nodes or elements are refused by name.

use super::{Instance, Mesh};
use crate::excerpt::shortened;
use anyhow::{Context, Result, anyhow, bail, ensure};
pub use element_name::{cell_type_of_element, rigid_corners};
pub use included::Expanded;
pub use lines::{Keyword, Lines, fields, label, number};
pub use motion::Motion;
use part::Part;
use std::collections::{HashMap, HashSet};
use std::path::Path;

mod element_name;
mod included;
mod lines;
mod motion;
mod part;
mod placed;
mod sets;

/// Keywords without which a mesh would be another one than the file means.
const REFUSED: [&str; 11] = [
    "SYSTEM",
    "NGEN",
    "NFILL",
    "NCOPY",
    "NMAP",
    "ELGEN",
    "ELCOPY",
    "USER ELEMENT",
    "IMPORT",
    "SYMMETRIC MODEL GENERATION",
    "PARAMETER",
];

/// Where a keyword stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Scope {
    Model,
    Part(usize),
    Assembly,
    Instance(usize),
}

/// A part in the assembly.
struct Placed {
    name: String,
    part: Option<usize>,
    motion: Motion,
    /// Instances may have nodes and elements of their own.
    own: Part,
}

/// What a file holds.
#[derive(Default)]
struct Deck {
    model: Part,
    parts: Vec<Part>,
    part_index: HashMap<String, usize>,
    assembly: Part,
    instances: Vec<Placed>,
    instance_names: HashSet<String>,
}

/// The mesh of a file, with the files that it includes, which stand in its folder.
pub(super) fn parse(bytes: &[u8], path: Option<&Path>) -> Result<Mesh> {
    let whole = Expanded::new(&String::from_utf8_lossy(bytes), path)?;
    of_text(&whole.text, false).map_err(|error| anyhow!("{}", whole.in_files(&format!("{error:#}"))))
}

/// `leaves_rigid` leaves out rigid elements, which have no inside, as what reads them itself asks for.
pub(super) fn of_text(text: &str, leaves_rigid: bool) -> Result<Mesh> {
    let mut lines = Lines::new(text);
    let mut deck = Deck::default();
    let (mut scope, mut begun) = (Scope::Model, 0);
    while let Some(keyword) = lines.keyword() {
        let Keyword { name, line, .. } = &keyword;
        if REFUSED.contains(&name.as_str()) {
            bail!("line {line}: *{name} is not supported: write nodes and elements themselves, in one file");
        }
        ensure!(!name.contains('='), "line {line}: *{} has no comma after its name", shortened(name));
        let before = scope;
        scope = match (name.as_str(), scope) {
            ("PART", Scope::Model) => deck.begin_part(&keyword)?,
            ("END PART", Scope::Part(_)) | ("END ASSEMBLY", Scope::Assembly) => Scope::Model,
            ("ASSEMBLY", Scope::Model) => Scope::Assembly,
            ("INSTANCE", Scope::Assembly) => deck.begin_instance(&keyword, &mut lines)?,
            ("END INSTANCE", Scope::Instance(_)) => Scope::Assembly,
            ("PART" | "END PART" | "ASSEMBLY" | "END ASSEMBLY" | "INSTANCE" | "END INSTANCE", _) => {
                bail!("line {line}: *{name} stands where none can be")
            }
            _ => scope,
        };
        if scope != before {
            begun = *line;
        }
        let part = deck.part_of(scope);
        match name.as_str() {
            "NODE" => part.read_nodes(&keyword, &mut lines)?,
            "ELEMENT" if leaves_rigid && keyword.value("TYPE").is_some_and(|kind| rigid_corners(kind).is_some()) => {
                part.leave_elements(&keyword);
            }
            "ELEMENT" => part.read_elements(&keyword, &mut lines)?,
            // Sets of the assembly are of elements of its instances, which are bodies already.
            "ELSET" if scope != Scope::Assembly => part.sets.read(&keyword, &mut lines)?,
            _ => {}
        }
        if let (true, Some(set)) = (name.ends_with(" SECTION"), keyword.value("ELSET")) {
            deck.part_of(scope).sets.add_section(set);
        }
    }
    ensure!(scope == Scope::Model, "the file ends within the block that begins in line {begun}");
    deck.mesh(text.len())
}

impl Deck {
    fn begin_part(&mut self, keyword: &Keyword) -> Result<Scope> {
        let name = keyword.required("NAME")?;
        let number = self.parts.len();
        let earlier = self.part_index.insert(name.to_uppercase(), number);
        ensure!(earlier.is_none(), "line {}: part {name} is there twice", keyword.line);
        self.parts.push(Part::default());
        Ok(Scope::Part(number))
    }

    fn begin_instance(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<Scope> {
        let line = keyword.line;
        ensure!(keyword.value("LIBRARY").is_none(), "line {line}: *INSTANCE with LIBRARY= is not supported");
        let name = keyword.required("NAME")?.to_owned();
        let part = match keyword.value("PART") {
            Some(part) => {
                let found = self.part_index.get(&part.to_uppercase()).copied();
                Some(found.with_context(|| format!("line {line}: there is no part '{}'", shortened(part)))?)
            }
            None => None,
        };
        let is_new = self.instance_names.insert(name.to_uppercase());
        ensure!(is_new, "line {line}: instance {name} is there twice");
        self.instances.push(Placed { name, part, motion: Motion::read(lines)?, own: Part::default() });
        Ok(Scope::Instance(self.instances.len() - 1))
    }

    fn part_of(&mut self, scope: Scope) -> &mut Part {
        match scope {
            Scope::Model => &mut self.model,
            Scope::Part(number) => &mut self.parts[number],
            Scope::Assembly => &mut self.assembly,
            Scope::Instance(number) => &mut self.instances[number].own,
        }
    }
}
