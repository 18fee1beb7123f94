"""Writes the site: python -m fmc_site OUT REPOSITORY REVISION

Needs markdown-it-py, Pygments and latex2mathml. A folder OUT/reference, if there is one, is kept and linked.
"""

import json
import re
import shutil
import sys
from pathlib import Path

from pygments.formatters import HtmlFormatter

from .contents import ROOT, Links, contents
from .layout import whole
from .markdown import Rendered
from .suite import problems

ASSETS = ROOT / "tools/site/assets"


def colours():
    """Colours of code, by light and by dark."""
    light = HtmlFormatter(style="default").get_style_defs(":root code")
    dark = HtmlFormatter(style="github-dark").get_style_defs(":root[data-theme=dark] code")
    kept = [line for line in f"{light}\n{dark}".splitlines() if "code ." in line and "background" not in line]
    return "\n".join(kept) + "\n"


def main():
    out, repository, revision = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    version = re.search(r'^version = "(.*)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.M)[1]
    out.mkdir(parents=True, exist_ok=True)
    for old in out.iterdir():
        if old.name != "reference":
            shutil.rmtree(old) if old.is_dir() else old.unlink()
    pages = contents()
    links = Links(pages, repository, revision, (out / "reference/python").is_dir())
    words = []
    for page in pages:
        text = page.source.read_text(encoding="utf-8")
        if page.name == "suite-results":
            text += problems(text)
        rendered = Rendered(text, page.source, links)
        (out / f"{page.name}.html").write_text(whole(pages, page, rendered, repository, version), encoding="utf-8")
        words += [[page.name, page.title, *section] for section in rendered.sections]
    shutil.copytree(ASSETS, out / "assets")
    with (out / "assets/style.css").open("a", encoding="utf-8") as style:
        style.write(colours())
    (out / "assets/words.js").write_text(f"const WORDS = {json.dumps(words, ensure_ascii=False)};\n", encoding="utf-8")
    for name, file in links.copied.items():
        (out / name).parent.mkdir(exist_ok=True)
        shutil.copyfile(file, out / name)
    print(f"{len(pages)} pages in {out}")


main()
