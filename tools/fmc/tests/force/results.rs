//! What the command finds and writes.

use crate::command::{folder, force, json};
use serde_json::Value;

const STAR: &str = "examples/star.msh examples/block.msh --stiffness 1e6";
const DATA: &str = "crates/mesh-io/tests/data";

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

/// Roundoff of sums over a few hundred nodes with forces of this size.
fn close(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= 1e-11 * size
}

#[test]
fn json_has_every_key() {
    for (words, dim, bodies) in [(STAR, 2, 2), ("examples/two_blocks.msh --stiffness 1e6", 3, 2)] {
        let found = json("json_has_every_key", words);
        let keys = "dim volume volume_standard_error energy contact_area fibers crossings seconds bodies warnings";
        assert!(keys.split(' ').all(|key| !found[key].is_null()), "{found}");
        assert_eq!(found["dim"], dim);
        assert_eq!(found["bodies"].as_array().unwrap().len(), bodies);
        for body in found["bodies"].as_array().unwrap() {
            assert_eq!(body["force"].as_array().unwrap().len(), dim);
            assert_eq!(body["moment"].as_array().unwrap().len(), if dim == 2 { 1 } else { 3 });
            assert!(body["nodes"].as_u64().unwrap() > 0);
        }
        assert!(found["warnings"].as_array().unwrap().is_empty());
    }
}

/// Two blocks, 0.02 deep in one another over 0.5 × 0.5: V = 0.005, F = K · 0.25, about (0.45, 0.55).
#[test]
fn blocks_press_with_stiffness_times_area() {
    for (estimator, tolerance) in [("exact", 1e-12), ("fibers", 0.01)] {
        let found = json(
            "blocks_press_with_stiffness_times_area",
            &format!("examples/two_blocks.msh --stiffness 1e6 --law volume --estimator {estimator}"),
        );
        assert!((number(&found["volume"]) / 0.005 - 1.0).abs() < tolerance, "{found}");
        assert!((number(&found["energy"]) / 5000.0 - 1.0).abs() < tolerance);
        let (upper, lower) = (&found["bodies"][1], &found["bodies"][0]);
        let expected = [0.0, 0.0, 2.5e5, 1.375e5, -1.125e5, 0.0];
        for (sign, body) in [(1.0, upper), (-1.0, lower)] {
            let computed = [numbers(&body["force"]), numbers(&body["moment"])].concat();
            for (c, e) in computed.iter().zip(expected) {
                assert!((sign * c - e).abs() <= tolerance * 2.5e5, "{estimator}: {computed:?}");
            }
        }
    }
}

/// The forces of pairs add up to those of bodies, and each is told once: in the table, and as JSON.
#[test]
fn pairs_add_up_to_bodies() {
    for words in
        [STAR, "examples/two_blocks.msh --stiffness 1e6", "examples/ball.vtu --stiffness 1e6 --obstacle half-space"]
    {
        let found = json("pairs_add_up_to_bodies", words);
        let pairs = found["pairs"].as_array().unwrap();
        assert!(!pairs.is_empty());
        let bodies = found["bodies"].as_array().unwrap();
        for key in ["force", "moment"] {
            let mut sums: Vec<Vec<f64>> = bodies.iter().map(|body| vec![0.0; numbers(&body[key]).len()]).collect();
            for pair in pairs {
                let [a, b] = ["a", "b"].map(|side| pair[side].as_u64().unwrap() as usize);
                for (axis, x) in numbers(&pair[key]).into_iter().enumerate() {
                    sums[a][axis] -= x;
                    if pair["obstacle"] == false {
                        sums[b][axis] += x;
                    }
                }
            }
            for (body, sum) in bodies.iter().zip(&sums) {
                let whole = numbers(&body[key]);
                let size = whole.iter().fold(1e-3, |most: f64, x| most.max(x.abs()));
                assert!(whole.iter().zip(sum).all(|(a, b)| (a - b).abs() <= 1e-9 * size), "{key}: {whole:?} {sum:?}");
            }
        }
    }
    let table = force("pairs_add_up_to_bodies", STAR).stdout;
    assert!(table.contains("force of on") && table.contains("star.msh on block.msh"), "{table}");
}

