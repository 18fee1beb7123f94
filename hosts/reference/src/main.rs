//! The command `fmc`: contact forces of mesh files.

use clap::{Parser, Subcommand};
use std::process::ExitCode;

mod estimator_args;
mod force;
mod mesh;

/// Contact forces from overlap volume, by Fiber Monte Carlo
#[derive(Parser)]
#[command(version, after_help = "Exit status: 0 on success, 2 for bad usage or input.")]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Force(force::ForceArgs),
}

fn main() -> ExitCode {
    let result = match Cli::parse().command {
        Command::Force(args) => force::run(&args),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}
