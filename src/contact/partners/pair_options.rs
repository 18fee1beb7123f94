//! Options of a single pair of partners.

use crate::contact::friction::{Friction, OrthotropicFriction, Orthotropy, StaticFriction};
use crate::contact::laws::EnergyLaw;
use crate::interfaces::Cohesive;

/// What holds for one pair of partners in place of the [`Options`](crate::Options). The default changes nothing, but for a body
/// with itself: its self-contact is then evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairOptions {
    /// The pair is left out: it is not measured, and adds nothing to any result. With named `surfaces` it is left out of contact alone: these
    /// are held together, and all other faces of the pair pass through one another.
    pub excluded: bool,
    /// Energy law of the pair and its stiffness; `None`: those of the options, also after they change.
    pub law: Option<EnergyLaw>,
    /// Coefficient of friction of the pair, at least 0, also of what is broken of a cohesive interface; `None`: that of the options, also after it changes. All else of the
    /// friction is that of the options.
    pub friction_coefficient: Option<f64>,
    /// Friction of the pair at rest; `None`: that of the options, or none where the pair has a coefficient of its own.
    pub static_friction: Option<StaticFriction>,
    /// Another coefficient across a direction; `None`: the same in all directions. In 3D, between a body and another body or an obstacle.
    pub orthotropic: Option<OrthotropicFriction>,
    /// The pair slides at the limit of a law of the host, and has none of the above: see [`FrictionLaw`](crate::contact::FrictionLaw). It is given
    /// by [`Contact::set_friction_law_pair`](crate::Contact::set_friction_law_pair); options that are set later keep it, with its history.
    pub friction_law: bool,
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
    /// What either of the two wears by, in the order of the partners, 0 by default: a side that slides by |ds| under the pressure p loses
    /// K p |ds| of its depth, in 1/pressure (Archard 1953: a wear coefficient without unit by the hardness). Obstacles do not wear. With the
    /// laws `depth` and `fiber`.
    ///
    /// Surfaces wear in [`Contact::commit_step`](crate::Contact::commit_step) alone, see [`Contact::wear`](crate::Contact::wear).
    pub wear_coefficients: [f64; 2],
    /// What happens between the two.
    pub interface: Interface,
    /// With an interface that holds bodies together: a named part of the surface of either, in the order of the partners
    /// ([`Contact::add_surface`](crate::Contact::add_surface)). Facets of both that face one another are then held, and are in no contact;
    /// all others of the pair are in contact, by the law `depth`, unless it is `excluded`. `None`: all faces of both bodies may be held, and nothing is in contact.
    pub surfaces: Option<[usize; 2]>,
}

/// What happens between two bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Interface {
    /// They press and rub where they touch.
    #[default]
    Contact,
    /// They go together where their faces face one another without deformation, within `reach`, and are in no contact: neither there
    /// nor elsewhere. Faces face one another up to an angle of 60°. A gap, or an overlap, within reach is kept, along the normal of a
    /// facet.
    ///
    /// The energy of the tie is k/2 times the squared means of the jump, with the stiffness k of the pair's law; its rows are those of
    /// [`Contact::tie_constraints`](crate::Contact::tie_constraints). Multipliers take the jump away.
    Tied {
        /// In length; 0: a tenth of the mean facet of the body with the larger facets, all its faces included.
        reach: f64,
    },
    /// They slide on one another without friction, and do not separate, where their faces face one another without deformation as those that
    /// are tied: the normal part of a tie, along the normals of facets as these turn, also in compression. They are in no other contact.
    ///
    /// Points that face one another are found anew where a step begins ([`Contact::begin_step`](crate::Contact::begin_step),
    /// [`Contact::commit_step`](crate::Contact::commit_step)) and with the multipliers ([`Contact::augment`](crate::Contact::augment)); in
    /// between they slide along the planes of the facets.
    NoSeparation {
        /// In length; 0: a tenth of the larger facets.
        reach: f64,
    },
    /// They press and open as in contact, and never slide where they touch: the limit of Coulomb friction with an infinite coefficient.
    Rough,
    /// They are held together where their faces face one another without deformation, as those that are tied, but by an interface that opens,
    /// slides and breaks: see [`Cohesive`]. They are in no contact: the interface carries compression with the stiffness that it has
    /// without damage, at the material points that faced one another at first, also where it is broken. What is broken and pressed rubs,
    /// by the coefficient of the pair and the shear limit of the options.
    ///
    /// Its damage grows in evaluations, and is kept by [`Contact::commit_step`](crate::Contact::commit_step); set anew with other options, or
    /// with another mesh without deformation, it is whole again.
    Cohesive(Cohesive),
    /// They are held together where those with a cohesive interface would be, by a law of the host: see
    /// [`InterfaceLaw`](crate::contact::InterfaceLaw). They are in no contact, so that the law has to resist compression. It is given by
    /// [`Contact::set_law_pair`](crate::Contact::set_law_pair); options that are set later keep it, with its history.
    Law {
        /// In length; 0: a tenth of the larger facets.
        reach: f64,
    },
}