/// The unit is a name: no number changes, and it is spelled in words.
#[test]
fn units_are_named() {
    let numbers_of = |text: &str| -> Vec<String> {
        let words = text.split_whitespace().filter(|word| word.contains("e-") || word.contains("e0"));
        words.map(str::to_owned).collect()
    };
    let [metres, millimetres] =
        ["", "--unit mm"].map(|unit| force("units_are_named", &format!("{STAR} {unit}")).stdout);
    assert_eq!(numbers_of(&metres), numbers_of(&millimetres));
    assert!(metres.contains("lengths in metres") && metres.contains("m²"), "{metres}");
    assert!(
        millimetres.contains("lengths in millimetres") && millimetres.contains("cubic millimetre"),
        "{millimetres}"
    );
    assert!(
        millimetres.contains("mm²") && millimetres.contains("N/mm") && !millimetres.contains("J/m"),
        "{millimetres}"
    );
}

/// A body in millimetres beside one in metres.
#[test]
fn sizes_that_are_no_match_are_told() {
    let folder = folder("sizes");
    let block = |size: f64| {
        let corners =
            [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]].map(|[x, y]| format!("{x} {y} 0\n")).concat();
        format!(
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n{corners}$EndNodes\n$Elements\n\
             1 1 1 1\n2 1 3 1\n1 1 2 3 4\n$EndElements\n"
        )
    };
    for (large, told) in [(1000.0, true), (50.0, false)] {
        std::fs::write(folder.join("small.msh"), block(1.0)).unwrap();
        std::fs::write(folder.join("large.msh"), block(large)).unwrap();
        let found = json("sizes", "{}/small.msh {}/large.msh --stiffness 1");
        let said = found["warnings"].to_string();
        assert_eq!(said.contains("same unit of length"), told, "{said}");
        assert!(!told || said.contains("1000 times") && said.contains("large.msh"), "{said}");
    }
}

/// The same blocks by their depth, exactly without being told: F = K · 0.02 · 0.25 less what the rim of the contact lacks, 14 %
/// where it is as deep as the balls in the cells of 0.125 along it are wide.
#[test]
fn blocks_press_by_their_depth() {
    let found = json("blocks_press_by_their_depth", "examples/two_blocks.msh --stiffness 1e6");
    let [lower, upper] = [0, 1].map(|body| numbers(&found["bodies"][body]["force"]));
    assert!(upper[2] > 0.8 * 5000.0 && upper[2] < 5000.0, "{found}");
    assert!((0..3).all(|axis| close(upper[axis], -lower[axis], 5000.0)), "{found}");
    assert!((number(&found["volume"]) / 0.005 - 1.0).abs() < 1e-12 && found["fibers"] == 0, "{found}");
}

#[test]
fn only_json_goes_to_standard_output() {
    let with = force("only_json", &format!("{STAR} --json -"));
    assert!(with.stdout.starts_with('{') && with.stdout.ends_with("}\n"));
    let without = force("only_json", &format!("{STAR} --json {{}}/star.json"));
    assert!(without.stdout.contains("overlap volume") && without.stdout.contains("star.msh"));
    let file = std::fs::read_to_string(folder("only_json").join("star.json")).unwrap();
    let [file, printed] = [&file, &with.stdout].map(|text| serde_json::from_str::<Value>(text).unwrap());
    assert_eq!(file["bodies"], printed["bodies"]);
}

#[test]
fn every_format_gives_the_same_forces() {
    let found = |name: &str| {
        json("every_format", &format!("{DATA}/{name} --bodies physical --stiffness 1e6"))["bodies"].clone()
    };
    let reference = found("plane_text.msh");
    assert_eq!(reference[0]["name"], "plane_text.msh, group steel wheel");
    for name in ["plane_binary.msh", "plane_meshio_zlib.vtu", "plane_vtk_appended_raw.vtu"] {
        for (body, expected) in found(name).as_array().unwrap().iter().zip(reference.as_array().unwrap()) {
            for (f, e) in numbers(&body["force"]).into_iter().zip(numbers(&expected["force"])) {
                assert!(close(f, e, 1e6), "{name}: {body}");
            }
        }
    }
}

#[test]
fn meshes_move_as_told() {
    let volume = |words: &str| number(&json("meshes_move", &format!("{STAR} --estimator exact {words}"))["volume"]);
    let deeper = volume("--translate 2=0,0.01");
    assert!(close(deeper, volume("--translate 1=0,-0.01"), 1e-4), "{deeper}");
    assert!(deeper > 3.0 * volume("") && volume("--translate 1=0,0.011") == 0.0);
    // The block reaches up to y = 0; turned about the origin by 180 degrees it takes the side of the star.
    assert!(close(volume("--rotate 2=180"), volume("--rotate 2=90 --rotate 2=90"), 1e-4));
    assert!(volume("--rotate 2=180") > 50.0 * deeper);
}

