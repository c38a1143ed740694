"""mujoco 4.0.0: mju_rayGeom with a sphere; the normal is worked out here

It gives the nearest t that is not negative, or -1. From inside that is where the ray leaves.
"""

import os

os.environ["MUJOCO_GL"] = "disable"  # no window is opened
import mujoco
import numpy as np


def ray_sphere(C, r, O, D):
    if D == (0, 0, 0) or r == 0:
        return None
    place, size, start, along = (np.array(each, float) for each in (C, (r, 0, 0), O, D))
    t = mujoco.mju_rayGeom(place, np.eye(3).ravel(), size, start, along, mujoco.mjtGeom.mjGEOM_SPHERE)
    if t < 0:
        return None
    normal = (start + t * along - place) / r
    return t, tuple(normal if np.dot(normal, along) <= 0 else -normal)
