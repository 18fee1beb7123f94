//! Contact of a mesh that ranks hold in parts.

use super::anchors::Anchors;
use super::carried::{self, Earlier};
use super::mesh_part::MeshPart;
use super::own_mesh::OwnMesh;
use super::places::Places;
use super::selection::{Search, selected};
use super::zone::Zone;
use crate::Error;
use crate::configuration::CellCheck;
use crate::contact::with_poses;
use crate::contact::{Contact, Needed, Options, hash_in_common, needed};
use crate::geometry::Vector;
use crate::geometry::boundary::symmetry::{NamedFace, Symmetry, SymmetryPlane, check_bodies, planes_of};
use crate::geometry::primitives::aabb::Aabb;
use crate::ranks::{Communicator, Ranks, packed};
use std::collections::BTreeMap;

packed!(NamedFace<D> { nodes, corners });

/// Contact of a mesh that ranks hold in parts: [`Contact`] of the cells that may be in contact, which all ranks have.
///
/// [`Self::set_coords`] takes the coordinates of the own nodes of every rank. After it [`Self::contact`] is the contact at
/// [`Self::coords`], with the bits of a contact of the whole mesh; its nodes have the numbers [`Self::node_numbers`], of which
/// [`Self::own_nodes`] are this rank's. Its evaluations are made by all ranks together, which share the work. What was begun,
/// kept or frozen stays when other cells are gathered.
///
/// A body may touch itself; all of it is then gathered. Nodes that hang, and nodes that a host's unknowns move, are refused.
pub struct PartitionedContact<const D: usize> {
    pub(super) own: OwnMesh<D>,
    anchors: Anchors<D>,
    /// Whether they are those with an axis.
    has_axis: bool,
    pub(super) contact: Contact<D>,
    pub(super) zone: Zone,
    /// Of the nodes gathered.
    coords: Vec<[f64; D]>,
    epoch: u64,
    /// Own coordinates by epoch, as far as something was begun, kept or frozen there; and the last.
    earlier: BTreeMap<u64, Vec<[f64; D]>>,
    gathering: Option<Gathering<D>>,
    reach: f64,
    symmetry: Option<Symmetry<D>>,
    cell_check: Option<CellCheck<D>>,
    gather_count: u64,
    facet_count: usize,
}

/// For what cells were gathered.
struct Gathering<const D: usize> {
    /// Own coordinates.
    coords: Vec<[f64; D]>,
    needed: Vec<Vec<Needed<D>>>,
    /// How far around that all cells are there.
    margin: f64,
}

/// How much of a mesh in parts was gathered: the same on all ranks, but for the own cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GatheredCounts {
    /// Cells that this rank gave.
    pub own_cell_count: usize,
    /// Boundary facets of the whole mesh.
    pub facet_count: usize,
    /// Those that every rank has.
    pub gathered_facet_count: usize,
    /// Cells that every rank has.
    pub gathered_cell_count: usize,
    /// How often cells were gathered.
    pub gather_count: u64,
}

impl<const D: usize> PartitionedContact<D> {
    /// Contact of a mesh of which this rank has a part, brought to its coordinates without deformation. `reach`: how far
    /// [`Contact::gap_constraints`] may reach, 0 where they are not asked for. All ranks call it together.
    ///
    /// # Errors
    /// As [`Surface::from_cells`](crate::Surface::from_cells), [`Contact::new`] and [`Self::set_coords`]; [`Error::Length`],
    /// [`Error::BadRank`], [`Error::NotPositive`] for a reach that is negative.
    #[inline(never)]
    pub fn new(
        communicator: Box<dyn Communicator>,
        part: &MeshPart<D>,
        options: Options,
        reach: f64,
    ) -> Result<Self, Error> {
        let ranks = Ranks::new(communicator)?;
        let is_reach = reach.is_finite() && reach >= 0.0;
        ranks.agree(
            if is_reach { Ok(()) } else { Err(Error::NotPositive { name: "reach", value: reach }) },
            reach.to_bits(),
        )?;
        let own = OwnMesh::new(part, &ranks)?;
        let (zone, surface, _) = Zone::gather(&own, &[], None, &[], &ranks)?;
        let facet_count = ranks.gather_lists(&[own.facet_count()])?.into_iter().flatten().sum();
        let mut contact = ranks.agree(Contact::new(surface, options), 0)?;
        contact.work.take_ranks(ranks);
        let mut new = Self {
            anchors: Anchors::new(&own, None),
            has_axis: false,
            own,
            contact,
            zone,
            coords: Vec::new(),
            epoch: 0,
            earlier: BTreeMap::new(),
            gathering: None,
            reach,
            symmetry: None,
            cell_check: None,
            gather_count: 0,
            facet_count,
        };
        new.set_coords(part.coords)?;
        Ok(new)
    }

