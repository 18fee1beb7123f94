//! Results as CalculiX writes them, for cgx and whatever else reads `.frd`.
//!
//! Source: G. Wittig, CalculiX GraphiX User's Manual, "Result Format": blocks of lines with fixed columns, in ASCII with long labels.

use super::fields::{pressures, stresses};
use crate::StepResult;
use crate::read::Deck;
use fmc_contact::CellType;
use fmc_mesh_io::in_space;
use fmc_solid::fem::Model;
use fmc_solid::statics::Equilibrium;
use std::fmt::Write;

/// Type of a cell in the format, and the places of its nodes in their order there. Middles of faces and cells are left out.
fn element(cell_type: CellType) -> Option<(usize, &'static [usize])> {
    const ALL: [usize; 10] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9];
    // The middles of the vertical edges come before those of the upper ones.
    const HEX20: [usize; 20] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15];
    const WEDGE15: [usize; 15] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11];
    match cell_type {
        CellType::Hex8 => Some((1, &ALL[..8])),
        CellType::Wedge6 => Some((2, &ALL[..6])),
        CellType::Tet4 => Some((3, &ALL[..4])),
        CellType::Hex20 | CellType::Hex27 => Some((4, &HEX20)),
        CellType::Wedge15 => Some((5, &WEDGE15)),
        CellType::Tet10 => Some((6, &ALL)),
        CellType::Tri3 => Some((7, &ALL[..3])),
        CellType::Tri6 => Some((8, &ALL[..6])),
        CellType::Quad4 => Some((9, &ALL[..4])),
        CellType::Quad8 | CellType::Quad9 => Some((10, &ALL[..8])),
        _ => None,
    }
}

/// Numbers of nodes and cells: the labels of the file, or from 1 where instances share labels.
struct Numbers {
    nodes: Vec<u64>,
    cells: Vec<u64>,
}

impl Numbers {
    fn new(deck: &Deck, [nodes, cells, apart]: &[Vec<usize>; 3]) -> Self {
        let nodes: Vec<usize> = nodes.iter().chain(apart).copied().collect();
        if deck.mesh.instances.is_empty() {
            let labels: Vec<u64> = deck.mesh.cells().map(|(_, _, label, _)| label).collect();
            return Self {
                nodes: nodes.iter().map(|&node| deck.mesh.node_tags[node]).collect(),
                cells: cells.iter().map(|&cell| labels[cell]).collect(),
            };
        }
        Self { nodes: (1..=nodes.len() as u64).collect(), cells: (1..=cells.len() as u64).collect() }
    }
}

/// The mesh: what a file begins with. The last line of a file is `9999`.
pub fn frd_start<const D: usize>(deck: &Deck, order: &[Vec<usize>; 3], model: &Model<D>) -> String {
    let numbers = Numbers::new(deck, order);
    let mut text = "    1C\n    1UPGM               fmc solve\n".to_owned();
    put(&mut text, format_args!("    2C{:18}{:12}{:37}1\n", "", numbers.nodes.len(), ""));
    let apart = order[2].iter().map(|&node| deck.mesh.points[node]);
    for (x, number) in model.coords().iter().map(in_space).chain(apart).zip(&numbers.nodes) {
        put(&mut text, format_args!(" -1{number:10}{}{}{}\n", real(x[0]), real(x[1]), real(x[2])));
    }
    put(&mut text, format_args!(" -3\n    3C{:18}{:12}{:37}1\n", "", model.cell_count(), ""));
    let mut labels = numbers.cells.iter();
    for number in 0..model.parts().len() {
        for (cell_type, nodes) in model.cells(number) {
            let label = labels.next().copied().unwrap_or(0);
            let Some((kind, places)) = element(cell_type) else { continue };
            put(&mut text, format_args!(" -1{label:10}{kind:5}{:5}{:>5}\n", 0, number + 1));
            for row in places.chunks(if places.len() == 20 { 10 } else { 15 }) {
                text.push_str(" -2");
                row.iter().for_each(|&place| {
                    put(&mut text, format_args!("{:10}", numbers.nodes[nodes[place] as usize]));
                });
                text.push('\n');
            }
        }
    }
    text.push_str(" -3\n");
    text
}

