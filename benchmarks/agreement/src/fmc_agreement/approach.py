"""A start for Newton's method: bodies that only contact holds are moved, undeformed, to where it carries their load."""

from __future__ import annotations

from typing import Callable

import numpy as np

from .problem import Body, Problem

SOFT = 50.0
"""Stiffness of a soft contact by E / size of the softest body: a body that comes to rest on hard contact would creep
there, every step as long as the next gap is wide. The reference host's choice."""


def soft_stiffness(problem: Problem) -> float:
    """A stiffness on which a loose body settles at once, Pa/m."""
    sizes = [np.ptp(problem.coords[body.nodes], axis=0).max() for body in problem.bodies]
    return SOFT * min(body.material.young / size for body, size in zip(problem.bodies, sizes))


def loose_push(problem: Problem, body: Body, load: np.ndarray) -> np.ndarray:
    """Load of a body along the axes on which nothing holds it, (dim,)."""
    return np.where(problem.held[body.nodes].any(axis=0), 0.0, load[body.nodes].sum(axis=0))


def approach(
    problem: Problem, start: np.ndarray, load: np.ndarray, force: Callable[[np.ndarray], np.ndarray]
) -> np.ndarray:
    """Displacements (nodes, dim): those of the start, with every loose body moved along its load until contact carries
    it.

    ``load`` (nodes, dim); ``force`` gives contact forces (nodes, dim) at displacements.
    """
    u = start.copy()
    for body in problem.bodies:
        nodes, push = body.nodes, loose_push(problem, body, load)
        size = np.linalg.norm(push)
        if size == 0.0:
            continue
        direction = push / size
        reach = np.ptp(problem.coords[nodes], axis=0).max()

        def missing(length: float) -> float:
            moved = u.copy()
            moved[nodes] += length * direction
            return size + force(moved)[nodes].sum(axis=0) @ direction

        low, high = 0.0, 1e-6 * reach
        while missing(high) > 0.0:
            low, high = high, 2.0 * high
            if high > 10.0 * reach:
                raise RuntimeError(f"nothing stops '{body.name}'")
        for _ in range(60):
            middle = 0.5 * (low + high)
            if abs(found := missing(middle)) < 0.05 * size:
                break
            low, high = (middle, high) if found > 0.0 else (low, middle)
        u[nodes] += middle * direction
    return u
