"""Common part of the operators for JAX and PyTorch: a contact with its parameters, and its values and derivatives for them."""

from __future__ import annotations

from typing import Optional

import numpy as np

from .contact import Contact

Given = Optional[np.ndarray]


class Operator:
    """A contact as a function of coordinates, undeformed coordinates and stiffness; the last two may be left as they are."""

    def __init__(self, contact: Contact) -> None:
        self.contact = contact
        self._reference: Given = None

    def _tell(self, reference: Given, stiffness: Given) -> None:
        if reference is not None and (self._reference is None or not np.array_equal(reference, self._reference)):
            self.contact.mesh.set_reference(reference)
            self._reference = np.array(reference)
        if stiffness is not None and float(stiffness) != self.contact.options["stiffness"]:
            self.contact.set_options(stiffness=float(stiffness))

    def energy(self, coords: np.ndarray, reference: Given, stiffness: Given) -> np.ndarray:
        """The contact energy."""
        self._tell(reference, stiffness)
        return np.array(self.contact.evaluate(coords).energy)

    def forces(self, coords: np.ndarray, reference: Given, stiffness: Given) -> np.ndarray:
        """The nodal forces."""
        self._tell(reference, stiffness)
        return self.contact.evaluate(coords).forces

    def gradients(
        self,
        coords: np.ndarray,
        reference: Given,
        stiffness: Given,
        adjoint: Given = None,
        energy: float = 0.0,
        by: tuple[str, ...] = (),
    ) -> tuple[np.ndarray, ...]:
        """The derivatives by ``by``, in its order: a subset of coords, reference, stiffness."""
        self._tell(reference, stiffness)
        found = self.contact.vjp(coords, adjoint, energy, by)
        of_all = {"coords": found.coords, "reference": found.reference}
        # A pair with a law of its own does not follow the stiffness of the contact.
        options = self.contact.pairs.options
        of_all["stiffness"] = np.array(
            sum((pair.stiffness for pair in found.pairs if options(pair.a, pair.b)["law"] is None), 0.0)
        )
        return tuple(np.asarray(of_all[name]) for name in by)


def given(reference: object, stiffness: object) -> tuple[str, ...]:
    """The names of the given arguments."""
    return tuple(name for name, value in (("reference", reference), ("stiffness", stiffness)) if value is not None)
