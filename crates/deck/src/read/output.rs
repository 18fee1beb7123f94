//! Requests of output, and numbers of solvers: what is written does not depend on them.

use fmc_mesh_io::inp::Keyword;

/// Keywords that tell a solver how to iterate.
const OF_SOLVERS: [&str; 4] = ["CONTROLS", "CONTACT CONTROLS", "SOLUTION TECHNIQUE", "PHYSICAL CONSTANTS"];

/// What is said of a keyword that changes no result; none if it is not one.
pub(super) fn unused(name: &str) -> Option<&'static str> {
    match name {
        "TIME POINTS" => Some("results are written at the ends of steps"),
        "SECTION CONTROLS" => Some("elements are integrated in full"),
        "ORIENTATION" => Some("materials have no directions"),
        _ if OF_SOLVERS.contains(&name) => Some("the search uses none of its numbers"),
        _ if REQUESTS.contains(&name) => Some("files and tables do not depend on it"),
        _ => None,
    }
}

/// What to write instead of a keyword that is not known.
pub(super) fn instead(name: &str) -> Option<&'static str> {
    match name {
        "CLEARANCE" => Some(
            "gaps and overlaps are those of the coordinates. Write ADJUST=length at *CONTACT PAIR to close gaps, or move the nodes for a wanted clearance",
        ),
        "CONTACT INTERFERENCE" => Some(
            "overlaps of the coordinates are pressed as an interference fit over the first step. Leave it out, and move the nodes for a wanted interference",
        ),
        _ => None,
    }
}

/// The parameter by which a request asks for results within steps, if it has one.
pub(super) fn sampled(keyword: &Keyword) -> Option<&str> {
    let asks = |name: &str| matches!(name, "FREQUENCY" | "TIME POINTS" | "NUMBER INTERVAL" | "TIME INTERVAL");
    let is_request = REQUESTS.contains(&keyword.name.as_str());
    keyword.parameters.iter().map(|(name, _)| name.as_str()).find(|name| is_request && asks(name))
}

/// Keywords that ask for results.
const REQUESTS: [&str; 19] = [
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
