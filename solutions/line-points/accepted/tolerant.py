"""foot and half-chord, with a tolerance

The foot of the perpendicular from the centre is the middle of both points: from there the same way
back and forth along the line.

With u the unit vector of B − A and f = A − C, the cross product of u and f says how far the line is
from C and on which side. It is known wherever A is on the line. The foot is that far along the left
normal from C, so it never passes through A, however far away that is. The other leg of the triangle
with r as its longest side is half of the chord.

Back comes before forth on the way from A to B: that is the order which is wanted. A touch is
decided by lengths, within 1e-9 of the size, and is the foot alone.
"""

from math import hypot, sqrt


def line_points(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    near = 1e-9 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    length = hypot(dx, dy)
    ux, uy = dx / length, dy / length
    side = ux * fy - uy * fx
    foot_x, foot_y = cx - side * uy, cy + side * ux
    gap = r - abs(side)
    if gap < -near:
        return []
    if gap <= near:
        return [(foot_x, foot_y)]
    half = sqrt(gap * (r + abs(side)))
    return [(foot_x - half * ux, foot_y - half * uy), (foot_x + half * ux, foot_y + half * uy)]
