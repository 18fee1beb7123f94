//! `*SURFACE, TYPE=SEGMENTS`, `CYLINDER` or `REVOLUTION`: analytical rigid surfaces.

use super::words::{length, only, required};
use crate::Fault;
use crate::profile::{Frame, Piece, Profile, Wrong};
use fmc_mesh_io::inp::{Keyword, Lines, fields};

/// How a profile goes through space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    /// Of the plane, or of a body of revolution in it.
    Segments,
    /// Straight along the third axis.
    Cylinder,
    /// Around the second axis.
    Revolution,
}

/// An analytical surface.
#[derive(Clone, Debug)]
pub(crate) struct Analytical {
    pub(super) line: usize,
    pub(super) shape: Shape,
    pub(super) profile: Profile,
    pub(super) frame: Frame,
    /// Whether its axes are those of its part.
    pub(super) has_own_axes: bool,
}

const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl From<Wrong> for Fault {
    fn from(Wrong { line, message }: Wrong) -> Self {
        Self::new(line, message)
    }
}

impl Analytical {
    /// Reads one; none if the surface is of elements or nodes.
    pub(super) fn read(keyword: &Keyword, lines: &mut Lines) -> Result<Option<Self>, Fault> {
        let shape = match keyword.value("TYPE").map(str::to_uppercase).as_deref() {
            Some("SEGMENTS") => Shape::Segments,
            Some("CYLINDER") => Shape::Cylinder,
            Some("REVOLUTION") => Shape::Revolution,
            _ => return Ok(None),
        };
        only(keyword, &["NAME", "TYPE", "INTERNAL", "FILLET RADIUS"])?;
        let fillet = length(keyword, "FILLET RADIUS")?.filter(|radius| *radius > 0.0);
        let mut rows: Vec<(usize, Vec<&str>)> = Vec::new();
        while let Some((line, text)) = lines.data() {
            rows.push((line, fields(text).collect()));
        }
        let begin = rows.iter().position(|(_, row)| row[0].eq_ignore_ascii_case("START"));
        let Some(begin) = begin else {
            return Err(Fault::new(keyword.line, "this analytical surface has no START"));
        };
        let axes: Vec<&(usize, Vec<&str>)> =
            rows[..begin].iter().filter(|(_, row)| row.iter().any(|f| !f.is_empty())).collect();
        let frame = frame(shape, keyword.line, &axes)?;
        let (line, row) = &rows[begin];
        let start = point((*line, row), 2, 3)?;
        let pieces: Vec<(usize, Piece)> = rows[begin + 1..]
            .iter()
            .map(|(line, row)| Ok((*line, piece((*line, row))?)))
            .collect::<Result<_, Fault>>()?;
        if pieces.is_empty() {
            return Err(Fault::new(*line, "no segment follows START: LINE, CIRCL or PARBL"));
        }
        let profile = Profile { start, pieces };
        let profile = fillet.map_or(Ok(profile.clone()), |radius| profile.rounded(radius))?;
        let has_own_axes = axes.is_empty();
        Ok(Some(Self { line: keyword.line, shape, profile, frame, has_own_axes }))
    }
}

/// Two coordinates of a segment from a field on, of which there are `most`; those that are not there are 0.
fn point((line, row): (usize, &[&str]), field: usize, most: usize) -> Result<[f64; 2], Fault> {
    if row.len() > most {
        return Err(Fault::new(
            line,
            format!("{} has {} numbers here, not {}", row[0].to_uppercase(), most - 1, row.len() - 1),
        ));
    }
    let mut found = [0.0; 2];
    for (k, x) in found.iter_mut().enumerate() {
        if row.get(field - 1 + k).is_some_and(|text| !text.is_empty()) {
            *x = required(line, row, field + k, "a coordinate")?;
        }
    }
    Ok(found)
}

fn piece((line, row): (usize, &[&str])) -> Result<Piece, Fault> {
    match row[0].to_uppercase().as_str() {
        "LINE" => Ok(Piece::Line(point((line, row), 2, 3)?)),
        "CIRCL" => Ok(Piece::Arc { end: point((line, row), 2, 5)?, centre: point((line, row), 4, 5)? }),
        "PARBL" | "PARAB" => Ok(Piece::Parabola { middle: point((line, row), 2, 5)?, end: point((line, row), 4, 5)? }),
        other => Err(Fault::new(line, format!("a segment '{other}' is not known, only LINE, CIRCL and PARBL"))),
    }
}

