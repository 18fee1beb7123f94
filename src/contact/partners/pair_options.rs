//! Options of a single pair of partners.

use super::parallel::Parallel;
use crate::Error;
use crate::contact::friction::Friction;
use crate::contact::interface::Contact;
use crate::contact::laws::EnergyLaw;
use crate::overlap::Partner;

/// What holds for one pair of partners in place of the [`crate::contact::Options`]. The default changes nothing, but for a body
/// with itself: its self-contact is then evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairOptions {
    /// The pair is left out: it is not measured, and adds nothing to any result.
    pub excluded: bool,
    /// Energy law of the pair and its stiffness; `None`: those of the options, also after they change.
    pub law: Option<EnergyLaw>,
    /// Coefficient of friction of the pair, at least 0; `None`: that of the options, also after it changes. All else of the
    /// friction is that of the options.
    pub friction_coefficient: Option<f64>,
    /// Distance at which contact begins, in length, 0 by default. Penetration, gap and pressure are counted from there,
    /// also in weighted gaps.
    ///
    /// Of a body with an obstacle: the obstacle's surface is taken to lie so much further out (a shell's thickness, a
    /// coating), or, if negative, further in (a clearance, an overlap that is to be let be).
    ///
    /// Of two bodies, or of one with itself, only with the law `depth`, and not positive: −c lets either body in by c before
    /// it presses, w = k/2 ∫ max(0, g_A − c) + max(0, g_B − c) dx over the overlap.
    ///
    /// The parallel surface of a half-space, a ball, a capsule, and that of a cylinder inwards are of the same kind, and as
    /// exact. Any other shape becomes the signed distance φ less the offset: edges that point outwards are rounded, and
    /// what holds for a [`Shape::SignedDistance`](crate::Shape::SignedDistance) holds for it.
    pub gap_offset: f64,
}

impl PairOptions {
    /// A pair that is left out.
    pub fn excluded() -> Self {
        Self { excluded: true, ..Self::default() }
    }

    /// A pair with a law of its own.
    pub fn with_law(law: EnergyLaw) -> Self {
        Self { law: Some(law), ..Self::default() }
    }

    /// A pair whose contact begins at a distance.
    pub fn with_gap_offset(gap_offset: f64) -> Self {
        Self { gap_offset, ..Self::default() }
    }

    /// A pair with a coefficient of friction of its own.
    pub fn with_friction(coefficient: f64) -> Self {
        Self { friction_coefficient: Some(coefficient), ..Self::default() }
    }
}

impl<const D: usize> Contact<D> {
    /// Sets the options of a pair, body with body or body with obstacle, in either order; `None`: it follows the options
    /// of the contact again, as every pair does at first.
    ///
    /// For a body with itself they decide in place of `Options::self_contact` whether it is evaluated against itself:
    /// `excluded` switches that off for this body, and anything else on.
    ///
    /// Kept patches stay kept, and patches of a pair that gets a local law later are found at every evaluation, until
    /// [`Self::keep_patches`] is called again.
    ///
    /// # Errors
    /// [`Error::BodyOutOfRange`], [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`]; [`Error::Unsupported`] for two obstacles, which do not
    /// act on one another; [`Error::OfPair`] for a value out of its range, a law that the estimator does not
    /// support, or a gap offset between bodies that is positive or has another law than `depth`. The old options then stay.
    pub fn set_pair_options(&mut self, partners: [Partner; 2], options: Option<PairOptions>) -> Result<(), Error> {
        let pair = self.checked_pair(partners)?;
        let bears_as = |options: Option<PairOptions>| {
            let PairOptions { excluded, law, friction_coefficient, gap_offset, .. } = options.unwrap_or_default();
            let law = law.unwrap_or(self.options.law);
            let friction = friction_coefficient.map(|coefficient| Friction { coefficient, ..self.options.friction });
            let friction = friction.unwrap_or(self.options.friction).is_active();
            (options.is_some(), excluded, std::mem::discriminant(&law), friction, gap_offset.to_bits())
        };
        let changes = bears_as(options) != bears_as(self.pair_table.options(&pair));
        let parallel = match (options, pair[1]) {
            (Some(PairOptions { gap_offset, .. }), Partner::Obstacle(obstacle)) if gap_offset != 0.0 => {
                Some(Parallel::new(self.rigid(obstacle)?, gap_offset))
            }
            _ => None,
        };
        if let Some(PairOptions { law, friction_coefficient, excluded, .. }) = options {
            let is_rubbed = friction_coefficient.is_some_and(|coefficient| coefficient > 0.0);
            let is_own = pair[0] == pair[1] && !excluded;
            self.check_beside_multipliers(&law.unwrap_or(self.options.law), is_rubbed || is_own)?;
        }
        self.pair_table.set(pair, options, parallel, &self.options)?;
        if changes {
            self.forget_bearings();
        }
        self.forget_found();
        Ok(())
    }

    /// The options of a pair, in either order; `None` where it follows those of the contact.
    ///
    /// # Errors
    /// [`Error::BodyOutOfRange`], [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`]; [`Error::Unsupported`] for two obstacles.
    pub fn pair_options(&self, partners: [Partner; 2]) -> Result<Option<PairOptions>, Error> {
        Ok(self.pair_table.options(&self.checked_pair(partners)?))
    }

    /// The partners in the order in which pairs have them: bodies before obstacles, each by index.
    pub(crate) fn checked_pair(&self, mut partners: [Partner; 2]) -> Result<[Partner; 2], Error> {
        for partner in partners {
            match partner {
                Partner::Body(body) => {
                    let count = self.surface.body_count();
                    if body >= count {
                        return Err(Error::BodyOutOfRange { body, count });
                    }
                }
                Partner::Obstacle(obstacle) => drop(self.rigid(obstacle)?),
            }
        }
        partners.sort_unstable();
        match partners {
            [Partner::Obstacle(_), _] => {
                Err(Error::Unsupported { what: "a pair of two obstacles: they do not act on one another" })
            }
            pair => Ok(pair),
        }
    }
}
