//! `*MPC`: nodes that go with others.

use super::equation::{EquationRow, Term};
use super::rigid::{Members, RigidKind, RigidRow};
use super::scope::Scope;
use super::words::only;
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};

/// What rows of `*MPC` come to.
#[derive(Default)]
pub(super) struct Mpc {
    pub(super) equations: Vec<EquationRow>,
    pub(super) rigid: Vec<RigidRow>,
}

impl Mpc {
    /// Reads it: a type, the nodes that go with others, and the others, in a space of this dimension. `PIN` and `TIE` are one for nodes of solids, which do not turn.
    pub(super) fn read(keyword: &Keyword, scope: &Scope, lines: &mut Lines, dimension: usize) -> Result<Self, Fault> {
        only(keyword, &[])?;
        let mut found = Self::default();
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).map(|field| field.trim_matches('"')).collect();
            let kind = entries[0].to_uppercase();
            if !matches!(kind.as_str(), "PIN" | "TIE" | "BEAM") {
                return Err(Fault::new(line, format!("*MPC of type {kind} is not known, only BEAM, PIN and TIE")));
            }
            let [_, set, other] = entries[..] else {
                let message =
                    format!("*MPC of type {kind} needs two nodes or sets, the first of which goes with the second");
                return Err(Fault::new(line, message));
            };
            if kind == "BEAM" {
                found.rigid.push(RigidRow {
                    line,
                    scope: scope.clone(),
                    keyword: "*MPC",
                    members: vec![Members::Nodes(set.to_owned())],
                    reference: other.to_owned(),
                    rotating: None,
                    kind: RigidKind::Follows([true; 3]),
                });
                continue;
            }
            let equation = |axis: usize| {
                let term = |set: &str, factor| Term { line, set: set.to_owned(), axis, factor };
                EquationRow { line, scope: scope.clone(), terms: vec![term(set, 1.0), term(other, -1.0)] }
            };
            found.equations.extend((0..dimension).map(equation));
        }
        match found.equations.is_empty() && found.rigid.is_empty() {
            true => Err(Fault::new(keyword.line, "*MPC has no data line with a type and nodes")),
            false => Ok(found),
        }
    }
}
