//! Points of interfaces that follow a law of the host, as plain structs.

use crate::contact::LawPoint;

/// A point of an interface that follows a law of the host.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_law_point {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// The bodies, indices for `fmc_context_body_resultant`, the lower one first.
    pub body: usize,
    /// See `body`.
    pub partner: usize,
    /// Where it is, on `body`; in 2D the last is 0.
    pub position: [f64; 3],
    /// Its tributary area, without deformation.
    pub area: f64,
    /// Normal of `partner` and axes in its plane, as in `fmc_law_points`, three numbers each; in 2D the third axis is z.
    pub axes: [f64; 9],
    /// Opening beyond the initial gap, and sliding, along these axes; in 2D the last is 0.
    pub jump: [f64; 3],
    /// Traction along these axes, force per area: positive along the normal in tension; in 2D the last is 0.
    pub traction: [f64; 3],
    /// Energy per area that unloading would give back, as the law returns it.
    pub stored: f64,
    /// The same that has been dissipated.
    pub dissipated: f64,
    /// Zero.
    pub reserved: [u64; 4],
}

impl<const D: usize> From<&LawPoint<D>> for fmc_law_point {
    fn from(one: &LawPoint<D>) -> Self {
        let in_space = |x: &[f64; D]| std::array::from_fn(|axis| if axis < D { x[axis] } else { 0.0 });
        let axis = |place: usize| match (place / 3, place % 3) {
            (row, column) if row < D && column < D => one.axes[row][column],
            (row, column) => f64::from(row == column),
        };
        Self {
            struct_size: size_of::<Self>(),
            body: one.bodies[0],
            partner: one.bodies[1],
            position: in_space(&one.position),
            area: one.area,
            axes: std::array::from_fn(axis),
            jump: in_space(&one.jump),
            traction: in_space(&one.traction),
            stored: one.stored,
            dissipated: one.dissipated,
            reserved: [0; 4],
        }
    }
}
