"""The driver and the contact of the library, as the problems call them.

Problems name no function of the library, so a changed name is changed here. ``STARTS_DRIVER`` names another module with ``find_equilibrium`` and
``NoSupportError`` to be tried on the same problems.
"""

import importlib
import os

import fmc_contact
from fmc_contact_skfem import SkfemContact

_DRIVER = importlib.import_module(os.environ.get("STARTS_DRIVER", "fmc_contact"))

NotConvergedError = fmc_contact.NotConvergedError


class _Never(NotConvergedError):
    """What a driver that cannot name a body does not raise."""


NoSupportError = getattr(_DRIVER, "NoSupportError", _Never)


def contact_of(bodies, **options):
    """Contact of all bodies, without a stiffness."""
    try:
        return SkfemContact(bodies.pairs, **options)
    except TypeError:
        # Drivers of other modules set a stiffness themselves.
        return SkfemContact(bodies.pairs, stiffness=1.0, **options)


def solve(host, contact, x, free, prescribed=None):
    """Equilibrium at the end of a load step."""
    return _DRIVER.find_equilibrium(host, contact, x, free, prescribed)


def rigid_steps(found):
    """Steps of rigid bodies before the first linear solve."""
    return int(getattr(found, "rigid_steps", 0))


def updates(found):
    """Updates of multipliers, if the driver counts them."""
    return int(getattr(found, "updates", 0))


def warnings(found):
    """Warnings of the driver and of the contact, as texts."""
    texts = [str(one) for one in getattr(found, "warnings", ())]
    return texts + [f"{one.kind}: {one.text}" for one in found.result.warnings]
