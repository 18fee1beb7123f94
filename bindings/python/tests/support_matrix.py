"""The support matrix, docs/support.md, as the library answers: python support_matrix.py check | write

Every law and estimator is asked for every feature on a small scene. An answer is "yes" only if the forces are there and balance, and if the
tangent is their derivative; otherwise it is the status with which the library refuses, or the warning that it gives.
"""

import sys
from functools import lru_cache
from itertools import combinations
from pathlib import Path

import numpy as np
from fmc_contact import FmcError
from fmc_contact._constants import FMC_STATUS
from support_features import ASKED, GROUPS, PAIRED, both
from support_scene import Scene

PAGE = Path(__file__).parents[3] / "docs" / "support.md"
BEGIN, END = "<!-- begin support: {} -->\n", "<!-- end support -->\n"

# The exponent 2 gives the law volume a pressure that grows with the overlap, and so a tangent.
LAWS = {
    "`depth`": {"law": "depth"},
    "`fiber`, `exact`": {"law": "fiber", "estimator": "exact"},
    "`fiber`, `fibers`": {"law": "fiber", "estimator": "fibers"},
    "`volume`, `exact`": {"law": "volume", "exponent": 2.0, "estimator": "exact"},
    "`volume`, `fibers`": {"law": "volume", "exponent": 2.0, "estimator": "fibers"},
}


class Refused(Exception):
    """A status of the library, and its text."""


class Unbalanced(Exception):
    """Forces of two sides that differ, of which no warning tells."""


def refusing(call, *arguments):
    try:
        return call(*arguments)
    except FmcError as error:
        name, text = FMC_STATUS[error.status].upper(), f": `{error}`"
        raise Refused(f"`FMC_{name}`{text}" if error.status else f"`{type(error).__name__}`") from error


def forces(scene, law):
    """Forces; those between bodies balance, but for the radial ones of rings and those across a plane of symmetry."""
    contact = scene.contact
    if law["law"] == "fiber":
        refusing(contact.patches.keep, scene.x)
    result = refusing(contact.evaluate, scene.x)
    parts = np.array([part.force for part in (*result.bodies, *result.obstacles)])
    size = np.abs(parts).max()
    assert size > 0.1, "no forces"
    axes = slice(1, None) if contact.options["axisymmetric"] or scene.is_cut else slice(None)
    if np.abs(parts.sum(0)[axes]).max() > 1e-5 * size and not any(one.kind == "unbalanced" for one in result.warnings):
        raise Unbalanced
    return result


def tangent(scene, feature):
    """The tangent, which is the slope of the forces: without friction, and under laws that neither sample nor look for directions."""
    contact, x = scene.contact, scene.x
    parts = refusing(contact.tangent_parts, x)
    is_compared = contact.options["law"] != "fiber" and contact.options["estimator"] != "fibers"
    if not is_compared or "friction_coefficient" in feature.scene or (feature.is_curved and scene.dim == 3):
        return
    # Upright walls stay upright: lines of the law fiber run along them.
    motion, step = np.zeros(x.shape), 1e-6
    motion[:, 1] = np.sin(x @ [1, 40, 2][: scene.dim])
    slope = (contact.evaluate(x - step * motion).forces - contact.evaluate(x + step * motion).forces) / (2 * step)
    error = np.abs(parts @ motion.ravel() - slope.ravel()).max() / np.abs(slope).max()
    assert error < (1e-2 if feature.is_curved else 2e-3), error


def answer(feature, law, dim, kind):
    """What the library answers for forces, and for the tangent."""
    try:
        scene = refusing(lambda: Scene(dim, kind, **feature.scene, **law))
        refusing(feature.setup, scene)
        result = forces(scene, law)
        if feature.has_effect:
            plain = Scene(dim, kind, **feature.scene, **law)
            if np.array_equal(forces(plain, law).forces, result.forces):
                return "no effect"
    except Refused as refusal:
        return f"no {refusal}"
    except Unbalanced:
        return "unbalanced"
    given = sorted({warning.kind for warning in result.warnings})
    told = "".join(f" `FMC_WARNING_{kind.upper()}`" for kind in given)
    try:
        tangent(scene, feature)
    except Refused as refusal:
        return f"forces only{told} {refusal}"
    return f"warns{told}" if told else "yes"


