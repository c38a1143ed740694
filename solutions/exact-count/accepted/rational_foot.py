"""rational-foot-of-the-perpendicular

The foot of the perpendicular has rational coordinates, and so has its squared distance from the
centre, which is compared with the squared radius.
"""

from fractions import Fraction


def exact_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    t = Fraction((cx - A[0]) * dx + (cy - A[1]) * dy, dx * dx + dy * dy)
    foot_x, foot_y = A[0] + t * dx, A[1] + t * dy
    distance_squared = (foot_x - cx) ** 2 + (foot_y - cy) ** 2
    if distance_squared == r * r:
        return 1
    return 2 if distance_squared < r * r else 0
