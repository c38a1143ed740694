"""loose-epsilon

A line within a millionth of the extent of a tangent is called one, which is wider than the promise: near hits
lose a point and near misses gain one. Take a slack well below the promise's wider band: 1e-10 of the extent.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    e = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    n = hypot(bx - ax, by - ay)
    if n == 0:
        return [A] if abs(hypot(ax, ay) - r) <= 1e-10 * e else []
    ux, uy = (bx - ax) / n, (by - ay) / n
    d = abs(ux * ay - uy * ax)
    foot = -(ux * ax + uy * ay)
    if abs(d - r) <= 1e-6 * e:
        steps = [foot]
    elif d > r:
        return []
    else:
        half = sqrt((r - d) * (r + d))
        steps = [foot - half, foot + half]
    return [(A[0] + s * ux, A[1] + s * uy) for s in steps if -1e-10 * e <= s <= n + 1e-10 * e]
