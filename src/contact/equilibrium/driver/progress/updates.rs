//! Multipliers, until what is left of the penetration does not matter.

use super::balance::Verdict;
use super::state::State;
use super::within_facets::{Most, TOLD, UNLOADED};
use crate::Error;
use crate::contact::equilibrium::augmentation::Augmentation;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::options::DriverOptions;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::dot;
use crate::contact::equilibrium::driver::bodies::elastic::deformed;
use crate::contact::evaluation::Contact;
use crate::contact::results::ContactForces;
use crate::contact::ties::{HeldApart, Supports, TieChange};
use crate::overlap::Partner;

/// Work of the contact forces on the penetration, by that of the bodies' own forces, that does not matter: the part by which forces are
/// too small.
const NEGLIGIBLE: f64 = 1e-3;

/// Part of its largest traction by which an update may still change a tie. Work does not tell: what is tied is one body, and where several
/// ties meet a gap far below the mean displacement is a stress of its own.
const TIED: f64 = 1e-3;

/// Updates where nobody has asked for a penetration, and as long as each of them changes the forces by more than a negligible part.
const BY_DEFAULT: usize = 4;
const BY_FORCE: usize = 12;

/// Part of a change that an update may leave; where it leaves more, the contact is made stiffer by the factor that follows.
const SLOW: f64 = 0.25;
const STIFFER: f64 = 4.0;

/// Factor, at most, by which it is made stiffer over all load steps: where a node or two come and go, a stiffer law makes no update better.
const STIFFEST: f64 = 16.0;

/// Jump or penetration that is left, by the smallest facet, of which nothing is said: a false strain of as much.
const UNTOLD: f64 = 1e-6;

/// Units of rounding of a coordinate that are no jump.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Residual by the forces below which surfaces are moved out: an equilibrium is not waited for, since the next one is another.
const NEAR: f64 = 1e-2;

/// Updates of a load step.
pub(crate) struct Updates {
    is_possible: bool,
    /// The penetration that somebody has asked for.
    asked: Option<f64>,
    reach: f64,
    /// How many are made at most in a part of the step, while anything is left of the penetration.
    most: usize,
    /// The same while each of them still changes the forces.
    most_by_force: usize,
    last: f64,
    /// Sum of the magnitudes of the contact forces at the last update.
    pressed: f64,
    /// Sum of the magnitudes of the contact forces where a load began to fall.
    fallen_from: f64,
    /// Number of them before the part that is under way.
    before: usize,
    is_needed: bool,
    /// Part of all contact forces of which a tie bears no more where residuals that are left might be its traction.
    light: f64,
    /// Whether the last update still changed the tractions of ties.
    are_ties_moving: bool,
    /// Whether the last state would have been given another update.
    is_cut_short: bool,
    /// Mean of the changes by the pressures that the last state asked for.
    mean: f64,
    pub(crate) count: usize,
    pub(crate) found: Option<f64>,
    /// The bodies' own displacement, as a mean by the contact forces, where no penetration was asked for.
    displacement: Option<f64>,
    supports: Option<Supports>,
    /// Where supports hold what is tied apart.
    held_apart: Option<HeldApart>,
}

