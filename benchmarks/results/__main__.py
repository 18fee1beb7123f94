"""Figures of the pages, from recorded results: python3 benchmarks/results record target/release/fmc | write | check

`record` runs every case that a page names and writes docs/results.json, with what `make agree`, `make peers` and `make bench` have left.
`write` fills the marked blocks of the pages, and the gallery, from that file. `check` says which are not what it would write.
"""

import sys

import gallery
import pages
import record
from recorded import FILE, Results


def written():
    """Text of every page, by its path, as the recorded results have it."""
    results = Results.read()
    texts = {path: pages.filled(path, results) for path in pages.all_pages()}
    return {**texts, pages.ROOT / "docs" / "gallery.md": gallery.page(results)}


def main(command, *words):
    if command == "record":
        record.record(*words)
    elif command == "write":
        for path, text in written().items():
            path.write_text(text, encoding="utf-8")
    elif command == "check":
        stale = [path.relative_to(pages.ROOT) for path, text in written().items() if path.read_text(encoding="utf-8") != text]
        unused = pages.unused_tables()
        for path in stale:
            print(f"{path}: its figures are not those of {FILE.relative_to(pages.ROOT)}: make figures")
        for table in unused:
            print(f"{table}: no page has a block of this name")
        sys.exit(bool(stale or unused))
    else:
        sys.exit(__doc__)


try:
    main(*sys.argv[1:])
except TypeError as error:
    sys.exit(f"{error}\n\n{__doc__}")
except (ValueError, OSError) as error:
    sys.exit(str(error))
