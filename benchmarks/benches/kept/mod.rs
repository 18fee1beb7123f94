//! What benchmarks leave for the pages: out/bench/NAME.json.

use serde_json::{Map, Value};
use std::path::Path;

/// Leaves figures beside those of earlier runs, in the place of those of the same name.
pub(crate) fn keep(bench: &str, figures: impl IntoIterator<Item = (String, Value)>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../out/bench");
    let path = folder.join(format!("{bench}.json"));
    let earlier = std::fs::read_to_string(&path).ok();
    let mut all: Map<String, Value> = earlier.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default();
    all.extend(figures);
    let text = serde_json::to_string_pretty(&all).expect("numbers");
    std::fs::create_dir_all(folder).and_then(|()| std::fs::write(path, text)).expect("a file of figures");
}
