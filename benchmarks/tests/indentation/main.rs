//! Indentation by rigid wedges, cones and punches: their equilibria, and the fibers through their contact.

mod fibers;
mod indentation;
mod second_order;
