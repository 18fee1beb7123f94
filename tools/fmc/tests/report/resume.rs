//! Interruption and going on.

use super::{Folder, output, report, said};
use serde_json::Value;
use std::process::{Command, Stdio};
use std::time::Duration;

fn figures(folder: &Folder, name: &str) -> Value {
    let summary: Value = serde_json::from_str(&folder.text(name)).unwrap();
    summary["figures"].clone()
}

#[cfg(unix)]
#[test]
fn an_interrupted_report_goes_on_within_the_run_that_was_stopped() {
    let folder = Folder::new("interrupt");
    // Small steps: time enough to be interrupted.
    let slow = include_str!("../../../../benchmarks/cases/star.toml")
        .replace("step = 3.889e-6\nend = 7e-3", "step = 3.889e-7\nend = 2e-3")
        .replace("animation = true", "animation = false");
    let slow_file = folder.0.join("slow.toml");
    std::fs::write(&slow_file, slow).unwrap();
    let arguments = ["patch2d", slow_file.to_str().unwrap(), "--quick", "--limit", "600"];
    let child = report(&folder, &arguments).stderr(Stdio::piped()).spawn().unwrap();
    let history = folder.0.join("runs/slow/history.csv");
    for _ in 0..3000 {
        std::thread::sleep(Duration::from_millis(10));
        if std::fs::metadata(&history).is_ok_and(|file| file.len() > 40_000) {
            break;
        }
    }
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let interrupted = child.wait_with_output().unwrap();
    assert_eq!(interrupted.status.code(), Some(130), "{}", said(&interrupted));
    assert!(said(&interrupted).contains("again to resume"), "{}", said(&interrupted));
    assert!(folder.0.join("runs/patch2d/record.json").exists() && !folder.0.join("report.html").exists());
    assert!(folder.0.join("runs/slow/checkpoint.state").exists());

    let finished = output(&folder, &arguments);
    let before = said(&finished).lines().find(|line| line.contains("patch2d ")).map(str::to_owned);
    assert!(before.is_some_and(|line| line.contains("computed before")), "{}", said(&finished));
    assert!(folder.0.join("report.html").exists());
    // What was resumed is what would have come out without a stop.
    let whole = Folder::new("whole");
    let run = Command::new(env!("CARGO_BIN_EXE_fmc"))
        .args(["run", slow_file.to_str().unwrap(), "--quiet", "--out"])
        .arg(&whole.0)
        .status()
        .unwrap();
    assert!(run.code().is_some_and(|code| code < 2));
    assert_eq!(figures(&folder, "runs/slow/summary.json"), figures(&whole, "summary.json"));
}

#[test]
fn a_case_that_has_changed_runs_again_and_others_do_not() {
    let folder = Folder::new("changed");
    let text = include_str!("../../../../benchmarks/cases/patch2d.toml");
    let file = folder.0.join("mine.toml");
    std::fs::write(&file, text).unwrap();
    let arguments = [file.to_str().unwrap(), "patch3d", "--quick"];
    let line = |said: &str, name: &str| {
        let lines: Vec<&str> = said.lines().filter(|line| line.contains(&format!(" {name} "))).collect();
        lines.join("; ")
    };
    let first = said(&output(&folder, &arguments));
    assert!(!first.contains("computed before") && !first.contains("runs again"), "{first}");
    // A comment changes nothing.
    std::fs::write(&file, format!("# mine\n{text}")).unwrap();
    let second = said(&output(&folder, &arguments));
    assert!(line(&second, "mine").contains("computed before"), "{second}");
    std::fs::write(&file, text.replace("pressure = 1.0", "pressure = 2.0")).unwrap();
    let third = said(&output(&folder, &arguments));
    assert!(line(&third, "mine").contains("the case has changed: runs again"), "{third}");
    assert!(line(&third, "patch3d").contains("computed before"), "{third}");
    // A record that was cut short is none.
    std::fs::write(folder.0.join("runs/patch3d/record.json"), "{").unwrap();
    let fourth = said(&output(&folder, &arguments));
    assert!(!line(&fourth, "patch3d").contains("computed before"), "{fourth}");
}
