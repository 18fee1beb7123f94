//! The contact at the nodes: where a host wants it, and as plain lists.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::Output;
use crate::contact::{NodalContact, NodeStatus};

/// Whether a node is in contact.
#[repr(C)]
pub enum fmc_node_status {
    /// No facet at the node is in contact.
    FMC_NODE_APART = 0,
    /// A facet at the node is in contact, without friction.
    FMC_NODE_TOUCHING = 1,
    /// More of the contact at the node sticks than slides, by area.
    FMC_NODE_STICKING = 2,
    /// At least half of it slides.
    FMC_NODE_SLIDING = 3,
}

/// Where `fmc_context_nodal_contact` writes the contact at the nodes: arrays of the host, each NULL if not requested. With n nodes
/// of the mesh `normal` and `friction` have room for n times `dim` numbers, in dense rows, all others for n.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_nodal_contact {
    /// Set by `fmc_nodal_contact_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Contact pressure: the nodal force by the area on which it acts, |F| / int N dA.
    pub pressure: *mut f64,
    /// Minus the penetration, the mean over the same part, and never positive: distances of separated surfaces are not
    /// measured.
    pub gap: *mut f64,
    /// Area (2D: length) on which it acts: int N dA over the part of the facets at the node that is in contact, N being the node's
    /// shape function. Never more than the node's part of the surface. Larger where `pressure` would be more than twice
    /// `local_pressure` and more than the mean pressure of the pair, as at nodes that only the other side presses.
    pub area: *mut f64,
    /// Unit vector outwards of the node's body.
    pub normal: *mut f64,
    /// Traction of friction on the node's body, the mean over the same part.
    pub friction: *mut f64,
    /// The part of the contact at the node that slides, of its area, between 0 and 1.
    pub sliding: *mut f64,
    /// Values of `fmc_node_status`.
    pub status: *mut i32,
    /// The mean of the law's pressure over the same part, weighted with the node's shape function, int N p dA / int N dA; with the law
    /// "volume" the pressure of the pair. On curved surfaces it scatters more than `pressure`.
    pub local_pressure: *mut f64,
    /// Zero. Room for outputs of later versions.
    pub reserved: [u64; 8],
}

impl Default for fmc_nodal_contact {
    fn default() -> Self {
        let none = std::ptr::null_mut();
        Self {
            struct_size: size_of::<Self>(),
            pressure: none,
            gap: none,
            area: none,
            normal: none,
            friction: none,
            sliding: none,
            status: std::ptr::null_mut(),
            local_pressure: none,
            reserved: [0; 8],
        }
    }
}

impl fmc_nodal_contact {
    /// Whether it was initialised, and its pointers are those of arrays.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        check_struct::<Self>("fmc_nodal_contact", self.struct_size, self.reserved)?;
        let numbers = [("pressure", self.pressure), ("gap", self.gap), ("area", self.area), ("normal", self.normal)];
        let others = [("friction", self.friction), ("sliding", self.sliding), ("local_pressure", self.local_pressure)];
        for (name, output) in numbers.into_iter().chain(others) {
            Output::optional(name, output)?;
        }
        Output::optional("status", self.status).map(|_| ())
    }

    /// Writes what is asked for.
    ///
    /// # Safety
    /// The host guarantees that its arrays, where given, have room for the lists.
    pub(crate) unsafe fn write(&self, lists: &NodalLists) {
        // SAFETY: passed on to the caller.
        unsafe {
            copy(&lists.pressure, self.pressure);
            copy(&lists.local_pressure, self.local_pressure);
            copy(&lists.gap, self.gap);
            copy(&lists.area, self.area);
            copy(&lists.normal, self.normal);
            copy(&lists.friction, self.friction);
            copy(&lists.sliding, self.sliding);
            copy(&lists.status, self.status);
        }
    }
}

/// Writes a list, unless the host declined it.
///
/// # Safety
/// The host guarantees that `output`, if it is not NULL, has room for the list.
unsafe fn copy<T: Copy>(list: &[T], output: *mut T) {
    if !output.is_null() {
        // SAFETY: passed on to the caller; the list is our own and cannot overlap it.
        unsafe { std::ptr::copy_nonoverlapping(list.as_ptr(), output, list.len()) };
    }
}

/// The contact at the nodes, with its dimension hidden: one list per quantity.
pub(crate) struct NodalLists {
    pub(crate) pressure: Vec<f64>,
    pub(crate) local_pressure: Vec<f64>,
    pub(crate) gap: Vec<f64>,
    pub(crate) area: Vec<f64>,
    pub(crate) normal: Vec<f64>,
    pub(crate) friction: Vec<f64>,
    pub(crate) sliding: Vec<f64>,
    pub(crate) status: Vec<i32>,
}

impl<const D: usize> From<NodalContact<D>> for NodalLists {
    fn from(field: NodalContact<D>) -> Self {
        let status = |status: &NodeStatus| match status {
            NodeStatus::Apart => fmc_node_status::FMC_NODE_APART as i32,
            NodeStatus::Touching => fmc_node_status::FMC_NODE_TOUCHING as i32,
            NodeStatus::Sticking => fmc_node_status::FMC_NODE_STICKING as i32,
            NodeStatus::Sliding => fmc_node_status::FMC_NODE_SLIDING as i32,
        };
        Self {
            normal: field.normal.as_flattened().to_vec(),
            friction: field.friction.as_flattened().to_vec(),
            sliding: field.sliding,
            status: field.status.iter().map(status).collect(),
            pressure: field.pressure,
            local_pressure: field.local_pressure,
            gap: field.gap,
            area: field.area,
        }
    }
}