impl Updates {
    pub(crate) fn new(options: &DriverOptions, is_stiffness_found: bool) -> Self {
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
            fallen_from: 0.0,
            before: 0,
            is_needed: true,
            light: 10.0 * options.tolerance / TIED,
            are_ties_moving: false,
            is_cut_short: false,
            mean: 0.0,
            count: 0,
            found: None,
            displacement: None,
            supports: None,
            held_apart: None,
        }
    }

    /// Another part of the load step begins. Without a history only its end needs them.
    pub(crate) fn begin(&mut self, is_needed: bool) {
        self.is_needed = is_needed;
        // Where a penetration is asked for, a load step has as many as were asked for, whatever its parts.
        self.before = if self.asked.is_some() { 0 } else { self.count };
        (self.pressed, self.last) = (0.0, f64::INFINITY);
        (self.is_cut_short, self.are_ties_moving) = (false, false);
    }

    /// The multipliers are those of an equilibrium that was found with them, and of this load: unless a penetration is asked for, they stay.
    pub(crate) fn stay(&mut self) {
        self.is_possible &= self.asked.is_some();
    }

    /// A load falls from where contact presses like this.
    pub(crate) fn fall_from<const D: usize>(&mut self, contact: &ContactForces<D>) {
        self.fallen_from = pressed(contact);
    }

    /// How much penetration there may be without a word where there is no multiplier.
    pub(crate) fn most_without(&self) -> Option<Most> {
        self.asked.map(Most::Asked).or(self.displacement.map(Most::OfDisplacement))
    }

    /// Where supports hold what is tied farther apart than was asked, or by what matters.
    pub(crate) fn held_apart(&self) -> Option<HeldApart> {
        let most = self.asked.or(self.displacement.map(|displacement| TOLD * displacement))?;
        self.held_apart.filter(|found| found.jump > most)
    }

    /// What is to be said where each update still changed the forces.
    pub(crate) fn left(&self, finest: f64) -> Option<String> {
        let left = self.found.filter(|left| self.is_cut_short && *left > UNTOLD * finest)?;
        let count = self.count - self.before;
        let of_displacement = match self.displacement {
            Some(own) if self.mean > TOLD * own => {
                format!(", {:.0} % of the bodies' own displacement on average", 100.0 * self.mean / own)
            }
            _ => String::new(),
        };
        Some(format!(
            "after {count} updates of the multipliers another one would still change the result; surfaces penetrate, \
             or tied surfaces have moved apart, by {left:.1e}{of_displacement}: set a penetration, take smaller load \
             steps, or allow more updates"
        ))
    }

    /// Whether the contact became another one: surfaces were moved out at a state that is near an equilibrium.
    ///
    /// # Errors
    /// A penetration that was asked for, and is not reached by as many updates as are allowed.
    pub(crate) async fn made<const D: usize>(
        &mut self,
        host: &Host<D>,
        state: &State<D>,
        verdict: Verdict,
        relative: f64,
    ) -> Result<bool, Trouble> {
        let is_over = verdict != Verdict::Not;
        if !(self.is_possible && self.is_needed) || !(is_over || relative <= NEAR) {
            return Ok(false);
        }
        let pressed = pressed(&state.contact);
        if pressed <= UNLOADED * self.fallen_from {
            return Ok(false);
        }
        let is_changing = (pressed - self.pressed).abs() > NEGLIGIBLE * pressed || self.are_ties_moving;
        let count = self.count - self.before;
        if count >= self.most && !is_over {
            return Ok(false);
        }
        let may = count < self.most || (count < self.most_by_force && is_changing);
        let coords = host.unknowns.coords(&state.x);
        self.pressed = pressed;
        let (wanted, reach) = (self.wanted(host, state, pressed).await?, self.reach);
        if let Wanted::OnAverage { penetration, .. } = wanted {
            self.displacement = Some(penetration / NEGLIGIBLE);
        }
        let supports = self.supports.get_or_insert_with(|| host.unknowns.supports()).clone();
        let asked = Asked { wanted, reach, supports, may };
        let update = match host.contact(move |contact| update(contact, &coords, asked)).await {
            Ok(update) => update,
            // With self-contact or another law the penetration stays what the law leaves.
            Err(Error::Unsupported { .. }) if self.asked.is_none() => {
                (self.is_possible, self.displacement) = (false, None);
                return Ok(false);
            }
            Err(error) => return Err(error.into()),
        };
        self.found = Some(update.penetration);
        self.are_ties_moving = update.are_ties_moving;
        (self.mean, self.held_apart) = (update.mean, update.held_apart);
        let is_far = self.displacement.is_some_and(|own| update.mean > TOLD * own);
        self.is_cut_short = !update.is_enough && !may && (is_changing || update.are_ties_moving || is_far);
        match self.asked {
            _ if update.is_enough => Ok(false),
            Some(wanted) if !may => {
                let left = update.penetration.max(update.change);
                Err(Trouble::Failed(format!(
                    "a penetration of {left:.1e} after {count} updates, expected {wanted:.1e}"
                )))
            }
            None if !may => Ok(false),
            _ => {
                self.count += 1;
                self.stiffen(host, &state.contact, update.change).await?;
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
            return Ok(Wanted::OnAverage { penetration: f64::MAX, rounding: f64::MAX, light: 0.0 });
        }
        let coords = host.unknowns.coords(&state.x);
        let (deformed, farthest) = deformed(host, &state.x).await?;
        let work = dot(&deformed, &host.product(deformed.clone(), false).await?);
        // Large numbers on the diagonal, by which a host may hold unknowns, are no stiffness of the bodies.
        let rounding = ROUNDING * coords.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let penetration = (NEGLIGIBLE * (work.abs() / pressed).min(farthest)).max(rounding);
        Ok(Wanted::OnAverage { penetration, rounding, light: self.light * pressed })
    }

    /// Makes the contact stiffer where updates are slow, and a penetration was asked for or edges press: below an edge of an obstacle a
    /// facet that is moved out reaches past the wall beside the edge, which pushes it along, and no update closes the gap.
    async fn stiffen<const D: usize>(
        &mut self,
        host: &Host<D>,
        pressed: &ContactForces<D>,
        change: f64,
    ) -> Result<(), Trouble> {
        let is_slow = change > SLOW * self.last;
        self.last = change;
        if !is_slow {
            return Ok(());
        }
        let (asked, touched) = (self.asked.is_some(), obstacles_in(pressed));
        let stiffened = host.contact(move |contact| -> Result<bool, Error> {
            let may = asked || touched.iter().any(|&obstacle| contact.has_edges(obstacle));
            if !may || contact.history.stiffened >= STIFFEST {
                return Ok(false);
            }
            contact.stiffen(STIFFER).map(|()| true)
        });
        if stiffened.await? {
            self.last = f64::INFINITY;
        }
        Ok(())
    }
}

