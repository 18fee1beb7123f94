//! `*TRANSFORM`: local axes of nodes, in which they are held and loaded.

use super::scope::Scope;
use super::words::{one_of, only, only_line, present};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines};

/// Local axes of the nodes of a set.
#[derive(Clone, Debug)]
pub(crate) struct TransformRow {
    pub(crate) line: usize,
    pub(crate) scope: Scope,
    pub(crate) set: String,
    /// Whether the axes are radial, tangential and axial about the line through both points; else the first point lies on the first axis
    /// through the origin, and the second in the plane of the first two.
    pub(crate) is_cylindrical: bool,
    pub(crate) points: [[f64; 3]; 2],
}

impl TransformRow {
    /// Reads `*TRANSFORM`.
    pub(super) fn read(keyword: &Keyword, scope: &Scope, lines: &mut Lines) -> Result<Self, Fault> {
        only(keyword, &["NSET", "TYPE"])?;
        one_of(keyword, "TYPE", &["R", "C"])?;
        let set = keyword.required("NSET")?.to_owned();
        let (line, found) = only_line(keyword, lines, "two points")?;
        let mut points = [[0.0; 3]; 2];
        for (k, value) in points.iter_mut().flatten().enumerate() {
            *value = present(line, &found, k + 1, "a coordinate")?;
        }
        let is_cylindrical = keyword.value("TYPE").is_some_and(|kind| kind.eq_ignore_ascii_case("C"));
        Ok(Self { line: keyword.line, scope: scope.clone(), set, is_cylindrical, points })
    }
}
