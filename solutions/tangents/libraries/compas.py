"""compas 2.15.1: tangent_points_to_circle_xy

From inside it takes the root of a negative number, which is taken for no point; from the centre it divides by 0.
"""

from compas.geometry import tangent_points_to_circle_xy


def tangent_points(cx, cy, r, P):
    if r == 0:
        return [(cx, cy)]
    try:
        found = tangent_points_to_circle_xy((((cx, cy, 0), (0, 0, 1)), r), P)
    except ValueError:
        return []
    return left_first(cx, cy, P, [p[:2] for p in found])


def left_first(cx, cy, P, points):
    """The points without doubles, the one on the left of P→C first."""
    side = lambda p: (cx - P[0]) * (p[1] - P[1]) - (cy - P[1]) * (p[0] - P[0])
    return sorted(set(points), key=side, reverse=True)
