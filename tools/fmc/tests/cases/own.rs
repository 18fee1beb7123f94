//! A user's own case: a mesh of Gmsh with physical groups, and as few lines as it takes.

use super::Folder;
use std::path::PathBuf;
use std::process::{Command, Output};

/// Two unit squares, one on the other.
const MESH: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"lower\"\n2 2 \"upper\"\n$EndPhysicalNames\n\
    $Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 1 0\n6 1 1 0\n7 1 2 0\n8 0 2 0\n$EndNodes\n\
    $Elements\n2\n1 3 2 1 1 1 2 3 4\n2 3 2 2 2 5 6 7 8\n$EndElements\n";

const CASE: &str = r#"title = "two squares"
dimension = 2
bodies = [
  { name = "lower", mesh = { shape = "file", path = "two.msh", group = "lower" }, material = { law = "linear-elastic", young = 1e5, poisson = 0.0, density = 1.0 } },
  { name = "upper", mesh = { shape = "file", path = "two.msh", group = "upper" }, material = { law = "linear-elastic", young = 1e5, poisson = 0.0, density = 1.0 } },
]
supports = [{ body = "lower", where = { side = "bottom" }, components = ["x", "y"] }, { body = "upper", where = { side = "left" }, components = ["x"] }]
loads = [{ body = "upper", where = { side = "top" }, pressure = 10.0 }]
contact = { law = "depth", stiffness = 1e7, estimator = "exact" }
load_steps = { count = 2 }
"#;

fn run(folder: &Folder, text: &str, arguments: &[&str]) -> (Output, String) {
    std::fs::write(folder.0.join("two.msh"), MESH).unwrap();
    let path: PathBuf = folder.0.join("two.toml");
    std::fs::write(&path, text).unwrap();
    let out = folder.0.join("out");
    let mut command = Command::new(env!("CARGO_BIN_EXE_fmc"));
    let output = command.args(["run", path.to_str().unwrap(), "--out", out.to_str().unwrap()]).args(arguments).output();
    let output = output.unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (output, said)
}

fn figures(output: &Output) -> serde_json::Value {
    serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()
}

/// Force = pressure × width; tolerance 1e-8: residual of the search.
#[test]
fn a_mesh_with_groups_and_ten_lines_run_to_a_result() {
    let folder = Folder::new("own");
    let (output, said) = run(&folder, CASE, &["--json"]);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let found = figures(&output);
    for key in ["force_peak", "force_end"] {
        let force = found["figures"][key].as_f64().unwrap();
        assert!((force / 10.0 - 1.0).abs() < 1e-8, "{key}: {force}");
    }
    // Pressure by stiffness; the ends of the edge press less, over about the penetration.
    let penetration = found["figures"]["penetration_max"].as_f64().unwrap();
    assert!((penetration / 1e-6 - 1.0).abs() < 0.05, "{penetration}");
    assert!(folder.0.join("out/equilibrium.vtu").exists());
}

/// What a set of figures needs is known before the solve; what only the solve shows costs no result.
#[test]
fn figures_that_cannot_be_are_told() {
    let folder = Folder::new("own-figures");
    for (kind, part) in [
        ("driven", "no support moves 'lower' in the first stage"),
        ("hertz", "these figures need a \"graded-half-disc\""),
        ("impact", "\"forces\" suits both"),
    ] {
        let (output, said) = run(&folder, &format!("{CASE}figures = {{ kind = \"{kind}\" }}\n"), &[]);
        assert_eq!(output.status.code(), Some(2), "{kind}: {said}");
        assert!(said.contains("two.toml:11") && said.contains(part), "{kind}: {said}");
    }
    // Pulled off, nothing touches.
    let apart = CASE.replace("pressure = 10.0", "pressure = -10.0").replace(
        "components = [\"x\"] }]",
        "components = [\"x\", \"y\"] }]\nfigures = { kind = \"punch\", body = \"upper\" }",
    );
    let (output, said) = run(&folder, &apart, &["--json"]);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let found = figures(&output);
    assert!(found["figures"]["force"].is_null());
    assert!(found["warnings"].to_string().contains("'upper' touches nothing"), "{found}");
    // Without a support that holds it, no equilibrium is found, and none is reported.
    let (output, said) = run(&folder, &CASE.replace("pressure = 10.0", "pressure = -10.0"), &["--json"]);
    assert!(output.status.code() == Some(2) && output.stdout.is_empty() && said.contains("'upper'"), "{said}");
    let (output, said) = run(&folder, &CASE.replace("count = 2", "count = 2, tolerance = 0.5"), &[]);
    assert!(output.status.code() == Some(2) && said.contains("at most 0.01"), "{said}");
}

/// Fields are spaced by the end of a run: another end would name the times of the old ones wrongly.
#[test]
fn a_run_is_resumed_to_its_own_end() {
    let folder = Folder::new("own-end");
    let out = folder.0.to_str().unwrap();
    let bar = |arguments: &[&str]| {
        let all = [&["run", "bar", "--out", out, "--quiet", "--override", "output.frames=4"], arguments].concat();
        let output = Command::new(env!("CARGO_BIN_EXE_fmc")).args(all).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    bar(&["--end", "0.2"]);
    let (code, said) = bar(&["--end", "0.4", "--resume"]);
    assert_eq!(code, Some(2), "{said}");
    assert!(said.contains("goes to time.end = 2.0") && said.contains("without --resume"), "{said}");
    assert_ne!(bar(&["--end", "0.2", "--resume"]).0, Some(2));
}
