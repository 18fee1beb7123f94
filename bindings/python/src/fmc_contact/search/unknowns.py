"""Which unknown of a host moves which coordinate of the contact."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..contact import Contact


class Moved:
    """Unknown of every coordinate; -1 for one that never moves."""

    def __init__(self, contact: Any, size: int) -> None:
        self.contact, self.size = contact, size
        self.inner: Contact = contact if isinstance(contact, Contact) else contact.contact
        count = self.inner.unknown_count * self.inner.dim
        self.of_coordinate = np.arange(count)
        if contact is not self.inner:
            # Unknowns that are their own numbers say which of them moves a coordinate.
            start = contact.coords(np.zeros(size))
            moved = (contact.coords(np.arange(1.0, size + 1.0)) - start).ravel()
            self.of_coordinate = np.rint(moved).astype(np.int64) - 1
            wave = np.sin(np.arange(size))
            told = np.where(self.of_coordinate < 0, 0.0, wave[np.clip(self.of_coordinate, 0, size - 1)])
            again = (contact.coords(wave) - start).ravel()
            if np.abs(again - told).max(initial=0.0) > 1e-9 * (1.0 + np.abs(start).max(initial=0.0)):
                raise ValueError("exactly one unknown has to move each coordinate of the contact, by the same amount")
        elif count != size:
            raise ValueError(f"x has {size} entries, the contact {count} degrees of freedom")

    def coords(self, x: np.ndarray) -> np.ndarray:
        """Coordinates that the contact is shown."""
        return x.reshape(-1, self.inner.dim) if self.contact is self.inner else self.contact.coords(x)
