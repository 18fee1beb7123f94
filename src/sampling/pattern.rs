//! How fibers are laid.

/// How fibers are laid in the region of contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum FiberPattern {
    /// D families of parallel lines at right angles, each a regular grid with a random shift. The default.
    #[default]
    Lines,
    /// Segments with uniform start and uniform direction (the paper's, appendix A), every crossing counted.
    ///
    /// The variance of the force is infinite: a facet is hit with a density proportional to |d·n| and then adds
    /// 1/|d·n|, and ∫ 1/|d·n| over all directions diverges. Offered for comparison.
    Isotropic {
        /// Length ℓ of a segment; `None`: the mean size of the facets in contact.
        length: Option<f64>,
    },
}
