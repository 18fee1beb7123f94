//! `picture.svg`: the bodies with the contact forces, to be opened in any browser; on the left all of it, on the right the contact.

mod faces;

use super::assembly::Assembly;
use super::division::Division;
use faces::{Face, faces, flat};
use std::fmt::Write;

/// Pixels of a side of either panel.
const SIDE: f64 = 520.0;
const MARGIN: f64 = 16.0;
/// Faces, at most, of which a browser makes a picture without delay.
const MOST_FACES: usize = 60_000;
/// Of bodies, in turn.
const COLOURS: [&str; 6] = ["#7aa6d8", "#e8b26a", "#8fc58f", "#c99ad1", "#d98c8c", "#9fb5b5"];
const ARROW: &str = "#c01818";

/// What a panel shows of the plane.
#[derive(Clone, Copy, Debug)]
struct Window {
    low: [f64; 2],
    high: [f64; 2],
}

impl Window {
    fn around(points: impl Iterator<Item = [f64; 2]>) -> Option<Self> {
        points.filter(|x| x[0].is_finite() && x[1].is_finite()).fold(None, |window, x| {
            let window = window.unwrap_or(Self { low: x, high: x });
            let pick = |axis: usize| (window.low[axis].min(x[axis]), window.high[axis].max(x[axis]));
            let ([left, right], [bottom, top]) = ([pick(0).0, pick(0).1], [pick(1).0, pick(1).1]);
            Some(Self { low: [left, bottom], high: [right, top] })
        })
    }

    fn size(&self) -> f64 {
        (self.high[0] - self.low[0]).max(self.high[1] - self.low[1])
    }

    /// A square about the same middle.
    fn square(&self, size: f64) -> Self {
        let middle = [0, 1].map(|axis| (self.low[axis] + self.high[axis]) / 2.0);
        Self { low: middle.map(|x| x - size / 2.0), high: middle.map(|x| x + size / 2.0) }
    }

    fn pixels(&self, x: [f64; 2]) -> [f64; 2] {
        let scale = SIDE / self.size();
        [(x[0] - self.low[0]) * scale, (self.high[1] - x[1]) * scale]
    }

    fn meets(&self, corners: &[[f64; 2]]) -> bool {
        (0..2).all(|axis| {
            corners.iter().any(|x| x[axis] >= self.low[axis]) && corners.iter().any(|x| x[axis] <= self.high[axis])
        })
    }
}

/// The picture, and why there is none where nothing could be seen.
pub(super) fn picture<const D: usize>(
    assembly: &Assembly<D>,
    division: &Division,
    forces: &[[f64; D]],
) -> Result<String, &'static str> {
    let faces = faces(assembly, division);
    if faces.len() > MOST_FACES {
        return Err("no picture: the meshes are too fine for one; open forces.vtu in ParaView");
    }
    let corners = || faces.iter().flat_map(|face| face.corners.iter().copied());
    let all = Window::around(corners()).filter(|window| window.size() > 0.0);
    let all = all.ok_or("no picture: the meshes have no extent")?;
    let length = |force: &[f64; D]| force.iter().map(|x| x * x).sum::<f64>().sqrt();
    let largest = forces.iter().map(length).fold(0.0, f64::max);
    // Smaller ones are a point of their arrow's head.
    let pushed: Vec<([f64; 2], [f64; 2])> = (assembly.coords.iter().zip(forces))
        .filter(|(_, force)| length(force) > 0.01 * largest)
        .map(|(x, force)| (flat(x), flat(force).map(|f| f / largest)))
        .collect();
    let whole = all.square(1.3 * all.size());
    let contact = Window::around(pushed.iter().map(|(x, _)| *x));
    let contact = contact.map_or(whole, |window| window.square((2.2 * window.size()).max(0.08 * all.size())));
    let [width, height] = [2.0 * SIDE + 3.0 * MARGIN, SIDE + 2.0 * MARGIN + 56.0];
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"15\">\n<title>Contact forces</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
    );
    panel(&mut svg, MARGIN, &whole, &faces, &pushed);
    panel(&mut svg, 2.0 * MARGIN + SIDE, &contact, &faces, &pushed);
    caption(&mut svg, division, largest, D);
    svg += "</svg>\n";
    Ok(svg)
}

fn panel(svg: &mut String, left: f64, window: &Window, faces: &[Face], pushed: &[([f64; 2], [f64; 2])]) {
    let mut line = |text: String| {
        *svg += &text;
        svg.push('\n');
    };
    line(format!("<svg x=\"{left}\" y=\"{MARGIN}\" width=\"{SIDE}\" height=\"{SIDE}\">"));
    line(format!("<rect width=\"{SIDE}\" height=\"{SIDE}\" fill=\"#fafafa\" stroke=\"#999999\"/>"));
    for face in faces.iter().filter(|face| window.meets(&face.corners)) {
        let mut points = String::new();
        for corner in &face.corners {
            let [x, y] = window.pixels(*corner);
            let _ = write!(points, "{x:.1},{y:.1} ");
        }
        let colour = COLOURS[face.body % COLOURS.len()];
        line(format!(
            "<polygon points=\"{}\" fill=\"{colour}\" fill-opacity=\"0.55\" stroke=\"#33445566\" stroke-width=\"0.6\"/>",
            points.trim_end()
        ));
    }
    for (x, force) in pushed {
        let [a, b] = window.pixels(*x);
        // The largest is a fifth of the panel; y points down there.
        let [u, v] = [0.2 * SIDE * force[0], -0.2 * SIDE * force[1]];
        let (p, q) = (a + u, b + v);
        line(format!(
            "<path d=\"M{a:.1} {b:.1}L{p:.1} {q:.1}M{:.1} {:.1}L{p:.1} {q:.1}L{:.1} {:.1}\" fill=\"none\" stroke=\"{ARROW}\" \
             stroke-width=\"1.8\"/>",
            p - 0.2 * u - 0.1 * v,
            q - 0.2 * v + 0.1 * u,
            p - 0.2 * u + 0.1 * v,
            q - 0.2 * v - 0.1 * u
        ));
    }
    line("</svg>".into());
}

fn caption(svg: &mut String, division: &Division, largest: f64, dimension: usize) {
    let base = SIDE + 2.0 * MARGIN + 12.0;
    let unit = if dimension == 2 { "N/m" } else { "N" };
    let said = if largest > 0.0 {
        format!("Arrows: contact forces on nodes, the largest {largest:.3e} {unit}. Right: where they act.")
    } else {
        "No contact forces: nothing overlaps.".to_owned()
    };
    let _ = writeln!(svg, "<text x=\"{MARGIN}\" y=\"{base}\">{said}</text>");
    let mut x = MARGIN;
    for (body, name) in division.names.iter().take(COLOURS.len()).enumerate() {
        let name = name.replace('&', "&amp;").replace('<', "&lt;");
        let _ = writeln!(
            svg,
            "<rect x=\"{x}\" y=\"{}\" width=\"14\" height=\"14\" fill=\"{}\"/><text x=\"{}\" y=\"{}\">{name}</text>",
            base + 14.0,
            COLOURS[body],
            x + 20.0,
            base + 26.0
        );
        x += 44.0 + 8.5 * name.chars().count() as f64;
    }
}
