//! Shapes of obstacles, as data.

use super::mesh::{Numbering, rows};
use super::pose::fmc_pose;
use super::signed_distance::{Callback, fmc_signed_distance};
use super::view::fmc_coords;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::{Output, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BAD_VALUE, FMC_ERROR_NULL_POINTER, FMC_ERROR_UNSUPPORTED};
use crate::{HeightField, Measures, Obstacle, Shape, ShapeKind, SignedDistance};
use std::ffi::c_void;
use std::ptr::{null, null_mut};
use std::sync::Arc;

/// How deep compounds may lie in one another: a part that leads back to its compound must end somewhere.
const NESTED: usize = 8;

/// A rigid shape in its own frame, as data. `fmc_shape_init` sets all fields; then set the fields that `fmc_shape_kind`
/// lists for its kind. Other fields are not read.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_shape {
    /// Set by `fmc_shape_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// A value of `fmc_shape_kind`.
    pub kind: i32,
    /// Bytes of a number in `facets`: 4, the default, or 8.
    pub index_size: i32,
    /// Radius.
    pub radius: f64,
    /// Half of the height.
    pub half_height: f64,
    /// Halves of the sides, of which the first `dim` are read.
    pub half_extents: [f64; 3],
    /// Points, or corners.
    pub points: fmc_coords,
    /// Numbers of corners, (facet_count, dim), of `index_size` bytes each, counted from the option `index_base`.
    pub facets: *const c_void,
    /// Number of facets.
    pub facet_count: usize,
    /// Heights along the last axis, over a grid across it that is centred on the origin. The index along the grid's last
    /// axis runs fastest. In 3D every cell is split along the diagonal from its corner of least x and y.
    pub heights: *const f64,
    /// Numbers of points of the grid along its `dim` - 1 axes, at least 2 each; their product is the number of heights.
    pub counts: [usize; 2],
    /// Lengths of the grid along its `dim` - 1 axes.
    pub lengths: [f64; 2],
    /// How far below the lowest height the flat bottom of the solid lies; its walls are vertical.
    pub thickness: f64,
    /// `fmc_part`s of a compound, of any kind, which may overlap. Its signed distance is the least signed distance of its
    /// parts: exact outside, and inside a single part; where parts overlap, the depth of a point is its largest depth in any
    /// part.
    pub parts: *const c_void,
    /// Number of parts.
    pub part_count: usize,
    /// Signed distance of a body. It and `user` must outlive the context, or the obstacle if it is removed before.
    pub signed_distance: fmc_signed_distance,
    /// Passed to `signed_distance`.
    pub user: *mut c_void,
    /// Zero. Room for measures of later versions.
    pub reserved: [u64; 8],
}

/// A part of a compound.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_part {
    /// Its shape.
    pub shape: *const fmc_shape,
    /// Its pose in the frame of the compound.
    pub pose: fmc_pose,
}

/// Sets a shape to a kind, a value of `fmc_shape_kind`, with sizes and counts 0 and pointers NULL.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` for another number. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_shape_init(shape: *mut fmc_shape, kind: i32) -> fmc_status {
    entry(|| {
        let output = Output::required("shape", shape)?;
        kind_of(kind)?;
        let empty = fmc_shape {
            struct_size: size_of::<fmc_shape>(),
            kind,
            index_size: 4,
            radius: 0.0,
            half_height: 0.0,
            half_extents: [0.0; 3],
            points: fmc_coords { data: null(), node_count: 0, node_stride: 0, axis_stride: 0 },
            facets: null(),
            facet_count: 0,
            heights: null(),
            counts: [0; 2],
            lengths: [0.0; 2],
            thickness: 0.0,
            parts: null(),
            part_count: 0,
            signed_distance: None,
            user: null_mut(),
            reserved: [0; 8],
        };
        // SAFETY: the host passes a shape that may be written.
        unsafe { output.write(empty) };
        Ok(())
    })
}

fn kind_of(number: i32) -> Result<ShapeKind, Failure> {
    let kind = usize::try_from(number).ok().and_then(|number| ShapeKind::ALL.get(number));
    kind.copied().ok_or_else(|| Failure::new(FMC_ERROR_BAD_VALUE, format!("{number} is not a value of fmc_shape_kind")))
}

