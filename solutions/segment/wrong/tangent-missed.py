"""tangent-missed

Only a positive discriminant counts, so a tangent line is a miss.
Treat the tangency as a case of its own, with one point.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    px, py = A[0] - cx, A[1] - cy
    eps = 1e-10 * max(r, abs(px), abs(py), abs(B[0] - cx), abs(B[1] - cy))
    vx, vy = B[0] - A[0], B[1] - A[1]
    size = hypot(vx, vy)
    if size == 0:
        return [A] if abs(hypot(px, py) - r) <= eps else []
    vx /= size
    vy /= size
    d = abs(vx * py - vy * px)
    answer = []
    if d < r - eps:
        along = -(px * vx + py * vy)
        for s in (-sqrt(r * r - d * d), sqrt(r * r - d * d)):
            if -eps <= along + s <= size + eps:
                answer.append((A[0] + (along + s) * vx, A[1] + (along + s) * vy))
    return answer
