//! What the library has to say, in words of input files.

use fmc_contact::overlap::Warning;

/// What names something that files cannot say, and what they can.
const WORDS: [(&str, &str); 7] = [
    (
        "name its nodes (symmetry nodes), if not, name none",
        "hold all nodes of both bodies in it across it by *BOUNDARY, from the start; if not, the pressure at these edges is too low",
    ),
    ("An adjustment removes overlaps without strain", "ADJUST=length of *CONTACT PAIR removes overlaps without strain"),
    ("set_surface_smoothing measures round faces, or ", "take elements of second order, or "),
    ("facets meet at more than the angle of set_surface_smoothing: raise the angle, or ", ""),
    ("set a larger reach to tie it", "give *TIE a larger POSITION TOLERANCE to tie it"),
    (
        "set a penetration, take smaller load steps, or allow more updates",
        "take smaller increments in *STATIC, or --penetration",
    ),
    ("take smaller load steps", "take smaller increments in *STATIC"),
];

/// Warnings of the contact and sentences of the search, each once, with the names of bodies and the labels of nodes.
pub(super) fn worded(
    warnings: &[Warning],
    said: &[String],
    names: &[String],
    label: &dyn Fn(usize) -> u64,
) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for warning in warnings {
        let mut warning = warning.clone();
        if let Warning::CoincidingFaces { nodes, .. } = &mut warning {
            nodes.iter_mut().for_each(|node| *node = label(*node) as usize);
        }
        all.push(warning.to_string());
    }
    let told: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    all.extend(said.iter().filter(|text| !told.contains(text)).cloned());
    all.iter().map(|text| in_words(text, names)).collect()
}

/// A sentence in which bodies have their names.
pub(super) fn in_words(text: &str, names: &[String]) -> String {
    let mut parts = text.split("body ");
    let mut found = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let digits = part.len() - part.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        match part[..digits].parse().ok().and_then(|body: usize| names.get(body)) {
            Some(name) => found += &format!("'{name}'{}", &part[digits..]),
            None => found += &format!("body {part}"),
        }
    }
    WORDS.iter().fold(found, |text, (from, to)| text.replace(from, to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use fmc_contact::overlap::Partner;

    #[test]
    fn bodies_have_their_names_and_nodes_their_labels() {
        let names = ["LOWER".to_owned(), "UPPER".to_owned()];
        let (a, b) = (Partner::Body(0), Partner::Body(1));
        let warnings = [
            Warning::FlushFaces { a, b, area: 0.5 },
            Warning::CoincidingFaces { body: b, area: 0.5, nodes: vec![3, 4] },
        ];
        let said = ["body 0 and body 1 overlap: An adjustment removes overlaps without strain".to_owned()];
        let said = [said[0].clone(), warnings[0].to_string(), "a body is free".to_owned()];
        let found = worded(&warnings, &said, &names, &|node| 100 + node as u64);
        assert_eq!(found.len(), 4, "{found:?}");
        assert!(found[0].starts_with("'LOWER' and 'UPPER'") && found[0].contains("*BOUNDARY"), "{}", found[0]);
        assert!(found[1].starts_with("'UPPER': ") && found[1].ends_with("103, 104"), "{}", found[1]);
        assert!(found[2].contains("'LOWER' and 'UPPER' overlap: ADJUST=length of *CONTACT PAIR"), "{}", found[2]);
        assert_eq!(found[3], "a body is free");
        let all = found.join(" ");
        assert!(!all.contains("symmetry nodes") && !all.contains("adjustment"), "{all}");
    }
}
