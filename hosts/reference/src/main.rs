//! The command `fmc`: contact forces of mesh files, and the benchmarks of the paper.

use clap::{Parser, Subcommand};
use std::process::ExitCode;

mod commands;
mod estimator_args;
mod force;
mod report;
mod verify;

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
    Run(commands::run::RunArgs),
    List(commands::list::ListArgs),
    Mesh(commands::mesh::MeshArgs),
    Study(commands::study::StudyArgs),
    Report(commands::report::ReportArgs),
    Force(force::ForceArgs),
    Verify(verify::VerifyArgs),
}

fn main() -> ExitCode {
    let result = match Cli::parse().command {
        Command::Run(args) => commands::run::run(&args),
        Command::List(args) => commands::list::run(&args).map(|()| ExitCode::SUCCESS),
        Command::Mesh(args) => commands::mesh::run(&args).map(|()| ExitCode::SUCCESS),
        Command::Study(args) => commands::study::run(&args).map(|()| ExitCode::SUCCESS),
        Command::Report(args) => commands::report::run(&args),
        Command::Force(args) => force::run(&args).map(|()| ExitCode::SUCCESS),
        Command::Verify(args) => verify::run(&args),
    };
    result.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::from(2)
    })
}
