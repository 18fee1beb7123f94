//! What the pages show in C compiles and runs: pieces of docs/host-guide.md and docs/abi.md inside of programs that give them what
//! a reader has already.

use super::program::{built, compiler, root, scratch, succeed};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Pieces in C and C++ on the pages of the book, and who runs them. Those of first-contact.md are tested by `readme.rs`.
const KNOWN: [(&str, usize); 5] =
    [("abi.md", 1), ("first-contact.md", 2), ("host-guide.md", 2), ("interfaces.md", 1), ("tutorial-c.md", 1)];

fn pieces(page: &str) -> Vec<String> {
    let text = fs::read_to_string(root().join("docs").join(page)).expect("a page");
    let (mut pieces, mut piece) = (Vec::new(), None);
    for line in text.lines() {
        match (&mut piece, line) {
            (None, "```c" | "```cpp") => piece = Some(String::new()),
            (Some(_), "```") => pieces.extend(piece.take()),
            (Some(text), _) => *text += &format!("{line}\n"),
            (None, _) => {}
        }
    }
    pieces
}

#[test]
fn every_piece_is_known() {
    let pages = fs::read_dir(root().join("docs")).expect("docs").map(|entry| entry.expect("an entry").file_name());
    let names = pages.map(|name| name.to_string_lossy().into_owned());
    // The reference repeats the declarations of the header, by whose test they are read.
    let names = names.filter(|name| name.ends_with(".md") && name != "c-reference.md");
    let found: BTreeMap<String, usize> =
        names.map(|name| (name.clone(), pieces(&name).len())).filter(|(_, count)| *count > 0).collect();
    assert_eq!(found, KNOWN.map(|(name, count)| (name.to_owned(), count)).into());
}

/// Compiles `program` in `folder`, where there may be files that it includes, and runs it.
fn printed(program: &Path, folder: &Path) -> String {
    let mut cc = compiler("CC", "cc");
    cc.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-I"]).arg(root().join("include"));
    cc.arg("-I").arg(folder).arg("-I").arg(root().join("tests/c_abi/pages"));
    cc.arg(program).arg(built().join("libfmc_contact.a"));
    succeed(cc.args(["-lpthread", "-ldl", "-lm", "-o"]).arg(folder.join("program")));
    succeed(&mut Command::new(folder.join("program")))
}

#[test]
fn ranks_of_the_guide() {
    let folder = scratch("page-ranks");
    let [shared, parts] = <[String; 2]>::try_from(pieces("host-guide.md")).expect("two pieces");
    fs::write(folder.join("shared.inc"), shared).expect("a writable folder");
    fs::write(folder.join("parts.inc"), with_floor(&parts)).expect("a writable folder");
    let printed = printed(&root().join("tests/c_abi/pages/ranks.c"), &folder);
    assert!(printed.starts_with("4 nodes gathered, force on the tip "), "{printed}");
}

/// An obstacle is added where the page says so: before `bring`.
fn with_floor(parts: &str) -> String {
    let bring = "fmc_context_set_coords(";
    assert_eq!(parts.matches(bring).count(), 1);
    parts.replace(bring, &format!("fmc_context_add_obstacle(context, &half_space, &floor, NULL);\n{bring}"))
}

#[test]
fn law_of_the_host() {
    let folder = scratch("page-law");
    let [piece] = <[String; 1]>::try_from(pieces("interfaces.md")).expect("a piece");
    let main = "int main(void) {\n  double k = 100;\n  fmc_own_law law;\n  fmc_own_law_init(&law);\n  law.respond = respond, law.user = &k;\n  \
                return fmc_own_law_check(&law, 3, 0.1, NULL, 0, 0, NULL, NULL);\n}\n";
    fs::write(folder.join("law.c"), format!("#include <fmc_contact.h>\n{piece}\n{main}")).expect("a writable folder");
    assert_eq!(printed(&folder.join("law.c"), &folder), "");
}

#[test]
fn newton_of_the_tutorial() {
    let folder = scratch("page-newton");
    let [program] = <[String; 1]>::try_from(pieces("tutorial-c.md")).expect("a piece");
    fs::write(folder.join("newton.c"), program).expect("a writable folder");
    let printed = printed(&folder.join("newton.c"), &folder);
    // Two springs and the contact in a row; the pressure falls off at the corners.
    assert!(printed.contains("iteration 4, ") && !printed.contains("iteration 5, "), "{printed}");
    assert!(printed.ends_with("force on the right square 47.6285\n"), "{printed}");
    let page = fs::read_to_string(root().join("docs/tutorial-c.md")).expect("the page");
    let shown = page.split("```output\n").nth(1).and_then(|rest| rest.split("```").next()).expect("the output");
    // The last residual is rounding.
    let kept = |text: &str| -> Vec<String> {
        text.lines().filter(|line| !line.starts_with("iteration 4, ")).map(str::to_owned).collect()
    };
    assert_eq!(kept(&printed), kept(shown));
}

#[test]
fn versions_of_the_interface_agree() {
    let folder = scratch("page-abi");
    let [piece] = <[String; 1]>::try_from(pieces("abi.md")).expect("a piece");
    let program = format!("#include <fmc_contact.h>\nint main(void) {{\n{piece}return 0;\n}}\n");
    fs::write(folder.join("abi.c"), program).expect("a writable folder");
    assert_eq!(printed(&folder.join("abi.c"), &folder), "");
}
