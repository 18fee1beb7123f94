//! Bodies of second order.

use crate::indentation::{case, figure, solved};

#[test]
fn blocks_of_second_order_pass_the_patch_test() {
    for variant in ["tri6", "quad9", "tri6-quad9", "tri6-quad4"] {
        let error = figure(&solved::<2>(&case("patch2d", Some(variant), &[])), "stress_error_max");
        assert!(error < 1e-9, "{variant}: {error:e}");
    }
    for variant in ["tet10", "hex20"] {
        let error = figure(&solved::<3>(&case("patch3d", Some(variant), &[])), "stress_error_max");
        assert!(error < 1e-9, "{variant}: {error:e}");
    }
}

/// Facets of a/8: the force is carried exactly, and the pressure is Hertz' within what a half-disc differs from a half-space, 0.18 %, and
/// what alternates between corners and middles inwards from the rim.
#[test]
fn discs_of_second_order_meet_hertz() {
    for variant in ["tri6", "quad9", "depth-tri6"] {
        let at = solved::<2>(&case("hertz", Some(variant), &[]));
        let [force, peak, width, error, inner] =
            ["force", "peak_pressure", "half_width", "profile_error", "profile_error_inner"]
                .map(|name| figure(&at, name));
        assert!((force / 10.0 - 1.0).abs() < 1e-8, "{variant}: {force}");
        assert!(
            (peak / 9.3506 - 1.0).abs() < 3e-3 && (width / 0.68083 - 1.0).abs() < 3e-3,
            "{variant}: {peak} {width}"
        );
        assert!(error < 1e-2 && inner < 4e-3, "{variant}: {error} {inner}");
    }
}
