"""Boundary faces of a body's cells, and loads on them."""

from __future__ import annotations

import numpy as np

from .problem import Body, Problem

_FACES = {
    "triangle": [[0, 1], [1, 2], [2, 0]],
    "quad": [[0, 1], [1, 2], [2, 3], [3, 0]],
    "tetra": [[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]],
    "hexahedron": [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [0, 3, 2, 1], [4, 5, 6, 7]],
}

_CORNERS = {(2, 2): 2, (2, 3): 2, (3, 3): 3, (3, 6): 3, (3, 4): 4, (3, 8): 4, (3, 9): 4}
"""Corners of a face, by the dimension and its nodes."""


def boundary_faces(body: Body) -> np.ndarray:
    """Faces of one cell only, (faces, corners), seen from outside."""
    faces = np.concatenate([body.conn[:, face] for face in _FACES[body.cell_type]])
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[np.sort(first[count == 1])]


def face_normals(coords: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Outward normal times the area of every face, (faces, dim)."""
    x = coords[faces]
    if coords.shape[1] == 2:
        along = x[:, 1] - x[:, 0]
        return np.column_stack([along[:, 1], -along[:, 0]])
    if x.shape[1] == 3:
        return 0.5 * np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
    return 0.5 * np.cross(x[:, 2] - x[:, 0], x[:, 3] - x[:, 1])


def loads(problem: Problem) -> list[tuple[np.ndarray, np.ndarray]]:
    """Faces by their corners, with the traction on each, (faces, dim): of a pressure or as given. Loaded faces are flat, those of
    second order too, so it is one for a face."""
    found = []
    for one in problem.raw["loads"]:
        if one["body_force"] is not None:
            raise NotImplementedError("a body force")
        faces = np.array(one["faces"], np.int64)
        faces = faces[:, : _CORNERS[problem.dim, faces.shape[1]]]
        if one["pressure"] is not None:
            normals = face_normals(problem.coords, faces)
            traction = -one["pressure"] * normals / np.linalg.norm(normals, axis=1)[:, None]
        else:
            traction = np.tile(one["traction"], (len(faces), 1))
        found.append((faces, traction))
    return found
