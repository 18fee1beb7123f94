//! When fields are written, and the list that ParaView opens.

use anyhow::Result;
use fmc_mesh_io::write_whole;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The steps whose fields are written: evenly spaced, the first and the last among them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frames {
    steps: Vec<u64>,
    step_size: f64,
}

impl Frames {
    /// `intervals` intervals over so many steps, fewer if there are fewer steps; 0 for no fields.
    pub(super) fn new(intervals: u64, step_count: u64, step_size: f64) -> Self {
        // One for every step is the most: a file may ask for more than there is memory for.
        let intervals = intervals.min(step_count);
        let at = |frame: u64| (u128::from(frame) * u128::from(step_count) / u128::from(intervals)) as u64;
        let mut steps: Vec<u64> = if intervals == 0 { Vec::new() } else { (0..=intervals).map(at).collect() };
        steps.dedup();
        Self { steps, step_size }
    }

    /// Number of the frame at a step, if there is one.
    pub(super) fn at(&self, step: u64) -> Option<usize> {
        self.steps.binary_search(&step).ok()
    }

    /// Time and file of the frames up to a step.
    pub(super) fn until(&self, step: u64) -> impl Iterator<Item = (f64, PathBuf)> {
        let numbered = self.steps.iter().enumerate().take_while(move |(_, frame)| **frame <= step);
        numbered.map(|(number, step)| (*step as f64 * self.step_size, Self::file(number)))
    }

    /// File of a frame, from the folder of the run.
    pub(super) fn file(number: usize) -> PathBuf {
        Path::new("fields").join(format!("{number:04}.vtu"))
    }

    /// Writes `fields.pvd`: the frames up to a step.
    pub(super) fn write_list(&self, folder: &Path, step: u64) -> Result<()> {
        let mut text = "<?xml version=\"1.0\"?>\n\
            <VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n"
            .to_owned();
        for (time, file) in self.until(step) {
            let file = file.display().to_string().replace('\\', "/");
            writeln!(text, "<DataSet timestep=\"{time:?}\" group=\"\" part=\"0\" file=\"{file}\"/>")?;
        }
        text += "</Collection>\n</VTKFile>\n";
        let path = folder.join("fields.pvd");
        write_whole(&path, text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_span_the_run() {
        let frames = Frames::new(7, 100, 0.5);
        assert_eq!((frames.at(0), frames.at(100), frames.at(1)), (Some(0), Some(7), None));
        assert_eq!(frames.until(100).count(), 8);
        assert_eq!(frames.until(14).last().unwrap().0, 7.0);
        assert_eq!(Frames::new(50, 3, 1.0).until(3).count(), 4);
        assert_eq!(Frames::new(u64::MAX, 3, 1.0), Frames::new(3, 3, 1.0));
        assert_eq!(Frames::new(0, 3, 1.0).until(3).count(), 0);
    }
}
