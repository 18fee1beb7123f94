//! The commands `fmc run` and `fmc list`.

use super::Folder;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

fn fmc(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_fmc")).args(arguments).output().unwrap()
}

#[test]
fn list_names_every_case() {
    let listed = String::from_utf8(fmc(&["list"]).stdout).unwrap();
    for name in ["bar", "bar3d", "blocks3d", "diamond", "star"] {
        assert!(listed.contains(&format!("| {name} ")), "{listed}");
    }
    let json: serde_json::Value = serde_json::from_slice(&fmc(&["list", "--json"]).stdout).unwrap();
    let star = json.as_array().unwrap().iter().find(|case| case["case"] == "star").unwrap();
    assert_eq!((&star["nodes"], &star["cells"], &star["dimension"]), (&1261.into(), &1142.into(), &2.into()));
}

/// As in `fmc list | head -1`: nobody reads on.
#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_fmc"))
        .arg("list")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let ended = child.wait_with_output().unwrap();
    assert_eq!((ended.status.code(), String::from_utf8_lossy(&ended.stderr).as_ref()), (Some(0), ""));
}

#[test]
fn exit_status_tells_checks_from_mistakes() {
    let folder = Folder::new("status");
    let out = folder.0.to_str().unwrap();
    let good = fmc(&["run", "bar", "--out", out, "--json", "--override", "output.frames=0"]);
    assert_eq!(good.status.code(), Some(0), "{}", String::from_utf8_lossy(&good.stderr));
    let summary: serde_json::Value = serde_json::from_slice(&good.stdout).unwrap();
    assert_eq!((&summary["case"], &summary["law"]), (&"bar".into(), &"fiber".into()));
    // A case that expects what it does not get.
    let case = folder.0.join("mine.toml");
    let text = include_str!("../../../../benchmarks/cases/bar.toml").replace("value = 300.0", "value = 200.0");
    std::fs::write(&case, text).unwrap();
    let bad = fmc(&["run", case.to_str().unwrap(), "--out", out, "--quiet"]);
    assert_eq!((bad.status.code(), bad.stdout.len()), (Some(1), 0));
    assert!(String::from_utf8_lossy(&bad.stderr).contains("fails: pressure_mean"));
    for arguments in
        [&["run", "tsar"][..], &["run", "bar", "--override", "time.stp=1"], &["run", "bar", "--variant", "x"]]
    {
        let refused = fmc(arguments);
        assert_eq!(refused.status.code(), Some(2), "{}", String::from_utf8_lossy(&refused.stdout));
    }
    // A step that is not stable, with the limit named.
    let unstable = fmc(&["run", "bar", "--out", out, "--override", "time.step=0.01"]);
    assert_eq!(unstable.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&unstable.stderr).contains("structure alone: 3.33"));
    let empty = Folder::new("no-checkpoint");
    let nothing = fmc(&["run", "bar", "--out", empty.0.to_str().unwrap(), "--resume"]);
    assert!(String::from_utf8_lossy(&nothing.stderr).contains("no checkpoint"));
}

/// A folder takes one run at a time; what was finished is not made again.
#[test]
fn a_folder_has_one_run() {
    let folder = Folder::new("one-run");
    let out = folder.0.to_str().unwrap();
    let arguments = ["run", "bar", "--out", out, "--override", "output.frames=0", "--end", "0.2"];
    let taken = fmc_mesh_io::FolderLock::take(&folder.0).unwrap();
    let refused = fmc(&arguments);
    let said = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(2), "{said}");
    assert!(
        said.contains(&format!("written into by process {}", std::process::id())) && said.contains("--out"),
        "{said}"
    );
    drop(taken);
    // As a process leaves it that was killed.
    std::fs::write(folder.0.join(".lock"), "4711").unwrap();
    let first = fmc(&arguments);
    let said = String::from_utf8_lossy(&first.stderr);
    assert!(
        first.status.code() < Some(2) && said.contains("process 4711") && said.contains("did not come to its end"),
        "{said}"
    );
    let again = fmc(&[&arguments[..], &["--resume"]].concat());
    let said = String::from_utf8_lossy(&again.stderr);
    assert_eq!(again.status.code(), first.status.code(), "{said}");
    assert!(said.contains("complete already"), "{said}");
    let figures = |run: &Output| {
        let text = String::from_utf8_lossy(&run.stdout).into_owned();
        text.lines().filter(|line| line.starts_with('|')).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(figures(&again), figures(&first));
}

