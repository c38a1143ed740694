"""raylib 6.2.0.0: get_ray_collision_sphere

Single precision. The direction must be of length 1. From inside the normal is turned round to face the ray.
"""

from math import hypot

from pyray import Ray, Vector3, get_ray_collision_sphere


def ray_sphere(C, r, O, D):
    if D == (0, 0, 0) or r == 0:
        return None
    length = hypot(*D)
    found = get_ray_collision_sphere(
        Ray(Vector3(*O), Vector3(*(d / length for d in D))), Vector3(*C), r
    )
    if not found.hit:
        return None
    return found.distance / length, (found.normal.x, found.normal.y, found.normal.z)
