//! Contact of some cells of a larger mesh: where nothing of it may be missing, and what is carried over to other cells.

use crate::Error;
use crate::configuration::{BodyTree, Configuration};
use crate::contact::friction::Step;
use crate::contact::interface::Contact;
use crate::geometry::aabb::Aabb;
use crate::geometry::plane::Plane;
use crate::geometry::submesh::hash_of;
use crate::geometry::{Pose, Shape, Surface, Vector};
use crate::overlap::{ImplicitSide, Partner, obstacle_region};
use std::sync::OnceLock;

/// Poses of the obstacles; `None` for one that was removed.
pub(crate) type Poses<const D: usize> = Vec<Option<Pose<D>>>;

/// To which coordinates, by turn, the mesh was brought when patches were kept, with the obstacles' poses, and when friction was
/// frozen.
#[derive(Default)]
pub(crate) struct Turns<const D: usize> {
    pub(crate) kept: (u64, Poses<D>),
    pub(crate) frozen: u64,
}

/// Where nothing of a body may be missing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Needed<const D: usize> {
    pub(crate) aabb: Aabb<D>,
    /// A point from which facets are seen: those are needed for which the two together reach into the box.
    pub(crate) apex: Option<Vector<D>>,
}

/// Something that was done at coordinates of an earlier turn, and would be needed again for other cells.
#[derive(Clone, Debug)]
pub(crate) struct Earlier<const D: usize> {
    pub(crate) turn: u64,
    pub(crate) poses: Poses<D>,
}

impl<const D: usize> Contact<D> {
    /// By body, where nothing of it may be missing if the bodies have these boxes.
    ///
    /// # Errors
    /// [`Error::SignedDistance`].
    pub(crate) fn needed(&self, boxes: &[Aabb<D>], reach: f64) -> Result<Vec<Vec<Needed<D>>>, Error> {
        let mut needed: Vec<Vec<Needed<D>>> = vec![Vec::new(); boxes.len()];
        let whole = |aabb: Aabb<D>| Needed { aabb, apex: None };
        let mut bodies = BodyTree::default();
        bodies.update(boxes.iter().copied());
        for (i, j) in bodies.meeting(reach) {
            if self.pair_table.has(&[Partner::Body(i), Partner::Body(j)], true) {
                needed[i].push(whole(boxes[i].intersection(&boxes[j].inflated(reach))));
                needed[j].push(whole(boxes[j].intersection(&boxes[i].inflated(reach))));
            }
        }
        for (body, aabb) in boxes.iter().enumerate() {
            if self.pair_table.has(&[Partner::Body(body); 2], self.options.self_contact) {
                needed[body].push(whole(*aabb));
            }
            for obstacle in 0..self.obstacles.len() {
                needed[body].extend(self.needed_below(body, aabb, obstacle, reach)?);
            }
        }
        Ok(needed)
    }

    /// The same for a body and an obstacle.
    fn needed_below(
        &self,
        body: usize,
        aabb: &Aabb<D>,
        obstacle: usize,
        reach: f64,
    ) -> Result<Option<Needed<D>>, Error> {
        let partners = [Partner::Body(body), Partner::Obstacle(obstacle)];
        let Some(rigid) = self.obstacles[obstacle].as_ref().filter(|_| self.pair_table.has(&partners, true)) else {
            return Ok(None);
        };
        let parallel = self.pair_table.parallel(&partners);
        let own = &rigid.obstacle.pose;
        let (shape, mut pose) = match parallel {
            Some(parallel) => (&parallel.shape, parallel.pose(own)),
            None => (rigid.implicit(), *own),
        };
        let has_depth = self.law_of(&partners).needs_depth() || self.friction_of(&partners).is_active();
        let within = match (shape, parallel.is_none().then(|| rigid.facets()).flatten()) {
            // The depth below their faces is summed along lines that run through all of the body.
            (_, Some(_)) if has_depth => Some(*aabb),
            (_, Some((_, points))) => {
                let placed: Vec<Vector<D>> = points.iter().map(|x| own.place(x)).collect();
                Some(Aabb::of(&placed).inflated(reach).intersection(aabb)).filter(|within| !within.is_empty())
            }
            (Shape::HalfSpace, None) => {
                let Plane { normal, point } = Plane::of(&pose);
                pose.position = (point + normal * (reach + aabb.rounding())).into();
                obstacle_region(&ImplicitSide { obstacle, shape, pose: &pose }, aabb)?
            }
            // How far it reaches is not known.
            _ if reach > 0.0 => Some(*aabb),
            _ => obstacle_region(&ImplicitSide { obstacle, shape, pose: &pose }, aabb)?,
        };
        let apex = (!matches!(shape, Shape::HalfSpace)).then(|| aabb.center());
        Ok(within.map(|aabb| Needed { aabb, apex }))
    }

    /// What was done at earlier coordinates: where the step began, where friction was frozen, where patches were kept.
    pub(crate) fn earlier(&self) -> [Option<Earlier<D>>; 3] {
        let step = self.step.as_ref().map(|step| Earlier { turn: step.turn, poses: step.poses.clone() });
        let frozen = self.frozen.as_ref();
        let frozen = frozen.map(|frozen| Earlier { turn: self.turns.frozen, poses: frozen.poses().to_vec() });
        let (turn, poses) = &self.turns.kept;
        let kept = (!self.kept.is_empty()).then(|| Earlier { turn: *turn, poses: poses.clone() });
        [step, frozen, kept]
    }

    /// What `work` returns with obstacles at other poses.
    pub(crate) fn with_poses<T>(&mut self, poses: &[Option<Pose<D>>], work: impl FnOnce(&mut Self) -> T) -> T {
        let mut own = poses.to_vec();
        self.exchange(&mut own);
        let found = work(self);
        self.exchange(&mut own);
        found
    }

