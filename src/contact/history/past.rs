//! The steps of a contact, and what is held during one.

use super::bearings::Bearings;
use super::first_touches::FirstTouches;
use super::kept_patches::KeptPatches;
use super::last::LastEquilibrium;
use super::multipliers::Multipliers;
use crate::Error;
use crate::contact::friction::{CarriedSlip, FrozenFriction, SlipFacets, Step};
use crate::contact::held::{Damage, LawHistory};
use crate::contact::partners::Poses;
use crate::contact::wear::Worn;
use crate::geometry::Surface;
use crate::interfaces::LawFields;
use crate::overlap::Partner;
use std::collections::BTreeSet;

/// What was begun, kept and frozen.
pub(crate) struct History<const D: usize> {
    /// Where the step began, once one has begun.
    pub(crate) step: Option<Step<D>>,
    /// How facets bore there, where that was measured.
    pub(crate) bearings: Option<Bearings>,
    /// Where pairs first touched that were apart there, where that is known: they have nothing to do with the way before.
    pub(crate) first_touches: FirstTouches<D>,
    /// Facets and pressures at which friction is frozen.
    pub(crate) frozen: Option<FrozenFriction<D>>,
    /// Part of their stiffness with which facets stick while a search leads to where they do, 0 for none; else 1.
    pub(crate) sticking: f64,
    pub(crate) patches: KeptPatches<D>,
    /// How far surfaces are moved out so that they press without penetration.
    pub(crate) multipliers: Multipliers<D>,
    /// What was worn off in the steps that were accepted.
    pub(crate) worn: Worn<D>,
    /// As many times the wear of a step counts.
    pub(crate) wear_cycles: f64,
    /// What cohesive interfaces have been through in the steps that were accepted.
    pub(crate) damage: Damage,
    /// The same of interfaces by a law of the host.
    pub(crate) of_laws: LawHistory,
    /// Fields that these laws are asked with.
    pub(crate) law_fields: LawFields,
    /// How long a step takes, for their viscosity and their laws; 0: nothing was said.
    pub(crate) time_step: f64,
    /// Factor by which the contact was made stiffer since it was made.
    pub(crate) stiffened: f64,
    /// Pairs that are left out while a search asks how bodies would move without their contact.
    pub(crate) let_apart: BTreeSet<[Partner; 2]>,
    /// Where tangents are those of surfaces that are apart, while an equilibrium without contact is sought: nowhere else, should the
    /// search be left there.
    pub(crate) apart_at: Option<Vec<[f64; D]>>,
    /// The equilibrium that a search found last. It decides how long the next one takes, and not what it finds but within tolerances.
    pub(crate) last: Option<LastEquilibrium<D>>,
}

/// Where a step began, and how facets bore there.
#[derive(Clone)]
pub(crate) struct Begun<const D: usize> {
    step: Option<Step<D>>,
    bearings: Option<Bearings>,
    first_touches: FirstTouches<D>,
    worn: Worn<D>,
    damage: Damage,
    of_laws: LawHistory,
    stiffened: f64,
}

impl<const D: usize> Begun<D> {
    /// The same with these places of first touch.
    pub(crate) fn with_first_touches(self, first_touches: FirstTouches<D>) -> Self {
        Self { first_touches, ..self }
    }
}

impl<const D: usize> History<D> {
    pub(crate) fn new() -> Self {
        Self {
            step: None,
            bearings: None,
            first_touches: FirstTouches::default(),
            frozen: None,
            sticking: 1.0,
            patches: KeptPatches::none(),
            multipliers: Multipliers::default(),
            worn: Worn::none(),
            wear_cycles: 1.0,
            damage: Damage::new(),
            of_laws: LawHistory::new(),
            law_fields: LawFields::default(),
            time_step: 0.0,
            stiffened: 1.0,
            let_apart: BTreeSet::new(),
            apart_at: None,
            last: None,
        }
    }

    /// Begins a step; frozen friction is released.
    pub(crate) fn begin(&mut self, step: Step<D>, bearings: Option<Bearings>) {
        (self.step, self.bearings) = (Some(step), bearings);
        self.first_touches = FirstTouches::default();
        self.release_friction();
    }

    /// Takes how facets bore when the step began; frozen friction is released.
    pub(crate) fn bear(&mut self, bearings: Option<Bearings>) {
        self.bearings = bearings;
        self.release_friction();
    }

    /// What has begun, so that it can be laid aside.
    pub(crate) fn begun(&self) -> Begun<D> {
        let (step, bearings, worn) = (self.step.clone(), self.bearings.clone(), self.worn.clone());
        let (damage, of_laws) = (self.damage.clone(), self.of_laws.clone());
        let first_touches = self.first_touches.clone();
        Begun { step, bearings, first_touches, worn, damage, of_laws, stiffened: self.stiffened }
    }

    /// Goes on with a step that was laid aside; frozen friction is released. As [`Self::stiffen`].
    pub(crate) fn take_up(&mut self, begun: Begun<D>, is_slip_of_law: bool) {
        (self.step, self.bearings, self.first_touches) = (begun.step, begun.bearings, begun.first_touches);
        self.release_friction();
        (self.worn, self.damage, self.of_laws) = (begun.worn, begun.damage, begun.of_laws);
        if is_slip_of_law {
            self.divide_slip(self.stiffened / begun.stiffened);
        }
    }

