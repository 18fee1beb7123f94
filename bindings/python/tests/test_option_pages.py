"""Every option of the C interface has its row on one page of the book, with the default that the library gives it."""

import re
from ctypes import byref
from pathlib import Path

import pytest
from fmc_contact import _structs
from fmc_contact._library import check, library
from fmc_contact.options import CHOICES

DOCS = Path(__file__).parents[3] / "docs"
PAGES = {
    "fmc_options": ["options-law.md", "options-measure.md", "options-bodies.md", "options-friction.md"],
    "fmc_pair_options": ["options-pairs.md"],
    "fmc_contact_step_options": ["options-contact-step.md"],
}
NAMED = {-1: {"law": "FMC_PAIR_LAW_OF_CONTEXT", "friction_coefficient": "FMC_PAIR_FRICTION_OF_CONTEXT"}}


def rows(page):
    """The rows of a page's first table, with what stands in each cell; further lines of an option have no name."""
    lines = (DOCS / page).read_text().splitlines()
    first = next(at for at, line in enumerate(lines) if line.startswith("| option | meaning, unit | default | if you see … | change |"))
    last = next((at for at in range(first, len(lines)) if not lines[at].startswith("|")), len(lines))
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in lines[first + 2 : last]]


def defaults(struct):
    options = getattr(_structs, struct)()
    check(getattr(library, f"{struct}_init")(byref(options)))
    fields = [name for name, _ in options._fields_ if name != "struct_size" and not name.startswith("reserved")]
    return {name: getattr(options, name) for name in fields}


def shown(name, value):
    if name == "stiffness" and value == 0:
        return None
    if value in NAMED and name in NAMED[value]:
        return NAMED[value][name]
    return CHOICES[name][value] if name in CHOICES else f"{value:g}"


@pytest.mark.parametrize("struct", PAGES)
def test_every_option_has_a_row_with_its_default(struct):
    found = [row for page in PAGES[struct] for row in rows(page)]
    assert all(len(row) == 5 and row[3] for row in found), "what one sees, in every row"
    named = {row[0].strip("`"): row for row in found if row[0]}
    wanted = defaults(struct)
    assert named.keys() == wanted.keys()
    for name, value in wanted.items():
        default = re.match(r"`([^`]*)`", named[name][2])
        number = shown(name, value)
        # Only the stiffness of a law has none.
        assert (default and default.group(1)) == number or number is None, (name, named[name][2], value)


@pytest.mark.parametrize("page", sorted({page for pages in PAGES.values() for page in pages}))
def test_every_page_has_numbers_for_steel_rubber_and_tissue(page):
    numbers = re.split(r"^## (?:Typical values|Numbers)$", (DOCS / page).read_text(), flags=re.M)[1].lower()
    assert "steel" in numbers and "rubber" in numbers and ("tissue" in numbers or "cartilage" in numbers)
