//! Obstacles of every shape, added, found and removed.

use super::Host;
use super::array::{Array, checked, unless};
use super::callbacks::{Distance, distance};
use crate::guarded::Guarded;
use crate::interface::*;
use crate::number::Number;
use crate::program::{Hole, Layout, Pose, Shape};
use std::ptr::null;

pub(super) fn pose(from: &Pose, dim: usize) -> fmc_pose {
    let mut pose = fmc_pose { position: [0.0; 3], rotation: [0.0; 9], scale: 1.0 };
    let (position, axis) = (from.position.map(|x| x.0), from.axis.map(|x| x.0));
    // SAFETY: `dim` entries of three are read.
    unsafe {
        assert_eq!(fmc_pose_init(&raw mut pose), OK);
        let before = pose;
        if checked(fmc_pose_along(dim as i32, position.as_ptr(), axis.as_ptr(), &raw mut pose)) != OK {
            assert_eq!(pose, before);
            pose.position = position;
        }
    }
    if let Some(rotation) = from.rotation {
        pose.rotation = rotation.map(|x| x.0);
    }
    pose.scale = from.scale.map_or(1.0, |x| x.0);
    pose
}

/// A shape with no measures; of a kind that is none, an empty half-space that says so.
fn empty(kind: i32) -> fmc_shape {
    let mut shape = std::mem::MaybeUninit::<fmc_shape>::zeroed();
    // SAFETY: a struct of numbers and pointers, which may be zero, and which the library initialises.
    unsafe {
        if checked(fmc_shape_init(shape.as_mut_ptr(), kind)) != OK {
            assert_eq!(fmc_shape_init(shape.as_mut_ptr(), FMC_SHAPE_HALF_SPACE), OK);
        }
        fmc_shape { kind, ..shape.assume_init() }
    }
}

fn pose_at_origin() -> fmc_pose {
    let mut pose = fmc_pose { position: [0.0; 3], rotation: [0.0; 9], scale: 1.0 };
    // SAFETY: a pose that may be written.
    assert_eq!(unsafe { fmc_pose_init(&raw mut pose) }, OK);
    pose
}

impl Host {
    pub(super) fn add(&mut self, shape: &Shape, place: Option<fmc_pose>, hole: Hole) {
        let (context, mut obstacle) = (self.context, 77usize);
        let place = place.as_ref().map_or(null(), |place| &raw const *place);
        let index = unless(hole, 0, &raw mut obstacle);
        let (dim, base) = (self.mesh.dim, i64::from(self.options.index_base));
        let points: Vec<f64> = shape.corners.iter().take(12).flat_map(|x| x[..dim].iter().map(|x| x.0)).collect();
        let points = Array::new(&points, dim, Layout::Rows);
        let simplex: &[i64] = if dim == 2 { &[0, 1, 1, 2, 2, 0] } else { &[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3] };
        let facets: Vec<i64> = match shape.facets.len() {
            0..3 => simplex.iter().map(|node| node + base).collect(),
            _ => shape.facets.iter().map(|f| i64::from(f % 8) - 1).collect(),
        };
        let facets = &facets[..facets.len() / dim * dim];
        let (wide, narrow) = (Guarded::new(facets), facets.iter().map(|&f| f as i32).collect::<Vec<_>>());
        let narrow = Guarded::new(&narrow);
        let counts = [usize::from(shape.count % 5), 2];
        let heights = Guarded::new(&shape.heights.map(|x| x.0)[..counts[..dim - 1].iter().product()]);
        let radius = shape.radius.0;
        let own = Box::new(Distance {
            dim,
            radius: if radius.is_finite() { radius.abs().min(2.0) } else { 1.0 },
            fault: shape.fault,
            context,
        });
        let kind = i32::from(shape.kind % 16);
        let part = |(kind, size): &(u8, Number)| {
            let mut part = empty(i32::from(kind % 16));
            (part.radius, part.half_height, part.half_extents) = (size.0, 0.5, [size.0; 3]);
            part
        };
        let shapes = Guarded::new(&shape.parts.iter().take(4).map(part).collect::<Vec<_>>());
        let at_origin = pose_at_origin();
        let count = shapes.values().len();
        let parts: Vec<fmc_part> =
            (0..count).map(|part| fmc_part { shape: shapes.ptr().wrapping_add(part), pose: at_origin }).collect();
        let parts = Guarded::new(&parts);
        let data = fmc_shape {
            index_size: if shape.is_wide { 8 } else { 4 },
            radius,
            half_height: shape.half_height.0,
            half_extents: shape.half_extents.map(|x| x.0),
            points: points.view,
            facets: if shape.is_wide { wide.ptr().cast() } else { narrow.ptr().cast() },
            facet_count: facets.len() / dim,
            heights: unless(hole, 1, heights.ptr()),
            counts,
            lengths: [2.0, 1.0],
            thickness: shape.thickness.0,
            parts: parts.ptr().cast(),
            part_count: count,
            signed_distance: Some(distance),
            user: (&raw const *own).cast_mut().cast(),
            ..empty(kind)
        };
        self.distances.push(own);
        let data = Guarded::new(&[data]);
        // SAFETY: arrays are as long as they say.
        let status = checked(unsafe { fmc_context_add_obstacle(context, unless(hole, 2, data.ptr()), place, index) });
        assert!(status == OK || obstacle == 77, "an error writes outputs");
    }

    pub(super) fn remove(&mut self, obstacle: usize, hole: Hole) {
        let (mut shape, mut place) = (77, fmc_pose { position: [0.5; 3], rotation: [0.5; 9], scale: 0.5 });
        let untouched = place;
        // SAFETY: the host's own context, and outputs that may be written.
        unsafe {
            let context = self.context;
            let mut find = || {
                let (shape, place) = (unless(hole, 0, &raw mut shape), unless(hole, 1, &raw mut place));
                checked(fmc_context_obstacle_shape(context, obstacle, shape, place))
            };
            let before = find();
            assert_eq!(checked(fmc_context_remove_obstacle(context, obstacle)), before);
            assert_eq!(find(), if before == OK { FMC_ERROR_OBSTACLE_REMOVED } else { before });
            assert!(if before != OK || hole == 1 { shape == 77 } else { (0..=10).contains(&shape) });
            assert!(if before != OK || hole == 2 { place == untouched } else { place.scale > 0.0 });
        }
    }
}
