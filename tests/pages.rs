//! What goes with the library is complete: links and pictures of all pages lead somewhere, the site has every page, and the fuzz
//! targets call every function.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

#[path = "pages/tables.rs"]
mod tables;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn in_docs() -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join("docs")).expect("docs").map(|entry| entry.expect("an entry").path());
    let mut pages: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    pages.sort();
    pages
}

/// Text without what stands in code, where brackets and parentheses are no links.
fn prose(text: &str) -> String {
    let mut prose = String::new();
    let mut is_code = false;
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            prose += line;
            prose.push('\n');
        }
    }
    prose
}

/// Targets of links and pictures.
fn targets(text: &str) -> Vec<String> {
    let text = prose(text);
    let targets = text.match_indices("](").filter_map(|(place, _)| text[place + 2..].split(')').next());
    targets.filter(|target| !target.contains("://") && !target.starts_with("mailto:")).map(str::to_owned).collect()
}

/// What a heading is called in links: words in lower case, joined by hyphens.
fn anchors(text: &str) -> BTreeSet<String> {
    let headings = prose(text);
    let headings =
        headings.lines().filter(|line| line.starts_with('#')).map(|line| line.trim_start_matches('#').trim());
    let name = |heading: &str| {
        let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
        kept.map(|c| if c == ' ' { '-' } else { c }).flat_map(char::to_lowercase).collect()
    };
    headings.map(name).collect()
}

