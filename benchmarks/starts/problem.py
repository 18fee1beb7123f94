"""A problem: what is solved, and what is expected of it, with the reason."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np
import solver


@dataclass(frozen=True)
class Expected:
    """A number of the equilibrium that is known from elsewhere."""

    name: str
    of: Callable[[Any], float]
    """The number, from what the driver returns."""
    value: float
    tolerance: float
    """Largest difference from the value."""
    reason: str
    """Where the value comes from, and why it holds to the tolerance."""


@dataclass(frozen=True)
class Refused:
    """That there is no equilibrium, and which motion nothing stops."""

    bodies: tuple
    """Bodies of which one has to be named."""
    reason: str
    direction: Optional[tuple] = None
    """Direction of the motion; not compared if None."""
    is_rotation: Optional[bool] = None
    within: float = 0.9
    """Least cosine between the direction and the one that is named."""

    def faults(self, error):
        """In what an error differs; empty if it names the motion."""
        found = []
        if error.body not in self.bodies:
            found.append(f"body {error.body} named, not {self.bodies}")
        if self.is_rotation is not None and bool(error.is_rotation) != self.is_rotation:
            found.append("a rotation named" if error.is_rotation else "a translation named")
        if self.direction is not None:
            a, b = np.asarray(error.direction, float), np.asarray(self.direction, float)
            cosine = a @ b / max(np.linalg.norm(a) * np.linalg.norm(b), 1e-300)
            if not cosine > self.within:
                found.append(f"direction {np.round(a, 3).tolist()}, not {np.round(b, 3).tolist()}")
        if str(error.body) not in str(error):
            found.append("the message does not name the body")
        return found


@dataclass(frozen=True)
class Step:
    """A load step."""

    host: Callable
    free: np.ndarray
    prescribed: Optional[np.ndarray] = None
    expected: tuple = ()
    refused: Optional[Refused] = None
    most_solves: int = 1000
    """Without the three that each update of multipliers may take."""
    told: str = ""
    """A word that a warning has to contain."""


@dataclass(frozen=True)
class Problem:
    """Load steps of one contact, from a start."""

    contact: Any
    start: np.ndarray
    steps: list
    has_friction: bool = False


@dataclass
class Outcome:
    """What a driver did with a problem."""

    faults: list = field(default_factory=list)
    numbers: list = field(default_factory=list)
    """Name, found and expected value of every number."""
    solves: list = field(default_factory=list)
    updates: list = field(default_factory=list)
    rigid_steps: list = field(default_factory=list)
    message: str = ""
    """Message of the error, or of the warnings."""
    seconds: float = 0.0
    """Of the processor."""


def run(problem):
    """Solves the steps of a problem one after the other, to the first fault of a driver."""
    outcome, begun = Outcome(), time.process_time()
    x = np.array(problem.start, float)
    for number, step in enumerate(problem.steps, 1):
        x = _solved(problem, step, x, outcome, f"step {number}: " if len(problem.steps) > 1 else "")
        if x is None:
            break
    outcome.seconds = time.process_time() - begun
    return outcome


def _solved(problem, step, x, outcome, place):
    """Takes one step. Returns its end, or None where there is none."""
    if problem.has_friction:
        problem.contact.begin_step(x)
    try:
        found = solver.solve(step.host, problem.contact, x, step.free, step.prescribed)
    except solver.NoSupportError as error:
        outcome.message = str(error)
        outcome.faults += [place + one for one in step.refused.faults(error)] if step.refused else [place + f"refused: {error}"]
        return None
    except solver.NotConvergedError as error:
        outcome.message = str(error)
        outcome.faults.append(place + f"not converged: {error}")
        return None
    outcome.solves.append(found.iterations)
    outcome.updates.append(solver.updates(found))
    outcome.rigid_steps.append(solver.rigid_steps(found))
    texts = solver.warnings(found)
    outcome.message = "; ".join(texts)
    if step.refused:
        outcome.faults.append(place + f"returned, though {step.refused.reason}; largest displacement {np.abs(found.x).max():.1e}")
        return None
    for one in step.expected:
        value = float(one.of(found))
        outcome.numbers.append((place + one.name, value, one.value))
        if not abs(value - one.value) <= one.tolerance:
            outcome.faults.append(place + f"{one.name} is {value:.10g}, not {one.value:.10g} to {one.tolerance:.1g} ({one.reason})")
    most = step.most_solves + 3 * solver.updates(found)
    if found.iterations > most:
        outcome.faults.append(place + f"{found.iterations} solves, at most {most} are expected with {solver.updates(found)} updates")
    if step.told and not any(step.told in text for text in texts):
        outcome.faults.append(place + f"no warning says '{step.told}'")
    if problem.has_friction:
        problem.contact.commit_step(found.x)
    return found.x