impl fmc_shape {
    /// The shape in D dimensions.
    ///
    /// # Safety
    /// The host guarantees the arrays that its kind has, and the parts with theirs.
    pub(crate) unsafe fn read_shape<const D: usize>(&self, index_base: i32) -> Result<Shape<D>, Failure> {
        // The fields of the host are read through this alone, which is made here.
        Fields { shape: self, index_base, nested: 0 }.read_shape()
    }
}

/// The fields of a shape whose arrays the host guarantees, to be read as the kind of the shape asks for them.
struct Fields<'a> {
    shape: &'a fmc_shape,
    index_base: i32,
    /// In how many compounds it lies.
    nested: usize,
}

impl Fields<'_> {
    fn read_shape<const D: usize>(mut self) -> Result<Shape<D>, Failure> {
        check_struct::<fmc_shape>("fmc_shape", self.shape.struct_size, self.shape.reserved)?;
        Shape::read(kind_of(self.shape.kind)?, &mut self)
    }
}

impl<const D: usize> Measures<D> for Fields<'_> {
    type Error = Failure;

    fn radius(&mut self) -> Result<f64, Failure> {
        Ok(self.shape.radius)
    }

    fn half_height(&mut self) -> Result<f64, Failure> {
        Ok(self.shape.half_height)
    }

    fn half_extents(&mut self) -> Result<[f64; D], Failure> {
        Ok(std::array::from_fn(|axis| self.shape.half_extents[axis]))
    }

    fn points(&mut self) -> Result<Vec<[f64; D]>, Failure> {
        // SAFETY: the host guarantees the points, as `fmc_shape::read_shape` asks for.
        Ok(unsafe { self.shape.points.rows("points", &mut Vec::new())?.to_vec() })
    }

    fn facets(&mut self) -> Result<Vec<[u32; D]>, Failure> {
        let &fmc_shape { facets, facet_count, index_size, ref points, .. } = self.shape;
        let numbering = Numbering { index_base: self.index_base, node_count: points.node_count };
        // SAFETY: the host guarantees the facets, as `fmc_shape::read_shape` asks for.
        let facets = unsafe {
            match index_size {
                4 => numbering.zero_based(slice("facets", facets.cast::<i32>(), facet_count, D)?, D, 0)?,
                8 => numbering.zero_based(slice("facets", facets.cast::<i64>(), facet_count, D)?, D, 0)?,
                _ => {
                    let text = format!("'index_size' is {index_size}, neither 4 nor 8");
                    return Err(Failure::new(FMC_ERROR_BAD_VALUE, text));
                }
            }
        };
        Ok(rows(&facets))
    }

    fn height_field(&mut self) -> Result<HeightField, Failure> {
        let counts = self.shape.counts[..D - 1].to_vec();
        let count = counts.iter().try_fold(1usize, |all, &count| all.checked_mul(count)).unwrap_or(usize::MAX);
        // SAFETY: the host guarantees the heights, as `fmc_shape::read_shape` asks for.
        let heights = unsafe { slice("heights", self.shape.heights, count, 1) }?.to_vec();
        let lengths = self.shape.lengths[..D - 1].to_vec();
        Ok(HeightField { counts, lengths, heights, thickness: self.shape.thickness })
    }

    fn parts(&mut self) -> Result<Vec<Obstacle<D>>, Failure> {
        if self.nested == NESTED {
            let text = format!("compounds lie in one another more than {NESTED} deep");
            return Err(Failure::new(FMC_ERROR_UNSUPPORTED, text));
        }
        // SAFETY: the host guarantees the parts, as `fmc_shape::read_shape` asks for.
        let parts = unsafe { slice("parts", self.shape.parts.cast::<fmc_part>(), self.shape.part_count, 1) }?;
        let part = |part: &fmc_part| {
            // SAFETY: and their shapes.
            let shape = unsafe { reference("shape", part.shape) }?;
            let fields = Fields { shape, index_base: self.index_base, nested: self.nested + 1 };
            Ok(Obstacle { shape: fields.read_shape()?, pose: part.pose.to_pose() })
        };
        parts.iter().map(part).collect()
    }

    fn signed_distance(&mut self) -> Result<Arc<dyn SignedDistance<D>>, Failure> {
        let null = || Failure::new(FMC_ERROR_NULL_POINTER, "'signed_distance' is NULL");
        let function = self.shape.signed_distance.ok_or_else(null)?;
        Ok(Arc::new(Callback { function, user: self.shape.user }))
    }
}
