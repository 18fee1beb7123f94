"""Newton's method for bodies in contact, one load step a call.

    driver  ->  search  ->  plain, levels, line_search, friction, patches, penetration, prescribed  ->  state  ->  equilibrium
"""

from .driver import newton
from .equilibrium import Equilibrium, NotConvergedError
from .penetration import Raising
from .predicted import predicted

__all__ = ["Equilibrium", "NotConvergedError", "Raising", "newton", "predicted"]
