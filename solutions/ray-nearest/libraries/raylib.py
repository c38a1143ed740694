"""raylib 6.2.0.0: get_ray_collision_sphere, in the plane z = 0

Single precision. The direction must be of length 1. From inside it gives where the ray leaves.
"""

from math import hypot

from pyray import Ray, Vector3, get_ray_collision_sphere


def ray_nearest(cx, cy, r, O, D):
    if D == (0, 0):
        return None
    if r == 0:
        return at_a_point(cx, cy, O, D)
    length = hypot(*D)
    beam = Ray(Vector3(*O, 0), Vector3(D[0] / length, D[1] / length, 0))
    found = get_ray_collision_sphere(beam, Vector3(cx, cy, 0), r)
    return found.distance / length if found.hit else None


def at_a_point(cx, cy, O, D):
    """t where the circle is the point C; None where the ray misses it."""
    t = ((cx - O[0]) * D[0] + (cy - O[1]) * D[1]) / (D[0] * D[0] + D[1] * D[1])
    off = hypot(O[0] + t * D[0] - cx, O[1] + t * D[1] - cy)
    return t if t >= 0 and off <= 1e-9 * hypot(cx - O[0], cy - O[1]) else None
