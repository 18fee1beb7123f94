//! What a run leaves can be read, and an interruption leaves no trace.

use super::{Folder, carry_out, document, finish};
use fmc_benchmarks::run::{Ending, RunOptions, run};
use fmc_mesh_io as mesh;
use std::ops::ControlFlow;
use std::path::Path;

const CHANGES: [&str; 3] = ["time.step=3.889e-6", "time.end=1.2e-3", "output.frames=6"];

/// Fields as ParaView finds them: from the list to the arrays, with numbers that fit those of the history.
#[test]
fn fields_hold_what_the_history_says() {
    let folder = Folder::new("fields");
    finish(&document("star", &CHANGES), &folder.0);
    let text = folder.text("fields.pvd");
    let list = roxmltree::Document::parse(&text).unwrap();
    let sets: Vec<_> = list.descendants().filter(|node| node.has_tag_name("DataSet")).collect();
    assert_eq!(sets.len(), 7);
    let history = folder.text("history.csv");
    let names: Vec<&str> = history.lines().next().unwrap().split(',').collect();
    let column = |name: &str| names.iter().position(|other| *other == name).unwrap();
    for set in sets {
        let file = folder.0.join(set.attribute("file").unwrap());
        let time: f64 = set.attribute("timestep").unwrap().parse().unwrap();
        let row = history.lines().skip(1).find(|row| row.split(',').nth(1).unwrap().parse() == Ok(time)).unwrap();
        let value = |name: &str| -> f64 { row.split(',').nth(column(name)).unwrap().parse().unwrap() };
        let grid = mesh::Mesh::read(&file).unwrap();
        assert_eq!((grid.points.len(), grid.cell_count()), (241 + 1020, 192 + 950));
        let forces = mesh::read_floats(&file, "contact_force").unwrap();
        let on_star: f64 = forces.chunks_exact(3).take(241).map(|force| force[1]).sum();
        let scale: f64 = forces.iter().map(|force| force.abs()).sum();
        assert!((on_star - value("force_star_y")).abs() <= 1e-12 * scale);
        let counts = [("displacement", 3 * 1261), ("velocity", 3 * 1261), ("stress", 6 * 1142), ("von_mises", 1142)];
        for (name, count) in counts {
            assert_eq!(mesh::read_floats(&file, name).unwrap().len(), count, "{name}");
        }
        let groups: Vec<_> = grid.cells().map(|cell| cell.3).collect();
        assert!(groups[..192].iter().all(|body| *body == Some(0)) && groups[192..].iter().all(|body| *body == Some(1)));
        assert!(mesh::read_floats(&file, "pressure").is_err());
        let total = ["kinetic", "strain", "contact", "external"].map(value).iter().sum::<f64>();
        assert!((total / value("total") - 1.0).abs() < 1e-12);
    }
}

/// Pictures show more than an empty sheet, and the animation has a frame for every field.
#[test]
fn pictures_are_not_empty() {
    let folder = Folder::new("pictures");
    finish(&document("star", &CHANGES), &folder.0);
    for name in ["energies", "forces"] {
        let svg = folder.text(&format!("{name}.svg"));
        let picture = roxmltree::Document::parse(&svg).unwrap();
        let curves = picture.descendants().filter(|node| node.has_tag_name("polyline"));
        // A curve has a point per step; ticks and grid lines have two.
        let long = curves.filter(|curve| curve.attribute("points").unwrap().split(' ').count() > 300).count();
        assert_eq!(long, if name == "energies" { 4 } else { 2 }, "{name}");
        let png = std::fs::read(folder.0.join(format!("{name}.png"))).unwrap();
        assert!(png.starts_with(b"\x89PNG") && png.len() > 20_000);
    }
    let file = std::fs::File::open(folder.0.join("animation.gif")).unwrap();
    let mut decoder = gif::DecodeOptions::new().read_info(file).unwrap();
    let (mut frames, mut changed) = (0, 0);
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        frames += 1;
        changed += usize::from(frame.width > 100 && frame.height > 100);
    }
    assert_eq!((frames, changed), (7, 7));
}

