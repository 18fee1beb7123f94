//! What hosts ask of cohesive interfaces.

use crate::Error;
use crate::contact::cohesive::{Breaking, CohesivePoint, CohesiveSummary};
use crate::contact::evaluation::Contact;
use crate::interfaces::PointDamage;
use crate::overlap::Partner;

impl<const D: usize> Contact<D> {
    /// The cohesive interface of two bodies at `coords`, `None` where they have none.
    ///
    /// # Errors
    /// [`Error::BodyOutOfRange`], [`Error::Length`], [`Error::NonFiniteCoordinate`]; [`Error::Untied`] where it was found on another mesh
    /// without deformation, and is not on this one.
    pub fn cohesive(&self, bodies: [usize; 2], coords: &[[f64; D]]) -> Result<Option<CohesiveSummary>, Error> {
        let pair = self.partners.checked_pair(bodies.map(Partner::Body), self.mesh.surface.body_count())?;
        let points = self.mesh.points(coords)?;
        self.mesh.surface.check_coords(&points, false)?;
        let all = self.cohesions.at(&points, &self.history.damage)?;
        Ok(all.into_iter().find(|(cohesion, _)| cohesion.bodies.map(Partner::Body) == pair).map(|(cohesion, at)| {
            let [stored, dissipated] = at.energies();
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
                damaged_area: area_of(|damage| damage > 0.0),
                broken_area: area_of(|damage| damage >= 1.0),
            }
        }))
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
        let (at, before) = (self.cohesions.at(&points, &self.history.damage)?, self.damage()?);
        let (mut found, mut before) = (Vec::new(), before.iter());
        for ((cohesion, at), law) in at.into_iter().zip(self.cohesions.all()) {
            let (_, law) = law?;
            let (mut damaged, mut broken, mut strengths) = (0.0, 0.0, [0.0; 2]);
            for ((point, at), before) in at.points().zip(&mut before) {
                let (part, now) = (point.measure / cohesion.area, at.now().damage);
                damaged += if now > before.damage { part } else { 0.0 };
                broken += if now >= 1.0 { part } else { 0.0 };
                let left = law.strengths_left(before.damage);
                (0..2).for_each(|k| strengths[k] += point.measure * left[k]);
            }
            if damaged > 0.0 {
                found.push(Breaking { bodies: cohesion.bodies, damaged, broken, strengths });
            }
        }
        Ok(found)
    }

    /// All points of cohesive interfaces at `coords`, by pair.
    ///
    /// # Errors
    /// As [`Self::cohesive`].
    pub fn cohesive_points(&self, coords: &[[f64; D]]) -> Result<Vec<CohesivePoint<D>>, Error> {
        let points = self.mesh.points(coords)?;
        self.mesh.surface.check_coords(&points, false)?;
        let mut found = Vec::new();
        for (cohesion, at) in self.cohesions.at(&points, &self.history.damage)? {
            found.extend(at.points().map(|(point, at)| CohesivePoint {
                bodies: cohesion.bodies,
                position: cohesion.position(point, &points).into(),
                area: point.measure,
                opening: at.opening,
                sliding: at.sliding.into(),
                traction: at.traction.into(),
                damage: at.now().damage,
                dissipated: at.now().dissipated,
            }));
        }
        Ok(found)
    }

    /// What all points of cohesive interfaces have been through in the steps that were accepted ([`Self::commit_step`]), in the order of
    /// [`Self::cohesive_points`]. With the coordinates it is all that a restart needs of them.
    ///
    /// # Errors
    /// [`Error::Untied`] as [`Self::cohesive`].
    pub fn damage(&self) -> Result<Vec<PointDamage>, Error> {
        self.cohesions.list(&self.history.damage)
    }

    /// Sets it, for a restart or for an interface that is damaged at first: a crack.
    ///
    /// # Errors
    /// [`Error::Length`]; [`Error::NotPositive`] for a damage outside 0 to 1 or a negative energy; [`Error::Untied`]. Nothing has then
    /// changed.
    pub fn set_damage(&mut self, damage: &[PointDamage]) -> Result<(), Error> {
        self.history.damage = self.cohesions.of_list(damage)?;
        Ok(())
    }
}
