//! The fibers of an equilibrium over the deformed mesh, about the contact: the paper's figures of the sampling region.

use crate::report::drawing::{Dot, Drawing, Fields, Patch, Stroke, View};
use crate::report::record::{Picture, PictureKind};
use anyhow::Result;
use fmc_contact::overlap::FiberTrace;
use fmc_mesh_io::read_fibers;
use std::path::Path;

/// Fibers that are drawn, at most: more would cover the mesh.
const MOST: usize = 90;
/// Longer side, pixels.
const LONGEST: f64 = 960.0;

/// How far lines are drawn beyond their crossings, by the side of the picture.
const MARGIN: f64 = 0.05;

const BODY: [u8; 4] = [226, 232, 238, 255];
const EDGE: [u8; 4] = [150, 160, 172, 255];
const FIBER: [u8; 4] = [60, 110, 170, 150];
const STRETCH: [u8; 4] = [214, 94, 0, 255];
const CROSSING: [u8; 4] = [170, 20, 30, 255];

/// Draws `fibers.png` from `fibers.vtu` in the folder of a run; `None` where the run has left none. `behind` are the rigid
/// partners.
pub(super) fn draw(view: View, fields: &Fields, behind: Vec<Patch>, folder: &Path) -> Result<Option<Picture>> {
    let file = folder.join("fibers.vtu");
    if !file.is_file() {
        return Ok(None);
    }
    let all = read_fibers(&file)?;
    let shown = all.len().min(MOST);
    let traces: Vec<&FiberTrace<3>> = (0..shown).map(|number| &all[number * all.len() / shown]).collect();
    let Some(frame) = around(all.iter().flat_map(|trace| &trace.crossings).map(|x| view.place(x))) else {
        return Ok(None);
    };
    let line = |ends: [&[f64; 3]; 2], color, width| Stroke { ends: ends.map(|x| view.place(x)), color, width };
    let margin = MARGIN * (frame[1][0] - frame[0][0]);
    let mut strokes: Vec<Stroke> = (traces.iter())
        .filter_map(|trace| beside(trace, margin))
        .map(|ends| line([&ends[0], &ends[1]], FIBER, 1.0))
        .collect();
    let stretches = traces.iter().flat_map(|trace| trace.crossings.as_chunks::<2>().0);
    strokes.extend(stretches.map(|[from, to]| line([from, to], STRETCH, 2.6)));
    let crossings = traces.iter().flat_map(|trace| &trace.crossings);
    let dots = crossings.map(|x| Dot { at: view.place(x), color: CROSSING, radius: 3.2 }).collect();
    let mut patches = behind;
    // In space one looks through the body.
    let body = if matches!(view, View::Plane) { BODY } else { [BODY[0], BODY[1], BODY[2], 110] };
    patches.extend(view.patches(&fields.points, &fields.cells, |_| body, |_| EDGE));
    Drawing { patches, strokes, dots }.write(&folder.join("fibers.png"), frame, LONGEST)?;
    let caption = format!(
        "{shown} of the {} lines through the contact, in orange their parts inside both bodies, in red where they \
         enter and leave",
        all.len()
    );
    Ok(Some(Picture { file: "fibers.png".into(), caption, kind: PictureKind::Bodies }))
}

/// Ends of a fiber, `margin` before its first crossing and behind its last.
fn beside(trace: &FiberTrace<3>, margin: f64) -> Option<[[f64; 3]; 2]> {
    let (first, last) = (trace.crossings.first()?, trace.crossings.last()?);
    let step = |axis: usize| trace.end[axis] - trace.start[axis];
    let length = (0..3).map(|axis| step(axis).powi(2)).sum::<f64>().sqrt();
    let by = |axis: usize| margin * step(axis) / length;
    Some([std::array::from_fn(|axis| first[axis] - by(axis)), std::array::from_fn(|axis| last[axis] + by(axis))])
}

/// Square around points, with a margin; `None` around nothing.
fn around(points: impl Iterator<Item = [f64; 2]>) -> Option<[[f64; 2]; 2]> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in points {
        low = [0, 1].map(|axis| low[axis].min(point[axis]));
        high = [0, 1].map(|axis| high[axis].max(point[axis]));
    }
    let half = 0.65 * (high[0] - low[0]).max(high[1] - low[1]);
    let center = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
    (half > 0.0).then(|| [center.map(|x| x - half), center.map(|x| x + half)])
}
