//! How a cohesive interface resists opening and sliding, and how it breaks.
//!
//! ```text
//! Y = (k_n ⟨δ_n⟩² + k_t |δ_t|²)/2               δ_n: opening, δ_t: sliding, ⟨δ⟩ = max(δ, 0)
//! B = k_t |δ_t|² / (2 Y)                        part of sliding (mixed mode)
//! G(B) = G_n + (G_t − G_n) B^η                  energy of fracture (Benzeggagh, Kenane 1996)
//! Y₀(B) = G(B)/m,   m = 2 k_n G_n/σ_n²          where damage begins
//! q = √(Y/Y₀),   d = max over time of D(q)      damage
//! t = (1 − d) (k_n ⟨δ_n⟩ n + k_t δ_t) − k_n ⟨−δ_n⟩ n
//! ```
//!
//! (or as `ppr_law` has it). In one mode this is a straight rise to the strength at q = 1, and a straight or exponential fall that encloses G with the opening; q = m is
//! where a straight fall ends. The stiffness of sliding is k_t = k_n (G_n/G_t) (σ_t/σ_n)², by which m is the same in all modes: damage
//! then never falls as the mode changes, and each path dissipates (Turon, Camanho, Costa, Renart 2010).

use super::broken_friction::BrokenFriction;
use super::point_state::{PointDamage, PointState, Response};
use super::ppr_law::{Ppr, PprLaw};
use crate::Error;

/// What m is by default: damage begins at a hundredth of the opening at which the interface is broken.
const BRITTLE: f64 = 100.0;

/// The largest m: at a traction of half the strength 1 − d is 1/m or so, of which rounding of d then takes a part of 1e-6.
const MOST_BRITTLE: f64 = 1e10;

/// Rounds in which the opening of a damage is found; it converges quadratically, from one side.
const ROUNDS: usize = 64;

/// How a cohesive interface breaks: strengths and energies, all by area of the undeformed interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cohesive {
    /// Traction at which damage begins in pure opening.
    pub normal_strength: f64,
    /// Traction at which damage begins in pure sliding.
    pub shear_strength: f64,
    /// Energy by area that pure opening takes until the interface is broken, G_Ic.
    pub normal_energy: f64,
    /// Energy by area that pure sliding takes, G_IIc.
    pub shear_energy: f64,
    /// Exponent η of Benzeggagh and Kenane, at least 1, by which the two are mixed.
    pub exponent: f64,
    /// Traction by opening without damage, and in compression; 0: so much that damage begins at a hundredth of the opening at which
    /// a linear softening ends, 50 σ²/G. It is more than σ²/(2 G), and at most 5e9 σ²/G.
    pub stiffness: f64,
    /// How the traction falls.
    pub softening: Softening,
    /// How far apart faces that belong together may be, or how far they may overlap, a length; 0: a tenth of the mean facet
    /// of the body with the larger facets, all its faces included.
    pub reach: f64,
    /// A time η, 0 by default: without. Damage then lags behind the law, d' = (D − d)/η, so that larger tractions are carried for a while;
    /// [`Contact::set_time_step`](crate::Contact::set_time_step) says how long a step takes. What it dissipates is told apart.
    pub viscosity: f64,
}

/// How the traction of a cohesive interface falls as it opens.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Softening {
    /// Along a straight line.
    #[default]
    Linear,
    /// Exponentially: it never quite ends.
    Exponential,
    /// By the potential of Park, Paulino and Roesler, which says how it rises, too, and mixes both modes: it has neither an `exponent` nor a
    /// `stiffness` beside it, nor a `viscosity`. Every opening damages, and [`PointDamage::damage`] is the largest opening or sliding by that
    /// at which the traction ends.
    Ppr(Ppr),
}

impl Cohesive {
    /// The exponent by default.
    pub(crate) const EXPONENT: f64 = 2.0;

    /// One that breaks alike in opening and in sliding, with a linear softening and the default stiffness.
    pub fn new(strength: f64, energy: f64) -> Self {
        Self {
            normal_strength: strength,
            shear_strength: strength,
            normal_energy: energy,
            shear_energy: energy,
            exponent: Self::EXPONENT,
            stiffness: 0.0,
            softening: Softening::Linear,
            reach: 0.0,
            viscosity: 0.0,
        }
    }

