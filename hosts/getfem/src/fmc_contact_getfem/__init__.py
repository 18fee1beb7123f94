"""Contact in GetFEM: forces and tangent of ``fmc_contact`` on the variables of your model.

    contact = GetfemContact(model, "u", stiffness=1e9)
    newton(contact, young=1e9)

or, in a model that GetFEM solves by itself, ``newton_by_bricks(Bricks(contact), young=1e9)``.

Layers: newton, newton_by_bricks  ->  Bricks, system  ->  GetfemContact  ->  field  ->  cells  ->  fmc_contact
"""

from .adapter import GetfemContact
from .bricks import Bricks
from .by_bricks import newton_by_bricks
from .errors import LayoutError
from .load_step import newton

__all__ = ["Bricks", "GetfemContact", "LayoutError", "newton", "newton_by_bricks"]
