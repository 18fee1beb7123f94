//! `*RIGID BODY` and `*COUPLING`: nodes that a reference node moves, or loads.

use super::scope::Scope;
use super::words::{no_more, one_of, only};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};

/// Nodes and their reference node.
#[derive(Clone, Debug)]
pub(crate) struct RigidRow {
    pub(crate) line: usize,
    pub(crate) scope: Scope,
    /// Its keyword, as messages have it.
    pub(crate) keyword: &'static str,
    pub(crate) members: Vec<Members>,
    /// The reference node: a label or a set of one node.
    pub(crate) reference: String,
    /// CalculiX's node whose displacements are the rotations.
    pub(crate) rotating: Option<String>,
    pub(crate) kind: RigidKind,
}

/// What belongs to a reference node.
#[derive(Clone, Debug)]
pub(crate) enum Members {
    /// The nodes of a set of elements.
    Elements(String),
    /// A set of nodes.
    Nodes(String),
    /// The nodes of a surface.
    Surface(String),
    /// An analytical surface, until its elements are made.
    Analytical(String),
}

/// How nodes and their reference node go together.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum RigidKind {
    /// Nodes follow along these axes.
    Follows([bool; 3]),
    /// Nodes share the load of the reference node; its moments about these axes.
    Shares([bool; 3]),
    /// The kind of a `*COUPLING` is still to come.
    Unknown,
}

impl RigidRow {
    /// Reads `*RIGID BODY`.
    pub(super) fn read_body(keyword: &Keyword, scope: &Scope, lines: &mut Lines) -> Result<Self, Fault> {
        let sets = ["ELSET", "NSET", "TIE NSET", "PIN NSET", "ANALYTICAL SURFACE"];
        let known = [&["REF NODE", "ROT NODE"][..], &sets, &["POSITION", "ISOTHERMAL"]].concat();
        only(keyword, &known)?;
        one_of(keyword, "POSITION", &["INPUT"])?;
        one_of(keyword, "ISOTHERMAL", &["NO"])?;
        no_more(keyword, lines)?;
        let named = |name: &str| keyword.value(name).filter(|set| !set.is_empty()).map(str::to_owned);
        let of = |name: &str| {
            let set = named(name)?;
            Some(match name {
                "ELSET" => Members::Elements(set),
                "ANALYTICAL SURFACE" => Members::Analytical(set),
                _ => Members::Nodes(set),
            })
        };
        let members: Vec<Members> = sets.into_iter().filter_map(of).collect();
        if members.is_empty() {
            return Err(Fault::new(
                keyword.line,
                "*RIGID BODY needs an ELSET, NSET, TIE NSET, PIN NSET or ANALYTICAL SURFACE",
            ));
        }
        let rotating = named("ROT NODE");
        Self::new(keyword, scope, ("*RIGID BODY", members), (rotating, RigidKind::Follows([true; 3])))
    }

    /// Reads `*COUPLING`, whose kind comes with the next keyword.
    pub(super) fn begin_coupling(keyword: &Keyword, scope: &Scope, lines: &mut Lines) -> Result<Self, Fault> {
        only(keyword, &["CONSTRAINT NAME", "REF NODE", "SURFACE"])?;
        no_more(keyword, lines)?;
        let members = vec![Members::Surface(keyword.required("SURFACE")?.to_owned())];
        Self::new(keyword, scope, ("*COUPLING", members), (None, RigidKind::Unknown))
    }

    /// Reads `*KINEMATIC COUPLING`: rows of a set, a first and a last degree of freedom.
    pub(super) fn read_old(keyword: &Keyword, scope: &Scope, lines: &mut Lines) -> Result<Vec<Self>, Fault> {
        only(keyword, &["REF NODE"])?;
        let mut rows = Vec::new();
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).collect();
            let set = entries[0].trim_matches('"').to_owned();
            let kind = RigidKind::Follows(range(line, &entries[1..], 0)?.unwrap_or([true; 3]));
            let mut row = Self::new(keyword, scope, ("*KINEMATIC COUPLING", vec![Members::Nodes(set)]), (None, kind))?;
            row.line = line;
            rows.push(row);
        }
        match rows.is_empty() {
            true => Err(Fault::new(keyword.line, "*KINEMATIC COUPLING names no nodes")),
            false => Ok(rows),
        }
    }

    /// Reads `*KINEMATIC` or `*DISTRIBUTING` behind a `*COUPLING`.
    pub(super) fn read_kind(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
        let is_kinematic = keyword.name == "KINEMATIC";
        only(keyword, if is_kinematic { &[] } else { &["WEIGHTING METHOD"] })?;
        one_of(keyword, "WEIGHTING METHOD", &["UNIFORM"])?;
        if self.kind != RigidKind::Unknown {
            return Err(Fault::new(keyword.line, format!("the *COUPLING of line {} has its kind already", self.line)));
        }
        let first = if is_kinematic { 0 } else { 3 };
        let mut found: Option<[bool; 3]> = None;
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).collect();
            let axes = range(line, &entries, first)?.unwrap_or_default();
            let all = found.get_or_insert_default();
            all.iter_mut().zip(axes).for_each(|(all, axis)| *all |= axis);
        }
        self.kind = match (is_kinematic, found.unwrap_or([true; 3])) {
            (true, [false, false, false]) => {
                return Err(Fault::new(keyword.line, "*KINEMATIC has none of the degrees of freedom 1 to 3"));
            }
            (true, axes) => RigidKind::Follows(axes),
            (false, axes) => RigidKind::Shares(axes),
        };
        Ok(())
    }

    fn new(
        keyword: &Keyword,
        scope: &Scope,
        (name, members): (&'static str, Vec<Members>),
        (rotating, kind): (Option<String>, RigidKind),
    ) -> Result<Self, Fault> {
        let reference = keyword.required("REF NODE")?.to_owned();
        Ok(Self { line: keyword.line, scope: scope.clone(), keyword: name, members, reference, rotating, kind })
    }
}

/// Three axes of a first and a last degree of freedom, those from `first` on; `None` if none is there.
fn range(line: usize, entries: &[&str], first: usize) -> Result<Option<[bool; 3]>, Fault> {
    let number = |field: &str| match field.parse::<usize>() {
        Ok(number @ 1..=6) => Ok(number - 1),
        _ => Err(Fault::new(line, format!("degree of freedom {field} is not known, only 1 to 6"))),
    };
    let (low, high) = match entries {
        [] | [""] => return Ok(None),
        [only] | [only, ""] => (number(only)?, number(only)?),
        [low, high] => (number(low)?, number(high)?),
        _ => return Err(Fault::new(line, "expected a first and a last degree of freedom")),
    };
    if high < low {
        return Err(Fault::new(line, "the last degree of freedom is below the first"));
    }
    Ok(Some(std::array::from_fn(|axis| (low..=high).contains(&(first + axis)))))
}
