//! Pictures of a run: the deformed bodies, and the charts that the run has drawn itself.

mod fibers;

use crate::case::Case;
use crate::chart::{self, Axis, Mark, Panel, Series};
use crate::report::drawing::{Drawing, Fields, Patch, View, brightest, darker, opaque, outline};
use crate::report::record::{Picture, PictureKind};
use crate::run::Summary;
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// Snapshots of a motion or of a series of load steps, at most.
const MOST_SNAPSHOTS: usize = 6;
/// Longer side of a picture and of a snapshot, pixels: sharp on a telephone's screen and in print.
const LONGEST: f64 = 960.0;
const LONGEST_SNAPSHOT: f64 = 480.0;
/// Where bodies in space are looked at from.
const CAMERA: [f64; 3] = [1.0, -1.7, 0.8];
/// Rigid partners.
const RIGID: [u8; 4] = [206, 206, 204, 255];

/// Charts that a run may have drawn, in the order of the page, and what they show; others go by the name of their file.
const CHARTS: [(&str, &str); 6] = [
    ("energies", "Energies over time"),
    ("forces", "Contact forces over time"),
    ("pressure", "Pressure on the contact surface"),
    ("profile", "Deformed surface"),
    ("reactions", "Contact force over the load steps"),
    ("newton", "Residual over the iterations, by the largest of the forces’ norms"),
];

/// Draws what there is to draw in the folder of a run; also the largest value of the colour scale, Pa.
pub(super) fn draw(
    summary: &Summary,
    case: &Case,
    camera: Option<[f64; 3]>,
    folder: &Path,
) -> Result<(Vec<Picture>, Option<f64>)> {
    let (mut pictures, top) = bodies(case, camera, folder)?;
    // Of one variant it is much like of another, and large.
    if summary.variant.is_none() && folder.join("animation.gif").is_file() {
        let caption = "The whole motion, coloured by von Mises stress".into();
        pictures.push(Picture { file: "animation.gif".into(), caption, kind: PictureKind::Bodies });
    }
    if summary.residuals.len() > 1 {
        newton(&summary.residuals, folder)?;
    }
    let mut charts: Vec<String> = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| format!("{} cannot be read", folder.display()))? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        charts.extend(name.strip_suffix(".svg").map(str::to_owned));
    }
    let rank = |name: &String| CHARTS.iter().position(|(known, _)| known == name).unwrap_or(CHARTS.len());
    charts.sort_by_key(|name| (rank(name), name.clone()));
    pictures.extend(charts.iter().map(|name| {
        let known = CHARTS.iter().find(|(known, _)| known == name);
        let caption = known.map_or_else(|| name.replace(['_', '-'], " "), |(_, caption)| (*caption).to_owned());
        Picture { file: format!("{name}.svg"), caption, kind: PictureKind::Chart }
    }));
    Ok((pictures, top))
}

