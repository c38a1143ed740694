"""the widest tolerance

Everything is compared with 1e-8 of the size: d with r, and the way along an edge with both of its ends.
"""

from math import hypot, sqrt


def boundary_hits(cx, cy, r, V):
    near = 1e-8 * max(r, *(max(abs(x - cx), abs(y - cy)) for x, y in V))
    found = []
    for i, (ax, ay) in enumerate(V):
        bx, by = V[(i + 1) % len(V)]
        length = hypot(bx - ax, by - ay)
        ux, uy = (bx - ax) / length, (by - ay) / length
        fx, fy = ax - cx, ay - cy
        d, foot = abs(ux * fy - uy * fx), -(fx * ux + fy * uy)
        if d > r + near:
            continue
        half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
        for way in sorted({foot - half, foot + half}):
            if -near <= way < length - near:
                found.append((i, (ax + way * ux, ay + way * uy)))
    return found
