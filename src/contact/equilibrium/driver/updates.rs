//! Multipliers, until what is left of the penetration does not matter.

use super::balance::Verdict;
use super::elastic::elastic_displacement;
use super::host::Host;
use super::options::DriverOptions;
use super::state::State;
use super::trouble::Trouble;
use super::unknowns::{dot, largest};
use crate::Error;
use crate::contact::equilibrium::Augmentation;
use crate::contact::evaluation::Contact;

/// Work of the contact forces on the penetration, by that of the bodies' own forces, that does not matter: the part by which forces are
/// too small.
const NEGLIGIBLE: f64 = 1e-3;

/// Updates where nobody has asked for a penetration, and as long as each of them changes the forces by more than a negligible part.
const BY_DEFAULT: usize = 4;
const BY_FORCE: usize = 12;

/// Part of a change that an update may leave; where it leaves more, the contact is made stiffer by the factor that follows.
const SLOW: f64 = 0.25;
const STIFFER: f64 = 4.0;

/// Factor, at most, by which it is made stiffer over all load steps: where a node or two come and go, a stiffer law makes no update better.
const STIFFEST: f64 = 16.0;

/// Residual by the forces below which surfaces are moved out: an equilibrium is not waited for, since the next one is another.
const NEAR: f64 = 1e-2;

/// Updates of a load step.
pub(super) struct Updates {
    is_possible: bool,
    /// The penetration that somebody has asked for.
    asked: Option<f64>,
    reach: f64,
    /// How many are made at most, while anything is left of the penetration.
    most: usize,
    /// The same while each of them still changes the forces.
    most_by_force: usize,
    last: f64,
    /// Sum of the magnitudes of the contact forces at the last update.
    pressed: f64,
    /// Factor by which the contact was made stiffer so far.
    stiffened: f64,
    pub(super) count: usize,
    pub(super) found: Option<f64>,
}

impl Updates {
    pub(super) fn new(options: &DriverOptions, is_stiffness_found: bool, stiffened: f64) -> Self {
        let asked = (options.penetration > 0.0).then_some(options.penetration);
        let all = options.max_updates;
        let (most, most_by_force) = if asked.is_some() { (all, all) } else { (BY_DEFAULT.min(all), BY_FORCE.min(all)) };
        Self {
            is_possible: asked.is_some() || is_stiffness_found,
            asked,
            reach: options.reach,
            most,
            most_by_force,
            last: f64::INFINITY,
            pressed: 0.0,
            stiffened,
            count: 0,
            found: None,
        }
    }

    /// Whether the contact became another one: surfaces were moved out at a state that is near an equilibrium.
    ///
    /// # Errors
    /// A penetration that was asked for, and is not reached by as many updates as are allowed.
    pub(super) async fn made<const D: usize>(
        &mut self,
        host: &Host<D>,
        state: &State<D>,
        verdict: Verdict,
        relative: f64,
    ) -> Result<bool, Trouble> {
        let is_over = verdict != Verdict::Not;
        if !self.is_possible || !(is_over || relative <= NEAR) {
            return Ok(false);
        }
        let pressed: f64 = state.contact.pairs.iter().map(|pair| pair.pressure * pair.contact_area).sum();
        let is_changing = (pressed - self.pressed).abs() > NEGLIGIBLE * pressed;
        if self.count >= self.most && !is_over {
            return Ok(false);
        }
        let may = self.count < self.most || (self.count < self.most_by_force && is_changing);
        let coords = host.unknowns.coords(&state.x);
        self.pressed = pressed;
        let (wanted, reach) = (self.wanted(host, state, pressed).await?, self.reach);
        let update = match host.contact(move |contact| update(contact, &coords, wanted, reach, may)).await {
            Ok(update) => update,
            // With self-contact or another law the penetration stays what the law leaves.
            Err(Error::Unsupported { .. }) if self.asked.is_none() => {
                self.is_possible = false;
                return Ok(false);
            }
            Err(error) => return Err(error.into()),
        };
        self.found = Some(update.penetration);
        match self.asked {
            _ if update.is_enough => Ok(false),
            Some(wanted) if !may => {
                let (left, count) = (update.penetration.max(update.change), self.count);
                Err(Trouble::Failed(format!(
                    "a penetration of {left:.1e} after {count} updates, {wanted:.1e} is wanted"
                )))
            }
            None if !may => Ok(false),
            _ => {
                self.count += 1;
                self.stiffen(host, update.change).await?;
                Ok(true)
            }
        }
    }

    /// The penetration that was asked for, or else one that does not matter.
    async fn wanted<const D: usize>(&self, host: &Host<D>, state: &State<D>, pressed: f64) -> Result<Wanted, Trouble> {
        if let Some(asked) = self.asked {
            return Ok(Wanted::OfAll(asked));
        }
        if pressed == 0.0 {
            return Ok(Wanted::OnAverage(f64::MAX));
        }
        let coords = host.unknowns.coords(&state.x);
        let deformed = host.contact(move |contact| elastic_displacement(contact, &coords)).await?;
        let farthest = deformed.as_ref().map_or(f64::INFINITY, |rows| largest(rows.as_flattened()));
        let deformed = deformed.map_or_else(|| state.x.clone(), |rows| host.unknowns.gathered(&rows));
        let work = dot(&deformed, &host.product(deformed.clone(), false).await?);
        // Large numbers on the diagonal, by which a host may hold unknowns, are no stiffness of the bodies.
        Ok(Wanted::OnAverage(NEGLIGIBLE * (work.abs() / pressed).min(farthest)))
    }

    /// Makes the contact stiffer where a penetration was asked for, and updates are slow.
    async fn stiffen<const D: usize>(&mut self, host: &Host<D>, change: f64) -> Result<(), Trouble> {
        let is_slow = change > SLOW * self.last;
        self.last = change;
        if self.asked.is_some() && is_slow && self.stiffened < STIFFEST {
            host.contact(|contact| contact.stiffen(STIFFER)).await?;
            (self.stiffened, self.last) = (STIFFER * self.stiffened, f64::INFINITY);
        }
        Ok(())
    }
}

/// How little penetration is wanted.
#[derive(Clone, Copy)]
enum Wanted {
    /// At every node.
    OfAll(f64),
    /// As the mean by the pressures.
    OnAverage(f64),
}

impl Wanted {
    fn of_all(self) -> f64 {
        match self {
            Wanted::OfAll(wanted) | Wanted::OnAverage(wanted) => wanted,
        }
    }
}

struct Update {
    penetration: f64,
    change: f64,
    is_enough: bool,
}

/// Updates the multipliers where it may; else it measures the penetration alone.
fn update<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    wanted: Wanted,
    reach: f64,
    may: bool,
) -> Result<Update, Error> {
    if !may {
        let penetration = contact.nodal_penetration(coords, reach)?;
        return Ok(Update { penetration, change: penetration, is_enough: penetration <= wanted.of_all() });
    }
    let is_enough = |found: &Augmentation| match wanted {
        Wanted::OfAll(wanted) => found.penetration.max(found.change) <= wanted,
        Wanted::OnAverage(wanted) => found.mean_change <= wanted,
    };
    let found = contact.augment_unless(coords, reach, is_enough)?;
    Ok(Update { penetration: found.penetration, change: found.change, is_enough: found.is_enough })
}
