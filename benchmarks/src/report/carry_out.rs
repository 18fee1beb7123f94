//! From a job to its record.

mod pictures;

use super::job::{Job, Work};
use super::kernel;
use super::quantity::count;
use super::record::{Outcome, Record};
use super::setting::Setting;
use super::stamp::Stamp;
use crate::case::{Case, Document};
use crate::run::{self, Ending, Progress, RunOptions, Summary};
use anyhow::{Context, Result};
use fmc_mesh_io::write_whole;
use fmc_solid::statics::Iteration;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::Ordering;
use std::time::Instant;

/// What a run was started with, so that a checkpoint is taken up only by the same run.
const STARTED: &str = "started.json";

/// Runs a job in a folder and leaves its record there; `None` if it was interrupted, to be taken up at the next call.
///
/// An error of the run itself is a record too.
///
/// # Errors
/// If the folder cannot be made or the record cannot be written.
pub fn carry_out(
    job: &Job,
    camera: Option<[f64; 3]>,
    stamp: &Stamp,
    folder: &Path,
    setting: &Setting,
) -> Result<Option<Record>> {
    let started: Option<Stamp> =
        fs::read(folder.join(STARTED)).ok().and_then(|bytes| serde_json::from_slice(&bytes).ok());
    let resume = started.as_ref() == Some(stamp) && folder.join("checkpoint.state").is_file();
    if !resume {
        if folder.exists() {
            fs::remove_dir_all(folder).with_context(|| format!("{} cannot be removed", folder.display()))?;
        }
        fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        let path = folder.join(STARTED);
        write_whole(&path, serde_json::to_string(stamp)?)?;
    }
    let ended = match &job.work {
        Work::Kernel(name) => kernel::run(name, stamp.clone(), folder, setting).map(Some),
        Work::Case(work) => of_case(&work.0, &work.1, camera, stamp, (folder, resume), setting),
    };
    let record = match ended {
        Ok(Some(record)) => record,
        Ok(None) => return Ok(None),
        Err(error) => Record::without_figures(stamp.clone(), Outcome::Failed(format!("{error:#}"))),
    };
    record.save(folder)?;
    Ok(Some(record))
}

/// Runs a case; `None` if it was interrupted.
fn of_case(
    document: &Document,
    case: &Case,
    camera: Option<[f64; 3]>,
    stamp: &Stamp,
    (folder, resume): (&Path, bool),
    setting: &Setting,
) -> Result<Option<Record>> {
    let options = RunOptions { out: folder.to_owned(), threads: setting.threads, resume };
    match ending(document, case, &options, setting)? {
        Ending::Finished(summary) | Ending::FinishedBefore(summary) => {
            Ok(Some(finished(&summary, case, document, camera, stamp, folder)?))
        }
        Ending::Interrupted { .. } if setting.stop.load(Ordering::SeqCst) => Ok(None),
        Ending::Interrupted { .. } => {
            let granted = setting.limit.unwrap_or_default().as_secs();
            Ok(Some(Record::without_figures(stamp.clone(), Outcome::LeftOut(granted))))
        }
    }
}

fn ending(document: &Document, case: &Case, options: &RunOptions, setting: &Setting) -> Result<Ending> {
    let (clock, bar) = (Instant::now(), setting.bar);
    let goes_on = || {
        let is_late = setting.limit.is_some_and(|limit| clock.elapsed() > limit);
        if is_late || setting.stop.load(Ordering::SeqCst) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    if case.load_steps.is_some() {
        return run::run_at_rest(document, case, options, &mut |iteration: &Iteration| {
            bar.set_length(1000);
            bar.set_position((1000.0 * iteration.load) as u64);
            bar.set_message(format!(
                "load {:.3}, iteration {}, residual {:.1e}",
                iteration.load, iteration.iteration, iteration.residual
            ));
            goes_on()
        });
    }
    run::run(document, case, options, &mut |progress: &Progress| {
        bar.set_length(progress.step_count);
        bar.set_position(progress.step);
        // The bar draws some times a second; a message for every step would cost more than small steps do.
        if progress.step.is_multiple_of(64) {
            bar.set_message(format!("t = {:.3e} s, {:.0} steps/s", progress.time, progress.steps_per_second));
        }
        goes_on()
    })
}

fn finished(
    summary: &Summary,
    case: &Case,
    document: &Document,
    camera: Option<[f64; 3]>,
    stamp: &Stamp,
    folder: &Path,
) -> Result<Record> {
    let (pictures, brightest) = pictures::draw(summary, case, camera, folder)?;
    let [nodes, cells] = match case.dimension {
        2 => size::<2>(case, document)?,
        _ => size::<3>(case, document)?,
    };
    Ok(Record {
        size: format!("{} nodes, {} cells", count(nodes as u64), count(cells as u64)),
        pictures,
        brightest,
        ..Record::of(stamp.clone(), summary)
    })
}

/// Nodes and cells of all bodies.
fn size<const D: usize>(case: &Case, document: &Document) -> Result<[usize; 2]> {
    let parts = case.parts::<D>(&document.folder)?;
    Ok(parts.iter().fold([0, 0], |[n, c], part| [n + part.mesh.coords.len(), c + part.mesh.cell_count()]))
}
