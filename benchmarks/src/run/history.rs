//! The history of a run as a table in CSV.

use anyhow::{Context, Result, ensure};
use fmc_solid::dynamics::Sample;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{LineWriter, Write};
use std::path::{Path, PathBuf};

/// Samples of all steps so far, in memory and in a file that grows line by line.
///
/// Numbers are written with the fewest digits that read back as the same bits.
pub struct History<const D: usize> {
    file: LineWriter<File>,
    path: PathBuf,
    /// All samples, the first at time 0. Their seconds and warnings are not kept.
    pub samples: Vec<Sample<D>>,
}

const AXES: [&str; 3] = ["x", "y", "z"];

impl<const D: usize> History<D> {
    /// Starts a file. Names are those of the bodies, then of the obstacles.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn create(path: &Path, bodies: &[String], obstacles: &[String]) -> Result<Self> {
        let cannot = || format!("{} cannot be written", path.display());
        let mut file = LineWriter::new(File::create(path).with_context(cannot)?);
        writeln!(file, "{}", header::<D>(bodies, obstacles)).with_context(cannot)?;
        Ok(Self { file, path: path.to_owned(), samples: Vec::new() })
    }

    /// Goes on with a file after the given step; later lines are dropped.
    ///
    /// # Errors
    /// If it cannot be read or written, is another table, or ends before that step.
    pub fn resume(path: &Path, bodies: &[String], obstacles: &[String], step: u64) -> Result<Self> {
        let name = path.display();
        let text = std::fs::read_to_string(path).with_context(|| format!("{name} cannot be read"))?;
        let mut lines = text.lines();
        let header = header::<D>(bodies, obstacles);
        ensure!(lines.next() == Some(&header), "{name} is the history of another case");
        let mut history = Self::create(path, bodies, obstacles)?;
        for line in lines.take(step as usize + 1) {
            let sample = parse(line, bodies.len(), obstacles.len());
            let sample = sample.filter(|sample: &Sample<D>| sample.step == history.samples.len() as u64);
            let number = history.samples.len() + 2;
            history.push(sample.with_context(|| format!("{name}:{number}: it cannot be read"))?)?;
        }
        ensure!(history.samples.len() as u64 == step + 1, "{name} ends before step {step}, where the checkpoint is");
        Ok(history)
    }

    /// Adds a sample.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn push(&mut self, sample: Sample<D>) -> Result<()> {
        writeln!(self.file, "{}", line(&sample))
            .with_context(|| format!("{} cannot be written", self.path.display()))?;
        self.samples.push(Sample { seconds: 0.0, contact_seconds: 0.0, warnings: Vec::new(), ..sample });
        Ok(())
    }
}

/// Names of the columns.
fn header<const D: usize>(bodies: &[String], obstacles: &[String]) -> String {
    let mut text = "step,time,kinetic,strain,contact,external,dissipated,total".to_owned();
    let vectors = [("force", bodies), ("force", obstacles), ("velocity", bodies)];
    for (quantity, name) in vectors.iter().flat_map(|(quantity, names)| names.iter().map(move |name| (quantity, name)))
    {
        for axis in &AXES[..D] {
            // A name may hold anything; a column may not hold what separates columns.
            let name: String = name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
            write!(text, ",{quantity}_{name}_{axis}").expect("writing into a string");
        }
    }
    text + ",balance,overlap,penetration,contact_area,fibers,crossings"
}

fn line<const D: usize>(sample: &Sample<D>) -> String {
    let Sample { step, time, kinetic, strain, contact, external, dissipated, total, balance, .. } = sample;
    let mut text = format!("{step},{time:?},{kinetic:?},{strain:?},{contact:?},{external:?},{dissipated:?},{total:?}");
    for value in sample.bodies.iter().chain(&sample.obstacles).chain(&sample.velocities).flatten() {
        write!(text, ",{value:?}").expect("writing into a string");
    }
    let Sample { overlap, penetration, contact_area, fibers, crossings, .. } = sample;
    text + &format!(",{balance:?},{overlap:?},{penetration:?},{contact_area:?},{fibers},{crossings}")
}

/// A line read back; `None` if it is cut short or no such line.
fn parse<const D: usize>(line: &str, bodies: usize, obstacles: usize) -> Option<Sample<D>> {
    let mut words = line.split(',');
    let step = words.next()?.parse().ok()?;
    let mut number = || words.next()?.parse::<f64>().ok();
    let [time, kinetic, strain, contact] = [number()?, number()?, number()?, number()?];
    let [external, dissipated, total] = [number()?, number()?, number()?];
    let mut vectors = |count: usize| -> Option<Vec<[f64; D]>> {
        (0..count)
            .map(|_| {
                let mut vector = [0.0; D];
                for component in &mut vector {
                    *component = number()?;
                }
                Some(vector)
            })
            .collect()
    };
    let (bodies, obstacles, velocities) = (vectors(bodies)?, vectors(obstacles)?, vectors(bodies)?);
    let [balance, overlap, penetration, contact_area] = [number()?, number()?, number()?, number()?];
    let (fibers, crossings) = (words.next()?.parse().ok()?, words.next()?.parse().ok()?);
    words.next().is_none().then_some(Sample {
        step,
        time,
        kinetic,
        strain,
        contact,
        external,
        total,
        dissipated,
        bodies,
        obstacles,
        balance,
        velocities,
        overlap,
        penetration,
        contact_area,
        fibers,
        crossings,
        warnings: Vec::new(),
        contact_seconds: 0.0,
        seconds: 0.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(step: u64) -> Sample<2> {
        let x = 1.0 / (3.0 + step as f64);
        Sample {
            step,
            time: x * 1e-6,
            kinetic: 1e300 * x,
            strain: f64::MIN_POSITIVE * x,
            contact: 0.0,
            external: -0.0,
            total: x,
            dissipated: 0.0,
            bodies: vec![[x, -x], [-x, x]],
            obstacles: vec![[0.1, 0.2]],
            balance: x * 1e-17,
            velocities: vec![[0.0, -50.0], [x, 2.0 * x]],
            overlap: x,
            penetration: x,
            contact_area: x,
            fibers: 3,
            crossings: 4,
            warnings: Vec::new(),
            contact_seconds: 0.0,
            seconds: 0.0,
        }
    }

    #[test]
    fn a_file_cut_off_anywhere_is_resumed_or_refused() {
        let path = std::env::temp_dir().join(format!("fmc-history-{}.csv", std::process::id()));
        let (bodies, obstacles) = (["star".to_owned(), "the block".to_owned()], ["wall".to_owned()]);
        let mut whole = History::create(&path, &bodies, &obstacles).unwrap();
        (0..4).for_each(|step| whole.push(sample(step)).unwrap());
        let text = std::fs::read_to_string(&path).unwrap();
        let columns = text.lines().next().unwrap().split(',').count();
        assert!(text.lines().all(|line| line.split(',').count() == columns));
        assert!(text.contains(",force_the_block_y,"));
        for length in (0..text.len()).step_by(7).chain([text.len()]) {
            std::fs::write(&path, &text[..length]).unwrap();
            match History::<2>::resume(&path, &bodies, &obstacles, 1) {
                Ok(mut history) => {
                    assert_eq!(history.samples, whole.samples[..2]);
                    (2..4).for_each(|step| history.push(sample(step)).unwrap());
                    assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
                }
                Err(_) => assert!(text[..length].lines().count() <= 3),
            }
        }
        std::fs::write(&path, text.replace("star", "disc")).unwrap();
        assert!(History::<2>::resume(&path, &bodies, &obstacles, 1).is_err());
        std::fs::remove_file(&path).unwrap();
    }
}
