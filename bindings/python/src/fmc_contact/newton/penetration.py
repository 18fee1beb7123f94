"""As little penetration as is wanted: the method of multipliers, beside the iterations of Newton's."""

from __future__ import annotations

from ..contact import Contact
from .equilibrium import NotConvergedError
from .state import Model, State

# Residual by the forces below which surfaces are moved out: an equilibrium is not waited for, since the next one is another.
_NEAR = 1e-2

# Part of a change that an update may leave; where it leaves more, k is raised by the factor that follows.
_SLOW = 0.25
_RAISE = 4.0

# Factor, at most, by which it is raised over all load steps: where a node or two come and go, a stiffer law makes no update better.
_MOST_RAISED = 16.0

# Attribute of a contact: the factor by which its stiffness was raised.
_RAISED = "_raised_by_newton"


class Raising:
    """The stiffness of a contact from one update of its multipliers to the next."""

    def __init__(self) -> None:
        self.last = float("inf")

    def updated(self, contact: Contact, change: float) -> None:
        """After an update that was asked for such a change."""
        is_slow, self.last = change > _SLOW * self.last, change
        raised = getattr(contact, _RAISED, 1.0)
        if is_slow and raised < _MOST_RAISED:
            contact.stiffen(_RAISE)
            setattr(contact, _RAISED, _RAISE * raised)
            self.last = float("inf")


class Penetration:
    """Updates of the multipliers in a load step."""

    def __init__(self, model: Model, wanted: float, reach: float, most: int) -> None:
        if not wanted > 0:
            raise ValueError(f"the penetration is {wanted}, a positive one is wanted")
        options = model.inner.options
        if options["friction_coefficient"] or options["cohesion"]:
            raise ValueError("a penetration asked for with friction is not there")
        if options["self_contact"]:
            raise ValueError("a penetration asked for with a body in contact with itself is not there")
        self.model, self.wanted, self.reach, self.most = model, wanted, reach, most
        self.updates, self.found, self.is_converged, self.raising = 0, float("nan"), False, Raising()

    def moved_out(self, state: State, tolerance: float) -> State:
        """The state with surfaces moved out by what they penetrate, if the bodies are near an equilibrium and that is too much."""
        self.is_converged = False
        if not state.relative <= max(_NEAR, tolerance):
            return state
        now = self.model.inner.multipliers.augment(self.model.coords(state.x), self.wanted, self.reach)
        self.found, self.is_converged = now.penetration, now.is_converged
        if now.is_converged:
            return state
        if self.updates == self.most:
            left = max(now.penetration, now.change)
            raise NotConvergedError(f"a penetration of {left:.1e} after {self.most} updates, {self.wanted:.1e} is wanted", [])
        self.updates += 1
        self.raising.updated(self.model.inner, now.change)
        return self.model.again(state)
