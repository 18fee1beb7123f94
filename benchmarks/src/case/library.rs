//! The cases that are part of the program.

/// Name and text of every case in `benchmarks/cases/`.
pub const CASES: [(&str, &str); 18] = [
    ("bar", include_str!("../../cases/bar.toml")),
    ("bar3d", include_str!("../../cases/bar3d.toml")),
    ("blocks3d", include_str!("../../cases/blocks3d.toml")),
    ("cattaneo", include_str!("../../cases/cattaneo.toml")),
    ("cgs4", include_str!("../../cases/cgs4.toml")),
    ("cone", include_str!("../../cases/cone.toml")),
    ("corner", include_str!("../../cases/corner.toml")),
    ("diamond", include_str!("../../cases/diamond.toml")),
    ("hertz", include_str!("../../cases/hertz.toml")),
    ("hertz3d", include_str!("../../cases/hertz3d.toml")),
    ("ironing", include_str!("../../cases/ironing.toml")),
    ("patch2d", include_str!("../../cases/patch2d.toml")),
    ("patch3d", include_str!("../../cases/patch3d.toml")),
    ("punch", include_str!("../../cases/punch.toml")),
    ("snap", include_str!("../../cases/snap.toml")),
    ("star", include_str!("../../cases/star.toml")),
    ("stop", include_str!("../../cases/stop.toml")),
    ("wedge", include_str!("../../cases/wedge.toml")),
];
