//! `*STEP`: what is held, what is loaded, and how long it takes.

use super::material::optional_line;
use super::words::{numbers, one_of, only};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields, number};

/// Displacements of nodes along some axes.
#[derive(Clone, Debug)]
pub(crate) struct Boundary {
    pub(crate) line: usize,
    pub(crate) set: String,
    /// First and last axis, from 0.
    pub(crate) axes: [usize; 2],
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
    /// A force along an axis, on each node of a set.
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
    pub(crate) boundaries: Vec<Boundary>,
    pub(crate) loads: Vec<Load>,
    /// `OP=NEW` of supports, forces and distributed loads.
    pub(crate) is_new: [bool; 3],
}

/// Load steps that a step may ask for.
const MOST_COUNT: f64 = 1e5;

impl Step {
    /// A step that does nothing.
    pub(super) fn empty(line: usize) -> Self {
        Self {
            line,
            is_finite: false,
            is_static: false,
            count: 1,
            period: 1.0,
            boundaries: Vec::new(),
            loads: Vec::new(),
            is_new: [false; 3],
        }
    }

    /// Reads `*STEP`.
    pub(super) fn begin(keyword: &Keyword, lines: &mut Lines) -> Result<Self, Fault> {
        only(keyword, &["NAME", "NLGEOM", "INC", "AMPLITUDE", "EXTRAPOLATION", "UNSYMM"])?;
        one_of(keyword, "NLGEOM", &["", "YES", "NO"])?;
        one_of(keyword, "AMPLITUDE", &["RAMP"])?;
        // Its data lines are a heading.
        while lines.data().is_some() {}
        let is_finite = keyword.value("NLGEOM").is_some_and(|value| !value.eq_ignore_ascii_case("NO"));
        Ok(Self { is_finite, ..Self::empty(keyword.line) })
    }

    /// Reads `*STATIC`: first increment, period, least and most increment.
    pub(super) fn read_static(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
        only(keyword, &["DIRECT", "SOLVER"])?;
        let found = optional_line(keyword, lines)?;
        let [first, period, _, most] = [0, 1, 2, 3].map(|k| found.get(k).copied().flatten().unwrap_or(0.0));
        if [first, period, most].iter().any(|time| !(*time >= 0.0 && time.is_finite())) {
            return Err(Fault::new(keyword.line, "times of *STATIC are not below 0"));
        }
        self.period = if period > 0.0 { period } else { 1.0 };
        let longest = [most, first, self.period].into_iter().find(|time| *time > 0.0).unwrap_or(1.0);
        let is_direct = keyword.value("DIRECT").is_some();
        let longest = if is_direct && first > 0.0 { first } else { longest };
        let count = (self.period / longest - 1e-9).ceil().max(1.0);
        if count > MOST_COUNT {
            return Err(Fault::new(keyword.line, format!("{count} load steps are more than {MOST_COUNT}")));
        }
        (self.count, self.is_static) = (count as usize, true);
        Ok(())
    }

    /// Reads `*BOUNDARY`.
    pub(super) fn read_boundary(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
        only(keyword, &["OP", "AMPLITUDE", "TYPE"])?;
        one_of(keyword, "TYPE", &["DISPLACEMENT"])?;
        self.take_op(keyword, 0)?;
        let amplitude = keyword.value("AMPLITUDE").map(str::to_uppercase);
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).collect();
            let set = entries[0].trim_matches('"').to_owned();
            let named = entries.get(1).map(|word| word.to_uppercase()).unwrap_or_default();
            let row = |axes, value| Boundary { line, set: set.clone(), axes, value, amplitude: amplitude.clone() };
            let all: &[usize] = match named.as_str() {
                "ENCASTRE" | "PINNED" => &[0, 1, 2],
                "XSYMM" => &[0],
                "YSYMM" => &[1],
                "ZSYMM" => &[2],
                _ => &[],
            };
            if !all.is_empty() {
                self.boundaries.extend(all.iter().map(|&axis| row([axis, axis], 0.0)));
                continue;
            }
            let axis = |field: Option<&&str>| -> Result<Option<usize>, Fault> {
                let Some(field) = field.filter(|field| !field.is_empty()) else { return Ok(None) };
                match field.parse::<usize>() {
                    Ok(axis @ 1..=3) => Ok(Some(axis - 1)),
                    _ => Err(Fault::new(line, format!("degree of freedom {field} is not known, only 1, 2 and 3"))),
                }
            };
            let Some(first) = axis(entries.get(1))? else {
                return Err(Fault::new(line, "*BOUNDARY needs a degree of freedom"));
            };
            let last = axis(entries.get(2))?.unwrap_or(first);
            let value = number(line, entries.get(3).copied().unwrap_or_default())?;
            if last < first || entries.len() > 4 {
                return Err(Fault::new(line, "expected a set, first and last degree of freedom, and a value"));
            }
            self.boundaries.push(row([first, last], value));
        }
        Ok(())
    }

    /// Reads `*CLOAD`.
    pub(super) fn read_forces(&mut self, keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
        only(keyword, &["OP", "AMPLITUDE"])?;
        self.take_op(keyword, 1)?;
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).collect();
            let [set, axis, value] = entries[..] else {
                return Err(Fault::new(line, "expected a set, a degree of freedom and a force"));
            };
            let Ok(axis @ 1..=3) = axis.parse::<usize>() else {
                return Err(Fault::new(line, format!("degree of freedom {axis} is not known, only 1, 2 and 3")));
            };
            self.push_load(keyword, line, set, LoadKind::Force(axis - 1), number(line, value)?);
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
            let value = number(line, entries.get(2).copied().unwrap_or_default())?;
            let face = kind.strip_prefix('P').and_then(|face| face.parse::<usize>().ok()).filter(|face| *face > 0);
            let kind = match (kind.as_str(), face) {
                ("P", _) if is_on_surface => LoadKind::OnSurface,
                (_, Some(face)) if !is_on_surface => LoadKind::Pressure(face - 1),
                ("GRAV", _) if !is_on_surface => {
                    let rest = numbers(line, &entries[3.min(entries.len())..].join(","))?;
                    LoadKind::Gravity(std::array::from_fn(|axis| rest.get(axis).copied().flatten().unwrap_or(0.0)))
                }
                _ => {
                    let known = if is_on_surface { "P" } else { "P1, P2, … and GRAV" };
                    return Err(Fault::new(line, format!("a load '{kind}' is not known, only {known}")));
                }
            };
            if entries.len() > 3 && !matches!(kind, LoadKind::Gravity(_)) {
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
