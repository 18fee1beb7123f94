"""Five small decks that `ccx`, patched or not, and `fmc solve` read: `python decks.py FOLDER` writes them."""

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

Map = Callable[[np.ndarray], np.ndarray]
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
TET_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
# Corners of the faces S1, S2, … of hexahedra and tetrahedra.
HEX_FACES = [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]
TET_FACES = [(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)]
# Tetrahedra of a cube about the diagonal from its first corner to the seventh: cubes side by side fit.
TETRAHEDRA = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]


class Deck:
    """Nodes, elements and sets of bodies that are boxes, or boxes bent by a map."""

    def __init__(self, title: str) -> None:
        self.lines = ["*HEADING", title]
        self.points = np.zeros((0, 3))
        self.element_count = 0
        self.faces: dict[str, list[str]] = {}

    def box(self, name: str, kind: str, counts: tuple[int, int, int], place: Map, is_fresh: bool = True) -> None:
        """A body of `counts` cubes of the unit cube, moved by `place`. `is_fresh` False: nodes at one place are one."""
        refine = 2 if kind in ("C3D10", "C3D20") else 1
        first = np.array(counts)
        cells = np.array([[i, j, k] for k in range(first[2]) for j in range(first[1]) for i in range(first[0])])
        at = refine * (cells[:, None, :] + CORNERS)
        if kind in ("C3D4", "C3D10"):
            at = at[:, TETRAHEDRA].reshape(-1, 4, 3)
        if refine == 2:
            middles = [(at[:, a] + at[:, b]) // 2 for a, b in (EDGES if kind == "C3D20" else TET_EDGES)]
            at = np.concatenate([at, np.stack(middles, axis=1)], axis=1)
        places, which = np.unique(at.reshape(-1, 3), axis=0, return_inverse=True)
        points = place(places / (refine * first))
        numbers = np.arange(len(points)) + len(self.points)
        fresh = np.ones(len(points), bool)
        # Numbers of nodes that are not written stay free: bodies behind have the same with and without.
        if not is_fresh:
            for i, x in enumerate(points):
                near = np.flatnonzero(np.linalg.norm(self.points - x, axis=1) < 1e-9)
                if len(near):
                    numbers[i], fresh[i] = near[0], False
        self.lines.append("*NODE")
        self.lines += [f"{n + 1}, {x[0]:.15g}, {x[1]:.15g}, {x[2]:.15g}" for n, x in zip(numbers[fresh], points[fresh], strict=True)]
        self.points = np.concatenate([self.points, points])
        self.lines.append(f"*ELEMENT, TYPE={kind}, ELSET={name}")
        for cell in numbers[which.reshape(at.shape[:2])] + 1:
            self.element_count += 1
            self.lines += rows([self.element_count, *cell])
        # Nodes and faces of the box by its six sides.
        sides = TET_FACES if kind in ("C3D4", "C3D10") else HEX_FACES
        for axis, letter in enumerate("XYZ"):
            for end in (0, 1):
                is_on = at[:, :, axis] == end * refine * first[axis]
                begin = self.element_count - len(at) + 1
                self.faces[f"{name}_{letter}{end}"] = [
                    f"{begin + e}, S{f + 1}" for e in range(len(at)) for f, face in enumerate(sides) if is_on[e, list(face)].all()
                ]
                on_side = numbers[places[:, axis] == end * refine * first[axis]] + 1
                self.lines += [f"*NSET, NSET={name}_{letter}{end}", *(f"{n}," for n in on_side)]

    def end(self, pair: tuple[str, str], slope: float, boundary: str, load: str = "", extra: str = "") -> str:
        """The rest of a deck with the pair of a node set and the faces of a side; all bodies are of one material."""
        names = [line.split("ELSET=")[1] for line in self.lines if line.startswith("*ELEMENT")]
        self.lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", "210000., 0.3"]
        self.lines += [f"*SOLID SECTION, ELSET={name}, MATERIAL=STEEL" for name in names]
        self.lines += extra.split("\n") if extra else []
        faces = "\n".join(self.faces[pair[1]])
        return (
            "\n".join(self.lines)
            + f"""
*SURFACE, NAME=SLAVE, TYPE=NODE
{pair[0]},
*SURFACE, NAME=MASTER, TYPE=ELEMENT
{faces}
*SURFACE INTERACTION, NAME=PRESS
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
{slope:g}, 1.
*CONTACT PAIR, INTERACTION=PRESS, TYPE=NODE TO SURFACE
SLAVE, MASTER
*STEP
*STATIC
1., 1.
*BOUNDARY
{boundary}
{load}*NODE PRINT, NSET={boundary.split(",")[0]}, TOTALS=ONLY
RF
*END STEP
"""
        )


def rows(numbers: list[int]) -> list[str]:
    """Numbers in lines of at most sixteen, as ccx reads them."""
    texts = [str(n) for n in numbers]
    parts = [", ".join(texts[i : i + 15]) for i in range(0, len(texts), 15)]
    return [part + "," for part in parts[:-1]] + [parts[-1]]


def box(low: tuple[float, float, float], high: tuple[float, float, float]) -> Map:
    """Moves the unit cube to a box."""
    return lambda x: np.array(low) + x * (np.array(high) - np.array(low))


def arc(inner: float, outer: float) -> Map:
    """Moves the unit cube to a quarter of a ring about z, of length 1."""

    def place(x: np.ndarray) -> np.ndarray:
        radius, angle = inner + x[:, 0] * (outer - inner), 0.5 * np.pi * x[:, 1]
        # Nodes in planes of symmetry are in them to the last bit.
        cosine, sine = np.where(x[:, 1] == 1, 0, np.cos(angle)), np.where(x[:, 1] == 0, 0, np.sin(angle))
        return np.stack([radius * cosine, radius * sine, x[:, 2]], axis=1)

    return place


def dome(radius: float) -> Map:
    """A box of 2 by 2 by 1 above z = 0 whose bottom is a paraboloid."""

    def place(x: np.ndarray) -> np.ndarray:
        flat = box((0, 0, 0), (2, 2, 1))(x)
        flat[:, 2] += (1 - x[:, 2]) * (flat[:, 0] ** 2 + flat[:, 1] ** 2) / (2 * radius)
        return flat

    return place


def hertz() -> str:
    """A quarter of a ball on a block, pressed by 0.02."""
    deck = Deck("Hertz: a quarter of a dome on a block, planes of symmetry x = 0 and y = 0")
    deck.box("BLOCK", "C3D8", (6, 6, 3), box((0, 0, -1), (2.5, 2.5, 0)))
    deck.box("DOME", "C3D8", (7, 7, 3), dome(20.0))
    return deck.end(("DOME_Z0", "BLOCK_Z1"), 2e6, "BLOCK_Z0, 1, 3\nBLOCK_X0, 1\nDOME_X0, 1\nBLOCK_Y0, 2\nDOME_Y0, 2\nDOME_Z1, 3, 3, -0.02")


def fit() -> str:
    """Two rings that overlap by 0.002."""
    deck = Deck("Press fit: a quarter of two rings, overlapping by 0.002")
    deck.box("HUB", "C3D8", (3, 12, 2), arc(2.0, 3.0))
    deck.box("SHAFT", "C3D8", (2, 9, 2), arc(1.0, 2.002))
    return deck.end(("SHAFT_X1", "HUB_X0"), 2e6, "HUB_Z0, 3\nSHAFT_Z0, 3\nHUB_Z1, 3\nSHAFT_Z1, 3\nHUB_Y0, 2\nSHAFT_Y0, 2\nHUB_Y1, 1\nSHAFT_Y1, 1")


def bracket() -> str:
    """A bracket of second order, clamped at an end and pressed down on a block under the other."""
    deck = Deck("Bracket of C3D20, clamped, pressed down beside a block")
    deck.box("BRACKET", "C3D20", (5, 2, 1), box((0, 0, 0.0), (5, 1, 0.5)))
    deck.box("BLOCK", "C3D8", (3, 3, 3), box((2.6, -0.2, -1.0), (4.1, 1.2, 0.0)))
    return deck.end(("BRACKET_Z0", "BLOCK_Z1"), 2e6, "BLOCK_Z0, 1, 3\nBRACKET_X0, 1, 3", "*CLOAD\nBRACKET_X1, 3, -4.\n")


def punch(kind: str = "C3D4") -> str:
    """A punch pressed into a block, both of elements of one type."""
    deck = Deck(f"Punch of {kind} pressed into a block")
    deck.box("BLOCK", kind, (5, 5, 3), box((0, 0, -2), (4, 4, 0)))
    deck.box("PUNCH", kind, (3, 3, 2), box((1.1, 1.2, 0), (2.7, 2.9, 1)))
    return deck.end(("PUNCH_Z0", "BLOCK_Z1"), 2e6, "BLOCK_Z0, 1, 3\nPUNCH_Z1, 1, 2\nPUNCH_Z1, 3, 3, -0.01")


def tie(is_merged: bool = False) -> str:
    """A cap tied on a plate, nodes on nodes, and a block that presses on the cap. `is_merged`: nodes are shared in place of the tie."""
    deck = Deck("Tie and contact")
    deck.box("PLATE", "C3D8", (4, 4, 2), box((0, 0, -2), (2, 2, -1)))
    deck.box("CAP", "C3D8", (4, 4, 2), box((0, 0, -1), (2, 2, 0)), not is_merged)
    deck.box("BLOCK", "C3D8", (3, 3, 2), box((0.4, 0.3, 0), (1.5, 1.6, 1)))
    above, below = ("\n".join(deck.faces[side]) for side in ("CAP_Z0", "PLATE_Z1"))
    tied = (
        f"*SURFACE, NAME=ABOVE, TYPE=ELEMENT\n{above}\n*SURFACE, NAME=BELOW, TYPE=ELEMENT\n{below}\n"
        "*TIE, NAME=T, POSITION TOLERANCE=0.01, ADJUST=NO\nABOVE, BELOW"
    )
    return deck.end(("BLOCK_Z0", "CAP_Z1"), 2e6, "PLATE_Z0, 1, 3\nBLOCK_Z1, 1, 2\nBLOCK_Z1, 3, 3, -0.005", extra="" if is_merged else tied)


DECKS: dict[str, Callable[[], str]] = {"hertz": hertz, "fit": fit, "bracket": bracket, "punch": punch, "tie": tie}

if __name__ == "__main__":
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, deck in DECKS.items():
        (folder / f"{name}.inp").write_text(deck())
