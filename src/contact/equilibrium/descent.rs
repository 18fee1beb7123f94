//! Rules of a descent on an energy that contact has a part in: how far along a direction, and with which tangent the next is found.
//!
//! The library's contact step goes by them, and so may a host's iterations of everything at once.

use crate::contact::tangents::TangentPart;

/// Part of what the slope promises that a step must gain (Armijo).
const GAIN: f64 = 1e-4;

/// Part of the energies that a change must exceed to be distinguished from rounding of some thousand pieces of contact.
const FLAT: f64 = 1e-12;

/// A place on the way, as far as the rules go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Descent {
    /// Energy.
    pub energy: f64,
    /// Norm of its derivative.
    pub norm: f64,
    /// What rounding of sums may change in the energy.
    pub rounding: f64,
    /// Change of the energy that is not to be distinguished from rounding: [`Self::flatness`], and more.
    pub flat: f64,
}

impl Descent {
    /// Change of an energy that is not to be distinguished from rounding, if what it is made of adds up to `magnitude`.
    pub fn flatness(magnitude: f64) -> f64 {
        FLAT * magnitude
    }

    /// Whether a part `length` of a step that begins with this slope leads lower: by a part of what the slope promises, or, where the
    /// energy is flat within rounding, near the end, or what the slope promises is, to smaller forces.
    pub fn is_lowered_by(&self, length: f64, slope: f64, there: &Self) -> bool {
        let (gain, promise) = ((there.energy - self.energy).abs(), length * slope.abs());
        let is_flat = gain.min(promise) <= self.flat.max(there.flat);
        there.energy <= self.energy + GAIN * length * slope + self.rounding
            || is_flat && self.is_weakened_by(length, there)
    }

    /// Whether it leads to smaller forces: what is asked where there is no energy.
    pub fn is_weakened_by(&self, length: f64, there: &Self) -> bool {
        there.norm <= (1.0 - GAIN * length) * self.norm
    }

    /// Whether a step has not halved the forces.
    pub fn is_hardly_weakened_by(&self, there: &Self) -> bool {
        there.norm > 0.5 * self.norm
    }
}

/// Shorter trial, where the slope would vanish if it were linear between those at the start and at this one, kept away from the ends.
pub fn shortened(length: f64, slope: f64, there: f64) -> f64 {
    let part = if there > slope { slope / (slope - there) } else { 0.5 };
    length * part.clamp(0.1, 0.7)
}

/// Which part of the contact's tangent is taken: the semidefinite one as long as the forces are large, the full one then; back for one step
/// where a full one has not halved them, or has led nowhere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TangentChoice {
    has_failed: bool,
}

impl TangentChoice {
    /// The part to begin with, where the forces that do not balance are so large by `scale`.
    pub fn wish(&self, norm: f64, full_below: f64, scale: f64) -> TangentPart {
        match norm > full_below * scale || self.has_failed {
            true => TangentPart::Semidefinite,
            false => TangentPart::Full,
        }
    }

    /// What a step with a part has led to, `None` for nowhere.
    pub fn made(&mut self, part: TangentPart, from: &Descent, to: Option<&Descent>) {
        self.has_failed = part == TangentPart::Full && to.is_none_or(|to| from.is_hardly_weakened_by(to));
    }
}
