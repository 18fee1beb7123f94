//! Every case for a while, and what its figures must already be.

use super::{Folder, document, finish};
use fmc_benchmarks::case::Document;
use fmc_shapes::Mesh;
use fmc_solid::fem::Part;

/// The bar is short enough to be run whole: every check of its file holds, with both estimators.
#[test]
fn bar_meets_its_closed_form() {
    for (case, estimator) in [("bar", "exact"), ("bar", "fibers"), ("bar3d", "fibers")] {
        let folder = Folder::new(&format!("{case}-{estimator}"));
        let summary =
            finish(&document(case, &[&format!("contact.estimator={estimator}"), "output.frames=0"]), &folder.0);
        assert_eq!(summary.checks.len(), 6, "{case}, {estimator}");
        assert!(summary.is_ok(), "{case}, {estimator}: {:#?}", summary.checks);
    }
}

/// Two equal blocks: the one that moves stops.
#[test]
fn blocks_exchange_their_momentum() {
    let folder = Folder::new("blocks");
    let mut document = document("blocks3d", &["output.frames=0"]);
    document.choose("coarse").unwrap();
    let summary = finish(&document, &folder.0);
    assert_eq!(summary.checks.len(), 5);
    assert!(summary.is_ok(), "{:#?}", summary.checks);
}

/// One energy for the whole overlap: k or nothing. The pressure that jumps between 0 and k and has the mean ρ c v0 = 300
/// has the rms √(k/300 − 1): 0, 32 % and 153 % for k = 300, 330 and 1000.
#[test]
fn volume_law_chatters_as_its_two_values_must() {
    for (variant, k) in [("volume-300", 300f64), ("volume", 330.0), ("volume-1000", 1000.0)] {
        let folder = Folder::new(variant);
        let mut document = document("bar", &["output.frames=0"]);
        document.choose(variant).unwrap();
        let summary = finish(&document, &folder.0);
        assert!(summary.checks.is_empty());
        let figure = |name| summary.figure(name).unwrap();
        // The mean over a time that holds no whole number of jumps is off by up to one step of k in 0.6 s.
        assert!((figure("pressure_mean") / 300.0 - 1.0).abs() < 0.01, "{variant}: {}", figure("pressure_mean"));
        let rms = (k / 300.0 - 1.0).sqrt();
        assert!((figure("pressure_rms") - rms).abs() < 0.01, "{variant}: {} {rms}", figure("pressure_rms"));
        // What the jumps do to the energy hangs on when within a step the bar touches; it is never little.
        assert!(k < 310.0 || figure("energy_error_max") > 0.05);
    }
}

/// By the depth below both surfaces the star is whole in a second, and one evaluation a step keeps its energy to 1e-5; the
/// blocks are the coarse ones.
#[test]
fn impacts_by_depth_keep_their_energy() {
    for (case, variant, checks) in [("star", "depth", 5), ("star", "depth-soft", 5), ("blocks3d", "depth-coarse", 5)] {
        let folder = Folder::new(&format!("{case}-{variant}"));
        let mut document = document(case, &["output.frames=0", "output.animation=false"]);
        document.choose(variant).unwrap();
        let summary = finish(&document, &folder.0);
        assert_eq!((summary.checks.len(), summary.contact_substeps), (checks, 1), "{case}, {variant}");
        assert!(summary.is_ok(), "{case}, {variant}: {:#?}", summary.checks);
    }
}

/// Until the tip has sunk in, nothing tells the star from the diamond but its tip; both gain speed upwards and keep
/// action and reaction equal.
#[test]
fn impacts_start_as_they_must() {
    for (case, estimator, mass) in [("star", "exact", 8.570), ("star", "fibers", 8.570), ("diamond", "exact", 20.2)] {
        let folder = Folder::new(&format!("short-{case}-{estimator}"));
        let changes =
            [&format!("contact.estimator={estimator}"), "time.step=3.889e-6", "time.end=9e-4", "output.frames=2"];
        let summary = finish(&document(case, &changes), &folder.0);
        assert_eq!(summary.iterations, 232);
        // The gap of 2 mm is closed after 40 µs at 50 m/s, at the eleventh step.
        assert!((summary.figure("contact_start").unwrap() - 11.0 * 3.889e-6).abs() < 1e-12);
        assert!(summary.figure("balance_max").unwrap() < 1e-12);
        // Momentum: the impulse is what the body has lost of m v0.
        let gained = mass * (summary.figure("rebound").unwrap() + 50.0);
        let impulse = summary.figure("impulse").unwrap();
        assert!((gained / impulse - 1.0).abs() < 1e-3, "{case}: {gained} {impulse}");
        assert!(summary.figure("energy_drift").unwrap() < 0.01);
        // A case that was changed is not judged by what the unchanged one should be.
        assert!(summary.checks.is_empty(), "{:?}", summary.checks);
    }
}

