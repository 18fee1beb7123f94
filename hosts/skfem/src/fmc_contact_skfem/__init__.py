"""Contact in scikit-fem: forces and tangent of ``fmc_contact`` on the degrees of freedom of your bases.

    contact = SkfemContact(basis, stiffness=1e9)
    residual = stiffness @ u - load - contact.force(u)
    matrix = stiffness + contact.tangent(u)

Layers: SkfemContact  ->  bases  ->  field  ->  other_basis  ->  fmc_contact
"""

from .adapter import SkfemContact
from .errors import LayoutError

__all__ = ["LayoutError", "SkfemContact"]
