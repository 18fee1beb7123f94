"""Contact added to dolfinx' own nonlinear problems."""

from __future__ import annotations

from typing import Any

from .adapter import DolfinxContact


def with_contact(kind: type) -> type:
    """A ``NonlinearProblem`` with contact, from a class with methods ``F`` and ``J``, as dolfinx has until 0.9.

    If the class has none because it holds a SNES, use ``attach(problem.solver, contact, bcs)``.

    Parameters
    ----------
    kind : type
        The class.

    Returns
    -------
    type
        A subclass that takes ``contact`` as a keyword. Its ``tangent`` is the contact's in the last matrix.

    Raises
    ------
    TypeError
        If the class has no such methods.

    Examples
    --------
    >>> Problem = with_contact(dolfinx.fem.petsc.NonlinearProblem)
    >>> problem = Problem(R, u, bcs, contact=contact)
    >>> NewtonSolver(comm, problem).solve(u)
    """
    if not (hasattr(kind, "F") and hasattr(kind, "J")):
        raise TypeError(f"{kind.__name__} has no methods F and J: use attach(problem.solver, contact, bcs)")

    class Problem(kind):  # type: ignore[misc, valid-type]
        def __init__(self, *arguments: Any, contact: DolfinxContact, **options: Any) -> None:
            super().__init__(*arguments, **options)
            self.contact = contact
            self.tangent: Any = None

        def F(self, x: Any, b: Any) -> None:
            super().F(x, b)
            self.contact.add_forces(b, self.contact.evaluate(x), -1.0, self.bcs)

        def J(self, x: Any, A: Any) -> None:
            super().J(x, A)
            self.tangent = self.contact.tangent(x)
            self.contact.add_tangent(A, self.tangent, self.bcs)

    return Problem


def attach(snes: Any, contact: DolfinxContact, bcs: Any = ()) -> None:
    """Adds contact to the functions of a SNES that has them already, such as ``NonlinearProblem.solver`` of dolfinx 0.10 and later.

    Parameters
    ----------
    snes : PETSc.SNES
        Its residual is one of internal minus external forces.
    contact : DolfinxContact
        The contact.
    bcs : sequence of DirichletBC
        Unknowns that they hold are left alone.

    Examples
    --------
    >>> attach(problem.solver, contact, bcs)
    """
    vector, (function, arguments, options) = snes.getFunction()
    matrix, preconditioner, (derivative, more, further) = snes.getJacobian()

    def residual(snes: Any, x: Any, b: Any) -> None:
        function(snes, x, b, *(arguments or ()), **(options or {}))
        contact.add_forces(b, contact.evaluate(x), -1.0, bcs)

    def jacobian(snes: Any, x: Any, a: Any, p: Any) -> Any:
        outcome = derivative(snes, x, a, p, *(more or ()), **(further or {}))
        contact.add_tangent(p, contact.tangent(x), bcs)
        return outcome

    snes.setFunction(residual, vector)
    snes.setJacobian(jacobian, matrix, preconditioner)
