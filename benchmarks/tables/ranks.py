"""What ranks exchange that all have the whole mesh: bytes that a rank receives, for the forces alone, and for forces and tangent together.

    python benchmarks/tables/ranks.py

Two blocks of 64² and 63² Hex8 along their faces, which touch over their whole faces: each face has four facets. Ranks are threads here. Needs
numpy, scipy, and fmc_contact with its tests and pytest; a minute.
"""

import sys
from pathlib import Path

import numpy as np
from fmc_contact import Contact

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bindings/python/tests"))
from elastic import bricks
from test_ranks import on_ranks

CELLS = 64
FACETS = 4 * (CELLS**2 + (CELLS - 1) ** 2)


def exchanged(size, law, call, coords, cells):
    """Calls of the communicator, and bytes that the first rank receives."""

    def work(comm):
        contact = Contact(coords, cells, "hexahedron", stiffness=1.0, law=law, estimator="exact")
        contact.ranks.set_communicator(comm)
        getattr(contact, call)(coords)
        counts = contact.ranks.counts()
        return counts.call_count, counts.received_bytes

    return on_ranks(size, work)[0]


if __name__ == "__main__":
    lower = bricks((CELLS, CELLS, 2), (0, 0, 0), (1, 1, 0.2))
    upper = bricks((CELLS - 1, CELLS - 1, 2), (0.01, 0.02, 0.199), (0.98, 0.97, 0.4))
    blocks = np.concatenate([lower[0], upper[0]]), np.concatenate([lower[1], upper[1] + len(lower[0])])
    for law in ("volume", "fiber", "depth"):
        for call in ("evaluate", "evaluate_tangent"):
            found = [exchanged(size, law, call, *blocks) for size in (2, 4, 7)]
            received = [bytes for _, bytes in found]
            print(f"{law}, {call}: {found[0][0]} calls, received on 2, 4, 7 ranks {received} B, {received[0] / FACETS:.3g} B per facet", flush=True)
