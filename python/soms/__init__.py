"""Exact collision queries on triangle meshes.

    import soms

    city = soms.Body(soms.read_mesh("city.ply"))
    car = soms.Shape(soms.read_mesh("car.ply"))
    answer = soms.overlap(car, city, poses)          # poses: (n, 4, 4)
    print(answer.any, answer.of(0))                  # who touches, and with which triangles

Queries: overlap, distance, within, solid of two bodies; contains, closest, nearest_triangles,
near_triangles, winding of points; closest_hit, any_hit, all_hits, sees of rays; first_contact, free of
motions (RigidMotion); clash of the parts of models; robot_contacts of states of a robot. Bodies are Body, Shape, Mesh, or any object with vertices
and faces. Scene is for many movers. One pose, point or ray
gives a single answer, rows of them a batch; both carry coverage and cost. All take threads, timeout
and progress, and end by Ctrl-C; the interpreter's lock is free meanwhile. Errors are soms.Error.
"""

from soms._enums import *
from soms._error import Error as Error
from soms._page import Page as Page
from soms._soms import *
from soms._soms import __version__ as __version__

__all__ = sorted(name for name in dir() if not name.startswith("_"))

# Where users find them, and so pickles and help(soms) do.
for _name in __all__:
    globals()[_name].__module__ = "soms"
del _name
