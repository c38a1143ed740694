"""loose-epsilon

The epsilon grows with the figure, but 1e-5 of it is so wide that near misses become tangents.
Stay well below the promise's wider band: 1e-10 of the extent.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    scale = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    dx, dy = bx - ax, by - ay
    length = hypot(dx, dy)
    if not length:
        return [A] if abs(hypot(ax, ay) - r) <= 1e-10 * scale else []
    dx /= length
    dy /= length
    off = dx * ay - dy * ax
    mid = -(dx * ax + dy * ay)
    gap = r - abs(off)
    if gap < -1e-5 * scale:
        return []
    half = sqrt(gap * (r + abs(off))) if gap > 1e-5 * scale else 0
    stops = [mid - half, mid + half] if half else [mid]
    return [
        (cx + ax + s * dx, cy + ay + s * dy)
        for s in stops
        if -1e-10 * scale <= s <= length + 1e-10 * scale
    ]
