"""cadquery-ocp 8.0.1.1.0: IntAna2d_AnaIntersection of a gp_Lin2d and a gp_Circ2d

No tolerance can be given. A touch should be one point; of some slanted lines it is none.
"""

from math import hypot

from OCP.gp import gp_Ax2d, gp_Circ2d, gp_Dir2d, gp_Lin2d, gp_Pnt2d
from OCP.IntAna2d import IntAna2d_AnaIntersection


def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    if r == 0:
        return int(on_line(cx, cy, A, B))
    line = gp_Lin2d(gp_Pnt2d(*A), gp_Dir2d(B[0] - A[0], B[1] - A[1]))
    circle = gp_Circ2d(gp_Ax2d(gp_Pnt2d(cx, cy), gp_Dir2d(1, 0)), r)
    return IntAna2d_AnaIntersection(line, circle).NbPoints()


def on_line(cx, cy, A, B):
    """Whether the point C, the circle of radius 0, is on the line."""
    ux, uy, wx, wy = B[0] - A[0], B[1] - A[1], cx - A[0], cy - A[1]
    size = max(map(abs, (wx, wy, cx - B[0], cy - B[1])))
    return abs(ux * wy - uy * wx) <= 1e-9 * size * hypot(ux, uy)
