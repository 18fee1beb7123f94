//! What hosts ask of cohesive interfaces.

use crate::Error;
use crate::contact::cohesive::{Breaking, CohesivePoint, CohesiveSummary};
use crate::contact::evaluation::Contact;
use crate::interfaces::{CohesiveLaw, PointDamage, PointHistory};
use crate::overlap::Partner;

impl<const D: usize> Contact<D> {
    /// The cohesive interface of two bodies at `coords`, `None` where they have none.
    ///
    /// # Errors
    /// [`Error::BodyOutOfRange`], [`Error::Length`], [`Error::NonFiniteCoordinate`]; [`Error::Untied`] where it was found on another mesh
    /// without deformation, and is not on this one.
    #[inline(never)]
    pub fn cohesive(&self, bodies: [usize; 2], coords: &[[f64; D]]) -> Result<Option<CohesiveSummary>, Error> {
        let pair = self.partners.checked_pair(bodies.map(Partner::Body), self.mesh.surface.body_count())?;
        let points = self.mesh.points(coords)?;
        self.mesh.surface.check_coords(&points, false)?;
        let all = self.at_points(&points, |at| self.cohesions.there(at))?;
        Ok(all.into_iter().find(|(cohesion, ..)| cohesion.bodies.map(Partner::Body) == pair).map(
            |(cohesion, at, _)| {
                let [stored, dissipated, rubbed, viscous] = at.energies();
                let area_of = |is: fn(f64) -> bool| {
                    // The sum of none would be −0.
                    at.points().filter(|(_, at)| is(at.now().damage)).fold(0.0, |sum, (point, _)| sum + point.measure)
                };
                CohesiveSummary {
                    area: cohesion.area,
                    largest_gap: cohesion.largest_gap,
                    count: cohesion.points.len(),
                    stored,
                    dissipated,
                    rubbed,
                    viscous,
                    damaged_area: area_of(|damage| damage > 0.0),
                    broken_area: area_of(|damage| damage >= 1.0),
                }
            },
        ))
    }

    /// Those whose damage is more at `coords` than what was accepted last.
    ///
    /// # Errors
    /// As [`Self::cohesive`].
    pub(crate) fn breaking(&self, coords: &[[f64; D]]) -> Result<Vec<Breaking>, Error> {
        if self.cohesions.is_empty() {
            return Ok(Vec::new());
        }
        let points = self.mesh.points(coords)?;
        let (at, before) =
            (self.at_points(&points, |at| self.cohesions.there(at))?, self.cohesions.list(&self.history.damage)?);
        let (mut found, mut before) = (Vec::new(), before.iter());
        for ((cohesion, at, _), held) in at.into_iter().zip(self.cohesions.all()) {
            let law = CohesiveLaw::new(&held?.1.0);
            let (mut damaged, mut broken, mut strengths) = (0.0, 0.0, [0.0; 2]);
            for ((point, at), before) in at.points().zip(&mut before) {
                let (part, now) = (point.measure / cohesion.area, at.now().damage);
                damaged += if now > before.damage.damage { part } else { 0.0 };
                broken += if now >= 1.0 { part } else { 0.0 };
                let left = law.strengths_left(before);
                (0..2).for_each(|k| strengths[k] += point.measure * left[k]);
            }
            if damaged > 0.0 {
                let is_viscous = law.is_viscous;
                found.push(Breaking { bodies: cohesion.bodies, damaged, broken, strengths, is_viscous });
            }
        }
        Ok(found)
    }

    /// All points of cohesive interfaces at `coords`, by pair.
    ///
    /// # Errors
    /// As [`Self::cohesive`].
    #[inline(never)]
    pub fn cohesive_points(&self, coords: &[[f64; D]]) -> Result<Vec<CohesivePoint<D>>, Error> {
        let points = self.mesh.points(coords)?;
        self.mesh.surface.check_coords(&points, false)?;
        let mut found = Vec::new();
        for (cohesion, at, _) in self.at_points(&points, |at| self.cohesions.there(at))? {
            found.extend(at.points().map(|(point, at)| CohesivePoint {
                bodies: cohesion.bodies,
                position: cohesion.position(point, &points).into(),
                area: point.measure,
                opening: at.opening,
                sliding: at.sliding.into(),
                traction: at.traction.into(),
                damage: at.now().damage,
                dissipated: at.now().dissipated,
                rubbed: at.history().rubbed,
                viscous: at.history().viscous,
            }));
        }
        Ok(found)
    }

    /// How far all points of cohesive interfaces are broken after the steps that were accepted ([`Self::commit_step`]), in the order of
    /// [`Self::cohesive_points`]. With the coordinates it is all that a restart needs of them, but for friction and viscosity
    /// ([`Self::cohesive_history`]).
    ///
    /// # Errors
    /// [`Error::Untied`] as [`Self::cohesive`].
    #[inline(never)]
    pub fn damage(&self) -> Result<Vec<PointDamage>, Error> {
        Ok(self.cohesions.list(&self.history.damage)?.iter().map(|state| state.damage).collect())
    }

    /// Sets it, for a restart or for an interface that is damaged at first: a crack. What [`Self::cohesive_history`] says stays.
    ///
    /// # Errors
    /// [`Error::Length`]; [`Error::NotPositive`] for a damage outside 0 to 1 or a negative energy; [`Error::Untied`]. Nothing has then
    /// changed.
    #[inline(never)]
    pub fn set_damage(&mut self, damage: &[PointDamage]) -> Result<(), Error> {
        self.history.damage = self.cohesions.of_list(&self.history.damage, ("damage", damage), |state, one| {
            state.damage = *one;
            if !(0.0..=1.0).contains(&one.damage) {
                return Err(Error::NotPositive { name: "damage", value: one.damage });
            }
            Error::check_not_negative("dissipated", one.dissipated)
        })?;
        Ok(())
    }

    /// What else these points have been through: the slip of what is broken, and what friction and viscosity have taken. A restart sets it,
    /// with the damage.
    ///
    /// # Errors
    /// As [`Self::damage`].
    #[inline(never)]
    pub fn cohesive_history(&self) -> Result<Vec<PointHistory>, Error> {
        Ok(self.cohesions.list(&self.history.damage)?.iter().map(|state| state.history).collect())
    }

    /// Sets it.
    ///
    /// # Errors
    /// [`Error::Length`]; [`Error::NotPositive`] for what is not finite, and for a negative energy of the viscosity; [`Error::Untied`]. Nothing
    /// has then changed.
    #[inline(never)]
    pub fn set_cohesive_history(&mut self, history: &[PointHistory]) -> Result<(), Error> {
        self.history.damage = self.cohesions.of_list(&self.history.damage, ("history", history), |state, one| {
            state.history = *one;
            one.check()
        })?;
        Ok(())
    }

    /// How long the step takes that is under way, and each later one until this is called again: what the viscosity of cohesive interfaces
    /// goes by.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    pub fn set_time_step(&mut self, time_step: f64) -> Result<(), Error> {
        if !(time_step.is_finite() && time_step > 0.0) {
            return Err(Error::NotPositive { name: "time_step", value: time_step });
        }
        self.history.time_step = time_step;
        self.state.forget_found();
        Ok(())
    }
}
