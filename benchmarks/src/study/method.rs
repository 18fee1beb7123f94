//! Ways to measure overlap.

use crate::case::{Contact, EstimatorName, LawName, PatternName, WeightsName};

/// A way to measure overlap in the course of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The paper's: isotropic segments, new ones at every step, forces as they come.
    Isotropic,
    /// Families of lines that stay where they are, balance weights, forces corrected to ΣF = 0 and ΣM = 0.
    Lines,
    /// By clipping.
    Exact,
}

impl Method {
    /// All of them, the paper's first.
    pub const ALL: [Method; 3] = [Method::Isotropic, Method::Lines, Method::Exact];

    /// Name in tables and files.
    pub fn name(self) -> &'static str {
        match self {
            Method::Isotropic => "isotropic",
            Method::Lines => "lines",
            Method::Exact => "exact",
        }
    }

    /// The contact of a case measured in this way with w = k Vᵐ. `segments` is the number of isotropic fibers;
    /// `spacing` the distance between lines, m, where the case's own is not to be taken.
    pub(super) fn contact(self, of_case: &Contact, law: (f64, f64), segments: usize, spacing: Option<f64>) -> Contact {
        let (stiffness, exponent) = law;
        let contact = Contact { law: LawName::Volume, stiffness, exponent, ..of_case.clone() };
        match self {
            Method::Exact => Contact { estimator: EstimatorName::Exact, ..contact },
            Method::Lines => Contact {
                estimator: EstimatorName::Fibers,
                pattern: PatternName::Lines,
                weights: WeightsName::Balance,
                fibers: contact.fibers.filter(|_| spacing.is_none()),
                spacing: spacing.or(contact.spacing),
                new_fibers_every_step: false,
                momentum_correction: true,
                ..contact
            },
            Method::Isotropic => Contact {
                estimator: EstimatorName::Fibers,
                pattern: PatternName::Isotropic,
                fibers: Some(segments),
                spacing: None,
                new_fibers_every_step: true,
                momentum_correction: false,
                ..contact
            },
        }
    }
}
