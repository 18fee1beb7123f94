//! Case files of any content, with changes from the command line: a case that is checked, or an error that names the place.
#![no_main]

use fmc_fuzz::case::Document;
use std::path::Path;

libfuzzer_sys::fuzz_target!(|text: &str| {
    // Lines behind a form feed are changes, as `--set` has them.
    let (text, changes) = text.split_once('\x0c').unwrap_or((text, ""));
    let document = Document::parse("fuzzed", "fuzzed.toml", Path::new("/nowhere"), text);
    let Ok(mut document) = document else { return };
    for change in changes.lines().take(4) {
        let _ = document.override_with("--set", change);
    }
    match document.case() {
        Ok(case) => drop(format!("{case:?}")),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});
