//! What a case file says.

use super::{Body, Contact, Expected, Load, LoadSteps, Obstacle, Support, Time};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The keys of a case file outside of its tables.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Title, one line.
    pub title: String,
    /// Source of the problem: an article and section, for example.
    #[serde(default)]
    pub source: String,
    /// D: 2 (plane strain) or 3.
    pub dimension: usize,
    /// The elastic bodies, in the order of their nodes.
    pub bodies: Vec<Body>,
    /// Prescribed displacements.
    #[serde(default)]
    pub supports: Vec<Support>,
    /// Loads. They act from the start to the end.
    #[serde(default)]
    pub loads: Vec<Load>,
    /// Rigid obstacles.
    #[serde(default)]
    pub obstacles: Vec<Obstacle>,
    /// Energy law and estimator.
    pub contact: Contact,
    /// Step and duration of a motion. A case has `time` or `load_steps`.
    #[serde(default, skip_serializing_if = "Time::is_absent")]
    pub time: Time,
    /// Steps to an equilibrium.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_steps: Option<LoadSteps>,
    /// Files in addition to the history.
    #[serde(default)]
    pub output: Output,
    /// The figures that the run computes; contact forces and penetration if absent.
    #[serde(default)]
    pub figures: Figures,
    /// Named sets of changes.
    #[serde(default)]
    pub variants: BTreeMap<String, Variant>,
    /// Expected figures.
    #[serde(default)]
    pub expected: Vec<Expected>,
}

/// `[output]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Number of intervals between written fields. The first field shows the start.
    pub frames: u64,
    /// Whether the fields also become an animation (2D only).
    pub animation: bool,
    /// Largest number of fibers of an equilibrium that are written. Of more, an even selection is written.
    pub fibers: usize,
}

/// `[figures]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figures {
    /// The set of figures.
    #[serde(default)]
    pub kind: FigureKind,
    /// The body whose figures are computed; if absent, the first that moves at the start, else the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<String>,
    /// Number of copies of the model that symmetry joins to the whole. Forces are the sum over all copies.
    #[serde(default = "one")]
    pub copies: usize,
    /// Pressures to compare with, `[[place, pressure], …]`, in ascending places.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub profile: Vec<[f64; 2]>,
}

fn one() -> usize {
    1
}

impl Default for Figures {
    fn default() -> Self {
        Self { kind: FigureKind::default(), body: None, copies: one(), profile: Vec::new() }
    }
}

/// Sets of figures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FigureKind {
    /// Of any case: the largest contact force on the body, and the force at the end, in magnitude.
    #[default]
    Forces,
    /// A bar that falls on a rigid wall: pressure, contact time, exit velocity, energy.
    Wall,
    /// A body that hits another one: impulse, contact time, rebound, energy, balance.
    Impact,
    /// Blocks under uniform pressure: largest error of the stress.
    Patch,
    /// A half-disc on a rigid plane: force, pressure and half width against Hertz.
    Hertz,
    /// A ball on its mirror image, or on a rigid plane: force, pressure and radius against Hertz.
    Balls,
    /// A block pressed on a rigid wedge: force, half width, pressures.
    Wedge,
    /// A block pressed on a rigid cone: force, radius, pressures.
    Cone,
    /// A flat punch on a block: force, pressures in the middle and at the edge.
    Punch,
    /// A die that slides over a block: forces and their ripple.
    Ironing,
    /// A body that slides on a floor until friction has stopped it: distance, energy.
    Stop,
    /// A body that is pressed on another and pushed along: ratio of both forces, sticking part, dissipated energy.
    Sliding,
    /// A body that its supports move forward, and perhaps back: force, work, and the remaining work over a closed path.
    Driven,
}

/// `[variants.NAME]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Variant {
    /// Description, one line.
    pub about: String,
    /// Changed keys, nested as in the file. Entries of lists are named by their `name`.
    pub set: toml::Table,
}

