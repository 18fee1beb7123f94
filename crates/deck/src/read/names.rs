//! Nodes and elements by their labels, and the sets of them.

use super::scope::Scope;
use super::words::only;
use crate::Fault;
use fmc_mesh_io::Mesh;
use fmc_mesh_io::inp::{Keyword, Lines, fields, label};
use std::collections::{BTreeMap, BTreeSet};

/// Nodes or elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    Node,
    Cell,
}

impl Kind {
    fn word(self) -> &'static str {
        if self == Self::Node { "node" } else { "element" }
    }
}

/// What a set was given.
#[derive(Clone, Debug)]
struct Member {
    line: usize,
    /// Name of the instance in which labels count, if the keyword names one.
    instance: Option<String>,
    what: What,
}

#[derive(Clone, Debug)]
enum What {
    /// First, last, step.
    Labels(u64, u64, u64),
    /// A label or a set, perhaps of an instance.
    Name(String),
    /// The nodes of the elements of a set.
    NodesOf(String),
}

/// An instance of a part.
#[derive(Clone, Debug)]
struct Instance {
    name: String,
    part: Option<String>,
    /// Whether a keyword places it: what stands in the model or the assembly itself is one for the mesh, too.
    is_placed: bool,
}

/// All labels and sets.
#[derive(Debug, Default)]
pub(crate) struct Names {
    instances: Vec<Instance>,
    /// Index in the mesh, by number of the instance and label.
    labels: BTreeMap<(Kind, Option<usize>, u64), usize>,
    sets: BTreeMap<(Kind, Scope, String), Vec<Member>>,
    /// Nodes of all cells, and where those of each begin, with the number of all.
    nodes_of_cells: Vec<u32>,
    first_nodes: Vec<usize>,
    /// Sets that keep the order in which they are given.
    unsorted: BTreeSet<(Kind, Scope, String)>,
}

/// Sets within sets, at most.
const MOST_LEVELS: usize = 50;

impl Names {
    /// Labels of a mesh.
    pub(super) fn new(mesh: &Mesh) -> Self {
        let mut names = Self::default();
        let instance_of = |node: usize| mesh.instances.iter().position(|instance| instance.nodes.contains(&node));
        // Instances are many or nodes are: each is looked up once.
        match mesh.instances.is_empty() {
            true => names.add(Kind::Node, mesh.node_tags.iter().enumerate().map(|(node, &tag)| (None, tag, node))),
            false => {
                let tags = mesh.node_tags.iter().enumerate();
                names.add(Kind::Node, tags.map(|(node, &tag)| (instance_of(node), tag, node)));
            }
        }
        names.first_nodes.push(0);
        for (_, nodes, ..) in mesh.cells() {
            names.nodes_of_cells.extend_from_slice(nodes);
            names.first_nodes.push(names.nodes_of_cells.len());
        }
        let has_instances = !mesh.instances.is_empty();
        let number = |group: Option<i64>| group.filter(|_| has_instances).map(|group| group as usize - 1);
        let cells = mesh.cells().enumerate().map(|(cell, (_, _, tag, group))| (number(group), tag, cell));
        names.add(Kind::Cell, cells.collect::<Vec<_>>());
        names.instances = mesh
            .instances
            .iter()
            .map(|i| Instance { name: i.name.to_uppercase(), part: None, is_placed: false })
            .collect();
        names
    }

    fn add(&mut self, kind: Kind, entries: impl IntoIterator<Item = (Option<usize>, u64, usize)>) {
        self.labels.extend(entries.into_iter().map(|(instance, label, index)| ((kind, instance, label), index)));
    }

    /// Notes which part an instance is of.
    pub(super) fn instance(&mut self, keyword: &Keyword) {
        let value = |name| keyword.value(name).map(str::to_uppercase);
        if let Some(instance) =
            self.instances.iter_mut().find(|instance| Some(&instance.name) == value("NAME").as_ref())
        {
            instance.part = value("PART");
            instance.is_placed = true;
        }
    }