/// Counts beyond all meaning, and factors that are none: a sentence each.
#[test]
fn counts_have_bounds() {
    let folder = Folder::new("counts");
    let out = folder.0.to_str().unwrap();
    for (arguments, parts) in [
        (
            &["run", "bar", "--override", "bodies.bar.mesh.cells=[1000000000, 1000000000]"][..],
            &["bodies.bar.mesh", "1e18 nodes"][..],
        ),
        (&["run", "bar", "--override", "time.step=1e-300"], &["time.end", "1e7 steps"]),
        (&["run", "patch2d", "--override", "load_steps.count=1000000000000"], &["load_steps.count", "at most 100000"]),
        (&["study", "convergence", "patch2d", "--meshes", "0"], &["positive"]),
        (&["study", "convergence", "patch2d", "--meshes", "1e-9"], &["bodies.0.mesh", "nodes"]),
        (&["study", "newton", "--relaxation", "nan"], &["positive"]),
    ] {
        let refused = fmc(&[arguments, &["--out", out]].concat());
        let said = String::from_utf8_lossy(&refused.stderr);
        assert_eq!(refused.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(!said.contains("panicked"), "{said}");
        assert!(parts.iter().all(|part| said.contains(part)), "{arguments:?}: {said}");
    }
}

/// Cells of a file keep their size: a study says so instead of calling the same mesh a coarser one.
#[test]
fn bodies_from_files_are_not_refined() {
    let folder = Folder::new("from-file");
    let mesh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 0.5 0 0\n3 1 0 0\n4 0 0.5 0\n5 0.5 0.5 0\n6 1 0.5 0\n\
                $EndNodes\n$Elements\n2\n1 3 2 1 1 1 2 5 4\n2 3 2 1 1 2 3 6 5\n$EndElements\n";
    std::fs::write(folder.0.join("lower.msh"), mesh).unwrap();
    let text = include_str!("../../../../benchmarks/cases/patch2d.toml");
    let start = text.find("mesh = {").unwrap();
    let end = start + text[start..].find('\n').unwrap();
    let text = format!("{}mesh = {{ shape = \"file\", path = \"lower.msh\" }}{}", &text[..start], &text[end..]);
    let case = folder.0.join("case.toml");
    std::fs::write(&case, text).unwrap();
    let study = |meshes: &str| {
        let (case, out) = (case.to_str().unwrap(), folder.0.join("out"));
        fmc(&["study", "convergence", case, "--meshes", meshes, "--fibers", "4", "--out", out.to_str().unwrap()])
    };
    let refused = study("2");
    let said = String::from_utf8_lossy(&refused.stderr);
    assert!(refused.status.code() == Some(2) && said.contains("body 'lower'") && said.contains("--meshes 1"), "{said}");
    let made = study("1");
    assert_eq!(made.status.code(), Some(0), "{}", String::from_utf8_lossy(&made.stderr));
}

#[test]
fn another_law_comes_with_its_stiffness() {
    let folder = Folder::new("law");
    let out = folder.0.to_str().unwrap();
    let run = |more: &[&str]| {
        let common = ["run", "bar", "--out", out, "--json", "--override", "output.frames=0", "--end", "0.2"];
        fmc(&[&common[..], more].concat())
    };
    let volume: serde_json::Value = serde_json::from_slice(&run(&["--law", "volume"]).stdout).unwrap();
    assert_eq!((&volume["law"], &volume["stiffness"]), (&"volume".into(), &330.0.into()));
    let own = run(&["--law", "volume", "--override", "contact.stiffness=400"]);
    let own: serde_json::Value = serde_json::from_slice(&own.stdout).unwrap();
    assert_eq!((&own["law"], &own["stiffness"]), (&"volume".into(), &400.0.into()));
}

/// The first Ctrl-C ends a run with status 130 and a checkpoint, from which it goes on.
#[cfg(unix)]
#[test]
fn interrupt_ends_cleanly() {
    let folder = Folder::new("interrupt");
    let arguments = ["run", "star", "--out", folder.0.to_str().unwrap(), "--override", "output.animation=false"];
    let slow = ["--override", "time.step=1e-7", "--override", "output.frames=1"];
    let mut command = Command::new(env!("CARGO_BIN_EXE_fmc"));
    let child = command.args(arguments).args(slow).stderr(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let history = folder.0.join("history.csv");
    for _ in 0..500 {
        std::thread::sleep(Duration::from_millis(10));
        if std::fs::metadata(&history).is_ok_and(|file| file.len() > 20_000) {
            break;
        }
    }
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.contains("--resume"), "{said}");
    assert!(folder.0.join("checkpoint.state").exists());
    assert!(folder.text("history.csv").lines().count() > 1, "what was computed stays");
}

#[test]
fn mesh_writes_a_case_for_other_programs() {
    let written = fmc(&["mesh", "hertz", "--override", "bodies.disc.mesh.finest=0.1134"]);
    assert!(written.status.success(), "{}", String::from_utf8_lossy(&written.stderr));
    let mesh: serde_json::Value = serde_json::from_slice(&written.stdout).unwrap();
    let list = |key: &str| mesh[key].as_array().unwrap().clone();
    let coords = list("coords");
    assert_eq!((&mesh["dimension"], &mesh["bodies"][0]["cell_type"]), (&2.into(), &"triangle".into()));
    let number = |value: &serde_json::Value| value.as_u64().unwrap() as usize;
    let place = |node: usize| coords[node].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect::<Vec<_>>();
    for cell in mesh["bodies"][0]["conn"].as_array().unwrap() {
        assert!(cell.as_array().unwrap().iter().all(|node| number(node) < coords.len()));
    }
    // Held across on the axis; loaded along the whole flat side, at the height of the centre.
    for support in list("supports") {
        assert_eq!((number(&support[1]), place(number(&support[0]))[0], &support[2]), (0, 0.0, &0.0.into()));
    }
    let faces = mesh["loads"][0]["faces"].as_array().unwrap();
    let ends = |face: &serde_json::Value| [0, 1].map(|k| place(number(&face[k])));
    let length: f64 = faces.iter().map(ends).map(|[a, b]| (a[0] - b[0]).abs()).sum();
    // Rounding of the coordinates.
    let on_top = |x: &Vec<f64>| (x[1] - 8.0).abs() < 1e-12;
    assert!((length - 16.0).abs() < 1e-12 && faces.iter().map(ends).all(|ends| ends.iter().all(on_top)));
    assert!(list("expected").is_empty(), "nobody said what a coarser mesh gives");
    assert_eq!(fmc(&["mesh", "hretz"]).status.code(), Some(2));
}
