"""Programs of ``parallel.py`` in which something goes wrong, on one rank only where that is possible."""

import time

import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem import petsc
from fmc_contact import errors
from fmc_contact_dolfinx import ContactProblem, DolfinxContact, find_equilibrium
from fmc_contact_dolfinx.versions import mesh_from_cells, vector_space
from parallel import elastic, pressed
from scenes import COMM, blocks


def fail(kind):
    """Something goes wrong, on one rank only where that is possible; every rank must see an exception."""
    last = COMM.size - 1
    x, cells = blocks("triangle")
    space = vector_space(mesh_from_cells(COMM, x, cells, "triangle"))
    contact = DolfinxContact(space, stiffness=1e4, estimator="exact")
    u = fem.Function(space)
    contact.force(u)
    expected = errors.FmcError
    if kind == "nan":
        if COMM.rank == last:
            u.x.array[0] = np.nan
    elif kind == "inverted":
        u.interpolate(lambda p: np.stack([-2.5 * p[0], 0 * p[0]]))
        expected = errors.InvertedCellError
    elif kind == "layout":
        expected = TypeError
    elif kind in ("length", "callback", "search"):
        expected = (ValueError, ZeroDivisionError)
    begin = time.perf_counter()
    try:
        if kind == "layout":
            scalar = fem.FunctionSpace(space.mesh, ("CG", 1)) if hasattr(fem, "FunctionSpace") else None
            DolfinxContact(scalar if COMM.rank == last and scalar is not None else space, stiffness=1.0)
        elif kind == "length":
            contact.force(np.zeros(3) if COMM.rank == last else u)
        elif kind in ("callback", "search"):
            other = DolfinxContact(space, stiffness=1e4, in_parts=False)

            def distance(points):
                if COMM.rank == last:
                    raise ZeroDivisionError("of the last rank")
                return points[:, 1] + 10.0, np.tile([0.0, 1.0], (len(points), 1))

            other.contact.obstacles.add_signed_distance(distance)
            if kind == "search":
                find_equilibrium(ContactProblem(elastic(u, ufl.TestFunction(space)), u, pressed(space), other))
            other.force(u)
        else:
            contact.force(u)
    except expected as error:
        print(
            f"rank {COMM.rank} saw {type(error).__name__}: {error}: after {time.perf_counter() - begin} s", flush=True
        )
    u.x.array[:] = 0.0
    contact.force(u)
    print(f"rank {COMM.rank} goes on", flush=True)


def fail_later(what):
    """A function of the host raises on the last rank, sooner or later in a search: every rank must see that, and the displacements stay."""
    x, cells = blocks("triangle")
    space = vector_space(mesh_from_cells(COMM, x, cells, "triangle"))
    contact = DolfinxContact(space, stiffness=1e4, in_parts=False)
    u, calls, fails_at = fem.Function(space), 0, np.inf

    def count():
        nonlocal calls
        calls += 1
        if calls == fails_at and COMM.rank == COMM.size - 1:
            raise ZeroDivisionError("of the last rank")

    def distance(points):
        count()
        return points[:, 1] + 10.0, np.tile([0.0, 1.0], (len(points), 1))

    problem = ContactProblem(elastic(u, ufl.TestFunction(space)), u, pressed(space), contact)
    if what == "contact":
        contact.contact.obstacles.add_signed_distance(distance)
    else:
        assemble = petsc.assemble_vector
        petsc.assemble_vector = lambda *arguments: [count(), assemble(*arguments)][1]
    find_equilibrium(problem)
    most = COMM.bcast(calls, COMM.size - 1)
    assert most > 1
    for at in sorted({1, 2, most // 4 + 1, most // 2, most - 1, most}):
        u.x.array[:], calls, fails_at = 0.0, 0, at
        # Friction and multipliers apart, a search leaves the contact as it was: each is the first one again.
        problem.on_unknowns = None
        try:
            find_equilibrium(problem)
            print(f"rank {COMM.rank} was told nothing of call {at} of {most}", flush=True)
        except ZeroDivisionError as error:
            assert str(error) == "of the last rank" and not u.x.array.any()
    u.x.array[:], calls, fails_at = 0.0, 0, np.inf
    find_equilibrium(problem)
    print(f"rank {COMM.rank} goes on", flush=True)
