//! Which keyword stands where.

use super::words::only;
use crate::Fault;
use fmc_mesh_io::inp::Keyword;

/// Where a keyword stands.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Scope {
    /// Outside of all parts, or in the assembly.
    Model,
    /// In a part, by its name in upper case.
    Part(String),
    /// In an instance, by its name in upper case.
    Instance(String),
}

impl Scope {
    /// The scope after a keyword; `None` if it does not change scopes. The mesh reader has checked their order.
    pub(super) fn after(&self, keyword: &Keyword) -> Result<Option<Self>, Fault> {
        match keyword.name.as_str() {
            "PART" | "ASSEMBLY" => only(keyword, &["NAME"])?,
            "INSTANCE" => only(keyword, &["NAME", "PART"])?,
            _ => {}
        }
        Ok(match keyword.name.as_str() {
            "PART" => Some(Self::Part(keyword.required("NAME")?.to_uppercase())),
            "INSTANCE" => Some(Self::Instance(keyword.required("NAME")?.to_uppercase())),
            "END PART" | "ASSEMBLY" | "END ASSEMBLY" | "END INSTANCE" => Some(Self::Model),
            _ => None,
        })
    }
}
