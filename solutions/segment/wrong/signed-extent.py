"""signed-extent

The coordinates seen from the centre go into the extent with their signs, so that an end far to the left or below
counts for nothing. Take their absolute values.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    px, py = A[0] - cx, A[1] - cy
    qx, qy = B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, px, py, qx, qy)
    length = hypot(B[0] - A[0], B[1] - A[1])
    if length == 0:
        return [A] if abs(hypot(px, py) - r) <= 1e-10 * max(r, abs(px), abs(py)) else []
    ux, uy = (B[0] - A[0]) / length, (B[1] - A[1]) / length
    height = ux * py - uy * px
    foot = -(ux * px + uy * py)
    gap = r - abs(height)
    if gap < -near:
        return []
    half = sqrt(gap * (r + abs(height))) if gap > near else 0.0
    places = [foot - half, foot + half] if half else [foot]
    return [(A[0] + s * ux, A[1] + s * uy) for s in places if -near <= s <= length + near]
