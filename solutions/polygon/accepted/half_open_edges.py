"""half-open edges

Each edge has its first corner and not its last one, which is the first one of the next edge: so a corner is met once.

An edge is a segment of length L. Its line passes C at the distance d; from the foot of the perpendicular the crossings
are half a chord back and forth, as lengths from the edge's first corner. Those from −near up to L − near count: what
is nearly at the last corner is left to the next edge, which finds it nearly at its first one.

Within an edge the nearer crossing comes first, and edges come in their order: nothing needs to be sorted. The last edge
goes back to V[0].
"""

from math import hypot, sqrt


def boundary_hits(cx, cy, r, V):
    corners = [(x - cx, y - cy) for x, y in V]
    near = 1e-10 * max(r, *(max(abs(x), abs(y)) for x, y in corners))
    found = []
    for i in range(len(V)):
        (fx, fy), (gx, gy) = corners[i], corners[(i + 1) % len(V)]
        dx, dy = gx - fx, gy - fy
        length = hypot(dx, dy)
        ux, uy = dx / length, dy / length
        d = abs(ux * fy - uy * fx)
        if d > r + near:
            continue
        foot = -(fx * ux + fy * uy)
        half = sqrt((r - d) * (r + d)) if d < r - near else 0
        for way in (foot - half, foot + half) if half else (foot,):
            if -near <= way < length - near:
                found.append((i, (V[i][0] + way * ux, V[i][1] + way * uy)))
    return found