    /// What surfaces and elastic slip press and pull with stays, by laws that are stiffer by a factor: slip, where its stiffness is that of
    /// the law.
    pub(crate) fn stiffen(&mut self, factor: f64, is_slip_of_law: bool) {
        self.multipliers.stiffen(factor);
        self.stiffened *= factor;
        if is_slip_of_law {
            self.divide_slip(factor);
        }
    }

    fn divide_slip(&mut self, factor: f64) {
        if let Some(step) = self.step.as_mut().filter(|_| factor != 1.0) {
            step.slip.values_mut().for_each(|carried| carried.slip /= factor);
            self.frozen = None;
        }
    }

    /// Refuses surfaces that are worn before a step has begun: nobody knows yet where they lie.
    pub(crate) fn check_worn(&self) -> Result<(), Error> {
        if self.worn.is_empty() { Ok(()) } else { self.step().map(drop) }
    }

    /// The step that has begun.
    pub(crate) fn step(&self) -> Result<&Step<D>, Error> {
        self.step.as_ref().ok_or(Error::NoStep)
    }

    /// That from where the slip of a pair counts: from its first touch, where that is known.
    pub(crate) fn step_of(&self, pair: &[Partner; 2]) -> Option<&Step<D>> {
        self.first_touches.of(pair).or(self.step.as_ref())
    }

    /// Whether a pair bore nothing where the step began, and nothing is known of its first touch.
    pub(crate) fn was_apart(&self, pair: &[Partner; 2]) -> bool {
        let is_of_pair = |step: &Step<D>| step.slip.keys().any(|(partners, ..)| partners == pair);
        let bore = self.bearings.as_ref().is_none_or(|bearings| bearings.has(pair));
        !bore && !self.first_touches.is_known(pair) && !self.step.as_ref().is_some_and(is_of_pair)
    }

    /// Whether nothing that rubs bore where the step began, and nothing is known of a first touch.
    pub(crate) fn was_all_apart(&self) -> bool {
        let bore_nothing = self.bearings.as_ref().is_some_and(Bearings::are_none);
        bore_nothing && self.first_touches.are_none() && self.step.as_ref().is_some_and(|step| step.slip.is_empty())
    }

    /// Sets the elastic slip that was carried into the step; frozen friction, which stands on the old one, is released.
    pub(crate) fn set_slip(&mut self, slip: CarriedSlip<D>) -> Result<(), Error> {
        self.step.as_mut().ok_or(Error::NoStep)?.slip = slip;
        self.frozen = None;
        Ok(())
    }

    /// Forgets what the law of friction of a pair keeps.
    pub(crate) fn forget_friction_law(&mut self, pair: &[Partner; 2]) {
        if let Some(step) = &mut self.step {
            let of_pair = step.slip.iter_mut().filter(|((partners, ..), _)| partners == pair);
            of_pair.for_each(|(_, carried)| carried.history.clear());
        }
    }

    /// Takes the pressure of the coordinates at hand again, and the whole stiffness of what sticks.
    pub(crate) fn release_friction(&mut self) {
        (self.frozen, self.sticking) = (None, 1.0);
    }

    /// Releases kept patches.
    pub(crate) fn release_patches(&mut self) {
        self.patches = KeptPatches::none();
    }

    /// Forgets an obstacle that is removed.
    pub(crate) fn forget(&mut self, partner: Partner) {
        self.patches.forget(partner);
        if let Some(step) = &mut self.step {
            step.slip.retain(|(partners, ..), _| !partners.contains(&partner));
        }
        self.first_touches.forget(partner);
        self.leave_out(|partners| partners.contains(&partner));
    }

    /// Takes pairs out that add nothing to results any more: their frozen friction, and what moves surfaces out against them.
    pub(crate) fn leave_out(&mut self, is_left_out: impl Fn(&[Partner; 2]) -> bool) {
        self.multipliers.forget(&is_left_out);
        self.release_frozen(is_left_out);
    }

    /// Releases frozen friction of some pairs alone; that of all others stays frozen.
    pub(crate) fn release_frozen(&mut self, is_released: impl Fn(&[Partner; 2]) -> bool) {
        if let Some(frozen) = &mut self.frozen {
            frozen.release(is_released);
        }
    }

    /// Goes on with other cells of the same mesh, whose points were at `started` when the step began; `facet` is the new number of a
    /// facet, if it is still there. What was kept and frozen is released.
    pub(crate) fn take_cells(
        &mut self,
        surface: &Surface<D>,
        started: Option<&[[f64; D]]>,
        facet: impl Fn(usize) -> Option<usize>,
    ) {
        self.release_patches();
        self.release_friction();
        self.bearings = self.bearings.take().map(|bearings| bearings.of_cells(&facet));
        self.first_touches = FirstTouches::default();
        self.step = self.step.take().zip(started).map(|(step, points)| step.of_cells(surface, points, facet));
    }

    /// The frozen friction with bodies and obstacles here.
    pub(crate) fn frozen_at(&self, coords: &[[f64; D]], poses: &Poses<D>) -> Vec<SlipFacets<D>> {
        self.frozen.as_ref().map_or_else(Vec::new, |frozen| frozen.at(coords, poses))
    }
}