/// The axes by points in `rows`: an origin and a point on the first axis, of a cylinder then one on its generator, which is opposite to the third axis; of a
/// body of revolution an origin and a point of its axis.
fn frame(shape: Shape, line: usize, rows: &[&(usize, Vec<&str>)]) -> Result<Frame, Fault> {
    let count = match shape {
        Shape::Segments => 0,
        Shape::Cylinder => 2,
        Shape::Revolution => 1,
    };
    if rows.is_empty() {
        return Ok(Frame { origin: [0.0; 3], axes: AXES });
    }
    if rows.len() != count {
        let message = format!("expected {count} lines with points of the axes before START, found {}", rows.len());
        return Err(Fault::new(line, message));
    }
    let mut numbers = [0.0; 9];
    for (number, (line, row)) in rows.iter().enumerate() {
        let most = if number == 0 { 6 } else { 3 };
        if row.len() > most {
            return Err(Fault::new(*line, format!("expected {most} coordinates, found {}", row.len())));
        }
        for (k, _) in row.iter().enumerate().filter(|(_, text)| !text.is_empty()) {
            numbers[6 * number + k] = required(*line, row, k + 1, "a coordinate")?;
        }
    }
    let point = |k: usize| -> [f64; 3] { std::array::from_fn(|axis| numbers[3 * k + axis]) };
    let from_origin = |k: usize| -> [f64; 3] { std::array::from_fn(|axis| point(k)[axis] - point(0)[axis]) };
    let line = rows[0].0;
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let message = "the points of the axes are one, or lie on one line";
        if length > 0.0 { Ok(v.map(|x| x / length)) } else { Err(Fault::new(line, message)) }
    };
    let cross = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
    };
    let axes = match shape {
        Shape::Cylinder => {
            let first = unit(from_origin(1))?;
            let second = unit(cross(first, unit(from_origin(2))?))?;
            [first, second, cross(first, second)]
        }
        _ => {
            let axis = unit(from_origin(1))?;
            let least = (0..3).min_by(|&p, &q| axis[p].abs().total_cmp(&axis[q].abs())).unwrap_or(0);
            let first = unit(cross(axis, AXES[least]))?;
            [first, axis, cross(first, axis)]
        }
    };
    Ok(Frame { origin: point(0), axes })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Analytical, Fault> {
        let mut lines = Lines::new(text);
        let keyword = lines.keyword().unwrap();
        Analytical::read(&keyword, &mut lines).map(Option::unwrap)
    }

    /// A plate above a body, as generators of textiles write it: its outside is below, with the generator along −y.
    #[test]
    fn the_generator_is_opposite_to_the_third_axis() {
        let found =
            read("*SURFACE, TYPE=CYLINDER, NAME=TOP\n0, 0, 0, 1, 0, 0\n0, -1, 0\nStart, -2., -3.\nLine, 2., -3.\n")
                .unwrap();
        assert_eq!(found.frame.axes, [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]);
        // To the left of the way along x, with the second axis down, is down.
        assert_eq!(found.profile.pieces[0].1, Piece::Line([2.0, -3.0]));
    }

    #[test]
    fn an_axis_of_revolution_is_the_second() {
        let found =
            read("*SURFACE, TYPE=REVOLUTION, NAME=BALL\n1, 2, 3, 1, 2, 7\nSTART, 0., 0.\nCIRCL, 1., -1., 0., -1.\n")
                .unwrap();
        let Frame { origin, axes } = found.frame;
        assert!(origin == [1.0, 2.0, 3.0] && axes[1] == [0.0, 0.0, 1.0] && axes[0][2] == 0.0, "{axes:?}");
    }

    #[test]
    fn what_is_no_profile_is_refused_by_its_line() {
        for (text, line, expected) in [
            ("LINE, 1., 0.", 1, "has no START"),
            ("START, 0., 0.", 2, "no segment follows START"),
            ("START, 0., 0.\nSPLINE, 1., 0.", 3, "a segment 'SPLINE' is not known"),
            ("START, 0., 0.\nLINE, 1., 0., 2.", 3, "LINE has 2 numbers here, not 3"),
            ("START, 0., 0.\nLINE, 1., nan", 3, "found 'nan' in field 3"),
            ("0., 0., 0., 1., 0., 0.\nSTART, 0., 0.\nLINE, 1., 0.", 1, "expected 0 lines with points of the axes"),
        ] {
            let fault = read(&format!("*SURFACE, TYPE=SEGMENTS, NAME=S\n{text}\n")).unwrap_err();
            assert!(fault.line == line && fault.message.contains(expected), "{text}: {fault}");
        }
        let text = "*SURFACE, TYPE=CYLINDER, NAME=S\n0., 0., 0., 1., 0., 0.\n2., 0., 0.\nSTART, 0., 0.\nLINE, 1., 0.\n";
        let fault = read(text).unwrap_err();
        assert!(fault.line == 2 && fault.message.contains("lie on one line"), "{fault}");
    }
}
