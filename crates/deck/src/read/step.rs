//! `*STEP`: what is held, what is loaded, and how long it takes.

use super::note::Note;
use super::words::{one_of, only, optional_line, required};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};

/// Displacements of nodes along some axes.
#[derive(Clone, Debug)]
pub(crate) struct Boundary {
    pub(crate) line: usize,
    pub(crate) set: String,
    /// First and last axis, from 0; rotations from 3.
    pub(crate) axes: [usize; 2],
    /// Whether a name as `ENCASTRE` stands for the axes: points without rotations leave these out.
    pub(crate) is_named: bool,
    /// Whether they stay where the step finds them.
    pub(crate) is_fixed: bool,
    pub(crate) value: f64,
    pub(crate) amplitude: Option<String>,
}

/// A load.
#[derive(Clone, Debug)]
pub(crate) struct Load {
    pub(crate) line: usize,
    /// Set, label or surface.
    pub(crate) set: String,
    pub(crate) kind: LoadKind,
    pub(crate) value: f64,
    pub(crate) amplitude: Option<String>,
}

/// What a load is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum LoadKind {
    /// A force along an axis, or from 3 a moment about one, on each node of a set.
    Force(usize),
    /// A pressure on face `P1`, … of the elements of a set, from 0.
    Pressure(usize),
    /// A pressure on a surface.
    OnSurface,
    /// An acceleration along a direction.
    Gravity([f64; 3]),
}

/// A step; that before the first holds what stands outside of steps.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    pub(crate) line: usize,
    pub(crate) is_finite: bool,
    pub(crate) is_static: bool,
    /// Load steps to begin with, and time.
    pub(crate) count: usize,
    pub(crate) period: f64,
    /// Times that a load step may be halved before it is shorter than the least increment.
    pub(crate) most_halvings: u32,
    /// Load steps that `INC` allows, if it is there.
    pub(crate) most: Option<usize>,
    pub(crate) boundaries: Vec<Boundary>,
    pub(crate) loads: Vec<Load>,
    /// `OP=NEW` of supports, forces and distributed loads.
    pub(crate) is_new: [bool; 3],
}

/// Load steps that a step may ask for.
const MOST_COUNT: f64 = 1e5;

/// Times that a load step is halved, at most.
const MOST_HALVINGS: u32 = 8;

impl Step {
    /// A step that does nothing.
    pub(super) fn empty(line: usize) -> Self {
        Self {
            line,
            is_finite: false,
            is_static: false,
            count: 1,
            period: 1.0,
            most_halvings: MOST_HALVINGS,
            most: None,
            boundaries: Vec::new(),
            loads: Vec::new(),
            is_new: [false; 3],
        }
    }

    /// Reads `*STEP`.
    pub(super) fn begin(keyword: &Keyword, lines: &mut Lines, notes: &mut Vec<Note>) -> Result<Self, Fault> {
        only(keyword, &["NAME", "NLGEOM", "INC", "AMPLITUDE", "EXTRAPOLATION", "UNSYMM"])?;
        one_of(keyword, "NLGEOM", &["", "YES", "NO"])?;
        one_of(keyword, "AMPLITUDE", &["RAMP", "STEP"])?;
        if keyword.value("AMPLITUDE").is_some_and(|kind| kind.eq_ignore_ascii_case("STEP")) {
            notes.push(Note::new(
                keyword.line,
                "AMPLITUDE=STEP is taken as RAMP: loads grow evenly to the end of the step",
            ));
        }
        let most = match keyword.value("INC") {
            Some(text) => match text.parse::<usize>() {
                Ok(count) if count > 0 => Some(count),
                _ => return Err(Fault::new(keyword.line, format!("*STEP, INC={text} is not a number of increments"))),
            },
            None => None,
        };
        // Its data lines are a heading.
        while lines.data().is_some() {}
        let is_finite = keyword.value("NLGEOM").is_some_and(|value| !value.eq_ignore_ascii_case("NO"));
        Ok(Self { is_finite, most, ..Self::empty(keyword.line) })
    }

