//! The picture of `fmc force`: what it draws, and that a browser shows it. The command is that of `make demo`.

use crate::command::{folder, force};
use roxmltree::Document;
use std::process::Command;
use tiny_skia::Pixmap;

/// The words behind `fmc force` in the Makefile's target demo.
fn demo() -> String {
    let makefile = include_str!("../../../../Makefile");
    let recipe = makefile.split("\ndemo:\n").nth(1).expect("the target demo");
    let line = recipe.lines().find(|line| line.contains(" force ")).expect("its command");
    line.split(" force ").nth(1).expect("its words").trim().to_owned()
}

fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-')).filter(|word| !word.is_empty());
    words.map(|word| word.parse().unwrap()).collect()
}

#[test]
fn bodies_and_forces_are_drawn() {
    let run = force("picture", &demo());
    let path = folder("picture").join("out/picture.svg");
    assert!(run.stdout.contains(&format!("written: {} (open it in a browser)", path.display())), "{}", run.stdout);
    let text = std::fs::read_to_string(&path).unwrap();
    let svg = Document::parse(&text).unwrap();
    let panels: Vec<_> = svg.root_element().children().filter(|node| node.has_tag_name("svg")).collect();
    assert_eq!(panels.len(), 2);
    let of = |panel: usize, name: &str| panels[panel].children().filter(|node| node.has_tag_name(name)).count();
    // On the left all cells of both files, on the right some of them.
    let cells: usize = run.stdout.split("cells: ").nth(1).unwrap().split(',').next().unwrap().parse().unwrap();
    assert_eq!(of(0, "polygon"), cells);
    assert!(of(1, "polygon") > 2 && of(1, "polygon") < cells);
    // An arrow at every node that is pushed, on both; the block, under the star, is pushed down, the star up.
    assert!(of(0, "path") >= 2 && of(0, "path") == of(1, "path"));
    let arrows = panels[0].children().filter(|node| node.has_tag_name("path"));
    let rise = |path: &str| {
        let at = numbers(path);
        at[1] - at[3]
    };
    let rises: Vec<f64> = arrows.map(|arrow| rise(arrow.attribute("d").unwrap())).collect();
    assert!(rises.iter().any(|rise| *rise > 50.0) && rises.iter().any(|rise| *rise < -20.0), "{rises:?}");
}

#[test]
fn bodies_in_space_and_none_in_contact_are_drawn() {
    let run = force("picture3d", "examples/two_blocks.msh --stiffness 1e6");
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let text = std::fs::read_to_string(folder("picture3d").join("out/picture.svg")).unwrap();
    let svg = Document::parse(&text).unwrap();
    assert!(svg.descendants().filter(|node| node.has_tag_name("polygon")).count() > 20);
    assert!(svg.descendants().any(|node| node.has_tag_name("path")));
    force("picture_apart", "examples/star.msh examples/block.msh --stiffness 1 --translate 1=0,1");
    let text = std::fs::read_to_string(folder("picture_apart").join("out/picture.svg")).unwrap();
    assert!(text.contains("nothing overlaps") && !text.contains("<path"));
}

#[test]
fn a_browser_shows_it() {
    force("picture_seen", &demo());
    let folder = folder("picture_seen");
    let seen = folder.join("seen.png");
    let run = Command::new("chromium")
        // Tests may run as root and in containers with little shared memory.
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"])
        .args(["--hide-scrollbars", "--window-size=1100,640", &format!("--screenshot={}", seen.display())])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("file://{}", folder.join("out/picture.svg").display()))
        .output()
        .unwrap_or_else(|error| panic!("chromium cannot be run ({error}); `make tools` installs it"));
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let shot = Pixmap::load_png(&seen).unwrap();
    // Blue and orange bodies on nearly white, red arrows.
    let count = |is_it: fn(i32, i32, i32) -> bool| {
        shot.pixels().iter().filter(|p| is_it(p.red().into(), p.green().into(), p.blue().into())).count()
    };
    let [star, block, arrows] = [
        count(|r, _, b| b > r + 25),
        count(|r, g, b| r > b + 25 && g > b + 10),
        count(|r, g, b| r > 160 && g < 60 && b < 60),
    ];
    assert!(star > 2_000 && block > 10_000 && arrows > 300, "{star} {block} {arrows}");
}
