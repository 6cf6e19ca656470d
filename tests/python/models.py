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


def box(lower, upper):
    """The surface of a box: 12 triangles."""
    ends = np.array([lower, upper], dtype=float)
    corners = [[ends[k >> axis & 1][axis] for axis in range(3)] for k in range(8)]
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return soms.Mesh(corners, [face[:1] + face[k:k + 2] for face in faces for k in (1, 2)])
