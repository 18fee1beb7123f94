"""Contact in FEniCSx: forces and tangent of ``fmc_contact`` on the degrees of freedom of your spaces, on any number of
MPI ranks.

    contact = DolfinxContact(V)
    problem = ContactProblem(residual_form, u, bcs, contact)
    find_equilibrium(problem)

    find_equilibrium  ->  on_ranks  ->  ContactProblem, attach, with_contact  ->  system  ->  DolfinxContact, FilteredMultigrid
      ->  linearised  ->  in_parts, replicated  ->  own_part, components, surface, symmetry  ->  entries, points, replica, space, unknowns
      ->  versions, together  ->  cells
"""

from .adapter import DolfinxContact
from .equilibrium import find_equilibrium
from .filtered_multigrid import FilteredMultigrid
from .input_numbers import by_input_number, set_by_input_number
from .nonlinear import attach, with_contact
from .problem import ContactProblem
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
    "find_equilibrium",
    "set_by_input_number",
    "with_contact",
]
