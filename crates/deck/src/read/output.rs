//! Requests of output: what is written does not depend on them.

/// Keywords that ask for results.
pub(super) const REQUESTS: [&str; 19] = [
    "NODE PRINT",
    "NODE FILE",
    "EL PRINT",
    "EL FILE",
    "ELEMENT OUTPUT",
    "NODE OUTPUT",
    "CONTACT FILE",
    "CONTACT PRINT",
    "CONTACT OUTPUT",
    "ENERGY PRINT",
    "ENERGY FILE",
    "ENERGY OUTPUT",
    "OUTPUT",
    "PREPRINT",
    "MONITOR",
    "PRINT",
    "FILE FORMAT",
    "SECTION PRINT",
    "RESTART",
];
