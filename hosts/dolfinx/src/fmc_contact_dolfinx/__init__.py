"""Contact in FEniCSx: forces and tangent of ``fmc_contact`` on the degrees of freedom of your spaces, on any number of
MPI ranks.

    contact = DolfinxContact(V, stiffness=1e9)
    problem = ContactProblem(residual_form, u, bcs, contact)
    problem.solve()          # or, on one rank, newton(problem, young=E)

    newton, ContactProblem, attach, with_contact  ->  DolfinxContact, FilteredMultigrid  ->  linearised  ->  in_parts, replicated
      ->  own_part, components, surface  ->  entries, points, replica, space  ->  versions, together  ->  cells
"""

from .adapter import DolfinxContact
from .filtered_multigrid import FilteredMultigrid
from .input_numbers import by_input_number, set_by_input_number
from .newton import newton
from .nonlinear import attach, with_contact
from .snes import ContactProblem
from .space import LayoutError
from .together import OtherRankError

__all__ = [
    "ContactProblem",
    "DolfinxContact",
    "FilteredMultigrid",
    "LayoutError",
    "OtherRankError",
    "attach",
    "by_input_number",
    "newton",
    "set_by_input_number",
    "with_contact",
]