    /// Brings the mesh to coordinates of its nodes, of which every rank gives those of its own. Returns whether other cells were
    /// gathered: nodes, cells and facets of the contact are then other ones. All ranks call it together, with the same
    /// options and obstacles.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`], [`Error::InvertedCell`], [`Error::ZeroMeasure`],
    /// [`Error::FoldedCell`], naming own nodes and cells; on other ranks [`Error::OnOtherRank`]. [`Error::RanksDiffer`] for a
    /// node that has not the same coordinates on all, [`Error::SignedDistance`], [`Error::Communication`].
    #[inline(never)]
    pub fn set_coords(&mut self, coords: &[[f64; D]]) -> Result<bool, Error> {
        let in_common = hash_in_common(&self.contact, &[], "set_coords");
        let checked = self.check(coords);
        self.ranks()?.agree(checked, in_common)?;
        let since = self.gathering.as_ref().map(|gathering| &gathering.coords[..]);
        let places = Places::gather(&self.own, coords, since, self.ranks()?)?;
        let needed = needed(&self.contact, &places.boxes, self.reach);
        let needed = self.ranks()?.agree(needed, 0)?;
        let epochs: Vec<u64> =
            carried::earlier(&self.contact).into_iter().flatten().map(|earlier| earlier.epoch).collect();
        self.earlier.retain(|epoch, _| epochs.contains(epoch));
        let is_outgrown = !self.gathering.as_ref().is_some_and(|gathering| gathering.covers(&needed, places.moved));
        if is_outgrown {
            self.gathering = None;
            self.gather(coords, needed)?;
        }
        self.coords = self.zone.coords(coords, self.ranks()?)?;
        self.epoch += 1;
        let moved = if is_outgrown { 0.0 } else { places.moved };
        let complete_in = self.gathering.as_ref().map_or_else(Vec::new, |gathering| gathering.complete_in(moved));
        carried::set_gathered(&mut self.contact, &self.coords, &places.boxes, complete_in, (self.epoch, self.reach));
        self.earlier.insert(self.epoch, coords.to_vec());
        Ok(is_outgrown)
    }

    /// The contact of the cells gathered, whose evaluations are at [`Self::coords`]. Of the facets that it tells of, those
    /// behind which the mesh goes on are never in contact.
    pub fn contact(&self) -> &Contact<D> {
        &self.contact
    }

    /// The same, to set options and obstacles, begin and commit steps, keep patches and freeze friction: on all ranks alike.
    pub fn contact_mut(&mut self) -> &mut Contact<D> {
        &mut self.contact
    }

    /// Number of own nodes.
    pub fn own_node_count(&self) -> usize {
        self.own.node_count()
    }

    /// Takes part in [`Self::new`] on a rank that cannot, so that the others do not wait: they are told that it failed.
    pub(crate) fn refuse(communicator: Box<dyn Communicator>) {
        if let Ok(ranks) = Ranks::new(communicator) {
            // What it returns is the failure that is known here.
            let _: Result<(), Error> = ranks.agree(Err(Error::Empty), 0);
        }
    }

    /// Makes a call that cannot be made here, so that the others do not wait: they are told that it failed.
    pub(crate) fn fail_elsewhere(&self) {
        if let Some(ranks) = self.contact.work.ranks() {
            // What it returns is the failure that is known here.
            let _: Result<(), Error> = ranks.agree(Err(Error::Empty), 0);
        }
    }

    /// Coordinates of the nodes gathered.
    pub fn coords(&self) -> &[[f64; D]] {
        &self.coords
    }

    /// Number in the whole mesh of each node gathered, ascending.
    pub fn node_numbers(&self) -> &[u64] {
        &self.zone.nodes
    }

    /// The own node of each node gathered, as this rank counts them; `None` for a node of other ranks alone.
    pub fn own_nodes(&self) -> &[Option<u32>] {
        &self.zone.own
    }

    /// Number in the whole mesh of each cell gathered, ascending.
    pub fn cell_numbers(&self) -> &[u64] {
        &self.zone.cells
    }

    /// How much was gathered.
    pub fn counts(&self) -> GatheredCounts {
        let surface = self.contact.surface();
        GatheredCounts {
            own_cell_count: self.own.len(),
            facet_count: self.facet_count,
            gathered_facet_count: (0..surface.facet_count()).filter(|&facet| surface.is_surface_facet(facet)).count(),
            gathered_cell_count: self.zone.cells.len(),
            gather_count: self.gather_count,
        }
    }

