//! The contact at the nodes as plain lists.

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

/// The contact at the nodes, with its dimension hidden: one list per quantity.
pub(crate) struct NodalLists {
    pub(crate) pressure: Vec<f64>,
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
            gap: field.gap,
            area: field.area,
        }
    }
}
