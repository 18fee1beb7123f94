"""The neo-Hookean solid of the reference host at points of integration; tensors are (dim, dim, cells, points).

    W  = G/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2
    P  = a F + b C            C = cof F,  a = G J^(-2/3),  b = K (J - 1) - a I1/3J
    dP = a dF + b dC + da F + db C        dJ = C:dF,  da = -2/3 a/J dJ,
                                          db = (K + 5/9 a I1/J^2) dJ - 2/3 a/J F:dF
"""

from __future__ import annotations

import numpy as np
from skfem.helpers import ddot, eye


class NeoHookean:
    """A deformation with the gradient ``gradient`` of its displacement; ``shear`` and ``bulk`` moduli, (cells, 1). The
    energy is infinite where J <= 0."""

    def __init__(self, gradient: np.ndarray, shear: np.ndarray, bulk: np.ndarray) -> None:
        dim = len(gradient)
        self.bulk, self.f = bulk, gradient + eye(np.ones(gradient.shape[2:]), dim)
        self.cofactor = _cofactor(self.f)
        self.j = (self.f[0] * self.cofactor[0]).sum(axis=0)
        self.i1 = ddot(self.f, self.f) + (3 - dim)
        # What is turned inside out has no stress to speak of, but must not be a complex number.
        self.a = shear * np.abs(self.j) ** (-2.0 / 3.0)
        self.b = bulk * (self.j - 1.0) - self.a * self.i1 / (3.0 * self.j)
        self.stress = self.a * self.f + self.b * self.cofactor
        energy = 0.5 * (self.a * self.i1 - 3.0 * shear) + 0.5 * bulk * (self.j - 1.0) ** 2
        self.energy = np.where(self.j > 0.0, energy, np.inf)

    def derivative(self, df: np.ndarray) -> np.ndarray:
        """dP for a change of F."""
        a, j = self.a, self.j
        change = _cofactor(df)
        if len(df) == 3:  # quadratic in F there, linear in 2D
            change = _cofactor(self.f + df) - self.cofactor - change
        dj = ddot(self.cofactor, df)
        da = -2.0 / 3.0 * a / j * dj
        db = (self.bulk + 5.0 / 9.0 * a * self.i1 / j**2) * dj - 2.0 / 3.0 * a / j * ddot(self.f, df)
        return a * df + self.b * change + da * self.f + db * self.cofactor


def _cofactor(f: np.ndarray) -> np.ndarray:
    """Derivative of the determinant."""
    c = np.empty_like(f)
    if len(f) == 2:
        c[0, 0], c[0, 1], c[1, 0], c[1, 1] = f[1, 1], -f[1, 0], -f[0, 1], f[0, 0]
        return c
    for i in range(3):
        for k in range(3):
            (p, q), (r, s) = ((i + 1) % 3, (i + 2) % 3), ((k + 1) % 3, (k + 2) % 3)
            c[i, k] = f[p, r] * f[q, s] - f[p, s] * f[q, r]
    return c
