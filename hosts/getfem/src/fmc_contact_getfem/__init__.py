"""Contact in GetFEM: forces and tangent of ``fmc_contact`` on the variables of your model.

    contact = GetfemContact(model, "u")
    find_equilibrium(contact)

``Bricks(contact)`` are for a loop of your own around GetFEM's ``solve``.

Layers: find_equilibrium  ->  Bricks, system  ->  GetfemContact  ->  field  ->  cells  ->  fmc_contact
"""

from .adapter import GetfemContact
from .bricks import Bricks
from .errors import LayoutError
from .load_step import find_equilibrium

__all__ = ["Bricks", "GetfemContact", "LayoutError", "find_equilibrium"]
