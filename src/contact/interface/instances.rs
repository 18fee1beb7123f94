//! Instances, for the plane and for space, of the functions that the C interface does not call. Other crates use them, and need not compile
//! the library below these functions again.

use crate::contact::evaluation::Contact;

#[used]
static IN_THE_PLANE: fn(&Contact<2>) = instances;
#[used]
static IN_SPACE: fn(&Contact<3>) = instances;

fn instances<const D: usize>(contact: &Contact<D>) {
    drop(contact.overlaps(&[]));
    drop(contact.trace(&[]));
    drop(contact.nodal_penetration(&[], 1.0));
}
