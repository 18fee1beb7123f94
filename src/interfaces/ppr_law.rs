//! The cohesive law of Park, Paulino and Roesler (J. Mech. Phys. Solids 57, 2009), whose tractions have a potential while both openings grow.
//!
//! ```text
//! x = κ_n/δ_n,  y = κ_t/δ_t                     κ: the largest opening and sliding so far, δ: where the traction ends
//! a(x) = (1 − x)^α (1 + α x/m)^m                α, β: shapes;  m = α (α − 1) λ²/(1 − α λ²),  λ: where the strength is, by δ
//! F_t(y) = max(φ b(y) − φ + φ_n, 0)             φ_n, φ_t: energies of fracture, φ the larger; b(y), F_n(x) as a(x), F_t(y)
//! t_n = −a′(x)/δ_n F_t(y),  t_t = −b′(y)/δ_t F_n(x)
//! a′(x) = −x A(x),   A(x) = α (1 + α/m) (1 − x)^(α−1) (1 + α x/m)^(m−1)
//! δ_n = φ_n/σ λ A(λ)
//! ```
//!
//! Below the largest openings each traction falls along a line to the origin: k_n = A(x) F_t(y)/δ_n², k_t = B(y) F_n(x)/δ_t². Both fall as
//! either opening grows on, so every path dissipates and nothing heals. In the paper a traction goes on with the other opening of now, by
//! which an interface that is slid back has its strength again.

use super::point_state::{PointState, Response};
use crate::Error;

/// Shapes and initial slopes of the law of Park, Paulino and Roesler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ppr {
    /// Shape α of softening in opening, above 1: below 2 the traction falls late, about 2 along a line, above it early with a long tail.
    pub normal_shape: f64,
    /// Shape β of sliding.
    pub shear_shape: f64,
    /// λ_n: the opening at the strength by that at which the traction ends, above 0, at most 1/√(2α − 1). A small one is a steep rise.
    pub normal_slope: f64,
    /// λ_t, by β.
    pub shear_slope: f64,
}

impl Default for Ppr {
    /// Softening along a line, nearly, from a twentieth of the opening at which it ends: a smaller part is a much stiffer start.
    fn default() -> Self {
        Self { normal_shape: 2.0, shear_shape: 2.0, normal_slope: 0.05, shear_slope: 0.05 }
    }
}

impl Ppr {
    /// Refuses what is no such law.
    pub(super) fn check(&self) -> Result<(), Error> {
        let sides = [
            (["normal_shape", "normal_slope"], self.normal_shape, self.normal_slope),
            (["shear_shape", "shear_slope"], self.shear_shape, self.shear_slope),
        ];
        for (names, shape, slope) in sides {
            for (name, value) in names.into_iter().zip([shape, slope]) {
                if !(value.is_finite() && value > 0.0) {
                    return Err(Error::NotPositive { name, value });
                }
            }
            if shape <= 1.0 {
                let what = "a normal_shape or a shear_shape of the cohesive law ppr that is not above 1: its traction would end with a jump";
                return Err(Error::Unsupported { what });
            }
            if slope * slope * (2.0 * shape - 1.0) > 1.0 {
                let what = "a normal_slope or a shear_slope of the cohesive law ppr above 1/√(2 shape − 1): the interface would stiffen as it opens";
                return Err(Error::Unsupported { what });
            }
        }
        Ok(())
    }
}

/// One of both directions.
#[derive(Clone, Copy)]
struct Side {
    shape: f64,
    m: f64,
    /// λ, the opening at which the traction ends, and the energy of fracture.
    slope: f64,
    end: f64,
    energy: f64,
    /// How much larger the other energy is.
    missing: f64,
}

impl Side {
    fn new([shape, slope]: [f64; 2], strength: f64, [energy, other]: [f64; 2]) -> Self {
        let m = shape * (shape - 1.0) * slope * slope / (1.0 - shape * slope * slope);
        let missing = (other - energy).max(0.0);
        let mut side = Self { shape, m, slope, end: 1.0, energy, missing };
        side.end = energy / strength * slope * side.stiffness(slope);
        side
    }

    /// a(x).
    fn left(&self, x: f64) -> f64 {
        (1.0 - x).powf(self.shape) * (1.0 + self.shape * x / self.m).powf(self.m)
    }

    /// A(x).
    fn stiffness(&self, x: f64) -> f64 {
        let Self { shape, m, .. } = *self;
        shape * (1.0 + shape / m) * (1.0 - x).powf(shape - 1.0) * (1.0 + shape * x / m).powf(m - 1.0)
    }

    /// A′(x), 0 where nothing is left.
    fn stiffness_slope(&self, x: f64) -> f64 {
        let Self { shape, m, .. } = *self;
        if x >= 1.0 {
            return 0.0;
        }
        self.stiffness(x) * ((m - 1.0) * shape / (m + shape * x) - (shape - 1.0) / (1.0 - x))
    }

    /// What the other direction leaves of this one's energy, where its own a is so much, and how that changes by this.
    fn energy_left(&self, left: f64) -> [f64; 2] {
        let all = self.energy + self.missing;
        let energy = if self.missing > 0.0 { all * left - self.missing } else { all * left };
        if energy > 0.0 { [energy, all] } else { [0.0; 2] }
    }
}

/// The law, ready to be asked.
#[derive(Clone, Copy)]
pub(super) struct PprLaw([Side; 2]);

/// What is known at the largest openings: by direction a, A, and what is left of the energy with its derivative by the other's a.
struct Known {
    at: [f64; 2],
    left: [f64; 2],
    stiffness: [f64; 2],
    energy: [[f64; 2]; 2],
}

