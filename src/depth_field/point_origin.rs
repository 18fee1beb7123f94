//! Where a point of a cell comes from, so that it can be told how it moves as the reference coordinates do.

/// Where the place of a point in its cell comes from, and its depth.
#[derive(Clone, Copy, Debug)]
pub(super) enum PointOrigin {
    /// A fixed place on the surface.
    Surface,
    /// A fixed place whose depth is that of the nodes, interpolated.
    Nodes,
    /// A fixed place whose depth is the distance from the surface, of which this facet is nearest.
    Distance { facet: u32 },
    /// The centre of the ball inscribed in the simplex with these corners. Its depth is the radius of the ball, or the distance from
    /// the surface, of which this facet is nearest.
    Centre { corners: [u8; 4], facet: Option<u32> },
    /// The crest of the simplex with these corners, whose faces opposite to the corners `facets`, named by bits, are facets. Its depth is
    /// the distance from the surface, of which this facet is nearest.
    Crest { corners: [u8; 4], facets: u8, facet: u32 },
}
