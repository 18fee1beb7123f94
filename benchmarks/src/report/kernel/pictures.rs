//! What is measured: both bodies, and the stretches of some fibers inside both.

use crate::report::drawing::{Cell, Drawing, Stroke, View};
use crate::report::record::{Picture, PictureKind};
use crate::verify::{self, Sketch};
use anyhow::Result;
use std::path::Path;

/// Colours of the bodies, translucent in space, where one stands in the other; and of the stretches.
const BODIES: [[u8; 3]; 2] = [[120, 170, 214], [222, 212, 190]];
const SPAN: [u8; 4] = [214, 94, 0, 235];
const LONGEST: f64 = 900.0;

/// Draws a kernel check at one θ.
pub(super) fn draw(name: &str, folder: &Path) -> Result<Vec<Picture>> {
    let Sketch { dimension, points, cells, spans } = verify::sketch(name)?;
    let bodies: Vec<usize> = cells.iter().map(|(.., body)| *body).collect();
    let cells: Vec<Cell> =
        cells.into_iter().map(|(cell_type, nodes, _)| Cell { cell_type, nodes, value: 0.0 }).collect();
    let (view, opacity, edge) = match dimension {
        2 => (View::Plane, 150, 60),
        _ => (View::Space([1.0, -1.7, 0.9]), 70, 70),
    };
    let fill = |cell: usize| {
        let [r, g, b] = BODIES[bodies[cell] % BODIES.len()];
        [r, g, b, opacity]
    };
    let patches = view.patches(&points, &cells, fill, |_| [60, 70, 85, edge]);
    let strokes =
        spans.iter().map(|ends| Stroke { ends: [0, 1].map(|k| view.place(&ends[k])), color: SPAN, width: 2.4 });
    let drawing = Drawing { patches, strokes: strokes.collect(), ..Drawing::default() };
    drawing.write(&folder.join("bodies.png"), drawing.frame(), LONGEST)?;
    let caption = "Both bodies, and in orange the parts of some fibers inside both".into();
    Ok(vec![Picture { file: "bodies.png".into(), caption, kind: PictureKind::Bodies }])
}
