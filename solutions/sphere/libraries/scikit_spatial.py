"""scikit-spatial 10.0.0: Sphere.intersect_line; the normal is worked out here

The line is infinite, so what lies behind O is left out here. A miss raises ValueError; a touch is two points.
"""

import numpy as np
from skspatial.objects import Line, Sphere


def ray_sphere(C, r, O, D):
    if D == (0, 0, 0) or r == 0:
        return None
    start, along, place = (np.array(each, float) for each in (O, D, C))
    try:
        found = Sphere(C, r).intersect_line(Line(O, D))
    except ValueError:
        return None
    times = [float(np.dot(np.array(p) - start, along) / np.dot(along, along)) for p in found]
    t = min((t for t in times if t >= 0), default=None)
    if t is None:
        return None
    normal = (start + t * along - place) / r
    return t, tuple(normal if np.dot(normal, along) <= 0 else -normal)
