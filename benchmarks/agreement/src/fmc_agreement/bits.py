"""Forces of different hosts at the very same coordinates: the same bits."""

from __future__ import annotations

from pathlib import Path
from typing import Callable

import numpy as np
from fmc_contact import Contact, Result

from . import outcome
from .problem import Problem
from .touching import Touching


def package(problem: Problem, displacement: np.ndarray) -> Result:
    """What the package alone finds, with patches found where the bodies are; with friction after one step from the
    start."""
    coords = problem.coords + displacement
    blocks = [(body.cell_type, body.conn) for body in problem.bodies]
    contact = Contact(problem.coords, blocks, bodies=problem.body_of_cell, **problem.contact_options())
    problem.add_obstacles(contact)
    if problem.has_friction:
        contact.friction.begin_step(problem.coords)
    return contact.evaluate(coords)


def begun_anew(problem: Problem, touching: Touching) -> None:
    """Leaves nothing of the way behind: no patches, and with friction a step that begins where the bodies were at
    first."""
    touching.contact.patches.release()
    touching.contact.multipliers.release()
    if problem.has_friction:
        touching.begin_step(np.zeros(problem.coords.shape))
        touching.contact.friction.slip = np.empty((0, 8))


def compared(folder: Path, problem: Problem, force: Callable[[np.ndarray], np.ndarray]) -> dict[str, np.ndarray]:
    """Arrays for an outcome, where the reference host has run: the forces that a host's adapter gives, by ``force``, at the displacement of the
    reference host, and those that they should be: of a motion the reference host's own, of an equilibrium those of
    the package, since there the reference host holds on to the patches of its last iteration."""
    if not (folder / "reference.npz").exists():
        return {}
    _, arrays = outcome.read(folder, "reference")
    at = arrays["at_displacement"]
    wanted = arrays["at_force"] if "at_force" in arrays else package(problem, at).forces
    return {"force_at_reference": force(at), "one_shot": wanted}
