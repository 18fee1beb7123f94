"""Exceptions: one class for every status of the library, with the sentence that names indices and values.

All of them are ``FmcError``, and also what Python would call them: ``except ValueError`` catches an inverted cell,
``except IndexError`` a node that does not exist.
"""

from __future__ import annotations

import re

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
    """A call that failed. Its outputs are untouched, and the contact is as it was before.

    ``status`` is the number of the header's ``fmc_status``; 0 for a library that could not be loaded.
    """

    status: int = 0

    @property
    def indices(self) -> dict[str, tuple[int, ...]]:
        """Numbers that the sentence names, by what they number: ``{"cell": (1,), "node": (8,)}``. A cell that may be
        a facet is a ``"cell"``; ``"coordinate"`` is an axis."""
        found: dict[str, tuple[int, ...]] = {}
        for name, *numbers in _NUMBERED.findall(str(self)):
            found.setdefault(_KEYS.get(name, name), tuple(int(number) for number in numbers if number))
        return found


class LibraryError(FmcError, ImportError):
    """The shared library was not found, or is not of the version that this package is for."""


class NullPointerError(FmcError, ValueError):
    """Something that the library needs was not given."""

    status = 1


class MisalignedPointerError(FmcError, ValueError):
    """An array does not begin at a multiple of its element's size."""

    status = 2


class LengthError(FmcError, ValueError):
    """The length of an array is not what the mesh says."""

    status = 3


class BufferTooSmallError(FmcError, ValueError):
    """An output is shorter than what is to be written into it."""

    status = 4


class StrideError(FmcError, ValueError):
    """Entries of an output share memory."""

    status = 5


class DimensionError(FmcError, ValueError):
    """A dimension other than 2 and 3, or a cell type of another dimension than the coordinates."""

    status = 6


class UnknownCellTypeError(FmcError, ValueError):
    """Not one of ``triangle``, ``quad``, ``tetra``, ``hexahedron``, ``wedge``, ``pyramid``."""

    status = 7


class NodeOutOfRangeError(FmcError, IndexError):
    """A cell or facet names a node that does not exist."""

    status = 8


class NonFiniteCoordinateError(FmcError, ValueError):
    """A coordinate is NaN or infinite."""

    status = 9


class RepeatedNodeError(FmcError, ValueError):
    """A cell or facet names one node twice."""

    status = 10


class InvertedCellError(FmcError, ValueError):
    """A cell is inverted."""

    status = 11


class ZeroMeasureError(FmcError, ValueError):
    """A cell or facet has no length, area or volume."""

    status = 12


class OpenSurfaceError(FmcError, ValueError):
    """A surface given by facets is not closed."""

    status = 13


class NonManifoldError(FmcError, ValueError):
    """More than two facets meet at an edge (2D: at a node), or more than two cells at a face."""

    status = 14


class InconsistentOrientationError(FmcError, ValueError):
    """Two neighbouring facets have opposite orientations."""

    status = 15


class InvertedSurfaceError(FmcError, ValueError):
    """The facets of a body point inwards."""

    status = 16


class EmptyError(FmcError, ValueError):
    """There are no cells and no facets."""

    status = 17


class NotPositiveError(FmcError, ValueError):
    """A parameter is not positive and finite, or an exponent not at least 1."""

    status = 18


class UnknownOptionError(FmcError, ValueError):
    """No such option, no such value of an option, or two options that exclude one another."""

    status = 19


class StructSizeError(FmcError, RuntimeError):
    """A struct of another version of the library: package and library do not match."""

    status = 20


class BadPoseError(FmcError, ValueError):
    """A position or scale is not finite, a scale not positive, or a rotation not orthonormal with determinant +1."""

    status = 21


class ObstacleOutOfRangeError(FmcError, IndexError):
    """No obstacle of this index."""

    status = 22


class IndexOutOfRangeError(FmcError, IndexError):
    """No such entry in the last evaluation, or no evaluation yet."""

    status = 23


class UnsupportedError(FmcError, NotImplementedError):
    """The estimator, the law or this build of the library does not support this."""

    status = 24


class SignedDistanceError(FmcError, ValueError):
    """A signed distance is not finite. Exceptions of the function itself are raised unchanged."""

    status = 25


class TooManyFibersError(FmcError, ValueError):
    """The spacing is too small for the bodies."""

    status = 26


class ThreadsError(FmcError, RuntimeError):
    """The threads could not be started."""

    status = 27


