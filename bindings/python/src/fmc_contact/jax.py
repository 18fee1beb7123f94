"""Contact energy and forces as functions that JAX differentiates in reverse mode: ``jit``, ``grad``, ``vjp``, ``vmap``.

``energy`` is twice differentiable by coordinates. There is no forward mode (``jvp``, ``jax.hessian``); use ``jax.jacrev`` of ``jax.grad``. An
operator sets the undeformed coordinates and the stiffness of its contact in each call, so do not share the contact.

``equilibrium`` is the equilibrium of bodies that JAX has the residual of, by their parameters; not within ``jit`` and ``vmap``.
"""

from __future__ import annotations

from typing import Any, Callable

import jax
import jax.numpy as jnp
import numpy as np
from numpy.typing import ArrayLike

from ._equilibria import Equilibria
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
        A function of jax arrays of float64, (n, dim), (n, dim) and (); ``None`` keeps the value of the contact. It returns a ().

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
        A function of jax arrays of float64, (n, dim), (n, dim) and (); ``None`` keeps the value of the contact. It returns (n, dim).

    Raises
    ------
    TypeError
        The function raises it for numbers other than float64.
    """
    return _pair_of(contact)[1]


def equilibrium(contact: Contact, residual: Callable[[Any, Any], Any], free: ArrayLike, **options: Any) -> Callable[..., Any]:
    """The equilibrium as a function ``of(parameters, x, prescribed=None, reference=None, positions=None)``, which returns the end x.

    Differentiable in reverse mode, once, by ``parameters``, ``prescribed`` (without it by ``x`` where unknowns are held), ``reference``
    (undeformed coordinates) and ``positions`` (of the obstacles): by one linear system, ``Equilibrium.adjoint``. Each call begins
    with the multipliers that the contact has now. The function does not run within ``jit`` and ``vmap``.

    Parameters
    ----------
    contact : Contact
        The contact. With friction its step has begun; the slip at its start is held.
    residual : callable
        Takes x, (n, dim), and the parameters, and returns internal minus external forces without contact, (n, dim). JAX
        differentiates it, by x to a dense matrix.
    free : array_like
        As for ``find_equilibrium``.
    **options
        Options of ``find_equilibrium``.

    Returns
    -------
    callable
        A function of any parameters that JAX takes as an argument, and of arrays of float64.

    Raises
    ------
    TypeError
        The function raises it within ``jit`` or ``vmap``, and for numbers other than float64.
    NotConvergedError
        The function raises it as ``find_equilibrium``.
    """
    operator, value, matrix = Equilibria(contact, free, options), jax.jit(residual), jax.jit(jax.jacfwd(residual))

    @jax.jit
    def of_bodies(x: Any, parameters: Any, factors: Any) -> Any:
        return jax.vjp(lambda given: residual(x, given), parameters)[1](factors)[0]

    def asked(parameters: Any, *arrays: Any) -> tuple[Any, ...]:
        """Bodies, a key, and arrays of numpy."""
        leaves, tree = jax.tree_util.tree_flatten((parameters, arrays))
        if any(isinstance(leaf, jax.core.Tracer) for leaf in leaves):
            raise TypeError("an equilibrium has to be found outside of jit and vmap")

        def bodies(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            return np.asarray(value(x, parameters)).ravel(), np.asarray(matrix(x, parameters)).reshape(x.size, x.size)

        key = tree, *(np.asarray(leaf).tobytes() for leaf in leaves)
        return bodies, key, *(None if one is None else np.asarray(one) for one in arrays)

    @jax.custom_vjp
    def of_all(parameters: Any, *arrays: Any) -> Any:
        bodies, key, *values = asked(parameters, *arrays)
        return jnp.asarray(operator.solved(bodies, key, *values).x)

    def forward(parameters: Any, *arrays: Any) -> tuple[Any, Any]:
        end = of_all(parameters, *arrays)
        return end, (parameters, arrays)

    def back(saved: Any, by_x: Any) -> tuple[Any, ...]:
        parameters, arrays = saved
        bodies, key, *values = asked(parameters, *arrays)
        found = operator.adjoint(bodies, key, np.asarray(by_x), *values)
        is_held = values[1] is None
        return (
            of_bodies(found.x, parameters, -found.balance),
            found.prescribed if is_held else np.zeros(found.prescribed.shape),
            None if is_held else found.prescribed,
            found.gradients.reference,
            found.gradients.positions,
        )

    of_all.defvjp(forward, back)

    def of(parameters: Any, x: Any, prescribed: Any = None, reference: Any = None, positions: Any = None) -> Any:
        return of_all(parameters, *_arrays(x=x, prescribed=prescribed, reference=reference, positions=positions))

    return of


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
        return function(*_arrays(coords=coords, reference=reference, stiffness=stiffness))

    return of


def _arrays(**named: Any) -> list[Any]:
    """Arrays of jax. Errors: ``TypeError`` for numbers other than float64."""
    values = [None if value is None else jnp.asarray(value) for value in named.values()]
    for name, value in zip(named, values):
        if value is not None and value.dtype != np.float64:
            hint = "jax.config.update('jax_enable_x64', True)"
            raise TypeError(f"{name} has dtype {value.dtype}, expected float64: {hint}")
    return values
