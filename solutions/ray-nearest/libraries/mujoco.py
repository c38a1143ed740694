"""mujoco 4.0.0: mju_rayGeom with a sphere, in the plane z = 0

It gives the nearest t that is not negative, or -1. From inside that is where the ray leaves.
"""

import os
from math import hypot

os.environ["MUJOCO_GL"] = "disable"  # no window is opened
import mujoco
import numpy as np


def ray_nearest(cx, cy, r, O, D):
    if D == (0, 0):
        return None
    if r == 0:
        return at_a_point(cx, cy, O, D)
    place, size = np.array([cx, cy, 0.0]), np.array([r, 0.0, 0.0])
    start, along = np.array([*O, 0.0]), np.array([*D, 0.0])
    kind = mujoco.mjtGeom.mjGEOM_SPHERE
    t = mujoco.mju_rayGeom(place, np.eye(3).ravel(), size, start, along, kind)
    return t if t >= 0 else None


def at_a_point(cx, cy, O, D):
    """t where the circle is the point C; None where the ray misses it."""
    t = ((cx - O[0]) * D[0] + (cy - O[1]) * D[1]) / (D[0] * D[0] + D[1] * D[1])
    off = hypot(O[0] + t * D[0] - cx, O[1] + t * D[1] - cy)
    return t if t >= 0 and off <= 1e-9 * hypot(cx - O[0], cy - O[1]) else None
