//! How far a step of a host's own may go.

use super::bodies::{Block, Host};

/// However long a step is, and however far all else: what is in reach of the whole of it is not looked at.
#[test]
fn no_body_moves_by_more_than_half_its_thickness() {
    let host = Host::new(&[Block::unit(0.0, 100.0, 3)]);
    let contact = host.contact(Some(0.0), 0.0);
    for length in [1.0, 10.0, 1e4, 1e100] {
        let found = contact.step_limit(&host.coords, &vec![[0.0, -length]; host.coords.len()]).unwrap();
        assert!((found.part * length / 0.25 - 1.0).abs() < 1e-9, "{length}: {found:?}");
        assert_eq!(found.first_touch, f64::INFINITY);
    }
}