class BusyError(FmcError, RuntimeError):
    """The contact is in use: by another thread, or by a call from inside one of its callbacks."""

    status = 28


class RangeError(FmcError, OverflowError):
    """A volume, energy or force exceeds the range of a double."""

    status = 29


class PanicError(FmcError, RuntimeError):
    """A defect of the library. The text says what and where."""

    status = 30


class DegenerateHullError(FmcError, ValueError):
    """The points of a convex hull lie in one plane (2D: on one line), or their hull cannot be found to rounding."""

    status = 31


class TooFewHeightsError(FmcError, ValueError):
    """A height field has fewer than two points along an axis."""

    status = 32


class NonFiniteHeightError(FmcError, ValueError):
    """A height is NaN or infinite."""

    status = 33


class EmptyCompoundError(FmcError, ValueError):
    """A compound has no parts."""

    status = 34


class NotPositiveMassError(FmcError, ValueError):
    """The mass of a node that feels contact is not positive."""

    status = 35


class BodyOutOfRangeError(FmcError, IndexError):
    """No body of this index."""

    status = 36


class ObstacleRemovedError(FmcError, IndexError):
    """The obstacle of this index was removed."""

    status = 37


class TooManyPiecesError(FmcError, ValueError):
    """The facets of a pair lie in so many layers that ``exact`` would cut them into more pieces than can be worked
    through."""

    status = 38


class UnfinishedLinesError(FmcError, ValueError):
    """Lines along the boundary of a signed-distance obstacle would need more steps than are taken."""

    status = 39


class NoStepError(FmcError, RuntimeError):
    """Friction is asked for, but no step has begun: call ``contact.friction.begin_step``."""

    status = 40


class NonFiniteSlipError(FmcError, ValueError):
    """An elastic slip is NaN or infinite."""

    status = 41


class NegativeRadiusError(FmcError, ValueError):
    """A node lies beyond the axis, with axisymmetry: its first coordinate is negative."""

    status = 42


class NonConformingError(FmcError, ValueError):
    """Two cells, or facets of a surface without cells, do not fit: an edge or a face has a node in its middle in one of
    them, and in the other it has none, or another one."""

    status = 43


class SingularStiffnessError(FmcError, ValueError):
    """The stiffness of bodies and contact together is singular to rounding: a body is not held."""

    status = 44


class IndefiniteStiffnessError(FmcError, ValueError):
    """The stiffness of bodies and contact together is not positive definite."""

    status = 45


class FreedomOutOfRangeError(FmcError, IndexError):
    """A list of degrees of freedom names one that does not exist."""

    status = 46


class RepeatedFreedomError(FmcError, ValueError):
    """A list of degrees of freedom does not ascend, or names one that another list has."""

    status = 47


class NonFiniteStiffnessError(FmcError, ValueError):
    """A stiffness or a residual that was given is NaN or infinite."""

    status = 48


class PlaceError(FmcError, RuntimeError):
    """A function that places the nodes failed."""

    status = 49


class BadRankError(FmcError, ValueError):
    """The rank of a communicator is not from 0 to one less than its size."""

    status = 50


class CommunicationError(FmcError, RuntimeError):
    """A communicator failed."""

    status = 51


class OnOtherRankError(FmcError, RuntimeError):
    """The evaluation failed on another rank, which has the cause."""

    status = 52


class RanksDifferError(FmcError, ValueError):
    """Ranks that share the work were given different coordinates, options or obstacles, or asked for different things."""

    status = 53


class NotGatheredError(FmcError, RuntimeError):
    """Coordinates at which a part of a mesh that was not gathered may be in contact."""

    status = 54


class NotPositiveDefiniteError(FmcError, ValueError):
    """The stiffness of bodies is not positive definite: they are not held, or buckle."""

    status = 55


class UnsymmetricError(FmcError, ValueError):
    """A matrix that has to be symmetric is not."""

    status = 56


class NotFactorisedError(FmcError, RuntimeError):
    """There are no factors of a matrix: none was given, or the last one had none."""

    status = 57


BY_STATUS = {error.status: error for error in FmcError.__subclasses__() if error.status}
"""Exception classes by the number of their status."""


def of_status(status: int, text: str) -> FmcError:
    """The exception for a status; one that this package does not know keeps its number."""
    error = BY_STATUS.get(status, FmcError)(text)
    error.status = status
    return error
