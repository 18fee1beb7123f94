//! The command `fmc`: contact forces of mesh files, and the benchmarks of the paper.

use clap::{CommandFactory, Parser, Subcommand};
use std::process::ExitCode;

#[cfg(feature = "statics")]
mod commands;
mod estimator_args;
mod force;
mod man;

/// Contact forces from overlap volume, by Fiber Monte Carlo
#[derive(Parser)]
#[command(
    version,
    after_help = "Exit status: 0 on success, 1 if a bound or a check is missed, 2 for bad usage or input."
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    #[cfg(feature = "statics")]
    Run(commands::run::RunArgs),
    #[cfg(feature = "statics")]
    List(commands::list::ListArgs),
    #[cfg(feature = "statics")]
    Mesh(commands::mesh::MeshArgs),
    #[cfg(feature = "statics")]
    Study(commands::study::StudyArgs),
    #[cfg(feature = "plots")]
    Report(commands::report::ReportArgs),
    Force(force::ForceArgs),
    #[cfg(feature = "statics")]
    Verify(commands::verify::VerifyArgs),
    Man(man::ManArgs),
}

fn main() -> ExitCode {
    let result = match Cli::parse().command {
        #[cfg(feature = "statics")]
        Command::Run(args) => commands::run::run(&args),
        #[cfg(feature = "statics")]
        Command::List(args) => commands::list::run(&args).map(|()| ExitCode::SUCCESS),
        #[cfg(feature = "statics")]
        Command::Mesh(args) => commands::mesh::run(&args).map(|()| ExitCode::SUCCESS),
        #[cfg(feature = "statics")]
        Command::Study(args) => commands::study::run(&args).map(|()| ExitCode::SUCCESS),
        #[cfg(feature = "plots")]
        Command::Report(args) => commands::report::run(&args),
        Command::Force(args) => force::run(&args).map(|()| ExitCode::SUCCESS),
        #[cfg(feature = "statics")]
        Command::Verify(args) => commands::verify::run(&args),
        Command::Man(args) => man::run(Cli::command(), &args).map(|()| ExitCode::SUCCESS),
    };
    result.unwrap_or_else(|error| {
        // Who reads no further, as `head` does, has what it wants.
        let cause = error.chain().find_map(|cause| cause.downcast_ref::<std::io::Error>());
        if cause.is_some_and(|cause| cause.kind() == std::io::ErrorKind::BrokenPipe) {
            return ExitCode::SUCCESS;
        }
        eprintln!("error: {error:#}");
        ExitCode::from(2)
    })
}
