"""Exceptions: one class for every status of the library, with the sentence that names indices and values.

All of them are ``FmcError``, and also what Python would call them: ``except ValueError`` catches an inverted cell,
``except IndexError`` a node that does not exist.
"""

from __future__ import annotations

import re

from ._constants import FMC_STATUS

# "facet or cell 2", "node 8", "nodes 0 and 1", "cells 0 and 1", "block 1", "coordinate 1", "point 0"
_NUMBERED = re.compile(
    r"\b(cells|cell or facet|facet or cell|cell block|facet block|block|cell|facet|nodes|node|body|obstacle|coordinate|point)"
    r" (-?\d+)(?: and (-?\d+))?"
)

_KEYS = {
    "facet or cell": "cell",
    "cell or facet": "cell",
    "cells": "cell",
    "cell block": "block",
    "facet block": "block",
    "nodes": "node",
}


class FmcError(Exception):
    """A call that failed. Its outputs and the contact are unchanged.

    ``status`` is the number of the header's ``fmc_status``; 0 for a library that could not be loaded.
    """

    status: int = 0

    @property
    def indices(self) -> dict[str, tuple[int, ...]]:
        """Indices that the sentence names, by their kind: ``{"cell": (1,), "node": (8,)}``. A cell that may be a facet is a ``"cell"``;
        ``"coordinate"`` is an axis."""
        found: dict[str, tuple[int, ...]] = {}
        for name, *numbers in _NUMBERED.findall(str(self)):
            found.setdefault(_KEYS.get(name, name), tuple(int(number) for number in numbers if number))
        return found


class LibraryError(FmcError, ImportError):
    """The shared library was not found, or is not of the version that this package is for."""


class NullPointerError(FmcError, ValueError):
    """Something that the library needs was not given."""


class MisalignedPointerError(FmcError, ValueError):
    """An array does not begin at a multiple of its element's size."""


class LengthError(FmcError, ValueError):
    """The length of an array does not match the mesh."""


class BufferTooSmallError(FmcError, ValueError):
    """An output array is too short."""


class StrideError(FmcError, ValueError):
    """Entries of an output share memory."""


class DimensionError(FmcError, ValueError):
    """A dimension other than 2 and 3, or a cell type of another dimension than the coordinates."""


class UnknownCellTypeError(FmcError, ValueError):
    """Not one of ``triangle``, ``quad``, ``tetra``, ``hexahedron``, ``wedge``, ``pyramid``."""


class NodeOutOfRangeError(FmcError, IndexError):
    """A cell or facet names a node that does not exist."""


class NonFiniteCoordinateError(FmcError, ValueError):
    """A coordinate is NaN or infinite."""


class RepeatedNodeError(FmcError, ValueError):
    """A cell or facet names one node twice."""


class InvertedCellError(FmcError, ValueError):
    """A cell is inverted."""


class ZeroMeasureError(FmcError, ValueError):
    """A cell or facet has no length, area or volume."""


class OpenSurfaceError(FmcError, ValueError):
    """A surface given by facets is not closed."""


class NonManifoldError(FmcError, ValueError):
    """More than two facets meet at an edge (2D: at a node), or more than two cells at a face."""


class InconsistentOrientationError(FmcError, ValueError):
    """Two neighbouring facets have opposite orientations."""


class InvertedSurfaceError(FmcError, ValueError):
    """The facets of a body point inwards."""


class EmptyError(FmcError, ValueError):
    """There are no cells and no facets."""


class NotPositiveError(FmcError, ValueError):
    """A parameter is not positive and finite, or an exponent not at least 1."""


class UnknownOptionError(FmcError, ValueError):
    """No option of this name."""


class BadValueError(FmcError, ValueError):
    """An option, a kind or a switch has no such value."""


class UnknownFlagError(FmcError, ValueError):
    """A flag that a function does not have."""


class OptionsConflictError(FmcError, ValueError):
    """Two options exclude one another, or one would have no effect in combination with the rest."""


class ReservedFieldError(FmcError, ValueError):
    """An option of a later version of the library."""


class StructSizeError(FmcError, RuntimeError):
    """A struct of another version of the library: package and library do not match."""


class BadPoseError(FmcError, ValueError):
    """A position or scale is not finite, a scale not positive, or a rotation not orthonormal with determinant +1."""


class ObstacleOutOfRangeError(FmcError, IndexError):
    """No obstacle of this index."""


class IndexOutOfRangeError(FmcError, IndexError):
    """No such entry in the last evaluation, or no evaluation yet."""


class UnsupportedError(FmcError, NotImplementedError):
    """The estimator, the law or this build of the library does not support this."""


class SignedDistanceError(FmcError, ValueError):
    """A signed distance is not finite. Exceptions of the function itself are raised unchanged."""


class TooManyFibersError(FmcError, ValueError):
    """The spacing is too small for the bodies."""


class ThreadsError(FmcError, RuntimeError):
    """The threads could not be started."""


class BusyError(FmcError, RuntimeError):
    """The contact is in use: by another thread, or by a call from inside one of its callbacks."""


