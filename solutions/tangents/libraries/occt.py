"""cadquery-ocp 8.0.1.1.0: GccAna_Lin2d2Tan of a circle and a point

A point counts as on the circle within the tolerance, here 1e-7. From inside there is no solution.
"""

from OCP.GccAna import GccAna_Lin2d2Tan
from OCP.GccEnt import GccEnt_Position, GccEnt_QualifiedCirc
from OCP.gp import gp_Ax2d, gp_Circ2d, gp_Dir2d, gp_Pnt2d


def tangent_points(cx, cy, r, P):
    if r == 0:
        return [(cx, cy)]
    circle = gp_Circ2d(gp_Ax2d(gp_Pnt2d(cx, cy), gp_Dir2d(1, 0)), r)
    qualified = GccEnt_QualifiedCirc(circle, GccEnt_Position.GccEnt_unqualified)
    lines = GccAna_Lin2d2Tan(qualified, gp_Pnt2d(*P), 1e-7)
    found = []
    for number in range(1, lines.NbSolutions() + 1 if lines.IsDone() else 1):
        point = gp_Pnt2d()
        lines.Tangency1(number, point)
        found.append((point.X(), point.Y()))
    return left_first(cx, cy, P, found)


def left_first(cx, cy, P, points):
    """The points without doubles, the one on the left of P→C first."""
    side = lambda p: (cx - P[0]) * (p[1] - P[1]) - (cy - P[1]) * (p[0] - P[0])
    return sorted(set(points), key=side, reverse=True)
