//! The ground: statuses, the text of an error, pointers that become slices, and the panic boundary in which every entry runs.

pub(super) mod dimension;
pub(super) mod entry;
pub(super) mod failure;
pub(super) mod given_struct;
pub(super) mod index;
pub(super) mod last_error;
pub(super) mod list;
pub(super) mod pointer;
pub(super) mod status;
pub(super) mod status_class;
