"""Sections of docstrings in numpy's form."""

import inspect
import re


def sections(text):
    """The sections of a docstring in numpy's form, by heading."""
    parts = re.split(r"^(\w+)\n-+\n", inspect.cleandoc(text), flags=re.M)
    return dict(zip(parts[1::2], parts[2::2]))


def named(section):
    """Names at the beginning of the entries of a section."""
    entries = [line.split(" : ")[0] for line in section.splitlines() if line and not line.startswith(" ")]
    return {name.strip().lstrip("*") for entry in entries for name in entry.split(",")}