    /// What m is: the energy of fracture by that where damage begins.
    fn brittleness(&self) -> f64 {
        match self.stiffness > 0.0 {
            true => 2.0 * self.stiffness * self.normal_energy / (self.normal_strength * self.normal_strength),
            false => BRITTLE,
        }
    }

    /// Refuses what is no such interface.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let positive = [
            ("normal_strength", self.normal_strength),
            ("shear_strength", self.shear_strength),
            ("normal_energy", self.normal_energy),
            ("shear_energy", self.shear_energy),
        ];
        for (name, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::NotPositive { name, value });
            }
        }
        Error::check_not_negative("reach", self.reach)?;
        Error::check_not_negative("stiffness", self.stiffness)?;
        Error::check_not_negative("viscosity", self.viscosity)?;
        if !(self.exponent.is_finite() && self.exponent >= 1.0) {
            return Err(Error::NotPositive { name: "mixed_mode_exponent", value: self.exponent });
        }
        if let Softening::Ppr(ppr) = self.softening {
            ppr.check()?;
            let what = match self {
                _ if self.stiffness != 0.0 => {
                    "a stiffness of a cohesive interface by the law ppr, whose slopes \
                    define it"
                }
                _ if self.exponent != Self::EXPONENT => {
                    "a mixed_mode_exponent of a cohesive interface by the law ppr, which mixes the modes by its potential"
                }
                _ if self.viscosity != 0.0 => "a viscosity of a cohesive interface by the law ppr",
                _ => return CohesiveLaw::new(self).check(),
            };
            return Err(Error::Unsupported { what });
        }
        if self.brittleness() <= 1.0 {
            let what = "a stiffness of a cohesive interface that is not above strength² / (2 energy): it would break before it yields";
            return Err(Error::Unsupported { what });
        }
        if self.brittleness() > MOST_BRITTLE {
            let what = "a stiffness of a cohesive interface above 5e9 strength² / energy, 1e8 times the default: damage would be 1 but for rounding";
            return Err(Error::Unsupported { what });
        }
        CohesiveLaw::new(self).check()
    }
}

/// A law, ready to be asked.
#[derive(Clone, Copy)]
pub(crate) struct CohesiveLaw {
    /// Of opening and of sliding.
    pub(super) stiffness: [f64; 2],
    /// Y₀ in pure opening and in pure sliding.
    onset: [f64; 2],
    brittleness: f64,
    exponent: f64,
    softening: Softening,
    ppr: Option<PprLaw>,
    /// The part of the way to the damage of the law that damage goes in the step: 1 without viscosity.
    part: f64,
    pub(crate) is_viscous: bool,
    pub(super) friction: Option<BrokenFriction>,
}

impl CohesiveLaw {
    /// Of options that are checked.
    pub(crate) fn new(options: &Cohesive) -> Self {
        let brittleness = options.brittleness();
        let onset = [options.normal_energy / brittleness, options.shear_energy / brittleness];
        let strengths = [options.normal_strength, options.shear_strength];
        let ppr = match options.softening {
            Softening::Ppr(ppr) => Some(PprLaw::new(&ppr, strengths, [options.normal_energy, options.shear_energy])),
            _ => None,
        };
        let bilinear = [0, 1].map(|k| strengths[k] * strengths[k] / (2.0 * onset[k]));
        let stiffness = ppr.map_or(bilinear, |law| law.stiffness());
        let Cohesive { exponent, softening, viscosity, .. } = *options;
        let (part, is_viscous) = (1.0, viscosity > 0.0);
        Self { stiffness, onset, brittleness, exponent, softening, ppr, part, is_viscous, friction: None }
    }

    /// Refuses numbers that overflow.
    fn check(&self) -> Result<(), Error> {
        let ends = self.ppr.map_or([1.0; 2], |law| law.ends());
        let all = self.stiffness.into_iter().chain(self.onset).chain([self.brittleness]).chain(ends);
        match all.into_iter().find(|x| !(x.is_finite() && *x > 0.0)) {
            Some(value) => Err(Error::Overflow { quantity: "stiffness of a cohesive interface", value }),
            None => Ok(()),
        }
    }

