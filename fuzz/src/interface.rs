//! `include/fmc_contact.h`, written down for Rust: the functions that the fuzz target calls, and their structs.
//!
//! A test holds the names against the header, both ways.
// The header documents them.
#![allow(missing_docs, non_camel_case_types)]

mod condensation;
mod contact_step;
mod evaluation;
mod fields;
mod friction;
mod mesh;
mod obstacles;
mod options;
mod ranks;
mod status;
mod tangent;

pub use condensation::*;
pub use contact_step::*;
pub use evaluation::*;
pub use fields::*;
pub use friction::*;
pub use mesh::*;
pub use obstacles::*;
pub use options::*;
pub use ranks::*;
pub use status::*;
pub use tangent::*;

/// The library with its C entry points, so that the linker takes it in.
pub use fmc_contact as library;

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    const OURS: &str = concat!(
        include_str!("interface/condensation.rs"),
        include_str!("interface/contact_step.rs"),
        include_str!("interface/evaluation.rs"),
        include_str!("interface/fields.rs"),
        include_str!("interface/friction.rs"),
        include_str!("interface/mesh.rs"),
        include_str!("interface/obstacles.rs"),
        include_str!("interface/options.rs"),
        include_str!("interface/ranks.rs"),
        include_str!("interface/status.rs"),
        include_str!("interface/tangent.rs")
    );

    /// Names before an opening bracket on lines that declare a function.
    fn functions<'a>(text: &'a str, declares: impl Fn(&str) -> bool) -> BTreeSet<&'a str> {
        let lines = text.lines().filter(|line| declares(line));
        let names = lines.filter_map(|line| {
            let head = &line[..line.find('(')?];
            Some(&head[head.rfind("fmc_")?..])
        });
        names.collect()
    }

    #[test]
    fn every_function_of_the_header_is_fuzzed() {
        let header = functions(include_str!("../../include/fmc_contact.h"), |line| {
            !line.starts_with(' ')
                && !line.starts_with("//")
                && line.contains(" fmc_") | line.contains("*fmc_")
                && !line.starts_with("typedef")
                && line.contains('(')
        });
        let ours = functions(OURS, |line| line.starts_with("    pub fn fmc_"));
        assert!(ours.len() > 30);
        assert_eq!(ours, header);
    }
}
