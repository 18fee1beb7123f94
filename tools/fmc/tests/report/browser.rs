//! The page in a browser.

use super::{Folder, output, said};
use scraper::{Html, Selector};
use std::process::Command;

/// Put behind a copy of the page: what the browser makes of it is written into the document, which is then dumped.
const WITNESS: &str = "<script>addEventListener('load', () => {
  for (const picture of document.images) picture.dataset.seen = picture.complete ? picture.naturalWidth : 0;
  document.body.dataset.width = document.documentElement.scrollWidth;
  document.body.dataset.window = innerWidth;
});</script>";

/// The document after it was loaded in a window of that width.
fn loaded(folder: &Folder, width: u32) -> Html {
    let page = folder.0.join("witness.html");
    std::fs::write(&page, folder.text("report.html") + WITNESS).unwrap();
    let run = Command::new("chromium")
        // Tests may run as root and in containers with little shared memory.
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"])
        .args(["--virtual-time-budget=20000", "--dump-dom", &format!("--window-size={width},900")])
        .arg(format!("--user-data-dir={}", folder.0.join("profile").display()))
        .arg(format!("file://{}", page.display()))
        .output()
        .unwrap_or_else(|error| panic!("chromium cannot be run ({error}); `make tools` installs it"));
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    Html::parse_document(&String::from_utf8_lossy(&run.stdout))
}

#[test]
fn a_browser_shows_every_picture_and_nothing_sticks_out() {
    let folder = Folder::new("browser");
    let run = output(&folder, &["squares", "patch2d", "patch3d", "bar", "--quick"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    for width in [1280, 500] {
        let document = loaded(&folder, width);
        let select = |selector: &str| Selector::parse(selector).unwrap();
        let pictures: Vec<_> = document.select(&select("img")).map(|picture| picture.value().clone()).collect();
        assert!(pictures.len() > 10);
        for picture in pictures {
            let seen: u32 = picture.attr("data-seen").and_then(|seen| seen.parse().ok()).unwrap_or(0);
            assert!(seen > 0, "{:?} is not shown", picture.attr("alt"));
        }
        // Wide tables scroll by themselves; the page does not.
        let body = document.select(&select("body")).next().unwrap().value().clone();
        let pixels = |name: &str| body.attr(name).and_then(|text| text.parse().ok()).unwrap_or(0);
        let (content, window): (u32, u32) = (pixels("data-width"), pixels("data-window"));
        assert!(content > 0 && content <= window, "{content} pixels of content in a window of {window}");
    }
}
