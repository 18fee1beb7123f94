//! The page by itself.

use super::{Folder, output, said};
use base64::Engine;
use scraper::{Html, Selector};
use std::collections::BTreeSet;

fn all<'a>(page: &'a Html, selector: &str) -> Vec<scraper::ElementRef<'a>> {
    page.select(&Selector::parse(selector).expect("a selector")).collect()
}

/// Whether bytes are a picture of the type that they claim to be.
fn decodes(media_type: &str, bytes: &[u8]) -> bool {
    match media_type {
        "image/png" => tiny_skia::Pixmap::decode_png(bytes).is_ok_and(|picture| picture.width() > 100),
        "image/gif" => gif::DecodeOptions::new()
            .read_info(bytes)
            .is_ok_and(|mut decoder| std::iter::from_fn(|| decoder.read_next_frame().ok()?.map(|_| ())).count() > 1),
        "image/svg+xml" => std::str::from_utf8(bytes)
            .is_ok_and(|text| roxmltree::Document::parse(text).is_ok_and(|svg| svg.root_element().has_tag_name("svg"))),
        _ => false,
    }
}

#[test]
fn every_run_stands_on_the_page_with_pictures_that_decode() {
    let folder = Folder::new("page");
    let run = output(&folder, &["squares", "patch2d", "bar", "--quick"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let page = Html::parse_document(&folder.text("report.html"));

    let pictures = all(&page, "img");
    let mut media_types = BTreeSet::new();
    for picture in &pictures {
        let (source, alt) = (picture.attr("src").unwrap_or_default(), picture.attr("alt").unwrap_or_default());
        let (head, data) = source.split_once(";base64,").unwrap_or_else(|| panic!("{alt}: not part of the page"));
        let media_type = head.strip_prefix("data:").expect("a data URI");
        let bytes = base64::engine::general_purpose::STANDARD.decode(data).expect("base64");
        assert!(decodes(media_type, &bytes), "{alt}: no {media_type}");
        assert!(!alt.is_empty());
        media_types.insert(media_type.to_owned());
    }
    assert!(media_types.contains("image/png") && media_types.contains("image/svg+xml"));
    // Of each run: bodies or snapshots; a chart of the kernel check, of the bar's energies and forces, of the iterations.
    for run in ["kernel-squares", "patch2d", "bar"] {
        let article = all(&page, &format!("article#{run}"));
        assert_eq!(article.len(), 1, "{run}");
        for wanted in [".pictures img, .snapshots img", ".chart img"] {
            assert!(article[0].select(&Selector::parse(wanted).unwrap()).next().is_some(), "{run}: no {wanted}");
        }
    }

    // Of an equilibrium also the fibers through its contact.
    let with_fibers = all(&page, "#patch2d .pictures figcaption").into_iter().filter(|caption| {
        let text: String = caption.text().collect();
        text.contains("lines through the contact")
    });
    assert!(with_fibers.count() >= 1 && folder.0.join("runs/patch2d/fibers.png").is_file());

    // Nothing comes from elsewhere, and every link leads somewhere.
    assert!(all(&page, "script, link, iframe, object").is_empty());
    for link in all(&page, "a") {
        let target = link.attr("href").and_then(|href| href.strip_prefix('#')).expect("a link within the page");
        assert_eq!(all(&page, &format!("[id='{target}']")).len(), 1, "{target}");
    }

    // As many verdicts as the runs have checks, and all of them hold.
    let mut checks = 0;
    for run in ["patch2d", "patch2d-tri3", "patch2d-depth", "bar"] {
        let summary: serde_json::Value =
            serde_json::from_str(&folder.text(&format!("runs/{run}/summary.json"))).unwrap();
        let expected = summary["checks"].as_array().unwrap().len();
        checks += expected;
    }
    let squares: serde_json::Value = serde_json::from_str(&folder.text("runs/kernel-squares/record.json")).unwrap();
    checks += squares["checks"].as_array().unwrap().len();
    assert_eq!(all(&page, ".checks tbody .badge.pass").len(), checks);
    assert!(all(&page, ".badge.fail").is_empty());
    let badge: String = all(&page, ".verdict-line .badge")[0].text().collect();
    assert_eq!(badge, format!("{checks} of {checks} checks pass"));
}

#[test]
fn a_check_that_fails_and_a_case_that_cannot_run_are_told() {
    let folder = Folder::new("fails");
    let wrong = include_str!("../../../../benchmarks/cases/patch2d.toml").replacen("value = 0.0", "value = 0.5", 1);
    // Steps far beyond the stable one.
    let impossible =
        include_str!("../../../../benchmarks/cases/bar.toml").replace("step = 1.6666666666666667e-3", "step = 0.1");
    let path = |name: &str| folder.0.join(name).to_str().unwrap().to_owned();
    std::fs::write(path("wrong.toml"), wrong).unwrap();
    std::fs::write(path("impossible.toml"), impossible).unwrap();
    let run = output(&folder, &[&path("wrong.toml"), &path("impossible.toml"), "--quick"]);
    assert_eq!(run.status.code(), Some(1), "{}", said(&run));
    let page = Html::parse_document(&folder.text("report.html"));
    assert_eq!(all(&page, "#wrong .checks .badge.fail").len(), 1);
    let failure: String = all(&page, "#impossible .failure")[0].text().collect();
    assert!(failure.contains("exceeds the limit"), "{failure}");
    assert_eq!(all(&page, ".summary .badge.fail").len(), 2);
    let refused = output(&folder, &["tsar"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(said(&refused).contains("did you mean 'star'?"), "{}", said(&refused));
}
