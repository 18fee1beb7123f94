//! Named parts of the surface: what hosts call.

use crate::Error;
use crate::contact::evaluation::Contact;

impl<const D: usize> Contact<D> {
    /// Names a part of the surface by its boundary facets, as they are counted by [`Self::boundary_facets`], in any order, and returns its
    /// number: 1, 2, … It may have facets of several bodies. It stays what it is on other reference coordinates.
    ///
    /// # Errors
    /// [`Error::NoSuchNumber`], naming the entry of a facet that does not exist; [`Error::Unsupported`] without facets, and for a mesh in
    /// parts. Nothing changes then.
    #[inline(never)]
    pub fn add_surface(&mut self, facets: &[usize]) -> Result<usize, Error> {
        self.mesh.add_surface(facets)
    }
}
