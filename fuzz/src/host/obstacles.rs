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

impl Host {
    pub(super) fn add(&mut self, shape: &Shape, place: Option<fmc_pose>, hole: Hole) {
        let (context, mut obstacle) = (self.context, 77usize);
        let place = place.as_ref().map_or(null(), |place| &raw const *place);
        let index = unless(hole, 0, &raw mut obstacle);
        let base = i64::from(self.options.index_base);
        // SAFETY: `dim` entries of three are read; arrays are as long as they say.
        let status = checked(unsafe {
            match shape {
                Shape::HalfSpace => fmc_context_add_half_space(context, place, index),
                Shape::Ball(radius) => fmc_context_add_ball(context, radius.0, place, index),
                Shape::Cuboid(half) => {
                    let half = Guarded::new(&half.map(|x| x.0)[..self.mesh.dim]);
                    fmc_context_add_cuboid(context, unless(hole, 1, half.ptr()), place, index)
                }
                Shape::Cylinder(radius, half) => fmc_context_add_cylinder(context, radius.0, half.0, place, index),
                Shape::Cone(radius, half) => fmc_context_add_cone(context, radius.0, half.0, place, index),
                Shape::Capsule(radius, half) => fmc_context_add_capsule(context, radius.0, half.0, place, index),
                Shape::Polytope { corners, facets, is_wide } => {
                    let dim = self.mesh.dim;
                    let points: Vec<f64> =
                        corners.iter().take(dim + 1).flat_map(|x| x[..dim].iter().map(|x| x.0)).collect();
                    let points = Array::new(&points, dim, Layout::Rows);
                    let simplex: &[i64] =
                        if dim == 2 { &[0, 1, 1, 2, 2, 0] } else { &[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3] };
                    let facets: Vec<i64> = match facets.len() {
                        0..3 => simplex.iter().map(|node| node + base).collect(),
                        _ => facets.iter().map(|f| i64::from(f % 8) - 1).collect(),
                    };
                    let count = facets.len() / dim;
                    if *is_wide {
                        let facets = Guarded::new(&facets[..count * dim]);
                        fmc_context_add_polytope_i64(context, &points.view, facets.ptr(), count, place, index)
                    } else {
                        let facets: Vec<i32> = facets[..count * dim].iter().map(|&f| f as i32).collect();
                        let facets = Guarded::new(&facets);
                        fmc_context_add_polytope(context, &points.view, facets.ptr(), count, place, index)
                    }
                }
                Shape::ConvexHull(points) => {
                    let dim = self.mesh.dim;
                    let points: Vec<f64> = points.iter().take(12).flat_map(|x| x[..dim].iter().map(|x| x.0)).collect();
                    let points = Array::new(&points, dim, Layout::Rows);
                    fmc_context_add_convex_hull(context, &points.view, place, index)
                }
                Shape::HeightField { count, heights, thickness } => {
                    let counts = Guarded::new(&[usize::from(count % 5), 2][..self.mesh.dim - 1]);
                    let lengths = Guarded::new(&[2.0, 1.0][..self.mesh.dim - 1]);
                    let heights = heights.map(|x| x.0);
                    let heights = Guarded::new(&heights[..counts.values().iter().product()]);
                    let (counts, lengths) = (unless(hole, 1, counts.ptr()), lengths.ptr());
                    fmc_context_add_height_field(context, counts, lengths, heights.ptr(), thickness.0, place, index)
                }
                Shape::Compound(parts) => {
                    let part = |(shape, size): &(u8, Number)| {
                        let mut part = std::mem::MaybeUninit::<fmc_part>::zeroed();
                        assert_eq!(fmc_part_init(part.as_mut_ptr()), OK);
                        let mut part = part.assume_init();
                        part.shape = i32::from(shape % 9);
                        (part.radius, part.half_height, part.half_extents) = (size.0, 0.5, [size.0; 3]);
                        part
                    };
                    let parts = Guarded::new(&parts.iter().take(4).map(part).collect::<Vec<_>>());
                    fmc_context_add_compound(context, parts.ptr(), parts.values().len(), place, index)
                }
                Shape::SignedDistance { radius, fault } => {
                    let radius = if radius.0.is_finite() { radius.0.abs().min(2.0) } else { 1.0 };
                    let own = Box::new(Distance { dim: self.mesh.dim, radius, fault: *fault, context });
                    let user = (&raw const *own).cast_mut().cast();
                    self.distances.push(own);
                    fmc_context_add_signed_distance(context, Some(distance), user, place, index)
                }
            }
        });
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
