"""Runs the program of a host and records all states that it finds: python record.py PROGRAM STATES.npz

The program is run as it stands. Its calls of ``find_equilibrium`` are recorded, and the last contact goes on from where the program ends:
the push is taken back to nothing, the upper block is lifted off by a tenth of the first push, and pressed again.
"""

import runpy
import sys

import fmc_contact
import numpy as np

find, calls = fmc_contact.find_equilibrium, []

STEPS = "pressed", "half way back", "back", "lifted off", "pressed again"
"""The states that are recorded; the first two are those of the program."""


def recorded(host, contact, x, free, prescribed, **options):
    found = find(host, contact, x, free, prescribed, **options)
    calls.append((found, (host, contact, x, free, prescribed)))
    return found


def on_nodes(contact, x):
    """Coordinates of the nodes in one order for all hosts: by place in the undeformed blocks."""
    return x if isinstance(contact, fmc_contact.Contact) else contact.coords(x)


def go_on():
    host, contact, start, free, pressed = calls[0][1]
    push = pressed - start
    for part in (0.0, -0.1, 1.0):
        recorded(host, contact, calls[-1][0].x, free, start + part * push)


def main(program, states):
    fmc_contact.find_equilibrium = recorded
    runpy.run_path(program, run_name="__main__")
    go_on()
    assert len(calls) == len(STEPS), f"{program} makes {len(calls) - 3} load steps, 2 are expected"
    contact = calls[0][1][1]
    points = on_nodes(contact, calls[0][1][2])
    order = np.lexsort(np.round(points, 6).T)
    np.savez(
        states,
        points=points[order],
        x=[on_nodes(contact, found.x)[order] for found, _ in calls],
        forces=[found.result.forces[order] for found, _ in calls],
        resultants=[[body.force for body in found.result.bodies] for found, _ in calls],
        iterations=[found.iterations for found, _ in calls],
        updates=[found.updates for found, _ in calls],
        # None where nothing presses.
        penetration=np.array([found.penetration for found, _ in calls], dtype=float),
        warnings=["; ".join(found.warnings) for found, _ in calls],
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