def of_feature(feature, law):
    """Answers by dimension; one for all types of cells."""
    found = {}
    for dim in feature.dims:
        flat = ("tri", "quad")
        kinds = [kind for kind in feature.kinds if kind.startswith(flat) == (dim == 2)] or [None]
        answers = {answer(feature, law, dim, kind) for kind in kinds}
        warned = answers - {"yes"}
        assert len(warned) <= 1, (feature.name, law, answers)
        found[dim] = warned.pop().replace("warns", "some types warn" if "yes" in answers else "warns") if warned else "yes"
    return found


def of_call(name, law):
    """Answers to a call, by dimension."""
    options, call = ASKED[name]
    found = {}
    for dim in (2,) if options.get("axisymmetric") or name.endswith("2D") else (2, 3):
        try:
            scene = refusing(lambda dim=dim: Scene(dim, **{**options, **law}))
            refusing(call, scene)
            found[dim] = "yes"
        except Refused as refusal:
            found[dim] = f"no {refusal}"
    return found


class Notes:
    """Numbers of what is refused, in the order in which they come."""

    def __init__(self):
        self.texts = []

    def of(self, text):
        word, mark, rest = text.partition(" `")
        if not rest:
            return word
        rest = mark.strip() + rest
        if rest not in self.texts:
            self.texts.append(rest)
        return f"{word} {self.texts.index(rest) + 1}"

    def cell(self, answers):
        first, *others = answers.values()
        if all(other == first for other in others):
            return self.of(first)
        return "; ".join(f"{dim}D {self.of(one)}" for dim, one in answers.items())


@lru_cache(maxsize=1)
def tables():
    """Every table by its name, and the notes to all of them."""
    notes, found = Notes(), {}
    groups = {name: [(one.name, lambda law, one=one: of_feature(one, law)) for one in rows] for name, rows in GROUPS.items()}
    groups["Calls"] = [(name, lambda law, name=name: of_call(name, law)) for name in ASKED]
    for group, rows in groups.items():
        lines = [f"| {group.lower()} | {' | '.join(LAWS)} |", "| --- |" + " --- |" * len(LAWS)]
        lines += [f"| {name} | {' | '.join(notes.cell(ask(law)) for law in LAWS.values())} |" for name, ask in rows]
        found[group] = "\n".join(lines) + "\n"
    pairs = [(one, other, of_feature(both(one, other), LAWS["`depth`"])) for one, other in combinations(PAIRED, 2)]
    rows = [f"| {one.name} | {other.name} | {notes.cell(found)} |" for one, other, found in pairs if found != {2: "yes"}]
    found["Pairs"] = "\n".join(["| feature | with | answer |", "| --- | --- | --- |", *rows]) + "\n"
    found["Notes"] = "".join(f"{number}. {text}\n" for number, text in enumerate(notes.texts, 1))
    return found


def filled(text):
    """The page with every table as the library answers."""
    for name, table in tables().items():
        begin = BEGIN.format(name)
        head, _, rest = text.partition(begin)
        assert rest and END in rest, f"{PAGE.name} has no block {begin}"
        text = head + begin + table + END + rest.partition(END)[2]
    return text


if __name__ == "__main__":
    written = filled(PAGE.read_text(encoding="utf-8"))
    if sys.argv[1:] == ["write"]:
        PAGE.write_text(written, encoding="utf-8")
    elif sys.argv[1:] != ["check"]:
        sys.exit(__doc__)
    elif written != PAGE.read_text(encoding="utf-8"):
        sys.exit(f"{PAGE}: the library answers otherwise: python {Path(__file__).name} write")