    /// Names own nodes in planes of symmetry, as [`Contact::set_symmetry_nodes`] does. Nodes between ranks are named by all that
    /// have them. All ranks call it together, and bring the mesh to its coordinates again after it.
    ///
    /// # Errors
    /// [`Error::NodeOutOfRange`]; [`Error::Unsupported`] on all ranks for a body of the whole mesh that would have no surface left, or for
    /// nodes of a curved surface. What was named before then stays.
    #[inline(never)]
    pub fn set_symmetry_nodes(&mut self, nodes: &[u32]) -> Result<(), Error> {
        let node_count = self.own.node_count();
        let mut marked = vec![false; node_count];
        let outside = nodes.iter().enumerate().find(|(_, node)| **node as usize >= node_count);
        let outside =
            outside.map_or(Ok(()), |(cell, &node)| Err(Error::NodeOutOfRange { cell, node: node.into(), node_count }));
        self.ranks()?.agree(outside, 6)?;
        nodes.iter().for_each(|&node| marked[node as usize] = true);
        let number = |node: u32| self.own.node_numbers[node as usize];
        let named = self.own.surface.iter().flat_map(|surface| surface.named_faces(&marked, number));
        let faces = self.ranks()?.gather_lists(&named.collect::<Vec<NamedFace<D>>>())?.concat();
        self.take_symmetry(Symmetry { planes: planes_of(faces)?, marks: marked })
    }

    /// Says where planes of symmetry are, as [`Contact::set_symmetry_planes`] does. All ranks say the same, together, and bring the mesh to
    /// its coordinates again after it.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a normal without length; [`Error::Unsupported`] on all ranks for a body of the whole mesh that would
    /// have no surface left. What was said before then stays.
    #[inline(never)]
    pub fn set_symmetry_planes(&mut self, planes: &[[[f64; D]; 2]]) -> Result<(), Error> {
        let planes = planes.iter().map(|[point, normal]| SymmetryPlane::new(point, normal)).collect::<Result<_, _>>();
        let planes: Vec<SymmetryPlane<D>> = self.ranks()?.agree(planes, 6)?;
        self.take_symmetry(Symmetry { planes, marks: vec![true; self.own.node_count()] })
    }

    fn take_symmetry(&mut self, symmetry: Symmetry<D>) -> Result<(), Error> {
        let with_surface = self.own.bodies_with_surface(&symmetry);
        let with_surface = self.ranks()?.gather_lists(&with_surface)?.concat();
        let has_surface = |body: usize| with_surface.contains(&(body as u64));
        check_bodies(&(0..self.own.body_ids.len()).map(has_surface).collect::<Vec<_>>())?;
        let of_ranks = self.ranks()?.gather_lists(&[symmetry.hash()])?.concat();
        self.contact.mesh.tell_symmetry(of_ranks.into_iter().fold(0, u64::wrapping_add));
        self.symmetry = Some(symmetry);
        self.gathering = None;
        self.find_anchors();
        Ok(())
    }

    /// Facets in planes of symmetry, or on an axis, are no surface.
    fn find_anchors(&mut self) {
        self.has_axis = self.contact.options().axisymmetric;
        let (has_axis, reference) = (self.has_axis, &self.own.reference);
        let rounding = self.own.whole.reference_box.rounding();
        let symmetry = self.symmetry.as_ref();
        let goes_on = |nodes: &[u32]| {
            let places: Vec<Vector<D>> = nodes.iter().map(|&node| reference[node as usize].into()).collect();
            has_axis && places.iter().all(|x| x[0] <= rounding)
                || symmetry.is_some_and(|symmetry| symmetry.has(nodes, &places))
        };
        self.anchors = Anchors::new(&self.own, (has_axis || symmetry.is_some()).then_some(&goes_on));
    }

    fn ranks(&self) -> Result<&Ranks, Error> {
        self.contact.work.ranks().ok_or(Error::BadRank { rank: 0, size: 0 })
    }

    fn check(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        let check_cells = self.contact.options().check_cells;
        if coords.len() != self.own.node_count() {
            return Err(Error::Length { array: "coords", expected: self.own.node_count(), found: coords.len() });
        }
        let Some(surface) = &self.own.surface else { return Ok(()) };
        let points = surface.mesh_points(coords)?;
        surface.check_coords(&points, true)?;
        match &surface.cells {
            Some(cells) if check_cells => self
                .cell_check
                .get_or_insert_with(|| CellCheck::new(cells, surface.curved()))
                .check(cells, surface.curved(), &points, false)
                .map_err(|error| surface.in_host_numbers(error)),
            _ => Ok(()),
        }
    }

