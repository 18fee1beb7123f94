//! The cases that are part of the program.

/// Name and text of every case in `cases/`.
pub const CASES: [(&str, &str); 5] = [
    ("bar", include_str!("../../../../cases/bar.toml")),
    ("bar3d", include_str!("../../../../cases/bar3d.toml")),
    ("blocks3d", include_str!("../../../../cases/blocks3d.toml")),
    ("diamond", include_str!("../../../../cases/diamond.toml")),
    ("star", include_str!("../../../../cases/star.toml")),
];
