//! Which own cells may be in contact.

use super::own_mesh::OwnMesh;
use crate::contact::Needed;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;

/// Where cells are looked for: at these own coordinates, within `margin` of what is needed.
pub(super) struct Search<'a, const D: usize> {
    pub(super) coords: &'a [[f64; D]],
    /// By body.
    pub(super) needed: &'a [Vec<Needed<D>>],
    pub(super) margin: f64,
}

/// Own cells that are found by any search, ascending.
pub(super) fn selected<const D: usize>(own: &OwnMesh<D>, searches: &[Search<D>]) -> Vec<u32> {
    let is_found = |cell: &u32| searches.iter().any(|search| search.finds(own, *cell as usize));
    (0..own.len() as u32).filter(is_found).collect()
}

impl<const D: usize> Search<'_, D> {
    fn finds(&self, own: &OwnMesh<D>, cell: usize) -> bool {
        let aabb = own.cell_box(cell, self.coords);
        let on_surface = own.surface_faces[cell] != 0;
        self.needed[own.body[cell] as usize].iter().any(|needed| {
            let within = needed.aabb.inflated(self.margin + needed.aabb.rounding());
            let seen = |apex: Vector<D>| aabb.union(&Aabb { min: apex, max: apex }).meets(&within);
            within.meets(&aabb) || on_surface && needed.apex.is_some_and(seen)
        })
    }
}