    /// Reads `*NSET` or `*ELSET`.
    pub(super) fn read(
        &mut self,
        kind: Kind,
        keyword: &Keyword,
        scope: &Scope,
        lines: &mut Lines,
    ) -> Result<(), Fault> {
        let parameter = if kind == Kind::Node { "NSET" } else { "ELSET" };
        let known = ["NSET", "ELSET", "GENERATE", "INSTANCE", "INTERNAL", "UNSORTED"];
        only(keyword, if kind == Kind::Node { &known } else { &known[1..] })?;
        let name = keyword.required(parameter)?.to_owned();
        let instance = keyword.value("INSTANCE").map(str::to_owned);
        let mut members = Vec::new();
        if let (Kind::Node, Some(set)) = (kind, keyword.value("ELSET")) {
            let what = What::NodesOf(set.trim_matches('"').to_owned());
            members.push(Member { line: keyword.line, instance: instance.clone(), what });
        }
        while let Some((line, text)) = lines.data() {
            let of = |what| Member { line, instance: instance.clone(), what };
            if keyword.value("GENERATE").is_none() {
                let names = fields(text).filter(|field| !field.is_empty()).map(|field| field.trim_matches('"'));
                members.extend(names.map(|name| of(What::Name(name.to_owned()))));
                continue;
            }
            let numbers = fields(text).map(|field| label(line, field)).collect::<anyhow::Result<Vec<u64>>>()?;
            members.push(match numbers[..] {
                [first, last] => of(What::Labels(first, last, 1)),
                [first, last, step] => of(What::Labels(first, last, step)),
                _ => return Err(Fault::new(line, "expected first, last and step of a set")),
            });
        }
        if keyword.value("UNSORTED").is_some() {
            self.unsorted.insert((kind, scope.clone(), name.to_uppercase()));
        }
        self.extend(kind, scope, &name, members);
        Ok(())
    }

    /// The element with a label.
    pub(super) fn cell(&self, instance: Option<usize>, label: u64) -> Option<usize> {
        self.labels.get(&(Kind::Cell, instance, label)).copied()
    }

    /// The node with a label.
    pub(super) fn node(&self, instance: Option<usize>, label: u64) -> Option<usize> {
        self.keys(instance).into_iter().find_map(|key| self.labels.get(&(Kind::Node, key, label)).copied())
    }

    /// Adds an element that the mesh will have as `cell`, its last until now; `false` if its label is there already.
    pub(super) fn add_cell(&mut self, instance: Option<usize>, label: u64, cell: usize, nodes: &[usize]) -> bool {
        self.nodes_of_cells.extend(nodes.iter().map(|&node| node as u32));
        self.first_nodes.push(self.nodes_of_cells.len());
        self.labels.insert((Kind::Cell, instance, label), cell).is_none()
    }

    /// Where labels of an instance are kept; those of no instance also where the model or the assembly has them.
    fn keys(&self, instance: Option<usize>) -> Vec<Option<usize>> {
        let rest = self.instances.iter().enumerate().filter(|(_, other)| instance.is_none() && !other.is_placed);
        std::iter::once(instance).chain(rest.map(|(number, _)| Some(number))).collect()
    }

    /// Adds labels, each with its line, to a set.
    pub(super) fn put(&mut self, kind: Kind, scope: &Scope, name: &str, line: usize, labels: &[(u64, usize)]) {
        let member = |&(label, _): &(u64, usize)| Member { line, instance: None, what: What::Labels(label, label, 1) };
        self.extend(kind, scope, name, labels.iter().map(member).collect());
    }

    fn extend(&mut self, kind: Kind, scope: &Scope, name: &str, members: Vec<Member>) {
        self.sets.entry((kind, scope.clone(), name.to_uppercase())).or_default().extend(members);
    }

    /// Instances of a scope: all of a part, the one of an instance, none of the model.
    pub(crate) fn instances_of(&self, scope: &Scope) -> Vec<Option<usize>> {
        let matching = |of: &dyn Fn(&Instance) -> bool| {
            let numbers = self.instances.iter().enumerate().filter(|(_, instance)| of(instance));
            numbers.map(|(number, _)| Some(number)).collect()
        };
        match scope {
            Scope::Model => vec![None],
            Scope::Part(part) => matching(&|instance| instance.part.as_ref() == Some(part)),
            Scope::Instance(name) => matching(&|instance| instance.name == *name),
        }
    }

    /// Scopes in which names of an instance are looked for.
    pub(crate) fn scopes_of(&self, instance: Option<usize>) -> Vec<Scope> {
        let Some(Instance { name, part, .. }) = instance.map(|number| &self.instances[number]) else {
            return vec![Scope::Model];
        };
        [Some(Scope::Instance(name.clone())), part.clone().map(Scope::Part)].into_iter().flatten().collect()
    }