/// Results of a step: `DISP`, `STRESS`, `CONTACT`, which holds the pressure alone, and `FORC`, what holds the nodes. Reference nodes that belong to
/// no element come last, with the stress 0.
pub fn frd_step<const D: usize>(
    deck: &Deck,
    order: &[Vec<usize>; 3],
    at: &Equilibrium<D>,
    step: &StepResult,
) -> String {
    let (number, time) = (step.number, step.time);
    let nodes = Numbers::new(deck, order).nodes;
    let mut text = String::new();
    let apart = step.references.iter().filter(|reference| reference.own.is_none());
    let of_bodies = at.displacement().iter().map(in_space);
    let displacements: Vec<Vec<f64>> =
        of_bodies.chain(apart.map(|reference| reference.displacement)).map(|u| u.to_vec()).collect();
    let rows = vector_rows(["D1", "D2", "D3"]);
    block(&mut text, "DISP", (number, time), (4, &rows), &nodes, &displacements);
    let rows: Vec<String> = [("SXX", 1, 1), ("SYY", 2, 2), ("SZZ", 3, 3), ("SXY", 1, 2), ("SYZ", 2, 3), ("SZX", 3, 1)]
        .iter()
        .map(|(name, i, j)| format!(" -5  {name:8}    1    4    {i}    {j}"))
        .collect();
    let values: Vec<Vec<f64>> = filled(stresses(at).into_iter().map(|stress| stress.0.to_vec()), nodes.len(), 6);
    block(&mut text, "STRESS", (number, time), (6, &rows), &nodes, &values);
    let rows = [format!(" -5  {:8}    1    1    0    0", "CPRESS")];
    let values: Vec<Vec<f64>> = filled(pressures(at).into_iter().map(|pressure| vec![pressure]), nodes.len(), 1);
    block(&mut text, "CONTACT", (number, time), (1, &rows), &nodes, &values);
    let rows = vector_rows(["F1", "F2", "F3"]);
    let values: Vec<Vec<f64>> = step.reactions.iter().map(|force| force.to_vec()).collect();
    block(&mut text, "FORC", (number, time), (4, &rows), &nodes, &values);
    text
}

/// Values, with zeros behind them up to `count`.
fn filled(values: impl Iterator<Item = Vec<f64>>, count: usize, size: usize) -> Vec<Vec<f64>> {
    let mut all: Vec<Vec<f64>> = values.collect();
    all.resize(count, vec![0.0; size]);
    all
}

/// Rows of the components of a vector.
fn vector_rows(names: [&str; 3]) -> Vec<String> {
    let components = names.iter().enumerate();
    components.map(|(k, name)| format!(" -5  {name:8}    1    2    {}    0", k + 1)).chain([all()]).collect()
}

/// The length of the vector, which readers compute.
fn all() -> String {
    format!(" -5  {:8}    1    2    0    0    1ALL", "ALL")
}

fn block(
    text: &mut String,
    name: &str,
    (step, time): (usize, f64),
    (count, rows): (usize, &[String]),
    nodes: &[u64],
    values: &[Vec<f64>],
) {
    put(text, format_args!("    1PSTEP{:26}{:12}{:12}\n", step, 1, step));
    put(
        text,
        format_args!(
            "  100CL  {:3}{:12}{:12}{:20}{:2}{:5}{:10}{:2}\n",
            100 + step,
            real(time),
            nodes.len(),
            "",
            0,
            step,
            "",
            1
        ),
    );
    put(text, format_args!(" -4  {name:8}{count:5}    1\n"));
    rows.iter().for_each(|row| put(text, format_args!("{row}\n")));
    for (node, values) in nodes.iter().zip(values) {
        put(text, format_args!(" -1{node:10}"));
        values.iter().for_each(|value| text.push_str(&real(*value)));
        text.push('\n');
    }
    text.push_str(" -3\n");
}

/// A number in twelve columns, as C's `%12.5E`: two digits of the exponent. Beyond what these hold it is 0 or the largest.
pub(super) fn real(value: f64) -> String {
    let value = if value.abs() < 1e-99 { 0.0 } else { value.clamp(-9.99999e99, 9.99999e99) };
    let text = format!("{value:.5E}");
    let (digits, exponent) = text.split_once('E').unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{:>12}", format!("{digits}E{sign}{:02}", exponent.abs()))
}

fn put(text: &mut String, arguments: std::fmt::Arguments) {
    text.write_fmt(arguments).expect("writing into a string");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_take_twelve_columns() {
        for (value, text) in
            [(0.0, " 0.00000E+00"), (-1.5, "-1.50000E+00"), (1e-120, " 0.00000E+00"), (2e99, " 2.00000E+99")]
        {
            assert_eq!(real(value), text);
        }
        assert_eq!(real(-1e300).len(), 12);
    }
}