impl FigureKind {
    /// Whether they are taken from an equilibrium, not from a motion; none if from either.
    pub fn is_static(self) -> Option<bool> {
        match self {
            FigureKind::Forces => None,
            FigureKind::Wall | FigureKind::Impact | FigureKind::Stop => Some(false),
            _ => Some(true),
        }
    }

    /// Keys of the figures, in the order of the report.
    pub fn keys(self) -> &'static [&'static str] {
        match self {
            FigureKind::Forces => &["force_peak", "force_end", "penetration_max"],
            FigureKind::Wall => {
                &["pressure_mean", "pressure_rms", "contact_start", "contact_end", "exit_velocity", "energy_error_max"]
            }
            FigureKind::Impact => &[
                "impulse",
                "contact_start",
                "contact_end",
                "rebound",
                "sideways",
                "energy_drift",
                "force_peak",
                "balance_max",
            ],
            FigureKind::Patch => &["stress_error_max", "penetration_max", "nodes"],
            FigureKind::Balls => &["force", "peak_pressure", "contact_radius", "penetration_max"],
            FigureKind::Wedge => &[
                "force",
                "half_width",
                "half_width_current",
                "profile_error_true",
                "profile_error_closed_form",
                "penetration_max",
            ],
            FigureKind::Cone => &["force", "contact_radius", "profile_error", "radial_spread", "penetration_max"],
            FigureKind::Punch => &["force", "pressure_center", "pressure_edge", "profile_error", "penetration_max"],
            FigureKind::Ironing => {
                &["force_y_mean", "ripple_rms", "ripple_peak_to_peak", "force_x_mid", "steps_failed", "penetration_max"]
            }
            FigureKind::Stop => &["way", "energy_error_max", "dissipated", "dissipated_least", "exit_velocity"],
            FigureKind::Sliding => &[
                "force_ratio",
                "force_across",
                "stick_ratio",
                "stick_error",
                "dissipated",
                "dissipated_least",
                "steps_failed",
                "penetration_max",
            ],
            FigureKind::Driven => &[
                "force_peak",
                "force_least",
                "work_peak",
                "work_error",
                "loop_error",
                "steps_failed",
                "penetration_max",
            ],
            FigureKind::Hertz => &[
                "force",
                "half_width",
                "peak_pressure",
                "profile_error",
                "profile_error_inner",
                "penetration_max",
                "nodes",
            ],
        }
    }
}

impl Default for Output {
    fn default() -> Self {
        Self { frames: 50, animation: false, fibers: 20_000 }
    }
}

impl Case {
    /// Whether the case fulfils what a file must: for one that was changed after it was read.
    ///
    /// # Errors
    /// What is wrong with it first.
    pub fn check(&self) -> anyhow::Result<()> {
        match super::check::flaws(self).into_iter().next() {
            Some((key, message)) => anyhow::bail!("{}: {message}", key.0.join(".")),
            None => Ok(()),
        }
    }

    /// Index of the body that the figures are about.
    pub fn figured(&self) -> usize {
        let named = self.figures.body.as_ref().and_then(|name| self.body(name));
        named.or_else(|| self.bodies.iter().position(Body::moves)).unwrap_or(0)
    }

    /// The support that drives the figures' body: that which moves it farthest in the first stage, with the number of its component and the
    /// displacement.
    pub fn driver(&self) -> Option<(&Support, usize, f64)> {
        let body = self.bodies.get(self.figured())?;
        let moved = self.supports.iter().filter(|support| support.body == body.name).flat_map(|support| {
            let values = support.values.iter().flatten().copied().enumerate();
            values.map(move |(component, value)| (support, component, value))
        });
        moved.filter(|(.., value)| *value != 0.0).max_by(|p, q| p.2.abs().total_cmp(&q.2.abs()))
    }

    /// Index of a body by its name.
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|body| body.name == name)
    }
}