/// Obstacles that press.
fn obstacles_in<const D: usize>(contact: &ContactForces<D>) -> Vec<usize> {
    let pressed = contact.pairs.iter().filter(|pair| pair.pressure > 0.0);
    let partners = pressed.flat_map(|pair| [pair.a, pair.b]);
    partners
        .filter_map(|partner| if let Partner::Obstacle(obstacle) = partner { Some(obstacle) } else { None })
        .collect()
}

fn pressed<const D: usize>(contact: &ContactForces<D>) -> f64 {
    contact.pairs.iter().map(|pair| pair.pressure * pair.contact_area).sum()
}

/// How little penetration is wanted.
#[derive(Clone, Copy)]
enum Wanted {
    /// At every node.
    OfAll(f64),
    /// As the mean by the pressures. Jumps of ties that bear more than `light` do not matter where they are rounding, or their tractions
    /// change no more.
    OnAverage { penetration: f64, rounding: f64, light: f64 },
}

impl Wanted {
    fn of_all(self) -> f64 {
        match self {
            Wanted::OfAll(wanted) | Wanted::OnAverage { penetration: wanted, .. } => wanted,
        }
    }

    /// Whether an update changes the tractions of ties by what matters.
    fn are_moving(self, ties: &TieChange) -> bool {
        match self {
            Wanted::OfAll(_) => false,
            Wanted::OnAverage { rounding, light, .. } => ties.largest > rounding && ties.of_tractions(light) > TIED,
        }
    }
}

struct Update {
    penetration: f64,
    change: f64,
    /// Mean of the changes by the pressures.
    mean: f64,
    is_enough: bool,
    are_ties_moving: bool,
    held_apart: Option<HeldApart>,
}

/// What is asked of one.
struct Asked {
    wanted: Wanted,
    reach: f64,
    supports: Supports,
    may: bool,
}

/// Updates the multipliers where it may; else it measures the penetration alone.
fn update<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    Asked { wanted, reach, supports, may }: Asked,
) -> Result<Update, Error> {
    if !may {
        let (found, ties) = contact.left_of_penetration(coords, reach, &supports)?;
        let (are_ties_moving, held_apart) = (wanted.are_moving(&ties), ties.held_apart);
        let (penetration, mean) = (found.penetration, found.mean_change);
        let is_enough = penetration <= wanted.of_all() && !are_ties_moving;
        return Ok(Update { penetration, change: penetration, mean, is_enough, are_ties_moving, held_apart });
    }
    let (mut are_ties_moving, mut held_apart) = (false, None);
    let found = contact.augment_unless(coords, reach, &supports, |found, ties| {
        (are_ties_moving, held_apart) = (wanted.are_moving(ties), ties.held_apart);
        match wanted {
            Wanted::OfAll(wanted) => [found.penetration.max(found.change) <= wanted; 2],
            Wanted::OnAverage { penetration, .. } => {
                [found.mean_change <= penetration, ties.mean() <= penetration && !are_ties_moving]
            }
        }
    })?;
    let Augmentation { penetration, change, mean_change: mean, is_enough, .. } = found;
    Ok(Update { penetration, change, mean, is_enough, are_ties_moving, held_apart })
}