class RangeError(FmcError, OverflowError):
    """A volume, energy or force exceeds the range of a double."""


class PanicError(FmcError, RuntimeError):
    """A defect of the library. The text gives the reason and the place."""


class DegenerateHullError(FmcError, ValueError):
    """The points of a convex hull lie in one plane (2D: on one line), or their hull cannot be found to rounding."""


class TooFewHeightsError(FmcError, ValueError):
    """A height field has fewer than two points along an axis."""


class NonFiniteHeightError(FmcError, ValueError):
    """A height is NaN or infinite."""


class EmptyCompoundError(FmcError, ValueError):
    """A compound has no parts."""


class NotPositiveMassError(FmcError, ValueError):
    """The mass of a node that feels contact is not positive."""


class BodyOutOfRangeError(FmcError, IndexError):
    """No body of this index."""


class ObstacleRemovedError(FmcError, IndexError):
    """The obstacle of this index was removed."""


class TooManyPiecesError(FmcError, ValueError):
    """The facets of a pair lie in so many layers that ``exact`` would cut them into too many pieces."""


class UnfinishedLinesError(FmcError, ValueError):
    """Lines along the boundary of a signed-distance obstacle would need more steps than are taken."""


class NoStepError(FmcError, RuntimeError):
    """Friction is on, but no step has begun: call ``contact.friction.begin_step``."""


class NonFiniteSlipError(FmcError, ValueError):
    """An elastic slip is NaN or infinite."""


class NegativeRadiusError(FmcError, ValueError):
    """A node lies beyond the axis, with axisymmetry: its first coordinate is negative."""


class NonConformingError(FmcError, ValueError):
    """Two cells, or facets of a surface without cells, do not conform: an edge or a face has a node in its middle in only one of them, or they have
    different nodes there."""


class SingularStiffnessError(FmcError, ValueError):
    """The stiffness of bodies and contact together is singular to rounding: a body is not held."""


class IndefiniteStiffnessError(FmcError, ValueError):
    """The stiffness of bodies and contact together is not positive definite."""


class DofOutOfRangeError(FmcError, IndexError):
    """A list of degrees of freedom names one that does not exist."""


class RepeatedDofError(FmcError, ValueError):
    """A list of degrees of freedom does not ascend, or names one that another list has."""


class NonFiniteStiffnessError(FmcError, ValueError):
    """A stiffness or a residual that was given is NaN or infinite."""


class PlaceError(FmcError, RuntimeError):
    """A function that places the nodes failed."""


class BadRankError(FmcError, ValueError):
    """The rank of a communicator is not from 0 to one less than its size."""


class CommunicationError(FmcError, RuntimeError):
    """A communicator failed."""


class OnOtherRankError(FmcError, RuntimeError):
    """The evaluation failed on another rank, which has the cause."""


class RanksDifferError(FmcError, ValueError):
    """Ranks that share the work were given different coordinates, options or obstacles, or made different calls."""


class NotGatheredError(FmcError, RuntimeError):
    """Coordinates at which a part of a mesh that was not gathered may be in contact."""


class NotPositiveDefiniteError(FmcError, ValueError):
    """The stiffness of bodies is not positive definite: they are not held, or buckle."""


class UnsymmetricError(FmcError, ValueError):
    """A matrix that has to be symmetric is not."""


class IndexSizeError(FmcError, ValueError):
    """Node numbers have neither 32 nor 64 bits, or not all the same width."""


class NoStiffnessError(FmcError, RuntimeError):
    """The contact has no stiffness: none was given, and none was found from the bodies' matrix."""


class UntiedError(FmcError, ValueError):
    """Two bodies are tied, or joined by a cohesive interface, and face one another nowhere within reach."""


class InterfaceLawError(FmcError, ValueError):
    """Your own law of an interface failed, or returned a number that is not finite."""


class EndedError(FmcError, RuntimeError):
    """The call was ended by its caller."""


class OutOfMemoryError(FmcError, RuntimeError):
    """Memory for large arrays cannot be had."""


class NotFactorisedError(FmcError, RuntimeError):
    """There are no factors of a matrix: none was given, or the last one had none."""


def _named(status: str) -> str:
    """Name of the class for ``error_null_pointer``. Some names are taken by Python."""
    words = status.replace("error_", "").title().replace("_", "")
    taken = {"Overflow": "Range", "Interrupted": "Ended", "Memory": "OutOfMemory"}
    return f"{taken.get(words, words)}Error"


_CLASSES = {name: one for name, one in list(globals().items()) if isinstance(one, type) and issubclass(one, FmcError)}

BY_STATUS = {number: _CLASSES[_named(name)] for number, name in FMC_STATUS.items() if _named(name) in _CLASSES}
"""Exception classes by the number of their status."""

for _number, _error in BY_STATUS.items():
    _error.status = _number


def of_status(status: int, text: str) -> FmcError:
    """The exception for a status; one that this package does not know keeps its number."""
    error = BY_STATUS.get(status, FmcError)(text)
    error.status = status
    return error
