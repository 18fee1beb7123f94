//! The pairs that have options of their own, and the law that each follows.

use super::pair_options::{Interface, PairOptions};
use super::parallel::Parallel;
use super::rigid::Rigid;
use crate::Error;
use crate::contact::friction::{Friction, Orthotropy};
use crate::contact::laws::{EnergyLaw, PairLaw, pair_law};
use crate::contact::method::Options;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Options by pair, bodies before obstacles; pairs that follow the options of the contact are not in it.
pub(crate) struct PairTable<const D: usize>(BTreeMap<[Partner; 2], Entry<D>>);

struct Entry<const D: usize> {
    options: PairOptions,
    law: Option<Box<dyn PairLaw<D>>>,
    /// What stands for the obstacle, where the contact begins at a distance from it.
    parallel: Option<Parallel<D>>,
}

impl<const D: usize> PairTable<D> {
    pub(crate) fn new() -> Self {
        Self(BTreeMap::new())
    }

    /// Puts the options of a pair in, or takes them out.
    pub(crate) fn set(
        &mut self,
        pair: [Partner; 2],
        options: Option<PairOptions>,
        parallel: Option<Parallel<D>>,
        defaults: &Options,
    ) -> Result<(), Error> {
        match options {
            Some(options) => {
                check::<D>(&pair, &options, defaults)?;
                let law = options.law.as_ref().map(pair_law);
                self.0.insert(pair, Entry { options, law, parallel });
            }
            None => drop(self.0.remove(&pair)),
        }
        Ok(())
    }

    /// Takes the options of all pairs of a partner out.
    pub(crate) fn forget(&mut self, partner: Partner) {
        self.0.retain(|pair, _| !pair.contains(&partner));
    }

    pub(crate) fn options(&self, pair: &[Partner; 2]) -> Option<PairOptions> {
        self.0.get(pair).map(|entry| entry.options)
    }

    /// Those of all pairs that have any.
    pub(crate) fn all_options(&self) -> BTreeMap<[Partner; 2], PairOptions> {
        self.0.iter().map(|(pair, entry)| (*pair, entry.options)).collect()
    }

    /// Whether the pair is evaluated, where it would be `by_default`.
    pub(crate) fn has(&self, pair: &[Partner; 2], by_default: bool) -> bool {
        // A body with itself that is in the table is there to be evaluated, unless the entry says otherwise.
        self.0.get(pair).map_or(by_default, |entry| entry.options.is_in_contact())
    }

    /// The law of the pair, if it has one of its own.
    pub(crate) fn law(&self, pair: &[Partner; 2]) -> Option<&dyn PairLaw<D>> {
        self.0.get(pair)?.law.as_deref()
    }

    /// Whether any of so many pairs, beside those of a body with itself, follows the law of the options: those in the table may have their own, or need none.
    pub(crate) fn need_stiffness(&self, pair_count: usize) -> bool {
        let needs = |entry: &Entry<D>| entry.law.is_none() && entry.options.needs_stiffness();
        let (with_itself, others): (Vec<_>, Vec<_>) = self.0.iter().partition(|([a, b], _)| a == b);
        let count = others.iter().filter(|(_, entry)| !needs(entry)).count();
        count < pair_count || with_itself.iter().any(|(_, entry)| needs(entry))
    }

    /// What stands for the obstacle of the pair, if its contact begins at a distance.
    pub(crate) fn parallel(&self, pair: &[Partner; 2]) -> Option<&Parallel<D>> {
        self.0.get(pair)?.parallel.as_ref()
    }

    /// How far outside an obstacle the contact of the pair begins.
    pub(crate) fn gap_offset(&self, pair: &[Partner; 2]) -> f64 {
        self.0.get(pair).map_or(0.0, |entry| entry.options.gap_offset)
    }

    /// Brings what stands for an obstacle to its new scale.
    pub(crate) fn rescale(&mut self, obstacle: usize, rigid: &Rigid<D>) {
        for (_, entry) in self.0.iter_mut().filter(|(pair, _)| pair[1] == Partner::Obstacle(obstacle)) {
            if entry.parallel.is_some() {
                entry.parallel = Some(Parallel::new(rigid, entry.options.gap_offset));
            }
        }
    }