    /// With this viscosity in a step that takes so long; backward in time, so that no step is too long.
    pub(crate) fn in_time(self, viscosity: f64, time_step: f64) -> Self {
        let part = if viscosity > 0.0 { time_step / (viscosity + time_step) } else { 1.0 };
        Self { part, ..self }
    }

    /// With friction of what is broken.
    pub(crate) fn rubbing(self, friction: Option<BrokenFriction>) -> Self {
        Self { friction, ..self }
    }

    /// The largest elastic slip of what is broken at an opening, and how it changes with that; `None` without friction.
    pub(super) fn pressed(&self, opening: f64) -> Option<(f64, f64)> {
        let BrokenFriction { coefficient, shear_limit } = self.friction?;
        let [kn, kt] = self.stiffness;
        if opening >= 0.0 {
            return Some((0.0, 0.0));
        }
        let traction = coefficient * -opening * kn;
        let most = traction >= shear_limit;
        Some((
            traction.min(shear_limit) / kt,
            if most || coefficient.is_infinite() { 0.0 } else { -coefficient * kn / kt },
        ))
    }

    /// Of opening or of sliding, whichever is larger.
    pub(crate) fn largest_stiffness(&self) -> f64 {
        self.stiffness[0].max(self.stiffness[1])
    }

    /// The largest tractions in pure opening and in pure sliding that are left after what a point has been through.
    pub(crate) fn strengths_left(&self, past: &PointState) -> [f64; 2] {
        if let Some(law) = &self.ppr {
            return law.strengths_left(past);
        }
        let damage = past.damage.damage;
        let part = if damage < 1.0 { (1.0 - damage) * self.reached(damage) } else { 0.0 };
        [0, 1].map(|k| part * (2.0 * self.stiffness[k] * self.onset[k]).sqrt())
    }

    /// At an opening and a squared sliding, after what a point has been through.
    pub(super) fn response(&self, past: &PointState, opening: f64, sliding2: f64) -> Response {
        if let Some(law) = &self.ppr {
            return law.response(past, opening, sliding2);
        }
        let [kn, kt] = self.stiffness;
        let opened = opening.max(0.0);
        let of_sliding = 0.5 * kt * sliding2;
        let all = 0.5 * kn * opened * opened + of_sliding;
        let (mut now, mut growth) = (*past, None);
        now.history.reached = 0.0;
        let PointDamage { damage: before, .. } = past.damage;
        if all > 0.0 && before < 1.0 {
            let part = (of_sliding / all).min(1.0);
            let difference = self.onset[1] - self.onset[0];
            let onset = self.onset[0] + difference * part.powf(self.exponent);
            let q = (all / onset).sqrt();
            let target = self.damage(q);
            if target > before {
                let started = self.reached(before);
                now.damage.damage = target;
                let mut fracture = onset * (self.spent(q) - self.spent(started)).max(0.0);
                if self.part < 1.0 {
                    now.damage.damage = before + self.part * (target - before);
                    let lost =
                        onset * self.spent_in_time(q, (started.max(past.history.reached), before), now.damage.damage);
                    fracture = onset * (self.spent(self.reached(now.damage.damage)) - self.spent(started)).max(0.0);
                    now.history.viscous += (lost - fracture).max(0.0);
                    now.history.reached = q;
                }
                now.damage.dissipated += fracture;
                let by_part = difference * self.exponent * part.powf(self.exponent - 1.0);
                let slope = self.part * self.slope(q) * q / (2.0 * all);
                growth = Some([slope * (1.0 + by_part * part / onset), -slope * by_part / onset]);
            }
        }
        let left = 1.0 - now.damage.damage;
        let normal_stiffness = if opening > 0.0 { left * kn } else { kn };
        let pressed = opening - opened;
        Response {
            stored: left * all + 0.5 * kn * pressed * pressed,
            normal: normal_stiffness * opening,
            normal_stiffness,
            shear_stiffness: left * kt,
            now,
            growth,
            coupled: None,
        }
    }

    /// a in exp(−(q − 1)/a), so that the energy of fracture is m Y₀.
    fn decay(&self) -> f64 {
        0.5 * (self.brittleness - 1.0)
    }

    /// D(q).
    fn damage(&self, q: f64) -> f64 {
        let m = self.brittleness;
        match self.softening {
            _ if q <= 1.0 => 0.0,
            Softening::Linear if q >= m => 1.0,
            Softening::Linear => m * (q - 1.0) / (q * (m - 1.0)),
            _ => 1.0 - (-(q - 1.0) / self.decay()).exp() / q,
        }
    }