#[test]
fn links_lead_somewhere() {
    let named = ["README.md", "ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"];
    let hosts = fs::read_dir(root().join("hosts")).expect("hosts").map(|entry| entry.expect("an entry").path());
    let hosts = hosts.map(|path| path.join("README.md")).filter(|path| path.exists());
    let named = named
        .into_iter()
        .chain(["bindings/python/README.md", "suite/README.md", "suite/results.md"])
        .chain(["tools/site/pages/start.md", "tools/site/pages/try.md"])
        .map(|name| root().join(name));
    let pages = named.chain(hosts).chain(in_docs());
    let (mut seen, mut broken) = (0, Vec::new());
    for page in pages {
        let text = fs::read_to_string(&page).unwrap_or_else(|error| panic!("{}: {error}", page.display()));
        for target in targets(&text) {
            let (path, anchor) = target.split_once('#').unwrap_or((&target, ""));
            let file = if path.is_empty() { page.clone() } else { page.parent().expect("a folder").join(path) };
            seen += 1;
            let is_heading = || anchors(&fs::read_to_string(&file).unwrap_or_default()).contains(anchor);
            if !file.exists() || !anchor.is_empty() && !is_heading() {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(seen > 150, "only {seen} links were found");
    assert!(broken.is_empty(), "{broken:#?}");
}

#[test]
fn the_site_has_every_page_once() {
    let summary = fs::read_to_string(root().join("docs/SUMMARY.md")).expect("the summary");
    let mut listed = targets(&summary);
    listed.sort();
    let name = |path: PathBuf| path.file_name().expect("a name").to_string_lossy().into_owned();
    let pages: Vec<String> = in_docs().into_iter().map(name).filter(|name| name != "SUMMARY.md").collect();
    assert_eq!(listed, pages);
}

/// A picture that no page shows is old. `fibers.svg` is part of the report of `fmc`.
#[test]
fn every_picture_is_shown() {
    let mut texts = fs::read_to_string(root().join("paper/paper.md")).expect("the paper");
    in_docs().iter().for_each(|page| texts += &fs::read_to_string(page).expect("a page"));
    let entries = fs::read_dir(root().join("docs")).expect("docs").map(|entry| entry.expect("an entry").file_name());
    let names = entries.map(|name| name.to_string_lossy().into_owned());
    let is_picture = |name: &String| [".svg", ".png", ".gif"].iter().any(|ending| name.ends_with(ending));
    let pictures: Vec<String> = names.filter(is_picture).collect();
    assert!(pictures.len() > 15, "{}", pictures.len());
    let is_old = |name: &&String| *name != "fibers.svg" && !texts.contains(&format!("{name})"));
    assert_eq!(pictures.iter().filter(is_old).collect::<Vec<_>>(), Vec::<&String>::new());
}

/// One page that is read in five minutes.
#[test]
fn the_readme_is_short() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the README");
    assert!(readme.lines().count() <= 130);
}

/// Each row says what to do about it.
#[test]
fn every_status_and_warning_leads_to_a_next_step() {
    let header = fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header");
    let page = fs::read_to_string(root().join("docs/errors.md")).expect("the page");
    let is_one = |name: &&str| name.starts_with("FMC_ERROR_") || name.starts_with("FMC_WARNING_");
    let declared: BTreeSet<&str> =
        header.lines().filter_map(|line| line.trim().split_once(" = ")).map(|(name, _)| name).filter(is_one).collect();
    assert!(declared.len() > 60, "{}", declared.len());
    let rows = page
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split_once("` | "))
        .filter(|(_, next)| next.len() > 10);
    let mut listed: Vec<&str> = rows.map(|(name, _)| name).collect();
    listed.sort_unstable();
    assert_eq!(listed, declared.into_iter().collect::<Vec<_>>());
}

/// Names before an opening bracket on lines that declare a function.
fn functions(text: &str, declares: impl Fn(&str) -> bool) -> BTreeSet<&str> {
    let names = text.lines().filter(|line| declares(line)).filter_map(|line| {
        let head = &line[..line.find('(')?];
        Some(&head[head.rfind("fmc_")?..])
    });
    names.collect()
}

/// Every file below a folder, as one text.
fn sources(folder: &Path, left_out: &str) -> String {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let text = |path: PathBuf| match path {
        path if path.ends_with(left_out) => String::new(),
        path if path.is_dir() => sources(&path, left_out),
        path => fs::read_to_string(&path).expect("a file"),
    };
    entries.map(text).collect()
}

/// The crate of the fuzz targets is a workspace of its own, whose tests nobody runs; so it is read here.
#[test]
fn every_function_of_the_header_is_fuzzed() {
    let text = fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header");
    let is_code = |line: &str| !line.starts_with([' ', '/']) && !line.starts_with("typedef");
    let header = functions(&text, |line| is_code(line) && (line.contains(" fmc_") || line.contains("*fmc_")));
    assert!(header.len() > 70, "{}", header.len());
    let calls = sources(&root().join("fuzz/src"), "interface");
    let missing: Vec<_> = header.iter().filter(|name| !calls.contains(&format!("{name}("))).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// A page that names a function, a status or a constant names one that there is: of the C interface, or a package.
#[test]
fn pages_name_what_the_interface_has() {
    let header = fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header");
    let header = header + &fs::read_to_string(root().join("include/fmc_mpi.h")).expect("the header for MPI");
    let words = |text: &str| -> BTreeSet<String> {
        let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        words.filter(|word| word.starts_with("fmc_") || word.starts_with("FMC_")).map(str::to_owned).collect()
    };
    let mut known = words(&header);
    let packages = ["fmc_contact_c", "fmc_contact_skfem", "fmc_contact_dolfinx", "fmc_contact_getfem", "fmc_agreement"];
    known.extend([&packages[..], &["FMC_CONTACT_LIBRARY"]].concat().into_iter().map(str::to_owned));
    let pages = in_docs().into_iter().chain([root().join("README.md"), root().join("bindings/python/README.md")]);
    for page in pages {
        let text = fs::read_to_string(&page).expect("a page");
        // A name that ends in a bar is the beginning of several.
        let unknown: Vec<String> =
            words(&text).into_iter().filter(|word| !word.ends_with('_') && !known.contains(word)).collect();
        assert!(unknown.is_empty(), "{}: {unknown:?}", page.display());
    }
}
