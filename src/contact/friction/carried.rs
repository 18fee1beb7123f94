//! What is carried from one step to the next: the elastic slip of every slider, one for each facet and what it faces.

use super::carriers::SliderName;
use crate::Error;
use crate::geometry::Vector;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// All sliders that carry something.
pub(crate) type CarriedSlip<const D: usize> = BTreeMap<SliderName, Carried<D>>;

/// What a slider carries.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Carried<const D: usize> {
    /// Elastic slip of its facet against what it faces.
    pub(crate) slip: Vector<D>,
    /// How far it has slid since it rested, where friction is another at rest.
    pub(crate) slid: f64,
    /// What a law of the host keeps of it; empty where that is nothing.
    pub(crate) history: Vec<f64>,
}

impl<const D: usize> Carried<D> {
    pub(super) fn is_nothing(&self) -> bool {
        self.slip == Vector::<D>::zeros() && self.slid == 0.0 && self.history.iter().all(|x| *x == 0.0)
    }
}

/// Elastic slip of a boundary facet against one of the bodies and obstacles that it faces, for a restart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacetSlip<const D: usize> {
    /// The facet, by its place in [`Contact::boundary_facets`](crate::Contact::boundary_facets).
    pub facet: usize,
    /// What it faces; its own body where that touches itself.
    pub partner: Partner,
    /// Whether its body is the second side of the pair. Bodies come in the order of their index, and before obstacles; a facet of a body
    /// that touches itself may be on both sides.
    pub is_second: bool,
    /// How far the facet has been shifted against the partner without sliding.
    pub slip: [f64; D],
    /// How far it has slid since it rested, at least 0, where friction falls from rest ([`Friction::at_rest`](super::Friction::at_rest)).
    pub slid: f64,
}

/// All sliders, ascending by facet, partner and side.
pub(crate) fn in_order<const D: usize>(carried: &CarriedSlip<D>) -> Vec<SliderName> {
    let mut names: Vec<_> = carried.keys().copied().collect();
    names.sort_unstable_by_key(|&([a, b], is_second, facet)| (facet, if is_second { a } else { b }, is_second));
    names
}

/// As a list, in this order.
pub(crate) fn list<const D: usize>(carried: &CarriedSlip<D>) -> Vec<FacetSlip<D>> {
    let one = |name: SliderName| {
        let (([a, b], is_second, facet), carried) = (name, &carried[&name]);
        let partner = if is_second { a } else { b };
        FacetSlip { facet, partner, is_second, slip: carried.slip.into(), slid: carried.slid }
    };
    in_order(carried).into_iter().map(one).collect()
}

/// Of a list; `body_of` is the body of a facet, if there is such a facet, `counts` are the numbers of bodies and obstacles.
///
/// # Errors
/// [`Error::NoSuchRow`], naming the row, [`Error::NonFiniteSlip`].
pub(crate) fn of_list<const D: usize>(
    list: &[FacetSlip<D>],
    body_of: impl Fn(usize) -> Option<usize>,
    [body_count, obstacle_count]: [usize; 2],
) -> Result<CarriedSlip<D>, Error> {
    let mut carried = CarriedSlip::new();
    for (row, one) in list.iter().enumerate() {
        let refuse = |what| Err(Error::NoSuchRow { list: "slip", row, what });
        let Some(body) = body_of(one.facet) else { return refuse("a facet that does not exist") };
        let is_there = match one.partner {
            Partner::Body(index) => index < body_count,
            Partner::Obstacle(index) => index < obstacle_count,
        };
        if !is_there {
            return refuse("a partner that does not exist");
        }
        let own = Partner::Body(body);
        let pair = if one.is_second { [one.partner, own] } else { [own, one.partner] };
        if pair[0] > pair[1] {
            return refuse("the other side of its pair");
        }
        if !(one.slip.iter().all(|x| x.is_finite()) && one.slid.is_finite() && one.slid >= 0.0) {
            return Err(Error::NonFiniteSlip { facet: one.facet });
        }
        if carried.insert((pair, one.is_second, one.facet), carried_by(one)).is_some() {
            return refuse("a facet and a partner that an earlier row names");
        }
    }
    Ok(carried)
}

/// Elastic slip alone.
pub(crate) fn carried_slip<const D: usize>(slip: Vector<D>) -> Carried<D> {
    Carried { slip, slid: 0.0, history: Vec::new() }
}

fn carried_by<const D: usize>(one: &FacetSlip<D>) -> Carried<D> {
    Carried { slip: Vector::from(one.slip), slid: one.slid, history: Vec::new() }
}