    /// Reads `*STATIC`: first increment, period, least and most increment.
    pub(super) fn read_static(
        &mut self,
        keyword: &Keyword,
        lines: &mut Lines,
        notes: &mut Vec<Note>,
    ) -> Result<(), Fault> {
        only(keyword, &["DIRECT", "SOLVER"])?;
        one_of(keyword, "DIRECT", &[""])?;
        if self.is_static {
            return Err(Fault::new(keyword.line, "this step has a *STATIC already"));
        }
        let (line, found) = optional_line(keyword, lines)?;
        if found.iter().skip(4).flatten().next().is_some() {
            return Err(Fault::new(
                line,
                "*STATIC has four numbers: first increment, period, least and most increment",
            ));
        }
        let time = |place: usize| found.get(place - 1).copied().flatten().unwrap_or(0.0);
        if let Some(place) = (1..=4).find(|place| time(*place) < 0.0) {
            return Err(Fault::new(
                line,
                format!("times of *STATIC are not below 0, as {} in field {place}", time(place)),
            ));
        }
        let [first, period, least, most] = [1, 2, 3, 4].map(time);
        self.period = if period > 0.0 { period } else { 1.0 };
        let longest = [most, first, self.period].into_iter().find(|time| *time > 0.0).unwrap_or(1.0);
        let is_direct = keyword.value("DIRECT").is_some();
        let longest = if is_direct && first > 0.0 { first } else { longest };
        let count = (self.period / longest - 1e-9).ceil().max(1.0);
        if count > MOST_COUNT {
            return Err(Fault::new(line, format!("{count} load steps are more than {MOST_COUNT}")));
        }
        (self.count, self.is_static) = (count as usize, true);
        if let Some(most) = self.most.filter(|most| *most < self.count) {
            let planned = self.count;
            if is_direct {
                let message =
                    format!("the step takes {planned} increments, more than INC={most} of line {}", self.line);
                return Err(Fault::new(line, message));
            }
            notes.push(Note::new(
                self.line,
                format!("INC={most}: the step begins with as many load steps, not {planned}"),
            ));
            self.count = most;
        }
        if least > 0.0 {
            let halvings = (self.period / self.count as f64 / least * (1.0 + 1e-9)).log2().floor();
            self.most_halvings = halvings.clamp(0.0, f64::from(MOST_HALVINGS)) as u32;
        }
        if least > longest {
            return Err(Fault::new(line, "the least increment of *STATIC is above the largest"));
        }
        Ok(())
    }

