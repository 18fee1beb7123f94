"""Contact in GetFEM: forces and tangent of ``fmc_contact`` on the variables of your model.

    contact = GetfemContact(model, "u", stiffness=1e9)
    newton(contact, young=1e9)

Layers: newton, Bricks  ->  GetfemContact  ->  field  ->  cells  ->  fmc_contact
"""

from .adapter import GetfemContact
from .bricks import Bricks
from .errors import LayoutError
from .load_step import newton

__all__ = ["Bricks", "GetfemContact", "LayoutError", "newton"]
