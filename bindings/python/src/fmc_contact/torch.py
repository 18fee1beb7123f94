"""Contact energy and forces as functions that PyTorch differentiates.

``energy`` is twice differentiable by coordinates. An operator tells its contact the undeformed coordinates and the stiffness that it
is called with, so that the contact is the operator's alone. Tensors are of float64 on the CPU.
"""

from __future__ import annotations

from typing import Any, Callable

import torch

from ._operators import Operator
from .contact import Contact


def energy(contact: Contact) -> Callable[..., Any]:
    """The contact energy as a function ``of(coords, reference=None, stiffness=None)``.

    Parameters
    ----------
    contact : Contact
        The contact; its obstacles, options and friction stay as they are.

    Returns
    -------
    callable
        A function of tensors of float64, (n, dim), (n, dim) and (); ``None`` leaves what the contact has. It returns a ().

    Raises
    ------
    TypeError
        The function raises it for tensors other than float64 on the CPU.
    """
    return _applied(_Energy, Operator(contact))


def forces(contact: Contact) -> Callable[..., Any]:
    """The nodal forces, friction included, as a function ``of(coords, reference=None, stiffness=None)``.

    Parameters
    ----------
    contact : Contact
        The contact; its obstacles, options and friction stay as they are.

    Returns
    -------
    callable
        A function of tensors of float64, (n, dim), (n, dim) and (); ``None`` leaves what the contact has. It returns (n, dim).

    Raises
    ------
    TypeError
        The function raises it for tensors other than float64 on the CPU.
    """
    return _applied(_Forces, Operator(contact))


def _arrays(*tensors: Any) -> list[Any]:
    return [None if tensor is None else tensor.detach().numpy() for tensor in tensors]


_NAMES = ("coords", "reference", "stiffness")


def _asked(context: Any) -> tuple[str, ...]:
    return tuple(name for name, needed in zip(_NAMES, context.needs_input_grad[1:]) if needed)


class _Forces(torch.autograd.Function):
    @staticmethod
    def forward(context: Any, operator: Operator, *values: Any) -> Any:
        context.operator = operator
        context.save_for_backward(*values)
        return torch.from_numpy(operator.forces(*_arrays(*values)))

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(context: Any, adjoint: Any) -> Any:
        by = _asked(context)
        coords, reference, stiffness, factors = _arrays(*context.saved_tensors, adjoint.contiguous())
        found = context.operator.gradients(coords, reference, stiffness, factors, by=by)
        tensors = dict(zip(by, map(torch.from_numpy, found)))
        return (None, *(tensors.get(name) for name in _NAMES))


class _Others(torch.autograd.Function):
    """The derivatives of the energy by all but the coordinates, which are not differentiated again."""

    @staticmethod
    def forward(context: Any, operator: Operator, by: tuple[str, ...], *values: Any) -> Any:
        coords, reference, stiffness = _arrays(*values)
        found = operator.gradients(coords, reference, stiffness, energy=1.0, by=by)
        return tuple(map(torch.from_numpy, found))

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(context: Any, *_: Any) -> Any:
        raise NotImplementedError("second derivatives by undeformed coordinates and stiffness")


class _Energy(torch.autograd.Function):
    @staticmethod
    def forward(context: Any, operator: Operator, *values: Any) -> Any:
        context.operator = operator
        context.save_for_backward(*values)
        return torch.from_numpy(operator.energy(*_arrays(*values)))

    @staticmethod
    def backward(context: Any, factor: Any) -> Any:
        by, values = _asked(context), context.saved_tensors
        found: dict[str, Any] = {}
        if "coords" in by:
            # By the forces, which can be differentiated again.
            found["coords"] = -factor * _Forces.apply(context.operator, *values)
        others = tuple(name for name in by if name != "coords")
        if others:
            of_others = _Others.apply(context.operator, others, *values)
            found.update((name, factor * value) for name, value in zip(others, of_others))
        return (None, *(found.get(name) for name in _NAMES))


def _applied(function: Any, operator: Operator) -> Callable[..., Any]:
    def of(coords: Any, reference: Any = None, stiffness: Any = None) -> Any:
        for name, value in zip(_NAMES, (coords, reference, stiffness)):
            if value is not None and (value.dtype != torch.float64 or value.device.type != "cpu"):
                raise TypeError(f"{name} has dtype {value.dtype} on {value.device}, expected torch.float64 on the CPU")
        return function.apply(operator, coords, reference, stiffness)

    return of
