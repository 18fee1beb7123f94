//! How far apart straight facets may be where the curved faces for which they stand touch.

use super::parts::Contact;

/// No less than that distance; 0 where no law measures curved faces, or none are.
pub(crate) fn layer<const D: usize>(contact: &Contact<D>) -> f64 {
    let Contact { mesh, partners, method, .. } = contact;
    if !mesh.may_be_curved() || !partners.energy_laws(method.options()).any(|law| law.needs_depth()) {
        return 0.0;
    }
    let height = match &mesh.surface.submesh {
        Some(submesh) => submesh.most_curved.iter().fold(0.0, |most: f64, body| body.height.max(most)),
        None => {
            let sharing = contact.work.within_pair(false);
            let field = mesh.depth_field(method.weighting(), &|| sharing.check());
            field.and_then(|field| field.curves()).map_or(0.0, |curves| curves.largest_height())
        }
    };
    // Of both bodies.
    2.0 * height
}
