"""floor-division

The foot of the perpendicular is found with //, so it is only a grid point near the true one. Keep
the denominator, as a Fraction or by multiplying through.
"""


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx * dx + dy * dy
    if a == 0:
        return None
    along = (cx - A[0]) * dx + (cy - A[1]) * dy
    foot_x = A[0] + along * dx // a
    foot_y = A[1] + along * dy // a
    d2 = (foot_x - cx) ** 2 + (foot_y - cy) ** 2
    if d2 == r * r:
        return 1
    return 2 if d2 < r * r else 0