/// A run that is interrupted and resumed, even twice and on another number of threads, leaves the same bytes in every
/// file but for its seconds.
#[test]
fn an_interruption_leaves_no_trace() {
    let (whole, torn) = (Folder::new("whole"), Folder::new("torn"));
    let document = document("star", &CHANGES);
    finish(&document, &whole.0);
    let stop_at = |step: u64| {
        move |progress: &fmc_benchmarks::run::Progress| {
            if progress.step == step { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }
    };
    let first = carry_out(&document, &torn.0, (1, false), &mut stop_at(77));
    assert!(matches!(first, Ending::Interrupted { step: 77, .. }));
    // What was computed can be read before it is gone on with.
    assert_eq!(torn.text("history.csv").lines().count(), 79);
    assert!(roxmltree::Document::parse(&torn.text("fields.pvd")).is_ok() && torn.0.join("forces.png").exists());
    assert!(!torn.0.join("summary.json").exists());
    let second = carry_out(&document, &torn.0, (2, true), &mut stop_at(200));
    assert!(matches!(second, Ending::Interrupted { step: 200, .. }));
    // A line that was cut off, as by a crash.
    let history = torn.text("history.csv");
    std::fs::write(torn.0.join("history.csv"), history + "201,0.0007").unwrap();
    let last = carry_out(&document, &torn.0, (1, true), &mut |_| ControlFlow::Continue(()));
    assert!(matches!(last, Ending::Finished(_)));
    assert_eq!(names(&whole.0), names(&torn.0));
    for name in names(&whole.0) {
        let bytes = [&whole, &torn].map(|folder| std::fs::read(folder.0.join(&name)).unwrap());
        if name != "summary.json" {
            assert!(bytes[0] == bytes[1], "{name}");
        }
    }
    let summaries = [&whole, &torn].map(|folder| {
        let mut summary: serde_json::Value = serde_json::from_str(&folder.text("summary.json")).unwrap();
        summary["seconds"].take();
        summary["contact_seconds"].take();
        summary
    });
    assert_eq!(summaries[0], summaries[1]);
}

/// A run that is at its end is not made again, and says so; its files stay as they are.
#[test]
fn a_finished_run_is_not_resumed() {
    let folder = Folder::new("finished");
    let short = document("star", &["time.end=4e-4", "output.frames=3", "output.animation=false"]);
    let first = finish(&short, &folder.0);
    let content =
        || names(&folder.0).iter().map(|name| std::fs::read(folder.0.join(name)).unwrap()).collect::<Vec<_>>();
    let before = content();
    let again = carry_out(&short, &folder.0, (1, true), &mut |_| panic!("no step is left"));
    let Ending::FinishedBefore(summary) = again else { panic!("{again:?}") };
    assert_eq!(*summary, first);
    assert!(content() == before);
    // Another case is not taken for it.
    let other = document("star", &["time.end=4e-4", "bodies.star.material.young=1e6"]);
    let options = RunOptions { out: folder.0.clone(), threads: 1, resume: true };
    let refused = run(&other, &other.case().unwrap(), &options, &mut |_| ControlFlow::Continue(())).unwrap_err();
    assert!(format!("{refused:#}").contains("another"), "{refused:#}");
}

/// Files of a folder and of its `fields`, sorted.
fn names(folder: &Path) -> Vec<String> {
    let inside = |folder: &Path, before: &str| -> Vec<String> {
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
        let files = entries.filter(|entry| entry.path().is_file());
        files.map(|entry| format!("{before}{}", entry.file_name().to_string_lossy())).collect()
    };
    let mut names = [inside(folder, ""), inside(&folder.join("fields"), "fields/")].concat();
    names.sort();
    names
}

/// A second run in the same folder leaves nothing of the first.
#[test]
fn nothing_of_an_earlier_run_is_left() {
    let folder = Folder::new("twice");
    let short = ["time.end=4e-4", "output.frames=9"];
    finish(&document("star", &short), &folder.0);
    assert_eq!(names(&folder.0).iter().filter(|name| name.starts_with("fields/")).count(), 10);
    finish(&document("star", &["time.end=4e-4", "output.frames=3", "output.animation=false"]), &folder.0);
    assert_eq!(names(&folder.0).iter().filter(|name| name.starts_with("fields/")).count(), 4);
    assert!(!folder.0.join("animation.gif").exists());
}

/// The keys that every host prints.
#[test]
fn summary_has_the_keys_of_every_host() {
    let folder = Folder::new("summary");
    finish(&document("bar", &["output.frames=0"]), &folder.0);
    let summary: serde_json::Value = serde_json::from_str(&folder.text("summary.json")).unwrap();
    for key in [
        "case",
        "host",
        "estimator",
        "law",
        "figures",
        "checks",
        "iterations",
        "seconds",
        "contact_seconds",
        "crossings",
    ] {
        assert!(!summary[key].is_null(), "{key}");
    }
    let figures =
        ["pressure_mean", "pressure_rms", "contact_start", "contact_end", "exit_velocity", "energy_error_max"];
    assert!(figures.iter().all(|name| summary["figures"][name].is_number()));
    for check in summary["checks"].as_array().unwrap() {
        assert!(check["name"].is_string() && check["ok"].is_boolean());
        assert!(["value", "reference", "tolerance"].iter().all(|key| check[key].is_number()));
    }
}
