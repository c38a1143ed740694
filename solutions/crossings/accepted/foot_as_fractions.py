"""foot-as-fractions

The foot of the perpendicular from C is the point of the line that is nearest to C. As exact fractions its distance
squared is compared with r².
"""

from fractions import Fraction


def crossings(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    t = Fraction((cx - A[0]) * dx + (cy - A[1]) * dy, dx * dx + dy * dy)
    x, y = A[0] + t * dx, A[1] + t * dy
    square = (x - cx) ** 2 + (y - cy) ** 2
    return 2 if square < r * r else 1 if square == r * r else 0
