//! What one step returns.

/// Energies, resultants and costs at one step. Energies in 2D are per unit thickness.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample<const D: usize> {
    /// Steps made since the start.
    pub step: u64,
    /// Time.
    pub time: f64,
    /// Kinetic energy, from the velocity at this time.
    pub kinetic: f64,
    /// Strain energy.
    pub strain: f64,
    /// Contact energy, with what the stick of friction stores.
    pub contact: f64,
    /// Potential of the external loads, −Σ f·u; they do the work −(change of it).
    pub external: f64,
    /// Kinetic + strain + contact + external energy. With `dissipated` it is constant but for the scheme's error.
    pub total: f64,
    /// Energy that damping and friction have taken out so far; it never falls.
    pub dissipated: f64,
    /// Sum of the contact forces on every body, in the order of the model's parts. With several contact sub-steps their
    /// mean, so that the sum over the steps times Δt is the impulse.
    pub bodies: Vec<[f64; D]>,
    /// The same on every obstacle.
    pub obstacles: Vec<[f64; D]>,
    /// |ΣF| over bodies and obstacles: what action and reaction leave of each other.
    pub balance: f64,
    /// Velocity of the centre of mass of every part.
    pub velocities: Vec<[f64; D]>,
    /// Overlap volume (2D: area), summed over the pairs.
    pub overlap: f64,
    /// Largest penetration of any pair.
    pub penetration: f64,
    /// Area of contact.
    pub contact_area: f64,
    /// Fibers laid.
    pub fibers: usize,
    /// Crossings that bound an overlap (`exact`: clipped pieces).
    pub crossings: usize,
    /// What the user should know: the contact's own warnings, and a step that came to exceed its limit.
    pub warnings: Vec<String>,
    /// Seconds spent in contact during this step.
    pub contact_seconds: f64,
    /// Seconds this step took in all.
    pub seconds: f64,
}
