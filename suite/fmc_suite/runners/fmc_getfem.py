"""fmc-contact in GetFEM: its adapter and its search on GetFEM's matrices, nothing chosen."""

from __future__ import annotations

import getfem as gf
import numpy as np
from fmc_contact_getfem import GetfemContact, find_equilibrium

from . import common
from .getfem import Body


def solve(model: common.Model, variant: str) -> tuple[np.ndarray, int]:
    gf.util("trace level", 0)
    gf.util("warning level", 0)
    brick = gf.Model("real")
    bodies = [Body(model, number, brick, 3) for number in range(len(model.cells))]
    for body in bodies:
        body.load = brick.add_explicit_rhs(body.name, np.zeros(body.space.nbdof()))
    options = {"friction_coefficient": model.friction} if model.friction else {}
    contact = GetfemContact(brick, [body.name for body in bodies], **options)
    if len(model.symmetry):
        contact.contact.mesh.set_symmetry_nodes(_symmetry(contact, model, bodies))
    for slave, master in model.pairs if model.tied else []:
        contact.contact.pairs.set(model.body_of(slave), model.body_of(master), interface="tied")
    places = [contact.interval(body.name) for body in bodies]
    held = np.concatenate([place[0] + np.flatnonzero(body.moved(model.fixed)) for place, body in zip(places, bodies)])
    found: list[np.ndarray] = []
    iterations = 0
    for prescribed, loads in zip(model.prescribed, model.loads):
        goal = np.array(brick.from_variables())
        for (first, size), body in zip(places, bodies):
            brick.set_private_rhs(body.load, body.moved(loads))
            fixed = body.moved(model.fixed)
            goal[first : first + size][fixed] = body.moved(prescribed)[fixed]
        if model.friction:
            contact.begin_step()
        step = find_equilibrium(contact, held=held, prescribed=goal)
        iterations += step.iterations
        model.warnings += [*step.warnings, *(one.text for one in step.result.warnings)]
        if model.friction:
            contact.commit_step()
        moved = np.zeros_like(model.points)
        for body in bodies:
            moved[body.rows][body.order] = np.reshape(brick.variable(body.name), (-1, model.dim))
        found.append(moved)
    return np.array(found), iterations


def _symmetry(contact: GetfemContact, model: common.Model, bodies: list[Body]) -> np.ndarray:
    """Numbers of the contact's nodes in planes of symmetry, which it has in an order of its own."""
    places, found = contact.coords(np.zeros(contact.size)), []
    for body in bodies:
        own = contact.nodes(body.name)
        inside = model.symmetry[(model.symmetry >= body.rows.start) & (model.symmetry < body.rows.stop)]
        found += [own[int(np.argmin(((places[own] - model.points[point]) ** 2).sum(axis=1)))] for point in inside]
    return np.array(found)


if __name__ == "__main__":
    common.main(solve)
