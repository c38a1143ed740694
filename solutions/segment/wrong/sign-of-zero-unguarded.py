"""sign-of-zero

The stable formula takes its sign from b, and the sign of 0 is 0 there. Then both roots are lost, or divided
by 0. Take the sign of 0 as +1 (or use copysign).
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    length = hypot(bx - ax, by - ay)
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []
    ux, uy = (bx - ax) / length, (by - ay) / length
    d = abs(ux * ay - uy * ax)
    foot = -(ux * ax + uy * ay)
    if d > r + near:
        return []
    if d < r - near:
        sign = (foot > 0) - (foot < 0)
        far = foot + sign * sqrt((r - d) * (r + d))
        places = sorted([far, (ax * ax + ay * ay - r * r) / far])
    else:
        places = [foot]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