#[test]
fn bodies_are_files_parts_or_groups() {
    let names = |words: &str| -> Vec<String> {
        let found = json("bodies_are", &format!("{words} --stiffness 1"));
        found["bodies"].as_array().unwrap().iter().map(|body| body["name"].as_str().unwrap().to_owned()).collect()
    };
    let two = "examples/two_blocks.msh";
    assert_eq!(names(two), ["two_blocks.msh, part 1", "two_blocks.msh, part 2"]);
    assert_eq!(
        names(&format!("{two} --bodies physical")),
        ["two_blocks.msh, group lower", "two_blocks.msh, group upper"]
    );
    assert_eq!(names(&format!("{two} --bodies file")), ["two_blocks.msh"]);
    assert_eq!(names(&format!("{two} examples/plate.msh")), ["two_blocks.msh", "plate.msh"]);
    assert_eq!(
        names(&format!("examples/plate.msh {two} --bodies component")),
        ["plate.msh", "two_blocks.msh, part 1", "two_blocks.msh, part 2"]
    );
    let twice = "examples/ball.vtu examples/ball.vtu --translate 2=0,0,0.9";
    assert_eq!(names(twice), ["ball.vtu (mesh 1)", "ball.vtu (mesh 2)"]);
    assert_eq!(
        names(&format!("{DATA}/shell_text.msh --law volume")),
        ["shell_text.msh, part 1", "shell_text.msh, part 2"]
    );
}

/// Sampled against exact: some 1 500 crossings tell the force to about 1 %; twice that is allowed.
#[test]
fn rigid_floor_carries_what_the_ball_loses() {
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_fmc"));
    command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).args(["force", "examples/ball.vtu"]);
    command.args(["--stiffness", "1e6", "--obstacle", "half-space axis=0,0,1", "--json", "-", "--out"]);
    let output = command.arg(folder("rigid_floor")).output().unwrap();
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let [ball, floor] = [&found["bodies"][0], &found["obstacles"][0]].map(|body| numbers(&body["force"]));
    for axis in 0..3 {
        assert!(close(ball[axis], -floor[axis], 1e6), "{found}");
    }
    let plate = json("rigid_floor", "examples/ball.vtu examples/plate.msh --stiffness 1e6 --estimator exact");
    assert!((ball[2] / number(&plate["bodies"][0]["force"][2]) - 1.0).abs() < 0.02, "{ball:?} {plate}");
}

#[test]
fn written_forces_are_read_back() {
    json("written_forces", "examples/two_blocks.msh --stiffness 1e6 --estimator exact");
    let again = json(
        "written_again",
        &format!(
            "{} --stiffness 1e6 --bodies physical --estimator exact",
            folder("written_forces").join("out/forces.vtu").display()
        ),
    );
    assert!(close(number(&again["volume"]), 0.005, 0.005));
    assert_eq!(again["bodies"][1]["name"], "forces.vtu, group 1");
    let forces = std::fs::read_to_string(folder("written_forces").join("out/forces.vtu")).unwrap();
    for (name, components) in [("force", 3), ("pressure", 1), ("gap", 1), ("area", 1), ("normal", 3)] {
        assert!(forces.contains(&format!("Name=\"contact_{name}\" NumberOfComponents=\"{components}\"")), "{name}");
    }
}

#[test]
fn fibers_shown_are_capped() {
    let count = |words: &str| {
        let run = force("fibers_shown", &format!("{STAR} --law volume {words}"));
        let file = std::fs::read_to_string(folder("fibers_shown").join("out/fibers.vtu")).unwrap();
        let cells = file.split("NumberOfCells=\"").nth(1).unwrap().split('"').next().unwrap();
        (run.stdout, cells.parse::<usize>().unwrap())
    };
    let (text, all) = count("--estimator fibers");
    assert!(text.contains("fibers in the overlap)") && all > 1000, "{text}");
    let (text, few) = count("--estimator fibers --fibers-shown 10");
    assert!(text.contains("10 of the ") && (40..80).contains(&few), "{text}");
    let (text, none) = count("--estimator exact");
    assert!(text.contains("empty") && none == 0, "{text}");
}

#[test]
fn lone_body_is_warned_of() {
    let found = json("lone_body", "examples/star.msh --stiffness 1");
    assert!(found["warnings"][0].as_str().unwrap().contains("one body only"));
    assert_eq!(found["volume"], 0.0);
}

#[test]
fn same_bits_for_any_thread_count() {
    let bodies = |threads: usize| json("threads", &format!("{STAR} --threads {threads}"))["bodies"].clone();
    assert_eq!(bodies(1), bodies(3));
}
