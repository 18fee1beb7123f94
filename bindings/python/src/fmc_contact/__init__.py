"""Contact forces and overlap volume for any finite element code.

Node coordinates and connectivity go in, nodal contact forces and the overlap volume come out, by ``contact_force`` in
one call or by a ``Contact`` that is kept. Forces push bodies apart. Units are the caller's: with m and Pa, forces are N
(2D: N/m).

    search  ->  contact_force, OnUnknowns, PartitionedContact  ->  Contact
            ->  its parts: mesh, obstacles, pairs, ties, friction, multipliers, patches, pattern, ranks
            ->  creation, _core, options; results: result, fields, flux, gradients, forward, boundary, gaps, points, tangent
            ->  _handle, _arrays  ->  _library  ->  _signatures, _structs  ->  errors
"""

from . import errors
from ._library import library as _shared
from .added_ties import Ties
from .boundary import BoundaryFacets
from .cohesive import CohesiveInterface, CohesiveInterfaces, CohesivePoints
from .condensation import Condensation
from .contact import Contact
from .contact_step import ContactStep
from .errors import FmcError
from .fields import ContactPoints, NodalContact
from .flux import Conductance, ContactFlux, FrictionHeat
from .forward import Slopes
from .friction_laws import FrictionFacets, FrictionResponse, check_friction_law
from .gaps import GapConstraints
from .gradients import Gradients, PairGradient
from .laws import InterfaceLaws, LawPoints, LawResponse, LawStates, check_law
from .mesh import Adjustment
from .multipliers import MULTIPLIER, Augmentation
from .on_unknowns import OnUnknowns
from .options import Options, OtherOptions
from .partition import CARRIED_SLIP, GatheredCounts, PartitionedContact
from .points import PointWeights
from .pose import Pose
from .result import ContactWarning, Friction, Pair, Result, Resultant
from .search import Adjoint, Equilibrium, History, HistoryStart, NoSupportError, NotConvergedError, StepAdjoint, check_host, find_equilibrium
from .shape import Part, Shape
from .stateless import contact_force, contact_force_step
from .step_limit import StepLimit
from .stiffness import suggest_stiffness
from .tangent import RankOne, Tangent
from .ties import Tie, TieConstraints, TieNodes

__version__: str = _shared.fmc_version().decode()


def has_feature(name: str) -> bool:
    """Whether the library has a feature.

    Parameters
    ----------
    name : str
        Name of the feature, that a build can lack: ``"shapes"`` (convex hulls and compounds), ``"solver"`` (``Condensation``).

    Returns
    -------
    bool
        Whether the library has it. False for a name that it does not know.

    Examples
    --------
    >>> from fmc_contact import has_feature
    >>> has_feature("shapes")
    True
    """
    return bool(_shared.fmc_has_feature(name.encode()) == 1)


__all__ = [
    "CARRIED_SLIP",
    "MULTIPLIER",
    "Adjoint",
    "Adjustment",
    "Augmentation",
    "BoundaryFacets",
    "CohesiveInterface",
    "CohesiveInterfaces",
    "CohesivePoints",
    "Condensation",
    "Conductance",
    "Contact",
    "ContactFlux",
    "ContactPoints",
    "ContactStep",
    "ContactWarning",
    "Equilibrium",
    "FmcError",
    "Friction",
    "FrictionFacets",
    "FrictionHeat",
    "FrictionResponse",
    "GapConstraints",
    "GatheredCounts",
    "Gradients",
    "History",
    "HistoryStart",
    "InterfaceLaws",
    "LawPoints",
    "LawResponse",
    "LawStates",
    "NoSupportError",
    "NodalContact",
    "NotConvergedError",
    "OnUnknowns",
    "Options",
    "OtherOptions",
    "Pair",
    "PairGradient",
    "Part",
    "PartitionedContact",
    "PointWeights",
    "Pose",
    "RankOne",
    "Result",
    "Resultant",
    "Shape",
    "Slopes",
    "StepAdjoint",
    "StepLimit",
    "Tangent",
    "Tie",
    "TieConstraints",
    "TieNodes",
    "Ties",
    "check_friction_law",
    "check_host",
    "check_law",
    "contact_force",
    "contact_force_step",
    "errors",
    "find_equilibrium",
    "has_feature",
    "suggest_stiffness",
]
