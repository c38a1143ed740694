"""absolute-epsilon

The tangency is measured by the figure, but the ends have a slack of 1e-9, whatever the size of the figure.
Give the ends the same slack as the tangency: 1e-10 of the extent.
"""

from math import dist, hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    bx, by = B[0] - cx, B[1] - cy
    extent = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    length = dist((ax, ay), (bx, by))
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= 1e-10 * extent else []
    ux, uy = (bx - ax) / length, (by - ay) / length
    height = abs(ux * ay - uy * ax)
    if height > r + 1e-10 * extent:
        return []
    half = sqrt((r - height) * (r + height)) if height < r - 1e-10 * extent else 0.0
    points = []
    for s in sorted({-half, half}):
        s -= ux * ax + uy * ay
        if s > -1e-9 and s < length + 1e-9:
            points.append((A[0] + s * ux, A[1] + s * uy))
    return points