    /// What these laws are.
    pub(crate) fn own_laws(&self) -> impl Iterator<Item = EnergyLaw> + '_ {
        self.0.values().filter_map(|entry| entry.options.law)
    }

    /// Multiplies the stiffness of these laws.
    pub(crate) fn stiffen(&mut self, factor: f64) {
        for entry in self.0.values_mut() {
            if let Some(law) = &mut entry.options.law {
                *law = law.stiffened(factor);
                entry.law = Some(pair_law(law));
            }
        }
    }

    /// The laws that pairs have of their own.
    pub(crate) fn laws(&self) -> impl Iterator<Item = &dyn PairLaw<D>> {
        self.0.values().filter_map(|entry| entry.law.as_deref())
    }

    /// The same of pairs of a body.
    pub(crate) fn laws_of(&self, body: usize) -> impl Iterator<Item = &dyn PairLaw<D>> {
        let of_body = self.0.iter().filter(move |(pair, _)| pair.contains(&Partner::Body(body)));
        of_body.filter_map(|(_, entry)| entry.law.as_deref())
    }

    /// The friction of the pair, which has that of the contact but for coefficients of its own.
    pub(crate) fn friction(&self, pair: &[Partner; 2], of_contact: Friction) -> Friction {
        self.0.get(pair).map_or(of_contact, |entry| entry.options.friction(of_contact))
    }

    /// How the limits of friction of the pair are by direction, where they are not the same in all.
    pub(crate) fn orthotropy(&self, pair: &[Partner; 2], of_contact: Friction) -> Option<Orthotropy> {
        self.0.get(pair)?.options.orthotropy(of_contact)
    }

    /// Whether any pair has a coefficient of friction of its own that is not zero.
    pub(crate) fn has_friction(&self) -> bool {
        self.0.values().any(|entry| entry.options.friction(Friction::default()).is_active())
    }

    /// What the sides of the pair wear by; `None`: neither does.
    pub(crate) fn wear(&self, pair: &[Partner; 2]) -> Option<[f64; 2]> {
        self.0.get(pair).map(|entry| entry.options.wear_coefficients).filter(|both| *both != [0.0; 2])
    }

    /// Whether any pair wears.
    pub(crate) fn has_wear(&self) -> bool {
        self.0.keys().any(|pair| self.wear(pair).is_some())
    }

    /// Whether all entries are allowed beside these options.
    pub(crate) fn check(&self, defaults: &Options) -> Result<(), Error> {
        self.0.iter().try_for_each(|(pair, entry)| check::<D>(pair, &entry.options, defaults))
    }
}

fn check<const D: usize>(pair: &[Partner; 2], options: &PairOptions, defaults: &Options) -> Result<(), Error> {
    let own = options.law.map_or(Ok(()), |law| law.check());
    let (law, friction) = (options.law.unwrap_or(defaults.law), options.friction(defaults.friction));
    let side = |partner| match partner {
        Partner::Body(body) => ("body", body),
        Partner::Obstacle(obstacle) => ("obstacle", obstacle),
    };
    let of_pair = |cause| Error::OfPair { sides: pair.map(side), cause: Box::new(cause) };
    // What has no effect comes first, whatever its value.
    check_interface(pair, options, &law)
        .and_then(|()| check_friction_law(options))
        .and_then(|()| check_orthotropic::<D>(pair, options, defaults))
        .and(own)
        .and_then(|()| Options { law, friction, ..*defaults }.check())
        .and_then(|()| check_offset(pair, options, law.needs_depth()))
        .and_then(|()| check_wear(pair, options, &law))
        .map_err(of_pair)
}

/// What cannot be beside another coefficient across a direction.
fn check_orthotropic<const D: usize>(
    pair: &[Partner; 2],
    options: &PairOptions,
    defaults: &Options,
) -> Result<(), Error> {
    let Some(orthotropic) = options.orthotropic else { return Ok(()) };
    let what = match pair {
        _ if D == 2 => "a transverse_coefficient in 2D, where bodies slide along one direction only",
        _ if matches!(options.interface, Interface::Cohesive(_)) => {
            "a transverse_coefficient of bodies with a cohesive interface, whose broken parts rub by one coefficient"
        }
        [a, b] if a == b => {
            "a transverse_coefficient of a body with itself, of which either side might have the direction"
        }
        _ => return orthotropic.check(&options.friction_along(defaults.friction)),
    };
    Err(Error::Unsupported { what })
}

/// What cannot be beside a law of friction of the host.
fn check_friction_law(options: &PairOptions) -> Result<(), Error> {
    let has_own =
        options.friction_coefficient.is_some() || options.static_friction.is_some() || options.orthotropic.is_some();
    let what = match () {
        () if !options.friction_law => return Ok(()),
        () if has_own => {
            "a coefficient of friction together with your own law of friction, which decides when the \
            pair slides"
        }
        () if options.interface != Interface::Contact => {
            "your own law of friction of a pair that is rough, tied, does not separate, has a cohesive interface, or one by your own law"
        }
        () if options.wear_coefficients != [0.0; 2] => {
            "a wear coefficient together with your own law of friction, which does not give the growth of the \
             pressure in the step"
        }
        () => return Ok(()),
    };
    Err(Error::Unsupported { what })
}

/// What cannot wear.
fn check_wear(pair: &[Partner; 2], options: &PairOptions, law: &EnergyLaw) -> Result<(), Error> {
    let [a, b] = options.wear_coefficients;
    let is_held = !matches!(options.interface, Interface::Contact | Interface::Rough);
    let what = match (pair, options.interface) {
        _ if [a, b] == [0.0; 2] => return Ok(()),
        ([_, Partner::Obstacle(_)], _) if b != 0.0 => "a wear coefficient of an obstacle, which does not wear",
        ([one, other], _) if one == other => "a wear coefficient of a body with itself",
        (_, Interface::Rough) => "a wear coefficient of a rough pair, which never slides",
        _ if is_held && options.surfaces.is_none() => {
            "a wear coefficient of bodies that are tied, do not separate, have a cohesive interface, or one by your own law"
        }
        _ if matches!(law, EnergyLaw::Volume { .. }) => {
            "a wear coefficient by the law volume, whose pressure is one for the whole pair: give the pair the law depth"
        }
        _ => {
            let bad = [a, b].into_iter().find(|value| !(value.is_finite() && *value >= 0.0));
            return bad.map_or(Ok(()), |value| Err(Error::NotPositive { name: "wear_coefficient", value }));
        }
    };
    Err(Error::Unsupported { what })
}

