"""Linear solves of load steps on five problems: the tables of docs/newton.md.

    python study.py [problem [cells [law [stiffness [recipe [load steps]]]]]]

Each is a list with commas, but for the number of load steps; "all" are all problems. Stiffnesses are by Young's modulus and the
size of a facet. Recipes: "search" is ``fmc_contact.find_equilibrium``, "whole" the same with bodies that are not condensed. The others are
a plain Newton's method: "first" has the semidefinite tangent in the first two iterations of each load step, "always" in all of them,
"full" in none. With the law "fiber" patches are kept from the start of each load step; with "anew", which is "whole" otherwise, they
are not.
"""

import sys
import time

import numpy as np
import problems
from fmc_contact import FmcError, NotConvergedError, find_equilibrium
from scipy.sparse.linalg import spsolve

LAWS = {
    "depth": {"law": "depth", "estimator": "auto"},
    "exact": {"law": "fiber", "estimator": "exact", "momentum_correction": False},
    "fibers": {"law": "fiber", "estimator": "fibers", "momentum_correction": False},
}
SEMIDEFINITE = {"full": 0, "first": 2, "always": 1000}
LIMIT = 30


def plainly(host, contact, u, problem, prescribed, semidefinite):
    """One load step with the stiffness asked for from the first iteration on: solution and number of linear solves."""
    step, free = prescribed - u, problem.free
    for iteration in range(LIMIT):
        inside, matrix = host(u)
        pushed = contact.force(u)
        residual = inside - pushed
        size = max(np.linalg.norm(inside), np.linalg.norm(pushed))
        if not np.isfinite(size):
            raise FmcError("inverted")
        if not step.any() and np.linalg.norm(residual[free]) <= 1e-9 * size:
            return u, iteration, inside
        matrix = (matrix + contact.tangent(u, semidefinite=iteration < semidefinite)).tocsr()
        step[free] = spsolve(matrix[free][:, free], -(residual + matrix @ step)[free])
        u, step = u + step, np.zeros(len(u))
    raise NotConvergedError("no end", [])


def load_steps(problem, contact, recipe="search"):
    """Linear solves of every load step, and what the moved unknowns are pressed with at the end. A load step that fails
    ends the list, by "x" after so many iterations or "inverted"."""
    u, counts, pressed = np.zeros(contact.size), [], float("nan")

    def host(u):
        return problem.solid.forces(u), problem.solid.stiffness(u)

    for push in problem.pushes:
        prescribed = u.copy()
        prescribed[problem.moved] = push
        if contact.contact.options["law"] == "fiber" and recipe != "anew":
            contact.keep_patches(u)
        try:
            if recipe in ("search", "whole", "anew"):
                two_level = None if recipe == "search" else False
                found = find_equilibrium(host, contact, u, problem.free, prescribed, max_iterations=LIMIT, two_level=two_level)
                u, count, pressed = found.x, found.iterations, found.reactions[problem.moved].sum()
            else:
                u, count, inside = plainly(host, contact, u, problem, prescribed, SEMIDEFINITE[recipe])
                pressed = inside[problem.moved].sum()
        except FmcError as error:
            counts.append("x" if str(error).endswith(("wanted", "end")) else "inverted")
            break
        counts.append(count)
    return counts, pressed


def main(names="all", cells="16,32", laws="depth", stiffnesses="10", recipes="search", steps="8"):
    for name in list(problems.ALL) if names == "all" else names.split(","):
        for count in map(int, cells.split(",")):
            problem = problems.ALL[name](count)
            if len(problem.pushes) > 1:
                problem.pushes = problems.growing(int(steps))
            for law in laws.split(","):
                for stiffness in map(float, stiffnesses.split(",")):
                    for recipe in recipes.split(","):
                        start = time.perf_counter()
                        counts, pressed = load_steps(problem, problem.contact(stiffness, **LAWS[law]), recipe)
                        took = time.perf_counter() - start
                        text = " ".join(map(str, counts))
                        case = f"{name:10} {count:4} {law:6} {stiffness:5g} {recipe:6}"
                        print(f"{case} | {text:22} | {-pressed:.5g} | {took:.1f} s", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
