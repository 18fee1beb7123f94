//! Arrays of the host: nodes by axes, with strides, so that rows, padded rows and columns go in without a copy.

use crate::Error;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::check;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BUFFER_TOO_SMALL, FMC_ERROR_LENGTH, FMC_ERROR_STRIDE};

/// Coordinates of nodes, read during the call and not kept: component `axis` of node `node` is
/// `data[node * node_stride + axis * axis_stride]`, for `node < node_count` and `axis < dim`.
///
/// | the host's array | node_stride | axis_stride |
/// | --- | --- | --- |
/// | (n, dim), rows | dim, or both strides 0 | 1 |
/// | (n, 3), rows, in 2D | 3 | 1 |
/// | (dim, n), rows; (n, dim) by columns | 1 | n |
///
/// Strides count doubles and may be negative. `{coords, n, 0, 0}`, or `{coords, n}` in C, are dense rows.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_coords {
    /// First component of the first node.
    pub data: *const f64,
    /// Number of nodes; if 0, `data` may be NULL.
    pub node_count: usize,
    /// From one node to the next.
    pub node_stride: isize,
    /// From one axis to the next.
    pub axis_stride: isize,
}

/// Array that receives nodal forces; laid out as `fmc_coords`. Padding between the entries is not written.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_forces {
    /// First component of the first node.
    pub data: *mut f64,
    /// Number of nodes that fit into it, at least as many as the mesh has; if 0, `data` may be NULL.
    pub node_count: usize,
    /// From one node to the next.
    pub node_stride: isize,
    /// From one axis to the next.
    pub axis_stride: isize,
}

/// Number of doubles between nodes and between axes.
#[derive(Clone, Copy, PartialEq)]
struct Strides {
    node: isize,
    axis: isize,
}

impl Strides {
    /// The strides of a view of `node_count` nodes; both zero mean dense rows. Every offset can be addressed.
    fn new<const D: usize>(name: &str, node_count: usize, node: isize, axis: isize) -> Result<Self, Failure> {
        let strides = if node == 0 && axis == 0 { Self { node: D as isize, axis: 1 } } else { Self { node, axis } };
        let extent = node_count
            .saturating_sub(1)
            .checked_mul(strides.node.unsigned_abs())
            .and_then(|along| along.checked_add((D - 1).checked_mul(strides.axis.unsigned_abs())?))
            .filter(|extent| *extent < isize::MAX as usize / size_of::<f64>());
        match extent {
            Some(_) => Ok(strides),
            None => Err(Failure::new(
                FMC_ERROR_STRIDE,
                format!("'{name}' spans more than memory: {node_count} nodes, strides {node} and {axis}"),
            )),
        }
    }

    fn is_dense<const D: usize>(self) -> bool {
        self == Self { node: D as isize, axis: 1 }
    }

    /// Whether no two entries share memory: the nodes do not interleave with the axes.
    fn is_injective<const D: usize>(self, node_count: usize) -> bool {
        let (node, axis) = (self.node.unsigned_abs(), self.axis.unsigned_abs());
        axis > 0 && (node_count < 2 || (node > 0 && (node > (D - 1) * axis || axis > (node_count - 1) * node)))
    }

    fn offset(self, node: usize, axis: usize) -> isize {
        node as isize * self.node + axis as isize * self.axis
    }
}

impl fmc_coords {
    /// The coordinates as rows: the host's own where they are dense, else gathered into `scratch`.
    ///
    /// # Safety
    /// The host guarantees every entry of the view, unchanged for `'a`.
    pub(crate) unsafe fn rows<'a, const D: usize>(
        &self,
        name: &str,
        scratch: &'a mut Vec<[f64; D]>,
    ) -> Result<&'a [[f64; D]], Failure> {
        if self.node_count == 0 {
            return Ok(&[]);
        }
        check(name, self.data)?;
        let strides = Strides::new::<D>(name, self.node_count, self.node_stride, self.axis_stride)?;
        if strides.is_dense::<D>() {
            // SAFETY: aligned, of addressable size; the caller guarantees `node_count` rows of D doubles.
            return Ok(unsafe { std::slice::from_raw_parts(self.data.cast(), self.node_count) });
        }
        scratch.clear();
        let bytes = self.node_count.saturating_mul(size_of::<[f64; D]>());
        scratch.try_reserve(self.node_count).map_err(|_| Error::Memory { what: "coordinates", bytes })?;
        scratch.extend((0..self.node_count).map(|node| {
            // SAFETY: the offset is addressable, and the caller guarantees every entry of the view.
            std::array::from_fn(|axis| unsafe { self.data.offset(strides.offset(node, axis)).read() })
        }));
        Ok(scratch)
    }
}

/// A view of forces that has been checked for so many nodes.
pub(crate) struct Output {
    data: *mut f64,
    strides: Strides,
}

