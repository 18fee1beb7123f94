"""Contact energy and forces as functions that JAX differentiates in reverse mode: ``jit``, ``grad``, ``vjp``, ``vmap``.

``energy`` is twice differentiable by coordinates. Forward mode (``jvp``, ``jax.hessian``) is not there; ``jax.jacrev`` of
``jax.grad`` is. An operator tells its contact the undeformed coordinates and the stiffness that it is called with, so
that the contact is the operator's alone.
"""

from __future__ import annotations

from typing import Any, Callable

import jax
import jax.numpy as jnp
import numpy as np

from ._operators import Operator, given
from .contact import Contact

# Without types in some versions.
_Shape: Any = jax.ShapeDtypeStruct


def energy(contact: Contact) -> Callable[..., Any]:
    """The contact energy as a function ``of(coords, reference=None, stiffness=None)``.

    Parameters
    ----------
    contact : Contact
        The contact; its obstacles, options and friction stay as they are.

    Returns
    -------
    callable
        A function of jax arrays of float64, (n, dim), (n, dim) and (); ``None`` leaves what the contact has. It returns a ().

    Raises
    ------
    TypeError
        The function raises it for numbers other than float64.
    """
    return _pair_of(contact)[0]


def forces(contact: Contact) -> Callable[..., Any]:
    """The nodal forces, friction included, as a function ``of(coords, reference=None, stiffness=None)``.

    Parameters
    ----------
    contact : Contact
        The contact; its obstacles, options and friction stay as they are.

    Returns
    -------
    callable
        A function of jax arrays of float64, (n, dim), (n, dim) and (); ``None`` leaves what the contact has. It returns (n, dim).

    Raises
    ------
    TypeError
        The function raises it for numbers other than float64.
    """
    return _pair_of(contact)[1]


def _call(function: Callable[..., Any], result: Any, *arguments: Any) -> Any:
    def on_host(*values: Any) -> Any:
        return function(*(None if value is None else np.asarray(value) for value in values))

    return jax.pure_callback(on_host, result, *arguments, vmap_method="sequential")


def _like(values: Any) -> Any:
    return _Shape(jnp.shape(values), np.float64)


def _pair_of(contact: Contact) -> tuple[Callable[..., Any], Callable[..., Any]]:
    operator = Operator(contact)

    def derivatives(saved: tuple[Any, ...], adjoint: Any, factor: Any, by: tuple[str, ...]) -> dict[str, Any]:
        if not by:
            return {}
        values = dict(zip(("coords", "reference", "stiffness"), saved))

        def on_host(coords: Any, reference: Any, stiffness: Any, adjoint: Any, factor: Any) -> Any:
            return operator.gradients(coords, reference, stiffness, adjoint, 0.0 if factor is None else float(factor), by)

        found = _call(on_host, tuple(_like(values[name]) for name in by), *saved, adjoint, factor)
        return dict(zip(by, found))

    @jax.custom_vjp
    def of_forces(coords: Any, reference: Any, stiffness: Any) -> Any:
        return _call(operator.forces, _like(coords), coords, reference, stiffness)

    def forces_back(saved: tuple[Any, ...], adjoint: Any) -> tuple[Any, ...]:
        found = derivatives(saved, adjoint, None, ("coords", *given(*saved[1:])))
        return found["coords"], found.get("reference"), found.get("stiffness")

    @jax.custom_vjp
    def of_energy(coords: Any, reference: Any, stiffness: Any) -> Any:
        return _call(operator.energy, _Shape((), np.float64), coords, reference, stiffness)

    def energy_back(saved: tuple[Any, ...], factor: Any) -> tuple[Any, ...]:
        # By the forces, which can be differentiated again.
        by_coords = -factor * of_forces(*saved)
        found = derivatives(saved, None, factor, given(*saved[1:]))
        return by_coords, found.get("reference"), found.get("stiffness")

    of_forces.defvjp(lambda *values: (of_forces(*values), values), forces_back)
    of_energy.defvjp(lambda *values: (of_energy(*values), values), energy_back)
    return _checked(of_energy), _checked(of_forces)


def _checked(function: Callable[..., Any]) -> Callable[..., Any]:
    def of(coords: Any, reference: Any = None, stiffness: Any = None) -> Any:
        named = {"coords": coords, "reference": reference, "stiffness": stiffness}
        values = [None if value is None else jnp.asarray(value) for value in named.values()]
        for name, value in zip(named, values):
            if value is not None and value.dtype != np.float64:
                hint = "jax.config.update('jax_enable_x64', True)"
                raise TypeError(f"{name} has dtype {value.dtype}, expected float64: {hint}")
        return function(*values)

    return of