impl PprLaw {
    pub(super) fn new(ppr: &Ppr, [normal, shear]: [f64; 2], [opening, sliding]: [f64; 2]) -> Self {
        Self([
            Side::new([ppr.normal_shape, ppr.normal_slope], normal, [opening, sliding]),
            Side::new([ppr.shear_shape, ppr.shear_slope], shear, [sliding, opening]),
        ])
    }

    /// Where the tractions end.
    pub(super) fn ends(&self) -> [f64; 2] {
        self.0.map(|side| side.end)
    }

    /// Without damage.
    pub(super) fn stiffness(&self) -> [f64; 2] {
        self.0.map(|side| side.stiffness(0.0) * side.energy / (side.end * side.end))
    }

    /// The largest tractions in pure opening and in pure sliding that are left.
    pub(super) fn strengths_left(&self, past: &PointState) -> [f64; 2] {
        let known = self.known(reached(past));
        [0, 1].map(|k| {
            let side = &self.0[k];
            let most = known.at[k].max(side.slope);
            most * side.stiffness(most) / side.end * known.energy[k][0]
        })
    }

    fn known(&self, at: [f64; 2]) -> Known {
        let left = [0, 1].map(|k| self.0[k].left(at[k]));
        let stiffness = [0, 1].map(|k| self.0[k].stiffness(at[k]));
        Known { at, left, stiffness, energy: [0, 1].map(|k| self.0[k].energy_left(left[1 - k])) }
    }

    /// At an opening and a squared sliding, after what a point has been through.
    pub(super) fn response(&self, past: &PointState, opening: f64, sliding2: f64) -> Response {
        let ends = self.ends();
        let openings = [opening.max(0.0), sliding2.sqrt()];
        let before = self.known(reached(past));
        let wanted = [0, 1].map(|k| (openings[k] / ends[k]).min(1.0));
        let grows = [0, 1].map(|k| wanted[k] > before.at[k]);
        let now = self.known([0, 1].map(|k| wanted[k].max(before.at[k])));
        let stiffness = [0, 1].map(|k| now.stiffness[k] * now.energy[k][0] / (ends[k] * ends[k]));
        let mut state = *past;
        if grows[0] || grows[1] {
            remember(&mut state, now.at);
            state.damage.dissipated += self.dissipated(&before, &now, openings, grows);
        }
        // By a direction: how much its stiffness falls with its own opening, and with the other.
        let own = |k: usize| match grows[k] {
            true => self.0[k].stiffness_slope(now.at[k]) * now.energy[k][0] / ends[k].powi(3),
            false => 0.0,
        };
        let by_other = |k: usize| match grows[1 - k] {
            true => -now.stiffness[0] * now.stiffness[1] * now.energy[k][1] / (ends[k] * ends[1 - k]).powi(2),
            false => 0.0,
        };
        let by_sliding = if openings[1] > 0.0 { own(1) / openings[1] } else { 0.0 };
        let coupled = [openings[0] * own(0), openings[0] * by_other(0), openings[0] * by_other(1), by_sliding];
        let pressed = opening - openings[0];
        let normal_stiffness = if opening > 0.0 { stiffness[0] } else { self.stiffness()[0] };
        Response {
            now: state,
            stored: 0.5
                * (stiffness[0] * openings[0].powi(2) + stiffness[1] * sliding2 + normal_stiffness * pressed.powi(2)),
            normal: normal_stiffness * opening,
            normal_stiffness,
            shear_stiffness: stiffness[1],
            growth: None,
            coupled: (grows[0] || grows[1]).then_some(coupled),
        }
    }

    /// Energy by area that is lost as the largest openings grow, first that along the normal: work less what is stored more. While both grow the
    /// order does not matter.
    fn dissipated(&self, before: &Known, now: &Known, openings: [f64; 2], grows: [bool; 2]) -> f64 {
        let ends = self.ends();
        let mut lost = 0.0;
        for k in [0, 1] {
            // Sliding grows at the opening there is by then, and the opening at the sliding there was.
            let other = if k == 0 { before } else { now };
            let energy = self.0[k].energy_left(other.left[1 - k])[0];
            let work = energy * (before.left[k] - now.left[k]);
            let squares = now.stiffness[k] * now.at[k].powi(2) - before.stiffness[k] * before.at[k].powi(2);
            let strained = match (k, grows[1 - k]) {
                (0, true) => before.at[1],
                _ => openings[1 - k] / ends[1 - k],
            };
            let fallen = self.0[1 - k].energy_left(before.left[k])[0] - self.0[1 - k].energy_left(now.left[k])[0];
            lost += work - 0.5 * energy * squares + 0.5 * strained.min(1.0).powi(2) * fallen * other.stiffness[1 - k];
        }
        lost.max(0.0)
    }
}

/// The largest openings so far, by those at which tractions end. The larger of both is the damage; the smaller is kept beside it, plus 2 where it
/// is the opening. A damage that was set alone is one of opening.
fn reached(past: &PointState) -> [f64; 2] {
    let (most, kept) = (past.damage.damage, past.history.reached);
    if kept >= 2.0 { [(kept - 2.0).min(most), most] } else { [most, kept.min(most)] }
}

/// The reverse of [`reached`]; of the smaller it keeps what a sum with 2 does.
fn remember(state: &mut PointState, [x, y]: [f64; 2]) {
    (state.damage.damage, state.history.reached) = if y > x { (y, 2.0 + x) } else { (x, y) };
}
