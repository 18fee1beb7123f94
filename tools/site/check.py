#!/usr/bin/env python3
"""Opens every page of the site in chromium, 390 px wide: python tools/site/check.py SITE

A page has no error on the console, no picture that is missing, and nothing to scroll sideways but code, tables, formulas and
drawings in boxes of their own. Pages come from a server on this machine; a page that asks another machine for something fails.
"""

import json
import shutil
import subprocess
import sys
import tempfile
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

WIDTH = 390

# One frame after another, so that the width is the same in any chromium.
HARNESS = """<!doctype html><meta charset="utf-8"><body style="margin:0"><script>
const pages = PAGES, found = [];
// The orange body is dragged down, then far away; then the keys bring it back.
function play(view) {
  const scene = view.document.getElementById("scene"), unit = scene.clientWidth / 6, box = scene.getBoundingClientRect();
  const at = ([x, y]) => ({ clientX: box.left + box.width / 2 + x * unit, clientY: box.top + box.height / 2 - y * unit, bubbles: true });
  const area = () => Number(view.document.querySelector("#numbers dd").textContent);
  const drag = (from, to) => {
    for (const [kind, x] of [["pointerdown", from], ["pointermove", to], ["pointerup", to]]) scene.dispatchEvent(new view.PointerEvent(kind, at(x)));
    return area();
  };
  const seen = [area(), drag([0.55, 0.8], [0.55, 0.6]), drag([0.55, 0.6], [0.55, 2.6])];
  const down = () => new view.KeyboardEvent("keydown", { key: "ArrowDown", bubbles: true });
  for (let k = 0; k < 100; k++) scene.dispatchEvent(down());
  return [...seen, area()];
}
async function look(page) {
  const frame = document.createElement("iframe");
  frame.style = "width:WIDTHpx;height:800px;border:0";
  const loaded = new Promise((done) => (frame.onload = done));
  frame.src = page;
  document.body.replaceChildren(frame);
  await loaded;
  const view = frame.contentWindow, text = view.document;
  await new Promise((done) => setTimeout(done, 30));
  const boxes = "pre, .table, .formula, .picture";
  const wide = [...text.querySelectorAll("main *")].filter((e) => e.getBoundingClientRect().right > WIDTH + 1 && !e.closest(boxes));
  const missing = [...text.images].filter((image) => image.complete && !image.naturalWidth).map((image) => image.src);
  const loads = view.performance.getEntriesByType("resource").map((entry) => entry.name);
  const elsewhere = loads.filter((name) => !name.startsWith(location.origin) && !name.startsWith("data:"));
  const shown = wide.slice(0, 3).map((e) => e.outerHTML.slice(0, 120));
  return { page, width: text.documentElement.scrollWidth, wide: shown, missing, elsewhere, areas: page === "try.html" ? play(view) : [] };
}
(async () => {
  for (const page of pages) found.push(await look(page));
  await fetch("/done", { method: "POST", body: JSON.stringify(found) });
})();
</script>"""


class Server(SimpleHTTPRequestHandler):
    """The site, the page that opens all others, and the place where it says what it found."""

    found = None
    is_done = threading.Event()
    pages = ()

    def do_GET(self):
        if self.path != "/harness":
            return super().do_GET()
        text = HARNESS.replace("PAGES", json.dumps(self.pages)).replace("WIDTH", str(WIDTH)).encode()
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        self.wfile.write(text)

    def do_POST(self):
        Server.found = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(204)
        self.end_headers()
        Server.is_done.set()

    def log_message(self, *_):
        pass


def browse(site, seconds=150):
    """What the browser found, and its console."""
    Server.pages = sorted(path.name for path in site.glob("*.html"))
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Server, directory=str(site)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}/harness"
    profile = tempfile.mkdtemp()
    with tempfile.TemporaryFile("w+") as console:
        words = [shutil.which("chromium"), "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}", "--enable-logging=stderr"]
        browser = subprocess.Popen([*words, "--window-size=1000,900", "--remote-debugging-port=0", address], stderr=console, stdout=console)
        is_done = Server.is_done.wait(seconds)
        browser.terminate()
        browser.wait(30)
        console.seek(0)
        said = [line.strip() for line in console if "CONSOLE" in line]
    server.shutdown()
    shutil.rmtree(profile, ignore_errors=True)  # the browser's own processes may still write there
    assert is_done, f"the browser did not come to an end within {seconds} s"
    return Server.found, said


def main():
    site = Path(sys.argv[1]).resolve()
    found, said = browse(site)
    faults = [f"console: {line}" for line in said]
    for one in found:
        if one["width"] > WIDTH:
            faults.append(f"{one['page']}: {one['width']} px wide: {one['wide']}")
        faults += [f"{one['page']}: no picture {name}" for name in one["missing"]]
        faults += [f"{one['page']}: asks for {name}" for name in one["elsewhere"]]
    (areas,) = (one["areas"] for one in found if one["areas"])
    first, deeper, apart, back = areas
    # Places of events are whole pixels, each a sixtieth of a unit.
    if not (0 < first < deeper and apart == 0 and abs(back - deeper) < 0.1 * deeper):
        faults.append(f"try.html: dragged, the area of the overlap goes from {first} to {deeper}, {apart} and {back}")
    print("\n".join(faults) or f"{len(found)} pages opened, {WIDTH} px wide: nothing on the console, nothing to scroll sideways")
    sys.exit(bool(faults) or len(found) < 50)


main()