    /// The number of an instance, and the rest of a name `instance.rest`.
    pub(crate) fn split<'a>(&self, name: &'a str) -> (Option<usize>, &'a str) {
        // Names of instances may have points in them.
        let is = |prefix: &str| self.instances.iter().position(|instance| instance.name == prefix.to_uppercase());
        let found = name.match_indices('.').find_map(|(at, _)| Some((is(&name[..at])?, &name[at + 1..])));
        found.map_or((None, name), |(number, rest)| (Some(number), rest))
    }

    /// Nodes or elements of a set or label, ascending, at least one; `instance` is where it is looked for.
    pub(crate) fn find(
        &self,
        kind: Kind,
        instance: Option<usize>,
        name: &str,
        line: usize,
    ) -> Result<Vec<usize>, Fault> {
        let mut found = Vec::new();
        self.collect(kind, instance, name, line, 0, &mut found)?;
        if found.is_empty() {
            return Err(Fault::new(line, format!("{} set '{name}' is empty", kind.word())));
        }
        found.sort_unstable();
        found.dedup();
        Ok(found)
    }

    /// The same in the order of labels, or for sets with `UNSORTED` in that of the file: how sets are taken that belong together.
    pub(crate) fn find_in_order(
        &self,
        kind: Kind,
        instance: Option<usize>,
        name: &str,
        line: usize,
    ) -> Result<Vec<usize>, Fault> {
        let sorted = self.find(kind, instance, name, line)?;
        let (of, rest) = match instance {
            None => self.split(name),
            some => (some, name),
        };
        let mut scopes = self.scopes_of(of).into_iter();
        if scopes.any(|scope| self.unsorted.contains(&(kind, scope, rest.to_uppercase()))) {
            let (mut found, mut seen) = (Vec::new(), BTreeSet::new());
            self.collect(kind, instance, name, line, 0, &mut found)?;
            found.retain(|index| seen.insert(*index));
            return Ok(found);
        }
        let is_found: BTreeSet<usize> = sorted.into_iter().collect();
        let of_kind = self.labels.iter().filter(|((of, ..), index)| *of == kind && is_found.contains(index));
        Ok(of_kind.map(|(_, &index)| index).collect())
    }

    fn collect(
        &self,
        kind: Kind,
        instance: Option<usize>,
        name: &str,
        line: usize,
        level: usize,
        found: &mut Vec<usize>,
    ) -> Result<(), Fault> {
        if level > MOST_LEVELS {
            return Err(Fault::new(line, format!("set {name} contains itself")));
        }
        let (instance, rest) = match instance {
            None => self.split(name),
            some => (some, name),
        };
        if let Ok(label) = rest.parse::<u64>() {
            let mut indices = self.keys(instance).into_iter().filter_map(|key| self.labels.get(&(kind, key, label)));
            let index = indices.next();
            found.push(*index.ok_or_else(|| Fault::new(line, format!("there is no {} {name}", kind.word())))?);
            return match indices.next() {
                Some(_) => Err(Fault::new(line, format!("{} {name} is in the model and in the assembly", kind.word()))),
                None => Ok(()),
            };
        }
        let key = rest.to_uppercase();
        let of = |scope: Scope| self.sets.get(&(kind, scope, key.clone()));
        let Some(members) = self.scopes_of(instance).into_iter().find_map(of) else {
            return Err(Fault::new(line, format!("there is no {} set '{name}'", kind.word())));
        };
        for Member { line, instance: named, what } in members {
            let instance = match named {
                Some(name) => {
                    let number = self.instances.iter().position(|i| i.name == name.to_uppercase());
                    Some(number.ok_or_else(|| Fault::new(*line, format!("there is no instance '{name}'")))?)
                }
                None => instance,
            };
            match what {
                What::Labels(first, last, _) if first > last => {}
                What::Labels(first, last, step) => {
                    let before = found.len();
                    for key in self.keys(instance) {
                        let range = self.labels.range((kind, key, *first)..=(kind, key, *last));
                        let steps = range.filter(|((.., label), _)| (label - first) % step == 0);
                        found.extend(steps.map(|(_, index)| *index));
                    }
                    if found.len() == before {
                        let word = kind.word();
                        return Err(Fault::new(*line, format!("there is no {word} {first} to {last} of set '{name}'")));
                    }
                }
                What::NodesOf(set) => {
                    let mut cells = Vec::new();
                    self.collect(Kind::Cell, instance, set, *line, level + 1, &mut cells)?;
                    let nodes = |cell: usize| &self.nodes_of_cells[self.first_nodes[cell]..self.first_nodes[cell + 1]];
                    found.extend(cells.into_iter().flat_map(nodes).map(|&node| node as usize));
                }
                What::Name(name) => self.collect(kind, instance, name, *line, level + 1, found)?,
            }
        }
        Ok(())
    }
}
