"""Which pages the site has, in which order, and where links to their sources lead."""

import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]

# Pages that are not in docs, by the page that they follow.
EXTRA = {
    "choosing.md": ("tools/site/pages/try.md", "Try the law depth", "try"),
    "comparison.md": ("suite/README.md", "Suite: several codes", "suite"),
    "suite": ("suite/results.md", "Suite: results", "suite-results"),
}


@dataclass(frozen=True)
class Page:
    """One page of the site.

    source: file below the repository; title: its name in the contents; name: its file, without the ending; part: its group.
    """

    source: Path
    title: str
    name: str
    part: str


def contents():
    """The start page, the pages of docs/SUMMARY.md in their order, and those in between."""
    pages = [Page(ROOT / "tools/site/pages/start.md", "fmc-contact", "index", "")]
    part = ""
    for line in (ROOT / "docs/SUMMARY.md").read_text(encoding="utf-8").splitlines():
        part = line[2:].strip() if line.startswith("# ") and line != "# Summary" else part
        entry = re.match(r"(?:- )?\[(.+)\]\((.+)\)$", line)
        if entry:
            title = entry[1] if part else "Introduction"
            pages.append(Page(ROOT / "docs" / entry[2], title, Path(entry[2]).stem, part))
            following = entry[2]
            while following in EXTRA:
                source, title, name = EXTRA[following]
                pages.append(Page(ROOT / source, title, name, part))
                following = name
    return pages


class Links:
    """Where links of a page lead in the site: to a page, a picture or a notebook that is copied, or a file of the repository."""

    def __init__(self, pages, repository, revision, references):
        self.by_source = {page.source.resolve(): page for page in pages}
        self.repository, self.revision, self.references = repository, revision, references
        self.copied = {}

    def target(self, source, link, is_picture=False):
        """The address of a link, or nothing where there is no such page in this site."""
        path, _, anchor = link.partition("#")
        if re.match(r"[a-z]+:", link) or not path:
            return link
        if path.startswith("reference/"):
            return link if self.references else None
        file = (source.parent / path).resolve()
        anchor = f"#{anchor}" if anchor else ""
        if file in self.by_source:
            return f"{self.by_source[file].name}.html{anchor}"
        if is_picture or file.suffix == ".ipynb":
            kept = f"{'pictures' if is_picture else 'notebooks'}/{file.name}"
            self.copied[kept] = file
            return kept
        if file == ROOT / "README.md" and not anchor:
            return "index.html"
        return f"{self.repository}/tree/{self.revision}/{file.relative_to(ROOT)}{anchor}"