/// The bodies as the run left them: snapshots of a series, and the equilibrium, also about its contact where that is small.
fn bodies(case: &Case, camera: Option<[f64; 3]>, folder: &Path) -> Result<(Vec<Picture>, Option<f64>)> {
    let mut series = snapshots(&folder.join("fields.pvd"))?;
    let at_rest = folder.join("equilibrium.vtu");
    let is_static = at_rest.is_file();
    if is_static {
        // What few load steps there are is seen in their last.
        series = if series.len() < 3 { Vec::new() } else { series };
        series.push((0.0, at_rest));
    }
    let fields: Vec<(f64, Fields)> =
        series.iter().map(|(time, file)| Ok((*time, Fields::read(file)?))).collect::<Result<_>>()?;
    if fields.is_empty() {
        return Ok((Vec::new(), None));
    }
    let top = brightest(fields.iter().flat_map(|(_, fields)| fields.cells.iter().map(|cell| cell.value)));
    let view = if case.dimension == 2 { View::Plane } else { View::Space(camera.unwrap_or(CAMERA)) };
    let drawings: Vec<Drawing> = fields.iter().map(|(_, fields)| drawing(view, fields, top)).collect();
    // All show the same part of the plane, so that motion is seen.
    let frames: Vec<[[f64; 2]; 2]> = drawings.iter().map(Drawing::frame).collect();
    let pick = |of: fn(f64, f64) -> f64, end: usize| {
        [0, 1].map(|axis| frames.iter().map(|frame| frame[end][axis]).reduce(of).unwrap_or_default())
    };
    let frame = [pick(f64::min, 0), pick(f64::max, 1)];
    let mut pictures = Vec::new();
    for (number, (mut drawing, (time, fields))) in drawings.into_iter().zip(&fields).enumerate() {
        if matches!(view, View::Plane) {
            drawing.patches.splice(0..0, rigid(case, frame));
        }
        let is_last = number + 1 == series.len();
        if !(is_static && is_last) {
            let file = format!("snapshot-{number}.png");
            drawing.write(&folder.join(&file), frame, LONGEST_SNAPSHOT)?;
            let caption = if is_static { format!("load step {time}") } else { moment(*time) };
            pictures.push(Picture { file, caption, kind: PictureKind::Snapshot });
            continue;
        }
        drawing.write(&folder.join("bodies.png"), frame, LONGEST)?;
        let caption = "The deformed mesh, coloured by von Mises stress".into();
        pictures.push(Picture { file: "bodies.png".into(), caption, kind: PictureKind::Bodies });
        if let Some(detail) = fields.detail().filter(|_| matches!(view, View::Plane)) {
            drawing.write(&folder.join("detail.png"), detail, LONGEST)?;
            let caption = "The same about the contact".into();
            pictures.push(Picture { file: "detail.png".into(), caption, kind: PictureKind::Bodies });
        }
        let about = matches!(view, View::Plane).then(|| rigid(case, frame)).unwrap_or_default();
        pictures.extend(fibers::draw(view, fields, about, folder)?);
    }
    Ok((pictures, Some(top)))
}

fn drawing(view: View, fields: &Fields, top: f64) -> Drawing {
    let color = |cell: usize| opaque(fields.cells[cell].value / top);
    Drawing { patches: view.patches(&fields.points, &fields.cells, color, darker), ..Drawing::default() }
}

/// Rigid partners of a case in the plane.
fn rigid(case: &Case, [low, high]: [[f64; 2]; 2]) -> Vec<Patch> {
    let reach = 4.0 * (high[0] - low[0]).max(high[1] - low[1]);
    let built = case.obstacles.iter().filter_map(|obstacle| obstacle.build::<2>());
    let outlines = built.flat_map(|obstacle| outline(&obstacle, reach));
    outlines.map(|corners| Patch { corners, fill: RIGID, edge: darker(darker(RIGID)) }).collect()
}

/// Times and files of some of the frames that a list for ParaView names, evenly spaced, the first and the last among them;
/// none if there is no list.
fn snapshots(list: &Path) -> Result<Vec<(f64, PathBuf)>> {
    let Ok(text) = fs::read_to_string(list) else { return Ok(Vec::new()) };
    let folder = list.parent().unwrap_or(Path::new(""));
    let document = roxmltree::Document::parse(&text).with_context(|| format!("{} is damaged", list.display()))?;
    let frames: Vec<(f64, PathBuf)> = (document.descendants())
        .filter(|node| node.has_tag_name("DataSet"))
        .filter_map(|node| Some((node.attribute("timestep")?.parse().ok()?, folder.join(node.attribute("file")?))))
        .collect();
    let count = frames.len().min(MOST_SNAPSHOTS);
    let chosen = (0..count).map(|k| frames[k * (frames.len() - 1) / (count - 1).max(1)].clone());
    Ok(chosen.collect())
}

/// A time that is easy to read.
fn moment(time: f64) -> String {
    match time {
        0.0 => "start".into(),
        t if t < 1e-4 => format!("{:.1} µs", 1e6 * t),
        t if t < 0.1 => format!("{:.2} ms", 1e3 * t),
        t => format!("{t:.2} s"),
    }
}

/// Residuals as a chart, `newton.svg`.
fn newton(residuals: &[f64], folder: &Path) -> Result<()> {
    let points = residuals.iter().enumerate().filter(|(_, residual)| **residual > 0.0);
    let points = points.map(|(number, residual)| (number as f64, *residual)).collect();
    let series = Series { mark: Mark::LineAndPoints, ..Series::line("residual", (0, 114, 178), points) };
    let panel = Panel { x: Axis::linear("iteration"), y: Axis::log("residual"), series: vec![series] };
    chart::draw(folder, "newton", "Convergence", &[panel])
}