fn check_offset(pair: &[Partner; 2], options: &PairOptions, has_depth: bool) -> Result<(), Error> {
    let value = options.gap_offset;
    let apart = "a positive gap offset between bodies, since the distance of separated bodies is not measured";
    let law = "a gap offset between bodies by another law than depth";
    match pair[1] {
        _ if !value.is_finite() => Err(Error::NotPositive { name: "gap_offset", value }),
        Partner::Body(_) if value > 0.0 => Err(Error::Unsupported { what: apart }),
        Partner::Body(_) if value < 0.0 && !has_depth => Err(Error::Unsupported { what: law }),
        _ => Ok(()),
    }
}

/// What a pair cannot have beside its interface.
fn check_interface(pair: &[Partner; 2], options: &PairOptions, law: &EnergyLaw) -> Result<(), Error> {
    let rubs =
        options.friction_coefficient.is_some() || options.static_friction.is_some() || options.orthotropic.is_some();
    let interface = options.interface;
    let of = |of_tie, of_sliding, of_cohesive, of_law| match interface {
        Interface::Tied { .. } => of_tie,
        Interface::NoSeparation { .. } => of_sliding,
        Interface::Law { .. } => of_law,
        _ => of_cohesive,
    };
    let is_held = !matches!(interface, Interface::Contact | Interface::Rough);
    let has_contact = options.surfaces.is_some() && !options.excluded;
    let is_cohesive = matches!(interface, Interface::Cohesive(_));
    let what = match pair {
        _ if !is_held && options.surfaces.is_some() => "named surfaces of a pair that is not held together",
        _ if interface == Interface::Contact => return Ok(()),
        _ if interface == Interface::Rough && options.excluded => "a pair that is both excluded and rough",
        _ if interface == Interface::Rough && rubs => "friction of a rough pair, which never slides",
        _ if interface == Interface::Rough => return Ok(()),
        [_, Partner::Obstacle(_)] => of(
            "a body that is tied to an obstacle: the host prescribes how its nodes move",
            "a body that does not separate from an obstacle",
            "a cohesive interface of a body and an obstacle",
            "an interface by your own law of a body and an obstacle",
        ),
        [a, b] if a == b => of(
            "a body that is tied to itself",
            "a body that does not separate from itself",
            "a cohesive interface of a body with itself",
            "an interface by your own law of a body with itself",
        ),
        _ if options.excluded && options.surfaces.is_none() => of(
            "a pair that is both excluded and tied",
            "a pair that is both excluded and does not separate",
            "a pair that is both excluded and has a cohesive interface",
            "a pair that is both excluded and has an interface by your own law",
        ),
        _ if has_contact && !matches!(law, EnergyLaw::Depth { .. }) => {
            "named surfaces with another law than depth, by which all other faces press"
        }
        // What is broken rubs, by one coefficient.
        _ if is_cohesive && !has_contact && options.static_friction.is_some() => {
            "friction at rest of bodies with a cohesive interface, which has one coefficient"
        }
        _ if rubs && !is_cohesive && !has_contact => of(
            "friction of bodies that are tied: they do not slide",
            "friction of bodies that do not separate: they slide freely",
            "",
            "friction of bodies with an interface by your own law, which defines their sliding",
        ),
        _ if options.gap_offset != 0.0 => {
            "a gap offset of bodies that are tied, do not separate, have a cohesive interface, or one by your own law: their gap is kept as it is"
        }
        _ if interface_needs_law(interface) && matches!(law, EnergyLaw::Volume { .. }) => of(
            "bodies that are tied by the law volume, which has no stiffness per area: give the pair the law depth",
            "bodies that do not separate by the law volume, which has no stiffness per area: give the pair the law \
             depth",
            "",
            "",
        ),
        _ if !interface_needs_law(interface) && options.law.is_some() => of(
            "",
            "",
            "a law of bodies with a cohesive interface, which has its own",
            "a law of contact together with an interface by your own law",
        ),
        _ => return check_values(interface),
    };
    Err(Error::Unsupported { what })
}

/// Whether its stiffness is that of the pair's law.
fn interface_needs_law(interface: Interface) -> bool {
    matches!(interface, Interface::Tied { .. } | Interface::NoSeparation { .. })
}

fn check_values(interface: Interface) -> Result<(), Error> {
    match interface {
        Interface::Contact | Interface::Rough => Ok(()),
        Interface::Tied { reach } | Interface::NoSeparation { reach } | Interface::Law { reach } => {
            Error::check_not_negative("reach", reach)
        }
        Interface::Cohesive(cohesive) => cohesive.check(),
    }
}