    /// Reads `*BOUNDARY`.
    pub(super) fn read_boundary(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
        only(keyword, &["OP", "AMPLITUDE", "TYPE", "FIXED"])?;
        one_of(keyword, "TYPE", &["DISPLACEMENT"])?;
        one_of(keyword, "FIXED", &[""])?;
        let is_fixed = keyword.value("FIXED").is_some();
        if is_fixed && keyword.value("AMPLITUDE").is_some() {
            return Err(Fault::new(
                keyword.line,
                "*BOUNDARY, FIXED holds nodes where they are, and takes no AMPLITUDE",
            ));
        }
        self.take_op(keyword, 0)?;
        let amplitude = keyword.value("AMPLITUDE").map(str::to_uppercase);
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).collect();
            let set = entries[0].trim_matches('"').to_owned();
            let named = entries.get(1).map(|word| word.to_uppercase()).unwrap_or_default();
            let row = |axes, is_named, value| Boundary {
                line,
                set: set.clone(),
                axes,
                is_named,
                is_fixed,
                value,
                amplitude: amplitude.clone(),
            };
            let all: &[usize] = match named.as_str() {
                "ENCASTRE" => &[0, 1, 2, 3, 4, 5],
                "PINNED" => &[0, 1, 2],
                "XSYMM" => &[0, 4, 5],
                "YSYMM" => &[1, 3, 5],
                "ZSYMM" => &[2, 3, 4],
                _ => &[],
            };
            if !all.is_empty() {
                if entries.len() > 2 {
                    return Err(Fault::new(line, format!("{named} has no further fields")));
                }
                self.boundaries.extend(all.iter().map(|&axis| row([axis, axis], true, 0.0)));
                continue;
            }
            let axis = |field: Option<&&str>| -> Result<Option<usize>, Fault> {
                let Some(field) = field.filter(|field| !field.is_empty()) else { return Ok(None) };
                match field.parse::<usize>() {
                    Ok(axis @ 1..=6) => Ok(Some(axis - 1)),
                    _ => Err(Fault::new(line, format!("degree of freedom {field} is not known, only 1 to 6"))),
                }
            };
            let Some(first) = axis(entries.get(1))? else {
                return Err(Fault::new(line, "*BOUNDARY needs a degree of freedom"));
            };
            let last = axis(entries.get(2))?.unwrap_or(first);
            // Without a fourth field they are held where they are.
            let value = if entries.len() < 4 { 0.0 } else { required(line, &entries, 4, "the displacement")? };
            if is_fixed && value != 0.0 {
                return Err(Fault::new(
                    line,
                    format!("*BOUNDARY, FIXED holds nodes where they are, and not at {value}"),
                ));
            }
            if last < first || entries.len() > 4 {
                return Err(Fault::new(line, "expected a set, first and last degree of freedom, and a value"));
            }
            self.boundaries.push(row([first, last], false, value));
        }
        Ok(())
    }

    /// Reads `*CLOAD`.
    pub(super) fn read_forces(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
        only(keyword, &["OP", "AMPLITUDE"])?;
        self.take_op(keyword, 1)?;
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).collect();
            let [set, axis, _] = entries[..] else {
                return Err(Fault::new(line, "expected a set, a degree of freedom and a force"));
            };
            let Ok(axis @ 1..=6) = axis.parse::<usize>() else {
                return Err(Fault::new(line, format!("degree of freedom {axis} is not known, only 1 to 6")));
            };
            let value = required(line, &entries, 3, "the force")?;
            self.push_load(keyword, line, set, LoadKind::Force(axis - 1), value);
        }
        Ok(())
    }

    /// Reads `*DLOAD` and `*DSLOAD`.
    pub(super) fn read_spread(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
        only(keyword, &["OP", "AMPLITUDE"])?;
        self.take_op(keyword, 2)?;
        let is_on_surface = keyword.name == "DSLOAD";
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).collect();
            let (set, kind) = (entries[0], entries.get(1).map(|kind| kind.to_uppercase()).unwrap_or_default());
            let face = kind.strip_prefix('P').and_then(|face| face.parse::<usize>().ok()).filter(|face| *face > 0);
            let kind = match (kind.as_str(), face) {
                ("P", _) if is_on_surface => LoadKind::OnSurface,
                (_, Some(face)) if !is_on_surface => LoadKind::Pressure(face - 1),
                ("GRAV", _) if !is_on_surface => {
                    let mut direction = [0.0; 3];
                    for (axis, x) in direction.iter_mut().enumerate() {
                        let is_there = entries.len() > axis + 3;
                        *x = if is_there { required(line, &entries, axis + 4, "the direction")? } else { 0.0 };
                    }
                    LoadKind::Gravity(direction)
                }
                _ => {
                    let known = if is_on_surface { "P" } else { "P1, P2, … and GRAV" };
                    return Err(Fault::new(line, format!("a load '{kind}' is not known, only {known}")));
                }
            };
            let value = required(line, &entries, 3, "the size of the load")?;
            if entries.len() > if matches!(kind, LoadKind::Gravity(_)) { 6 } else { 3 } {
                return Err(Fault::new(line, "expected a set or surface, the kind of load and its value"));
            }
            self.push_load(keyword, line, set, kind, value);
        }
        Ok(())
    }

    fn push_load(&mut self, keyword: &Keyword, line: usize, set: &str, kind: LoadKind, value: f64) {
        let amplitude = keyword.value("AMPLITUDE").map(str::to_uppercase);
        self.loads.push(Load { line, set: set.trim_matches('"').to_owned(), kind, value, amplitude });
    }

    fn take_op(&mut self, keyword: &Keyword, which: usize) -> Result<(), Fault> {
        one_of(keyword, "OP", &["MOD", "NEW"])?;
        self.is_new[which] |= keyword.value("OP").is_some_and(|op| op.eq_ignore_ascii_case("NEW"));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A step of ten load steps, by its data line.
    fn step(head: &str, data: &str) -> Step {
        let text = format!("*STEP{head}\n*STATIC\n{data}\n");
        let mut lines = Lines::new(&text);
        let keyword = lines.keyword().unwrap();
        let mut step = Step::begin(&keyword, &mut lines, &mut Vec::new()).unwrap();
        let keyword = lines.keyword().unwrap();
        step.read_static(&keyword, &mut lines, &mut Vec::new()).unwrap();
        step
    }

    #[test]
    fn increments_bound_the_load_steps() {
        for (head, data, count, halvings) in [
            ("", "0.1, 1.", 10, 8),
            (", INC=4", "0.1, 1.", 4, 8),
            (", INC=100", "0.1, 1., 0.025", 10, 2),
            ("", "0.1, 1., 0.1", 10, 0),
            ("", "0.1, 1., 1e-5, 0.5", 2, 8),
        ] {
            let found = step(head, data);
            assert_eq!((found.count, found.most_halvings), (count, halvings), "{head} {data}");
        }
    }
}