    /// Gathers the cells that are needed at these coordinates, and where something was begun, kept or frozen.
    fn gather(&mut self, coords: &[[f64; D]], needed: Vec<Vec<Needed<D>>>) -> Result<(), Error> {
        if self.has_axis != self.contact.options().axisymmetric {
            self.find_anchors();
        }
        let earlier = carried::earlier(&self.contact);
        let mut places_then: Vec<Option<Then<D>>> = Vec::with_capacity(earlier.len());
        for earlier in &earlier {
            places_then.push(earlier.as_ref().map(|earlier| self.places_at(earlier)).transpose()?);
        }
        let margin = self.own.cell_size;
        let now = Search { coords, needed: &needed, margin: 2.0 * margin };
        let then = places_then.iter().flatten();
        let then = then.map(|then| Search { coords: &then.coords, needed: &then.needed, margin });
        let searches: Vec<Search<D>> = std::iter::once(now).chain(then).collect();
        let mut cells = selected(&self.own, &searches);
        cells.extend(self.own.cells_of(&self.cells_with_slip()));
        let marks = self.symmetry.as_ref().map_or(&[][..], |symmetry| &symmetry.marks);
        let ranks = self.ranks()?;
        let (zone, surface, marked) = Zone::gather(&self.own, &cells, Some(&self.anchors), marks, ranks)?;
        let started = places_then[0].as_ref().map(|then| zone.coords(&then.coords, ranks)).transpose()?;
        let old = std::mem::replace(&mut self.zone, zone);
        let symmetry = self.symmetry.as_ref().map(|s| Symmetry { planes: s.planes.clone(), marks: marked });
        let numbers = self.zone.facet_numbers();
        let facet = |facet: usize| numbers.get(&old.facets[facet]).copied();
        carried::take_cells(&mut self.contact, surface, started.as_deref(), facet, symmetry)?;
        for (number, then) in places_then.iter().enumerate().skip(1) {
            let (Some(then), Some(earlier)) = (then, &earlier[number]) else { continue };
            let coords = self.zone.coords(&then.coords, self.ranks()?)?;
            let complete_in =
                then.needed.iter().map(|of_body| of_body.iter().map(|needed| needed.aabb.inflated(margin)).collect());
            let at = (earlier.epoch, self.reach);
            carried::set_gathered(&mut self.contact, &coords, &then.boxes, complete_in.collect(), at);
            with_poses(&mut self.contact, &earlier.poses, |contact| match number {
                1 => contact.freeze_friction(&coords),
                _ => contact.keep_patches(&coords).map(drop),
            })?;
        }
        self.gathering = Some(Gathering { coords: coords.to_vec(), needed, margin });
        self.gather_count += 1;
        Ok(())
    }

    fn places_at(&mut self, earlier: &Earlier<D>) -> Result<Then<D>, Error> {
        let coords = self.earlier.get(&earlier.epoch).ok_or(Error::NoStep)?.clone();
        let boxes = Places::gather(&self.own, &coords, None, self.ranks()?)?.boxes;
        let reach = self.reach;
        let needed = with_poses(&mut self.contact, &earlier.poses, |contact| needed(contact, &boxes, reach));
        Ok(Then { coords, needed: self.ranks()?.agree(needed, 0)?, boxes })
    }

    /// Numbers of the cells whose facets carry slip.
    fn cells_with_slip(&self) -> Vec<u64> {
        let slip = self.contact.slip().unwrap_or_default();
        let mut cells: Vec<u64> = slip.iter().map(|of| self.zone.facets[of.facet].cell).collect();
        cells.dedup();
        cells
    }
}

/// Where bodies were when something was begun, kept or frozen.
struct Then<const D: usize> {
    coords: Vec<[f64; D]>,
    boxes: Vec<Aabb<D>>,
    needed: Vec<Vec<Needed<D>>>,
}

impl<const D: usize> Gathering<D> {
    /// Whether nothing is missing where nodes have moved so far since.
    fn covers(&self, needed: &[Vec<Needed<D>>], moved: f64) -> bool {
        needed.iter().zip(&self.needed).all(|(now, then)| {
            now.len() == then.len()
                && now.iter().zip(then).all(|(now, then)| {
                    let apex_moved = now.apex.zip(then.apex).map_or(0.0, |(now, then)| (now - then).amax());
                    let room = 2.0 * self.margin - moved.max(apex_moved);
                    room > 0.0
                        && then.aabb.inflated(room).contains(&now.aabb)
                        && now.apex.is_some() == then.apex.is_some()
                })
        })
    }

    /// Where nothing is missing then.
    fn complete_in(&self, moved: f64) -> Vec<Vec<Aabb<D>>> {
        let room = 2.0 * self.margin - moved;
        self.needed.iter().map(|of_body| of_body.iter().map(|needed| needed.aabb.inflated(room)).collect()).collect()
    }
}