impl PairOptions {
    /// The friction of the pair, beside that of the options; the largest of all directions.
    pub(crate) fn friction(&self, of_contact: Friction) -> Friction {
        if self.interface == Interface::Rough {
            let (coefficient, shear_limit) = (f64::INFINITY, f64::INFINITY);
            return Friction { coefficient, shear_limit, at_rest: None, ..of_contact };
        }
        if self.friction_law {
            // Of the pressure, from which the law has the limit.
            let Friction { stiffness, memoryless_slip, .. } = of_contact;
            return Friction { stiffness, memoryless_slip, ..Friction::coulomb(1.0) };
        }
        let along = self.friction_along(of_contact);
        self.orthotropic.map_or(along, |own| own.largest(along))
    }

    /// How the limits of that are by direction, where they are not the same in all.
    pub(crate) fn orthotropy(&self, of_contact: Friction) -> Option<Orthotropy> {
        Some(self.orthotropic?.shape(self.friction_along(of_contact)))
    }

    /// The friction along the direction, if it has one.
    pub(super) fn friction_along(&self, of_contact: Friction) -> Friction {
        let own = self.friction_coefficient;
        Friction {
            coefficient: own.unwrap_or(of_contact.coefficient),
            at_rest: self.static_friction.or(of_contact.at_rest.filter(|_| own.is_none())),
            ..of_contact
        }
    }

    /// A pair that is left out.
    pub fn excluded() -> Self {
        Self { excluded: true, ..Self::default() }
    }

    /// Two bodies that are tied, within a reach; 0: as of [`Interface::Tied`].
    pub fn tied(reach: f64) -> Self {
        Self { interface: Interface::Tied { reach }, ..Self::default() }
    }

    /// Two bodies that slide and do not separate, within a reach; 0: a tenth of the larger facets.
    pub fn no_separation(reach: f64) -> Self {
        Self { interface: Interface::NoSeparation { reach }, ..Self::default() }
    }

    /// Two partners that never slide where they touch.
    pub fn rough() -> Self {
        Self { interface: Interface::Rough, ..Self::default() }
    }

    /// Two bodies that are held together by an interface that breaks.
    pub fn with_cohesive(cohesive: Cohesive) -> Self {
        Self { interface: Interface::Cohesive(cohesive), ..Self::default() }
    }

    /// What holds it: nothing of a pair that is left out, unless named parts are held beside faces that are.
    pub(crate) fn held(&self) -> Interface {
        if self.excluded && self.surfaces.is_none() { Interface::Contact } else { self.interface }
    }

    /// The same between named parts of their surfaces alone.
    pub fn between(self, surfaces: [usize; 2]) -> Self {
        Self { surfaces: Some(surfaces), ..self }
    }

    /// Those of the same pair with its partners in the other order.
    pub(crate) fn swapped(self) -> Self {
        let orthotropic = self.orthotropic.map(OrthotropicFriction::swapped);
        let [a, b] = self.wear_coefficients;
        Self { surfaces: self.surfaces.map(|[a, b]| [b, a]), orthotropic, wear_coefficients: [b, a], ..self }
    }

    /// Whether the two press and rub somewhere: they are neither left out nor tied, nor held together by an interface that breaks, unless
    /// by parts of their surfaces.
    pub(crate) fn is_in_contact(&self) -> bool {
        let is_held = !matches!(self.interface, Interface::Contact | Interface::Rough);
        !self.excluded && (!is_held || self.surfaces.is_some())
    }

    /// Whether the stiffness of the law matters: where the two press, are tied, or do not separate. An interface that breaks has its own.
    pub(crate) fn needs_stiffness(&self) -> bool {
        self.is_in_contact() || matches!(self.held(), Interface::Tied { .. } | Interface::NoSeparation { .. })
    }

    /// A pair with a law of its own.
    pub fn with_law(law: EnergyLaw) -> Self {
        Self { law: Some(law), ..Self::default() }
    }

    /// A pair whose contact begins at a distance.
    pub fn with_gap_offset(gap_offset: f64) -> Self {
        Self { gap_offset, ..Self::default() }
    }

    /// A pair of which either side wears by a coefficient.
    pub fn with_wear(coefficients: [f64; 2]) -> Self {
        Self { wear_coefficients: coefficients, ..Self::default() }
    }

    /// A pair with a coefficient of friction of its own.
    pub fn with_friction(coefficient: f64) -> Self {
        Self { friction_coefficient: Some(coefficient), ..Self::default() }
    }

    /// A pair with a coefficient of friction of its own along a direction, and another across it.
    pub fn with_orthotropic_friction(coefficient: f64, across: OrthotropicFriction) -> Self {
        Self { orthotropic: Some(across), ..Self::with_friction(coefficient) }
    }
}
