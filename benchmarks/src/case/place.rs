//! Where a body is held or loaded.

use serde::{Deserialize, Serialize};

/// Part of a body, in the reference configuration. Exactly one form: a side, a plane, or a box.
///
/// Nodes count as on a side or in a plane within 1e-6 of the body's size, and as in a box with the same margin. A face
/// belongs to the place if all its nodes do.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Place {
    /// Extreme side of the body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side: Option<Side>,
    /// Axis perpendicular to a plane …
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<Axis>,
    /// … at this coordinate, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<f64>,
    /// Lowest corner of a box, `[D]`, m …
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min: Option<Vec<f64>>,
    /// … and its highest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max: Option<Vec<f64>>,
}

/// Side of a body's bounding box. Down is along the last axis: y in 2D, z in 3D.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// Least x.
    Left,
    /// Largest x.
    Right,
    /// Least y, in 3D.
    Front,
    /// Largest y, in 3D.
    Back,
    /// Least y in 2D, least z in 3D.
    Bottom,
    /// Largest y in 2D, largest z in 3D.
    Top,
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// First.
    X,
    /// Second.
    Y,
    /// Third.
    Z,
}

/// `[[supports]]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Name of the body.
    pub body: String,
    /// The held nodes.
    #[serde(rename = "where")]
    pub place: Place,
    /// Prescribed components of the displacement.
    pub components: Vec<Axis>,
    /// Their values, m, in the same order; zero if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub values: Option<Vec<f64>>,
    /// Their values at the end of each further stage of `[load_steps]`, in the same order; the first values if absent.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub then: Vec<Vec<f64>>,
}

/// `[[loads]]`. Exactly one of traction, pressure and body force; constant in time, on the reference configuration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// Name of the body.
    pub body: String,
    /// The loaded faces; not for a body force.
    #[serde(rename = "where", default, skip_serializing_if = "Option::is_none")]
    pub place: Option<Place>,
    /// Force per area, `[D]`, Pa.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub traction: Option<Vec<f64>>,
    /// Force per area against the outward normal, Pa.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure: Option<f64>,
    /// Force per volume, `[D]`, N/m³.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body_force: Option<Vec<f64>>,
}

impl Side {
    /// Axis that the side lies across, and whether it is its high end.
    pub fn direction(self, dimension: usize) -> (usize, bool) {
        match self {
            Side::Left => (0, false),
            Side::Right => (0, true),
            Side::Front => (1, false),
            Side::Back => (1, true),
            Side::Bottom => (dimension - 1, false),
            Side::Top => (dimension - 1, true),
        }
    }
}

impl Axis {
    /// 0, 1 or 2.
    pub fn index(self) -> usize {
        self as usize
    }
}

impl Place {
    /// Whether a point of a body with these bounds belongs to the place; `None` if it has no form, or several.
    pub fn holds<const D: usize>(&self, x: &[f64; D], low: &[f64; D], high: &[f64; D]) -> Option<bool> {
        let size = (0..D).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        let margin = 1e-6 * size;
        match self {
            Place { side: Some(side), axis: None, at: None, min: None, max: None } => {
                let (axis, is_high) = side.direction(D);
                Some((x[axis] - if is_high { high[axis] } else { low[axis] }).abs() <= margin)
            }
            Place { side: None, axis: Some(axis), at: Some(at), min: None, max: None } => {
                Some((x.get(axis.index())? - at).abs() <= margin)
            }
            Place { side: None, axis: None, at: None, min: Some(min), max: Some(max) } => {
                let (min, max): ([f64; D], [f64; D]) = (min[..].try_into().ok()?, max[..].try_into().ok()?);
                Some((0..D).all(|axis| x[axis] >= min[axis] - margin && x[axis] <= max[axis] + margin))
            }
            _ => None,
        }
    }
}