    fn exchange(&mut self, poses: &mut [Option<Pose<D>>]) {
        for (rigid, pose) in self.obstacles.iter_mut().zip(poses) {
            if let (Some(rigid), Some(pose)) = (rigid, pose) {
                std::mem::swap(&mut rigid.obstacle.pose, pose);
            }
        }
        self.forget_found();
    }

    /// Takes other cells of the same mesh. `started` are the coordinates of their nodes at which the step began; `facet` is
    /// the new number of a facet, if it is still there. What was kept and frozen is released.
    pub(crate) fn take_cells(
        &mut self,
        surface: Surface<D>,
        started: Option<&[[f64; D]]>,
        facet: impl Fn(usize) -> Option<usize>,
        in_symmetry_plane: Option<Vec<bool>>,
    ) -> Result<(), Error> {
        self.surface = surface;
        *self.state.get_mut().unwrap_or_else(|poisoned| poisoned.into_inner()) = None;
        self.depth = OnceLock::new();
        self.in_symmetry_plane = None;
        if let Some(marked) = in_symmetry_plane {
            self.mark_symmetry(marked);
        }
        (self.kept, self.frozen) = (Vec::new(), None);
        if let (Some(step), Some(started)) = (self.step.take(), started) {
            let mut slip = vec![[0.0; D]; self.surface.facets.len()];
            for (old, carried) in step.slip.iter().enumerate() {
                if let Some(new) = facet(old) {
                    slip[new] = *carried;
                }
            }
            let points = self.surface.mesh_points(started)?;
            let mut next = Step::new(&self.surface, &points, step.poses, slip);
            next.turn = step.turn;
            next.bearings = step.bearings.map(|bearings| {
                let of = |((partners, of_b, old), bearing)| facet(old).map(|new| ((partners, of_b, new), bearing));
                bearings.into_iter().filter_map(of).collect()
            });
            self.step = Some(next);
        }
        Ok(())
    }

    /// Brings the mesh that is given in parts to coordinates of the nodes gathered.
    pub(crate) fn set_gathered(
        &mut self,
        coords: &[[f64; D]],
        boxes: &[Aabb<D>],
        complete_in: Vec<Vec<Aabb<D>>>,
        turn: u64,
        reach: f64,
    ) {
        if let Some(submesh) = &mut self.surface.submesh {
            submesh.body_boxes = boxes.to_vec();
            (submesh.complete_in, submesh.turn, submesh.brought) = (complete_in, turn, hash_of(coords));
            submesh.reach = reach;
        }
    }

    /// Repeats what was done with the cells before, at the coordinates of that time.
    pub(crate) fn freeze_again(&mut self, coords: &[[f64; D]], earlier: &Earlier<D>) -> Result<(), Error> {
        self.with_poses(&earlier.poses, |contact| contact.freeze_friction(coords))?;
        self.turns.frozen = earlier.turn;
        Ok(())
    }

    /// The same of patches.
    pub(crate) fn keep_again(&mut self, coords: &[[f64; D]], earlier: &Earlier<D>) -> Result<(), Error> {
        self.with_poses(&earlier.poses, |contact| contact.keep_patches(coords))?;
        self.turns.kept.0 = earlier.turn;
        Ok(())
    }

    /// Number of the coordinates to which a mesh in parts was brought last.
    pub(crate) fn turn(&self) -> u64 {
        self.surface.submesh.as_ref().map_or(0, |submesh| submesh.turn)
    }

    /// Refuses coordinates to which a mesh in parts was not brought: those of other cells would not be known later.
    pub(crate) fn check_brought(&self, coords: &[[f64; D]]) -> Result<(), Error> {
        match &self.surface.submesh {
            Some(submesh) if submesh.brought != hash_of(coords) => {
                let what = "friction and patches at coordinates to which the parts of the mesh were not brought";
                Err(Error::Unsupported { what })
            }
            _ => Ok(()),
        }
    }

    /// Refuses gaps to what lies farther than was gathered.
    pub(crate) fn check_reach(&self, reach: f64) -> Result<(), Error> {
        match &self.surface.submesh {
            Some(submesh) if reach > submesh.reach => {
                Err(Error::Unsupported { what: "gaps that reach farther than the parts of the mesh were gathered for" })
            }
            _ => Ok(()),
        }
    }

    /// Refuses coordinates and obstacles at which cells of a mesh in parts may be missing.
    pub(crate) fn check_gathered(&self, configuration: &Configuration<D>, coords: &[[f64; D]]) -> Result<(), Error> {
        let Some(submesh) = self.surface.submesh.as_ref() else { return Ok(()) };
        // There nothing that was not gathered has come near, though obstacles may have.
        let is_brought = submesh.brought == hash_of(coords);
        let boxes: Vec<Aabb<D>> = (0..self.surface.body_count()).map(|body| configuration.body_box(body)).collect();
        for (body, needed) in self.needed(&boxes, 0.0)?.iter().enumerate() {
            let complete_in = &submesh.complete_in[body];
            let is_complete = needed.iter().all(|needed| complete_in.iter().any(|aabb| aabb.contains(&needed.aabb)));
            let side = configuration.body(&self.surface, body);
            let first = self.surface.ranges[body].start;
            let mut ends = (0..side.facets.len()).filter(|facet| submesh.is_cut(first + facet));
            let reaches = |facet: usize| needed.iter().any(|needed| needed.aabb.meets(&side.facet_box(facet)));
            if !is_complete || !is_brought && ends.any(reaches) {
                return Err(Error::NotGathered { body });
            }
        }
        Ok(())
    }
}
