//! The command `fmc`: contact forces of mesh files, and the benchmarks of the paper.

use clap::{CommandFactory, Parser, Subcommand};
use std::process::ExitCode;

#[cfg(feature = "statics")]
mod commands;
mod estimator_args;
mod folder;
mod force;
mod man;
mod next_step;

#[cfg(feature = "statics")]
const AFTER_HELP: &str = "To begin with:
  Forces between two meshes, and a picture of them:
    fmc force examples/star.msh examples/block.msh --stiffness 2.8e7
  Solve an input file of Abaqus or CalculiX:
    fmc solve model.inp
  List the cases, and run one of them, an equilibrium compared with a closed form:
    fmc list
    fmc run hertz
  Run all of them and write one page, in less than a minute:
    fmc report --quick
  Every option of a command, with examples:
    fmc COMMAND --help

Exit status: 0 on success, 1 if a bound or a check is missed, 2 for bad usage or input.";

#[cfg(not(feature = "statics"))]
const AFTER_HELP: &str = "To begin with:
  Forces between two meshes, and a picture of them:
    fmc force examples/star.msh examples/block.msh --stiffness 2.8e7
  Every option, with examples:
    fmc force --help

Built without the commands that solve: cargo run --release -p fmc has them.
Exit status: 0 on success, 2 for bad usage or input.";

/// Contact forces between any meshes, from how deep they overlap
#[derive(Parser)]
#[command(
    version,
    after_help = AFTER_HELP
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
    Solve(commands::solve::SolveArgs),
    #[cfg(feature = "statics")]
    List(commands::list::ListArgs),
    #[cfg(feature = "statics")]
    Mesh(commands::mesh::MeshArgs),
    #[cfg(feature = "statics")]
    Study(commands::study::StudyArgs),
    #[cfg(feature = "plots")]
    Report(commands::report::ReportArgs),
    // The largest by far.
    Force(Box<force::ForceArgs>),
    #[cfg(feature = "statics")]
    Verify(commands::verify::VerifyArgs),
    Man(man::ManArgs),
}

impl Command {
    /// As it is called.
    fn name(&self) -> &'static str {
        match self {
            #[cfg(feature = "statics")]
            Command::Run(_) => "run",
            #[cfg(feature = "statics")]
            Command::Solve(_) => "solve",
            #[cfg(feature = "statics")]
            Command::List(_) => "list",
            #[cfg(feature = "statics")]
            Command::Mesh(_) => "mesh",
            #[cfg(feature = "statics")]
            Command::Study(_) => "study",
            #[cfg(feature = "plots")]
            Command::Report(_) => "report",
            Command::Force(_) => "force",
            #[cfg(feature = "statics")]
            Command::Verify(_) => "verify",
            Command::Man(_) => "man",
        }
    }
}

fn main() -> ExitCode {
    let command = Cli::parse().command;
    let name = command.name();
    let result = match command {
        #[cfg(feature = "statics")]
        Command::Run(args) => commands::run::run(&args),
        #[cfg(feature = "statics")]
        Command::Solve(args) => commands::solve::run(&args),
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
        // A reader that stops early, as `head` does, is no error.
        let cause = error.chain().find_map(|cause| cause.downcast_ref::<std::io::Error>());
        if cause.is_some_and(|cause| cause.kind() == std::io::ErrorKind::BrokenPipe) {
            return ExitCode::SUCCESS;
        }
        eprintln!("error: {error:#}\n\n{}", next_step::next_step(name));
        ExitCode::from(2)
    })
}