/// Checks apply to the case they are about, whatever it is changed to.
#[test]
fn checks_apply_where_they_were_made_for() {
    let count = |changes: &[&str], variant: Option<&str>| {
        let mut document = Document::open("star").unwrap();
        variant.iter().for_each(|name| document.choose(name).unwrap());
        changes.iter().for_each(|change| document.override_with("--override", change).unwrap());
        let case = document.case().unwrap();
        let effective = toml::Table::try_from(&case).unwrap();
        let applies = |figure: &str| {
            let of_figure =
                case.expected.iter().filter(|expected| expected.figure == figure && expected.tolerance().is_some());
            of_figure.filter(|e| e.applies(&effective, document.variant.as_deref(), &document.changes)).count()
        };
        (applies("impulse"), applies("energy_drift"), applies("balance_max"))
    };
    assert_eq!(count(&[], None), (1, 1, 1));
    assert_eq!(count(&["contact.seed=3", "output.frames=1"], None), (1, 1, 1));
    assert_eq!(count(&["time.step=1.9445e-6"], None), (1, 1, 1));
    assert_eq!(count(&["time.step=2e-6"], None), (0, 0, 0));
    assert_eq!(count(&["contact.estimator=fibers"], None), (0, 0, 1));
    assert_eq!(count(&["bodies.star.material.young=1e6"], None), (0, 0, 0));
    assert_eq!(count(&[], Some("smooth")), (1, 1, 1));
    assert_eq!(count(&["time.step=1.9445e-6"], Some("smooth-lines")), (1, 0, 1));
    // What changes nothing is no change.
    assert_eq!(count(&["contact.exponent=1.0"], None), (1, 1, 1));
}

/// The case file's geometry, against areas by hand: star 4·outer·inner·sin 45°·2, diamond (0.1 √2)².
#[test]
fn bodies_have_the_mass_of_the_case() {
    let mass = |case: &str| {
        let case = Document::open(case).unwrap().case().unwrap();
        let parts: Vec<Part<2>> = case.parts(std::path::Path::new("")).unwrap();
        parts[0].mesh.measure() * parts[0].material.density
    };
    let star = 8.0 * 0.5 * 0.1 * 0.03 * 0.5f64.sqrt() * 1010.0;
    assert!((mass("star") / star - 1.0).abs() < 1e-12 && (star - 8.570).abs() < 1e-3);
    assert!((mass("diamond") / (0.02 * 1010.0) - 1.0).abs() < 1e-12);
}

/// A mesh file with a physical group becomes a body, turned and moved.
#[test]
fn mesh_files_become_bodies() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    let text = include_str!("../../cases/star.toml").replace(
        "mesh = { shape = \"star\", cell = \"quad4\", tips = 4, outer = 0.1, inner = 0.03, side_edges = 12, half_width = 2 }",
        "mesh = { shape = \"file\", path = \"star.msh\" }\nrotation = 90.0\nposition = [0.0, 0.5]",
    );
    let case = Document::parse("my", "my.toml", &folder, &text).unwrap().case().unwrap();
    let turned: Vec<Part<2>> = case.parts(&folder).unwrap();
    let plain = fmc_mesh_io::Mesh::read(&folder.join("star.msh")).unwrap();
    assert_eq!(turned[0].mesh.cell_count(), plain.cell_count());
    let measure = |mesh: &Mesh<2>| mesh.measure();
    assert!(measure(&turned[0].mesh) > 0.0);
    let highest = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
    let top = highest(&mut turned[0].mesh.coords.iter().map(|x| x[1]));
    let right = highest(&mut plain.points.iter().map(|x| x[0]));
    assert!((top - right - 0.5).abs() < 1e-12);
}
