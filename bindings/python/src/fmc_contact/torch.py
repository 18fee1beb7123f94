"""Contact energy and forces as functions that PyTorch differentiates.

``energy`` is twice differentiable by coordinates. An operator sets the undeformed coordinates and the stiffness of its contact in each call, so do
not share the contact. Tensors are of float64 on the CPU.

``equilibrium`` is the equilibrium of bodies that PyTorch has the residual of, by their parameters.
"""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
import torch
from numpy.typing import ArrayLike

from ._equilibria import Equilibria
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
        A function of tensors of float64, (n, dim), (n, dim) and (); ``None`` keeps the value of the contact. It returns a ().

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
        A function of tensors of float64, (n, dim), (n, dim) and (); ``None`` keeps the value of the contact. It returns (n, dim).

    Raises
    ------
    TypeError
        The function raises it for tensors other than float64 on the CPU.
    """
    return _applied(_Forces, Operator(contact))


def equilibrium(contact: Contact, residual: Callable[[Any, Any], Any], free: ArrayLike, **options: Any) -> Callable[..., Any]:
    """The equilibrium as a function ``of(parameters, x, prescribed=None, reference=None, positions=None)``, which returns the end x.

    Differentiable once, by ``parameters``, ``prescribed`` (without it by ``x`` where unknowns are held), ``reference``
    (undeformed coordinates) and ``positions`` (of the obstacles): by one linear system, ``Equilibrium.adjoint``. Each call begins
    with the multipliers that the contact has now.

    Parameters
    ----------
    contact : Contact
        The contact. With friction its step has begun; the slip at its start is held.
    residual : callable
        Takes x, (n, dim), and the parameters, and returns internal minus external forces without contact, (n, dim). PyTorch
        differentiates it, by x to a dense matrix.
    free : array_like
        As for ``find_equilibrium``.
    **options
        Options of ``find_equilibrium``.

    Returns
    -------
    callable
        A function of parameters, a tensor or a dict of tensors, and of tensors, all of float64 on the CPU.

    Raises
    ------
    TypeError
        The function raises it for tensors other than float64 on the CPU.
    NotConvergedError
        The function raises it as ``find_equilibrium``.
    """
    operator = Equilibria(contact, free, options)

    def of(parameters: Any, x: Any, prescribed: Any = None, reference: Any = None, positions: Any = None) -> Any:
        names = tuple(parameters) if isinstance(parameters, dict) else None
        leaves = (parameters,) if names is None else tuple(parameters.values())
        arrays = {"x": x, "prescribed": prescribed, "reference": reference, "positions": positions}
        _refuse_others({**arrays, **{f"parameters[{name!r}]": leaf for name, leaf in zip(names or ("",), leaves)}})

        def of_bodies(x: Any, *leaves: Any) -> Any:
            return residual(x, leaves[0] if names is None else dict(zip(names, leaves)))

        return _Equilibrium.apply(operator, of_bodies, names, *arrays.values(), *leaves)

    return of


def _asked_of(of_bodies: Any, names: Any, values: Any) -> tuple[Any, ...]:
    """Bodies, a key, and arrays of numpy."""
    arrays, leaves = _arrays(*values[:4]), tuple(leaf.detach() for leaf in values[4:])

    def bodies(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        at = torch.from_numpy(x)
        matrix = torch.autograd.functional.jacobian(lambda there: of_bodies(there, *leaves), at)
        return of_bodies(at, *leaves).detach().numpy().ravel(), matrix.numpy().reshape(x.size, x.size)

    told = (*arrays, *_arrays(*leaves))
    return bodies, (names, *(None if one is None else (one.shape, one.tobytes()) for one in told)), *arrays


class _Equilibrium(torch.autograd.Function):
    @staticmethod
    def forward(context: Any, operator: Equilibria, of_bodies: Any, names: Any, *values: Any) -> Any:
        context.given = operator, of_bodies, names
        context.save_for_backward(*values)
        return torch.from_numpy(operator.solved(*_asked_of(of_bodies, names, values)).x.copy())

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(context: Any, by_x: Any) -> Any:
        (operator, of_bodies, names), values = context.given, context.saved_tensors
        bodies, key, *arrays = _asked_of(of_bodies, names, values)
        found = operator.adjoint(bodies, key, by_x.contiguous().numpy(), *arrays)
        prescribed, is_held = torch.from_numpy(found.prescribed), values[1] is None
        leaves = tuple(leaf.detach().requires_grad_() for leaf in values[4:])
        with torch.enable_grad():
            forces = of_bodies(torch.from_numpy(found.x), *leaves)
        of_leaves = torch.autograd.grad(forces, leaves, torch.from_numpy(-found.balance), allow_unused=True)
        of_contact = (None if one is None else torch.from_numpy(one) for one in (found.gradients.reference, found.gradients.positions))
        return (None, None, None, prescribed if is_held else None, None if is_held else prescribed, *of_contact, *of_leaves)


def _refuse_others(named: dict[str, Any]) -> None:
    """Errors: ``TypeError`` for tensors other than float64 on the CPU."""
    for name, value in named.items():
        if value is not None and (value.dtype != torch.float64 or value.device.type != "cpu"):
            raise TypeError(f"{name} has dtype {value.dtype} on {value.device}, expected torch.float64 on the CPU")


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
        _refuse_others(dict(zip(_NAMES, (coords, reference, stiffness))))
        return function.apply(operator, coords, reference, stiffness)

    return of
