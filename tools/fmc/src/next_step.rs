//! What to do after an error, by the command that met it.

/// A line behind the error, which says where what is expected stands.
pub(crate) fn next_step(command: &str) -> String {
    match command {
        "run" | "mesh" => format!(
            "Included cases: fmc list. Contents of a case: benchmarks/cases. Options and examples: fmc {command} \
             --help"
        ),
        "study" => "Included cases: fmc list. Options and examples: fmc study --help, fmc study impact --help".into(),
        "report" => "Names of examples: fmc list, or none for all of them. Options: fmc report --help".into(),
        other => format!("Formats, options and examples: fmc {other} --help"),
    }
}