    /// D′(q), beyond 1.
    fn slope(&self, q: f64) -> f64 {
        let m = self.brittleness;
        match self.softening {
            Softening::Linear if q >= m => 0.0,
            Softening::Linear => m / ((m - 1.0) * q * q),
            _ => (-(q - 1.0) / self.decay()).exp() * (1.0 / q + 1.0 / self.decay()) / q,
        }
    }

    /// ∫ s² D′(s) ds from 1 to q: what is dissipated, by Y₀.
    fn spent(&self, q: f64) -> f64 {
        let (m, u) = (self.brittleness, q - 1.0);
        match self.softening {
            Softening::Linear => m / (m - 1.0) * (q.min(m) - 1.0),
            _ if u > 700.0 * self.decay() => m,
            _ => {
                let left = (-u / self.decay()).exp();
                m * (1.0 - left) - u * left
            }
        }
    }

    /// ∫ q² dd over a step with viscosity, by Y₀: to what the step began with, q₀, damage goes on evenly in the step, and from there as q
    /// grows. Where q falls it goes on evenly.
    fn spent_in_time(&self, q: f64, (started, before): (f64, f64), after: f64) -> f64 {
        if q < started {
            return 0.5 * (started * started + q * q) * (after - before);
        }
        let held = self.part * (self.damage(started) - before);
        0.5 * (started * started + q * q) * held + self.part * (self.spent(q) - self.spent(started))
    }

    /// The q of a damage below 1.
    fn reached(&self, damage: f64) -> f64 {
        let m = self.brittleness;
        match self.softening {
            _ if damage <= 0.0 => 1.0,
            Softening::Linear => m / (m - damage * (m - 1.0)),
            _ => {
                // ln q + (q − 1)/a = −ln(1 − d), whose left is concave: Newton's method comes from below.
                let (target, decay) = (-(-damage).ln_1p(), self.decay());
                let mut q = 1.0f64;
                for _ in 0..ROUNDS {
                    let next = q + (target - q.ln() - (q - 1.0) / decay) / (1.0 / q + 1.0 / decay);
                    if next <= q {
                        break;
                    }
                    q = next;
                }
                q
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laws() -> Vec<CohesiveLaw> {
        let one = Cohesive { shear_strength: 3.0, shear_energy: 0.7, ..Cohesive::new(2.0, 0.1) };
        [
            (0.0, Softening::Linear),
            (0.0, Softening::Exponential),
            (50.0, Softening::Linear),
            (50.0, Softening::Exponential),
        ]
        .map(|(stiffness, softening)| CohesiveLaw::new(&Cohesive { stiffness, softening, ..one }))
        .to_vec()
    }

    /// By the trapezoidal rule of 1e5 intervals, whose error is 1e-10 of the sum; the inverse to rounding of 1 − d.
    #[test]
    fn the_curve_encloses_the_energy_of_fracture() {
        for law in laws() {
            let (mut sum, count, most) = (0.0, 100_000, law.brittleness);
            let at = |k: usize| 1.0 + (most - 1.0) * k as f64 / count as f64;
            let rate = |q: f64| q * q * law.slope(q);
            for k in 0..count {
                sum += 0.5
                    * (rate(at(k)) + if k + 1 < count { rate(at(k + 1)) } else { rate(at(k)) })
                    * (at(k + 1) - at(k));
            }
            assert!((sum - law.spent(most)).abs() < 1e-4 * law.brittleness, "{sum} for {}", law.spent(most));
            assert!((law.spent(1e6 * most) - most).abs() < 1e-12 * most);
            for q in [1.0, 1.3, 2.0, 0.5 * (1.0 + most), 0.99 * most] {
                assert!((law.reached(law.damage(q)) - q).abs() < 1e-12 * most, "{q}");
                let step = 1e-6;
                let slope = (law.damage(q + 1.0 + step) - law.damage(q + 1.0 - step)) / (2.0 * step);
                // The straight line ends with a kink at m.
                assert!(q + 1.1 > most || (slope - law.slope(q + 1.0)).abs() < 1e-8);
            }
        }
    }
}
