//! Bodies of second order.

use super::{case, figure, solved};

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
