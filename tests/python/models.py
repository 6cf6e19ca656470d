"""Small models for the tests of the Python package."""
import numpy as np

import soms

TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def tetrahedron():
    return soms.Mesh(TETRAHEDRON, FACES)


def shifts(*rows):
    return np.array(rows, dtype=float)


class Foreign:
    """A mesh of another library: vertices and faces."""

    def __init__(self, vertices=TETRAHEDRON, faces=FACES):
        self.vertices, self.faces = vertices, faces
