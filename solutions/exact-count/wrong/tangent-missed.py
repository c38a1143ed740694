"""tangent-missed

A tangent is counted as a miss, because the line has to come strictly closer than the radius. It has
one point in common with the circle.
"""


def exact_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    cross = dx * (cy - A[1]) - dy * (cx - A[0])
    return 2 if cross * cross < r * r * (dx * dx + dy * dy) else 0