impl fmc_forces {
    /// Checks that `node_count` rows can be written.
    pub(crate) fn output<const D: usize>(&self, node_count: usize) -> Result<Output, Failure> {
        if self.node_count < node_count {
            let text = format!("'forces' has room for {} nodes, the mesh has {node_count}", self.node_count);
            return Err(Failure::new(FMC_ERROR_BUFFER_TOO_SMALL, text));
        }
        if node_count > 0 {
            check("forces", self.data)?;
        }
        let strides = Strides::new::<D>("forces", node_count, self.node_stride, self.axis_stride)?;
        if !strides.is_injective::<D>(node_count) {
            let text = format!("entries of 'forces' overlap: strides {} and {}", self.node_stride, self.axis_stride);
            return Err(Failure::new(FMC_ERROR_STRIDE, text));
        }
        Ok(Output { data: self.data, strides })
    }
}

impl Output {
    /// Writes the rows, or adds them to what is there. There are as many as were checked for.
    ///
    /// # Safety
    /// The host guarantees that every entry of the view may be written, and read where `add`.
    pub(crate) unsafe fn write<const D: usize>(&self, rows: &[[f64; D]], add: bool) {
        for (node, row) in rows.iter().enumerate() {
            for axis in 0..D {
                // SAFETY: the offset is addressable as checked; the caller guarantees every entry of the view.
                unsafe {
                    let entry = self.data.offset(self.strides.offset(node, axis));
                    entry.write(if add { entry.read() + row[axis] } else { row[axis] });
                }
            }
        }
    }
}

/// Coordinates must be those of all nodes of the mesh.
pub(crate) fn check_node_count(found: usize, expected: usize) -> Result<(), Failure> {
    if found == expected {
        return Ok(());
    }
    Err(Failure::new(FMC_ERROR_LENGTH, format!("'coords' has {found} nodes, the mesh has {expected}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same two nodes laid out in four ways: (data, start, node stride, axis stride).
    const LAYOUTS: [(&[f64], usize, isize, isize); 5] = [
        (&[1.0, 2.0, 3.0, 4.0], 0, 0, 0),
        (&[1.0, 2.0, 3.0, 4.0], 0, 2, 1),
        (&[1.0, 2.0, 9.0, 3.0, 4.0, 9.0], 0, 3, 1),
        (&[1.0, 3.0, 2.0, 4.0], 0, 1, 2),
        (&[3.0, 4.0, 1.0, 2.0], 2, -2, 1),
    ];

    #[test]
    fn every_layout_gives_the_same_rows() {
        for (data, start, node_stride, axis_stride) in LAYOUTS {
            let first = data.as_ptr().wrapping_add(start);
            let view = fmc_coords { data: first, node_count: 2, node_stride, axis_stride };
            let mut scratch = Vec::new();
            // SAFETY: every layout lies within its array.
            assert_eq!(unsafe { view.rows::<2>("coords", &mut scratch) }.unwrap(), &[[1.0, 2.0], [3.0, 4.0]]);
        }
    }

    #[test]
    fn forces_go_back_by_the_same_strides() {
        for (layout, start, node_stride, axis_stride) in LAYOUTS {
            let mut data: Vec<f64> = layout.iter().map(|x| if *x == 9.0 { 9.0 } else { 10.0 }).collect();
            let first = data.as_mut_ptr().wrapping_add(start);
            let output = fmc_forces { data: first, node_count: 2, node_stride, axis_stride }.output::<2>(2).unwrap();
            // SAFETY: every layout lies within its array.
            unsafe { output.write(&[[1.0, 2.0], [3.0, 4.0]], false) };
            assert_eq!(data, layout);
            // SAFETY: as above.
            unsafe { output.write(&[[1.0, 2.0], [3.0, 4.0]], true) };
            let doubled: Vec<f64> = layout.iter().map(|x| if *x == 9.0 { 9.0 } else { 2.0 * x }).collect();
            assert_eq!(data, doubled);
        }
    }

    #[test]
    fn outputs_that_overlap_are_refused() {
        let mut data = [0.0; 8];
        let data = data.as_mut_ptr();
        let refused = |node_count, node_stride, axis_stride| {
            let view = fmc_forces { data, node_count: 3, node_stride, axis_stride };
            view.output::<2>(node_count).err().map(|failure| failure.status)
        };
        for (node, axis) in [(1, 1), (0, 1), (1, 0), (1, 2), (-1, 1), (isize::MAX, 1)] {
            assert_eq!(refused(3, node, axis), Some(FMC_ERROR_STRIDE), "{node} {axis}");
        }
        for (node, axis) in [(0, 0), (2, 1), (1, 3), (-2, 1), (2, -1)] {
            assert_eq!(refused(3, node, axis), None, "{node} {axis}");
        }
        assert_eq!(refused(4, 2, 1), Some(FMC_ERROR_BUFFER_TOO_SMALL));
    }
}
